/* SPDX-License-Identifier: GPL-3.0-or-later */
/* K_0, the kinetic energy that the grid cannot see, against plain rotations row by row: particles anywhere in
 * their cells, on nodes, upon each other, and cells that decide next to nothing. */
#include "methods/bar_case.h"
#include "methods/mpm/engine.h"
#include "suite.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>

/* The definition: rows N_1 .. N_b | v against an upper band, one after the other. */
static double reference(const Mpm *mpm)
{
    const int support = mpm->support;
    double band[SHAPE_SUPPORT_MAX][SHAPE_SUPPORT_MAX + 1] = {{0}}, sum = 0;
    for (int p = 0, node = 0; p < mpm->n_particles; p++) {
        double row[SHAPE_SUPPORT_MAX + 1] = {0}, slope[SHAPE_SUPPORT_MAX];
        for (; node < mpm->base[p]; node++)
            for (int a = 0; a < support; a++)
                for (int b = a; b <= support; b++) {
                    const bool inside = a + 1 < support && b + 1 < support;
                    band[a][b] = inside ? band[a + 1][b + 1] : 0;
                    if (b == support)
                        band[a][b] = a + 1 < support ? band[a + 1][b] : 0;
                }
        shape_at(mpm->shape, mpm_half(mpm, p), mpm->cells, node, mpm->s[0][p], row, slope);
        for (int a = 0; a < support; a++)
            if (mpm->inverse[node + a] == 0.0 || mpm_held(mpm, 0, node + a))
                row[a] = 0;
        row[support] = mpm->v[0][p];
        for (int a = 0; a < support; a++) {
            const double root = hypot(band[a][a], row[a]);
            if (root < 1e-140)
                continue;
            const double cosine = band[a][a] / root, sine = row[a] / root;
            for (int b = a; b <= support; b++) {
                const double above = band[a][b];
                band[a][b] = cosine * above + sine * row[b];
                row[b] = cosine * row[b] - sine * above;
            }
        }
        sum += row[support] * row[support];
    }
    return 0.5 * mpm->mass[0] * sum;
}

static double uniform(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (double)(*state >> 11) * 0x1p-53;
}

enum {
    AS_MADE,
    ANYWHERE,
    ON_NODES,
    NEAR_NODES,
    TOGETHER,
    BEFORE_NODES,
    FROM_THE_MIDDLE,
    SOME_ON_NODES,
    PLACES
};

static double place(int how, int cell, int cells, double before, uint64_t *state)
{
    const double any = uniform(state);
    switch (how) {
    case ANYWHERE:
        return any;
    case ON_NODES:
        return 0;
    case NEAR_NODES:
        return any * 1e-12;
    case TOGETHER:
        return 0.3 + 1e-3 * any;
    case BEFORE_NODES:
        return 1 - 1e-3 * any;
    case FROM_THE_MIDDLE: /* the middle's node is all but free of its neighbours' */
        return cell < cells / 2 ? 1e-3 * any : 1 - 1e-3 * any;
    case SOME_ON_NODES:
        return any < 0.1 ? 0 : any;
    default:
        return before;
    }
}

/* Two sums of squares agree if what is squared does, to round-off of the whole; where particles are nearly
 * upon each other, nodal velocities are a thousand times theirs. */
static void expect_null(Simulation *sim, int how)
{
    const Mpm *mpm = mpm_of_const(sim);
    const int column = simulation_find_series(sim, "kinetic_null");
    double row[SIMULATION_SERIES_MAX];
    simulation_row(sim, row);
    const double all = row[simulation_find_series(sim, "kinetic")], expected = reference(mpm);
    const double off = fabs(sqrt(row[column]) - sqrt(expected)), allowed = how < TOGETHER ? 1e-14 : 1e-11;
    ck_assert_msg(off <= allowed * sqrt(all), "places %d, P %d, %d cells: K_0 is %.17g, not %.17g, of %g",
                  how, mpm->def.particles_per_cell, mpm->cells, row[column], expected, all);
}

static int ascending(const void *left, const void *right)
{
    const double a = *(const double *)left, b = *(const double *)right;
    return (a > b) - (a < b);
}

/* All shapes and supports, 1 to 5 particles per cell. */
static BarCase bar_of_number(int number, double length)
{
    BarCase bar = bar_case(1, 1.0);
    bar.def.shape = (MpmShape)(number % 4);
    bar.def.particles_per_cell = 1 + number / 4 % 5;
    bar.def.supports = (BarSupports)(number / 20);
    bar.def.length = length;
    bar.def.padding = number % 3 * 7;
    return bar;
}

/* Whether K_0 is more than round-off there: wider shapes on one point of each cell hang together by a thread.
 */
static bool is_defined(const MpmDef *def, int how)
{
    return def->shape == MPM_HAT || how <= ANYWHERE;
}

START_TEST(particles_anywhere)
{
    static const double lengths[] = {1, 2, 7, 8, 40, 65, 700, 1200};
    uint64_t state = (uint64_t)_i;
    for (size_t l = 0; l < sizeof lengths / sizeof lengths[0]; l++)
        for (int how = 0; how < PLACES; how++) {
            BarCase which = bar_of_number(_i, lengths[l]);
            if (!is_defined(&which.def, how))
                continue;
            Simulation *sim = bar_case_create(&which);
            Mpm *mpm = mpm_of(sim);
            const int P = mpm->def.particles_per_cell;
            for (int first = 0; first < mpm->n_particles; first += P) {
                double places[8];
                for (int j = 0; j < P; j++) {
                    const double r = mpm->rest[0][first + j] - mpm->edge;
                    places[j] = place(how, first / P, (int)lengths[l], r - floor(r), &state);
                    mpm->v[0][first + j] = uniform(&state) - 0.5;
                }
                qsort(places, (size_t)P, sizeof *places, ascending); /* in their order, as they always are */
                for (int j = 0; j < P; j++)
                    mpm->u[0][first + j] =
                        (first / P + mpm->origin + places[j] + mpm->edge - mpm->rest[0][first + j]) * mpm->dx;
            }
            ck_assert(mpm_find_all(mpm));
            expect_null(sim, how);
            simulation_destroy(sim);
        }
}
END_TEST

/* Cells with more and fewer particles than they were made with, and nearly empty ones. */
START_TEST(after_crossings)
{
    BarCase which = bar_of_number(_i, 300);
    which.def.transfer = MPM_FLIP;
    which.def.padding = 16;
    which.modes[0].number = 20;
    which.modes[0].velocity = 1.5;
    Simulation *sim = bar_case_create(&which);
    for (int k = 0; k < 8; k++) {
        advance(sim, 20);
        expect_null(sim, -1);
    }
    ck_assert_int_gt(sim->n_events, 0);
    simulation_destroy(sim);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *test = tcase_create("null space");
    tcase_add_loop_test(test, particles_anywhere, 0, 80);
    tcase_add_loop_test(test, after_crossings, 0, 80);
    suite_add_tcase(suite, test);
}
