/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the step of a bar's lattice predicts against its runs, its waves, and what counts eigenvalues against
 * a dense solver. */
#include "answers/step_modes.h"
#include "base/linear.h"
#include "methods/bonds/plane/bonds_plane.h"
#include "suite.h"
#include "theory/elastic_bar.h"
#include "theory/frequency.h"
#include "theory/pd_waves.h"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_sort_vector.h>
#include <math.h>
#include <stdlib.h>

static BarTheory theory(bool left, bool right, int mode)
{
    return (BarTheory){.length = 25,
                       .youngs_modulus = 100,
                       .density = 1,
                       .left_fixed = left,
                       .right_fixed = right,
                       .n_modes = 1,
                       .modes = {{mode, 0.1}}};
}

/* Of the bars of theory() once on_bar() has given it ends. */
static BeamDef lattice(double spacing, double horizon, VolumeCorrection volumes, bool energy, double dt)
{
    return (BeamDef){.problem = BEAM_BAR,
                     .length = 25,
                     .youngs_modulus = 100,
                     .density = 1,
                     .spacing = spacing,
                     .horizon = horizon,
                     .volume_correction = volumes,
                     .surface_correction = energy ? SURFACE_ENERGY : SURFACE_NONE,
                     .dt = dt};
}

static BeamDef on_bar(const BarTheory *bar, const BeamDef *on)
{
    BeamDef def = *on;
    def.left_fixed = bar->left_fixed, def.right_fixed = bar->right_fixed;
    return def;
}

static double velocity(double x, const void *context)
{
    return bar_initial_velocity(context, x);
}

static Simulation *lattice_bar(const BarTheory *bar, const BeamDef *on)
{
    BeamDef def = on_bar(bar, on);
    def.initial_velocity = velocity;
    def.initial_context = bar;
    Status status = {0};
    Simulation *sim = beam_create(&def, &status);
    ck_assert_msg(sim != NULL, "%s", status.text);
    return sim;
}

static StepModes *motion(const BarTheory *bar, const BeamDef *on, bool whole)
{
    Simulation *sim = lattice_bar(bar, on);
    StepModes *modes = step_modes_create(sim, whole, (Cancel){0});
    ck_assert_ptr_nonnull(modes);
    simulation_destroy(sim);
    return modes;
}

/* Of the bar's first mode. */
static double frequency(const BarTheory *bar, const BeamDef *on)
{
    StepModes *modes = motion(bar, on, false);
    const StepMode mode = step_modes_largest(modes);
    step_modes_free(modes);
    return mode.known ? mode.frequency : NAN;
}

static double in_steps(double omega, double dt)
{
    return 2 * asin(omega * dt / 2) / dt;
}

/* The frequency of a node's velocity by least squares over 2000 steps. */
static double measured(const BarTheory *bar, const BeamDef *on, double start)
{
    enum { STEPS = 2000 };
    static double record[STEPS];
    Simulation *sim = lattice_bar(bar, on);
    const int field = simulation_find_field(sim, 0, "v");
    for (int k = 0; k < STEPS; k++) {
        sim->method->field(sim, field, 3, 1, &record[k]);
        ck_assert(simulation_steps(sim, 1, NULL, NULL, NULL));
    }
    simulation_destroy(sim);
    FrequencyFit fit;
    Status status = {0};
    ck_assert_msg(frequency_fit(record, STEPS, 0, on->dt, start, &fit, &status), "%s", status.text);
    return fit.frequency;
}

/* Between two fixed ends a sine is an exact mode of the lattice. */
START_TEST(fixed_ends)
{
    static const int modes[] = {1, 2, 5, 10, 20};
    static const double horizons[] = {0.5, 1, 1.5, 2, 1.4};
    for (int m = 0; m < 5; m++)
        for (int h = 0; h < 5; h++)
            for (int flags = 0; flags < 6; flags++) {
                const VolumeCorrection volumes = (VolumeCorrection)(flags / 2);
                const bool energy = flags % 2;
                const BarTheory bar = theory(true, true, modes[m]);
                const BeamDef on = lattice(0.5, horizons[h], volumes, energy, 0.01);
                const double predicted = frequency(&bar, &on);
                ck_assert_double_eq_tol(measured(&bar, &on, predicted) / predicted, 1, 1e-9);
            }
}
END_TEST

/* v_cm of the run at every step, to the rounding of what it starts with. */
static double furthest(const BarTheory *bar, const BeamDef *on, int steps)
{
    Simulation *sim = lattice_bar(bar, on);
    StepModes *modes = motion(bar, on, true);
    ck_assert(step_modes_are_whole(modes));
    const int v_cm = simulation_find_series(sim, "v_cm");
    double row[16], most = 0;
    for (int k = 0; k <= steps; k++) {
        simulation_row(sim, row);
        most = fmax(most, fabs(row[v_cm] - step_modes_v_cm(modes, k)));
        ck_assert(simulation_steps(sim, 1, NULL, NULL, NULL));
    }
    step_modes_free(modes);
    simulation_destroy(sim);
    return most / 0.1;
}

START_TEST(centre_of_mass)
{
    for (int ends = 0; ends < 4; ends++)
        for (int energy = 0; energy < 2; energy++) {
            BarTheory bar = theory(ends & 1, ends & 2, 5);
            bar.n_modes = 2;
            bar.modes[1].number = 3, bar.modes[1].velocity = 0.02;
            const BeamDef on = lattice(0.5, 1.5, VOLUME_PARTIAL, energy, 0.03);
            ck_assert_double_lt(furthest(&bar, &on, 3000), 1e-11);
        }
}
END_TEST

/* A cone: the engine runs as the lattice predicts, its sum gives E, and fine lattices disperse as the
 * integral says. */
START_TEST(a_cone_runs_as_predicted)
{
    for (int ends = 0; ends < 4; ends++) {
        BarTheory bar = theory(ends & 1, ends & 2, 5);
        BeamDef on = lattice(0.5, 1.5, VOLUME_PARTIAL, true, 0.03);
        on.influence = INFLUENCE_CONICAL;
        ck_assert_double_lt(furthest(&bar, &on, 1000), 1e-11);
        Simulation *sim = lattice_bar(&bar, &on);
        BeamFacts facts;
        beam_facts(sim, &facts);
        ck_assert_double_eq_tol(facts.modulus, 100, 1e-11);
        simulation_destroy(sim);
    }
    const BarTheory bar = theory(true, true, 1);
    BeamDef fine = lattice(0.01, 0.2, VOLUME_PARTIAL, false, 1e-6);
    fine.influence = INFLUENCE_CONICAL;
    for (double z = 0.5; z < 8; z += 0.5) {
        const double w = bonds_line_wave(&fine, z / 0.2), c = bar_wave_speed(&bar);
        ck_assert_double_eq_tol(pow(w / (c * z / 0.2), 2), pd_waves_line(INFLUENCE_CONICAL, z), 4e-3);
    }
    /* as the help has it: the weights of the sum, and long waves */
    for (int volumes = VOLUME_NONE; volumes <= VOLUME_HHB; volumes++) {
        BeamDef on = lattice(0.5, 1.5, (VolumeCorrection)volumes, false, 1e-6);
        on.influence = INFLUENCE_CONICAL;
        const double theta = 0.3, ratio = 3, w[] = {1, 1, 0.5}, c = bar_wave_speed(&bar), beta = theta / 0.5;
        double sum = 0, all = 0;
        for (int m = 1; m <= 3; m++) {
            const double cone = (1 - m / ratio) * (volumes == VOLUME_NONE ? 1 : w[m - 1]);
            sum += cone / m * pow(sin(m * theta / 2), 2);
            all += cone * m;
        }
        sum *= 8 * pow(c / 1.5, 2) * ratio * ratio / (2 * all);
        const double omega = bonds_line_wave(&on, beta);
        ck_assert_double_eq_tol(omega, sqrt(sum), 1e-12 * omega);
        const double slow = beta / 100, falls = slow * slow * (1.5 * 1.5 - 2.0 / 3 * 0.5 * 0.5) / 80;
        ck_assert_double_eq_tol((1 - bonds_line_wave(&on, slow) / (slow * c)) / falls, 1, 1e-4);
    }
}
END_TEST

/* How far a free end moves the frequency, and that it does so less and less on finer lattices. Percent of the
 * continuum's, by a dense eigenvalue solver. */
START_TEST(free_end)
{
    static const struct {
        double spacing;
        bool energy;
        int mode;
        double ends, endless; /* omega/exact - 1, % */
    } cases[] = {
        {0.5, false, 1, -0.0217, -0.0206},  {0.5, false, 5, -1.7412, -1.6490},
        {0.5, false, 10, -7.5010, -7.0989}, {0.5, true, 1, -0.0134, -0.0206},
        {0.5, true, 5, -1.2158, -1.6490},   {0.5, true, 10, -6.2188, -7.0989},
        {0.25, true, 5, -0.3481, -0.4153},  {0.1, true, 5, -0.0620, -0.0666},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        const BarTheory bar = theory(true, false, cases[k].mode);
        const double exact = bar_frequency(&bar, cases[k].mode);
        /* so small a step that time adds nothing */
        const BeamDef on =
            lattice(cases[k].spacing, 3 * cases[k].spacing, VOLUME_PARTIAL, cases[k].energy, 1e-5);
        const double endless = in_steps(bonds_line_wave(&on, bar_wave_number(&bar, cases[k].mode)), on.dt);
        ck_assert_double_eq_tol(100 * (endless / exact - 1), cases[k].endless, 6e-5);
        ck_assert_double_eq_tol(100 * (frequency(&bar, &on) / exact - 1), cases[k].ends, 6e-5);
    }
}
END_TEST

/* The run starts in a sine, which is not a mode of the lattice with a free end: others oscillate along. What
 * the fit finds is near the eigenvalue, far nearer than the endless lattice. */
START_TEST(free_end_measured)
{
    const BarTheory bar = theory(true, false, 5);
    const BeamDef on = lattice(0.5, 1.5, VOLUME_PARTIAL, true, 0.01);
    const double predicted = frequency(&bar, &on), found = measured(&bar, &on, predicted);
    const double endless = in_steps(bonds_line_wave(&on, bar_wave_number(&bar, 5)), on.dt);
    ck_assert_double_lt(fabs(found / predicted - 1), 2e-4);
    ck_assert_double_gt(fabs(endless / predicted - 1), 4e-3);
}
END_TEST

START_TEST(long_waves)
{
    const double k = 1e-2;
    for (int reach = 1; reach <= 6; reach++) {
        const double h = 0.5, delta = reach * h;
        BeamDef on = lattice(h, delta, VOLUME_PARTIAL, false, 1e-6);
        const double lag = 1 - in_steps(bonds_line_wave(&on, k), on.dt) / (10 * k);
        ck_assert_double_eq_tol(lag / (k * k * (delta * delta + h * h) / 48), 1, 1e-3);
    }
    /* a reach of one is the chain of springs */
    const BeamDef on = lattice(0.5, 0.5, VOLUME_NONE, true, 1e-6);
    ck_assert_double_eq_tol(bonds_line_wave(&on, 2), 10 / 0.5 * 2 * sin(0.5), 1e-12);
}
END_TEST

/* 500 nodes with a free end: the space does not close, and the mode converges. Beyond the stable step only a
 * mode that is slow enough is predicted. */
START_TEST(large_or_unstable)
{
    BarTheory bar = theory(true, false, 1);
    BeamDef on = lattice(0.05, 0.15, VOLUME_PARTIAL, true, 1e-3);
    StepModes *modes = motion(&bar, &on, true);
    ck_assert(!step_modes_are_whole(modes));
    step_modes_free(modes);
    ck_assert_double_eq_tol(frequency(&bar, &on),
                            in_steps(bonds_line_wave(&on, bar_wave_number(&bar, 1)), on.dt), 1e-6);
    bar.right_fixed = true;
    on.dt = 0.09; /* lambda and 1/lambda of the mode, of which one decays */
    bar.modes[0].number = 20;
    ck_assert(isnan(frequency(&bar, &on)));
    on.dt = 1;
    bar.modes[0].number = 100;
    modes = motion(&bar, &on, true);
    ck_assert(!step_modes_are_whole(modes));
    step_modes_free(modes);
    ck_assert(isnan(frequency(&bar, &on)));
}
END_TEST

/* --- counting eigenvalues ------------------------------------------------------------------------- */

START_TEST(eigenvalues_of_a_band)
{
    enum { SIZE = 40, WIDTH = 4 };
    static double rows[SIZE * (WIDTH + 1)];
    gsl_matrix *matrix = gsl_matrix_calloc(SIZE, SIZE);
    gsl_vector *values = gsl_vector_alloc(SIZE);
    gsl_eigen_symm_workspace *work = gsl_eigen_symm_alloc(SIZE);
    for (size_t i = 0; i < SIZE; i++)
        for (size_t d = 0; d <= WIDTH && d <= i; d++) {
            const double value = d == 0 ? 0 : sin(1.0 + (double)(7 * i * i + 3 * d)) / (1 + (double)d);
            rows[i * (WIDTH + 1) + d] = value;
            gsl_matrix_set(matrix, i, i - d, value);
            gsl_matrix_set(matrix, i - d, i, value);
        }
    ck_assert_int_eq(gsl_eigen_symm(matrix, values, work), 0);
    gsl_sort_vector(values);
    const Band band = {SIZE, WIDTH, rows};
    for (size_t k = 0; k < SIZE; k++)
        ck_assert_double_eq_tol(band_eigenvalue(&band, k, &(Cancel){0}), gsl_vector_get(values, k), 1e-13);
    gsl_eigen_symm_free(work);
    gsl_vector_free(values);
    gsl_matrix_free(matrix);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("pd_bar");
    tcase_add_test(tcase, fixed_ends);
    tcase_add_test(tcase, centre_of_mass);
    tcase_add_test(tcase, a_cone_runs_as_predicted);
    tcase_add_test(tcase, free_end);
    tcase_add_test(tcase, free_end_measured);
    tcase_add_test(tcase, long_waves);
    tcase_add_test(tcase, large_or_unstable);
    tcase_add_test(tcase, eigenvalues_of_a_band);
    suite_add_tcase(suite, tcase);
}
