/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A force term added from outside, a spring that holds every particle to the ground: it acts, and the stage
 * box says so. Then what all stages say, held against what particles and nodes exchange. */
#include "base/text.h"
#include "methods/bar_case.h"
#include "suite.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double pull_back(const Simulation *sim, size_t particle, int axis, const void *stiffness)
{
    (void)axis;
    const double u = simulation_value(sim, simulation_find_field(sim, 0, "u"), particle);
    return -*(const double *)stiffness * u *
           simulation_value(sim, simulation_find_field(sim, 0, "mass"), particle);
}

static const double stiffness = 0.25;

static const ForceTerm springs[] = {{.name = "spring to the ground",
                                     .equation = "Σ N_i (-k u_p m_p)",
                                     .load = "-k u m",
                                     .on = pull_back,
                                     .context = &stiffness},
                                    {0}};

static BarCase on_springs(int mode, double v0)
{
    BarCase bar = bar_case(mode, v0);
    bar.def.forces = springs;
    return bar;
}

static double drift(double x, const void *speed)
{
    (void)x;
    return *(const double *)speed;
}

static const Stage *stage_named(const Simulation *sim, const char *id)
{
    const int stage = simulation_find_stage(sim, id);
    ck_assert_int_ge(stage, 0);
    return &sim->stages[stage];
}

static void go_to_force(Simulation *sim)
{
    Status status;
    for (int i = 0; i <= simulation_find_stage(sim, "force"); i++)
        ck_assert(simulation_stage(sim, &status));
}

static const char *meaning_of_f_ext(const Simulation *sim)
{
    return sim->fields[simulation_find_field(sim, 1, "f_ext")].quantity.meaning;
}

/* A free bar that moves as a whole oscillates with omega^2 = k. */
START_TEST(it_acts)
{
    static const double v0 = 0.1;
    BarCase bar = on_springs(0, 0);
    bar.def.supports = BAR_FREE_FREE;
    bar.def.initial_velocity = drift;
    bar.def.initial_context = &v0;
    Status status;
    Simulation *sim = mpm_create(&bar.def, &status);
    ck_assert_msg(sim, "%s", status.text);
    /* v' = v - dt k x, x' = x + dt v', from x = 0 and v0: x(n) = dt v0 sin(n th)/sin(th) up to a shift of
     * half a step that the first force, 0 at x = 0, takes away */
    const double angle = 2 * asin(sqrt(stiffness) * sim->dt / 2);
    for (int i = 1; i <= 40; i++) {
        ck_assert(simulation_steps(sim, 50, NULL, NULL, &status));
        ck_assert_double_eq_tol(series_now(sim, "x_cm") - 12.5,
                                sim->dt * v0 * sin((double)sim->step * angle) / sin(angle), 1e-12);
        /* the work of a step is that of its force and its last velocity: more than it gives, by f^2 dt^2/(2
         * m) */
        const double start = 0.5 * 25 * v0 * v0;
        const double more = start - (series_now(sim, "kinetic") - series_now(sim, "work"));
        ck_assert_double_ge(more, 0);
        ck_assert_double_le(more, start * stiffness * sim->dt * simulation_time(sim));
    }
    simulation_destroy(sim);
}
END_TEST

/* Stage by stage and in slices, and from a snapshot, with each algorithm: the bits are the same. */
START_TEST(its_bits_do_not_depend_on_slices)
{
    BarCase bar = on_springs(5, 0.1);
    bar.def.algorithm = (MpmAlgorithm)_i;
    Simulation *whole = bar_case_create(&bar), *sliced = bar_case_create(&bar);
    Status status;
    ck_assert(simulation_steps(whole, 20, NULL, NULL, &status));
    while (sliced->step < 20) {
        bool done;
        ck_assert(simulation_slice(sliced, 7, &done, &status));
    }
    const size_t size = simulation_snapshot_size(whole);
    void *a = malloc(size), *b = malloc(size);
    ck_assert(a && b);
    simulation_snapshot(whole, a);
    simulation_snapshot(sliced, b);
    ck_assert_mem_eq(a, b, size);
    free(a), free(b);
    simulation_destroy(whole);
    simulation_destroy(sliced);
}
END_TEST

START_TEST(the_box_shows_it)
{
    BarCase bar = on_springs(5, 0.1);
    Simulation *sim = bar_case_create(&bar);
    Status status;
    ck_assert(simulation_steps(sim, 100, NULL, NULL, &status));
    const Stage *stage = stage_named(sim, "force");
    ck_assert_str_eq(stage->equation, "f_int = -Σ N_i′ σ_p m_p/ρ_p    f_ext = Σ N_i (-k u_p m_p)\n"
                                      "f_i = f_int + f_ext,   f_i = 0 at fixed nodes");
    ck_assert_str_eq(meaning_of_f_ext(sim), "force of spring to the ground");

    /* what the box works out is what acts */
    go_to_force(sim);
    char text[8192];
    sim->method->explain(sim, simulation_find_stage(sim, "force"), 0, 20, NULL, 0, text, sizeof text);
    const char *load = strstr(text, "load = -k u m = ");
    ck_assert_ptr_nonnull(load);
    ck_assert_double_eq_tol(strtod(load + strlen("load = -k u m = "), NULL),
                            pull_back(sim, 20, 0, &stiffness),
                            1e-4 * fabs(pull_back(sim, 20, 0, &stiffness)));
    double sum = 0, *force = field_now(sim, 1, "f_ext");
    for (size_t i = 0; i < sim->counts[1]; i++)
        sum += force[i];
    for (size_t p = 0; p < sim->counts[0]; p++)
        sum -= pull_back(sim, p, 0, &stiffness);
    ck_assert_double_eq_tol(sum, 0, 1e-17);
    free(force);
    simulation_destroy(sim);
}
END_TEST

/* Loads that are switched on in mid-run come into the equation, and go from it. */
START_TEST(the_box_follows_the_loads)
{
    BarCase bar = bar_case(5, 0.1);
    Simulation *sim = bar_case_create(&bar);
    Status status;
    ck_assert_str_eq(stage_named(sim, "force")->equation, "f_int = -Σ N_i′ σ_p m_p/ρ_p\n"
                                                          "f_i = f_int,   f_i = 0 at fixed nodes");
    ck_assert_str_eq(meaning_of_f_ext(sim), "force of the loads: none acts");
    ck_assert(sim->method->change(sim, "load.traction", 1e-2, &status));
    ck_assert_ptr_nonnull(strstr(stage_named(sim, "force")->equation, "f_ext = Σ N_i t m_p/(ρ_p h)\n"));
    ck_assert(sim->method->change(sim, "load.body_force", 1e-2, &status));
    ck_assert_ptr_nonnull(
        strstr(stage_named(sim, "force")->equation, "f_ext = Σ N_i m_p b + Σ N_i t m_p/(ρ_p h)\n"));
    ck_assert_str_eq(meaning_of_f_ext(sim), "force of body force and traction");
    void *loaded = malloc(simulation_snapshot_size(sim));
    ck_assert_ptr_nonnull(loaded);
    simulation_snapshot(sim, loaded);
    ck_assert(sim->method->change(sim, "load.traction", 0, &status));
    ck_assert(sim->method->change(sim, "load.body_force", 0, &status));
    ck_assert_ptr_null(strstr(stage_named(sim, "force")->equation, "f_ext"));
    simulation_restore(sim, loaded); /* and come back with their time */
    ck_assert_ptr_nonnull(strstr(stage_named(sim, "force")->equation, "f_ext"));
    free(loaded);
    simulation_destroy(sim);
}
END_TEST

/* All terms together need a line of their own: none is wider than the narrowest box. */
START_TEST(lines_stay_narrow)
{
    BarCase bar = on_springs(5, 0.1);
    bar.def.body_force = bar.def.traction = 1e-3;
    Simulation *sim = bar_case_create(&bar);
    for (const char *line = stage_named(sim, "force")->equation; *line; line += *line == '\n') {
        int columns = 0;
        for (; *line && *line != '\n'; line++)
            columns += ((unsigned char)*line & 0xc0) != 0x80;
        ck_assert_int_le(columns, 76);
    }
    ck_assert_ptr_nonnull(strstr(stage_named(sim, "force")->equation,
                                 "\nf_ext = Σ N_i m_p b + Σ N_i t m_p/(ρ_p h) + Σ N_i (-k u_p m_p)\n"));
    simulation_destroy(sim);
}
END_TEST

static bool has_word(const char *words, const char *word, size_t length)
{
    for (const char *at = words; (at = strstr(at, word)); at++) {
        const bool begins = at == words || !isalnum((unsigned char)at[-1]);
        if (begins && !isalnum((unsigned char)at[length]))
            return true;
    }
    return false;
}

/* A factor is in the stage's equation, or the note says what it is. */
static void expect_factor(const Exchange *exchange, const Stage *stage, const char *factor)
{
    char defined[32], slope[8] = "", equation[512];
    text_to_ascii(stage->equation, equation, sizeof equation);
    factor += *factor == '-';
    if (factor[strlen(factor) - 1] == '\'') /* "N'" is "N_i'" there */
        snprintf(slope, sizeof slope, "%c_i'", *factor);
    snprintf(defined, sizeof defined, "%s = ", factor);
    ck_assert_msg((*slope ? strstr(equation, slope) != NULL : has_word(equation, factor, strlen(factor))) ||
                      (exchange->note && strstr(exchange->note, defined)),
                  "%s of %s is not in: %s", factor, exchange->field, equation);
}

/* Every exchange is done by a stage that says so: what is received is written there, its factors stand in
 * the equation. */
START_TEST(stages_say_what_is_exchanged)
{
    static const struct {
        MpmTransfer transfer;
        double flip, blend;
    } ways[] = {{MPM_FLIP, 1, 1},     {MPM_FLIP, 0.5, 1}, {MPM_FLIP, 0, 1}, {MPM_FLIP, 1, 0.5},
                {MPM_FLIP, 0.5, 0.5}, {MPM_APIC, 1, 1},   {MPM_FMPM, 1, 1}};
    int told = 0;
    for (int algorithm = MPM_USF; algorithm <= MPM_MUSL; algorithm++)
        for (size_t way = 0; way < sizeof ways / sizeof *ways; way++) {
            BarCase bar = on_springs(5, 0.1);
            bar.def.algorithm = (MpmAlgorithm)algorithm;
            bar.def.transfer = ways[way].transfer;
            bar.def.flip_fraction = ways[way].flip;
            bar.def.mass_blend = ways[way].blend;
            bar.def.fmpm_order = 2;
            bar.def.body_force = 1e-3;
            Simulation *sim = bar_case_create(&bar);
            for (int e = 0; e < sim->n_exchanges; e++) {
                const Exchange *exchange = &sim->exchanges[e];
                const int index = simulation_find_stage(sim, exchange->stage);
                if (index < 0) { /* only MUSL maps again */
                    ck_assert_str_eq(exchange->stage, "map_again");
                    ck_assert_int_ne(algorithm, MPM_MUSL);
                    continue;
                }
                const Stage *stage = &sim->stages[index];
                ck_assert_msg(has_word(stage->writes, exchange->field, strlen(exchange->field)),
                              "%s writes %s, not %s", stage->id, stage->writes, exchange->field);
                char words[64], *rest;
                text_to_ascii(exchange->factors, words, sizeof words);
                for (char *word = strtok_r(words, " ", &rest); word; word = strtok_r(NULL, " ", &rest))
                    expect_factor(exchange, stage, word);
                told++;
            }
            simulation_destroy(sim);
        }
    ck_assert_int_eq(told, 7 * (7 + 7 + 8));
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *forces = tcase_create("forces");
    tcase_add_test(forces, it_acts);
    tcase_add_loop_test(forces, its_bits_do_not_depend_on_slices, 0, 3);
    tcase_add_test(forces, the_box_shows_it);
    tcase_add_test(forces, the_box_follows_the_loads);
    tcase_add_test(forces, lines_stay_narrow);
    tcase_add_test(forces, stages_say_what_is_exchanged);
    suite_add_tcase(suite, forces);
}
