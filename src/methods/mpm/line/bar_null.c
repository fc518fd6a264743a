/* SPDX-License-Identifier: GPL-3.0-or-later */
/* kinetic_null, the energy that no nodal velocities can represent (bar_null.h): least squares by Givens
 * rotations, row by row in the order of the particles. Part of the row of a step.
 *
 * A particle brings the row (N_1 .. N_b | v), which is turned against the rows of a triangle until nothing is
 * left of it but a number on the right: its square belongs to the minimum. Rotations are done without roots
 * (Gentleman 1973): a row is kept as its diagonal's square d and the rest over the diagonal r, the new row
 * has a weight w, at first 1, and for each of its entries x in turn
 *
 *     d' = d + w x^2    c = d/d'    g = w x/d'    w' = c w
 *     of what stands right of it   y' = y - x r    r' = c r + g y
 *
 * A row that is empty (d = 0) takes the new one whole: c = 0, and nothing is left of it. So no pivot is too
 * small until its square leaves the range of a double, and no tolerance says which one would be. As particles
 * are in order, a triangle's row is complete when their cells have passed it: only as many rows are kept as a
 * cell has nodes. */
#include "methods/mpm/line/bar_null.h"
#include "base/assertion.h"
#include "methods/mpm/line/kernels/shape.h"

/* Numbers whose squares would leave a double's range are as good as 0 beside others of order 1. */
static const double too_small = 1e-280;

/* One particle: its row x (support entries, overwritten) and right-hand side v against the rows of the
 * triangle. */
static inline void add_row(BarNull *null, const int support, double *x, double v)
{
    double w = 1.0;
#pragma GCC unroll 4
    for (int a = 0; a < support; a++) {
        const double first = x[a], whole = null->weight[a] + w * (first * first);
        if (!(whole > too_small))
            continue;
        const double inverse = 1.0 / whole, keep = null->weight[a] * inverse, gain = w * first * inverse;
        null->weight[a] = whole;
        w *= keep;
#pragma GCC unroll 4
        for (int k = a + 1; k < support; k++) {
            const double before = x[k], row = null->above[a][k];
            x[k] = before - first * row;
            null->above[a][k] = keep * row + gain * before;
        }
        const double before = v, row = null->value[a];
        v = before - first * row;
        null->value[a] = keep * row + gain * before;
    }
    null->sum += w * (v * v);
}

/* On to the next cell, whose first node was this one's second: the complete first row of the triangle is
 * dropped, an empty last one comes in. */
static inline void shift(BarNull *null, const int support)
{
#pragma GCC unroll 4
    for (int a = 0; a + 1 < support; a++) {
        null->weight[a] = null->weight[a + 1];
        null->value[a] = null->value[a + 1];
#pragma GCC unroll 4
        for (int k = a + 1; k + 1 < support; k++)
            null->above[a][k] = null->above[a + 1][k + 1];
        null->above[a][support - 1] = 0.0;
    }
    null->weight[support - 1] = null->value[support - 1] = 0.0;
}

/* Cells up to `end`, for any shape: each particle's row is N at its nodes, 0 at those that are held or
 * inactive. */
static inline void add_cells(const Bar *bar, BarNull *null, const MpmShape shape, int end)
{
    const int support = shape_support(shape);
    const double root_of_second = sqrt(bar->joint_weight);
    BarNull local = *null;
    for (int c = null->next; c < end; c++) {
        double free[BAR_SUPPORT_MAX];
        for (int a = 0; a < support; a++)
            free[a] = bar_node_moves(bar, c + a) ? 1.0 : 0.0;
        const int count = bar->first[c + 1] - bar->first[c];
        int j = bar->first[c] % bar->slots, k = bar->first[c] / bar->slots;
        for (int i = 0; i < count; i++) {
            double n[BAR_SUPPORT_MAX], slope[BAR_SUPPORT_MAX];
            const double half = shape == MPM_CPDI ? bar->half[j][k] : bar->gimp_half;
            shape_at(shape, half, bar->n_cells, c, bar->s[j][k], n, slope);
            /* the rows of the second material weigh more or less in the sum of squares */
            const double root = bar->first[c] + i < bar->joint ? 1.0 : root_of_second;
            for (int a = 0; a < support; a++)
                n[a] *= root * free[a];
            add_row(&local, support, n, root * bar->v[j][k]);
            if (++j == bar->slots)
                j = 0, k++;
        }
        shift(&local, support);
    }
    local.next = end > null->next ? end : null->next;
    *null = local;
}

/* On to cell `end` as far as nodes are mapped: a node's activity is known only when all its cells have been.
 */
void bar_null_add(const Bar *bar, BarNull *null, int end)
{
    ASSERT_INT(end, <=, bar->n_cells);
    const int mapped = end == bar->n_cells ? end : end - bar->support + 1;
    switch (bar->def.shape) {
    case MPM_HAT:
        add_cells(bar, null, MPM_HAT, mapped);
        return;
    case MPM_GIMP:
        add_cells(bar, null, MPM_GIMP, mapped);
        return;
    case MPM_CPDI:
        add_cells(bar, null, MPM_CPDI, mapped);
        return;
    case MPM_BSPLINE2:
        add_cells(bar, null, MPM_BSPLINE2, mapped);
        return;
    case MPM_BSPLINE3:
        add_cells(bar, null, MPM_BSPLINE3, mapped);
        return;
    }
}

/* K_0 = m/2 times the sum of squares, in units of energy per cross-section. */
double bar_null_energy(const Bar *bar, const BarNull *null)
{
    return 0.5 * bar->mass * null->sum;
}
