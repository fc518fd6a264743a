/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The last stage of a step, "forget the grid": every particle takes its new natural coordinate,
 *
 *     s + sum N_i drift_i = edges + s',   0 <= s' < 1,   cell' = cell + edges        (eq. 15)
 *
 * which is exact: only whole numbers are taken off. Cells are done one by one from the left; a cell none of
 * whose particles leaves is done by a kernel. Here a run fails when a particle leaves the mesh or overtakes
 * its neighbour, and first crossings of a cell's edge become events. */
#include "base/assertion.h"
#include "methods/mpm/line/bar_state.h"
#include "methods/mpm/line/kernels/bar_kernels.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool bar_fail_particle(Bar *bar, Status *status, int particle, const char *what)
{
    ASSERT_INDEX(particle, bar->n_particles);
    const bool light = bar_feels_light_nodes(&bar->def, bar->head->transfer);
    char text[160];
    snprintf(text, sizeof text, "%s%s", what, light ? " (" BAR_LIGHT_NODES ")" : "");
    return batch_fail_particle(&bar->sim, status, particle, text, "");
}

static bool leave_mesh(Bar *bar, Status *status, int particle, bool to_left)
{
    const bool box = bar->def.shape == MPM_GIMP || bar->def.shape == MPM_CPDI;
    const bool held = (to_left ? bar->fixed_left : bar->fixed_right) > 0;
    return bar_fail_particle(bar, status, particle,
                             box && held ? "left the mesh through a support (its box reaches past the fixed "
                                           "node, which stops only the grid)"
                                         : "left the mesh");
}

static void report_crossing(Bar *bar, int particle, int cell)
{
    if (bar->sim.n_events == SIMULATION_EVENTS_MAX) {
        bar->sim.events_beyond++;
        return;
    }
    char text[80];
    snprintf(text, sizeof text, "particle %d crossed into cell %d", particle, cell);
    batch_report(&bar->sim, EVENT_CROSSING, text);
}

static int by_step_and_particle(const void *left, const void *right)
{
    const BarCrossing *a = left, *b = right;
    return a->step != b->step ? (a->step < b->step ? -1 : 1)
                              : (a->particle > b->particle) - (a->particle < b->particle);
}

/* In the order in which steps done one by one would have met them. */
void bar_report_crossings(Bar *bar)
{
    const long start = bar->sim.step;
    qsort(bar->crossings, (size_t)bar->n_crossings, sizeof bar->crossings[0], by_step_and_particle);
    for (int i = 0; i < bar->n_crossings; i++) {
        bar->sim.step = start + bar->crossings[i].step;
        report_crossing(bar, bar->crossings[i].particle, bar->crossings[i].cell);
    }
    bar->sim.step = start;
    bar->n_crossings = 0;
}

/* Only the first crossing of each particle is reported. False: the tiles must give up. */
static bool note_crossing(Bar *bar, int particle, int cell)
{
    uint64_t bit = (uint64_t)1 << (particle % 64);
    if (bar->crossed[particle / 64] & bit)
        return true;
    bar->crossed[particle / 64] |= bit;
    if (bar->keeps_crossings) {
        int room = SIMULATION_EVENTS_MAX - bar->sim.n_events;
        if (room == 0)
            bar->sim.events_beyond++;
        else if (bar->n_crossings == room)
            return false; /* which of them come first is not known yet */
        else
            bar->crossings[bar->n_crossings++] = (BarCrossing){bar->pipeline_step, particle, cell};
        return true;
    }
    report_crossing(bar, particle, cell);
    return true;
}

void bar_count_odd_cells(Bar *bar)
{
    memset(bar->odd, 0, ((size_t)bar->n_cells / BAR_CELL_BLOCK + 1) * sizeof *bar->odd);
    for (int c = 0; c < bar->n_cells; c++)
        if (bar->first[c + 1] - bar->first[c] != bar->slots)
            bar->odd[c / BAR_CELL_BLOCK]++;
}

/* Whether a cell does not hold P particles: then it cannot be part of a run. */
static bool is_odd(const Bar *bar, int c)
{
    return bar->first[c + 1] - bar->first[c] != bar->slots;
}

/* Cell c begins with another particle: this changes how many it and the cell before it hold. */
static void set_first(Bar *bar, int c, int particle)
{
    for (int side = c - 1; side <= c; side++)
        if (is_odd(bar, side))
            bar->odd[side / BAR_CELL_BLOCK]--;
    bar->first[c] = particle;
    for (int side = c - 1; side <= c; side++)
        if (is_odd(bar, side))
            bar->odd[side / BAR_CELL_BLOCK]++;
}

/* --- particles to cells --------------------------------------------------------------------------- */

/* Counts the cell edges passed; s comes back to [0, 1). */
static int pass_edges(double *s)
{
    double edges = floor(*s);
    *s -= edges;
    if (*s >= 1.0) { /* -1e-17 + 1 rounds to 1: the particle lies on the edge */
        *s = 0.0;
        edges += 1.0;
    }
    return (int)edges;
}

/* The particles of one cell, in their order. Those that stay or go to a neighbour take their places at once:
 * the ones that go left are the cell's first, those that go right its last, so the cell's range loses them at
 * either end. A jump over a whole cell is left to the end of the stage, settle_all(). */
static bool settle_cell(Bar *bar, int c, Status *status)
{
    const int begin = bar->first[c], end = bar->first[c + 1];
    double before = -INFINITY;
    for (int p = begin; p < end; p++) {
        double moved = bar->moved[p % bar->slots][p / bar->slots];
        if (!(moved >= before))
            return bar_fail_particle(bar, status, p, "was overtaken by its neighbour (1 + de <= 0)");
        before = moved;
        bar->jumped = bar->jumped || moved < -1.0 || moved >= 2.0;
    }
    if (bar->jumped)
        return true;
    int into_left = begin, from_right = end;
    for (int p = begin; p < end; p++) {
        int j = p % bar->slots, k = p / bar->slots;
        double moved = bar->moved[j][k];
        if (moved >= 0.0 && moved < 1.0) {
            bar->s[j][k] = moved;
            continue;
        }
        double s = moved;
        int target = c + pass_edges(&s);
        if (target < 0 || target >= bar->n_cells)
            return leave_mesh(bar, status, p, target < 0);
        if (target < c) {
            if (p > 0 && bar->first[c - 1] < p && !(s >= bar->s[(p - 1) % bar->slots][(p - 1) / bar->slots]))
                return bar_fail_particle(bar, status, p, "was overtaken by its neighbour (1 + de <= 0)");
            into_left = p + 1;
        } else if (target > c && from_right == end)
            from_right = p;
        bar->s[j][k] = bar->moved[j][k] = s;
        if (target != c) {
            bar->head->cell_sum += target - c;
            if (!note_crossing(bar, p, target))
                return false;
        }
    }
    if (into_left != begin)
        set_first(bar, c, into_left);
    if (from_right != end)
        set_first(bar, c + 1, from_right);
    return true;
}

/* After a jump over a whole cell: all particles anew from the cells they were in (old_first), left to right.
 * As particles keep their order, first[] fills from the left too. */
static bool settle_all(Bar *bar, Status *status)
{
    memcpy(bar->old_first, bar->first, ((size_t)bar->n_cells + 1) * sizeof *bar->first);
    int next = 0; /* the next cell whose first particle is not known */
    int last_cell = 0;
    double last_s = 0.0;
    for (int c = 0; c < bar->n_cells; c++)
        for (int p = bar->old_first[c]; p < bar->old_first[c + 1]; p++) {
            int j = p % bar->slots, k = p / bar->slots;
            double s = bar->moved[j][k];
            if (!(s >= -(double)c && s < (double)(bar->n_cells - c)))
                return leave_mesh(bar, status, p, s < 0.0);
            int target = c + pass_edges(&s);
            if (target == bar->n_cells)
                return leave_mesh(bar, status, p, false);
            if (target < last_cell || (target == last_cell && s < last_s))
                return bar_fail_particle(bar, status, p, "was overtaken by its neighbour (1 + de <= 0)");
            last_cell = target;
            last_s = s;
            while (next <= target)
                bar->first[next++] = p;
            bar->s[j][k] = bar->moved[j][k] = s;
            if (target != c) {
                bar->head->cell_sum += target - c;
                if (!note_crossing(bar, p, target))
                    return false;
            }
        }
    while (next <= bar->n_cells)
        bar->first[next++] = bar->n_particles;
    bar_count_odd_cells(bar);
    return true;
}

/* Cells [first, end): whole runs by a kernel where no particle leaves its cell, which is nearly always, else
 * cell by cell. */
bool bar_settle(Bar *bar, int first, int end, Status *status)
{
    ASSERT_INT(first, >=, 0);
    ASSERT_INT(first, <=, end);
    ASSERT_INT(end, <=, bar->n_cells);
    if (first == 0)
        bar->jumped = false;
    for (int c = first; c < end && !bar->jumped;) {
        int limit = c + BAR_CELL_BLOCK < end ? c + BAR_CELL_BLOCK : end, run = bar_run_end(bar, c, limit) - c;
        if (run > 0 && bar->kernels->settle && bar->kernels->settle(bar, run, bar->first[c])) {
            c += run;
            continue;
        }
        int stop = run > 0 ? c + run : c + 1;
        for (; c < stop && !bar->jumped; c++)
            if (!settle_cell(bar, c, status))
                return false;
    }
    if (bar->jumped && bar->keeps_crossings)
        return false; /* tiles cannot wait for the end of the stage: the steps are done again without tiles */
    return end < bar->n_cells || !bar->jumped || settle_all(bar, status);
}
