/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How a sampled mode goes on: the frequency and decay that a run shows with the ends that its mesh has.
 *
 * At rest one time step is a linear map of the nodal velocities v and forces f. Its eigenvalues lambda are
 * what the run can do, and the mode that the particles were given is nearly one of its eigenvectors: exactly
 * with hats and uGIMP, a mixture with B-splines, whose ends differ from their middle. The answer is the
 * eigenvalue of the vector that the sampled mode overlaps most:
 *
 *     frequency = arg(lambda)/dt,   decay = -ln|lambda|/dt
 *     overlap = |sum m conj(v) s| / (|v|_m |s|_m),   s = sum m N phi / m
 *
 * Of two materials phi is the mode of both (bar_modes.h), and each particle has its own modulus and mass;
 * where the bar starts with the sine of one, the overlap is that of the sine. */
#ifndef THEORY_STEP_SPECTRUM_H
#define THEORY_STEP_SPECTRUM_H

#include "theory/elastic_bar.h"

typedef struct StepMode {
    bool known; /* false: shorter than two cells, beyond the stability limit, not enough memory (errno
                   ENOMEM), or given up (ECANCELED) */
    double frequency;
    double decay;   /* amplitude ~ exp(-decay t) */
    double overlap; /* 1: the sampled mode is this one; much less: a mixture of several, see the spectrum */
    bool with_ends; /* false: of the endless mesh, because the bar is long (1e-8 there) */
} StepMode;

/* Mode number n >= 1 on the mesh with its time step mesh->dt; the rigid motion has frequency 0. Some ms at
 * 1000 cells; the endless mesh from 2000 cells on, and from 20000 where a cubic spline is held: held ends of
 * those are soft by .012 dx (6e-7 of the frequency there). Of two materials, which no endless mesh has, it is
 * not known of more than 20000 cells. */
StepMode step_mode(const BarTheory *, const BarMesh *, int number);

#endif
