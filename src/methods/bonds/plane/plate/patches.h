/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Patches: rectangles of nodes on which something acts. Whatever holds or loads a body, a beam's support, the
 * pressure on its top, a region of a plate, is one; so a step knows no more of them than this. */
#ifndef METHODS_BONDS_PLANE_PLATE_PATCHES_H
#define METHODS_BONDS_PLANE_PLATE_PATCHES_H

#include "methods/bonds/plane/lattice/lattice.h"
#include "methods/bonds/plane/plate/plate.h"

static inline bool patch_has(const Patch *patch, int i, int j)
{
    return i >= patch->i && i < patch->i + patch->columns && j >= patch->j && j < patch->j + patch->rows;
}

static inline bool patch_has_row(const Patch *patch, int j)
{
    return patch->columns > 0 && j >= patch->j && j < patch->j + patch->rows;
}

/* The nodes of a region, ends included to 1e-6 dx; `inside`: those strictly inside, by as
 * much. May be empty (columns or rows 0). */
Patch patch_of(const Lattice *, const PlateRegion *, bool inside);

/* The nodes of a stretch of an edge: one layer. */
Patch patch_of_edge(const Lattice *, PlateEdge, double from, double to);

bool patch_is_empty(const Patch *);
bool patches_meet(const Patch *, const Patch *);

/* The share of a load that acts at a time, in steps of dt. */
double load_share(const Load *, double time, double dt);

/* Cuts: which bonds they part. */

/* Whether the cut parts the bond. */
bool plate_cut_parts(const PlateCut *, const Lattice *, BondPlace);

/* Whether all nodes lie on one side of it because it runs along an edge: it parts no bond. */
bool plate_cut_runs_outside(const PlateCut *, const Lattice *);

/* Whether two or more nodes lie on the cut, so that it is one-sided. */
bool plate_cut_runs_along_nodes(const PlateCut *, const Lattice *);

#endif
