/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What one step does to a bar at rest on its mesh: how large it may be, and how a mode goes on. The tables
 * are those of an independent program, and the engine has the last word. */
#include "methods/bar_case.h"
#include "suite.h"
#include "theory/bar_rest.h"
#include "theory/step_limit.h"
#include "theory/step_spectrum.h"

#include <complex.h>
#include <gsl/gsl_blas.h>
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdlib.h>

enum { FIXED_FREE, FREE_FREE, FIXED_FIXED, FREE_FIXED, SUPPORTS };

static BarTheory bar_with(int supports, double length)
{
    return (BarTheory){.length = length,
                       .youngs_modulus = 100,
                       .density = 1,
                       .left_fixed = supports == FIXED_FREE || supports == FIXED_FIXED,
                       .right_fixed = supports == FREE_FIXED || supports == FIXED_FIXED};
}

static BarMesh mesh_with(MpmShape shape, int per_cell, MpmAlgorithm algorithm, bool apic)
{
    return (BarMesh){.cell_size = 1,
                     .particles_per_cell = per_cell,
                     .padding = 4,
                     .algorithm = algorithm,
                     .shape = shape,
                     .apic = apic,
                     .flip_fraction = 1,
                     .dt = 0.01};
}

/* --- the largest step ----------------------------------------------------------------------------- */

/* Of FLIP: the endless mesh, then fixed-free, free-free, fixed-fixed; of APIC without the endless one. */
static const struct {
    MpmShape shape;
    int per_cell;
    double flip[2][4], apic[2][3]; /* USF, USL */
} limits[] = {
    {MPM_HAT,
     1,
     {{2.0000, 2.0000, 2.0040, 2.0040}, {0.7071, 0.7076, 0.7071, 0.7092}},
     {{1.0005, 1.0000, 1.0020}, {1.0005, 1.0000, 1.0020}}},
    {MPM_HAT,
     2,
     {{1.7321, 1.7326, 1.7323, 1.7323}, {0.7559, 0.7565, 0.7559, 0.7581}},
     {{1.0005, 1.0000, 1.0020}, {1.0005, 1.0000, 1.0020}}},
    {MPM_HAT,
     4,
     {{1.6583, 1.6586, 1.6586, 1.6586}, {0.7698, 0.7703, 0.7698, 0.7719}},
     {{1.0005, 1.0000, 1.0020}, {1.0005, 1.0000, 1.0020}}},
    {MPM_BSPLINE2,
     1,
     {{2.5406, 2.3815, 2.5054, 2.3814}, {1.6551, 0.9735, 0.9735, 1.6313}},
     {{1.4535, 1.4535, 2.0345}, {1.2142, 1.2142, 1.8355}}},
    {MPM_BSPLINE2,
     2,
     {{2.3953, 2.0510, 2.2973, 2.0510}, {1.3500, 0.9986, 0.9986, 1.2261}},
     {{1.4000, 1.4000, 1.6227}, {1.2857, 1.2857, 1.4449}}},
    {MPM_BSPLINE2,
     4,
     {{2.3548, 1.9559, 2.2591, 1.9559}, {1.2705, 0.9987, 0.9987, 1.1284}},
     {{1.3996, 1.3996, 1.5223}, {1.2808, 1.2808, 1.3368}}},
    {MPM_BSPLINE3,
     1,
     {{2.6952, 2.6235, 2.6474, 2.6225}, {1.3700, 1.0364, 1.0364, 1.2643}},
     {{1.5253, 1.5253, 1.8391}, {1.3293, 1.3293, 1.5409}}},
    {MPM_BSPLINE3,
     2,
     {{2.7079, 1.9413, 2.6115, 1.9413}, {1.4859, 1.1184, 1.1184, 1.1426}},
     {{1.5430, 1.5960, 1.5430}, {1.3059, 1.4071, 1.3059}}},
    {MPM_BSPLINE3,
     4,
     {{2.7089, 1.7133, 2.6015, 1.7133}, {1.4915, 0.9627, 1.1322, 0.9627}},
     {{1.3321, 1.6078, 1.3321}, {1.0992, 1.4205, 1.0992}}},
};

static const double printed = 5.01e-5; /* four places */

static void expect_limits(MpmShape shape, size_t row, bool apic)
{
    static const MpmAlgorithm algorithms[] = {MPM_USF, MPM_USL, MPM_MUSL};
    for (int a = 0; a < 3; a++) {
        const BarMesh mesh = mesh_with(shape, limits[row].per_cell, algorithms[a], apic);
        const int column = algorithms[a] == MPM_USL;
        const double endless = dispersion_endless_courant(&mesh);
        if (!apic)
            ck_assert_double_eq_tol(endless, limits[row].flip[column][0], printed);
        for (int supports = 0; supports < SUPPORTS; supports++) {
            const int same = supports == FREE_FIXED ? FIXED_FREE : supports; /* the mirror image */
            const BarTheory bar = bar_with(supports, 25);
            const double expected =
                apic ? limits[row].apic[column][same] : limits[row].flip[column][1 + same];
            const double limit = step_limit_with_ends(&bar, &mesh);
            ck_assert_msg(fabs(limit - expected) <= printed, "shape %d, P = %d, %d, %d, %d: %.6f not %.4f",
                          shape, limits[row].per_cell, algorithms[a], apic, supports, limit, expected);
            ck_assert_double_eq(step_limit(&bar, &mesh), fmin(limit, endless));
        }
    }
}

START_TEST(limits_of_bars)
{
    for (int apic = 0; apic < 2; apic++) {
        expect_limits(limits[_i].shape, (size_t)_i, apic);
        if (limits[_i].shape == MPM_HAT)
            expect_limits(MPM_GIMP, (size_t)_i, apic);
    }
}
END_TEST

START_TEST(limits_of_padding_and_blend)
{
    static const struct {
        MpmShape shape;
        int padding;
        double flip_fraction, usf, usl;
    } rows[] = {
        {MPM_BSPLINE2, 0, 1, 1.559, 0.675},   {MPM_BSPLINE3, 0, 1, 1.433, 0.532},
        {MPM_BSPLINE2, 1, 1, 2.051, 0.999},   {MPM_BSPLINE3, 1, 1, 1.941, 1.014},
        {MPM_BSPLINE3, 2, 1, 1.9413, 1.1184}, {MPM_BSPLINE3, 9, 1, 1.9413, 1.1184},
        {MPM_HAT, 4, 0.9, 1.710, 0.759},      {MPM_HAT, 4, 0.5, 1.617, 0.769},
        {MPM_HAT, 4, 0, 1.479, 0.791},        {MPM_BSPLINE2, 4, 0.9, 2.034, 1.000},
        {MPM_BSPLINE2, 4, 0.5, 1.960, 1.009}, {MPM_BSPLINE2, 4, 0, 1.854, 1.025},
    };
    const BarTheory bar = bar_with(FIXED_FREE, 25);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (int usl = 0; usl < 2; usl++) {
            BarMesh mesh = mesh_with(rows[i].shape, 2, usl ? MPM_USL : MPM_USF, false);
            mesh.padding = rows[i].padding;
            mesh.flip_fraction = rows[i].flip_fraction;
            ck_assert_double_eq_tol(step_limit_with_ends(&bar, &mesh), usl ? rows[i].usl : rows[i].usf,
                                    5.01e-4);
        }
}
END_TEST

/* 32 cells stand for more: never too high by more than 1e-8. A bar that cannot move has no limit. */
START_TEST(limits_of_long_bars)
{
    static const MpmShape shapes[] = {MPM_HAT, MPM_BSPLINE2, MPM_BSPLINE3};
    for (int s = 0; s < 3; s++)
        for (int usl = 0; usl < 2; usl++) {
            const BarMesh mesh = mesh_with(shapes[s], 2, usl ? MPM_USL : MPM_USF, false);
            const BarTheory some = bar_with(FIXED_FREE, 32), more = bar_with(FIXED_FREE, 1e6);
            ck_assert_double_eq(step_limit(&some, &mesh), step_limit(&more, &mesh));
        }
    const BarTheory held = bar_with(FIXED_FIXED, 1);
    const BarMesh mesh = mesh_with(MPM_HAT, 2, MPM_USF, false);
    ck_assert(isinf(step_limit_with_ends(&held, &mesh)));
}
END_TEST

/* --- runs ----------------------------------------------------------------------------------------- */

static BarCase case_of(const BarTheory *bar, const BarMesh *mesh, int number, double velocity)
{
    static const MpmAlgorithm algorithms[] = {
        [MPM_USF] = MPM_USF, [MPM_USL] = MPM_USL, [MPM_MUSL] = MPM_MUSL};
    static const MpmShape shapes[] = {[MPM_HAT] = MPM_HAT,
                                      [MPM_GIMP] = MPM_GIMP,
                                      [MPM_BSPLINE2] = MPM_BSPLINE2,
                                      [MPM_BSPLINE3] = MPM_BSPLINE3};
    BarCase which = bar_case(number, velocity);
    which.def.length = bar->length;
    which.def.supports = bar->left_fixed ? (bar->right_fixed ? BAR_FIXED_FIXED : BAR_FIXED_FREE)
                                         : (bar->right_fixed ? BAR_FREE_FIXED : BAR_FREE_FREE);
    which.def.particles_per_cell = mesh->particles_per_cell;
    which.def.offset = mesh->offset;
    which.def.padding = mesh->padding;
    which.def.algorithm = algorithms[mesh->algorithm];
    which.def.shape = shapes[mesh->shape];
    which.def.transfer = mesh->apic ? MPM_APIC : MPM_FLIP;
    which.def.flip_fraction = mesh->flip_fraction;
    which.def.courant = mesh->dt * bar_fastest_speed(bar);
    which.def.joint = bar->joint;
    which.def.joint_modulus = bar->joint_modulus, which.def.joint_density = bar->joint_density;
    return which;
}

/* Whether 4000 steps keep the energy of a mode so small that the particles stay where they are. */
static bool run_keeps(const BarTheory *bar, BarMesh mesh, double courant)
{
    mesh.dt = courant / bar_fastest_speed(bar);
    const BarCase which = case_of(bar, &mesh, 9, 1e-12);
    Simulation *sim = bar_case_create(&which);
    const double start = series_now(sim, "total");
    double largest = 0;
    for (int k = 0; k < 4000 && largest < 100 * start; k++) {
        advance(sim, 1);
        largest = fmax(largest, series_now(sim, "total"));
    }
    simulation_destroy(sim);
    return largest < 100 * start;
}

/* With a second material beyond 10: the slower of the two, the faster; 0: none. */
static BarTheory joined(BarTheory bar, int second)
{
    if (second > 0) {
        bar.joint = 10;
        bar.joint_modulus = second == 1 ? 50 : 400;
        bar.joint_density = second == 1 ? 4 : 0.5;
    }
    return bar;
}

START_TEST(limits_hold_in_runs)
{
    static const struct {
        MpmShape shape;
        MpmAlgorithm algorithm;
        bool apic;
        double flip_fraction;
        int supports;
    } rows[] = {
        {MPM_HAT, MPM_USF, false, 1, FIXED_FREE},      {MPM_HAT, MPM_USL, false, 0.9, FIXED_FIXED},
        {MPM_BSPLINE2, MPM_USF, false, 1, FIXED_FREE}, {MPM_BSPLINE2, MPM_USL, false, 1, FIXED_FREE},
        {MPM_BSPLINE2, MPM_USF, true, 1, FIXED_FIXED}, {MPM_BSPLINE3, MPM_MUSL, false, 1, FIXED_FREE},
        {MPM_BSPLINE3, MPM_USL, true, 1, FREE_FREE},
    };
    const BarTheory bar = bar_with(rows[_i].supports, 25);
    BarMesh mesh = mesh_with(rows[_i].shape, 2, rows[_i].algorithm, rows[_i].apic);
    mesh.flip_fraction = rows[_i].flip_fraction;
    for (int second = 0; second < 3; second++) {
        const BarTheory of_two = joined(bar, second);
        const double limit = step_limit_with_ends(&of_two, &mesh);
        ck_assert(run_keeps(&of_two, mesh, 0.995 * limit));
        ck_assert(!run_keeps(&of_two, mesh, 1.01 * limit));
    }
}
END_TEST

/* Particles beside the middle of their shares leave the node at one free end nearly empty: of hats that alone
 * makes the step a third smaller. */
START_TEST(limits_hold_beside_the_middle)
{
    const BarTheory bar = bar_with(FIXED_FREE, 25);
    BarMesh mesh = mesh_with(_i % 2 ? MPM_BSPLINE2 : MPM_HAT, 1 + _i / 2, MPM_USF, false);
    const double middle = step_limit(&bar, &mesh);
    mesh.offset = -0.4;
    const double limit = step_limit(&bar, &mesh);
    if (_i == 0)
        ck_assert_double_lt(limit, 2.0 / 3 * middle);
    ck_assert(run_keeps(&bar, mesh, 0.995 * limit));
    ck_assert(!run_keeps(&bar, mesh, 1.01 * limit));
}
END_TEST

/* Of a longer bar each end keeps its own material, and the joint both. */
START_TEST(limits_of_long_bars_of_two)
{
    const BarMesh mesh = mesh_with(MPM_BSPLINE2, 2, MPM_USL, false);
    const double joints[] = {3, 60, 117};
    for (int i = 0; i < 3; i++) {
        BarTheory bar = joined(bar_with(FIXED_FREE, 120), 1);
        bar.joint = joints[i];
        const double limit = step_limit(&bar, &mesh);
        BarTheory kept = bar; /* 32 cells, of which the shorter part keeps its own */
        kept.length = 32;
        kept.joint = i == 0 ? 3 : i == 1 ? 16 : 29;
        ck_assert_double_eq(step_limit(&kept, &mesh), limit);
        ck_assert(run_keeps(&bar, mesh, 0.99 * limit));
        ck_assert(!run_keeps(&bar, mesh, 1.02 * limit));
    }
}
END_TEST

/* --- a mode --------------------------------------------------------------------------------------- */

static const int numbers[3] = {1, 5, 10};

/* P = 2, courant .1, USF. decay 0: none. */
static const struct {
    MpmShape shape;
    bool apic;
    struct {
        double frequency[3], decay[3];
        bool mixture[3];
    } of[3]; /* fixed-free, free-free, fixed-fixed */
} modes[] = {
    {MPM_HAT,
     false,
     {{{0.627983738, 5.415168088, 9.823832520}, {0}, {0}},
      {{1.253960524, 5.955795243, 10.122982103}, {0}, {0}},
      {{1.253960524, 5.955795243, 10.122982103}, {0}, {0}}}},
    {MPM_HAT,
     true,
     {{{0.628216215, 5.580546227, 11.247595433}, {0}, {0}},
      {{1.255818643, 6.181323927, 11.762484752}, {0}, {0}},
      {{1.255818643, 6.181323927, 11.762484752}, {0}, {0}}}},
    {MPM_BSPLINE2,
     false,
     {{{0.627678986, 5.212199603, 8.256228915}, {0}, {false, true, true}},
      {{1.251473004, 5.695632485, 8.284373034}, {0}, {false, true, true}},
      {{1.251568670, 5.750011664, 8.282366407}, {0}, {false, true, true}}}},
    {MPM_BSPLINE2,
     true,
     {{{0.627991337, 5.420944523, 9.736662096}, {2e-05, 0.12, 2}, {false, false, true}},
      {{1.253968904, 5.963210741, 10.183696896}, {0.00032, 0.18, 2.7}, {false, false, true}},
      {{1.254081737, 5.962514388, 9.865850856}, {0.0003, 0.18, 2.4}, {false, false, true}}}},
    {MPM_BSPLINE3,
     false,
     {{{0.627192023, 5.103060349, 7.319872263}, {0}, {false, false, true}},
      {{1.250059594, 5.508828822, 7.660359939}, {0}, {false, false, true}},
      {{1.248677063, 5.549358431, 7.310935233}, {0}, {false, true, true}}}},
    {MPM_BSPLINE3,
     true,
     {{{0.627749909, 5.373458063, 9.692310092}, {0.00013, 0.22, 2.7}, {false, false, true}},
      {{1.253377451, 5.898774807, 9.777150142}, {0.00059, 0.33, 3}, {false, false, true}},
      {{1.253130585, 5.896631197, 9.592898948}, {0.00092, 0.34, 4.1}, {false, false, true}}}},
};

START_TEST(modes_with_ends)
{
    for (int gimp = 0; gimp <= (modes[_i].shape == MPM_HAT); gimp++)
        for (int supports = 0; supports < 3; supports++)
            for (int n = 0; n < 3; n++) {
                const BarTheory bar = bar_with(supports, 25);
                const BarMesh mesh = mesh_with(gimp ? MPM_GIMP : modes[_i].shape, 2, MPM_USF, modes[_i].apic);
                const StepMode mode = step_mode(&bar, &mesh, numbers[n]);
                const double decay = modes[_i].of[supports].decay[n];
                ck_assert(mode.known && mode.with_ends);
                ck_assert_double_eq_tol(mode.frequency, modes[_i].of[supports].frequency[n], 5.01e-10);
                /* as printed: two digits at most, one of 2, 3 */
                ck_assert_double_eq_tol(mode.decay, decay, decay > 0 ? 0.17 * decay : 1e-15);
                ck_assert_int_eq(mode.overlap < 0.995, modes[_i].of[supports].mixture[n]);
                ck_assert_double_le(mode.overlap, 1 + 1e-12);
            }
}
END_TEST

START_TEST(waves_that_share_a_frequency)
{
    /* P = 1: F K is the same for theta and pi - theta, and the sampled mode is one vector of the two */
    const BarTheory bar = bar_with(FREE_FIXED, 25);
    const BarMesh mesh = mesh_with(MPM_HAT, 1, MPM_USF, false);
    for (int number = 1; number <= 25; number++)
        ck_assert_double_eq_tol(step_mode(&bar, &mesh, number).overlap, 1, 1e-9);
}
END_TEST

/* 13 cells as in a class: the endless mesh says 4.5478. */
START_TEST(thirteen_cells)
{
    const BarTheory bar = bar_with(FIXED_FIXED, 13);
    const BarMesh mesh = mesh_with(MPM_BSPLINE2, 2, MPM_USF, false);
    ck_assert_double_eq_tol(step_mode(&bar, &mesh, 2).frequency, 4.5734, 5.01e-5);
    ck_assert_double_eq_tol(dispersion_of_bar(&bar, &mesh, bar_wave_number(&bar, 2)).frequency, 4.5478,
                            5.01e-5);
}
END_TEST

/* Far ends matter little, a held end of cubic splines more. */
START_TEST(long_bars)
{
    static const struct {
        MpmShape shape;
        int supports, number;
        double error, tolerance; /* endless formula over this, less 1 */
    } rows[] = {{MPM_HAT, FIXED_FREE, 1, 0, 1e-11},
                {MPM_BSPLINE2, FIXED_FREE, 5, -1.08e-8, 1e-10},
                {MPM_BSPLINE2, FIXED_FIXED, 5, -2.85e-8, 1e-10},
                {MPM_BSPLINE3, FIXED_FREE, 1, 1.2e-5, 5e-7},
                {MPM_BSPLINE3, FIXED_FIXED, 1, 2.5e-5, 6e-7}};
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        const BarTheory bar = bar_with(rows[i].supports, 1000);
        const BarMesh mesh = mesh_with(rows[i].shape, 2, MPM_USF, false);
        const double endless =
            dispersion_of_bar(&bar, &mesh, bar_wave_number(&bar, rows[i].number)).frequency;
        const StepMode mode = step_mode(&bar, &mesh, rows[i].number);
        ck_assert(mode.known && mode.with_ends);
        ck_assert_double_eq_tol(endless / mode.frequency - 1, rows[i].error, rows[i].tolerance);
    }
    const BarTheory longer = bar_with(FIXED_FREE, 2001), free = bar_with(FREE_FREE, 2001);
    const BarMesh quadratic = mesh_with(MPM_BSPLINE2, 2, MPM_USF, false),
                  cubic = mesh_with(MPM_BSPLINE3, 2, MPM_USF, false);
    ck_assert(step_mode(&longer, &quadratic, 1).known && !step_mode(&longer, &quadratic, 1).with_ends);
    ck_assert(step_mode(&longer, &cubic, 1).with_ends && !step_mode(&free, &cubic, 1).with_ends);
}
END_TEST

START_TEST(modes_that_do_not_swing)
{
    BarTheory bar = bar_with(FREE_FREE, 25);
    BarMesh mesh = mesh_with(MPM_BSPLINE2, 2, MPM_USF, true);
    ck_assert_double_eq(step_mode(&bar, &mesh, 0).frequency, 0); /* drifts */
    ck_assert(!step_mode(&bar, &mesh, 26).known);                /* shorter than two cells */
    mesh.apic = false, mesh.flip_fraction = 0, mesh.dt = 0.001;
    const StepMode creeping = step_mode(&bar, &mesh, 10); /* much PIC */
    ck_assert(creeping.known);
    ck_assert_double_eq(creeping.frequency, 0);
    ck_assert_double_gt(creeping.decay, 1);
    mesh.dt = 1;
    ck_assert(!step_mode(&bar, &mesh, 10).known); /* too large a step */
}
END_TEST

/* --- modes in runs: projected on the left eigenvector, which mixtures do not disturb ---------------- */

static double band_entry(const BarRest *rest, const double *band, int i, int j)
{
    const int d = abs(i - j), row = i > j ? i : j;
    return d > rest->reach ? 0 : band[row * (rest->reach + 1) + d];
}

/* The transposed map of (v, f) as science writes it, with G, W, K multiplied out. */
static gsl_matrix *transposed_step(const BarRest *rest, const BarMesh *mesh)
{
    const size_t n = (size_t)rest->nodes;
    const double dt = mesh->dt * 10, alpha = mesh->apic ? 0 : mesh->flip_fraction;
    gsl_matrix *g = gsl_matrix_alloc(n, n), *w = gsl_matrix_alloc(n, n), *k = gsl_matrix_alloc(n, n);
    gsl_matrix *product = gsl_matrix_calloc(n, n), *map = gsl_matrix_calloc(2 * n, 2 * n);
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            const double back = band_entry(rest, rest->consistent, (int)i, (int)j) / rest->mass[i];
            gsl_matrix_set(g, i, j, (i == j ? alpha : 0) + (1 - alpha) * back);
            gsl_matrix_set(w, i, j, back / rest->mass[j]);
            gsl_matrix_set(k, i, j, band_entry(rest, rest->stiffness, (int)i, (int)j));
        }
    double lower[2][64][64] = {{{0}}};
    ck_assert_uint_le(n, 64);
    if (mesh->algorithm == MPM_USF)
        gsl_blas_dgemm(CblasNoTrans, CblasNoTrans, 1, w, k, 0, product);
    for (int which = 0; which < 2 && mesh->algorithm == MPM_MUSL; which++) {
        gsl_blas_dgemm(CblasNoTrans, CblasNoTrans, 1, k, which ? w : g, 0, product);
        for (size_t i = 0; i < n; i++)
            for (size_t j = 0; j < n; j++)
                lower[which][i][j] = gsl_matrix_get(product, i, j);
    }
    for (size_t i = 0; i < n; i++)
        for (size_t j = 0; j < n; j++) {
            const double one = i == j, stiff = gsl_matrix_get(k, i, j);
            double of_v = gsl_matrix_get(g, i, j), f_of_v = stiff, f_of_f = one;
            if (mesh->algorithm == MPM_USF)
                of_v -= dt * dt * gsl_matrix_get(product, i, j);
            else if (mesh->algorithm == MPM_USL)
                f_of_f -= dt * dt * stiff / rest->mass[j];
            else
                f_of_v = lower[0][i][j], f_of_f -= dt * dt * lower[1][i][j];
            gsl_matrix_set(map, j, i, of_v);
            gsl_matrix_set(map, n + j, i, dt * gsl_matrix_get(w, i, j));
            gsl_matrix_set(map, j, n + i, -dt * f_of_v);
            gsl_matrix_set(map, n + j, n + i, f_of_f);
        }
    gsl_matrix_free(g);
    gsl_matrix_free(w);
    gsl_matrix_free(k);
    gsl_matrix_free(product);
    return map;
}

/* The eigenvector of the transposed map whose eigenvalue is next to this one. */
static void find_left(const BarRest *rest, const BarMesh *mesh, double complex eigenvalue,
                      double complex *left)
{
    gsl_matrix *map = transposed_step(rest, mesh);
    const size_t n = map->size1;
    gsl_vector_complex *values = gsl_vector_complex_alloc(n);
    gsl_matrix_complex *vectors = gsl_matrix_complex_alloc(n, n);
    gsl_eigen_nonsymmv_workspace *work = gsl_eigen_nonsymmv_alloc(n);
    gsl_eigen_nonsymmv(map, values, vectors, work);
    double nearest = INFINITY;
    for (size_t k = 0; k < n; k++) {
        const gsl_complex value = gsl_vector_complex_get(values, k);
        const double distance = cabs(GSL_REAL(value) + I * GSL_IMAG(value) - eigenvalue);
        if (distance >= nearest)
            continue;
        nearest = distance;
        for (size_t i = 0; i < n; i++) {
            const gsl_complex number = gsl_matrix_complex_get(vectors, i, k);
            left[i] = GSL_REAL(number) + I * GSL_IMAG(number);
        }
    }
    ck_assert_double_lt(nearest, 1e-10);
    gsl_eigen_nonsymmv_free(work);
    gsl_matrix_complex_free(vectors);
    gsl_vector_complex_free(values);
    gsl_matrix_free(map);
}

/* v and f of the particles as they are now, with the weights of the bar at rest, on the left vector. */
static double complex projection(const BarRest *rest, Simulation *sim, bool apic, const double complex *left)
{
    double *v = field_now(sim, 0, "v"), *stress = field_now(sim, 0, "stress");
    double *affine = field_now(sim, 0, "affine");
    double complex sum = 0;
    for (int cell = 0; cell < rest->cells; cell++)
        for (int j = 0; j < rest->per_cell; j++) {
            double n[REST_SUPPORT_MAX], slope[REST_SUPPORT_MAX], arm[REST_SUPPORT_MAX];
            bar_rest_weights(rest, cell, j, n, slope, arm);
            const double mass = cell < rest->joint ? 1 : rest->density_beyond;
            const int p = cell * rest->per_cell + j, first = cell + rest->origin - rest->first_node;
            for (int a = 0; a <= rest->degree; a++) {
                const int i = first + a;
                if (i < 0 || i >= rest->nodes)
                    continue;
                const double speed = v[p] + (apic ? affine[p] * arm[a] : 0);
                sum += left[i] * mass * n[a] * speed / rest->per_cell / rest->mass[i];
                /* in the units of bar_rest.h, where E = 100 is 1 and c = 10 is 1 */
                sum -= left[rest->nodes + i] * slope[a] * (stress[p] / 10) / rest->per_cell;
            }
        }
    free(v);
    free(stress);
    free(affine);
    return sum;
}

static void expect_run(const BarTheory *bar, const BarMesh *mesh, int number, double tolerance)
{
    const StepMode mode = step_mode(bar, mesh, number);
    ck_assert(mode.known);
    /* as long as it is not lost among rounding errors */
    const int steps = (int)fmin(300, 2 / fmax(mode.decay, 1e-3) / mesh->dt);
    BarRest rest;
    ck_assert(bar_rest_make(&rest, bar, mesh, (int)bar->length));
    double complex left[128];
    find_left(&rest, mesh, cexp((I * mode.frequency - mode.decay) * mesh->dt), left);

    /* the slower of two materials is strained more; beside the middle the weights change with a particle's
     * place in the first order, and the error with the velocity: cubics 7.2e-9, 3.6e-9, 7.2e-10 with 1e-7,
     * 5e-8, 1e-8 */
    const double velocity = bar_is_layered(bar) ? 1e-9 : mesh->offset != 0 ? 1e-8 : 1e-7;
    const BarCase which = case_of(bar, mesh, number, velocity);
    Simulation *sim = bar_case_create(&which);
    const double complex start = projection(&rest, sim, mesh->apic, left);
    double complex before = start;
    double turned = 0;
    for (int k = 0; k < steps; k++) {
        advance(sim, 1);
        const double complex now = projection(&rest, sim, mesh->apic, left);
        turned += carg(now / before);
        before = now;
    }
    const double span = steps * mesh->dt, frequency = turned / span,
                 decay = -log(cabs(before / start)) / span;
    ck_assert_msg(fabs(frequency - mode.frequency) <= tolerance * mode.frequency &&
                      fabs(decay - mode.decay) <= tolerance * mode.frequency,
                  "shape %d, algorithm %d, apic %d, n = %d: %.12f %.12f instead of %.12f %.12f", mesh->shape,
                  mesh->algorithm, mesh->apic, number, frequency, decay, mode.frequency, mode.decay);
    simulation_destroy(sim);
    bar_rest_free(&rest);
}

START_TEST(modes_in_runs)
{
    for (int supports = 0; supports < SUPPORTS; supports++)
        for (int algorithm = 0; algorithm < 3; algorithm++)
            for (int transfer = 0; transfer < 3; transfer++)
                for (int n = 0; n < 3; n++) {
                    if (!suite_wide() && (supports + algorithm + transfer + n + _i) % 3 != 0)
                        continue;
                    const BarTheory bar = bar_with(supports, 25);
                    BarMesh mesh = mesh_with((MpmShape)_i, 2, (MpmAlgorithm)algorithm, transfer == 1);
                    mesh.flip_fraction = transfer == 2 ? 0.95 : 1;
                    expect_run(&bar, &mesh, numbers[n], _i == MPM_GIMP ? 1e-8 : 2e-9);
                }
}
END_TEST

START_TEST(modes_in_runs_beside_the_middle)
{
    static const MpmShape shapes[] = {MPM_HAT, MPM_BSPLINE2, MPM_BSPLINE3};
    for (int supports = 0; supports < SUPPORTS; supports++)
        for (int n = 0; n < 3; n++) {
            const BarTheory bar = bar_with(supports, 25);
            BarMesh mesh =
                mesh_with(shapes[_i], _i == 0 ? 1 + n : 2, supports % 2 ? MPM_USF : MPM_MUSL, n == 1);
            mesh.offset = n == 0 ? 0.3 : -0.25;
            expect_run(&bar, &mesh, numbers[n], 2e-9);
            ck_assert(!dispersion_predicts_centre_velocity(&bar, &mesh));
        }
}
END_TEST

/* Each particle with its own E and m; the wave in the slower half is too short for the tenth mode. */
START_TEST(modes_of_two_materials_in_runs)
{
    for (int supports = 0; supports < SUPPORTS; supports++)
        for (int second = 1; second < 3; second++)
            for (int transfer = 0; transfer < 3; transfer++)
                for (int n = 0; n < 2; n++) {
                    if (!suite_wide() && (supports + second + transfer + n + _i) % 2 != 0)
                        continue;
                    const BarTheory bar = joined(bar_with(supports, 25), second);
                    BarMesh mesh = mesh_with((MpmShape)_i, 2, transfer ? MPM_MUSL : MPM_USF, transfer == 1);
                    mesh.dt = 0.005;
                    mesh.flip_fraction = transfer == 2 ? 0.95 : 1;
                    expect_run(&bar, &mesh, numbers[n], _i == MPM_GIMP ? 1e-8 : 2e-9);
                }
}
END_TEST

/* Finer meshes come to the exact frequencies of two materials, to second order; equal halves are one bar; of
 * very many cells nothing is known. */
START_TEST(two_materials_converge)
{
    double errors[2][3];
    for (int fine = 0; fine < 2; fine++)
        for (int n = 1; n <= 3; n++) {
            const BarTheory bar = joined(bar_with(FIXED_FREE, 25), 1);
            BarMesh mesh = mesh_with(MPM_HAT, 2, MPM_USF, false);
            mesh.cell_size = fine ? 0.05 : 0.1, mesh.dt = mesh.cell_size / 100;
            const StepMode mode = step_mode(&bar, &mesh, n);
            ck_assert(mode.known && mode.overlap > 0.9999);
            errors[fine][n - 1] = mode.frequency / bar_frequency(&bar, n) - 1;
            ck_assert_double_lt(fabs(errors[fine][n - 1]), 1e-3);
        }
    for (int n = 0; n < 3; n++)
        ck_assert_double_eq_tol(errors[0][n] / errors[1][n], 4, 0.1);

    BarTheory equal = bar_with(FIXED_FREE, 25);
    const BarMesh mesh = mesh_with(MPM_HAT, 2, MPM_USF, false);
    const StepMode one = step_mode(&equal, &mesh, 5);
    equal.joint = 10, equal.joint_modulus = 100, equal.joint_density = 1, equal.of_sines = true;
    const StepMode joint = step_mode(&equal, &mesh, 5);
    ck_assert_double_eq(joint.frequency, one.frequency);
    ck_assert_double_eq(joint.overlap, one.overlap);
    const double limit = step_limit(&equal, &mesh);
    equal.joint = 0;
    ck_assert_double_eq(step_limit(&equal, &mesh), limit);

    BarTheory of_sines = joined(bar_with(FIXED_FREE, 25), 1);
    const StepMode exact = step_mode(&of_sines, &mesh, 2);
    of_sines.of_sines = true;
    const StepMode sine = step_mode(&of_sines, &mesh, 2);
    ck_assert_double_eq(sine.frequency, exact.frequency);
    /* .86567 of the mode are in the sine (check_exact_bar), by their masses */
    ck_assert(exact.overlap > 0.999 && sine.overlap < 0.95 && sine.overlap > 0.5);
    of_sines.length = 30000;
    ck_assert(!step_mode(&of_sines, &mesh, 1).known);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *limit = tcase_create("limit");
    tcase_add_loop_test(limit, limits_of_bars, 0, (int)(sizeof limits / sizeof *limits));
    tcase_add_test(limit, limits_of_padding_and_blend);
    tcase_add_test(limit, limits_of_long_bars);
    tcase_add_loop_test(limit, limits_hold_in_runs, 0, 7);
    tcase_add_test(limit, limits_of_long_bars_of_two);
    tcase_add_loop_test(limit, limits_hold_beside_the_middle, 0, 4);
    suite_add_tcase(suite, limit);

    TCase *mode = tcase_create("mode");
    tcase_add_loop_test(mode, modes_in_runs_beside_the_middle, 0, 3);
    tcase_add_loop_test(mode, modes_with_ends, 0, (int)(sizeof modes / sizeof *modes));
    tcase_add_test(mode, waves_that_share_a_frequency);
    tcase_add_test(mode, thirteen_cells);
    tcase_add_test(mode, long_bars);
    tcase_add_test(mode, modes_that_do_not_swing);
    tcase_add_loop_test(mode, modes_in_runs, 0, 4);
    tcase_add_loop_test(mode, modes_of_two_materials_in_runs, 0, 4);
    tcase_add_test(mode, two_materials_converge);
    suite_add_tcase(suite, mode);
}
