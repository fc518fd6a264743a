/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lowest vibration of this very lattice, with its supports and its surface correction: the predicted
 * period of a simply supported beam, and of any beam or plate what critical damping and rest go by. It is
 * what the discretisation gives for small motion, before any
 * step is taken: what a run measures differs by the step (dt^2) and by how well the record can be fitted. */
#ifndef METHODS_BONDS_PLANE_BONDS_MODES_H
#define METHODS_BONDS_PLANE_BONDS_MODES_H

#include "methods/bonds/plane/bonds_plane.h"

/* The largest factor that is made for it, in numbers of 8 bytes: a quarter of a gigabyte. */
enum { BEAM_MODES_NUMBERS_MAX = 1 << 25 };

/* The period in s of a simply supported beam; NAN where the lattice is so fine that the factor of its
 * stiffness would not fit (BEAM_MODES_NUMBERS_MAX), and for other problems, which have none. `span` and
 * `height` (NULL: not wanted): the distance of the supports and the height as the nodes lie, m. It takes n
 * B^2 products, n twice the number of nodes and B twice the nodes of a column times the reach: a tenth of a
 * second at 400 x 20 nodes, seconds at 800 x 40. BeamDef.cancel is asked on the way. False: the status says
 * why (a definition that is no beam, no memory, given up). */
bool beam_predicted_period(const BeamDef *definition, double *period, double *span, double *height,
                           Status *status);

/* What small motion of a beam or a plate is, by the factor of its stiffness as it stands: with its supports,
 * its notch or cuts, and the clamp of t = 0. NAN: nothing holds it, or the factor would not fit. */
typedef struct BeamLinear {
    double period; /* the longest, s */
    double sag;    /* of the probe at rest under a body force of 1 m/s^2 upwards, m */
} BeamLinear;

/* False: no memory, or given up by BeamDef.cancel; the status says which. */
bool beam_linear(const Simulation *beam, BeamLinear *, Status *);

#endif
