/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is asked of the state in mid-step, whatever the order of the stages: which of them are done, where a
 * particle and a node are, and what a node has at present. */
#include "base/assertion.h"
#include "methods/mpm/mistakes.h"

size_t mpm_lasting_bytes(const Mpm *mpm, const MpmHead *head)
{
    if (mpm_wrong_with(mpm, head->mistake) & (DOES(KEEPS_GRID) | DOES(VOLUME_LATE)))
        return mpm->bytes_kept;
    return head->transfer == MPM_APIC ? mpm->bytes_apic : mpm->bytes_flip;
}

bool mpm_holds_momentum(const Mpm *mpm, MpmOp stage, int node)
{
    return mpm_held(mpm, mpm->sim.step, node) && !mpm_does(mpm, WRONG_HOLDS_NEVER) &&
           stage == (mpm_does(mpm, WRONG_HOLDS_LATE) ? OP_STRAIN : OP_FIX);
}

bool mpm_has_done(const Mpm *mpm, MpmOp op)
{
    for (int i = 0; i < mpm->sim.stage; i++)
        if (mpm->ops[i] == op)
            return true;
    return false;
}

bool mpm_find_all(Mpm *mpm)
{
    const double shift = mpm_shift(mpm, mpm->sim.step);
    bool inside = true;
    for (int k = 0; k < mpm->n_chunks; k++) {
        MpmChunk *chunk = &mpm->chunks[k];
        chunk->span = (MpmSpan){INT_MAX, 0};
        for (int row = 0; row < chunk->rows; row++) {
            const int first = chunk->first + row * chunk->stride, end = first + chunk->count;
            inside = mpm_set_places(mpm, mpm->dim, mpm->shape, shift, first, end, &chunk->span, NULL) < 0 &&
                     inside;
        }
    }
    return inside;
}

bool mpm_crosses(const Mpm *mpm, int particle, int node, double x, double y)
{
    const int gx = mpm->gx, old = mpm->base[particle];
    return mpm_cell(old % gx, mpm->s[0][particle], mpm->edge) != mpm_cell(node % gx, x, mpm->edge) ||
           (mpm->dim == 2 &&
            mpm_cell(old / gx, mpm->s[1][particle], mpm->edge) != mpm_cell(node / gx, y, mpm->edge));
}

double mpm_rest(const Mpm *mpm, int axis, int particle)
{
    if (mpm->bodies)
        return mpm->at[axis][particle];
    if (mpm->dim == 2)
        return axis == 0 ? (particle % mpm->nxp + 0.5) * mpm->spacing - mpm->def.channel
                         : (particle / mpm->nxp + 0.5) * mpm->spacing - mpm->def.height / 2;
    const int P = mpm->def.particles_per_cell;
    return (particle / P + (particle % P + 0.5 + mpm->def.offset) / P) * mpm->dx;
}

double mpm_grid_place(const Mpm *mpm, int axis, double coordinate)
{
    if (mpm->dim == 1)
        return coordinate / mpm->dx + mpm->origin + mpm->edge;
    const double first = axis == 0 ? mpm->xmin + mpm_shift(mpm, mpm->sim.step) * mpm->dx : mpm->ymin;
    return (coordinate - first) / mpm->dx + mpm->edge;
}

/* A beam's nodes. Places are compared with a tolerance of 1e-6 dx, as nodes lie exactly on the limits.
 * Supported: uy = 0 at the nodes of the end sections and beyond (`point`: on the mid-plane alone), ux = 0 at
 * x <= 0 on the mid-plane. Cantilever: nodes in the channel, x <= 0 in the laboratory, uy = 0 and, with the
 * full clamp, ux = v0 t. A wrong code may hold the nodes one further in instead. */
static unsigned held_of_beam(const Mpm *mpm, long step, int i, int j)
{
    const double x = mpm->xmin + mpm_shift(mpm, step) * mpm->dx + i * mpm->dx, close = 1e-6 * mpm->dx;
    const double in = mpm->dx, far = mpm->def.length;
    /* of splines the nodes beyond the ends stay free: held too, they would hold the slope of the end */
    const bool next = mpm_does(mpm, WRONG_HOLDS_NEXT),
               there = next || (mpm->shape == MPM_BSPLINE2 && !mpm->def.leaves_channel);
    const bool left = there ? fabs(x - (next ? in : 0.0)) <= close : x <= close;
    const bool right = there ? fabs(x - (next ? far - in : far)) <= close : x >= far - close;
    const bool middle = fabs(mpm->ymin + j * mpm->dx) <= close;
    if (mpm->def.leaves_channel)
        return (left ? HELD_Y : 0) | (left && mpm->def.clamp == CLAMP_FULL ? HELD_X : 0);
    return (left && middle ? HELD_X : 0) |
           ((left || right) && (middle || mpm->def.ends == PLANE_SECTION) ? HELD_Y : 0);
}

/* A bar's end nodes, and uGIMP's and CPDI's ghosts beyond them; a wrong code may hold those beside. */
unsigned mpm_held(const Mpm *mpm, long step, int node)
{
    ASSERT_INDEX(node, mpm->n_nodes);
    if (mpm->dim == 2)
        return held_of_beam(mpm, step, node % mpm->gx, node / mpm->gx);
    const int last = mpm->n_nodes - 1;
    if (mpm_does(mpm, WRONG_HOLDS_NEXT))
        return (mpm->fixed_left > 0 && node == mpm->fixed_left) ||
               (mpm->fixed_right > 0 && node == last - mpm->fixed_right);
    return node < mpm->fixed_left || node > last - mpm->fixed_right;
}

/* Only a grid that rides past its supports has other nodes held from step to step: as soon as one more is. */
void mpm_find_held(Mpm *mpm, long step)
{
    if (mpm->bodies) /* walls know their nodes */
        return;
    const long riding = mpm->dim == 2 ? lround(ceil(mpm_shift(mpm, step) + mpm->xmin / mpm->dx - 1e-6)) : 0;
    if (mpm->held_known && mpm->held_riding == riding && mpm->held_mistake == mpm->head->mistake)
        return;
    for (int i = 0; i < mpm->n_nodes; i++)
        for (int axis = 0; axis < mpm->dim; axis++)
            mpm->free[axis][i] = mpm_held(mpm, step, i) & (unsigned)(HELD_X << axis) ? 0.0 : 1.0;
    mpm->held_known = true;
    mpm->held_riding = riding;
    mpm->held_mistake = mpm->head->mistake;
}

double mpm_node_force(const Mpm *mpm, int axis, int node)
{
    if (mpm_holds_force(mpm, axis, node))
        return 0.0;
    return mpm_is_loaded(mpm) ? mpm->force[axis][node] + mpm->load[node] : mpm->force[axis][node];
}

/* p/m with lumped masses, or the solution of M v = p; at present, so behind `integrate` with the force in it.
 */
double mpm_node_velocity(const Mpm *mpm, int axis, int node)
{
    ASSERT_INDEX(node, mpm->n_nodes);
    if (mpm_is_lumped(mpm)) {
        const double mass = mpm->node_mass[node];
        return mass > mpm->floor ? mpm->momentum[axis][node] / mass : axis == 0 ? mpm->speed : 0.0;
    }
    /* USF keeps the velocity that strained */
    const bool integrated = mpm->head->algorithm == MPM_USF && mpm_has_done(mpm, OP_INTEGRATE);
    return (integrated ? mpm->carry : mpm->velocity)[axis][node];
}

double mpm_node_acceleration(const Mpm *mpm, int axis, int node)
{
    ASSERT_INDEX(node, mpm->n_nodes);
    if (!mpm_has_done(mpm, OP_FORCE))
        return 0.0;
    return mpm_is_lumped(mpm) ? mpm_node_force(mpm, axis, node) * mpm->inverse[node]
                              : mpm->kick[axis][node] / mpm->dt;
}
