/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bar by peridynamics against plain double loops over all pairs of points, and what must hold of it. */
#include "methods/bonds/plane/bonds_plane.h"
#include "methods/run_case.h"
#include "suite.h"
#include "sums.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { POINTS_MAX = 400 };

static double wave(double x, const void *context)
{
    const double *length = context;
    return 0.1 * sin(4.5 * M_PI * x / *length) + 0.03 * cos(2 * M_PI * x / *length) + 0.01 * x / *length;
}

static BeamDef standard(bool left, bool right)
{
    static const double length = 25;
    return (BeamDef){.problem = BEAM_BAR,
                     .length = length,
                     .youngs_modulus = 100,
                     .density = 1,
                     .left_fixed = left,
                     .right_fixed = right,
                     .spacing = 0.5,
                     .horizon = 1.5,
                     .surface_correction = SURFACE_ENERGY,
                     .volume_correction = VOLUME_PARTIAL,
                     .dt = 0.01,
                     .initial_velocity = wave,
                     .initial_context = &length};
}

static Simulation *create(const BeamDef *def)
{
    Status status = {0};
    Simulation *sim = beam_create(def, &status);
    ck_assert_msg(sim != NULL, "%s", status.text);
    return sim;
}

static double of_particle(const Simulation *sim, const char *name, size_t index)
{
    double value;
    int field = simulation_find_field(sim, 0, name);
    ck_assert_msg(field >= 0, "no field %s", name);
    sim->method->field(sim, field, index, 1, &value);
    return value;
}

/* --- the other way to compute it: a cloud of points, every pair looked at ------------------------- */

/* Points of the bar and, beyond a fixed end, a point for each mirror image within the horizon. */
typedef struct Cloud {
    int count, real;
    double place[POINTS_MAX], moved[POINTS_MAX], factor[POINTS_MAX];
    int image_of[POINTS_MAX]; /* -1: a point of the bar */
} Cloud;

static double share(const BeamDef *def, double distance)
{
    if (distance > def->horizon * (1 + 1e-9) &&
        !(def->volume_correction == VOLUME_HHB && distance < def->horizon + def->spacing / 2))
        return 0;
    if (def->volume_correction == VOLUME_NONE)
        return 1;
    double within = def->horizon - (distance - def->spacing / 2);
    return within > def->spacing ? 1 : within / def->spacing;
}

static void add_point(Cloud *cloud, double place, int image_of)
{
    ck_assert_int_lt(cloud->count, POINTS_MAX);
    cloud->image_of[cloud->count] = image_of;
    cloud->place[cloud->count++] = place;
}

static void make_cloud(const BeamDef *def, Cloud *cloud)
{
    memset(cloud, 0, sizeof *cloud);
    int n = (int)round(def->length / def->spacing);
    for (int i = 0; i < n; i++)
        add_point(cloud, (i + 0.5) * def->spacing, -1);
    cloud->real = n;
    for (int i = 0; i < n; i++) {
        double x = cloud->place[i];
        if (def->left_fixed && x < def->horizon + def->spacing)
            add_point(cloud, -x, i);
        if (def->right_fixed && def->length - x < def->horizon + def->spacing)
            add_point(cloud, 2 * def->length - x, i);
    }
    for (int i = 0; i < n; i++) {
        double density = 0; /* of energy, at a strain of one */
        for (int j = 0; j < cloud->count; j++) {
            double distance = fabs(cloud->place[j] - cloud->place[i]);
            if (j != i)
                density += 0.5 * (2 * def->youngs_modulus / (def->horizon * def->horizon)) * distance / 2 *
                           share(def, distance) * def->spacing;
        }
        cloud->factor[i] = def->surface_correction == SURFACE_ENERGY ? def->youngs_modulus / 2 / density : 1;
    }
    for (int j = n; j < cloud->count; j++)
        cloud->factor[j] = cloud->factor[cloud->image_of[j]];
}

/* The force density on point i and the energy density of its bonds, half of each bond's. */
static double pair_forces(const BeamDef *def, Cloud *cloud, int i, double *energy)
{
    double sum = 0, c = 2 * def->youngs_modulus / (def->horizon * def->horizon);
    *energy = 0;
    for (int j = cloud->real; j < cloud->count; j++)
        cloud->moved[j] = -cloud->moved[cloud->image_of[j]];
    for (int j = 0; j < cloud->count; j++) {
        double xi = cloud->place[j] - cloud->place[i], w = share(def, fabs(xi));
        if (j == i || w == 0)
            continue;
        double now = xi + cloud->moved[j] - cloud->moved[i], s = (fabs(now) - fabs(xi)) / fabs(xi);
        double g = (cloud->factor[i] + cloud->factor[j]) / 2;
        sum += c * g * w * s * def->spacing * (now > 0 ? 1 : -1);
        *energy += 0.5 * (c * g * w * s * s * fabs(xi) / 2) * def->spacing;
    }
    return sum;
}

static void compare_with_cloud(const BeamDef *def)
{
    enum { STEPS = 400 };
    static Cloud cloud;
    make_cloud(def, &cloud);
    Simulation *sim = create(def);
    const int n = cloud.real;
    ck_assert_int_eq((int)sim->counts[0], n);
    static double v[POINTS_MAX], a[POINTS_MAX];
    double stored = 0, kinetic = 0, energy;
    for (int i = 0; i < n; i++)
        v[i] = wave(cloud.place[i], def->initial_context), a[i] = 0;
    for (int step = 0; step < STEPS; step++) {
        for (int i = 0; i < n; i++) {
            v[i] += def->dt / 2 * a[i];
            cloud.moved[i] += def->dt * v[i];
        }
        stored = kinetic = 0;
        for (int i = 0; i < n; i++) {
            a[i] = pair_forces(def, &cloud, i, &energy) / def->density;
            stored += energy * def->spacing;
        }
        for (int i = 0; i < n; i++) {
            v[i] += def->dt / 2 * a[i];
            kinetic += def->density * def->spacing * v[i] * v[i] / 2;
        }
    }
    advance(sim, STEPS);
    for (int i = 0; i < n; i++) {
        ck_assert_double_eq_tol(of_particle(sim, "u", (size_t)i), cloud.moved[i], 1e-12);
        ck_assert_double_eq_tol(of_particle(sim, "v", (size_t)i), v[i], 1e-11);
    }
    ck_assert_double_eq_tol(series_now(sim, "strain"), stored, 1e-11 * (stored + kinetic));
    ck_assert_double_eq_tol(series_now(sim, "kinetic"), kinetic, 1e-11 * (stored + kinetic));
    simulation_destroy(sim);
}

START_TEST(every_pair)
{
    for (int ends = 0; ends < 4; ends++)
        for (int correction = SURFACE_NONE; correction <= SURFACE_ENERGY; correction++)
            for (int volume = VOLUME_NONE; volume <= VOLUME_HHB; volume++) {
                BeamDef def = standard(ends & 1, ends & 2);
                def.surface_correction = (SurfaceCorrection)correction;
                def.volume_correction = (VolumeCorrection)volume;
                def.horizon = correction ? 1.5 : 1.4; /* whole spacings, and not */
                def.density = 2;
                compare_with_cloud(&def);
            }
}
END_TEST

/* --- statics -------------------------------------------------------------------------------------- */

static double stretch_of(double x, const void *context)
{
    (void)context;
    return 1e-3 * x;
}

/* A first step from rest with v = 0.001 x moves the bar into a uniform strain. */
START_TEST(uniform_strain)
{
    for (int volume = VOLUME_NONE; volume <= VOLUME_PARTIAL; volume++)
        for (int correction = SURFACE_NONE; correction <= SURFACE_ENERGY; correction++) {
            BeamDef def = standard(true, false);
            def.initial_velocity = stretch_of;
            def.surface_correction = (SurfaceCorrection)correction;
            def.volume_correction = (VolumeCorrection)volume;
            Simulation *sim = create(&def);
            advance(sim, 1);
            BeamFacts facts;
            beam_facts(sim, &facts);
            double e = 1e-3 * def.dt, modulus = volume ? 100 : 100 * (1 + 1.0 / 3);
            ck_assert_double_eq_tol(facts.modulus, modulus, 1e-10);
            /* the energy correction also repairs the sum over the family */
            double pulls = correction ? 100 : modulus;
            ck_assert_double_eq_tol(of_particle(sim, "strain", 20), e, 1e-15);
            ck_assert_double_eq_tol(of_particle(sim, "stress", 20), pulls * e, 1e-12 * pulls);
            ck_assert_double_eq_tol(of_particle(sim, "stress", 0), pulls * e, 1e-12 * pulls);
            ck_assert_double_eq_tol(of_particle(sim, "density", 20), 1 / (1 + e), 1e-14);
            ck_assert_double_eq_tol(of_particle(sim, "strain_energy", 20), pulls * e * e / 2 * 0.5,
                                    1e-12 * pulls * e * e);
            ck_assert_double_eq(of_particle(sim, "mass", 7), 0.5);
            ck_assert_double_eq(of_particle(sim, "family", 0), 6);
            ck_assert_double_eq(of_particle(sim, "family", 49), 3);
            ck_assert_double_eq_tol(of_particle(sim, "surface_factor", 20), correction ? 100 / modulus : 1,
                                    1e-14);
            /* half a family is gone: the last node has twice the factor */
            ck_assert_double_eq_tol(of_particle(sim, "surface_factor", 49),
                                    correction ? 2 * 100 / modulus : 1, 1e-12);
            ck_assert_double_eq_tol(facts.end_factor, of_particle(sim, "surface_factor", 49), 1e-15);
            simulation_destroy(sim);
        }
}
END_TEST

/* --- conservation --------------------------------------------------------------------------------- */

START_TEST(free_bar_keeps_momentum)
{
    BeamDef def = standard(false, false);
    Simulation *sim = create(&def);
    double before = series_now(sim, "v_cm");
    advance(sim, 3000);
    ck_assert_double_eq_tol(series_now(sim, "v_cm"), before, 1e-15);
    ck_assert_double_eq_tol(series_now(sim, "x_cm"), 12.5 + before * 30, 1e-12);
    ck_assert_double_eq_tol(series_now(sim, "momentum"), 25 * before, 1e-13);
    ck_assert_int_eq(simulation_find_series(sim, "reaction"), -1);
    simulation_destroy(sim);
}
END_TEST

static double largest_error_of_energy(double dt)
{
    BeamDef def = standard(true, false);
    def.dt = dt;
    Simulation *sim = create(&def);
    double start = series_now(sim, "total"), most = 0;
    for (long k = 0; k < lround(10 / dt); k++) {
        advance(sim, 1);
        most = fmax(most, fabs(series_now(sim, "total") / start - 1));
    }
    simulation_destroy(sim);
    return most;
}

START_TEST(energy_to_second_order)
{
    double coarse = largest_error_of_energy(0.01), fine = largest_error_of_energy(0.005);
    ck_assert_double_lt(coarse, 2e-3);
    ck_assert_double_eq_tol(coarse / fine, 4, 0.1);
}
END_TEST

START_TEST(work_of_loads)
{
    BeamDef def = standard(true, false);
    def.initial_velocity = NULL;
    def.body_force = 1e-3;
    def.traction = 2e-2;
    def.traction_layer = 2;
    Simulation *sim = create(&def);
    double most = 0, largest = 0;
    for (int k = 0; k < 2000; k++) {
        advance(sim, 1);
        most = fmax(most, fabs(series_now(sim, "total") - series_now(sim, "work")));
        largest = fmax(largest, series_now(sim, "work"));
    }
    ck_assert_double_lt(most, 2e-3 * largest);
    /* the load of the last nodes: 2 deep, 4 of them, together the traction */
    double sum = 0;
    for (size_t i = 0; i < 50; i++)
        sum += 0.5 * of_particle(sim, "load", i);
    ck_assert_double_eq_tol(sum, 2e-2 + 25e-3, 1e-15);
    /* what loads and support give to the momentum in a step, by the mean of its ends */
    for (int k = 0; k < 100; k++) {
        const double momentum = series_now(sim, "momentum"), reaction = series_now(sim, "reaction");
        advance(sim, 1);
        ck_assert_double_eq_tol((series_now(sim, "momentum") - momentum) / sim->dt,
                                sum + (reaction + series_now(sim, "reaction")) / 2, 1e-12);
    }
    simulation_destroy(sim);
}
END_TEST

static double constant(double x, const void *speed)
{
    (void)x;
    return *(const double *)speed;
}

static double pull_back(const Simulation *sim, size_t node, int axis, const void *stiffness)
{
    ck_assert_int_eq(axis, 0);
    return -*(const double *)stiffness * of_particle(sim, "u", node);
}

/* A spring to the ground that is added from outside acts, keeps the energy, and stands in the stage and in
 * its sum beside the loads, which come and go with their values. */
START_TEST(stages_say_what_acts)
{
    static const double stiffness = 0.25, speed = 0.1;
    static const ForceTerm springs[] = {
        {.name = "spring", .equation = "-k u(i)", .load = "-k u", .on = pull_back, .context = &stiffness},
        {0}};
    BeamDef def = standard(false, false);
    def.forces = springs;
    def.initial_velocity = constant;
    def.initial_context = &speed;
    Simulation *sim = create(&def);
    const int load = simulation_find_stage(sim, "load");
    const Stage *stage = &sim->stages[load];
    ck_assert_str_eq(stage->equation, "f(i) += -k u(i)");
    /* as a whole it oscillates with omega^2 = k/rho: u(n) of velocity Verlet from rest at 0 */
    const double angle = 2 * asin(sqrt(stiffness) * sim->dt / 2), start = 0.5 * 25 * speed * speed;
    for (int i = 1; i <= 40; i++) {
        advance(sim, 50);
        ck_assert_double_eq_tol(of_particle(sim, "u", 7),
                                speed * sim->dt * sin((double)sim->step * angle) / sin(angle), 1e-12);
        ck_assert_double_eq_tol(series_now(sim, "total") - series_now(sim, "work"), start, 1e-4 * start);
    }
    Status status;
    ck_assert(sim->method->change(sim, "load.traction", 0.01, &status));
    ck_assert(sim->method->change(sim, "load.body_force", 0.02, &status));
    ck_assert_str_eq(stage->equation, "f(i) += ρ b + (±t/h in the layer at a free end) + -k u(i)");
    for (int i = 0; i <= load; i++)
        ck_assert(simulation_stage(sim, &status));
    char text[8192];
    sim->method->explain(sim, load, 0, 0, NULL, 0, text, sizeof text);
    ck_assert_msg(strstr(text, "+\u00a00.02 ") || strstr(text, "+ 0.02 "), "%s", text);
    const double all = 0.02 - 0.01 / 0.5 + pull_back(sim, 0, 0, &stiffness);
    ck_assert_double_eq_tol(of_particle(sim, "load", 0), all, 1e-15);
    simulation_destroy(sim);
}
END_TEST

/* --- the time step -------------------------------------------------------------------------------- */

static bool survives(double dt, char *why)
{
    BeamDef def = standard(true, false);
    def.dt = dt;
    Simulation *sim = create(&def);
    Status status = {0};
    long done;
    bool sound = simulation_steps(sim, 20000, NULL, &done, &status);
    if (!sound) {
        /* it stands at the last sound step, and stays there */
        ck_assert_int_eq(sim->step, done);
        ck_assert_int_eq(sim->stage, 0);
        for (size_t i = 0; i < 50; i++)
            ck_assert(isfinite(of_particle(sim, "u", i)));
        ck_assert(!simulation_steps(sim, 1, NULL, NULL, NULL));
        strcpy(why, status.text);
    }
    simulation_destroy(sim);
    return sound;
}

START_TEST(critical_step)
{
    BeamDef def = standard(true, false);
    double critical;
    char why[sizeof((Status *)NULL)->text] = "";
    ck_assert(bonds_line_critical_step(&def, &critical, NULL));
    ck_assert_double_eq_tol(critical, 0.08802, 1e-5); /* by a dense eigenvalue solver */
    ck_assert(survives(0.999 * critical, why));
    ck_assert(!survives(1.01 * critical, why));
    ck_assert_msg(strstr(why, "particle ") && strstr(why, "step ") && strstr(why, "t = "), "%s", why);
    /* without free ends: the largest frequency of the endless lattice, here at theta = pi */
    def = standard(true, true);
    const double largest = sqrt(8 * 100 / (1.5 * 1.5) * (1 + 0.5 / 3));
    ck_assert(bonds_line_critical_step(&def, &critical, NULL));
    ck_assert_double_eq_tol(critical, 2 / largest, 1e-9);
    /* a long bar is judged by a part of it */
    Simulation *sim = create(&def);
    BeamFacts facts;
    beam_facts(sim, &facts);
    ck_assert_double_eq(facts.critical_step, critical);
    ck_assert_int_eq(facts.nx, 50);
    ck_assert_uint_eq(facts.family, 6);
    simulation_destroy(sim);
    def.spacing = 0.005, def.horizon = 0.015;
    ck_assert(bonds_line_critical_step(&def, &critical, NULL));
    ck_assert_double_eq_tol(critical * 100, 2 / largest, 1e-6);
}
END_TEST

/* --- the state ------------------------------------------------------------------------------------ */

static bool same_bits(const Simulation *a, const Simulation *b)
{
    size_t size = simulation_snapshot_size(a);
    char *one = malloc(size), *other = malloc(size);
    ck_assert(one && other && simulation_snapshot_size(b) == size);
    simulation_snapshot(a, one);
    simulation_snapshot(b, other);
    bool same = memcmp(one, other, size) == 0;
    free(one), free(other);
    return same;
}

START_TEST(rewound_sliced_or_whole)
{
    Status status = {0};
    BeamDef def = standard(true, false);
    def.body_force = 1e-3;
    def.traction = 0.01;
    Simulation *whole = create(&def), *sliced = create(&def);
    for (int stage = 0; stage < whole->n_stages; stage++) {
        Simulation *sim = create(&def);
        advance(sim, 17);
        for (int k = 0; k < stage; k++)
            ck_assert(simulation_stage(sim, &status));
        void *bytes = malloc(simulation_snapshot_size(sim));
        ck_assert(bytes != NULL);
        simulation_snapshot(sim, bytes);
        advance(sim, 30);
        simulation_restore(sim, bytes);
        ck_assert_int_eq(sim->stage, stage);
        advance(sim, 100 - 17 - (stage > 0));
        Simulation *straight = create(&def);
        advance(straight, 100);
        ck_assert(same_bits(sim, straight));
        free(bytes);
        simulation_destroy(straight);
        simulation_destroy(sim);
    }
    advance(whole, 50);
    while (sliced->step < 50) {
        bool done;
        ck_assert(simulation_slice(sliced, 7, &done, &status));
    }
    ck_assert(same_bits(whole, sliced));
    /* a live parameter belongs to the state */
    void *before = malloc(simulation_snapshot_size(whole));
    ck_assert(before != NULL);
    simulation_snapshot(whole, before);
    ck_assert(whole->method->change(whole, "load.body_force", 0.5, &status));
    ck_assert_double_eq(of_particle(whole, "load", 3), 0.5);
    ck_assert(!same_bits(whole, sliced));
    simulation_restore(whole, before);
    ck_assert(same_bits(whole, sliced));
    ck_assert(!whole->method->change(whole, "pd.horizon", 3, &status));
    ck_assert(strstr(status.text, "pd.horizon: cannot change in mid-run") != NULL);
    free(before);
    simulation_destroy(whole);
    simulation_destroy(sliced);
}
END_TEST

/* --- what is seen --------------------------------------------------------------------------------- */

START_TEST(links_and_bonds)
{
    BeamDef def = standard(true, false);
    Simulation *sim = create(&def);
    Link links[16];
    advance(sim, 40);
    /* every force is the sum of its links, which a mirrored node takes part in under its partner's number */
    for (size_t i = 0; i < sim->counts[0]; i++) {
        size_t n = sim->method->links(sim, 0, i, links, 16);
        ck_assert_int_eq((int)n, (int)of_particle(sim, "family", i));
        double least = 0;
        for (size_t k = 0; k < n; k++) {
            ck_assert_int_eq(links[k].set, 0);
            ck_assert_uint_lt(links[k].index, sim->counts[0]);
            least += fabs(link_pull(&links[k]));
            ck_assert_double_eq_tol(links[k].factors[0] * links[k].factors[1] * links[k].factors[2] *
                                        links[k].factors[3],
                                    links[k].stiffness, 1e-12);
        }
        ck_assert_double_ge(least * (1 + 1e-12), fabs(of_particle(sim, "force", i)));
    }
    ck_assert_uint_eq(sim->method->links(sim, 0, 9, links, 4), 4); /* no more than there is room for */
    ck_assert_uint_eq(sim->method->links(sim, 0, 0, links, 16), 6);
    ck_assert_uint_eq(links[0].index, 2); /* three spacings to the left of node 0 lies the image of node 2 */
    ck_assert_uint_eq(links[2].index, 0);
    ck_assert(links[0].mirrored && links[2].mirrored && !links[3].mirrored);
    /* bonds: 47 nodes with three to the right, then two, one, none */
    ck_assert_uint_eq(sim->counts[1], 47 * 3 + 2 + 1);
    static double ends[2][256], stretch[256];
    const char *const names[] = {"i", "j"};
    for (int e = 0; e < 2; e++)
        sim->method->field(sim, simulation_find_field(sim, 1, names[e]), 0, sim->counts[1], ends[e]);
    sim->method->field(sim, simulation_find_field(sim, 1, "stretch"), 0, sim->counts[1], stretch);
    size_t number = 0;
    for (int i = 0; i < 50; i++)
        for (int j = i + 1; j <= i + 3 && j < 50; j++, number++) {
            ck_assert_double_eq(ends[0][number], i);
            ck_assert_double_eq(ends[1][number], j);
            double elongation = of_particle(sim, "u", (size_t)j) - of_particle(sim, "u", (size_t)i);
            ck_assert_double_eq_tol(stretch[number], elongation / (0.5 * (j - i)), 1e-15);
        }
    ck_assert_uint_eq(number, sim->counts[1]);
    simulation_destroy(sim);
}
END_TEST

/* What is printed adds up as it is printed. */
static void expect_sums(const char *text)
{
    for (const char *line = text; *line != '\0'; line = strchr(line, '\n') + 1) {
        PrintedSum sum;
        if (read_sum(line, &sum))
            ck_assert_msg(fabs(sum.value - sum.result) <= sum.last * (1 + 1e-5), "%sit comes to %.9g", line,
                          sum.value);
    }
}

START_TEST(stages_explain_themselves)
{
    BeamDef def = standard(true, false);
    Simulation *sim = create(&def);
    Status status = {0};
    char text[512];
    advance(sim, 3);
    void *before = malloc(sim->method->state_size(sim));
    ck_assert(before != NULL);
    for (int stage = 0; stage < sim->n_stages; stage++) {
        simulation_save(sim, before);
        ck_assert(simulation_stage(sim, &status));
        for (size_t i = 0; i < 50; i += 49) {
            sim->method->explain(sim, stage, 0, i, before, 0, text, sizeof text);
            expect_sums(text);
            ck_assert_uint_gt(strlen(text), 10);
        }
        sim->method->explain(sim, stage, 0, 0, before, 0, text, 8);
        ck_assert_uint_lt(strlen(text), 8);
        for (const char *word = sim->stages[stage].reads; *word; word += strcspn(word, " ")) {
            char name[32];
            word += strspn(word, " ");
            snprintf(name, sizeof name, "%.*s", (int)strcspn(word, " "), word);
            ck_assert_msg(simulation_find_field(sim, 0, name) >= 0, "no field %s", name);
        }
    }
    sim->method->explain(sim, 3, 0, 0, NULL, 0, text, sizeof text);
    ck_assert_msg(strstr(text, "to the mirror of 0: c G w V s = "), "%s", text);
    free(before);
    simulation_destroy(sim);
}
END_TEST

/* One node between two walls has no other neighbour than its images. */
START_TEST(a_lonely_node_bursts_too)
{
    BeamDef def = standard(true, true);
    def.length = def.spacing = def.horizon = 0.5;
    double step;
    Status status = {0};
    ck_assert(bonds_line_critical_step(&def, &step, &status));
    def.dt = 1.1 * step;
    Simulation *sim = create(&def);
    long done;
    ck_assert(!simulation_steps(sim, 10000, NULL, &done, &status));
    ck_assert_msg(strstr(status.text, "unstable: particle 0 has met or lost its neighbour") == status.text,
                  "%s", status.text);
    ck_assert_int_eq(done, sim->step);
    ck_assert(fabs(of_particle(sim, "u", 0)) < 0.25);
    simulation_destroy(sim);
}
END_TEST

START_TEST(refusals)
{
    static const struct {
        size_t offset;
        double value;
        const char *says;
    } wrong[] = {
        {offsetof(BeamDef, spacing), 0.7, "pd.spacing: the length 25 is"},
        {offsetof(BeamDef, horizon), 0.4, "pd.horizon: 0.4 is below the spacing"},
        {offsetof(BeamDef, horizon), 13, "pd.horizon: 13 is 26 spacings (at most 24"},
        {offsetof(BeamDef, traction_layer), 26, "load.traction_layer: 26 is out of range"},
        {offsetof(BeamDef, traction_layer), 0.25,
         "load.traction_layer: 0.25 holds no particle (more than 0.25, or 0"},
        {offsetof(BeamDef, spacing), 1e-6,
         "pd.spacing: the length 25 is 2.5e+07 spacings of 1e-06 (a whole number, at most"},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; k++) {
        BeamDef def = standard(true, false);
        Status status = {0};
        memcpy((char *)&def + wrong[k].offset, &wrong[k].value, sizeof(double));
        ck_assert(!beam_check(&def, &status));
        ck_assert_msg(strstr(status.text, wrong[k].says) == status.text, "%s", status.text);
    }
    BeamDef def = standard(true, false);
    Status status = {0};
    def.surface_correction = SURFACE_VOLUME;
    ck_assert(!beam_check(&def, &status));
    ck_assert(strstr(status.text, "pd.surface_correction: volume is for beams") == status.text);
    def = standard(true, false);
    def.length = 1;
    ck_assert(!beam_check(&def, &status));
    ck_assert(strstr(status.text, "pd.horizon: 1.5 reaches beyond the whole bar") == status.text);
    /* of bars, beams and plates alike: without a bond there is no lattice */
    def = standard(true, false);
    def.horizon = def.spacing;
    ck_assert(beam_check(&def, &status));
    while (strcmp(beam_mistake_words[def.mistake], "horizon_strict") != 0)
        def.mistake++;
    ck_assert(!beam_check(&def, &status));
    ck_assert_str_eq(status.text,
                     "pd.mistake: horizon_strict is defined for pd.horizon = more than 1 spacing only");
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("bar");
    tcase_add_test(tcase, every_pair);
    tcase_add_test(tcase, uniform_strain);
    tcase_add_test(tcase, free_bar_keeps_momentum);
    tcase_add_test(tcase, energy_to_second_order);
    tcase_add_test(tcase, work_of_loads);
    tcase_add_test(tcase, stages_say_what_acts);
    tcase_add_test(tcase, critical_step);
    tcase_add_test(tcase, rewound_sliced_or_whole);
    tcase_add_test(tcase, links_and_bonds);
    tcase_add_test(tcase, stages_explain_themselves);
    tcase_add_test(tcase, a_lonely_node_bursts_too);
    tcase_add_test(tcase, refusals);
    suite_add_tcase(suite, tcase);
}
