/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Waves in the plane of bonds far from surfaces: how fast they run by their length, their direction to the
 * lattice's rows, and the shape of the micromodulus. Source: theory/pd_waves.h. */
#ifndef ANSWERS_WAVES_H
#define ANSWERS_WAVES_H

#include "base/kinds.h"
#include "scenario/assignment.h"

#include <stdbool.h>

/* Phase speed over that of long waves in elasticity, at the wave number k: on this lattice with its volume
 * and surface correction (NAN: shorter than two spacings), and in the continuum of bonds with this horizon.
 * `angle` in radians, 0 along the rows. */
double waves_on_lattice(const Settings *, Influence, bool transverse, double angle, double k);
double waves_of_bonds(const Settings *, Influence, bool transverse, double k);

#endif
