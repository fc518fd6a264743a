/* SPDX-License-Identifier: GPL-3.0-or-later */
/* v_cm(t) of a bar predicted whole: the velocity at t = 0 resolved into the modes of the discrete bar, each
 * of which oscillates with the frequency that the time step makes of it.
 *
 * The parts of the bar (nodes, particles) obey y'' = -S y with a symmetric S, and in time steps
 *
 *     y_{k+1} - 2 y_k + y_{k-1} = -dt^2 S y_k
 *
 * An eigenvector e of S, S e = omega^2 e, therefore oscillates as cos(Omega k dt), sin(Omega dt/2) =
 * omega dt/2, by velocity Verlet. This is the scheme's own answer,
 * not an approximation of it. */
#ifndef THEORY_BAR_MOTION_H
#define THEORY_BAR_MOTION_H

#include <gsl/gsl_matrix.h>
#include <stdbool.h>

typedef struct BarMotion BarMotion;

/* Omega; NAN beyond the stability limit omega dt = 2. */
double bar_motion_frequency(double omega, double dt);

/* A sum of so many cosines, all 0. NULL: not enough memory. */
BarMotion *bar_motion_create(int count, double dt);
void bar_motion_free(BarMotion *); /* NULL is allowed */

/* Cosine k: share of v_cm at t = 0, and its frequency, which may be 0. */
void bar_motion_set(BarMotion *, int k, double share, double frequency);

/* All modes of S (size: the count of the motion; destroyed) that a start has, y_0 = start, v_cm = weights .
 * y. False: memory is short, or a mode is unstable. */
bool bar_motion_resolve(BarMotion *, gsl_matrix *s, const double *start, const double *weights);

double bar_motion_centre_velocity(const BarMotion *, long step);

/* A bar that hangs from its left end at rest, exact at any strain where stress = E ln(stretch) and the
 * section stays as it is: at the place X of the bar without load hangs the weight rho b (L - X) below it.
 * Units: any consistent system. */

typedef struct HangingColumn {
    double length, youngs_modulus, density, body_force;
} HangingColumn;

double bar_column_stress(const HangingColumn *, double x);       /* rho b (L - X) */
double bar_column_displacement(const HangingColumn *, double x); /* at a place of the bar without load */
double bar_column_linear(const HangingColumn *, double x); /* the same for small strains, k (L X - X^2/2) */
double bar_column_centre(const HangingColumn *);           /* where the centre of mass hangs */

#endif
