/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Part of the dispersion view: waves in the plane of bonds. */
#ifndef VIEWS_WAVES_PLANE_H
#define VIEWS_WAVES_PLANE_H

#include "views/view.h"

/* Speed of waves that press (or, transverse, shear) over their length, along rows and diagonals of the
 * lattice, for both shapes of the micromodulus; dotted the integrals that they stand for. */
void waves_plane_describe(const Screen *, bool transverse, Picture *);

#endif
