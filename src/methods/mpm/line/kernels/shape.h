/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shape functions of the bar's mesh, in natural coordinates: a particle in `cell` at s in [0, 1) sees
 * `support` nodes, cell to cell + support - 1. Derivatives are by s (divide by dx). */
#ifndef METHODS_MPM_LINE_KERNELS_SHAPE_H
#define METHODS_MPM_LINE_KERNELS_SHAPE_H

#include "methods/mpm/line/mpm_bar.h"

#include <math.h>

enum { SHAPE_SUPPORT_MAX = 4 };

/* Nodes that a cell touches: hat 2, bspline2 3, uGIMP, CPDI and bspline3 4. */
static inline int shape_support(MpmShape shape)
{
    return shape == MPM_HAT ? 2 : shape == MPM_BSPLINE2 ? 3 : 4;
}

/* Nodes to each side with which a node shares a particle: one less, but a uGIMP particle touches three at
 * most. */
static inline int shape_reach(MpmShape shape)
{
    return shape == MPM_HAT ? 1 : shape == MPM_BSPLINE3 || shape == MPM_CPDI ? 3 : 2;
}

/* Cells at each end of the mesh whose B-splines differ from the inner ones (open knots). */
static inline int shape_end_cells(MpmShape shape)
{
    return shape == MPM_BSPLINE2 ? 1 : shape == MPM_BSPLINE3 ? 2 : 0;
}

/* B-splines of the given degree with open knots at the ends of a mesh of n_cells cells; any cell. */
void shape_open_spline(int degree, int n_cells, int cell, double s, double *n, double *dn);

/* Where node a of the cell lies, from the cell's left edge in units of dx: a mesh node, a ghost node, or the
 * Greville abscissa (mean of the inner knots) of a B-spline. */
double shape_node_offset(MpmShape shape, int n_cells, int cell, int a);

/* Inner cells, where the functions are the same in each: shape_inner(shape, &h, &s, n, dn); h is the
 * half-width of a uGIMP or CPDI particle over dx. */
#define REAL        double
#define SHAPE_INNER shape_inner
#define ABSOLUTE(x) fabs(x)
#include "methods/mpm/line/kernels/shape_inner.h"
#undef REAL
#undef SHAPE_INNER
#undef ABSOLUTE

/* Any cell. */
static inline void shape_at(MpmShape shape, double h, int n_cells, int cell, double s, double *n, double *dn)
{
    int ends = shape_end_cells(shape);
    if (cell < ends || cell >= n_cells - ends)
        shape_open_spline(shape == MPM_BSPLINE2 ? 2 : 3, n_cells, cell, s, n, dn);
    else
        shape_inner(shape, &h, &s, n, dn);
}

#endif
