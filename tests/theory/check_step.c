/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What one step does to a bar at rest on its mesh: how large it may be, and how a mode goes on. The tables
 * are those of an independent program, and the engine has the last word. */
#include "methods/bar_case.h"
#include "suite.h"
#include "theory/elastic_bar.h"

#include <float.h>
#include <math.h>

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
                     .algorithm = algorithm,
                     .shape = shape,
                     .apic = apic,
                     .flip_fraction = 1,
                     .dt = 0.01};
}

/* The greater of both materials' wave speeds. */
static double fastest_speed(const BarTheory *bar)
{
    return fmax(bar_wave_speed(bar), bar->joint > 0 ? sqrt(bar->joint_modulus / bar->joint_density) : 0);
}

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
    which.def.padding = 4;
    which.def.algorithm = algorithms[mesh->algorithm];
    which.def.shape = shapes[mesh->shape];
    which.def.transfer = mesh->apic ? MPM_APIC : MPM_FLIP;
    which.def.flip_fraction = mesh->flip_fraction;
    which.def.courant = mesh->dt * fastest_speed(bar);
    which.def.joint = bar->joint;
    which.def.joint_modulus = bar->joint_modulus, which.def.joint_density = bar->joint_density;
    return which;
}

static double limit_of(const BarTheory *bar, const BarMesh *mesh)
{
    const BarCase which = case_of(bar, mesh, 1, 0);
    return bar_case_limit(&which);
}

/* What the step makes of a mode. */
static StepMode mode_of(const BarTheory *bar, const BarMesh *mesh, int number)
{
    const BarCase which = case_of(bar, mesh, number, 1e-3);
    StepModes *modes = bar_case_modes(&which);
    const StepMode mode = step_modes_largest(modes);
    step_modes_free(modes);
    return mode;
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
            const double limit = limit_of(&bar, &mesh);
            ck_assert_msg(fabs(limit - expected) <= printed, "shape %d, P = %d, %d, %d, %d: %.6f not %.4f",
                          shape, limits[row].per_cell, algorithms[a], apic, supports, limit, expected);
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
            mesh.flip_fraction = rows[i].flip_fraction;
            BarCase which = case_of(&bar, &mesh, 1, 0);
            which.def.padding = rows[i].padding;
            ck_assert_double_eq_tol(bar_case_limit(&which), usl ? rows[i].usl : rows[i].usf, 5.01e-4);
        }
}
END_TEST

/* A bar that cannot move has no limit. */
START_TEST(limit_of_a_held_bar)
{
    const BarTheory held = bar_with(FIXED_FIXED, 1);
    const BarMesh mesh = mesh_with(MPM_HAT, 2, MPM_USF, false);
    ck_assert(isinf(limit_of(&held, &mesh)));
}
END_TEST

/* --- runs ----------------------------------------------------------------------------------------- */

/* Whether 4000 steps keep the energy of a mode so small that the particles stay where they are. */
static bool run_keeps(const BarTheory *bar, BarMesh mesh, double courant)
{
    mesh.dt = courant / fastest_speed(bar);
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
        const double limit = limit_of(&of_two, &mesh);
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
    BarMesh mesh = mesh_with(_i == 4  ? MPM_GIMP
                             : _i % 2 ? MPM_BSPLINE2
                                      : MPM_HAT,
                             1 + _i % 4 / 2, MPM_USF, false);
    const double middle = limit_of(&bar, &mesh);
    mesh.offset = -0.4;
    const double limit = limit_of(&bar, &mesh);
    if (_i == 0)
        ck_assert_double_lt(limit, 2.0 / 3 * middle);
    ck_assert(run_keeps(&bar, mesh, 0.995 * limit));
    ck_assert(!run_keeps(&bar, mesh, 1.01 * limit));
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
                const StepMode mode = mode_of(&bar, &mesh, numbers[n]);
                const double decay = modes[_i].of[supports].decay[n];
                ck_assert(mode.known);
                ck_assert_double_eq_tol(mode.frequency, modes[_i].of[supports].frequency[n], 5.01e-10);
                /* as printed: two digits at most, one of 2, 3; 0 to the rounding of |lambda| = 1 */
                ck_assert_double_eq_tol(mode.decay, decay,
                                        decay > 0 ? 0.17 * decay : DBL_EPSILON / (2 * mesh.dt));
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
        ck_assert_double_eq_tol(mode_of(&bar, &mesh, number).overlap, 1, 1e-9);
}
END_TEST

/* 13 cells as in a class: the endless mesh says 4.5478. */
START_TEST(thirteen_cells)
{
    const BarTheory bar = bar_with(FIXED_FIXED, 13);
    const BarMesh mesh = mesh_with(MPM_BSPLINE2, 2, MPM_USF, false);
    ck_assert_double_eq_tol(mode_of(&bar, &mesh, 2).frequency, 4.5734, 5.01e-5);
    ck_assert_double_eq_tol(dispersion_of_bar(&bar, &mesh, bar_wave_number(&bar, 2)).frequency, 4.5478,
                            5.01e-5);
}
END_TEST

/* Far ends matter little, a held end of cubic splines more: the space of the start does not close there, and
 * the mode has settled before. */
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
        const StepMode mode = mode_of(&bar, &mesh, rows[i].number);
        ck_assert(mode.known);
        ck_assert_double_eq_tol(endless / mode.frequency - 1, rows[i].error, rows[i].tolerance);
    }
}
END_TEST

/* uGIMP beside the middle, mode 8 of 25 cells: exact frequencies of a map of (v, stress) of another program,
 * per cent below the continuum's. */
START_TEST(boxes_beside_the_middle)
{
    static const double offsets[] = {0, 0.1, 0.2, 0.3, 0.4},
                        errors[] = {-11.39, -13.29, -14.83, -16.05, -16.95};
    for (int i = 0; i < 5; i++) {
        const BarTheory bar = bar_with(FIXED_FREE, 25);
        BarMesh mesh = mesh_with(MPM_GIMP, 2, MPM_USF, false);
        mesh.offset = offsets[i];
        const StepMode mode = mode_of(&bar, &mesh, 8);
        ck_assert(mode.known);
        ck_assert_double_eq_tol(100 * (mode.frequency / bar_frequency(&bar, 8) - 1), errors[i], 5.01e-3);
    }
}
END_TEST

START_TEST(modes_that_do_not_oscillate)
{
    BarTheory bar = bar_with(FREE_FREE, 25);
    BarMesh mesh = mesh_with(MPM_BSPLINE2, 2, MPM_USF, true);
    mesh.apic = false, mesh.flip_fraction = 0, mesh.dt = 0.001;
    const StepMode creeping = mode_of(&bar, &mesh, 10); /* much PIC */
    ck_assert(creeping.known);
    ck_assert_double_eq(creeping.frequency, 0);
    ck_assert_double_gt(creeping.decay, 1);
    mesh.dt = 1;
    ck_assert(!mode_of(&bar, &mesh, 10).known); /* too large a step */
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *limit = tcase_create("limit");
    tcase_add_loop_test(limit, limits_of_bars, 0, (int)(sizeof limits / sizeof *limits));
    tcase_add_test(limit, limits_of_padding_and_blend);
    tcase_add_test(limit, limit_of_a_held_bar);
    tcase_add_loop_test(limit, limits_hold_in_runs, 0, 7);
    tcase_add_loop_test(limit, limits_hold_beside_the_middle, 0, 5);
    suite_add_tcase(suite, limit);

    TCase *mode = tcase_create("mode");
    tcase_add_test(mode, boxes_beside_the_middle);
    tcase_add_loop_test(mode, modes_with_ends, 0, (int)(sizeof modes / sizeof *modes));
    tcase_add_test(mode, waves_that_share_a_frequency);
    tcase_add_test(mode, thirteen_cells);
    tcase_add_test(mode, long_bars);
    tcase_add_test(mode, modes_that_do_not_oscillate);
    suite_add_tcase(suite, mode);
}
