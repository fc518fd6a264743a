/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Who is linked with whom by shape functions: particles and nodes, and nodes and a place. During a step they
 * are those of its beginning. */
#include "base/assertion.h"
#include "methods/mpm/engine.h"

/* The nodes of a place; those with neither weight nor slope are left out: a box far from its last node has no
 * part in it. */
static size_t links_at(const Mpm *mpm, MpmWeights w, int base, Link *out, size_t max)
{
    size_t count = 0;
    for (int b = 0; b < mpm_across(mpm); b++)
        for (int a = 0; a < mpm->support && count < max; a++) {
            const Link link = {
                .set = MPM_NODES,
                .index = (size_t)(base + b * mpm->gx + a),
                .weight = w.n[0][a] * w.n[1][b],
                .gradient = {w.dn[0][a] * w.n[1][b] / mpm->dx, w.n[0][a] * w.dn[1][b] / mpm->dx}};
            if (link.weight != 0.0 || link.gradient[0] != 0.0 || link.gradient[1] != 0.0)
                out[count++] = link;
        }
    return count;
}

/* Along a line particles are in order: the first whose nodes reach so far, by bisection. */
static int first_reaching(const Mpm *mpm, int node)
{
    int low = 0, high = mpm->n_particles;
    while (mpm->dim == 1 && low < high) {
        const int middle = low + (high - low) / 2;
        if (mpm->base[middle] + mpm->support > node)
            high = middle;
        else
            low = middle + 1;
    }
    return low;
}

size_t mpm_links(const Simulation *sim, int set, size_t index, Link *out, size_t max)
{
    const Mpm *mpm = mpm_of_const(sim);
    size_t count = 0;
    ASSERT_INT(index, <, sim->counts[set]);
    if (set == MPM_PARTICLES)
        return links_at(mpm, mpm_weights_of(mpm, (int)index), mpm->base[index], out, max);
    for (int p = first_reaching(mpm, (int)index); p < mpm->n_particles && count < max; p++) {
        const int away = (int)index - mpm->base[p];
        if (mpm->dim == 1 && away < 0)
            break;
        if (away < 0 || away / mpm->gx >= mpm->support || away % mpm->gx >= mpm->support)
            continue;
        Link links[SHAPE_SUPPORT_MAX * SHAPE_SUPPORT_MAX];
        const size_t n =
            links_at(mpm, mpm_weights_of(mpm, p), mpm->base[p], links, sizeof links / sizeof *links);
        for (size_t k = 0; k < n; k++)
            if (links[k].index == index) {
                out[count] = links[k];
                out[count].set = MPM_PARTICLES;
                out[count++].index = (size_t)p;
            }
    }
    return count;
}

/* A place on the right end of a line's mesh belongs to the last cell. */
size_t mpm_shapes(const Simulation *sim, const double *place, Link *out, size_t max)
{
    const Mpm *mpm = mpm_of_const(sim);
    int node[MPM_AXES] = {0};
    double s[MPM_AXES] = {0};
    for (int axis = 0; axis < mpm->dim; axis++) {
        const double r = mpm_grid_place(mpm, axis, place[axis]);
        const bool last = mpm->dim == 1 && r == mpm->high[0];
        if (!(r >= mpm->low[axis] && (r < mpm->high[axis] || last)))
            return 0;
        node[axis] = (int)r - last;
        s[axis] = r - node[axis];
    }
    const int base = node[1] * mpm->gx + node[0];
    /* CPDI's functions differ from particle to particle: those of the one that is nearest in the cell */
    double half = mpm->half, nearest = INFINITY;
    for (int p = mpm->shape == MPM_CPDI ? first_reaching(mpm, base) : mpm->n_particles;
         p < mpm->n_particles && mpm->base[p] <= base; p++)
        if (mpm->base[p] == base && fabs(mpm->s[0][p] - s[0]) < nearest) {
            nearest = fabs(mpm->s[0][p] - s[0]);
            half = mpm_half(mpm, p);
        }
    return links_at(mpm, mpm_weights(mpm, half, base, s), base, out, max);
}
