/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Damping, weight and rest of beams: against runs of an independent program, the ledger, and the same beam at
 * rest by one solution. */
#include "methods/beam_case.h"
#include "methods/default_defs.h"
#include "methods/bonds/plane/bonds_plane.h"
#include "methods/bonds/plane/plate/patches.h"
#include "suite.h"
#include "theory/elastic_beam.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static FILE *golden(void)
{
    FILE *file = fopen(source_path("tests/golden/rest.txt"), "r");
    ck_assert_ptr_nonnull(file);
    return file;
}

static BeamDef half_millimetre(void)
{
    BeamDef def = beam_default(BEAM_SIMPLY_SUPPORTED);
    def.thickness = 1;
    def.spacing = 0.5e-3;
    def.horizon = 2e-3;
    return def;
}

static double of_series(Simulation *sim, const char *name)
{
    double row[SIMULATION_SERIES_MAX];
    const int k = simulation_find_series(sim, name);
    ck_assert_int_ge(k, 0);
    simulation_row(sim, row);
    return row[k];
}

static void go_to(Simulation *sim, long step)
{
    Status status = {0};
    ck_assert_msg(simulation_steps(sim, step - sim->step, NULL, NULL, &status), "%s", status.text);
}

/* --- digits --- */

static const char *const columns[] = {"u_probe", "v_probe", "kinetic", "strain", "work", "damped"};

static void expect_row(Simulation *sim, const double expected[6], const double scale[6])
{
    for (int k = 0; k < 6; k++) {
        const double value = of_series(sim, columns[k]);
        ck_assert_msg(fabs(value - expected[k]) <= 1e-9 * scale[k], "step %ld: %s is %.16g, not %.16g",
                      sim->step, columns[k], value, expected[k]);
    }
}

/* Each number to 1e-9 of the largest of its kind. */
static int run_case(const char *wanted)
{
    FILE *file = golden();
    char line[512], name[16] = "";
    Simulation *sim = NULL;
    const double scale_decay[6] = {3e-6, 0.02, 2e-4, 2e-4, 1, 2e-4},
                 scale_rest[6] = {2.4e-7, 3e-4, 3e-8, 1e-6, 2e-6, 1e-6};
    int rows = 0;
    while (fgets(line, sizeof line, file)) {
        BeamDef def = half_millimetre();
        double at[6];
        long step;
        if (sscanf(line, "case %15s %lf %lf %lf %lf", name, &def.damping, &def.dt, &def.amplitude,
                   &def.body_force) == 5 &&
            strcmp(name, wanted) == 0)
            sim = beam_case_create(&def, NULL);
        if (strcmp(name, wanted) != 0 || sscanf(line, "row %ld %lf %lf %lf %lf %lf %lf", &step, &at[0],
                                                &at[1], &at[2], &at[3], &at[4], &at[5]) != 7)
            continue;
        go_to(sim, step);
        expect_row(sim, at, strcmp(name, "rest") == 0 ? scale_rest : scale_decay);
        rows++;
    }
    fclose(file);
    simulation_destroy(sim);
    return rows;
}

START_TEST(golden_decay)
{
    ck_assert_int_eq(run_case("decay"), 11);
}
END_TEST

START_TEST(golden_rest)
{
    ck_assert_int_eq(run_case("rest"), 11);
}
END_TEST

/* --- one solution --- */

START_TEST(golden_sags)
{
    static const char *const surfaces[] = {"none", "energy", "volume"};
    FILE *file = golden();
    char line[256], surface[16];
    double spacing, horizon, sag, ratio;
    int held = 0;
    while (fgets(line, sizeof line, file)) {
        if (sscanf(line, "sag %lf %lf %15s %lf %lf", &spacing, &horizon, surface, &sag, &ratio) != 5 ||
            (!suite_wide() && spacing < 0.49))
            continue;
        BeamDef def = beam_default(BEAM_SIMPLY_SUPPORTED);
        def.spacing = spacing * 1e-3;
        def.horizon = horizon * 1e-3;
        for (int k = 0; k < 3; k++)
            if (strcmp(surface, surfaces[k]) == 0)
                def.surface_correction = (SurfaceCorrection)k;
        Simulation *sim = beam_case_create(&def, NULL);
        Status status = {0};
        BeamLinear linear;
        BeamFacts facts;
        ck_assert_msg(beam_linear(sim, &linear, &status), "%s", status.text);
        beam_facts(sim, &facts);
        const BeamTheory theory = {facts.real_span, facts.real_height, 71e9, 2700, 1.0 / 3, 0, 0, 0, {0}};
        ck_assert_msg(fabs(-9.81 * linear.sag / sag - 1) < 1e-8, "%s: %.12g", line, -9.81 * linear.sag);
        ck_assert_msg(fabs(linear.sag / beam_sag(&theory, 1) - ratio) < 1e-6, "%s: %.9g", line,
                      linear.sag / beam_sag(&theory, 1));
        simulation_destroy(sim);
        held++;
    }
    fclose(file);
    ck_assert_int_eq(held, suite_wide() ? 18 : 9);
}
END_TEST

START_TEST(nothing_holds_a_free_body)
{
    BeamDef def = small_beam(BEAM_SIMPLY_SUPPORTED);
    Simulation *sim = beam_case_create(&def, &(BeamOptions){.free_body = true});
    BeamLinear linear;
    ck_assert(beam_linear(sim, &linear, NULL));
    ck_assert(isnan(linear.period) && isnan(linear.sag));
    ck_assert_int_eq(simulation_find_series(sim, "reaction_y"), -1);
    simulation_destroy(sim);
    def.critically_damped = true;
    Status status = {0};
    ck_assert_ptr_null(beam_create_with(&def, &(BeamOptions){.free_body = true}, &status));
    ck_assert_ptr_nonnull(strstr(status.text, "damping.rate: critical"));
    ck_assert_ptr_nonnull(strstr(status.text, "nothing holds the beam,"));
    def.to_rest = true;
    ck_assert_ptr_null(beam_create_with(&def, &(BeamOptions){.free_body = true}, &status));
}
END_TEST

/* Bent and let go, it comes to rest all the same, straight. */
START_TEST(a_free_body_comes_to_rest)
{
    BeamDef def = small_beam(BEAM_SIMPLY_SUPPORTED);
    def.to_rest = true;
    def.damping = 1e5;
    Simulation *sim = beam_case_create(&def, &(BeamOptions){.free_body = true});
    Status status = {0};
    long done;
    ck_assert(simulation_steps(sim, 40000, NULL, &done, &status));
    ck_assert(sim->at_rest && done < 40000);
    ck_assert_double_lt(series_now(sim, "strain"), 1e-6 * series_now(sim, "damped"));
    simulation_destroy(sim);
}
END_TEST

/* --- rest --- */

static BeamDef hanging(void)
{
    BeamDef def = small_beam(BEAM_SIMPLY_SUPPORTED);
    def.amplitude = 0;
    def.body_force = -9.81;
    def.critically_damped = true;
    def.to_rest = true;
    def.dt = 1e-7;
    return def;
}

/* 20 x 30 nodes that stand on their foot. */
static BeamDef post(void)
{
    BeamDef def = beam_default(BEAM_PLATE);
    def.length = 0.04;
    def.height = 0.06;
    def.spacing = 2e-3;
    def.horizon = 6e-3;
    def.dt = 2e-7;
    def.plate.n_supports = 1;
    def.plate.supports[0] =
        (PlateRegion){.x1 = 0.04, .y1 = 0.004, .gives_x = true, .gives_y = true, .name = "foot"};
    def.plate.probe_x = 0.02;
    def.plate.probe_y = 0.06;
    return def;
}

/* P' = R - m g - alpha P as velocity Verlet has it, from step to step; at rest supports bear the weight. */
static void weigh(const BeamDef *def)
{
    Simulation *sim = beam_case_create(def, NULL);
    BeamFacts facts;
    beam_facts(sim, &facts);
    const double weight =
        9.81 * def->density * def->thickness * sim->spacing * sim->spacing * (double)sim->counts[0];
    const double half = facts.damping * sim->dt / 2;
    for (int step = 0; step < 200; step++) {
        const double momentum = series_now(sim, "momentum_y"), reaction = series_now(sim, "reaction_y");
        advance(sim, 1);
        const double gain = series_now(sim, "momentum_y") * (1 + half) - momentum * (1 - half);
        const double force = (reaction + series_now(sim, "reaction_y")) / 2 - weight;
        ck_assert_double_eq_tol(gain / sim->dt, force, 1e-9 * weight);
    }
    ck_assert(simulation_steps(sim, 200000, NULL, NULL, NULL));
    ck_assert(sim->at_rest);
    ck_assert_double_eq_tol(series_now(sim, "reaction_y"), weight, 1e-4 * weight);
    ck_assert_double_eq_tol(series_now(sim, "reaction_x"), 0, 1e-4 * weight);
    simulation_destroy(sim);
}

START_TEST(supports_bear_the_weight)
{
    BeamDef def = hanging();
    weigh(&def);
    /* nodes that two supports hold, each in its own directions */
    def = post();
    def.body_force = -9.81;
    def.critically_damped = def.to_rest = true;
    def.plate.n_supports = 2;
    def.plate.supports[0].x1 = 0.024;
    def.plate.supports[0].gives_x = false;
    def.plate.supports[1] = post().plate.supports[0];
    def.plate.supports[1].x0 = 0.016;
    weigh(&def);
}
END_TEST

START_TEST(comes_to_rest_by_itself)
{
    const BeamDef def = hanging();
    Simulation *sim = beam_case_create(&def, NULL);
    BeamLinear linear;
    BeamFacts facts;
    long done;
    beam_facts(sim, &facts);
    ck_assert(beam_linear(sim, &linear, NULL));
    ck_assert_double_eq_tol(facts.damping * linear.period, 4 * M_PI, 1e-9);
    ck_assert(simulation_steps(sim, 100000, NULL, &done, NULL));
    ck_assert(sim->at_rest);
    ck_assert_int_eq(done, sim->step);
    ck_assert_int_lt(done, 20000);
    ck_assert_int_eq(sim->events[sim->n_events - 1].kind, EVENT_REST);
    ck_assert_int_eq(sim->events[sim->n_events - 1].step, sim->step);
    const double sag = of_series(sim, "u_probe"), work = of_series(sim, "work");
    ck_assert_double_eq_tol(sag / (-9.81 * linear.sag), 1, 6e-6);
    ck_assert_double_eq_tol(of_series(sim, "strain") / work, 0.5, 1e-4);
    ck_assert_double_eq_tol(of_series(sim, "total") / work, 1, 1e-9);
    ck_assert(simulation_steps(sim, 10, NULL, &done, NULL));
    ck_assert_int_eq(done, 0); /* it stays */
    simulation_destroy(sim);
}
END_TEST

/* Rest has to last half a period where the beam still oscillates: kinetic energy vanishes at each turning. */
START_TEST(a_turning_point_is_no_rest)
{
    BeamDef def = hanging();
    def.critically_damped = false;
    def.damping = 20000; /* of some 90000 */
    Simulation *sim = beam_case_create(&def, NULL);
    BeamLinear linear;
    ck_assert(beam_linear(sim, &linear, NULL));
    go_to(sim, 1000000);
    ck_assert(sim->at_rest);
    ck_assert_double_eq_tol(of_series(sim, "u_probe") / (-9.81 * linear.sag), 1, 6e-6);
    simulation_destroy(sim);
    def.damping = 0;
    Status status = {0};
    ck_assert_ptr_null(beam_create(&def, &status));
    ck_assert_ptr_nonnull(strstr(status.text, "time.rest: without damping"));
}
END_TEST

/* The way a post sways is not the way a supported beam bends: what it is left to do after a push sideways has
 * the lowest frequency of all. */
START_TEST(critical_is_twice_the_lowest_of_a_post)
{
    BeamDef def = post();
    def.plate.n_impulses = 1;
    def.plate.impulses[0] = (PlateRegion){.x1 = 0.04, .y0 = 0.04, .y1 = 0.06, .vx = 1, .name = "push"};
    Simulation *sim = beam_case_create(&def, NULL);
    const int ux = simulation_find_field(sim, SET_PARTICLE, "ux");
    const size_t top = sim->counts[SET_PARTICLE] - sim->columns / 2;
    double before = 1, first = 0, last = 0;
    int turns = 0;
    while (turns < 7) {
        go_to(sim, sim->step + 1);
        const double now = simulation_value(sim, ux, top);
        if ((now < 0) != (before < 0)) {
            last = simulation_time(sim);
            first = turns++ == 0 ? last : first;
        }
        before = now;
    }
    BeamLinear linear;
    ck_assert(beam_linear(sim, &linear, NULL));
    ck_assert_double_eq_tol(linear.period * 3 / (last - first), 1, 0.03);
    simulation_destroy(sim);
}
END_TEST

/* A cut makes two tongues that sway alike, together or against each other, with nearly one frequency: an
 * iteration that has not told them apart has no period. */
START_TEST(two_alike_have_no_period)
{
    BeamDef def = post();
    def.height = 0.1;
    def.plate.probe_y = 0.1;
    def.plate.n_cuts = 2;
    def.plate.cuts[0] = (PlateCut){.x0 = 0.020, .y0 = 0.1, .x1 = 0.020, .y1 = 0, .name = "a"};
    def.plate.cuts[1] = (PlateCut){.x0 = 0, .y0 = 0.0611, .x1 = 0.0035, .y1 = 0.0611, .name = "b"};
    Simulation *sim = beam_case_create(&def, NULL);
    BeamLinear linear;
    ck_assert(beam_linear(sim, &linear, NULL));
    ck_assert_msg(isnan(linear.period), "%.17g", linear.period);
    ck_assert(linear.sag > 0);
    simulation_destroy(sim);
}
END_TEST

static long step_of_rest(const BeamDef *def)
{
    Simulation *sim = beam_case_create(def, NULL);
    go_to(sim, 60000);
    ck_assert(sim->at_rest);
    const long step = sim->step;
    simulation_destroy(sim);
    return step;
}

/* A load that will be let go, one that still grows and a change that is to come: it waits for them, and is at
 * rest only then. */
START_TEST(rest_waits_for_what_was_ordered)
{
    BeamDef def = post();
    def.critically_damped = def.to_rest = true;
    def.plate.n_loads = 1;
    def.plate.loads[0] = (PlateLoad){"side", PLATE_RIGHT, 0.04, 0.06, 1e5, 0, 0, INFINITY};
    const long by_itself = step_of_rest(&def), later = 2 * by_itself;
    ck_assert_int_gt(by_itself, 500);
    def.plate.loads[0].until = (double)later * def.dt;
    ck_assert_int_gt(step_of_rest(&def), later + by_itself / 2);
    def.plate.loads[0].until = INFINITY;
    BeamDef slow = def; /* so slowly that beside the push it would pass for rest */
    slow.plate.n_impulses = 1;
    slow.plate.impulses[0] = (PlateRegion){.x1 = 0.04, .y0 = 0.04, .y1 = 0.06, .vx = 1, .name = "push"};
    slow.plate.loads[0].sx = 100;
    slow.plate.loads[0].ramp = (double)later * def.dt;
    ck_assert_int_gt(step_of_rest(&slow), later);
    def.changes_until = later;
    Simulation *sim = beam_case_create(&def, NULL);
    go_to(sim, later);
    ck_assert(!sim->at_rest);
    ck_assert_double_lt(sim->kinetic_left, 1e-10);
    ck_assert(sim->method->change(sim, "load.body_force", -9.81, NULL));
    ck_assert(sim->kinetic_left == 1);
    go_to(sim, 60000);
    ck_assert(sim->at_rest);
    ck_assert_int_gt(sim->step, later + by_itself / 2);
    simulation_destroy(sim);
}
END_TEST

/* At 2/dt the first half kick takes all of the velocity; beyond it what is left turns around. */
START_TEST(damping_beyond_the_step_is_refused)
{
    BeamDef def = post();
    def.damping = 1.0001e7;
    Status status = {0};
    ck_assert(!beam_check(&def, &status));
    ck_assert_str_eq(status.text, "damping.rate: 1.0001e+07 is too much for the time step 2e-07 (at most "
                                  "2/time.step = 1e+07)");
    def.damping = 0.9999e7;
    ck_assert(beam_check(&def, NULL));
    def.dt = 0; /* known when the plate is made */
    def.damping = 1e9;
    ck_assert(beam_check(&def, NULL));
    ck_assert_ptr_null(beam_create(&def, &status));
    ck_assert_ptr_nonnull(strstr(status.text, "damping.rate: 1e+09 is too much for the time step"));
}
END_TEST

/* With rows, stage by stage, on two threads and from a snapshot: the same bits, the same end. */
START_TEST(rest_is_the_same_by_every_way)
{
    BeamDef def = hanging();
    Simulation *plain = beam_case_create(&def, NULL), *staged = beam_case_create(&def, NULL);
    def.threads = 2;
    Simulation *threads = beam_case_create(&def, NULL);
    go_to(plain, 40);
    for (long k = 0; k < 40 * plain->n_stages; k++)
        ck_assert(simulation_stage(staged, NULL));
    go_to(threads, 40);
    expect_same_state(plain, staged, "stages");
    expect_same_state(plain, threads, "threads");
    unsigned char *snapshot = snapshot_now(plain);
    double *rows = malloc(20000 * (size_t)plain->n_series * sizeof *rows);
    long done;
    ck_assert(simulation_steps(plain, 20000, rows, &done, NULL));
    go_to(threads, 20040);
    expect_same_state(plain, threads, "to rest");
    ck_assert(plain->at_rest && threads->at_rest);
    simulation_restore(threads, snapshot);
    ck_assert(!threads->at_rest);
    go_to(threads, 20040);
    expect_same_state(plain, threads, "again");
    /* a change sets it going anew */
    ck_assert(plain->method->change(plain, "load.body_force", -5, NULL));
    ck_assert(!plain->at_rest);
    const long before = plain->step;
    go_to(plain, before + 20000);
    ck_assert_int_gt(plain->step, before + 1000);
    free(rows);
    free(snapshot);
    simulation_destroy(plain);
    simulation_destroy(staged);
    simulation_destroy(threads);
}
END_TEST

/* A beam that leaves its channel is braked in its own frame: an undeflected one goes on as it does. */
START_TEST(travel_is_not_braked)
{
    BeamDef def = small_beam(BEAM_MOVING_CANTILEVER);
    def.amplitude = 0;
    def.damping = 1e5;
    Simulation *sim = beam_case_create(&def, NULL);
    go_to(sim, 500);
    double *vx = field_now(sim, SET_PARTICLE, "vx");
    for (size_t k = 0; k < sim->counts[SET_PARTICLE]; k++)
        ck_assert_double_eq_tol(vx[k], def.speed, 1e-9);
    ck_assert_double_eq_tol(of_series(sim, "damped"), 0, 1e-15);
    free(vx);
    unsigned char *before = malloc(sim->method->state_size(sim));
    char text[512];
    simulation_save(sim, before);
    ck_assert(simulation_stage(sim, NULL));
    sim->method->explain(sim, 0, SET_PARTICLE, sim->counts[SET_PARTICLE] - 1, before, 4, text, sizeof text);
    ck_assert_msg(strstr(text, "α (vx − v0)") != NULL, "%s", text);
    free(before);
    simulation_destroy(sim);
}
END_TEST

/* It counts half in the step nearest to its end, and whole in the one before. */
START_TEST(a_load_ends_in_the_nearest_step)
{
    const double dt = 0.01;
    const Load load = {.until = 2.6 * dt};
    ck_assert_double_eq(load_share(&load, 2 * dt, dt), 1);
    ck_assert_double_eq(load_share(&load, 3 * dt, dt), 0.5);
    ck_assert_double_eq(load_share(&load, 4 * dt, dt), 0);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *digits = tcase_create("digits");
    if (suite_wide())
        tcase_add_test(digits, golden_decay);
    tcase_add_test(digits, a_load_ends_in_the_nearest_step);
    tcase_add_test(digits, golden_rest);
    tcase_add_test(digits, golden_sags);
    tcase_add_test(digits, nothing_holds_a_free_body);
    tcase_add_test(digits, a_free_body_comes_to_rest);
    suite_add_tcase(suite, digits);
    TCase *rest = tcase_create("rest");
    tcase_add_test(rest, supports_bear_the_weight);
    tcase_add_test(rest, comes_to_rest_by_itself);
    tcase_add_test(rest, a_turning_point_is_no_rest);
    tcase_add_test(rest, critical_is_twice_the_lowest_of_a_post);
    tcase_add_test(rest, two_alike_have_no_period);
    tcase_add_test(rest, rest_waits_for_what_was_ordered);
    tcase_add_test(rest, damping_beyond_the_step_is_refused);
    tcase_add_test(rest, rest_is_the_same_by_every_way);
    tcase_add_test(rest, travel_is_not_braked);
    suite_add_tcase(suite, rest);
}
