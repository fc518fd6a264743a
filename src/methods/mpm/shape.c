/* SPDX-License-Identifier: GPL-3.0-or-later */
/* B-splines near the ends of the mesh, by the recursion of Cox and de Boor on open knots k_i (Piegl
 * and Tiller, The NURBS Book, chapter 2):
 *
 *     N_i,0 = 1 in [k_i, k_i+1),   else 0
 *     N_i,d = (x - k_i)/(k_i+d - k_i) N_i,d-1 + (k_i+d+1 - x)/(k_i+d+1 - k_i+1) N_i+1,d-1,   0/0 = 0
 *     N'_i,d = d (N_i,d-1/(k_i+d - k_i) - N_i+1,d-1/(k_i+d+1 - k_i+1))
 *
 * Inner cells, nearly all of a mesh, have the closed forms of shape.h. Lengths in cells. */
#include "methods/mpm/shape.h"
#include "base/assertion.h"
#include "methods/mpm/engine.h"

/* Knot k of an open knot vector on cell edges 0, 1, ..., n_cells: the ends are repeated degree + 1 times. */
static double knot(int degree, int n_cells, int k)
{
    int edge = k - degree;
    return edge < 0 ? 0.0 : edge > n_cells ? (double)n_cells : (double)edge;
}

/* The degree + 1 functions that are not zero in the cell, functions cell to cell + degree, in place from
 * degree 0 upwards: in each round n[a] is split between functions a and a + 1 of the next degree. */
static void functions(int degree, int knots_degree, int n_cells, int cell, double s, double *n)
{
    /* distances to the knots left and right of the point, cell's left edge being knot cell + knots_degree */
    double left[4], right[4];
    int here = cell + knots_degree;
    n[0] = 1.0;
    for (int d = 1; d <= degree; d++) {
        left[d] = ((double)cell - knot(knots_degree, n_cells, here + 1 - d)) + s;
        right[d] = (knot(knots_degree, n_cells, here + d) - (double)cell) - s;
        double saved = 0.0;
        for (int a = 0; a < d; a++) {
            double share = n[a] / (right[a + 1] + left[d - a]);
            n[a] = saved + right[a + 1] * share;
            saved = left[d - a] * share;
        }
        n[d] = saved;
    }
}

void shape_open_spline(int degree, int n_cells, int cell, double s, double *n, double *dn)
{
    ASSERT_INT(degree, >=, 1);
    ASSERT_INT(degree, <, SHAPE_SUPPORT_MAX);
    ASSERT_INDEX(cell, n_cells);
    functions(degree, degree, n_cells, cell, s, n);
    /* N' as above: before and after are the two terms of the difference */
    double lower[SHAPE_SUPPORT_MAX];
    functions(degree - 1, degree, n_cells, cell, s, lower);
    double before = 0.0;
    for (int a = 0; a <= degree; a++) {
        double after = 0.0;
        if (a < degree) {
            int i = cell + a + 1; /* function of the lower degree, counted by its first knot */
            after = degree * lower[a] / (knot(degree, n_cells, i + degree) - knot(degree, n_cells, i));
        }
        dn[a] = before - after;
        before = after;
    }
}

double shape_node_offset(MpmShape shape, double half, int cells, int cell, int a)
{
    ASSERT_INDEX(a, SHAPE_SUPPORT_MAX);
    if (shape == MPM_HAT)
        return a;
    if (shape == MPM_GIMP)
        return a - half;
    if (shape == MPM_CPDI)
        return a - 1;
    ASSERT_INDEX(cell, cells);
    const int degree = shape == MPM_BSPLINE2 ? 2 : 3;
    double sum = 0.0;
    for (int d = 1; d <= degree; d++)
        sum += knot(degree, cells, cell + a + d) - cell;
    return sum / degree;
}

MpmWeights mpm_weights(const Mpm *mpm, double half, int base, const double *s)
{
    MpmWeights w = {.n[1][0] = 1.0};
    for (int axis = 0; axis < mpm->dim; axis++) /* in the plane B-splines stay as they are at the ends */
        shape_at(mpm->shape, half, mpm->cells, mpm->dim == 2 ? 2 : base, s[axis], w.n[axis], w.dn[axis]);
    return w;
}

MpmWeights mpm_weights_of(const Mpm *mpm, int p)
{
    const double s[MPM_AXES] = {mpm->s[0][p], mpm->dim == 2 ? mpm->s[1][p] : 0.0};
    return mpm_weights(mpm, mpm_half(mpm, p), mpm->base[p], s);
}
