/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Cuts: which bonds they part. */
#ifndef METHODS_BONDS_PLANE_PLATE_CUTS_H
#define METHODS_BONDS_PLANE_PLATE_CUTS_H

#include "methods/bonds/plane/lattice/lattice.h"
#include "methods/bonds/plane/plate/plate.h"

/* Whether the cut parts the bond. */
bool cut_parts(const PlateCut *, const Lattice *, BondPlace);

/* Whether all nodes lie on one side of it because it runs along an edge: it parts no bond. */
bool cut_runs_outside(const PlateCut *, const Lattice *);

/* Whether two or more nodes lie on the cut, so that it is one-sided. */
bool cut_runs_along_nodes(const PlateCut *, const Lattice *);

#endif
