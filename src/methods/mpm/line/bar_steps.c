/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stages and whole steps of a bar as the driver asks for them (method.h). Whole steps go in batches
 * (batch.h). */
#include "base/assertion.h"
#include "methods/mpm/line/bar_state.h"

#include <string.h>

static double energy(const Simulation *sim)
{
    return bar_energy(bar_of_const(sim));
}

static bool check_energy(Bar *bar, Status *status)
{
    const bool light = bar_feels_light_nodes(&bar->def, bar->head->transfer);
    const GrowthNow now = {bar->energy_start, energy, bar->head->work, "",
                           light ? "another shape: " BAR_LIGHT_NODES : "another algorithm"};
    return batch_check_energy(&bar->sim, &bar->head->growth, &now, status);
}

/* --- stages --------------------------------------------------------------------------------------- */

/* One stage on cells [first, end), for whoever looks at a step from inside (method.h). The energy is checked
 * behind the last stage. */
bool bar_stage(Simulation *sim, int stage, size_t first, size_t end, Status *status)
{
    ASSERT_INDEX(stage, sim->n_stages);
    ASSERT_INT(first, <=, end);
    ASSERT_INT(end, <=, sim->stage_items);
    Bar *bar = bar_of(sim);
    const BarSchedule *schedule = bar_schedule(bar);
    /* what a step that can be looked at has not written yet is 0, so that its snapshots are the same bytes
     * whatever ran before */
    if (stage == 0 && first == 0)
        memset((char *)bar->block + bar->bytes_kept, 0, bar->bytes_whole - bar->bytes_kept);
    if (!bar_do(bar, schedule->ops[stage], (int)first, (int)end, status))
        return false;
    return stage + 1 < schedule->count || end < sim->stage_items || check_energy(bar, status);
}

/* --- whole steps --------------------------------------------------------------------------------- */

static void keep(Simulation *sim)
{
    Bar *bar = bar_of(sim);
    memcpy(bar->backup, bar->block, bar_lasting_bytes(bar, bar->head));
}

static void put_back(Simulation *sim)
{
    Bar *bar = bar_of(sim);
    memcpy(bar->block, bar->backup, bar_lasting_bytes(bar, bar->head));
    bar_count_odd_cells(bar);
}

/* Whole steps over the whole bar, stage by stage. A row may need the grid after map and boundary conditions,
 * which are also the first two stages of the next step: they are done once for both. */
static bool whole_steps(Bar *bar, long count, double *rows, Status *status)
{
    const BarSchedule *schedule = bar_schedule(bar);
    if (count > 0)
        bar_map_and_fix(bar);
    for (long n = 0; n < count; n++) {
        for (int stage = 2; stage < schedule->count; stage++)
            if (!bar_do(bar, schedule->ops[stage], 0, bar->n_cells, status))
                return false;
        if (!check_energy(bar, status))
            return false;
        bar->sim.step++;
        if (n + 1 < count || (rows && bar_row_needs_grid(bar)))
            bar_map_and_fix(bar);
        if (rows)
            bar_step_row(bar, rows + n * bar->sim.n_series);
    }
    return true;
}

static bool some_steps(Simulation *, long count, double *rows, Status *);

static const Batches batches = {keep, put_back, some_steps};

/* In tiles where that pays, else, or if something went wrong there, stage by stage over the whole bar: two
 * ways to the same bits. */
static bool some_steps(Simulation *sim, long count, double *rows, Status *status)
{
    Bar *bar = bar_of(sim);
#ifdef HAVE_FAST
    if (bar_tiles_pay(bar, rows != NULL)) {
        /* the particles were kept when the batch began */
        const BatchMark mark = {sim->step, sim->n_events, sim->events_beyond};
        if (bar_tiled_steps(bar, count, rows)) {
            sim->step--;
            const bool good = check_energy(bar, status);
            sim->step++;
            if (good)
                return true;
        }
        batch_return(sim, &batches, mark);
    }
#endif
    return whole_steps(bar, count, rows, status);
}

bool bar_steps(Simulation *sim, long count, double *rows, long *done, Status *status)
{
    ASSERT_INT(count, >=, 0);
    ASSERT_INT(sim->stage, ==, 0);
    return batch_steps(sim, &batches, count, rows, done, status);
}
