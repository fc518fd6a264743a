/* SPDX-License-Identifier: GPL-3.0-or-later */
/* K_0, the kinetic energy that the grid cannot see, against plain rotations row by row: particles anywhere in
 * their cells, on nodes, upon each other, and cells that decide next to nothing. */
#include "methods/bar_case.h"
#include "methods/mpm/line/bar_state.h"
#include "methods/mpm/line/kernels/bar_kernels.h"
#include "methods/mpm/line/kernels/shape.h"
#include "suite.h"

#include <float.h>
#include <math.h>
#include <stdint.h>

/* The definition: rows N_1 .. N_b | v against an upper band, one after the other. */
static double reference(const Bar *bar)
{
    const int support = bar->support;
    double band[BAR_SUPPORT_MAX][BAR_SUPPORT_MAX + 1] = {{0}}, sum = 0;
    for (int c = 0; c < bar->n_cells; c++) {
        for (int p = bar->first[c]; p < bar->first[c + 1]; p++) {
            double row[BAR_SUPPORT_MAX + 1] = {0}, slope[BAR_SUPPORT_MAX];
            const int j = p % bar->slots, k = p / bar->slots;
            shape_at(bar->def.shape, bar_half(bar, p), bar->n_cells, c, bar->s[j][k], row, slope);
            for (int a = 0; a < support; a++)
                if (bar->node_inverse[c + a] == 0.0 || bar_node_is_fixed(bar, c + a))
                    row[a] = 0;
            row[support] = bar->v[j][k];
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
        for (int a = 0; a < support; a++)
            for (int b = a; b <= support; b++) {
                const bool inside = a + 1 < support && b + 1 < support;
                band[a][b] = inside ? band[a + 1][b + 1] : 0;
                if (b == support)
                    band[a][b] = a + 1 < support ? band[a + 1][b] : 0;
            }
    }
    return 0.5 * bar->mass * sum;
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
    BY_NODES,
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
    case BY_NODES:
        return 1e-160;
    case NEAR_NODES:
        return any * 1e-60;
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
    Bar *bar = bar_of(sim);
    const int column = simulation_find_series(sim, "kinetic_null");
    double row[BAR_SERIES], other[BAR_SERIES];
    simulation_row(sim, row);
    const double all = row[simulation_find_series(sim, "kinetic")], expected = reference(bar);
    const double off = fabs(sqrt(row[column]) - sqrt(expected)), allowed = how < TOGETHER ? 1e-14 : 1e-11;
    ck_assert_msg(off <= allowed * sqrt(all), "places %d, P %d, %d cells: K_0 is %.17g, not %.17g, of %g",
                  how, bar->slots, bar->n_cells, row[column], expected, all);
    for (int level = CPU_PLAIN; level <= CPU_AVX512; level++)
        if (cpu_has((CpuLevel)level)) {
            bar_use_kernels(sim, (CpuLevel)level);
            simulation_row(sim, other);
            ck_assert_mem_eq(row, other, sizeof row);
        }
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
static bool is_defined(const BarDef *def, int how)
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
            Bar *bar = bar_of(sim);
            for (int c = 0; c < bar->n_cells; c++)
                for (int p = bar->first[c]; p < bar->first[c + 1]; p++) {
                    double *s = &bar->s[p % bar->slots][p / bar->slots];
                    *s = place(how, c - bar->origin, (int)lengths[l], *s, &state);
                    bar->v[p % bar->slots][p / bar->slots] = uniform(&state) - 0.5;
                }
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
