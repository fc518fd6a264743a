/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The work of the stages over everything. That of particles is shared out by blocks, that of nodes by
 * columns; the arithmetic is in kernels/plane_kernels.c, the supports are here:
 *
 *     supports            p_i = m_i (v0, 0) in the components that are held
 *     supports on forces  held: work -= f_x v0 dt, then f = 0
 *
 * Whole steps do them one after the other over everything, or in the parts of fast/plane_parts.h. */
#include "base/assertion.h"
#include "methods/mpm/plane/kernels/plane_kernels.h"

#include <stdio.h>

/* --- particles --------------------------------------------------------------------------------------- */

static double *slots_of(const Plane *plane, int worker)
{
    return plane->slots + (size_t)worker * plane_slot_numbers(plane);
}

/* Whether a stage gives to nodes, so that these have to be gathered from the blocks' patches. */
static bool gives(PlaneOp op)
{
    return op == PLANE_MAP || op == PLANE_MAP_AGAIN || op == PLANE_FORCE;
}

static bool of_nodes(PlaneOp op)
{
    return op == PLANE_HOLD || op == PLANE_HOLD_AGAIN || op == PLANE_HOLD_FORCE || op == PLANE_INTEGRATE;
}

/* The stages [0, count) on the particles of one block, as far as they go well: a block is 8 P columns of the
 * beam, some hundred particles in whose 100 bytes each everything happens. A strain and the force behind
 * it are one loop. */
static void do_block(Plane *plane, int block, int worker, const PlaneTask *tasks, int count)
{
    const PlaneKernels *kernels = plane->kernels;
    double *slots = slots_of(plane, worker);
    PlaneTrouble *trouble = &plane->trouble[block];
    *trouble = (PlaneTrouble){-1, 0};
    plane->far[block] = false;
    for (int k = 0; k < count && trouble->place < 0; k++) {
        trouble->op = (int32_t)tasks[k].op;
        switch (tasks[k].op) {
        case PLANE_MAP:
            kernels->find(plane, block, tasks[k].step);
            plane->far[block] = !kernels->map(plane, block, slots, true);
            break;
        case PLANE_MAP_AGAIN:
            plane->far[block] = !kernels->map(plane, block, slots, false);
            break;
        case PLANE_STRAIN:
            if (k + 1 < count && tasks[k + 1].op == PLANE_FORCE) {
                plane->far[block] = !kernels->strain_and_force(plane, block, slots, &trouble->place);
                k++;
            } else
                trouble->place = kernels->strain(plane, block);
            break;
        case PLANE_FORCE:
            plane->far[block] = !kernels->force(plane, block, slots);
            break;
        case PLANE_UPDATE:
            trouble->place = kernels->update(plane, block, tasks[k].step);
            break;
        default:
            break;
        }
    }
}

/* What went wrong first: in the order of stages, then of places. */
static bool judge(Plane *plane, const PlaneTask *tasks, int count, int first, int end, Status *status)
{
    for (int k = 0; k < count; k++)
        for (int block = first; block < end; block++) {
            const PlaneTrouble *trouble = &plane->trouble[block];
            if (trouble->place < 0 || trouble->op != (int32_t)tasks[k].op)
                continue;
            return batch_fail_particle(
                &plane->sim, status, plane_particle(plane, trouble->place),
                tasks[k].op == PLANE_UPDATE ? "left the grid" : "was crushed (1 + exx + eyy <= 0)", " s");
        }
    return true;
}

/* One event a step, of particles that cross for the first time: those of a lattice cross many at once. */
static void report_crossings(Plane *plane)
{
    PlaneCrossing all = {0, 0};
    for (int block = 0; block < plane->n_blocks; block++) {
        const PlaneCrossing *of = &plane->crossings[block];
        if (of->count > 0 && (all.count == 0 || of->first < all.first))
            all.first = of->first;
        all.count += of->count;
    }
    if (all.count == 0)
        return;
    char text[120];
    const int at = plane_at(plane, all.first);
    const int column = plane_cell(plane, plane->x[at], plane_xmin(plane, plane->sim.step + 1));
    int used = snprintf(text, sizeof text, "particle %d crossed into cell (%d, %d)", all.first, column,
                        plane_cell(plane, plane->y[at], plane->ymin));
    if (all.count > 1)
        snprintf(text + used, sizeof text - (size_t)used, ", %d others with it", all.count - 1);
    batch_report(&plane->sim, EVENT_CROSSING, text);
}

/* --- nodes ------------------------------------------------------------------------------------------- */

static PlaneNodes rows_of(const Plane *plane, int first, int end)
{
    return (PlaneNodes){first, end, 0, plane->gx};
}

static int smaller(int a, int b)
{
    return a < b ? a : b;
}

static int larger(int a, int b)
{
    return a > b ? a : b;
}

/* Whether a support reaches into a part of the grid at all: columns are held alike in every row, or not. */
static bool is_held(const Plane *plane, long step, PlaneNodes part)
{
    const PlaneHeldColumns held = plane_held_columns(plane, step, part.row);
    return part.column < held.left || part.end_column > held.right;
}

/* Supports, paper M's step 2 and paper P's eqs. 12, 13: p = m v0 along where x is held, 0 across where y is.
 * The mass stays. */
static void hold(Plane *plane, long step, PlaneNodes part)
{
    const int end_row = is_held(plane, step, part) ? part.end_row : part.row;
    for (int j = part.row; j < end_row; j++) {
        const PlaneHeldColumns held = plane_held_columns(plane, step, j);
        const int left = smaller(held.left, part.end_column), right = larger(held.right, part.column);
        double *px = plane->px + j * plane->gx, *py = plane->py + j * plane->gx;
        const double *mass = plane->node_mass + j * plane->gx;
        for (int i = part.column; i < left && held.at_left.x; i++)
            px[i] = mass[i] * plane->speed;
        for (int i = part.column; i < left && held.at_left.y; i++)
            py[i] = 0;
        for (int i = right; i < part.end_column && held.at_right.y; i++)
            py[i] = 0;
    }
    plane->kernels->velocities(plane, part);
}

/* Supports take the force of the nodes that they hold. The one along a channel that moves with
 * v0 does work on the beam: push is its force, N/m, column by column, from the lowest row up. */
static void hold_force(Plane *plane, long step, PlaneNodes part)
{
    const int end_row = is_held(plane, step, part) ? part.end_row : part.row;
    for (int i = part.column; i < part.end_column && part.row == 0; i++)
        plane->push[i] = 0;
    for (int j = part.row; j < end_row; j++) {
        const PlaneHeldColumns held = plane_held_columns(plane, step, j);
        const int left = smaller(held.left, part.end_column), right = larger(held.right, part.column);
        double *fx = plane->fx + j * plane->gx, *fy = plane->fy + j * plane->gx;
        for (int i = part.column; i < left && held.at_left.x; i++) {
            plane->push[i] += fx[i];
            fx[i] = 0;
        }
        for (int i = part.column; i < left && held.at_left.y; i++)
            fy[i] = 0;
        for (int i = right; i < part.end_column && held.at_right.y; i++)
            fy[i] = 0;
    }
}

/* -f_x v0 dt times the thickness, J: f_x is the beam's force on the nodes. In the order of columns. */
static void add_work(Plane *plane)
{
    double push = 0;
    for (int i = 0; i < plane->gx; i++)
        push += plane->push[i];
    plane->head->work -= push * plane->speed * plane->dt * plane->def.thickness;
}

static void gather(Plane *plane, PlaneOp op, PlaneNodes part)
{
    if (op == PLANE_FORCE)
        plane->kernels->gather_force(plane, part);
    else
        plane->kernels->gather_map(plane, part, op == PLANE_MAP);
}

static bool any_far(const Plane *plane)
{
    for (int block = 0; block < plane->n_blocks; block++)
        if (plane->far[block])
            return true;
    return false;
}

/* All nodes at once, with what particles give that others have left aside. */
static void gather_all(Plane *plane, PlaneOp op)
{
    gather(plane, op, rows_of(plane, 0, plane->gy));
    if (any_far(plane))
        plane_add_far(plane, op);
}

static void do_nodes(Plane *plane, PlaneTask task, PlaneNodes part)
{
    switch (task.op) {
    case PLANE_HOLD:
        plane->kernels->invert(plane, part);
        hold(plane, task.step, part);
        break;
    case PLANE_HOLD_AGAIN:
        hold(plane, task.step, part);
        break;
    case PLANE_HOLD_FORCE:
        hold_force(plane, task.step, part);
        break;
    case PLANE_INTEGRATE:
        plane->kernels->integrate(plane, part);
        break;
    default:
        break;
    }
}

/* --- stage by stage ---------------------------------------------------------------------------------- */

/* Item k of a stage is block k of the particles, or row k of the nodes; there may be fewer of the one. */
bool plane_do(Plane *plane, PlaneTask task, int first, int end, Status *status)
{
    ASSERT_INT(first, >=, 0);
    ASSERT_INT(first, <=, end);
    const PlaneOp op = task.op;
    if (of_nodes(op)) {
        do_nodes(plane, task, rows_of(plane, smaller(first, plane->gy), smaller(end, plane->gy)));
        if (op == PLANE_HOLD_FORCE && end == (int)plane->sim.stage_items)
            add_work(plane);
        return true;
    }
    const int end_block = smaller(end, plane->n_blocks);
    for (int block = first; block < end_block; block++)
        do_block(plane, block, 0, &task, 1);
    if (!judge(plane, &task, 1, first, end_block, status))
        return false;
    if (gives(op) && end == (int)plane->sim.stage_items)
        gather_all(plane, op);
    if (op == PLANE_UPDATE && end == (int)plane->sim.stage_items)
        report_crossings(plane);
    return true;
}

/* --- all of it ---------------------------------------------------------------------------------------- */

#ifdef HAVE_FAST
#include "methods/fast/plane_parts.h"
#else
bool plane_do_all(Plane *plane, const PlaneTask *tasks, int count, Status *status)
{
    ASSERT_INT(count, >=, 1);
    for (int k = 0; k < count; k++)
        if (!plane_do(plane, tasks[k], 0, (int)plane->sim.stage_items, status))
            return false;
    return true;
}
#endif

/* The first two stages of the step that comes: what a row of the series needs of the grid. */
bool plane_map_and_hold(Plane *plane, Status *status)
{
    const PlaneTask tasks[] = {{PLANE_MAP, plane->sim.step}, {PLANE_HOLD, plane->sim.step}};
    return plane_do_all(plane, tasks, 2, status);
}
