/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Shape functions along one direction; those of the plane are products of two. Lengths in cells, dN/dx over
 * 1/dx.
 *
 * hat: a particle at s in [0, 1) of its cell gives N = 1 - s, s to the cell's two nodes.
 *
 * uGIMP: a particle is a box of fixed half-width l = 1/(2P) and N the mean of the hat over it. With the first
 * node that it touches i = floor(r - l), s = r - l - i the place of its left edge and o = max(0, s + 2l - 1)
 * what stands over into the next cell:
 *
 *     N      1 - (s + l) + o^2/(4l)    (s + l) - 2 o^2/(4l)    o^2/(4l)
 *     N' dx  o/(2l) - 1                1 - 2 o/(2l)            o/(2l)
 *
 * Written so no difference of large numbers is left: the light third node keeps all its digits.
 *
 * Source: S. G. Bardenhagen, E. M. Kober, "The generalized interpolation material point method" (2004), with
 * boxes that keep their size. */
#ifndef METHODS_MPM_PLANE_PLANE_SHAPE_H
#define METHODS_MPM_PLANE_PLANE_SHAPE_H

enum { PLANE_SUPPORT_MAX = 3 };

static inline void plane_hat(double s, double n[PLANE_SUPPORT_MAX], double dn[PLANE_SUPPORT_MAX])
{
    n[0] = 1 - s;
    n[1] = s;
    dn[0] = -1;
    dn[1] = 1;
    n[2] = dn[2] = 0; /* there is none */
}

static inline void plane_gimp(double half, double s, double n[PLANE_SUPPORT_MAX],
                              double dn[PLANE_SUPPORT_MAX])
{
    const double beyond = s + 2 * half - 1, over = beyond > 0 ? beyond : 0;
    const double slope = over * (0.5 / half), third = 0.5 * over * slope, middle = s + half;
    n[0] = 1 - middle + third;
    n[1] = middle - 2 * third;
    n[2] = third;
    dn[0] = slope - 1;
    dn[1] = 1 - 2 * slope;
    dn[2] = slope;
}

#endif
