/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Far particles: those of a beam so bent or torn that a block's particles do not find their nodes within its
 * slots (plane_state.h). They give to the nodes one by one when the patches of all blocks are there, in the
 * order of places, by the equations of kernels/plane_kernels.c. */
#include "methods/mpm/plane/plane_state.h"

#include "base/assertion.h"

/* Whether the particle found no slot: the same question as to_nodes() of the kernels asks. */
static bool is_far(const Plane *plane, const PlaneBlock *block, int at)
{
    const int slot = plane->base[at] % plane->gx - at % PLANE_LANES - block->column;
    return slot < 0 || slot + plane->support > PLANE_SLOTS;
}

/* m, p of eqs. 2, 3 and f of eq. 10, per unit thickness. */
static void give(const Plane *plane, PlaneOp op, int at)
{
    ASSERT_INDEX(plane->base[at], plane->n_nodes);
    const PlaneWeights w = plane_weights(plane, plane->sx[at], plane->sy[at]);
    const double scale = plane->volume[at] / plane->dx;
    const double xx = plane->sxx[at] * scale, yy = plane->syy[at] * scale, xy = plane->sxy[at] * scale;
    for (int b = 0; b < plane->support; b++)
        for (int a = 0; a < plane->support; a++) {
            const int node = plane->base[at] + b * plane->gx + a;
            if (op == PLANE_FORCE) {
                const double bx = w.dnx[a] * w.ny[b], by = w.nx[a] * w.dny[b];
                plane->fx[node] -= bx * xx + by * xy;
                plane->fy[node] -= bx * xy + by * yy;
                continue;
            }
            const double share = plane->mass * (w.nx[a] * w.ny[b]);
            if (op == PLANE_MAP)
                plane->node_mass[node] += share;
            plane->px[node] += share * plane->vx[at];
            plane->py[node] += share * plane->vy[at];
        }
}

void plane_add_far(const Plane *plane, PlaneOp op)
{
    for (int at = 0; at < plane->n_places; at++) {
        const int block = at / PLANE_LANES / plane->n_vectors;
        if (plane->far[block] && at % PLANE_LANES < plane_lanes(plane, block) &&
            is_far(plane, &plane->blocks[block], at))
            give(plane, op, at);
    }
}
