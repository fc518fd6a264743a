/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kinetic energy along a line that the grid cannot see at all: K_0.
 *
 * What particles have falls into K_l + (K_c - K_l) + K_0. K_l = sum p^2/(2 m_i) is what lumped masses make of
 * the grid's momenta, K_c what consistent masses would, and
 *
 *     K_0 = min over nodal velocities u of  sum over particles of m (v - sum N u)^2 / 2
 *
 * is the motion that no velocities of the grid can give to the particles. The minimum is over the nodes that
 * are free and active. Of APIC's particles it is that of v alone.
 *
 * Least squares by Givens rotations, row by row in the order of the particles. A particle brings the row
 * (N_1 .. N_b | v), which is turned against the rows of a triangle until nothing is left of it but a number
 * on the right: its square belongs to the minimum. Rotations are done without roots (Gentleman 1973): a row
 * is kept as its diagonal's square d and the rest over the diagonal r, the new row has a weight w, at first
 * m, and for each of its entries x in turn
 *
 *     d' = d + w x^2    c = d/d'    g = w x/d'    w' = c w
 *     of what stands right of it   y' = y - x r    r' = c r + g y
 *
 * A row that is empty (d = 0) takes the new one whole: c = 0, and nothing is left of it. So no pivot is too
 * small until its square leaves the range of a double, and no tolerance says which one would be. As particles
 * are in order, a triangle's row is complete when their cells have passed it: only as many rows are kept as a
 * particle has nodes. */
#include "methods/mpm/engine.h"

/* Numbers whose squares would leave a double's range are as good as 0 beside others of order 1. */
static const double too_small = 1e-280;

/* Rows of the triangle that are not yet complete. */
typedef struct Triangle {
    double weight[SHAPE_SUPPORT_MAX];                   /* square of the row's diagonal; 0: an empty row */
    double above[SHAPE_SUPPORT_MAX][SHAPE_SUPPORT_MAX]; /* the row right of its diagonal, over the diagonal */
    double value[SHAPE_SUPPORT_MAX];                    /* its right-hand side, likewise */
} Triangle;

/* One particle: its row x (overwritten) and right-hand side v against the rows; what is left of it. */
static double add_row(Triangle *rows, const int support, double weight, double *x, double v)
{
    for (int a = 0; a < support; a++) {
        const double first = x[a], whole = rows->weight[a] + weight * (first * first);
        if (!(whole > too_small))
            continue;
        const double inverse = 1.0 / whole, keep = rows->weight[a] * inverse, gain = weight * first * inverse;
        rows->weight[a] = whole;
        weight *= keep;
        for (int k = a + 1; k < support; k++) {
            const double before = x[k], row = rows->above[a][k];
            x[k] = before - first * row;
            rows->above[a][k] = keep * row + gain * before;
        }
        const double before = v, row = rows->value[a];
        v = before - first * row;
        rows->value[a] = keep * row + gain * before;
    }
    return weight * (v * v);
}

/* In units of energy per cross-section; the grid stands as after map and supports. */
double mpm_line_null_energy(const Mpm *mpm)
{
    Triangle rows = {{0}, {{0}}, {0}};
    double sum = 0.0;
    const int last = mpm->support - 1;
    int node = 0; /* of the triangle's first row */
    for (int p = 0; p < mpm->n_particles; p++) {
        const int base = mpm->base[p];
        double n[SHAPE_SUPPORT_MAX], slopes[SHAPE_SUPPORT_MAX];
        for (; node < base; node++) { /* its row is complete and is dropped, an empty last one comes in */
            for (int a = 0; a < last; a++) {
                rows.weight[a] = rows.weight[a + 1];
                rows.value[a] = rows.value[a + 1];
                for (int k = a + 1; k < last; k++)
                    rows.above[a][k] = rows.above[a + 1][k + 1];
                rows.above[a][last] = 0.0;
            }
            rows.weight[last] = rows.value[last] = 0.0;
        }
        shape_at(mpm->shape, mpm_half(mpm, p), mpm->cells, base, mpm->s[0][p], n, slopes);
        for (int a = 0; a < mpm->support; a++)
            n[a] *= mpm_moves(mpm, base + a);
        sum += add_row(&rows, mpm->support, mpm_mass(mpm, p), n, mpm->v[0][p]);
    }
    return 0.5 * sum;
}
