/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the lattice of a bar by bond-based peridynamics predicts: frequencies, and v_cm(t).
 *
 * A wave u_j = U exp(i (k j h - omega t)) on the endless lattice of spacing h with bonds of the stiffness k_m
 * at distance m h (bonds_line_wave()) obeys, theta = k h,
 *
 *     rho u_j'' = sum_m k_m (u_{j+m} - 2 u_j + u_{j-m}),   u_{j+m} + u_{j-m} - 2 u_j = -4 sin^2(m theta/2)
 * u_j
 *
 * For long waves, with partial volumes and delta a whole number of spacings, omega is that of elasticity; to
 * the next order it is too low by k^2 (delta^2 + h^2)/48: the horizon, more than the spacing, sets the
 * dispersion.
 *
 * Velocity Verlet turns u'' = -omega^2 u into sin(Omega dt/2) = omega dt/2 (bar_motion.h), and from u = 0 the
 * velocity at whole steps is exactly v_0 cos(Omega n dt).
 *
 * With both ends fixed by mirrored nodes sin(beta_n X) keeps its form under the whole sum, so Omega(beta_n)
 * is the frequency of the run. A free end has fewer bonds, or stiffer ones where they are corrected: there
 * the frequencies are eigenvalues of the matrix of the lattice.
 *
 * Source: the dispersion relation of S. A. Silling (2000), section 6, summed over the lattice. Units: any
 * consistent system. Each definition is that of a right code, and of the bar of the theory. */
#ifndef ANSWERS_BAR_LATTICE_H
#define ANSWERS_BAR_LATTICE_H

#include "methods/bonds/plane/bonds_plane.h"
#include "theory/bar_motion.h"
#include "theory/elastic_bar.h"

/* A wave far from the ends, its number in 1/length, of either sign. known: the step is within the stability
 * limit of this wave; decay 0, filter 1. */
Dispersion bar_lattice_dispersion(const BeamDef *, double wave_number);

/* Omega of mode `number` (1, 2, ...) with the ends as they are; NAN: no such mode, unstable, no memory (errno
 * ENOMEM), given up (ECANCELED), or with a free end a mode so low on a lattice so fine (n = 1 from some 7,000
 * nodes on) that rounding hides it. */
double bar_lattice_frequency(const BarTheory *, const BeamDef *, int number);

/* v_cm(t) predicted whole, all loads 0. NULL: a load acts, the step is unstable, memory is short, or an end
 * is free and there are more than BAR_LATTICE_MOTION_MAX nodes (all eigenvectors are needed). */
enum { BAR_LATTICE_MOTION_MAX = 200 };
BarMotion *bar_lattice_motion(const BarTheory *, const BeamDef *);

#endif
