/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a run of small motion does, from the engine itself: one step of it is a linear map A of the state x
 * (Method.small), whose eigenvalues lambda are the frequencies and decays that a run shows,
 *
 *     Omega = |arg lambda|/dt,   decay = -log|lambda|/dt
 *
 * and of which a start x_0 has the parts P_k x_0, P_k the spectral projector of lambda_k:
 *
 *     x_n = A^n x_0 = sum lambda_k^n P_k x_0
 *
 * Only the space is looked at that the start moves in: that of y, A y, A^2 y ..., y = A x_0 - x_0, by the
 * method of Arnoldi. (What the grid does not see has lambda = 1 and is not in y.) Where it closes all of this
 * is exact: after two steps for a mode of hats or uGIMP, after two for each node else; larger bars are looked
 * at until the residual of the mode is small.
 *
 * The largest stable step is where an eigenvalue comes to -1. With dt times the stress in place of the stress
 * A = A_0 + dt^2 A_1, and
 *
 *     -(1 + A_0)^-1 A_1 x = x/dt^2
 *
 * is an eigenproblem whose space closes after one step for each node.
 *
 * Sources: W. E. Arnoldi, Q. Appl. Math. 9 (1951) 17; Y. Saad, Numerical Methods for Large Eigenvalue
 * Problems (2011), 6.2. Units: those of the simulation. */
#ifndef ANSWERS_STEP_MODES_H
#define ANSWERS_STEP_MODES_H

#include "base/cancel.h"
#include "methods/method.h"

typedef struct StepModes StepModes;

typedef struct StepMode {
    bool known; /* false: not converged, or it or its reciprocal grows */
    double frequency;
    double decay;   /* amplitude ~ exp(-decay t) */
    double overlap; /* of its momenta at the nodes with those of the start, weighed by 1/m: 0 to 1 */
} StepMode;

/* From the start that a simulation of a method with Method.small was created with; it is used up. `whole`:
 * the motion is asked for, and not just its largest mode. NULL: too large (more than 25 million numbers), no
 * memory (errno ENOMEM), given up (ECANCELED). */
StepModes *step_modes_create(Simulation *, bool whole, Cancel);
void step_modes_free(StepModes *); /* NULL is allowed */

/* The mode with the largest share in the energy of the start. */
StepMode step_modes_largest(const StepModes *);

/* The overlap of that mode with another start of the same bar. */
double step_modes_overlap(const StepModes *, Simulation *start);

/* Whether the space has closed without an unstable mode, and then the column v_cm after so many steps. */
bool step_modes_are_whole(const StepModes *);
double step_modes_v_cm(const StepModes *, long step);

/* The largest stable time step of a bar that stands at rest; `still` is the same bar with a step so small
 * (2^-60 of a stable one) that no stress changes. Meant for some 100 nodes: the bound of `most` vectors is
 * beyond them. INFINITY: any step; NAN: not known, errno ENOMEM where memory was short, ECANCELED. */
double step_modes_limit(Simulation *still, Simulation *moving, Cancel);

#endif
