/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the energy of broken bonds went: the price of the crack itself and what was broken besides.
 *
 * A crack of area A should cost G0 A, with G0 = 9 E delta s0^2/(4 pi) of paper P: the work, up to s0, of all
 * bonds that an unbounded plane cuts. On the lattice it costs more, for three reasons that can be
 * distinguished: the lattice sum is not the integral; bonds break beside the path without crossing it; others
 * break far from it, under the load. What is dissipated (bonds_break.c) is shared out by the energies of
 * whole bonds at s0, of which it is the sum to some .2 %. SI units; energies are those of the beam, J. */
#ifndef METHODS_BONDS_CRACKS_CRACK_COST_H
#define METHODS_BONDS_CRACKS_CRACK_COST_H

#include "base/cancel.h"
#include "methods/method.h"

/* Straight pieces from place to place, m. */
typedef struct CrackPath {
    size_t count;
    double *x, *y;
} CrackPath;

typedef struct CrackCost {
    double area;    /* length of the path times the thickness, m^2 */
    double plane;   /* what the bonds through a straight upright plane of this lattice take up to s0, J/m^2 */
    double through; /* J: of the broken bonds that cross the path */
    double beside;  /* likewise of those that do not, but lie within a horizon of it */
    double far;     /* likewise of all others */
    double total;   /* J: dissipated so far; the sum of the three */
} CrackCost;

/* So many pairs of a broken bond and a piece of a path, or eights of bonds, lie between two questions. */
enum { CRACK_COST_PAIRS_A_QUESTION = 262144 };

/* False: the simulation has no notch that a crack could begin at, s0 was changed on the way (then no bond's
 * share is known), or it was given up. */
bool crack_cost(const Simulation *beam, const Cancel *, CrackCost *cost);

/* The same of any body by peridynamics in the plane whose cracks run along these paths and are of that length
 * (m) together. False: s0 was changed on the way, or it was given up. */
bool crack_cost_along(const Simulation *, const CrackPath *paths, int n_paths, double length, const Cancel *,
                      CrackCost *);

#endif
