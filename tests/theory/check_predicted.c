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
                     .joint = which->def.joint,
                     .joint_modulus = which->def.joint_modulus,
                     .joint_density = which->def.joint_density,
                     .n_modes = which->n_modes};
    bar.of_sines = bar_is_layered(&bar);
    for (int i = 0; i < which->n_modes; i++)
        bar.modes[i].number = which->modes[i].number, bar.modes[i].velocity = which->modes[i].velocity;
    return bar;
}

static BarMesh mesh_of(const MpmDef *def, double dt)
{
    static const MpmAlgorithm algorithms[] = {
        [MPM_USF] = MPM_USF, [MPM_USL] = MPM_USL, [MPM_MUSL] = MPM_MUSL};
    static const MpmShape shapes[] = {[MPM_HAT] = MPM_HAT,
                                      [MPM_GIMP] = MPM_GIMP,
                                      [MPM_BSPLINE2] = MPM_BSPLINE2,
                                      [MPM_BSPLINE3] = MPM_BSPLINE3};
    return (BarMesh){.cell_size = def->cell_size,
                     .particles_per_cell = def->particles_per_cell,
                     .offset = def->offset,
                     .algorithm = algorithms[def->algorithm],
                     .shape = shapes[def->shape],
                     .apic = def->transfer == MPM_APIC,
                     .flip_fraction = def->flip_fraction,
                     .consistent = 1 - def->mass_blend,
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

/* Every step of v_cm, whatever is transferred how, from where, by which shape, between which ends: what is
 * left is that particles move, and falls with v0. It is most with uGIMP, and beside the middle of their
 * shares, where weights change with the place in the first order. */
static void expect_centre(BarCase which, double tolerance)
{
    Simulation *sim = bar_case_create(&which);
    StepModes *modes = bar_case_modes(&which);
    ck_assert(step_modes_are_whole(modes));
    for (long k = 0; k <= STEPS; k++) {
        const double v = series_now(sim, "v_cm"), predicted = step_modes_v_cm(modes, k);
        ck_assert_msg(fabs(v - predicted) <= tolerance * which.modes[0].velocity,
                      "supports %d, P = %d, shape %d: step %ld: %.12g instead of %.12g", which.def.supports,
                      which.def.particles_per_cell, which.def.shape, k, v, predicted);
        if (k < STEPS)
            advance(sim, 1);
    }
    step_modes_free(modes);
    simulation_destroy(sim);
}

START_TEST(centre_velocity)
{
    for (int per_cell = 1; per_cell <= 6; per_cell++)
        for (int i = 0; i < 3; i++) {
            BarCase which = bar_case(numbers[i], small);
            which.def.algorithm = (MpmAlgorithm)_i;
            which.def.particles_per_cell = per_cell;
            expect_centre(which, 1e-6);
        }
    BarCase both = bar_case(1, small);
    bar_case_add_mode(&both, 7, 0.3 * small);
    both.def.algorithm = (MpmAlgorithm)_i;
    expect_centre(both, 1e-6);
}
END_TEST

START_TEST(centre_velocity_of_others)
{
    static const struct {
        MpmShape shape;
        int per_cell;
        double joint, modulus, density, courant, blend, offset, tolerance, flip;
        MpmTransfer transfer;
    } rows[] = {
        {MPM_HAT, 2, 10, 50, 4, 0.1, 1, 0, 1e-9, 1, MPM_FLIP},
        {MPM_HAT, 1, 12, 400, 1, 0.4, 1, 0, 1e-9, 1, MPM_FLIP},
        {MPM_HAT, 4, 3, 100, 0.25, 0.1, 0.3, 0, 1e-9, 1, MPM_FLIP},
        {MPM_HAT, 2, 20, 25, 1, 0.8, 1, 0.2, 3e-9, 1, MPM_FLIP},
        {MPM_GIMP, 2, 10, 50, 4, 0.1, 1, 0, 1e-8, 1, MPM_FLIP},
        {MPM_BSPLINE2, 3, 10, 400, 1, 0.3, 1, 0, 1e-9, 1, MPM_FLIP},
        {MPM_BSPLINE2, 2, 24, 50, 4, 0.1, 0.5, 0, 1e-9, 1, MPM_FLIP},
        {MPM_BSPLINE3, 2, 12, 50, 4, 0.5, 1, 0, 1e-9, 1, MPM_FLIP},
        {MPM_GIMP, 2, 0, 100, 1, 0.1, 1, 0.3, 3e-8, 1, MPM_FLIP},
        {MPM_CPDI, 3, 0, 100, 1, 0.2, 1, 0, 1e-8, 0.9, MPM_FLIP},
        {MPM_BSPLINE2, 2, 0, 100, 1, 0.1, 1, 0.2, 3e-9, 1, MPM_APIC},
        {MPM_HAT, 3, 10, 50, 4, 0.1, 1, 0, 1e-9, 1, MPM_FMPM},
    };
    for (int supports = 0; supports < 4; supports++)
        for (int algorithm = 0; algorithm < 3; algorithm++) {
            BarCase which = bar_case(numbers[(supports + algorithm + _i) % 3], 1e-9);
            bar_case_add_mode(&which, 2, 0.3e-9);
            which.def.supports = (BarSupports)supports;
            which.def.algorithm = (MpmAlgorithm)algorithm;
            which.def.shape = rows[_i].shape;
            which.def.particles_per_cell = rows[_i].per_cell;
            which.def.joint = rows[_i].joint;
            which.def.joint_modulus = rows[_i].modulus, which.def.joint_density = rows[_i].density;
            which.def.courant = algorithm == MPM_USL ? fmin(0.3, rows[_i].courant) : rows[_i].courant;
            which.def.mass_blend = rows[_i].blend;
            which.def.offset = rows[_i].offset;
            which.def.flip_fraction = rows[_i].flip;
            which.def.transfer = rows[_i].transfer;
            which.def.fmpm_order = 2;
            expect_centre(which, rows[_i].tolerance);
        }
}
END_TEST

/* Too large a step has no prediction; a bar at rest stays so; of what is too large nothing is known. */
START_TEST(without_prediction)
{
    BarCase which = bar_case(20, 0.1);
    which.def.courant = 2;
    StepModes *modes = bar_case_modes(&which);
    ck_assert(!step_modes_are_whole(modes) && !step_modes_largest(modes).known);
    step_modes_free(modes);
    which = bar_case(5, 0);
    modes = bar_case_modes(&which);
    ck_assert(step_modes_are_whole(modes) && !step_modes_largest(modes).known);
    ck_assert_double_eq(step_modes_v_cm(modes, 1000), 0);
    step_modes_free(modes);
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
    tcase_add_loop_test(predicted, centre_velocity, 0, 3);
    tcase_add_loop_test(predicted, centre_velocity_of_others, 0, 12);
    tcase_add_test(predicted, without_prediction);
    tcase_add_test(predicted, decay);
    suite_add_tcase(suite, predicted);
}
