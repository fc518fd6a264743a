/* Shape functions of the bar's mesh, in natural coordinates: a particle in `cell` at s in [0, 1) sees
 * `support` nodes, cell to cell + support - 1. Derivatives are by s (divide by dx). */
#ifndef PHYSICS_MPM_SHAPE_H
#define PHYSICS_MPM_SHAPE_H

#include "physics/mpm/bar.h"

enum { SHAPE_SUPPORT_MAX = 4 };

/* Nodes that a cell touches: hat 2, bspline2 3, uGIMP and bspline3 4. */
static inline int shape_support(MpmShape shape)
{
    return shape == MPM_HAT ? 2 : shape == MPM_BSPLINE2 ? 3 : 4;
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

/* Inner cells: the functions are the same in each.
 * uGIMP is the hat averaged over the particle's width 2 h dx (Bardenhagen and Kober 2004): its corners are
 * rounded within h of a node, and with the pieces' own squares no case has to be told from another. */
static inline void shape_inner(MpmShape shape, double h, double s, double *n, double *dn)
{
    switch (shape) {
    case MPM_HAT:
        n[0] = 1.0 - s;
        n[1] = s;
        dn[0] = -1.0;
        dn[1] = 1.0;
        return;
    case MPM_GIMP: {
        double left = h - s, right = s - (1.0 - h);
        left = left > 0.0 ? left : 0.0;
        right = right > 0.0 ? right : 0.0;
        double slope_left = left * (0.5 / h), slope_right = right * (0.5 / h);
        n[0] = 0.5 * (left * slope_left);
        n[3] = 0.5 * (right * slope_right);
        n[1] = (1.0 - s) - 2.0 * n[0] + n[3];
        n[2] = s + n[0] - 2.0 * n[3];
        dn[0] = -slope_left;
        dn[3] = slope_right;
        dn[1] = -1.0 + 2.0 * slope_left + slope_right;
        dn[2] = 1.0 - slope_left - 2.0 * slope_right;
        return;
    }
    case MPM_BSPLINE2: {
        double r = 1.0 - s;
        n[0] = 0.5 * (r * r);
        n[1] = 0.5 + s * r;
        n[2] = 0.5 * (s * s);
        dn[0] = -r;
        dn[1] = r - s;
        dn[2] = s;
        return;
    }
    case MPM_BSPLINE3: {
        double r = 1.0 - s, ss = s * s, rr = r * r;
        n[0] = rr * r * (1.0 / 6.0);
        n[1] = (2.0 / 3.0) - ss * (1.0 - 0.5 * s);
        n[2] = (2.0 / 3.0) - rr * (1.0 - 0.5 * r);
        n[3] = ss * s * (1.0 / 6.0);
        dn[0] = -0.5 * rr;
        dn[1] = s * (1.5 * s - 2.0);
        dn[2] = r * (2.0 - 1.5 * r);
        dn[3] = 0.5 * ss;
        return;
    }
    }
}

/* Any cell. */
static inline void shape_at(MpmShape shape, double h, int n_cells, int cell, double s, double *n, double *dn)
{
    int ends = shape_end_cells(shape);
    if (cell < ends || cell >= n_cells - ends)
        shape_open_spline(shape == MPM_BSPLINE2 ? 2 : 3, n_cells, cell, s, n, dn);
    else
        shape_inner(shape, h, s, n, dn);
}

#endif
