/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the mesh makes of a wave: frequencies, decay, stability limits, v_cm. */
#include "suite.h"
#include "theory/elastic_bar.h"

#include <math.h>

static const BarTheory paper = {
    .length = 25, .youngs_modulus = 100, .density = 1, .left_fixed = true, .n_modes = 1, .modes = {{1, 0.1}}};

static BarMesh paper_mesh(void)
{
    return (BarMesh){.cell_size = 1, .particles_per_cell = 2, .flip_fraction = 1, .dt = 0.01};
}

static Dispersion mode_on(const BarMesh *mesh, int number)
{
    return dispersion_of_bar(&paper, mesh, bar_wave_number(&paper, number));
}

static const int numbers[3] = {1, 5, 10};

START_TEST(predicted_frequencies)
{
    const double expected[3] = {0.6279837381, 5.4151680880, 9.8238325197};
    BarMesh mesh = paper_mesh();
    for (int i = 0; i < 3; i++) {
        Dispersion wave = mode_on(&mesh, numbers[i]);
        ck_assert(wave.known);
        ck_assert_double_eq_tol(wave.frequency, expected[i], 5e-11);
        ck_assert_double_eq(wave.decay, 0);
    }
}
END_TEST

/* The predicted column of the error table, in percent, as it is printed. */
START_TEST(error_table)
{
    static const struct {
        double cell, courant;
        int per_cell;
        double errors[3];
    } rows[] = {{1, 0.1, 2, {-0.053, -4.239, -17.710}},  {0.5, 0.1, 2, {-0.013, -1.074, -4.713}},
                {1, 0.05, 2, {-0.053, -4.248, -17.735}}, {1, 0.1, 1, {-0.066, -5.234, -22.088}},
                {1, 0.1, 4, {-0.050, -3.992, -16.651}},  {1, 0.1, 6, {-0.050, -3.946, -16.456}}};
    for (size_t row = 0; row < sizeof rows / sizeof *rows; row++)
        for (int i = 0; i < 3; i++) {
            BarMesh mesh = paper_mesh();
            mesh.cell_size = rows[row].cell;
            mesh.particles_per_cell = rows[row].per_cell;
            mesh.dt = rows[row].courant * mesh.cell_size / 10;
            double exact = bar_frequency(&paper, numbers[i]);
            double error = 100 * (mode_on(&mesh, numbers[i]).frequency / exact - 1);
            ck_assert_double_eq_tol(error, rows[row].errors[i], 5.001e-4);
        }
}
END_TEST

/* Lumped finite elements alone, as with APIC whose filter is 1. */
START_TEST(without_the_filter)
{
    BarMesh mesh = paper_mesh();
    mesh.apic = true, mesh.dt = 1e-6;
    const double errors[3] = {-0.016, -1.3, -5.8};
    for (int i = 1; i < 3; i++) {
        Dispersion wave = mode_on(&mesh, numbers[i]);
        ck_assert_double_eq(wave.filter, 1);
        ck_assert_double_eq_tol(100 * (wave.frequency / bar_frequency(&paper, numbers[i]) - 1), errors[i],
                                0.05);
    }
}
END_TEST

START_TEST(small_steps_leave_the_mesh_alone)
{
    BarMesh mesh = paper_mesh();
    for (int shape = MPM_HAT; shape <= MPM_BSPLINE2; shape++) {
        mesh.shape = (MpmShape)shape, mesh.dt = 1e-6;
        Dispersion wave = mode_on(&mesh, 10);
        ck_assert_double_eq_tol(wave.frequency, wave.space_only, 1e-8);
        /* a long wave knows nothing of the mesh, and the error falls as the square of the cell */
        double errors[2];
        for (int i = 0; i < 2; i++) {
            mesh.cell_size = i ? 0.05 : 0.1;
            errors[i] = mode_on(&mesh, 1).space_only / bar_frequency(&paper, 1) - 1;
        }
        ck_assert_double_lt(fabs(errors[0]), 1e-4);
        if (shape != MPM_BSPLINE2)
            ck_assert_double_eq_tol(errors[0] / errors[1], 4, 0.01);
        mesh.cell_size = 1;
    }
}
END_TEST

/* Decay against the definition, by the product of the eigenvalues of the step. */
START_TEST(decay_rates)
{
    BarMesh mesh = paper_mesh();
    mesh.algorithm = MPM_USL;
    double left[3]; /* of the part of the energy that the grid sees, at t = 100 */
    for (int i = 0; i < 3; i++) {
        Dispersion wave = mode_on(&mesh, numbers[i]);
        double theta = bar_wave_number(&paper, numbers[i]), s2 = pow(sin(theta / 2), 2);
        double w2dt2 = 4 * s2 * 0.01;
        ck_assert_double_eq_tol(wave.filter, 1 - 0.375 * (1 - cos(theta)), 1e-15);
        ck_assert_double_eq_tol(wave.decay, -log(1 - w2dt2 * (1 - wave.filter)) / 0.02, 1e-12);
        left[i] = exp(-2 * wave.decay * 100);
    }
    ck_assert_double_eq_tol(left[0], 0.9998, 3e-4);
    ck_assert_double_gt(left[1], 0.1);
    ck_assert_double_lt(left[1], 0.207); /* what a run keeps beside it is hidden */
    ck_assert_double_lt(left[2], 0.012);
    /* the loss is proportional to the step */
    mesh.dt = 0.005;
    double half = mode_on(&mesh, 5).decay;
    mesh.dt = 0.01;
    ck_assert_double_eq_tol(mode_on(&mesh, 5).decay / half, 2, 0.01);
}
END_TEST

START_TEST(blend_damps_per_step)
{
    BarMesh mesh = paper_mesh();
    mesh.flip_fraction = 0.9;
    Dispersion wave = mode_on(&mesh, 5);
    ck_assert(wave.known);
    double kept = 0.9 + 0.1 * wave.filter;
    ck_assert_double_eq_tol(wave.decay, -log(kept) / 0.02, 1e-12);
    mesh.dt = 0.005; /* halving the step makes it worse */
    ck_assert_double_eq_tol(mode_on(&mesh, 5).decay / wave.decay, 2, 1e-9);
    /* with much PIC a short wave does not oscillate at all, it creeps back */
    mesh.flip_fraction = 0, mesh.dt = 0.001;
    Dispersion creeping = mode_on(&mesh, 10);
    ck_assert(creeping.known);
    ck_assert_double_eq(creeping.frequency, 0);
    ck_assert_double_gt(creeping.decay, 0);
}
END_TEST

START_TEST(unknown_is_said)
{
    BarMesh mesh = paper_mesh();
    mesh.dt = 0.3; /* beyond the limit for the short wave, not for the long one */
    ck_assert(mode_on(&mesh, 1).known);
    ck_assert(!mode_on(&mesh, 16).known);
    ck_assert(!dispersion_of_bar(&paper, &mesh, 4).known); /* shorter than two cells */
    mesh.dt = 0;
    ck_assert(!mode_on(&mesh, 1).known);
}
END_TEST

START_TEST(largest_courant)
{
    static const struct {
        MpmAlgorithm algorithm;
        MpmShape shape;
        int per_cell;
        bool apic;
        double limit, tolerance;
    } rows[] = {
        {MPM_USF, MPM_HAT, 1, false, 2, 1e-12},
        {MPM_MUSL, MPM_HAT, 1, false, 2, 1e-12},
        {MPM_USF, MPM_HAT, 2, false, 1.7320508075688772, 1e-12},
        {MPM_USF, MPM_GIMP, 2, false, 1.7320508075688772, 1e-12},
        {MPM_MUSL, MPM_HAT, 4, false, 1.6583, 5e-5},
        {MPM_USL, MPM_HAT, 1, false, 0.7071, 5e-5},
        {MPM_USL, MPM_HAT, 2, false, 0.7559, 5e-5},
        {MPM_USL, MPM_HAT, 4, false, 0.7698, 5e-5},
        {MPM_USF, MPM_BSPLINE2, 2, false, 2.395, 5e-4},
        {MPM_USL, MPM_BSPLINE2, 2, false, 1.350, 5e-4},
        {MPM_USF, MPM_HAT, 2, true, 1, 1e-12},
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        BarMesh mesh = paper_mesh();
        mesh.algorithm = rows[i].algorithm, mesh.shape = rows[i].shape;
        mesh.particles_per_cell = rows[i].per_cell, mesh.apic = rows[i].apic;
        double limit = dispersion_endless_courant(&mesh);
        ck_assert_double_eq_tol(limit, rows[i].limit, rows[i].tolerance);
        /* a little under it every wave is known, a little over it some wave is not */
        int unknown[2] = {0, 0};
        for (int over = 0; over < 2; over++)
            for (int k = 1; k <= 1000; k++) {
                mesh.dt = limit * (over ? 1.001 : 0.999) / 10;
                unknown[over] += !dispersion_of_bar(&paper, &mesh, M_PI * k / 1000).known;
            }
        ck_assert_int_eq(unknown[0], 0);
        ck_assert_int_gt(unknown[1], 0);
    }
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *waves = tcase_create("waves");
    tcase_add_test(waves, predicted_frequencies);
    tcase_add_test(waves, error_table);
    tcase_add_test(waves, without_the_filter);
    tcase_add_test(waves, small_steps_leave_the_mesh_alone);
    tcase_add_test(waves, decay_rates);
    tcase_add_test(waves, blend_damps_per_step);
    tcase_add_test(waves, unknown_is_said);
    suite_add_tcase(suite, waves);
    TCase *limits = tcase_create("limits");
    tcase_add_test(limits, largest_courant);
    suite_add_tcase(suite, limits);
}
