/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bar against what is known of the method: frequencies, invariants, energies, limits of stability. */
#include "methods/bar_case.h"
#include "methods/default_defs.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The frequency of a single vibration, from its samples every `stride` steps: for differences d of samples
 * d[k+1] + d[k-1] = 2 cos(Omega h) d[k]. Mean and phase do not matter. */
static double measured_frequency(Simulation *sim, long steps, long stride)
{
    int v_cm = simulation_find_series(sim, "v_cm");
    double *rows = malloc(sizeof(double) * (size_t)(steps * sim->n_series));
    ck_assert_ptr_nonnull(rows);
    ck_assert(simulation_steps(sim, steps, rows, NULL, NULL));
    double above = 0, below = 0;
    for (long k = 2 * stride; k + stride < steps; k++) {
        double sample[4];
        for (int i = 0; i < 4; i++)
            sample[i] = rows[(k + (i - 2) * stride) * sim->n_series + v_cm];
        double d0 = sample[1] - sample[0], d1 = sample[2] - sample[1], d2 = sample[3] - sample[2];
        above += d1 * (d0 + d2);
        below += 2 * d1 * d1;
    }
    free(rows);
    return acos(above / below) / ((double)stride * sim->dt);
}

/* The dispersion relation of hat and uGIMP on this mesh, USF and MUSL with pure FLIP (science: filter F times
 * the lumped finite-element mesh, then central differences). */
static double predicted_frequency(const BarCase *bar, int mode)
{
    double p = bar->def.particles_per_cell, c = sqrt(bar->def.youngs_modulus / bar->def.density);
    double theta = bar_case_wave_number(bar, mode) * bar->def.cell_size;
    double f = 1 - (1.0 / 3 + 1 / (6 * p * p)) * (1 - cos(theta)), k = 4 * pow(sin(theta / 2), 2);
    double w = sqrt(f * k) * bar->def.courant; /* omega dt */
    return acos(1 - w * w / 2) / (bar->def.courant * bar->def.cell_size / c);
}

START_TEST(paper_frequencies)
{
    static const struct {
        int mode;
        double frequency;
    } known[] = {{1, .6279837381}, {5, 5.4151680880}, {10, 9.8238325197}};
    BarCase bar = bar_case(known[_i].mode, 1e-6);
    ck_assert_double_eq_tol(predicted_frequency(&bar, known[_i].mode), known[_i].frequency, 1e-9);
    Simulation *sim = bar_case_create(&bar);
    double measured = measured_frequency(sim, 4000, _i == 0 ? 200 : 20);
    ck_assert_double_eq_tol(measured, known[_i].frequency, 1e-8 * known[_i].frequency);
    simulation_destroy(sim);
}
END_TEST

/* Other supports, numbers of particles per cell, MUSL, uGIMP. */
START_TEST(predicted_frequencies)
{
    for (int supports = BAR_FIXED_FREE; supports <= BAR_FREE_FREE; supports++)
        for (int particles = 1; particles <= 6; particles++) {
            /* of equal ends only the odd modes move the centre of mass, and of two free ends none */
            BarCase bar = bar_case(3, 1e-6);
            bar.def.supports = (BarSupports)supports;
            bar.def.particles_per_cell = particles;
            bar.def.algorithm = particles % 2 ? MPM_MUSL : MPM_USF;
            bar.def.shape = _i ? MPM_GIMP : MPM_HAT;
            if (supports == BAR_FREE_FREE)
                continue;
            /* uGIMP at a free end is no exact eigenvector */
            double allowed = _i ? 1e-7 : 1e-8;
            Simulation *sim = bar_case_create(&bar);
            double measured = measured_frequency(sim, 4000, 40), predicted = predicted_frequency(&bar, 3);
            ck_assert_msg(fabs(measured / predicted - 1) <= allowed,
                          "supports %d P %d: %.12g, not %.12g (%.2g)", supports, particles, measured,
                          predicted, measured / predicted - 1);
            simulation_destroy(sim);
        }
}
END_TEST

START_TEST(second_order_in_the_cell_size)
{
    double error[4];
    for (int i = 0; i < 4; i++) {
        BarCase bar = bar_case(5, 1e-6);
        bar.def.cell_size = pow(0.5, i);
        Simulation *sim = bar_case_create(&bar);
        double exact = bar_case_wave_number(&bar, 5) * 10;
        error[i] = measured_frequency(sim, 2000L << i, 20L << i) / exact - 1;
        simulation_destroy(sim);
    }
    for (int i = 1; i < 4; i++)
        ck_assert_double_eq_tol(log2(error[i - 1] / error[i]), 2.0, 0.03 / i);
}
END_TEST

/* sum m v^n v^(n+1) / 2 + strain energy: of stress^(n+1) for USF, of stress^n for MUSL. */
START_TEST(sharp_invariant)
{
    BarCase bar = bar_case(5, 1e-8);
    bar.def.algorithm = _i ? MPM_MUSL : MPM_USF;
    Simulation *sim = bar_case_create(&bar);
    double first = 0, worst = 0;
    double *v = field_now(sim, 0, "v"), strain = 0;
    for (int step = 0; step < 10000; step++) {
        advance(sim, 1);
        double *next = field_now(sim, 0, "v"), energy = 0, next_strain = series_now(sim, "strain");
        for (size_t p = 0; p < sim->counts[0]; p++)
            energy += 0.5 * 0.5 * v[p] * next[p];
        energy += _i ? strain : next_strain;
        strain = next_strain;
        free(v);
        v = next;
        if (step == 0)
            first = energy;
        worst = fmax(worst, fabs(energy / first - 1));
    }
    free(v);
    ck_assert_msg(worst <= 1e-9, "the invariant wanders by %.3g", worst);
    simulation_destroy(sim);
}
END_TEST

START_TEST(momentum_of_a_free_bar)
{
    for (int shape = MPM_HAT; shape <= MPM_BSPLINE3; shape++)
        for (int algorithm = MPM_USF; algorithm <= MPM_MUSL; algorithm++)
            for (int transfer = MPM_FLIP; transfer <= MPM_APIC; transfer++) {
                BarCase bar = bar_case(0, 0.05);
                bar_case_add_mode(&bar, 3, 0.1);
                bar.def.supports = BAR_FREE_FREE;
                bar.def.shape = (MpmShape)shape;
                bar.def.algorithm = (MpmAlgorithm)algorithm;
                bar.def.transfer = (MpmTransfer)transfer;
                Simulation *sim = bar_case_create(&bar);
                double v0 = series_now(sim, "v_cm"), x0 = series_now(sim, "x_cm");
                advance(sim, 400);
                ck_assert_double_eq_tol(series_now(sim, "v_cm"), v0, 1e-13);
                ck_assert_double_eq_tol(series_now(sim, "x_cm"), x0 + 400 * sim->dt * v0, 1e-12);
                simulation_destroy(sim);
            }
}
END_TEST

/* A bar that drifts stays free of stress even as its particles meet the nodes to the last digit. */
START_TEST(rigid_motion_is_not_felt)
{
    BarCase bar = bar_case(0, 0.05);
    bar.def.supports = BAR_FREE_FREE;
    bar.def.length = 10;
    bar.def.courant = 0.2;
    bar.def.shape = (MpmShape)_i;
    Simulation *sim = bar_case_create(&bar);
    for (int i = 0; i < 70; i++) {
        advance(sim, 50);
        double *stress = field_now(sim, 0, "stress");
        for (size_t p = 0; p < sim->counts[0]; p++)
            ck_assert_msg(fabs(stress[p]) < 1e-7, "stress %g of particle %zu", stress[p], p);
        free(stress);
    }
    simulation_destroy(sim);
}
END_TEST

/* At each fifth step an end stands on a node, and the node beyond is empty: APIC's slope takes it to move
 * with the bar. (A slope of -v/dx there had filled the bar with a strain energy of 15.7.) */
START_TEST(apic_does_not_feel_an_empty_node)
{
    BarCase bar = bar_case(0, 2.5);
    bar.def.supports = BAR_FREE_FREE;
    bar.def.padding = 10;
    bar.def.transfer = MPM_APIC;
    bar.def.algorithm = (MpmAlgorithm)_i;
    Simulation *sim = bar_case_create(&bar);
    for (int step = 0; step < 200; step++) {
        advance(sim, 1);
        ck_assert_msg(series_now(sim, "strain") < 1e-20, "%g at step %ld", series_now(sim, "strain"),
                      sim->step);
    }
    simulation_destroy(sim);
}
END_TEST

/* x_cm moves with the nodes: whatever the transfer, by x_cm_rate. At the start that is what the first step
 * would do without its forces. */
START_TEST(the_rate_of_x_cm_is_its_rate)
{
    BarCase bar = bar_case(5, 0.2);
    bar.def.transfer = (MpmTransfer)(_i % 3);
    bar.def.algorithm = (MpmAlgorithm)(_i / 3 % 3);
    bar.def.joint = _i % 2 ? 10 : 0;
    bar.def.joint_modulus = 300;
    bar.def.joint_density = 3;
    bar.def.body_force = _i % 2 ? 0.01 : 0;
    Simulation *sim = bar_case_create(&bar);
    double x = series_now(sim, "x_cm"), rate = series_now(sim, "x_cm_rate");
    for (int step = 0; step < 300; step++) {
        const double before = rate;
        advance(sim, 1);
        rate = series_now(sim, "x_cm_rate");
        ck_assert_double_eq_tol((series_now(sim, "x_cm") - x) / sim->dt, rate, 1e-10);
        ck_assert_double_eq_tol(rate, before, step == 0 ? 1e-3 : 0.05);
        x = series_now(sim, "x_cm");
    }
    simulation_destroy(sim);
}
END_TEST

/* v_cm, the particles' momentum over their mass, oscillates by what is right while x_cm does not (science: to
 * three digits, the root of the mean square over ten units of time); and of mode 10 it keeps a mean. */
START_TEST(v_cm_is_not_the_rate_of_x_cm)
{
    static const struct {
        int mode;
        double v_cm, rate;
    } known[] = {{1, 1.000, .9995}, {5, 1.007, .948}, {10, 1.005, .767}};
    BarCase bar = bar_case(known[_i].mode, 0.1);
    Simulation *sim = bar_case_create(&bar);
    const double wave = bar_case_wave_number(&bar, known[_i].mode);
    const double oscillation = 0.1 * (1 - cos(wave * 25)) / (wave * 25);
    double exact = 0, v_cm = 0, rate = 0, late = 0;
    for (int step = 0; step <= 1000; step++) {
        exact += pow(oscillation * cos(10 * wave * simulation_time(sim)), 2);
        v_cm += pow(series_now(sim, "v_cm"), 2);
        rate += pow(series_now(sim, "x_cm_rate"), 2);
        advance(sim, 1);
    }
    ck_assert_double_eq_tol(sqrt(v_cm / exact), known[_i].v_cm, 1e-3);
    ck_assert_double_eq_tol(sqrt(rate / exact), known[_i].rate, 1e-3);
    for (int step = 1001; known[_i].mode == 10 && step <= 10000; step++) {
        late += step >= 9000 ? series_now(sim, "v_cm") / 1001 : 0;
        advance(sim, 1);
    }
    if (known[_i].mode == 10)
        ck_assert_double_eq_tol(late / oscillation, -.226, 1e-3);
    simulation_destroy(sim);
}
END_TEST

/* What the supports take is what acts on the nodes that they hold; the particles get the rest. A free bar has
 * no such column. */
START_TEST(the_reaction_is_what_held_nodes_get)
{
    BarCase bar = bar_case(5, 0.2);
    bar.def.algorithm = (MpmAlgorithm)(_i % 3);
    bar.def.body_force = _i < 3 ? 0.01 : 0;
    bar.def.traction = _i < 3 ? 0.02 : 0;
    Simulation *sim = bar_case_create(&bar);
    ck_assert_double_eq(series_now(sim, "reaction"), 0);
    for (int step = 0; step < 100; step++) {
        double held = 0, pull = 0;
        const double before = series_now(sim, "momentum");
        while (strcmp(sim->stages[sim->stage].id, "integrate") != 0)
            ck_assert(simulation_stage(sim, NULL));
        double *f = field_now(sim, 1, "f_int"), *load = field_now(sim, 1, "f_ext"),
               *fixed = field_now(sim, 1, "fixed");
        for (size_t i = 0; i < sim->counts[1]; i++) {
            held -= fixed[i] * (f[i] + load[i]);
            pull += load[i];
        }
        free(f), free(load), free(fixed);
        do
            ck_assert(simulation_stage(sim, NULL));
        while (sim->stage > 0);
        ck_assert_double_eq_tol(series_now(sim, "reaction"), held, 1e-11);
        ck_assert_double_eq_tol((series_now(sim, "momentum") - before) / sim->dt, held + pull, 1e-11);
    }
    simulation_destroy(sim);
    bar.def.supports = BAR_FREE_FREE;
    sim = bar_case_create(&bar);
    ck_assert_int_eq(simulation_find_series(sim, "reaction"), -1);
    ck_assert_int_ge(simulation_find_series(sim, "momentum"), 0);
    simulation_destroy(sim);
}
END_TEST

static double mean_energy(Simulation *sim, const char *name, long steps)
{
    double *rows = malloc(sizeof(double) * (size_t)(steps * sim->n_series)), sum = 0;
    ck_assert(simulation_steps(sim, steps, rows, NULL, NULL));
    int which = simulation_find_series(sim, name);
    for (long k = 0; k < steps; k++)
        sum += rows[k * sim->n_series + which];
    free(rows);
    return sum / (double)steps;
}

/* Mean of the last tenth of t in [0, 100] over the first. */
START_TEST(energy_left)
{
    static const double left[3][3] = {[MPM_USF] = {1.000, 1.000, 1.008},
                                      [MPM_USL] = {.9998, .207, .012},
                                      [MPM_MUSL] = {1.000, 1.000, .992}};
    static const int modes[] = {1, 5, 10};
    int algorithm = _i / 3;
    BarCase bar = bar_case(modes[_i % 3], 0.1);
    bar.def.algorithm = (MpmAlgorithm)algorithm;
    Simulation *sim = bar_case_create(&bar);
    double first = mean_energy(sim, "total", 1000);
    advance(sim, 8000);
    ck_assert_double_eq_tol(mean_energy(sim, "total", 1000) / first, left[algorithm][_i % 3], 0.003);
    simulation_destroy(sim);
}
END_TEST

START_TEST(crossing_heats_or_cools)
{
    /* with hats the orbit is chaotic: a bounded range, not a number */
    static const struct {
        MpmAlgorithm algorithm;
        MpmShape shape;
        double least, most;
    } known[] = {{MPM_USF, MPM_HAT, 1.1, 1.5},
                 {MPM_MUSL, MPM_HAT, .85, 1.05},
                 {MPM_USL, MPM_HAT, .28, .36},
                 {MPM_USF, MPM_GIMP, .998, 1.002},
                 {MPM_USF, MPM_BSPLINE2, .996, 1.000}};
    BarCase bar = bar_case(1, 1.0);
    bar.def.algorithm = known[_i].algorithm;
    bar.def.shape = known[_i].shape;
    bar.def.padding = 20;
    Simulation *sim = bar_case_create(&bar);
    double first = mean_energy(sim, "total", 1000);
    advance(sim, 8000);
    double left = mean_energy(sim, "total", 1000) / first;
    ck_assert_msg(left > known[_i].least && left < known[_i].most, "%g of the energy is left", left);
    ck_assert_int_gt(sim->n_events, 0);
    ck_assert_int_eq(sim->events[0].kind, EVENT_CROSSING);
    const long crossed = sim->events[0].step;
    simulation_destroy(sim);
    sim = bar_case_create(&bar);
    while (sim->n_events == 0)
        advance(sim, 1);
    ck_assert_int_eq(sim->step, crossed); /* after which it is true */
    simulation_destroy(sim);
}
END_TEST

/* The share of the kinetic energy that the grid cannot see, early and late. */
START_TEST(hidden_energy)
{
    static const struct {
        int mode;
        double early, late;
    } known[] = {{1, .0007, .0008}, {5, .059, .248}, {10, .252, .942}};
    BarCase bar = bar_case(known[_i].mode, 0.1);
    Simulation *sim = bar_case_create(&bar), *again = bar_case_create(&bar);
    double early = 1 - mean_energy(sim, "kinetic_grid", 1000) / mean_energy(again, "kinetic", 1000);
    advance(sim, 8000);
    advance(again, 8000);
    double late = 1 - mean_energy(sim, "kinetic_grid", 1000) / mean_energy(again, "kinetic", 1000);
    ck_assert_double_eq_tol(early, known[_i].early, 1e-3);
    ck_assert_double_eq_tol(late, known[_i].late, 1e-3);
    simulation_destroy(sim);
    simulation_destroy(again);
}
END_TEST

typedef struct Shares {
    double lumping, null;
} Shares;

/* In per cent of the kinetic energy, over the next steps. */
static Shares mean_shares(Simulation *sim, long steps)
{
    double *rows = malloc(sizeof(double) * (size_t)(steps * sim->n_series)), all = 0, seen = 0, null = 0;
    ck_assert(simulation_steps(sim, steps, rows, NULL, NULL));
    for (long k = 0; k < steps; k++) {
        const double *row = rows + k * sim->n_series;
        all += row[simulation_find_series(sim, "kinetic")];
        seen += row[simulation_find_series(sim, "kinetic_grid")];
        null += row[simulation_find_series(sim, "kinetic_null")];
    }
    free(rows);
    return (Shares){100 * (all - seen - null) / all, 100 * null / all};
}

/* Lumped masses take their share from the start; only a run that moves particles far fills the null space. */
START_TEST(hidden_energy_in_two)
{
    static const struct {
        double v0;
        int mode;
        double period;
        Shares at[3]; /* of the first period, and of those that end at t = 20 and 100 */
    } known[] = {
        {0.001, 1, 10.0053, {{.074, 0}, {.074, 0}, {.074, 0}}},
        {0.1, 1, 10.0053, {{.073, 0}, {.073, 0}, {.073, .003}}},
        {0.001, 5, 1.1603, {{5.84, .002}, {5.84, .002}, {5.84, .004}}},
        {0.1, 5, 1.1603, {{5.84, .003}, {5.87, .91}, {5.34, 20.9}}},
        {0.001, 10, 0.6396, {{23.65, .17}, {23.66, .17}, {23.64, .22}}},
        {0.1, 10, 0.6396, {{23.65, .18}, {19.3, 18.6}, {1.57, 93.5}}},
    };
    static const double ends[3] = {0, 20, 100};
    BarCase bar = bar_case(known[_i].mode, known[_i].v0);
    Simulation *sim = bar_case_create(&bar);
    const long period = lround(known[_i].period / sim->dt);
    for (int i = 0; i < 3; i++) {
        const long first = lround(ends[i] / sim->dt) - period; /* two periods of mode 1 are just over 20 */
        if (first > sim->step)
            advance(sim, first - sim->step);
        const Shares got = mean_shares(sim, period), expected = known[_i].at[i];
        /* to the last digit of the table or two */
        ck_assert_double_eq_tol(got.lumping, expected.lumping, fmax(1e-3, 2e-3 * expected.lumping));
        ck_assert_double_eq_tol(got.null, expected.null,
                                fmax(expected.null < 0.1 ? 6e-4 : 6e-3, 5e-3 * expected.null));
    }
    simulation_destroy(sim);
}
END_TEST

/* At the start, before anything has moved; and with one particle for each node nothing can hide. */
START_TEST(null_space_at_the_start)
{
    static const struct {
        int mode;
        double lumping, null;
    } known[] = {{1, .074, 0}, {5, 5.838, .00083}, {10, 23.675, .085}};
    for (int i = 0; i < 3; i++) {
        BarCase bar = bar_case(known[i].mode, 0.1);
        Simulation *sim = bar_case_create(&bar);
        const double all = series_now(sim, "kinetic"), null = series_now(sim, "kinetic_null");
        ck_assert_double_eq_tol(100 * null / all, known[i].null, known[i].null > .01 ? 5e-4 : 5e-6);
        ck_assert_double_eq_tol(100 * (1 - (series_now(sim, "kinetic_grid") + null) / all), known[i].lumping,
                                5e-4);
        simulation_destroy(sim);
    }
    for (int shape = MPM_HAT; shape <= MPM_BSPLINE3; shape++) {
        BarCase bar = bar_case(10, 0.1);
        bar.def.particles_per_cell = 1;
        bar.def.shape = (MpmShape)shape;
        Simulation *sim = bar_case_create(&bar);
        ck_assert_double_lt(series_now(sim, "kinetic_null"), 1e-25);
        simulation_destroy(sim);
    }
}
END_TEST

/* The minimum itself, by trying: no velocities of the grid come nearer to the particles than K_0 says, and a
 * motion that the grid can give has none. With crossings, empty nodes and all shapes. */
START_TEST(null_space_of_what_the_grid_gives)
{
    BarCase bar = bar_case(1, 1.0);
    bar.def.shape = (MpmShape)(_i / 2);
    bar.def.transfer = MPM_FLIP;
    bar.def.flip_fraction = _i % 2 ? 0 : 1; /* PIC: v = sum N v_i of the last step, seen nearly whole */
    bar.def.padding = 16;
    Simulation *sim = bar_case_create(&bar);
    advance(sim, 900);
    ck_assert_int_gt(sim->n_events, 0);
    const double all = series_now(sim, "kinetic"), null = series_now(sim, "kinetic_null");
    const double grid = series_now(sim, "kinetic_grid");
    ck_assert_double_ge(null, 0);
    ck_assert_double_le(null + grid, all * (1 + 1e-12));
    if (_i % 2)
        ck_assert_double_lt(null, 1e-3 * all);
    simulation_destroy(sim);
}
END_TEST

typedef struct Peak {
    double value, time;
} Peak;

/* The largest value of v_cm over the next steps, and when. */
static Peak largest_v_cm(Simulation *sim, double end)
{
    Peak peak = {-INFINITY, 0};
    while (simulation_time(sim) < end - 0.5 * sim->dt) {
        advance(sim, 1);
        double v = series_now(sim, "v_cm");
        if (v > peak.value)
            peak = (Peak){v, simulation_time(sim)};
    }
    return peak;
}

START_TEST(gravity)
{
    BarCase bar = bar_case(1, 0);
    bar.def.body_force = 1e-3;
    Simulation *sim = bar_case_create(&bar);
    Peak first = largest_v_cm(sim, 4);
    ck_assert_double_eq_tol(first.value, 1.2499e-3, 5e-8);
    ck_assert_double_eq_tol(first.time, 2.49, 1e-9);
    Peak largest = largest_v_cm(sim, 50);
    ck_assert_double_eq_tol(largest.value, 1.2536e-3, 5e-8);
    ck_assert_double_eq_tol(largest.time, 22.51, 1e-9);
    /* what the load has done is what the bar has got */
    double row[BAR_CASE_MODES * 4];
    simulation_row(sim, row);
    double work = row[simulation_find_series(sim, "work")], total = row[simulation_find_series(sim, "total")];
    ck_assert_double_gt(work, 1e-7);
    ck_assert_double_eq_tol(total / work, 1, 0.05);
    simulation_destroy(sim);
}
END_TEST

START_TEST(pull)
{
    BarCase bar = bar_case(1, 0);
    bar.def.traction = 1e-2;
    Simulation *sim = bar_case_create(&bar);
    Peak largest = largest_v_cm(sim, 4);
    ck_assert_double_eq_tol(largest.value, 9.60e-4, 5e-7);
    simulation_destroy(sim);
    /* outwards at both ends: nothing moves but the ends part */
    bar.def.supports = BAR_FREE_FREE;
    sim = bar_case_create(&bar);
    advance(sim, 100);
    double *u = field_now(sim, 0, "u");
    ck_assert_double_lt(u[0], 0);
    ck_assert_double_eq_tol(u[49], -u[0], 1e-15);
    ck_assert_double_eq_tol(series_now(sim, "v_cm"), 0, 1e-17);
    free(u);
    simulation_destroy(sim);
    /* a thicker layer bears the same force */
    bar.def.supports = BAR_FIXED_FREE;
    bar.def.traction_layer = 2;
    sim = bar_case_create(&bar);
    Status status;
    for (int i = 0; i < sim->sets[1].ready_after; i++)
        ck_assert(simulation_stage(sim, &status));
    double *force = field_now(sim, 1, "f_ext"), sum = 0;
    for (size_t i = 0; i < sim->counts[1]; i++)
        sum += force[i];
    ck_assert_double_eq_tol(sum, 1e-2, 1e-16);
    free(force);
    simulation_destroy(sim);
}
END_TEST

/* Whether small random-looking motion stays small over many steps. */
static bool is_stable(const BarCase *bar)
{
    Simulation *sim = bar_case_create(bar);
    double first = series_now(sim, "kinetic");
    bool good = simulation_steps(sim, 3000, NULL, NULL, NULL);
    good = good && series_now(sim, "total") < 30 * first;
    simulation_destroy(sim);
    return good;
}

START_TEST(limits_of_stability)
{
    /* of B-splines the open end is less stable than waves in the bulk (2.395 and 1.350): measured */
    static const struct {
        MpmAlgorithm algorithm;
        MpmShape shape;
        MpmTransfer transfer;
        int particles;
        double limit;
    } known[] = {
        {MPM_USF, MPM_HAT, MPM_FLIP, 1, 2.0},        {MPM_USF, MPM_HAT, MPM_FLIP, 2, 1.7320508},
        {MPM_USF, MPM_HAT, MPM_FLIP, 4, 1.6583},     {MPM_MUSL, MPM_HAT, MPM_FLIP, 2, 1.7320508},
        {MPM_USL, MPM_HAT, MPM_FLIP, 1, .7071},      {MPM_USL, MPM_HAT, MPM_FLIP, 2, .7559},
        {MPM_USL, MPM_HAT, MPM_FLIP, 4, .7698},      {MPM_USF, MPM_BSPLINE2, MPM_FLIP, 2, 2.050},
        {MPM_USL, MPM_BSPLINE2, MPM_FLIP, 2, 1.226}, {MPM_USF, MPM_HAT, MPM_APIC, 2, 1.0},
    };
    BarCase bar = bar_case(1, 1e-8);
    for (int mode = 4; mode < 40; mode += 12)
        bar_case_add_mode(&bar, mode, 1e-8);
    bar.def.supports = BAR_FIXED_FIXED;
    bar.def.length = 64;
    bar.def.algorithm = known[_i].algorithm;
    bar.def.shape = known[_i].shape;
    bar.def.transfer = known[_i].transfer;
    bar.def.particles_per_cell = known[_i].particles;
    bar.def.courant = 0.98 * known[_i].limit;
    ck_assert(is_stable(&bar));
    bar.def.courant = 1.03 * known[_i].limit;
    ck_assert(!is_stable(&bar));
}
END_TEST

/* A run that fails names particle, step and time, and stands where everything was sound. */
static void expect_failure(const BarCase *bar, long steps, const char *words, Status *status)
{
    Simulation *sim = bar_case_create(bar);
    long done = -1;
    ck_assert(!simulation_steps(sim, steps, NULL, &done, status));
    ck_assert_msg(strstr(status->text, words) != NULL, "%s", status->text);
    ck_assert_msg(strstr(status->text, "step") && strstr(status->text, "t = "), "%s", status->text);
    ck_assert_int_eq(status->code, STATUS_FAILED);
    ck_assert(sim->failed);
    ck_assert_int_eq(sim->step, done);
    ck_assert_int_gt(done, 0);
    Simulation *sound = bar_case_create(bar);
    advance(sound, done);
    double *v = field_now(sim, 0, "v"), *w = field_now(sound, 0, "v");
    ck_assert_mem_eq(v, w, sim->counts[0] * sizeof *v);
    /* stage by stage it fails in the same step with the same words */
    Status other;
    while (simulation_stage(sound, &other))
        ck_assert_int_eq(sound->step, done);
    ck_assert_str_eq(other.text, status->text);
    free(v);
    free(w);
    simulation_destroy(sim);
    simulation_destroy(sound);
}

START_TEST(failures_are_errors)
{
    Status status;
    BarCase bar = bar_case(0, 1.0);
    bar.def.supports = BAR_FREE_FREE;
    bar.def.padding = 1;
    expect_failure(&bar, 1000, "particle 49 left the mesh", &status);

    /* a support stops the grid, not a box that lies across it */
    bar = bar_case(1, 0);
    bar.def.shape = MPM_GIMP;
    bar.def.offset = -0.49;
    bar.def.body_force = -0.35;
    expect_failure(&bar, 1000, "particle 0 left the mesh through a support (its box reaches past", &status);
    bar.def.shape = MPM_CPDI;
    bar.def.supports = BAR_FREE_FIXED;
    bar.def.offset = 0.49;
    bar.def.body_force = 0.35;
    expect_failure(&bar, 1000, "particle 49 left the mesh through a support (its box reaches past", &status);

    /* another velocity, at which an end passes nodes by less */
    bar = bar_case(0, 2.5);
    bar.def.supports = BAR_FREE_FREE;
    bar.def.padding = 100;
    bar.def.particles_per_cell = 1;
    bar.def.transfer = MPM_APIC;
    expect_failure(&bar, 10000, "nodes of tiny mass", &status);

    bar = bar_case(4, 32.0);
    bar.def.algorithm = MPM_USL;
    expect_failure(&bar, 1000, "1 + de <= 0", &status);
    ck_assert_ptr_nonnull(strstr(status.text, "particle"));

    bar = bar_case(10, 1e-6);
    bar.def.courant = 1.74;
    expect_failure(&bar, 10000, "energy", &status);
}
END_TEST

START_TEST(jumps_over_cells)
{
    /* faster than a cell per step, but all together: nothing is wrong with that */
    BarCase bar = bar_case(0, 30.0);
    bar.def.supports = BAR_FREE_FREE;
    bar.def.padding = 40;
    bar.def.courant = 0.5;
    Simulation *sim = bar_case_create(&bar);
    advance(sim, 20);
    double *u = field_now(sim, 0, "u");
    for (size_t p = 0; p < sim->counts[0]; p++)
        ck_assert_double_eq_tol(u[p], 20 * sim->dt * 30, 1e-10);
    free(u);
    simulation_destroy(sim);
}
END_TEST

START_TEST(growth_is_reported)
{
    BarCase bar = bar_case(1, 1.0); /* heats */
    bar.def.padding = 20;
    Simulation *sim = bar_case_create(&bar);
    advance(sim, 10000);
    bool reported = false;
    for (int i = 0; i < sim->n_events; i++)
        reported = reported || sim->events[i].kind == EVENT_ENERGY;
    ck_assert(reported);
    ck_assert_str_eq(sim->events[0].text, "particle 43 crossed into cell 22");
    simulation_destroy(sim);
}
END_TEST

static void expect_refused(MpmDef def, const char *key)
{
    Status status;
    ck_assert(!mpm_check(&def, &status) || !mpm_create(&def, &status));
    ck_assert_msg(strncmp(status.text, key, strlen(key)) == 0, "%s", status.text);
}

START_TEST(definitions_are_checked)
{
    const struct {
        double value;
        size_t offset;
        const char *key;
    } bad[] = {
        {0.7, offsetof(MpmDef, cell_size), "mesh.cell_size"},
        {1e-9, offsetof(MpmDef, cell_size), "mesh.cell_size"},
        {30, offsetof(MpmDef, cell_size), "mesh.cell_size"},
        {0.1, offsetof(MpmDef, traction_layer), "load.traction_layer"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        MpmDef def = bar_default();
        *(double *)((char *)&def + bad[i].offset) = bad[i].value;
        expect_refused(def, bad[i].key);
    }
    MpmDef def = bar_default();
    def.youngs_modulus = 1e308, def.density = 1e-300;
    expect_refused(def, "bar.youngs_modulus");
    /* within 1e-9 a whole number of cells */
    def = bar_default();
    def.cell_size = 25.0 / 250;
    def.length = 25.0 * (1 + 5e-10);
    Simulation *sim = mpm_create(&def, NULL);
    ck_assert_ptr_nonnull(sim);
    simulation_destroy(sim);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *test = tcase_create("physics");
    tcase_add_loop_test(test, paper_frequencies, 0, 3);
    if (!suite_sanitized()) {
        tcase_add_loop_test(test, predicted_frequencies, 0, 2);
        tcase_add_test(test, second_order_in_the_cell_size);
    }
    tcase_add_loop_test(test, sharp_invariant, 0, 2);
    tcase_add_test(test, momentum_of_a_free_bar);
    tcase_add_loop_test(test, rigid_motion_is_not_felt, 0, 4);
    tcase_add_loop_test(test, the_rate_of_x_cm_is_its_rate, 0, 18);
    tcase_add_loop_test(test, the_reaction_is_what_held_nodes_get, 0, 6);
    tcase_add_loop_test(test, v_cm_is_not_the_rate_of_x_cm, 0, 3);
    tcase_add_loop_test(test, apic_does_not_feel_an_empty_node, MPM_USF, MPM_MUSL + 1);
    tcase_add_loop_test(test, energy_left, 0, 9);
    tcase_add_loop_test(test, crossing_heats_or_cools, 0, 5);
    tcase_add_loop_test(test, hidden_energy, 0, 3);
    tcase_add_loop_test(test, hidden_energy_in_two, 0, 6);
    tcase_add_test(test, null_space_at_the_start);
    tcase_add_loop_test(test, null_space_of_what_the_grid_gives, 0, 8);
    tcase_add_test(test, gravity);
    tcase_add_test(test, pull);
    tcase_add_loop_test(test, limits_of_stability, 0, 10);
    tcase_add_test(test, failures_are_errors);
    tcase_add_test(test, jumps_over_cells);
    tcase_add_test(test, growth_is_reported);
    tcase_add_test(test, definitions_are_checked);
    suite_add_tcase(suite, test);
}
