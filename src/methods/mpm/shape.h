/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shape functions along one axis of the mesh: N and dN/ds of the nodes from the particle's first one on, s
 * the place of the particle beside it, in cells. Those of the plane are products of two.
 *
 *     hat        r, s                                             r = 1 - s
 *     bspline2   r^2/2, 1/2 + s r, s^2/2
 *     bspline3   r^3/6, 2/3 - s^2 (1 - s/2), 2/3 - r^2 (1 - r/2), s^3/6
 *     uGIMP      1 - (s + h) + o^2/4h, (s + h) - 2 o^2/4h, o^2/4h  o = max(0, s + 2 h - 1)
 *     CPDI       L/2, r - L + R/2, s + L/2 - R, R/2               L = max(h - s, 0), R = max(s - 1 + h, 0)
 *     CPDI's N'  -L/2h, L/h + R/2h - 1, 1 - L/2h - R/h, R/2h
 *
 * uGIMP is the hat averaged over a box of half-width h (Bardenhagen and Kober 2004); s is the place of the
 * box's left edge, o what reaches into the next cell. CPDI is the hat's mean from the two ends of a domain of
 * half-width h that follows the particle (Sadeghirad, Brannon, Burghardt 2011); of its four nodes the second
 * is the left one of the cell. Each set adds up to 1, its derivatives to 0: mass and momentum are kept. */
#ifndef METHODS_MPM_SHAPE_H
#define METHODS_MPM_SHAPE_H

#include "base/kinds.h"

enum { SHAPE_SUPPORT_MAX = 4 };

/* Built from functions whose dimension and shape are constants where they are called: inlined, they leave
 * nothing of their branches. */
#define MPM_INLINE static inline __attribute__((always_inline, unused))

/* Nodes that a particle touches. */
MPM_INLINE int shape_support(MpmShape shape)
{
    return shape == MPM_HAT ? 2 : shape == MPM_BSPLINE2 || shape == MPM_GIMP ? 3 : 4;
}

/* Cells at each end of a line whose B-splines differ from the inner ones (open knots). */
MPM_INLINE int shape_end_cells(MpmShape shape)
{
    return shape == MPM_BSPLINE2 ? 1 : shape == MPM_BSPLINE3 ? 2 : 0;
}

/* B-splines of the given degree with open knots at the ends of a mesh of `cells` cells; any cell. */
void shape_open_spline(int degree, int cells, int cell, double s, double *n, double *dn);

/* Where node a of a cell lies, from the place at which s is 0 in units of dx: on a mesh node, on a ghost, or
 * at the Greville abscissa (mean of the inner knots) of a B-spline. */
double shape_node_offset(MpmShape shape, double half, int cells, int cell, int a);

/* `first` is the particle's first node; it is asked for by B-splines alone. */
MPM_INLINE void shape_at(MpmShape shape, double half, int cells, int first, double s, double *n, double *dn)
{
    const double r = 1.0 - s, ss = s * s, rr = r * r;
    const int ends = shape_end_cells(shape);
    if (ends > 0 && (first < ends || first >= cells - ends)) {
        shape_open_spline(shape == MPM_BSPLINE2 ? 2 : 3, cells, first, s, n, dn);
        return;
    }
    switch (shape) {
    case MPM_HAT:
        n[0] = r;
        n[1] = s;
        dn[0] = -1.0;
        dn[1] = 1.0;
        return;
    case MPM_GIMP: {
        const double beyond = s + 2.0 * half - 1.0, over = beyond > 0.0 ? beyond : 0.0;
        const double slope = over * (0.5 / half), third = 0.5 * over * slope, middle = s + half;
        n[0] = 1.0 - middle + third;
        n[1] = middle - 2.0 * third;
        n[2] = third;
        dn[0] = slope - 1.0;
        dn[1] = 1.0 - 2.0 * slope;
        dn[2] = slope;
        return;
    }
    case MPM_CPDI: {
        const double left = half > s ? half - s : 0.0, right = s > 1.0 - half ? s - (1.0 - half) : 0.0;
        const double slope_left = left * (0.5 / half), slope_right = right * (0.5 / half);
        n[0] = 0.5 * left;
        n[3] = 0.5 * right;
        n[1] = r - 2.0 * n[0] + n[3];
        n[2] = s + n[0] - 2.0 * n[3];
        dn[0] = -slope_left;
        dn[3] = slope_right;
        dn[1] = 2.0 * slope_left + slope_right - 1.0;
        dn[2] = 1.0 - slope_left - 2.0 * slope_right;
        return;
    }
    case MPM_BSPLINE2:
        n[0] = 0.5 * rr;
        n[1] = 0.5 + s * r;
        n[2] = 0.5 * ss;
        dn[0] = -r;
        dn[1] = r - s;
        dn[2] = s;
        return;
    case MPM_BSPLINE3:
        n[0] = rr * r * (1.0 / 6.0);
        n[1] = (2.0 / 3.0) - ss * (1.0 - 0.5 * s);
        n[2] = (2.0 / 3.0) - rr * (1.0 - 0.5 * r);
        n[3] = ss * s * (1.0 / 6.0);
        dn[0] = -0.5 * rr;
        dn[1] = s * (1.5 * s - 2.0);
        dn[2] = r * (2.0 - 1.5 * r);
        dn[3] = 0.5 * ss;
        return;
    default: /* a bar makes MPM_GIMP and MPM_BSPLINE3 of the uniform ones */
        return;
    }
}

#endif
