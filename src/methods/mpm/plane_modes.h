/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the equations of a beam's own mesh say before any step is taken: the period of its lowest vibration,
 * and the largest stable time step. */
#ifndef METHODS_MPM_PLANE_MODES_H
#define METHODS_MPM_PLANE_MODES_H

#include "methods/mpm/plane.h"

/* The predicted period of a supported beam, s, for small motion about the lattice on which its particles
 * start, with its time step, algorithm and flip fraction; NAN for a cantilever, whose length changes, of
 * B-splines, and
 * where the mesh is so fine that its matrices would take more than a quarter of a gigabyte. PlaneDef.cancel
 * is asked on the way. False: the status says why (no memory, given up). */
bool plane_predicted_period(const PlaneDef *, double *period, Status *);

/* The largest stable courant number of the lattice on which particles start; hats whose particles have
 * drifted stand less. Of a mesh too fine for its matrices that of an endless one, less a hundredth, which is
 * a lower bound. False: as above. */
bool plane_courant_limit(const PlaneDef *, double *courant, Status *);

#endif
