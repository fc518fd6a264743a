/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a node counts for in the family of another: which nodes are members, and the factor w of their volume.
 *
 *     none      |xi| <= delta             w = 1
 *     partial   |xi| <= delta             w = min(1, (delta + dx/2 - |xi|)/dx)     the rule of PDLAMMPS
 *     hhb       |xi| <  delta + dx/2      the same line                            Hu, Ha, Bobaru
 *
 * On a line w of hhb is the share of the node's cell that lies within the horizon. In the plane neither is
 * the share of its area: the line takes the cell for one that is met face on. `partial` leaves out the cells
 * whose centres lie beyond the horizon, so that a body far from its surfaces is too soft at every horizon: by
 * 12 % at delta = 4 dx, where hhb is off by 2 %. Names and rules as in P. Seleson, Improved one-point
 * quadrature algorithms for two-dimensional peridynamic models based on analytical calculations (2014). */
#ifndef METHODS_BONDS_PLANE_LATTICE_VOLUME_H
#define METHODS_BONDS_PLANE_LATTICE_VOLUME_H

#include "base/kinds.h"

#include <stdbool.h>

/* The members of a family lie no farther than this; at delta = 4 dx, or at delta + dx/2 = 3 dx, the tolerance
 * decides. */
static inline double volume_reach(VolumeCorrection how, double horizon, double spacing)
{
    return how == VOLUME_HHB ? (horizon + spacing / 2) * (1 - 1e-9) : horizon * (1 + 1e-9);
}

/* w of a member at this distance, 1. */
static inline double volume_factor(VolumeCorrection how, double horizon, double spacing, double length)
{
    const bool whole = how == VOLUME_NONE || length <= horizon - spacing / 2;
    return whole ? 1 : (horizon + spacing / 2 - length) / spacing;
}

#endif
