/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lattice's answer for the bar by bond-based peridynamics: predicted frequencies.
 *
 * A wave u_j = U exp(i (k j h - omega t)) on an endless lattice of spacing h, horizon delta, c = 2E/(A
 * delta^2) and w_m the factor of the volume at distance m h (m = 1 .. M; pd_waves.h):
 *
 *     rho u_j'' = sum_m c w_m V (u_{j+m} - 2 u_j + u_{j-m})/(m h),   V = A h
 *     u_{j+m} + u_{j-m} - 2 u_j = -4 sin^2(m theta/2) u_j,           theta = k h
 *
 *     omega_h^2 = 8E/(rho delta^2) sum_m (w_m/m) sin^2(m theta/2)
 *
 * For long waves sin^2(m theta/2) ~ (m theta/2)^2 and omega_h^2 ~ (E/rho) k^2 2 sum_m w_m m / (delta/h)^2,
 * which is c^2 k^2 exactly where partial volumes (or hhb) make sum w_m m = M^2/2 (delta = M h). To the next
 * order, with sum w_m m^3 = M^2 (M^2 + 1)/4, the frequency is too low by k^2 (delta^2 + h^2)/48: the horizon,
 * more than the spacing, sets the dispersion. With the energy correction every bond of a whole family has the
 * factor g = (delta/h)^2 / (2 sum_m w_m m), which takes out what the sum over the family has too much or too
 * little.
 *
 * A conical micromodulus, c_1 (1 - m h/delta), is in the sums as w_m (1 - m h/delta) times the scale that
 * makes the long waves right, (delta/h)^2/(2 sum_m (1 - m h/delta) w_m m).
 *
 * Velocity Verlet turns u'' = -omega_h^2 u into u_{n+1} - 2 u_n + u_{n-1} = -(omega_h dt)^2 u_n, hence
 *
 *     sin(Omega dt/2) = omega_h dt/2
 *
 * and from u = 0 the velocity at whole steps is exactly v_0 cos(Omega n dt).
 *
 * With both ends fixed by mirrored nodes sin(beta_n X) keeps its form under the whole sum, so Omega(beta_n)
 * is the frequency of the run. A free end has fewer bonds, or stiffer ones where they are corrected: there
 * the frequencies are eigenvalues of the matrix of the lattice, put together here again from its families.
 *
 * Source: the dispersion relation of S. A. Silling (2000), section 6, summed over the lattice. Units: any
 * consistent system. */
#ifndef THEORY_PD_BAR_THEORY_H
#define THEORY_PD_BAR_THEORY_H

#include "base/cancel.h"
#include "theory/bar_motion.h"
#include "theory/elastic_bar.h"
#include "theory/pd_waves.h"

typedef struct PdBarTheory {
    double spacing, horizon;  /* h, delta */
    VolumeCorrection volumes; /* w_m */
    bool conical;             /* c falls to 0 at the horizon, and is scaled so that the sum gives E */
    bool energy_correction;   /* bonds near a free end are scaled by the energy of their families */
    double dt;
    Cancel cancel; /* asked while an eigenvalue is found */
} PdBarTheory;

/* A wave far from the ends. known: the step is within the stability limit of this wave; decay 0, filter 1. */
Dispersion pd_bar_dispersion(const BarTheory *bar, const PdBarTheory *lattice, double wave_number);

/* Omega of mode `number` (1, 2, ...) with the ends as they are; NAN: no such mode, unstable, no memory (errno
 * ENOMEM), given up (ECANCELED), or with a free end a mode so low on a lattice so fine (n = 1 from some 7,000
 * nodes on) that rounding hides it.
 */
double pd_bar_frequency(const BarTheory *bar, const PdBarTheory *lattice, int number);

/* v_cm(t) predicted whole, all loads 0. NULL: a load acts, the step is unstable, memory is short, the family
 * is longer than the bar, or an end is free and there are more than PD_BAR_MOTION_MAX nodes (all eigenvectors
 * are needed). */
enum { PD_BAR_MOTION_MAX = 200 };
BarMotion *pd_bar_motion(const BarTheory *bar, const PdBarTheory *lattice);

#endif
