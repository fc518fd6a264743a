/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Is what a plate has sound? */
#ifndef METHODS_BONDS_PLANE_PLATE_PLATE_CHECK_H
#define METHODS_BONDS_PLANE_PLATE_PLATE_CHECK_H

#include "methods/bonds/plane/plate/patches.h"

/* Do all rows hold nodes of this lattice, move no node in two ways, and none faster than waves, m/s? Else the
 * status names the row, what is wrong, what is allowed. Of the lattice its measures alone are read. */
bool plate_check(const PlateDef *, const Lattice *, double wave_speed, Status *);

#endif
