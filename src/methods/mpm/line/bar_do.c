/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The work of a bar's stages on a range of cells: the kernels, the supports, and what makes a run fail.
 * Stages one by one and whole steps in tiles (fast/bar_tiles.c) both call this. */
#include "base/assertion.h"
#include "methods/mpm/line/bar_mistakes.h"
#include "methods/mpm/line/bar_state.h"
#include "methods/mpm/line/kernels/bar_kernels.h"

#include <string.h>

/* Step 2 of paper M: p_i = 0 at nodes held by a support, among those that come with these cells; their mass
 * stays, so that eqs. 4 and 15 divide by it as everywhere. */
static void fix(Bar *bar, int first, int end)
{
    int last = end == bar->n_cells ? bar->n_nodes : end;
    for (int i = first; i < last && i < bar->fixed_left; i++)
        bar->node_momentum[i] = 0.0;
    for (int i = last - 1; i >= first && i >= bar->n_nodes - bar->fixed_right; i--)
        bar->node_momentum[i] = 0.0;
}

/* x <- M^-1 x, or FMPM's series: of all nodes. */
static void solve(Bar *bar, double *x)
{
    if (bar->head->transfer == MPM_FMPM)
        bar->kernels->series(bar, x);
    else
        bar->kernels->solve(bar, x);
}

/* Eq. 4 in three forms: p/m with lumped masses, M v = p with blended ones, FMPM's series. The latter two take
 * all nodes, so they are done with the last cell. */
static void find_velocities(Bar *bar, int first, int end, bool factor)
{
    if (bar_is_lumped(bar)) {
        bar->kernels->velocities(bar, first, end);
        return;
    }
    if (end < bar->n_cells)
        return;
    if (factor && bar->head->transfer != MPM_FMPM)
        bar->kernels->factor(bar);
    memcpy(bar->node_velocity, bar->node_momentum, (size_t)bar->n_nodes * sizeof(double));
    solve(bar, bar->node_velocity);
}

/* dt a with M a = f, eqs. 12, 13, or FMPM's series of dt f: it is linear, so that v(k) of p + dt f is the sum
 * of both. With lumped masses integrate() does it node by node. Units of a velocity. */
static void find_kicks(Bar *bar, int end)
{
    if (bar_is_lumped(bar) || end < bar->n_cells)
        return;
    const bool loaded = bar_is_loaded(bar);
    for (int i = 0; i < bar->n_nodes; i++)
        bar->node_kick[i] = bar->dt * (loaded ? bar->node_f_int[i] + bar->node_f_ext[i] : bar->node_f_int[i]);
    solve(bar, bar->node_kick);
}

/* Eqs. 2 and 3, per unit cross-section; with blended masses or FMPM also
 * the couplings M_c(i, j) of different nodes. */
static void map(Bar *bar, int first, int end)
{
    if (bar->def.shape == MPM_CPDI)
        bar->kernels->halve_domains(bar, first, end);
    bar->kernels->map(bar, first, end);
    if (!bar_is_lumped(bar))
        bar->kernels->couple(bar, first, end);
}

/* The supports, then eq. 4. `factor`: the matrix of the masses is new; MUSL's second map has the same one. */
static void fix_and_divide(Bar *bar, int first, int end, bool factor)
{
    fix(bar, first, end);
    find_velocities(bar, first, end, factor);
}

/* False: the run fails. A particle with 1 + de <= 0 (eq. 8 would turn its density negative) stops it; so
 * do those of bar_settle(). */
bool bar_do(Bar *bar, BarOp op, int first, int end, Status *status)
{
    ASSERT_INT(first, >=, 0);
    ASSERT_INT(first, <=, end);
    ASSERT_INT(end, <=, bar->n_cells);
    const BarKernels *kernels = bar->kernels;
    if (bar_mistake(bar))
        return bar_do_wrongly(bar, op, first, end, status);
    switch (op) {
    case OP_MAP:
        map(bar, first, end);
        return true;
    case OP_FIX:
        fix_and_divide(bar, first, end, true);
        return true;
    case OP_STRAIN: {
        int bad = kernels->strain(bar, first, end);
        if (bad >= 0)
            return bar_fail_particle(bar, status, bad, "was crushed (1 + de <= 0)");
        const int long_one = bar->def.shape == MPM_CPDI ? kernels->too_long(bar, first, end) : -1;
        return long_one < 0 || bar_fail_particle(bar, status, long_one, "was stretched over two cells");
    }
    case OP_FORCE:
        kernels->force(bar, first, end);
        bar_add_forces(bar, end);
        find_kicks(bar, end);
        return true;
    case OP_INTEGRATE:
        kernels->integrate(bar, first, end);
        return true;
    case OP_UPDATE:
        kernels->update(bar, first, end);
        return true;
    case OP_MAP_AGAIN:
        kernels->map(bar, first, end); /* the masses are as they were */
        fix_and_divide(bar, first, end, false);
        return true;
    case OP_FORGET:
        return bar_settle(bar, first, end, status);
    case OP_COUNT:
        break;
    }
    return true;
}

void bar_map_and_fix(Bar *bar)
{
    Status unused; /* neither of them fails */
    bar_do(bar, OP_MAP, 0, bar->n_cells, &unused);
    bar_do(bar, OP_FIX, 0, bar->n_cells, &unused);
}
