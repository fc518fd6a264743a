/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The prediction against runs of the engine, with motions so small that particles stay where they are. */
#include "methods/bar_case.h"
#include "suite.h"
#include "theory/elastic_bar.h"
#include "theory/frequency.h"

#include <math.h>
#include <stdlib.h>

enum { STEPS = 2000 };
static const double small = 1e-6;

static BarTheory theory_of(const BarCase *which)
{
    BarSupports supports = which->def.supports;
    BarTheory bar = {.length = which->def.length,
                     .youngs_modulus = which->def.youngs_modulus,
                     .density = which->def.density,
                     .left_fixed = supports == BAR_FIXED_FREE || supports == BAR_FIXED_FIXED,
                     .right_fixed = supports == BAR_FREE_FIXED || supports == BAR_FIXED_FIXED,
                     .n_modes = which->n_modes};
    for (int i = 0; i < which->n_modes; i++)
        bar.modes[i].number = which->modes[i].number, bar.modes[i].velocity = which->modes[i].velocity;
    return bar;
}

static BarMesh mesh_of(const BarDef *def, double dt)
{
    static const MeshAlgorithm algorithms[] = {
        [MPM_USF] = MESH_USF, [MPM_USL] = MESH_USL, [MPM_MUSL] = MESH_MUSL};
    static const MeshShape shapes[] = {[MPM_HAT] = MESH_HAT,
                                       [MPM_GIMP] = MESH_GIMP,
                                       [MPM_BSPLINE2] = MESH_BSPLINE2,
                                       [MPM_BSPLINE3] = MESH_BSPLINE3};
    return (BarMesh){.cell_size = def->cell_size,
                     .particles_per_cell = def->particles_per_cell,
                     .algorithm = algorithms[def->algorithm],
                     .shape = shapes[def->shape],
                     .apic = def->transfer == MPM_APIC,
                     .flip_fraction = def->flip_fraction,
                     .dt = dt};
}

/* The frequency of the centre of mass where one end is free; elsewhere, where it may stand still, that of a
 * particle. */
static double measured_frequency(Simulation *sim, bool centre, double start)
{
    static double record[STEPS + 1];
    int field = simulation_find_field(sim, 0, "v");
    ck_assert_int_ge(field, 0);
    for (long k = 0; k <= STEPS; k++) {
        /* from the first step on: APIC starts without its affine velocities */
        advance(sim, 1);
        if (centre)
            record[k] = series_now(sim, "v_cm");
        else
            sim->method->field(sim, field, 3, 1, &record[k]);
    }
    FrequencyFit fit;
    Status status = {0};
    ck_assert_msg(frequency_fit(record, STEPS + 1, 0, sim->dt, start, &fit, &status), "%s", status.text);
    return fit.frequency;
}

static void expect_predicted(BarCase which, double tolerance)
{
    Simulation *sim = bar_case_create(&which);
    BarTheory bar = theory_of(&which);
    BarMesh mesh = mesh_of(&which.def, sim->dt);
    int number = which.modes[0].number;
    Dispersion wave = dispersion_of_bar(&bar, &mesh, bar_wave_number(&bar, number));
    ck_assert(wave.known);
    double error =
        measured_frequency(sim, bar.left_fixed != bar.right_fixed, wave.frequency) / wave.frequency - 1;
    ck_assert_msg(fabs(error) <= tolerance, "supports %d, P = %d, shape %d, n = %d: off by %g",
                  which.def.supports, which.def.particles_per_cell, which.def.shape, number, error);
    simulation_destroy(sim);
}

static const int numbers[3] = {1, 5, 10};

START_TEST(hat_whatever_the_supports)
{
    for (int per_cell = 1; per_cell <= 6; per_cell++)
        for (int i = 0; i < 3; i++) {
            BarCase which = bar_case(numbers[i], small);
            which.def.supports = (BarSupports)_i;
            which.def.particles_per_cell = per_cell;
            expect_predicted(which, 1e-8);
        }
}
END_TEST

START_TEST(other_shapes)
{
    for (int i = 0; i < 3; i++) {
        BarCase which = bar_case(numbers[i], small);
        which.def.shape = MPM_GIMP;
        expect_predicted(which, 1e-7);
        which.def.shape = MPM_HAT, which.def.transfer = MPM_APIC;
        expect_predicted(which, 1e-7);
    }
    /* the sine is no eigenvector of a spline's ends */
    BarCase spline = bar_case(1, small);
    spline.def.shape = MPM_BSPLINE2;
    expect_predicted(spline, 1e-5);
    spline.modes[0].number = 5;
    expect_predicted(spline, 1e-2);
}
END_TEST

/* Every step of v_cm, overtones too, to a millionth of the velocity. */
static void expect_centre(BarCase which)
{
    Simulation *sim = bar_case_create(&which);
    BarTheory bar = theory_of(&which);
    BarMesh mesh = mesh_of(&which.def, sim->dt);
    ck_assert(dispersion_predicts_centre_velocity(&bar, &mesh));
    for (long k = 0; k <= STEPS; k++) {
        double v = series_now(sim, "v_cm"), predicted = dispersion_centre_velocity(&bar, &mesh, k);
        ck_assert_msg(fabs(v - predicted) <= 1e-6 * small, "step %ld: %.12g instead of %.12g", k, v,
                      predicted);
        if (k < STEPS)
            advance(sim, 1);
    }
    simulation_destroy(sim);
}

START_TEST(centre_velocity)
{
    for (int per_cell = 1; per_cell <= 6; per_cell++)
        for (int i = 0; i < 3; i++) {
            BarCase which = bar_case(numbers[i], small);
            which.def.algorithm = _i ? MPM_MUSL : MPM_USF;
            which.def.particles_per_cell = per_cell;
            expect_centre(which);
        }
    BarCase both = bar_case(1, small);
    bar_case_add_mode(&both, 7, 0.3 * small);
    both.def.algorithm = _i ? MPM_MUSL : MPM_USF;
    expect_centre(both);
}
END_TEST

/* What the grid sees of the energy falls as the predicted decay says. */
static void expect_decay(BarCase which, double tolerance)
{
    Simulation *sim = bar_case_create(&which);
    BarTheory bar = theory_of(&which);
    BarMesh mesh = mesh_of(&which.def, sim->dt);
    Dispersion wave = dispersion_of_bar(&bar, &mesh, bar_wave_number(&bar, which.modes[0].number));
    ck_assert(wave.known);
    double sums[2] = {0, 0};
    long period = lround(2 * M_PI / wave.frequency / sim->dt);
    for (long k = 0; k < STEPS; k++) {
        double seen = series_now(sim, "kinetic_grid");
        sums[0] += k < period ? seen : 0;
        sums[1] += k >= STEPS - period ? seen : 0;
        advance(sim, 1);
    }
    double expected = exp(-2 * wave.decay * sim->dt * (double)(STEPS - period));
    ck_assert_double_lt(expected, 0.99);
    ck_assert_double_eq_tol(sums[1] / sums[0] / expected, 1, tolerance);
    simulation_destroy(sim);
}

START_TEST(decay)
{
    BarCase last = bar_case(5, small), blend = bar_case(5, small);
    last.def.algorithm = MPM_USL;
    expect_decay(last, 5e-3);
    blend.def.flip_fraction = 0.99;
    expect_decay(blend, 5e-3);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *predicted = tcase_create("predicted");
    tcase_add_loop_test(predicted, hat_whatever_the_supports, 0, 4);
    tcase_add_test(predicted, other_shapes);
    tcase_add_loop_test(predicted, centre_velocity, 0, 2);
    tcase_add_test(predicted, decay);
    suite_add_tcase(suite, predicted);
}
