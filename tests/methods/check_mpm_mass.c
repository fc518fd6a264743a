/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Masses that are not lumped: what is solved, kept, predicted and stable with a mass blend and with FMPM. */
#include "methods/bar_case.h"
#include "methods/default_defs.h"
#include "suite.h"
#include "theory/elastic_bar.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* M v = p row by row, as the fields tell M, v and p after the boundary conditions: short bars, and long ones,
 * which are solved in stretches side by side, with the weakest diagonal that is allowed and crossings. */
START_TEST(rows_add_up)
{
    static const struct {
        MpmShape shape;
        int cells;
    } bars[] = {{MPM_HAT, 25},      {MPM_HAT, 2047},    {MPM_HAT, 3001}, {MPM_GIMP, 40},
                {MPM_BSPLINE2, 40}, {MPM_BSPLINE3, 40}, {MPM_CPDI, 40}};
    BarCase bar = bar_case(bars[_i].cells / 6, 1.0);
    bar.def.shape = bars[_i].shape;
    bar.def.length = bars[_i].cells;
    bar.def.mass_blend = BAR_MASS_BLEND_LEAST;
    bar.def.courant = 0.05;
    Simulation *sim = bar_case_create(&bar);
    advance(sim, 60);
    Status status;
    ck_assert(simulation_stage(sim, &status) && simulation_stage(sim, &status));
    const size_t n = sim->counts[1];
    double *p = field_now(sim, 1, "momentum"), *v = field_now(sim, 1, "velocity");
    double *fixed = field_now(sim, 1, "fixed"), *active = field_now(sim, 1, "active");
    double *sum = calloc(n, sizeof *sum), most = 0;
    static const char *const names[] = {"mass_0", "mass_1", "mass_2", "mass_3"};
    for (size_t d = 0; d < 4 && simulation_find_field(sim, 1, names[d]) >= 0; d++) {
        double *mass = field_now(sim, 1, names[d]);
        for (size_t i = 0; i + d < n; i++) {
            sum[i] += mass[i] * v[i + d];
            sum[i + d] += d > 0 ? mass[i] * v[i] : 0;
        }
        free(mass);
    }
    for (size_t i = 0; i < n; i++)
        most = fmax(most, fabs(p[i]));
    for (size_t i = 0; i < n; i++)
        if (fixed[i] != 0 || active[i] == 0)
            ck_assert_double_eq(v[i], 0);
        else
            ck_assert_msg(fabs(sum[i] - p[i]) <= 2e-15 * most, "node %zu: %.17g is not %.17g", i, sum[i],
                          p[i]);
    free(sum), free(p), free(v), free(fixed), free(active);
    simulation_destroy(sim);
}
END_TEST

/* A second material beyond the middle of the bar: twice as fast, twice as heavy. */
static void add_joint(BarCase *bar)
{
    bar->def.joint = 12;
    bar->def.joint_modulus = 800;
    bar->def.joint_density = 2;
}

/* M(i, j) as the fields tell it against (1 - mu) sum m N_i N_j + mu sum m N_i by the particles' own shape
 * functions, those of either material with their own mass. */
START_TEST(rows_across_a_joint)
{
    enum { NODES_MAX = 64, SHAPES_MAX = 8 };
    const double mu = 0.5;
    BarCase bar = bar_case(3, 0.05);
    bar.def.shape = (MpmShape)_i;
    bar.def.mass_blend = mu;
    add_joint(&bar);
    Simulation *sim = bar_case_create(&bar);
    advance(sim, 20);
    Status status;
    ck_assert(simulation_stage(sim, &status) && simulation_stage(sim, &status));
    const size_t n = sim->counts[1];
    ck_assert_uint_le(n, NODES_MAX);
    double by_hand[NODES_MAX][NODES_MAX] = {{0}}, *x0 = field_now(sim, 0, "x0");
    for (size_t p = 0; p < sim->counts[0]; p++) {
        Link nodes[SHAPES_MAX];
        const size_t count = sim->method->links(sim, 0, p, nodes, SHAPES_MAX);
        const double mass = (x0[p] > 12 ? 2 : 1) * 0.5; /* two particles in a cell of length 1 */
        for (size_t a = 0; a < count; a++) {
            by_hand[nodes[a].index][nodes[a].index] += mu * mass * nodes[a].weight;
            for (size_t b = 0; b < count; b++)
                by_hand[nodes[a].index][nodes[b].index] +=
                    (1 - mu) * mass * nodes[a].weight * nodes[b].weight;
        }
    }
    static const char *const names[] = {"mass_0", "mass_1", "mass_2", "mass_3"};
    for (size_t d = 0; d < 4 && simulation_find_field(sim, 1, names[d]) >= 0; d++) {
        double *mass = field_now(sim, 1, names[d]);
        for (size_t i = 0; i + d < n; i++)
            ck_assert_msg(fabs(mass[i] - by_hand[i][i + d]) <= 1e-14, "M(%zu,%zu): %.17g is not %.17g", i,
                          i + d, mass[i], by_hand[i][i + d]);
        free(mass);
    }
    free(x0);
    simulation_destroy(sim);
}
END_TEST

/* sum m v of the particles. */
static double momentum_of(const Simulation *sim)
{
    double *mass = field_now(sim, 0, "mass"), *v = field_now(sim, 0, "v"), sum = 0;
    for (size_t p = 0; p < sim->counts[0]; p++)
        sum += mass[p] * v[p];
    free(mass), free(v);
    return sum;
}

static void expect_momentum(MpmTransfer transfer, double blend, MpmShape shape, MpmAlgorithm algorithm,
                            bool joint)
{
    BarCase bar = bar_case(0, 0.05);
    bar_case_add_mode(&bar, 3, 0.1);
    bar.def.supports = BAR_FREE_FREE;
    bar.def.shape = shape;
    bar.def.algorithm = algorithm;
    bar.def.transfer = transfer;
    bar.def.mass_blend = blend;
    bar.def.fmpm_order = 3;
    if (joint)
        add_joint(&bar);
    Simulation *sim = bar_case_create(&bar);
    const double before = momentum_of(sim);
    advance(sim, 400);
    ck_assert_double_eq_tol(momentum_of(sim), before, 25 * 1e-15 * 400);
    simulation_destroy(sim);
}

START_TEST(momentum_is_kept)
{
    for (int shape = MPM_HAT; shape <= MPM_CPDI; shape++)
        for (int algorithm = MPM_USF; algorithm <= MPM_MUSL; algorithm++) {
            expect_momentum(MPM_FLIP, BAR_MASS_BLEND_LEAST, (MpmShape)shape, (MpmAlgorithm)algorithm, _i);
            expect_momentum(MPM_FMPM, 1.0, (MpmShape)shape, (MpmAlgorithm)algorithm, _i);
        }
}
END_TEST

/* What a run makes of a wave: with hats a sampled mode is an eigenvector of the step. Its amplitude q at the
 * nodes obeys q'' = trace q' - determinant q, which is fitted over some steps. */
static void fit_wave(const BarCase *bar, int mode, double *trace, double *determinant)
{
    enum { STEPS = 120 };
    Simulation *sim = bar_case_create(bar);
    double q[STEPS], beta = bar_case_wave_number(bar, mode), half = bar->def.cell_size / 2;
    Status status;
    for (int k = 0; k < STEPS; k++) {
        ck_assert(simulation_stage(sim, &status) && simulation_stage(sim, &status));
        double *v = field_now(sim, 1, "velocity"), *x = field_now(sim, 1, "x");
        q[k] = 0;
        for (size_t i = 0; i < sim->counts[1]; i++)
            q[k] +=
                (x[i] > 25 - half ? 0.5 : 1) * v[i] * (x[i] > 0 && x[i] < 25 + half ? sin(beta * x[i]) : 0);
        free(v);
        free(x);
        advance(sim, 0); /* the rest of the step */
        ck_assert_int_eq(sim->stage, 0);
    }
    double aa = 0, ab = 0, bb = 0, ac = 0, bc = 0;
    for (int k = 2; k < STEPS; k++) {
        aa += q[k - 1] * q[k - 1], ab += q[k - 1] * q[k - 2], bb += q[k - 2] * q[k - 2];
        ac += q[k - 1] * q[k], bc += q[k - 2] * q[k];
    }
    *trace = (ac * bb - bc * ab) / (aa * bb - ab * ab);
    *determinant = -(bc * aa - ac * ab) / (aa * bb - ab * ab);
    simulation_destroy(sim);
}

/* The usual bar on such a mesh. */
static const BarTheory usual_bar = {.length = 25, .youngs_modulus = 100, .density = 1, .left_fixed = true};

/* Frequency and decay of a run against those of a wave. */
static void expect_wave(MpmAlgorithm algorithm, bool gimp, int order, double blend, double alpha, int mode)
{
    BarCase bar = bar_case(mode, 1e-7);
    bar.def.algorithm = (MpmAlgorithm)algorithm;
    bar.def.shape = gimp ? MPM_GIMP : MPM_HAT;
    bar.def.transfer = order > 0 ? MPM_FMPM : MPM_FLIP;
    bar.def.fmpm_order = order > 0 ? order : 1;
    bar.def.mass_blend = blend;
    bar.def.flip_fraction = alpha;
    double trace, determinant;
    fit_wave(&bar, mode, &trace, &determinant);
    const BarMesh mesh = {.cell_size = 1,
                          .particles_per_cell = 2,
                          .algorithm = algorithm,
                          .shape = MPM_HAT,
                          .flip_fraction = alpha,
                          .consistent = 1 - blend,
                          .fmpm_order = order,
                          .dt = 0.01};
    const Dispersion wave = dispersion_of_bar(&usual_bar, &mesh, bar_case_wave_number(&bar, mode));
    ck_assert(wave.known);
    const double lambda = exp(-wave.decay * 0.01);
    ck_assert_msg(fabs(trace - 2 * lambda * cos(wave.frequency * 0.01)) <= 1e-9 &&
                      fabs(determinant - lambda * lambda) <= 1e-9,
                  "algorithm %d, k %d, mu %g, n %d: %.12f %.12f, not %.12f %.12f", algorithm, order, blend,
                  mode, trace, determinant, 2 * lambda * cos(wave.frequency * 0.01), lambda * lambda);
}

START_TEST(runs_are_as_predicted)
{
    static const int modes[] = {2, 5, 10};
    const MpmAlgorithm algorithm = (MpmAlgorithm)_i;
    for (int n = 0; n < 3; n++) {
        expect_wave(algorithm, false, 0, 5.0 / 18, 1, modes[n]);
        expect_wave(algorithm, true, 0, 0.5, 1, modes[n]);
        expect_wave(algorithm, false, 0, 0.5, 0.95, modes[n]);
        expect_wave(algorithm, false, 4, 1, 1, modes[n]);
        if (modes[n] < 10) /* which FMPM(2) damps away before it can be looked at */
            expect_wave(algorithm, false, 2, 1, 1, modes[n]);
    }
}
END_TEST

/* E* = sum m v^n v^(n+1)/2 + strain energy, of the new stress with USF, of the old one with MUSL, is kept by
 * a blend as by lumped masses. */
START_TEST(blends_keep_the_sharp_energy)
{
    static const double blends[] = {0.05, 5.0 / 18, 0.5};
    /* what is left goes with the amplitude, and is ten times as much at a joint */
    BarCase bar = bar_case(5, _i >= 6 ? 1e-9 : 1e-8);
    bar.def.algorithm = _i % 2 ? MPM_MUSL : MPM_USF;
    bar.def.mass_blend = blends[_i / 2 % 3];
    if (_i >= 6)
        add_joint(&bar);
    Simulation *sim = bar_case_create(&bar);
    double first = 0, worst = 0, strain = 0, *v = field_now(sim, 0, "v"), *mass = field_now(sim, 0, "mass");
    for (int step = 0; step < 10000; step++) {
        advance(sim, 1);
        double *next = field_now(sim, 0, "v"), next_strain = series_now(sim, "strain"),
               energy = _i % 2 ? strain : next_strain;
        for (size_t p = 0; p < sim->counts[0]; p++)
            energy += 0.5 * mass[p] * v[p] * next[p];
        strain = next_strain;
        free(v);
        v = next;
        if (step == 0)
            first = energy;
        worst = fmax(worst, fabs(energy / first - 1));
    }
    free(v), free(mass);
    ck_assert_msg(worst <= 1e-10, "mu %g: E* wanders by %.3g", bar.def.mass_blend, worst);
    simulation_destroy(sim);
}
END_TEST

/* --- the largest step ------------------------------------------------------------------------------- */

static unsigned drawn = 12345;

static int draw(int least, int most)
{
    drawn = drawn * 1664525u + 1013904223u;
    return least + (int)((drawn >> 8) % (unsigned)(most - least + 1));
}

/* Whether the energy came to 1e4 times what it was, where the engine stops. */
static bool blows_up(BarCase *bar, double courant, long steps)
{
    bar->def.courant = courant;
    Simulation *sim = bar_case_create(bar);
    const bool sound = simulation_steps(sim, steps, NULL, NULL, NULL);
    simulation_destroy(sim);
    return !sound;
}

START_TEST(limits_of_any_parameters)
{
    for (int set = 0; set < (suite_wide() ? 1000 : 300); set++) {
        BarCase bar = bar_case(1, 1e-9);
        bar.def.length = draw(5, 14);
        for (int mode = 2; mode <= BAR_CASE_MODES; mode++)
            bar_case_add_mode(&bar, (int)bar.def.length * (mode - 1) / 3, 1e-9);
        bar.def.supports = (BarSupports)draw(0, 3);
        bar.def.shape = (MpmShape)draw(MPM_HAT, MPM_CPDI);
        bar.def.algorithm = (MpmAlgorithm)draw(0, 2);
        bar.def.particles_per_cell = draw(1, 4);
        bar.def.padding = draw(1, 4);
        const int transfer = draw(0, 3);
        bar.def.transfer = transfer == 1 ? MPM_APIC : transfer == 2 ? MPM_FMPM : MPM_FLIP;
        bar.def.mass_blend = transfer == 3 ? draw(5, 99) / 100.0 : 1;
        bar.def.flip_fraction = transfer != 1 && transfer != 2 && draw(0, 1) ? draw(0, 99) / 100.0 : 1;
        bar.def.fmpm_order = draw(1, FMPM_ORDER_MAX);
        const BarSupports ends = bar.def.supports;
        const double limit = bar_case_limit(&bar);
        ck_assert(limit > 0.1 && limit < 4);
        const char *const words =
            "set %d (shape %d, algorithm %d, transfer %d, P %d, supports %d, mu %g, alpha "
            "%g, k %d, cells %g, limit %.5f) %s";
#define SET_OF_PARAMETERS                                                                                    \
    set, bar.def.shape, bar.def.algorithm, transfer, bar.def.particles_per_cell, ends, bar.def.mass_blend,   \
        bar.def.flip_fraction, bar.def.fmpm_order, bar.def.length, limit
        ck_assert_msg(!blows_up(&bar, 0.999 * limit, 2000), words, SET_OF_PARAMETERS, "grows at .999");
        ck_assert_msg(blows_up(&bar, 1.001 * limit, 100000), words, SET_OF_PARAMETERS, "is stable at 1.001");
    }
}
END_TEST

/* Crossing at v0 = 3: domains that stretch with their particles keep the energy. */
START_TEST(stretching_domains_keep_the_energy)
{
    BarCase bar = bar_case(1, 3.0);
    bar.def.shape = MPM_CPDI;
    bar.def.padding = 40;
    Simulation *sim = bar_case_create(&bar);
    double tenths[2], *row = malloc((size_t)sim->n_series * sizeof *row);
    const int total = simulation_find_series(sim, "total");
    for (int part = 0; part < 2; part++) {
        tenths[part] = 0;
        for (int k = 0; k < 1000; k++) {
            advance(sim, 1);
            simulation_row(sim, row);
            tenths[part] += row[total];
        }
        if (part == 0)
            advance(sim, 8000);
    }
    ck_assert_double_eq_tol(tenths[1] / tenths[0], 0.9998, 5.1e-5);
    double *stretch = field_now(sim, 0, "stretch"), *density = field_now(sim, 0, "density");
    for (size_t p = 0; p < sim->counts[0]; p++)
        ck_assert_double_eq_tol(stretch[p] * density[p], 1, 1e-14);
    free(stretch), free(density), free(row);
    simulation_destroy(sim);
}
END_TEST

/* A domain of two cells would reach beyond the nodes that a cell's particles know. */
START_TEST(no_domain_over_two_cells)
{
    BarCase bar = bar_case(1, 0);
    bar.def.shape = MPM_CPDI;
    bar.def.particles_per_cell = 1;
    bar.def.padding = 40;
    bar.def.traction = 200;
    Simulation *sim = bar_case_create(&bar);
    Status status = {0};
    ck_assert(!simulation_steps(sim, 5000, NULL, NULL, &status));
    ck_assert_msg(strstr(status.text, "was stretched over two cells"), "%s", status.text);
    simulation_destroy(sim);
}
END_TEST

START_TEST(best_blend)
{
    static const struct {
        MpmShape shape;
        int per_cell;
        double courant, best;
    } known[] = {
        {MPM_HAT, 1, 0, 1.0 / 3},      {MPM_HAT, 2, 0, 5.0 / 18},    {MPM_HAT, 3, 0, 5.0 / 19},
        {MPM_HAT, 4, 0, 17.0 / 66},    {MPM_HAT, 2, 0.1, 0.28},      {MPM_GIMP, 2, 0.4, 0.28 + 0.1 / 3},
        {MPM_CPDI, 2, 0.8, 0.42},      {MPM_HAT, 2, 5, 1},           {MPM_BSPLINE2, 2, 0, -1.0 / 24},
        {MPM_BSPLINE2, 4, 1, 0.15625}, {MPM_BSPLINE3, 2, 0.8, 0.08},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++)
        ck_assert_double_eq_tol(bar_mass_blend_auto(known[i].shape, known[i].per_cell, known[i].courant),
                                known[i].best, 1e-15);
}
END_TEST

/* Errors of the frequency of mode 5 in per cent, P = 2, by Courant number and cells of 1, 1/2, 1/4, 1/8: of
 * second order with the share for C -> 0, of fourth with mu*(C). A reference solver's digits. */
static const struct {
    double courant, still[4], best[4];
} orders[] = {
    {0.1, {-.0226, .0011, .0007, .0002}, {-.036126, -.002224, -.000138, -.000009}},
    {0.4, {.1780, .0512, .0132, .0033}, {-.039255, -.002414, -.000150, -.000009}},
    {0.8, {.8360, .2122, .0532, .0133}, {-.045542, -.002787, -.000173, -.000011}},
};

static double predicted_error(double cell, double courant, double blend, double beta)
{
    const BarMesh mesh = {.cell_size = cell,
                          .particles_per_cell = 2,
                          .shape = MPM_HAT,
                          .flip_fraction = 1,
                          .consistent = 1 - blend,
                          .dt = courant * cell / 10};
    const Dispersion wave = dispersion_of_bar(&usual_bar, &mesh, beta);
    ck_assert(wave.known);
    return 100 * (wave.frequency / (10 * beta) - 1);
}

START_TEST(fourth_order_at_any_step)
{
    const double courant = orders[_i].courant;
    BarCase bar = bar_case(5, 1e-6);
    bar.def.courant = courant;
    bar.def.mass_blend = 0;
    const double beta = bar_case_wave_number(&bar, 5);
    for (int k = 0; k < 4; k++) {
        const double cell = 1.0 / (1 << k);
        const double best = predicted_error(cell, courant, bar_mass_blend_auto(MPM_HAT, 2, courant), beta);
        ck_assert_double_eq_tol(best, orders[_i].best[k], 5.1e-7);
        ck_assert_double_eq_tol(predicted_error(cell, courant, 5.0 / 18, beta), orders[_i].still[k],
                                k ? 5.1e-5 : 5.1e-4);
        if (k > 1)
            continue;
        bar.def.cell_size = cell; /* and measured where it costs little */
        double trace, determinant;
        fit_wave(&bar, 5, &trace, &determinant);
        const double measured = acos(trace / 2) / (courant * cell / 10);
        ck_assert_double_eq_tol(determinant, 1, 1e-9);
        ck_assert_double_eq_tol(100 * (measured / (10 * beta) - 1), orders[_i].best[k], 2e-6);
    }
}
END_TEST

START_TEST(what_does_not_fit_is_refused)
{
    static const struct {
        double blend;
        MpmTransfer transfer;
        MpmShape shape;
        const char *words;
    } wrong[] = {
        {0.04, MPM_FLIP, MPM_HAT, "mpm.mass_blend: with 0.04 the largest stable step nearly vanishes"},
        {0.5, MPM_APIC, MPM_HAT, "mpm.mass_blend: less than 1 is for mpm.transfer = flip"},
        {0.0, MPM_FMPM, MPM_HAT, "mpm.mass_blend: less than 1 is for mpm.transfer = flip"},
        {0.0, MPM_FLIP, MPM_BSPLINE2,
         "mpm.mass_blend: auto would be -0.04 with this shape, and below 0.05 the"},
    };
    MpmDef def = bar_default();
    def.mass_blend = wrong[_i].blend;
    def.transfer = wrong[_i].transfer;
    def.shape = wrong[_i].shape;
    Status status = {0};
    ck_assert(!mpm_check(&def, &status));
    ck_assert_msg(strncmp(status.text, wrong[_i].words, strlen(wrong[_i].words)) == 0, "%s", status.text);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *rows = tcase_create("rows"), *test = tcase_create("mass");
    tcase_add_loop_test(rows, rows_add_up, 0, 7);
    tcase_add_loop_test(rows, rows_across_a_joint, MPM_HAT, MPM_CPDI + 1);
    suite_add_tcase(suite, rows);
    tcase_add_loop_test(test, momentum_is_kept, 0, 2);
    tcase_add_loop_test(test, runs_are_as_predicted, 0, 3);
    tcase_add_loop_test(test, blends_keep_the_sharp_energy, 0, 12);
    tcase_add_test(test, limits_of_any_parameters);
    tcase_add_test(test, stretching_domains_keep_the_energy);
    tcase_add_test(test, no_domain_over_two_cells);
    tcase_add_test(test, best_blend);
    tcase_add_loop_test(test, fourth_order_at_any_step, 0, sizeof orders / sizeof *orders);
    tcase_add_loop_test(test, what_does_not_fit_is_refused, 0, 4);
    suite_add_tcase(suite, test);
}
