/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams by the material point method: what their mesh predicts, conservation, symmetry, limits, bits, ends.
 */
#include "methods/mpm/engine.h"
#include "methods/default_defs.h"
#include "methods/mpm/mpm.h"
#include "methods/run_case.h"
#include "suite.h"
#include "theory/frequency.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static Simulation *create(const MpmDef *def)
{
    Status status = {0};
    Simulation *sim = mpm_create(def, &status);
    ck_assert_msg(sim != NULL, "%s", status.text);
    return sim;
}

/* 16 x 4 cells; a cantilever with four more in its channel, fast enough to cross some. */
static MpmDef small(bool leaves_channel)
{
    MpmDef def = plane_default(leaves_channel);
    def.length = 0.02;
    def.cell_size = 0.00125;
    def.end = 1e-4;
    if (leaves_channel) {
        def.channel = 0.01;
        def.speed = 90;
    }
    return def;
}

/* --- what the mesh predicts ----------------------------------------------------------------------- */

START_TEST(predicted_periods)
{
    static const struct {
        double cell_size, nu, section, point; /* ms; 0: not given */
        int P;
    } known[] = {
        {1.25e-3, 1.0 / 3, .860591, .860702, 2}, {.625e-3, 1.0 / 3, .862906, .863083, 2},
        {.5e-3, 1.0 / 3, .863188, .863389, 2},   {.3125e-3, 1.0 / 3, .863494, .863746, 2},
        {1.25e-3, 1.0 / 3, .855087, 0, 3},
    };
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        for (int point = 0; point < 2; point++) {
            MpmDef def = plane_default(false);
            Status status;
            double period;
            def.cell_size = known[k].cell_size;
            def.particles_per_cell = known[k].P;
            def.poisson = known[k].nu;
            def.courant = 1;
            def.ends = point ? PLANE_POINT : PLANE_SECTION;
            ck_assert(plane_predicted_period(&def, &period, &status));
            const double expected = point ? known[k].point : known[k].section;
            if (expected > 0)
                ck_assert_double_eq_tol(period * 1e3, expected, 6e-7);
        }
}
END_TEST

/* Measured over two periods by the least squares of a cosine. */
static double measured_period(const MpmDef *def, double expected)
{
    Simulation *sim = create(def);
    const long steps = lround(2 * expected / sim->dt);
    const int u = simulation_find_series(sim, "u_probe");
    double *record = malloc((size_t)steps * sizeof *record), row[16];
    FrequencyFit fit;
    Status status = {0};
    for (long k = 0; k < steps; k++) {
        advance(sim, 1);
        simulation_row(sim, row);
        record[k] = row[u];
    }
    ck_assert_msg(frequency_fit(record, (size_t)steps, 0, sim->dt, 2 * M_PI / expected, &fit, &status), "%s",
                  status.text);
    free(record);
    simulation_destroy(sim);
    return 2 * M_PI / fit.frequency;
}

/* Over two periods from the relaxed start, or of what else there is from that with velocities. */
START_TEST(the_run_oscillates_as_predicted)
{
    static const struct {
        double length; /* m */
        MpmShape shape;
        MpmAlgorithm algorithm;
        PlaneEnds ends;
        PlaneStart start;
        double amplitude, flip, nu, tolerance;
    } known[] = {
        {.1, MPM_HAT, MPM_USF, PLANE_SECTION, PLANE_DEFLECTION, 3e-6, 1, 1.0 / 3, 1e-6},
        {.1, MPM_HAT, MPM_USF, PLANE_POINT, PLANE_DEFLECTION, 3e-6, 1, 1.0 / 3, 1e-6},
        {.1, MPM_GIMP, MPM_USF, PLANE_SECTION, PLANE_DEFLECTION, 3e-6, 1, 1.0 / 3, 1e-4},
        {.025, MPM_HAT, MPM_MUSL, PLANE_SECTION, PLANE_VELOCITY, 3e-7, 1, 0, 1e-6},
        {.025, MPM_HAT, MPM_USL, PLANE_SECTION, PLANE_VELOCITY, 3e-7, 1, .45, 1e-5},
        {.025, MPM_HAT, MPM_USF, PLANE_SECTION, PLANE_VELOCITY, 3e-7, .999, 1.0 / 3, 1e-5},
    };
    for (size_t k = 0; k < sizeof known / sizeof *known; k += suite_wide() ? 1 : 5) {
        MpmDef def = small(false);
        Status status;
        double period;
        def.length = known[k].length;
        def.shape = known[k].shape;
        def.algorithm = known[k].algorithm;
        def.ends = known[k].ends;
        def.start = known[k].start;
        def.amplitude = known[k].amplitude;
        def.flip_fraction = known[k].flip;
        def.poisson = known[k].nu;
        def.courant = known[k].algorithm == MPM_USL ? 0.5 : 1;
        ck_assert(plane_predicted_period(&def, &period, &status));
        const double measured = measured_period(&def, period);
        ck_assert_msg(fabs(measured / period - 1) < known[k].tolerance,
                      "case %zu: measured %.9g, predicted %.9g, off %.3g", k, measured, period,
                      measured / period - 1);
    }
}
END_TEST

/* A pseudo-random number in [0, 1). */
static double next_share(uint32_t *seed)
{
    *seed = *seed * 1664525u + 1013904223u;
    return *seed / 4294967296.0;
}

/* The start is relaxed by the stress that the mesh itself makes of its shape: alike with every shape
 * function. */
START_TEST(splines_start_as_hats_do)
{
    MpmDef def = small(false);
    double strain[2];
    for (int k = 0; k < 2; k++) {
        def.shape = k ? MPM_BSPLINE2 : MPM_HAT;
        Simulation *sim = create(&def);
        strain[k] = series_now(sim, "strain");
        simulation_destroy(sim);
    }
    ck_assert_msg(fabs(strain[1] / strain[0] - 1) < 0.1, "hats %g, splines %g", strain[0], strain[1]);
}
END_TEST

/* Just below its limit, at a share r = 0.995, a beam keeps the energy of its start but for the ripple of its
 * fastest mode, which is within 1/(1 - r^2) = 100; just above it explodes. The start is so small that boxes
 * stay where the prediction has them. */
static void one_limit(uint32_t seed, int number)
{
    MpmDef def = small(number % 3 == 2);
    def.length = def.cell_size * (3 + floor(8 * next_share(&seed)));
    def.height = def.cell_size * (2 + 2 * floor(2 * next_share(&seed)));
    def.channel = def.leaves_channel ? 3 * def.cell_size : 0;
    def.speed = 0;
    def.end = 1e-2;
    def.particles_per_cell = 2 + (int)(2 * next_share(&seed));
    def.poisson = 0.45 * next_share(&seed);
    def.algorithm = (MpmAlgorithm)(3 * next_share(&seed));
    def.flip_fraction = number % 2 ? 1 : 0.5 + 0.5 * next_share(&seed);
    def.shape = number % 4 == 1 ? MPM_BSPLINE2 : MPM_HAT;
    def.ends = next_share(&seed) < 0.5 ? PLANE_SECTION : PLANE_POINT;
    def.clamp = next_share(&seed) < 0.5 ? CLAMP_FULL : CLAMP_GUIDE;
    def.start = PLANE_VELOCITY;
    def.amplitude = 1e-15;
    Status status = {0};
    double limit;
    ck_assert(plane_courant_limit(&def, &limit, &status));
    for (int above = 0; above < 2; above++) {
        def.courant = limit * (above ? 1.005 : 0.995);
        Simulation *sim = create(&def);
        const double start = series_now(sim, "total");
        const bool lasts = simulation_steps(sim, def.algorithm == MPM_USL ? 8000 : 1500, NULL, NULL, &status);
        const double grown = lasts ? series_now(sim, "total") / start : INFINITY;
        ck_assert_msg(above ? grown > 1000 : grown < 100,
                      "set %d, %s the limit of %.5f (shape %d, algorithm %d, flip %g, P %d, nu %.3f, %s): "
                      "energy times %g",
                      number, above ? "above" : "below", limit, def.shape, def.algorithm, def.flip_fraction,
                      def.particles_per_cell, def.poisson, def.leaves_channel ? "cantilever" : "supported",
                      grown);
        simulation_destroy(sim);
    }
}

START_TEST(the_largest_step)
{
    for (int k = suite_wide() ? 0 : _i % 3; k < 25; k += suite_wide() ? 1 : 3)
        one_limit(1000u + 77u * (uint32_t)(25 * _i + k), 25 * _i + k);
}
END_TEST

START_TEST(known_limits)
{
    static const struct {
        double cell_size, limit;
        int P;
    } known[] = {{1.25e-3, 1.7207, 2}, {1.25e-3, 1.6687, 3}};
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        MpmDef def = plane_default(false);
        Status status;
        double limit;
        def.cell_size = known[k].cell_size;
        def.particles_per_cell = known[k].P;
        ck_assert(plane_courant_limit(&def, &limit, &status));
        ck_assert_double_eq_tol(limit, known[k].limit, 5e-4);
    }
}
END_TEST

/* --- what is kept ---------------------------------------------------------------------------------- */

START_TEST(a_guide_leaves_momentum_alone)
{
    MpmDef def = small(true);
    def.clamp = CLAMP_GUIDE;
    def.grid_velocity =
        def.speed; /* a crossing leaves a node empty, and the little that pulls at it is lost */
    def.shape = MPM_HAT;
    def.flip_fraction = 0.99;
    def.algorithm = (MpmAlgorithm)_i;
    Simulation *sim = create(&def);
    advance(sim, 300);
    double *v = field_now(sim, 0, "vx"), sum = 0, most = 0;
    for (size_t p = 0; p < sim->counts[0]; p++) {
        sum += v[p] - def.speed;
        most = fmax(most, fabs(v[p] - def.speed));
    }
    ck_assert_double_gt(most, 1e-3);
    ck_assert_double_lt(fabs(sum) / (double)sim->counts[0], 1e-13 * def.speed);
    free(v);
    simulation_destroy(sim);
}
END_TEST

START_TEST(a_supported_beam_stays_symmetric)
{
    MpmDef def = small(false);
    def.amplitude = 3e-9;
    Simulation *sim = create(&def);
    advance(sim, 500);
    double *uy = field_now(sim, 0, "uy"), *sxx = field_now(sim, 0, "sxx"), u = 0, s = 0, worst_u = 0,
           worst_s = 0;
    for (size_t row = 0; row < sim->rows; row++)
        for (size_t i = 0; i < sim->columns; i++) {
            const size_t p = row * sim->columns + i, mirror = (row + 1) * sim->columns - 1 - i;
            u = fmax(u, fabs(uy[p]));
            s = fmax(s, fabs(sxx[p]));
            worst_u = fmax(worst_u, fabs(uy[p] - uy[mirror]));
            worst_s = fmax(worst_s, fabs(sxx[p] - sxx[mirror]));
        }
    ck_assert_double_gt(u, 1e-10);
    ck_assert_double_lt(worst_u, 1e-6 * u);
    ck_assert_double_lt(worst_s, 1e-3 * s);
    free(uy);
    free(sxx);
    simulation_destroy(sim);
}
END_TEST

/* E* = sum m v^n v^(n+1)/2 + strain^(n+1). */
START_TEST(the_sharp_invariant)
{
    MpmDef def = small(false);
    def.shape = MPM_HAT;
    def.amplitude = 3e-8;
    Simulation *sim = create(&def);
    double least = INFINITY, most = 0;
    for (int step = 0; step < 400; step++) {
        double *vx = field_now(sim, 0, "vx"), *vy = field_now(sim, 0, "vy"), product = 0;
        advance(sim, 1);
        double *nx = field_now(sim, 0, "vx"), *ny = field_now(sim, 0, "vy"), *m = field_now(sim, 0, "mass");
        for (size_t p = 0; p < sim->counts[0]; p++)
            product += m[p] * (vx[p] * nx[p] + vy[p] * ny[p]) / 2;
        const double energy = product * def.thickness + series_now(sim, "strain");
        least = fmin(least, energy);
        most = fmax(most, energy);
        free(vx), free(vy), free(nx), free(ny), free(m);
    }
    ck_assert_double_lt(most / least - 1, 1e-8);
    simulation_destroy(sim);
}
END_TEST

/* The series' energies are the sums of the particles', each of which has its place in memory. */
START_TEST(energies_of_particles)
{
    MpmDef def = small(_i);
    def.length = 13 * def.cell_size;
    Simulation *sim = create(&def);
    static const char *const names[2][2] = {{"strain_energy", "strain"}, {"kinetic_energy", "kinetic"}};
    advance(sim, 50);
    for (int k = 0; k < 2; k++) {
        double *energy = field_now(sim, 0, names[k][0]), sum = 0;
        for (size_t p = 0; p < sim->counts[0]; p++)
            sum += energy[p];
        ck_assert_double_eq_tol(sum, series_now(sim, names[k][1]), 1e-12 * sum);
        free(energy);
    }
    simulation_destroy(sim);
}
END_TEST

/* kinetic_null against conjugate gradients on the velocities of free nodes, from links alone. */
static double null_by_gradients(Simulation *sim, const MpmDef *def)
{
    enum { LINKS = 9 };
    const size_t np = sim->counts[0], nn = sim->counts[1];
    double *v[2] = {field_now(sim, 0, "vx"), field_now(sim, 0, "vy")}, *m = field_now(sim, 0, "mass"),
           left = 0;
    double *held[2] = {field_now(sim, 1, "held_x"), field_now(sim, 1, "held_y")};
    Link *links = malloc(np * LINKS * sizeof *links);
    size_t *count = malloc(np * sizeof *count);
    for (size_t p = 0; p < np; p++)
        count[p] = sim->method->links(sim, 0, p, links + p * LINKS, LINKS);
    for (int c = 0; c < 2; c++) {
        double *rest = v[c], *direction = calloc(nn, sizeof *direction), *slope = malloc(nn * sizeof *slope);
        double *scale = calloc(nn, sizeof *scale), *image = malloc(np * sizeof *image);
        double before = 0, first = 0, *whole = calloc(nn, sizeof *whole);
        if (c == 0)
            for (size_t p = 0; p < np; p++)
                rest[p] -= def->speed;
        for (size_t p = 0; p < np; p++)
            for (size_t k = 0; k < count[p]; k++) {
                const Link *link = &links[p * LINKS + k];
                scale[link->index] += link->weight * link->weight;
                whole[link->index] += link->weight;
            }
        for (size_t i = 0; i < nn; i++) /* an inactive node */
            if (whole[i] <= 1e-12 * def->particles_per_cell * def->particles_per_cell)
                scale[i] = 0;
        free(whole);
        for (int round = 0; round < 20000; round++) {
            double now = 0, step = 0;
            memset(slope, 0, nn * sizeof *slope);
            for (size_t p = 0; p < np; p++)
                for (size_t k = 0; k < count[p]; k++)
                    slope[links[p * LINKS + k].index] += links[p * LINKS + k].weight * rest[p];
            for (size_t i = 0; i < nn; i++) {
                slope[i] = held[c][i] != 0 || scale[i] == 0 ? 0 : slope[i];
                now += scale[i] == 0 ? 0 : slope[i] * slope[i] / scale[i];
            }
            first = fmax(first, now);
            if (now <= 1e-26 * first)
                break;
            for (size_t i = 0; i < nn; i++)
                direction[i] = (scale[i] == 0 ? 0 : slope[i] / scale[i]) +
                               (before > 0 ? now / before : 0) * direction[i];
            for (size_t p = 0; p < np; p++) {
                image[p] = 0;
                for (size_t k = 0; k < count[p]; k++)
                    image[p] += links[p * LINKS + k].weight * direction[links[p * LINKS + k].index];
                step += image[p] * image[p];
            }
            for (size_t p = 0; p < np; p++)
                rest[p] -= now / step * image[p];
            before = now;
        }
        for (size_t p = 0; p < np; p++)
            left += m[p] * rest[p] * rest[p] / 2;
        free(direction), free(slope), free(scale), free(image);
    }
    free(v[0]), free(v[1]), free(held[0]), free(held[1]), free(m), free(links), free(count);
    return left * def->thickness;
}

START_TEST(what_the_grid_cannot_see)
{
    MpmDef def = small(_i % 2);
    def.shape = _i / 2 ? MPM_GIMP : MPM_HAT;
    def.flip_fraction = 1;
    def.stress = PLANE_EXACT; /* rings */
    Simulation *sim = create(&def);
    for (int k = 0; k < 4; k++) {
        advance(sim, 60);
        const double null = series_now(sim, "kinetic_null"), kinetic = series_now(sim, "kinetic");
        const double expected = null_by_gradients(sim, &def);
        ck_assert_msg(fabs(null - expected) <= 1e-9 * kinetic, "step %ld: %.12g, not %.12g of %.6g",
                      sim->step, null, expected, kinetic);
        ck_assert_double_le(series_now(sim, "kinetic_grid") + null, kinetic * (1 + 1e-12));
    }
    ck_assert_double_gt(series_now(sim, "kinetic_null"), 1e-8 * series_now(sim, "kinetic"));
    simulation_destroy(sim);
}
END_TEST

/* A particle that lands on a node to the last bit leaves an empty node beside it, which must not strain it.
 */
START_TEST(an_empty_node_moves_with_the_beam)
{
    MpmDef def = plane_default(true);
    def.length = 0.01;
    def.channel = 0.005;
    def.cell_size = 0.5e-3;
    def.shape = MPM_HAT;
    def.flip_fraction = 1;
    def.amplitude = 0;
    def.end = 2e-5;
    const MpmDef plain = def;
    for (int steps = 125; steps <= 500; steps *= 2) {
        /* a quarter of a cell after so many steps */
        def.courant = 1;
        def.courant = 0.125e-3 / (def.speed * steps) / mpm_time_step(&def);
        Simulation *sim = create(&def);
        advance(sim, steps + 5);
        ck_assert_double_lt(series_now(sim, "total"), 1e-20);
        simulation_destroy(sim);
        def = plain;
    }
}
END_TEST

/* --- bits ------------------------------------------------------------------------------------------ */

static MpmDef variant(int number)
{
    MpmDef def = small(number % 2);
    def.algorithm = (MpmAlgorithm)(number / 2 % 3);
    def.shape = number / 6 % 2 ? MPM_HAT : MPM_GIMP;
    def.particles_per_cell = 2 + number / 12 % 2;
    def.grid_velocity = def.leaves_channel && number % 5 == 0 ? def.speed : 0;
    if (def.shape == MPM_HAT && def.algorithm == MPM_USL) /* it does not survive the first crossing */
        def.speed = def.grid_velocity = 0;
    return def;
}

enum { VARIANTS = 24 };

static void expect_same_state(const Simulation *a, const Simulation *b, const char *when)
{
    const size_t size = simulation_snapshot_size(a);
    ck_assert_uint_eq(size, simulation_snapshot_size(b));
    unsigned char *of_a = snapshot_now(a), *of_b = snapshot_now(b);
    ck_assert_msg(memcmp(of_a, of_b, size) == 0, "%s: states differ, step %ld stage %d", when, a->step,
                  a->stage);
    free(of_a);
    free(of_b);
}

/* Forwards with rows, without, stage by stage in slices, and again from a snapshot in the middle of a step.
 */
START_TEST(one_run_one_set_of_bits)
{
    const MpmDef def = variant(_i);
    Simulation *straight = create(&def), *watched = create(&def), *sliced = create(&def);
    double rows[40 * 16], row[16];
    long done;
    Status status;
    advance(straight, 40);
    ck_assert(simulation_steps(watched, 40, rows, &done, &status));
    expect_same_state(straight, watched, "watched");
    simulation_row(straight, row);
    ck_assert_int_eq(memcmp(row, rows + 39 * straight->n_series, (size_t)straight->n_series * sizeof *row),
                     0);
    size_t items = 1;
    while (sliced->step < 40) {
        bool stage_done;
        ck_assert(simulation_slice(sliced, items, &stage_done, &status));
        items = items % 5 + 1;
    }
    expect_same_state(straight, sliced, "sliced");
    for (int stage = 0; stage < sliced->n_stages; stage++) {
        unsigned char *bytes = snapshot_now(sliced);
        advance(sliced, 3);
        simulation_restore(sliced, bytes);
        free(bytes);
        ck_assert_int_eq(sliced->stage, stage);
        ck_assert(simulation_stage(sliced, &status));
    }
    advance(straight, 1);
    expect_same_state(straight, sliced, "restored");
    simulation_destroy(straight);
    simulation_destroy(watched);
    simulation_destroy(sliced);
}
END_TEST

/* 5,120 particles, or some less in a last block that is not full: enough for threads. */
static MpmDef wide(int number)
{
    MpmDef def = plane_default(number % 2);
    def.algorithm = (MpmAlgorithm)(number / 2 % 3);
    def.shape = number / 6 ? MPM_HAT : MPM_GIMP;
    def.length = number % 3 ? def.length : 155 * def.cell_size;
    def.end = 1e-4;
    if (def.leaves_channel) {
        def.channel = 0.01;
        def.speed = def.shape == MPM_HAT && def.algorithm == MPM_USL ? 0 : 90;
    }
    return def;
}

enum { WIDE_ONES = 12 };

/* Any number of threads, with rows and without. */
START_TEST(any_threads)
{
    MpmDef def = wide(_i);
    Simulation *first = create(&def);
    double rows[30 * 16], again[30 * 16];
    Status status;
    long done;
    ck_assert(simulation_steps(first, 30, rows, &done, &status));
    for (int threads = 2; threads <= 4; threads++) {
        def.threads = threads;
        Simulation *sim = create(&def);
        ck_assert_ptr_nonnull(mpm_of(sim)->pool);
        ck_assert(simulation_steps(sim, 30, again, &done, &status));
        expect_same_state(first, sim, "by threads");
        ck_assert_int_eq(memcmp(rows, again, 30 * (size_t)sim->n_series * sizeof *rows), 0);
        simulation_destroy(sim);
    }
    simulation_destroy(first);
}
END_TEST

/* A box that begins in the last row of cells has its third node beyond the grid: as with rows to spare. */
START_TEST(beside_the_grids_edge)
{
    MpmDef def = small(false);
    def.shape = MPM_GIMP;
    def.amplitude = .6 * def.cell_size;
    def.padding = 3;
    Simulation *spare = create(&def);
    def.padding = 1;
    def.threads = 1 + _i;
    Simulation *edge = create(&def);
    double expected[16], row[16];
    for (int step = 0; step < 20; step++) {
        simulation_row(spare, expected);
        simulation_row(edge, row);
        for (int k = 0; k < spare->n_series; k++)
            if (isfinite(expected[k]))
                ck_assert_msg(fabs(row[k] - expected[k]) <= 1e-9 * fabs(expected[k]) + 1e-12,
                              "%s is %.12g and not %.12g at step %d", spare->series[k].name, row[k],
                              expected[k], step);
        advance(spare, 1);
        advance(edge, 1);
    }
    simulation_destroy(spare);
    simulation_destroy(edge);
}
END_TEST

/* Who looks at some columns only gets the others alike, and the last row whole. */
START_TEST(rows_that_are_spared)
{
    const MpmDef def = small(_i);
    Simulation *whole = create(&def), *spared = create(&def);
    double rows[20 * 16], again[20 * 16];
    Status status;
    long done;
    const int null = simulation_find_series(whole, "kinetic_null"), n = whole->n_series;
    spared->spares_rows = true;
    ck_assert(simulation_steps(whole, 20, rows, &done, &status));
    ck_assert(simulation_steps(spared, 20, again, &done, &status));
    for (int k = 0; k < 20 * n; k++)
        if (k % n == null && k / n != 19)
            ck_assert(isnan(again[k]));
        else
            ck_assert_double_eq(again[k], rows[k]);
    expect_same_state(whole, spared, "spared");
    simulation_destroy(whole);
    simulation_destroy(spared);
}
END_TEST

/* Columns that are left out change no other, and no bit of the run. */
START_TEST(columns_that_are_left_out)
{
    const MpmDef def = small(_i);
    Simulation *whole = create(&def), *bare = create(&def);
    double rows[20 * 16], again[20 * 16];
    Status status;
    simulation_ask_columns(bare, "");
    ck_assert_int_eq(bare->n_series, whole->n_series - 6);
    ck_assert_int_eq(simulation_find_series(bare, "kinetic_grid"), -1);
    ck_assert(simulation_steps(whole, 19, rows, NULL, &status));
    ck_assert(simulation_steps(bare, 19, again, NULL, &status));
    simulation_row(whole, rows + 19 * whole->n_series);
    simulation_row(bare, again + 19 * bare->n_series);
    for (int i = 0; i < bare->n_series; i++) {
        const int other = simulation_find_series(whole, bare->series[i].name);
        for (int row = 0; row < 20; row++)
            ck_assert_double_eq(again[row * bare->n_series + i], rows[row * whole->n_series + other]);
    }
    expect_same_state(whole, bare, "bare");
    simulation_destroy(whole);
    simulation_destroy(bare);
}
END_TEST

/* A beam bent like a bow: nodes of neighbours do not stand side by side any more, and some particles are so
 * far from the others of their block that they give to the grid by themselves. */
static MpmDef bow(int number)
{
    MpmDef def = small(false);
    def.length = 13 * def.cell_size;
    def.shape = number % 2 ? MPM_HAT : MPM_GIMP;
    def.algorithm = (MpmAlgorithm)(number / 2 % 3);
    def.amplitude = 0.01;
    def.padding = 12;
    def.stress = PLANE_EXACT;
    def.courant = 1e-4;
    return def;
}

START_TEST(bits_of_a_bow)
{
    MpmDef def = bow(_i);
    Simulation *first = create(&def);
    Status status;
    for (int step = 0; step < 20; step++)
        do
            ck_assert(simulation_stage(first, &status));
        while (first->stage > 0);
    for (int threads = 1; threads <= 3; threads++) {
        def.threads = threads;
        Simulation *sim = create(&def);
        advance(sim, 20);
        expect_same_state(first, sim, "by threads");
        simulation_destroy(sim);
    }
    simulation_destroy(first);
}
END_TEST

/* The cells of all particles, by the definition: floor((x - xmin)/dx) in both directions. */
static void cells_of(Simulation *sim, int *cells)
{
    const Mpm *plane = mpm_of_const(sim);
    double *x = field_now(sim, 0, "x"), *y = field_now(sim, 0, "y");
    for (int p = 0; p < plane->n_particles; p++)
        cells[p] = (int)floor((y[p] - plane->ymin) / plane->dx) * plane->gx +
                   (int)floor((x[p] - (plane->xmin + mpm_shift(plane, sim->step) * plane->dx)) / plane->dx);
    free(x);
    free(y);
}

/* The first crossing of each particle is an event, one a step, by every way through the steps. A supported
 * beam begins bent by more than a cell. */
START_TEST(crossings_are_told)
{
    enum { STEPS = 90 };
    const bool leaves = _i < 4;
    MpmDef def = plane_default(leaves);
    def.cell_size = 1.25e-3;
    def.amplitude = leaves ? def.amplitude : 1.6e-3;
    def.length = .025;
    def.channel = leaves ? 5e-3 : 0;
    def.speed = leaves ? 40 : 0;
    def.end = 1e-4;
    def.shape = _i == 2 ? MPM_BSPLINE2 : _i % 2 ? MPM_GIMP : MPM_HAT;
    def.algorithm = _i < 2 ? MPM_USF : MPM_MUSL;
    Simulation *sim = create(&def), *fast = create(&def);
    const int n = mpm_of(sim)->n_particles;
    int *before = calloc((size_t)n, sizeof *before), *after = calloc((size_t)n, sizeof *after);
    bool *crossed = calloc((size_t)n, sizeof *crossed);
    Status status;
    int told = 0;
    for (int step = 0; step < STEPS; step++) {
        int count = 0, first = -1;
        bool stage_done;
        cells_of(sim, before);
        do
            ck_assert(simulation_slice(sim, 3, &stage_done, &status));
        while (sim->stage != 0 || sim->item != 0);
        cells_of(sim, after);
        for (int p = 0; p < n; p++)
            if (before[p] != after[p] && !crossed[p]) {
                crossed[p] = true;
                first = count++ == 0 ? p : first;
            }
        ck_assert_int_eq(sim->n_events, told + (count > 0));
        if (count == 0)
            continue;
        const Event *event = &sim->events[told++];
        char text[120];
        int used = snprintf(text, sizeof text, "particle %d crossed into cell (%d, %d)", first,
                            after[first] % mpm_of(sim)->gx, after[first] / mpm_of(sim)->gx);
        if (count > 1)
            snprintf(text + used, sizeof text - (size_t)used, ", %d others with it", count - 1);
        ck_assert_int_eq(event->kind, EVENT_CROSSING);
        ck_assert_int_eq(event->step, step + 1);
        ck_assert_str_eq(event->text, text);
    }
    ck_assert_int_gt(told, 1);
    ck_assert(simulation_steps(fast, STEPS, NULL, NULL, &status));
    ck_assert_int_eq(fast->n_events, told);
    for (int k = 0; k < told; k++)
        ck_assert_str_eq(fast->events[k].text, sim->events[k].text);
    expect_same_state(sim, fast, "whole steps");
    if (leaves) {
        def.grid_velocity = def.speed;
        Simulation *riding = create(&def);
        ck_assert(simulation_steps(riding, STEPS, NULL, NULL, &status));
        ck_assert_int_eq(riding->n_events, 0);
        simulation_destroy(riding);
    }
    simulation_destroy(fast);
    simulation_destroy(sim);
    free(before);
    free(after);
    free(crossed);
}
END_TEST

/* A node takes 14 numbers: a beam ten cells high has 0.38 of them for a particle, one of forty cells 0.28. */
START_TEST(memory_of_a_beam)
{
    static const struct {
        double cell_size;
        MpmShape shape;
        double most;
    } known[] = {{.5e-3, MPM_HAT, 230}, {.5e-3, MPM_GIMP, 230}, {.125e-3, MPM_GIMP, 200}};
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        MpmDef def = plane_default(false);
        def.cell_size = known[k].cell_size;
        def.shape = known[k].shape;
        Simulation *sim = create(&def);
        const double bytes = (double)mpm_of_const(sim)->bytes_memory / (double)sim->counts[0];
        ck_assert_msg(bytes <= known[k].most, "%.0f bytes for each of %zu particles", bytes, sim->counts[0]);
        simulation_destroy(sim);
    }
}
END_TEST

START_TEST(live_parameters)
{
    MpmDef def = small(true);
    Simulation *sim = create(&def);
    Status status;
    advance(sim, 10);
    unsigned char *bytes = snapshot_now(sim);
    ck_assert_int_eq(sim->n_stages, 7);
    ck_assert(sim->method->change(sim, "mpm.algorithm", MPM_MUSL, &status));
    ck_assert_int_eq(sim->n_stages, 9);
    ck_assert(sim->method->change(sim, "mpm.flip_fraction", 0.5, &status));
    ck_assert(!sim->method->change(sim, "mpm.shape", 1, &status));
    advance(sim, 1);
    simulation_restore(sim, bytes);
    ck_assert_int_eq(sim->n_stages, 7);
    free(bytes);
    simulation_destroy(sim);
}
END_TEST

/* --- what is told of a stage ------------------------------------------------------------------------ */

static void expect_words(const Simulation *sim, int set, size_t index)
{
    char text[4000];
    sim->method->explain(sim, sim->stage - 1, set, index, NULL, 0, text, sizeof text);
    ck_assert_msg(strlen(text) > 10 && !strstr(text, "nan"), "stage %d: %s", sim->stage, text);
    ck_assert_int_eq(text[strlen(text) - 1], '\n');
}

START_TEST(stages_are_told)
{
    static const double flips[] = {1, 0.5, 0};
    MpmDef def = _i < VARIANTS ? variant(_i) : bow(_i - VARIANTS);
    Status status;
    def.flip_fraction = flips[_i % 3];
    Simulation *sim = create(&def);
    advance(sim, 10);
    for (int stages = sim->n_stages; stages > 1; stages--) {
        ck_assert(simulation_stage(sim, &status));
        Link link;
        expect_words(sim, 0, sim->counts[0] / 2);
        ck_assert_uint_eq(sim->method->links(sim, 0, sim->counts[0] / 2, &link, 1), 1);
        expect_words(sim, 1, link.index);
        expect_words(sim, 1, 0); /* empty */
    }
    simulation_destroy(sim);
}
END_TEST

/* --- ends ------------------------------------------------------------------------------------------ */

/* The run stands at its last sound step, and says what happened. */
static void expect_failure(const MpmDef *def, long steps, const char *words)
{
    Simulation *sim = create(def);
    Status status = {0};
    long done;
    ck_assert(!simulation_steps(sim, steps, NULL, &done, &status));
    ck_assert_msg(strstr(status.text, words) != NULL, "%s", status.text);
    ck_assert_int_eq(sim->stage, 0);
    ck_assert_int_eq(sim->step, done);
    const double energy = series_now(sim, "total");
    ck_assert(isfinite(energy));
    simulation_destroy(sim);
}

START_TEST(runs_that_fail)
{
    MpmDef def = small(false);
    def.courant = 1.75;
    def.amplitude = 1e-12;
    expect_failure(&def, 1000, "the energy has grown");
    def.courant = 20;
    expect_failure(&def, 1000, "step ");
    def = small(true);
    def.amplitude = 0;
    def.end = 1e-6;
    expect_failure(&def, 2000, "left the grid");
    def = small(true); /* the first particle to enter a cell is all that its far nodes have */
    def.shape = MPM_HAT;
    def.algorithm = MPM_USL;
    expect_failure(&def, 100, "crushed");
}
END_TEST

START_TEST(definitions_that_are_refused)
{
    Status status;
#define REFUSED(change, key)                                                                                 \
    do {                                                                                                     \
        MpmDef def = small(true);                                                                            \
        change;                                                                                              \
        ck_assert(!mpm_check(&def, &status));                                                                \
        ck_assert_msg(strncmp(status.text, key ":", strlen(key) + 1) == 0, "%s", status.text);               \
    } while (0)
    REFUSED(def.cell_size = 1e-3, "mesh.cell_size");   /* five cells high */
    REFUSED(def.cell_size = 1.3e-3, "mesh.cell_size"); /* no whole number */
    REFUSED(def.channel = 0.0095, "mesh.cell_size");
    REFUSED(def.channel = 0.005, "motion.channel");
    REFUSED(def.grid_velocity = 91, "mesh.velocity");
    REFUSED(def.particles_per_cell = 1, "mesh.particles_per_cell");
    REFUSED(def.padding = 0, "mesh.padding");
    REFUSED(def.shape = MPM_BSPLINE3, "mpm.shape");
    REFUSED((def.length = 100, def.channel = 100), "mesh.cell_size");
    REFUSED((def.height = 20, def.length = 1.25e-3, def.channel = 2.5e-3, def.end = 1e-6), "mesh.cell_size");
    REFUSED(def.courant = 1e20, "mesh.padding"); /* its one step goes far beyond the end */
    MpmDef bent = small(false);
    bent.amplitude = 0.01;
    ck_assert_ptr_null(mpm_create(&bent, &status));
    ck_assert_msg(strstr(status.text, "initial.amplitude") != NULL, "%s", status.text);
}
END_TEST

/* Of every particle of a bent beam, where shear is more than the rest in some. */
START_TEST(von_mises_has_its_shear)
{
    const MpmDef def = small(false);
    Simulation *sim = create(&def);
    Status status;
    ck_assert(simulation_steps(sim, 20, NULL, NULL, &status));
    double *xx = field_now(sim, 0, "sxx"), *yy = field_now(sim, 0, "syy"), *xy = field_now(sim, 0, "sxy"),
           *mises = field_now(sim, 0, "mises"), most = 0;
    for (size_t p = 0; p < sim->counts[0]; p++) {
        const double squares = xx[p] * xx[p] + yy[p] * yy[p] - xx[p] * yy[p], shear = 3 * xy[p] * xy[p];
        ck_assert_double_eq_tol(mises[p], sqrt(squares + shear), 1e-12 * mises[p]);
        most = fmax(most, shear / (squares + shear));
    }
    ck_assert_double_gt(most, 0.1);
    free(xx), free(yy), free(xy), free(mises);
    simulation_destroy(sim);
}
END_TEST

/* With `jaumann` the stress before a strain turns with its particle: tan(theta/2) = dt (dv/dx - du/dy)/4,
 * stress <- Q stress Q^T, of which the rest is that of `none`. */
START_TEST(the_stress_turns_with_its_particle)
{
    static const char *const names[3] = {"sxx", "syy", "sxy"};
    MpmDef def = small(false);
    def.amplitude = 1e-3;
    def.shape = _i % 2 ? MPM_GIMP : MPM_BSPLINE2;
    def.rotation = ROTATION_NONE;
    Simulation *none = create(&def);
    def.rotation = ROTATION_JAUMANN;
    Simulation *turns = create(&def);
    Status status;
    advance(none, 40);
    unsigned char *bytes = snapshot_now(none);
    simulation_restore(turns, bytes);
    double *before[3], *after[3], *turned[3], most = 0, change = 0;
    for (int k = 0; k < 3; k++)
        before[k] = field_now(none, 0, names[k]);
    for (int stage = 0; stage < 3; stage++)
        ck_assert(simulation_stage(none, &status) && simulation_stage(turns, &status));
    ck_assert_str_eq(turns->stages[2].id, "strain");
    ck_assert_ptr_nonnull(strstr(turns->stages[2].equation, "Q σ Qᵀ"));
    ck_assert_ptr_null(strstr(none->stages[2].equation, "Q σ"));
    double *v[2] = {field_now(none, 1, "vx"), field_now(none, 1, "vy")};
    for (int k = 0; k < 3; k++) {
        after[k] = field_now(none, 0, names[k]);
        turned[k] = field_now(turns, 0, names[k]);
        for (size_t p = 0; p < none->counts[0]; p++)
            most = fmax(most, fabs(before[k][p]));
    }
    for (size_t p = 0; p < none->counts[0]; p++) {
        Link links[16];
        const size_t count = none->method->links(none, 0, p, links, 16);
        double spin = 0;
        for (size_t i = 0; i < count; i++)
            spin += links[i].gradient[0] * v[1][links[i].index] - links[i].gradient[1] * v[0][links[i].index];
        const double theta = 2 * atan(none->dt * spin / 4), c = cos(theta), s = sin(theta);
        const double xx = before[0][p], yy = before[1][p], xy = before[2][p];
        const double Q[3] = {c * c * xx + s * s * yy - 2 * c * s * xy,
                             s * s * xx + c * c * yy + 2 * c * s * xy,
                             c * s * (xx - yy) + (c * c - s * s) * xy};
        for (int k = 0; k < 3; k++) {
            ck_assert_double_eq_tol(turned[k][p] - after[k][p], Q[k] - before[k][p], 1e-14 * most);
            change = fmax(change, fabs(Q[k] - before[k][p]));
        }
    }
    ck_assert_double_gt(change, 1e-5 * most);
    for (int k = 0; k < 3; k++)
        free(before[k]), free(after[k]), free(turned[k]);
    free(v[0]), free(v[1]), free(bytes);
    simulation_destroy(none);
    simulation_destroy(turns);
}
END_TEST

/* USF takes the strain before it integrates: what is told of its velocities later in the step is the same. */
START_TEST(velocities_that_strained)
{
    const MpmDef def = small(false);
    Simulation *sim = create(&def);
    Status status;
    ck_assert(simulation_steps(sim, 20, NULL, NULL, &status));
    const Mpm *mpm = mpm_of_const(sim);
    const int node = (int)sim->counts[1] / 2;
    while (!mpm_has_done(mpm, OP_STRAIN))
        ck_assert(simulation_stage(sim, &status));
    const double before[2] = {mpm->velocity[0][node], mpm->velocity[1][node]};
    while (!mpm_has_done(mpm, OP_INTEGRATE))
        ck_assert(simulation_stage(sim, &status));
    for (int axis = 0; axis < 2; axis++)
        ck_assert_double_eq(mpm->velocity[axis][node], before[axis]);
    simulation_destroy(sim);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *test = tcase_create("plane");
    tcase_add_test(test, von_mises_has_its_shear);
    tcase_add_test(test, velocities_that_strained);
    tcase_add_loop_test(test, the_stress_turns_with_its_particle, 0, 2);
    tcase_add_test(test, predicted_periods);
    tcase_add_test(test, the_run_oscillates_as_predicted);
    tcase_add_test(test, splines_start_as_hats_do);
    tcase_add_loop_test(test, the_largest_step, 0, 4);
    tcase_add_test(test, known_limits);
    tcase_add_loop_test(test, a_guide_leaves_momentum_alone, 0, 3);
    tcase_add_test(test, a_supported_beam_stays_symmetric);
    tcase_add_test(test, the_sharp_invariant);
    tcase_add_loop_test(test, energies_of_particles, 0, 2);
    tcase_add_loop_test(test, what_the_grid_cannot_see, 0, 4);
    tcase_add_test(test, an_empty_node_moves_with_the_beam);
    tcase_add_loop_test(test, one_run_one_set_of_bits, 0, VARIANTS);
    tcase_add_loop_test(test, beside_the_grids_edge, 0, 2);
    tcase_add_loop_test(test, any_threads, 0, WIDE_ONES);
    tcase_add_loop_test(test, rows_that_are_spared, 0, 2);
    tcase_add_loop_test(test, columns_that_are_left_out, 0, 2);
    tcase_add_loop_test(test, bits_of_a_bow, 0, 6);
    tcase_add_test(test, memory_of_a_beam);
    tcase_add_loop_test(test, crossings_are_told, 0, 6);
    tcase_add_test(test, live_parameters);
    tcase_add_loop_test(test, stages_are_told, 0, VARIANTS + 6);
    tcase_add_test(test, runs_that_fail);
    tcase_add_test(test, definitions_that_are_refused);
    suite_add_tcase(suite, test);
}
