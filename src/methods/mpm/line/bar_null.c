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
 * cell has nodes.
 *
 * That is for the wider shapes. Hats go faster in pairs of cells (kernels_null.h); what is here of them is
 * for the few cells and pairs that are not like the others. */
#include "methods/mpm/line/bar_null.h"
#include "methods/mpm/line/kernels/bar_kernels.h"
#include "methods/mpm/line/kernels/shape.h"

/* Numbers whose squares would leave a double's range are as good as 0 beside others of order 1. */
static const double too_small = 1e-280;

/* One particle: its row x (support entries, overwritten) and right-hand side v against the rows of the
 * triangle. */
static inline void add_row(BarNullBand *null, const int support, double *x, double v)
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
static inline void shift(BarNullBand *null, const int support)
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
    BarNullBand local = null->band;
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
    null->next = end > null->next ? end : null->next;
    null->band = local;
}

/* Whether cells go in pairs. A short bar is done sooner cell by cell; with one particle a cell the products
 * of many joined cells would leave the range of a double, and there is nothing to be found: as many particles
 * as nodes can hide nothing. Of two materials the pairs know nothing. */
static bool goes_in_pairs(const Bar *bar)
{
    enum { SHORT = 128 };
    return bar->def.shape == MPM_HAT && bar->slots > 1 && bar->n_cells > SHORT && bar->def.joint == 0.0;
}

/* On to cell `end` as far as nodes are mapped: a node's activity is known only when all its cells have been.
 */
void bar_null_add(const Bar *bar, BarNull *null, int end)
{
    const int mapped = end == bar->n_cells ? end : end - bar->support + 1;
    if (goes_in_pairs(bar)) {
        bar->kernels->null_space(bar, null, end == bar->n_cells ? end : mapped / 8 * 8);
        return;
    }
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

/* --- hats, by plain rotations ---------------------------------------------------------------------- */

/* Turns (*x, and what comes with it in its row) against (other, ...), so that `other` becomes 0. Where both
 * are 0 nothing turns. */
typedef struct Rotation {
    double c, s;
} Rotation;

static Rotation rotate(double *x, double other)
{
    const double square = *x * *x + other * other;
    if (!(square > too_small))
        return (Rotation){1, 0};
    const double root = sqrt(square);
    const Rotation rotation = {*x / root, other / root};
    *x = root;
    return rotation;
}

static void turn(Rotation by, double *a, double *b)
{
    const double before = *a;
    *a = by.c * before + by.s * *b;
    *b = by.c * *b - by.s * before;
}

/* A row t u_far = u of the far node alone. */
static void add_far(BarTriangle *to, double t, double u)
{
    double *part = to->part;
    turn(rotate(&part[NULL_T], t), &part[NULL_U], &u);
    part[NULL_SUM] += u * u;
}

/* A row x u_near + y u_far = v. */
static void add_near(BarTriangle *to, double x, double y, double v)
{
    double *part = to->part;
    const Rotation by = rotate(&part[NULL_X], x);
    turn(by, &part[NULL_Y], &y);
    turn(by, &part[NULL_V], &v);
    add_far(to, y, v);
}

BarTriangle bar_null_cell(const Bar *bar, int cell, bool left)
{
    BarTriangle triangle = {{0}};
    const double free_left = bar_node_moves(bar, cell), free_right = bar_node_moves(bar, cell + 1);
    for (int p = bar->first[cell]; p < bar->first[cell + 1]; p++) {
        const double s = bar->s[p % bar->slots][p / bar->slots], v = bar->v[p % bar->slots][p / bar->slots];
        const double of_left = free_left * (1.0 - s), of_right = free_right * s;
        add_near(&triangle, left ? of_left : of_right, left ? of_right : of_left, v);
    }
    return triangle;
}

BarTriangle bar_null_join(const BarTriangle *first, const BarTriangle *second)
{
    const double *a = first->part, *b = second->part;
    BarTriangle all = {{[NULL_SUM] = a[NULL_SUM] + b[NULL_SUM]}};
    add_far(&all, b[NULL_T], b[NULL_U]);
    add_near(&all, a[NULL_T], 0.0, a[NULL_U]);

    /* the shared node's two rows: one goes with the node, the other is left */
    double x = a[NULL_X], y = a[NULL_Y], v = a[NULL_V], far = 0.0, rest_y = 0.0, rest_far = b[NULL_Y];
    double rest_v = b[NULL_V];
    const Rotation by = rotate(&x, b[NULL_X]);
    turn(by, &y, &rest_y);
    turn(by, &far, &rest_far);
    turn(by, &v, &rest_v);
    if (by.s == 0.0 && !(x * x > too_small)) /* the node is in neither */
        add_near(&all, y, far, v);
    add_near(&all, rest_y, rest_far, rest_v);
    return all;
}

/* The squares that are left when the last two nodes go too. */
static double sum_of_tree(const BarNullTree *tree)
{
    BarTriangle all = tree->before;
    double *part = all.part;
    if (!(part[NULL_X] * part[NULL_X] > too_small))
        add_far(&all, part[NULL_Y], part[NULL_V]);
    if (!(part[NULL_T] * part[NULL_T] > too_small))
        part[NULL_SUM] += part[NULL_U] * part[NULL_U];
    return part[NULL_SUM];
}

/* K_0 = m/2 times the sum of squares, in units of energy per cross-section. */
double bar_null_energy(const Bar *bar, const BarNull *null)
{
    const double sum = goes_in_pairs(bar) ? sum_of_tree(&null->tree) : null->band.sum;
    return 0.5 * bar->mass * sum;
}
