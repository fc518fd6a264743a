/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whole steps tile by tile, for bars that are larger than the processor's cache.
 *
 * Done stage after stage over the whole bar, every stage reads all particles from memory. Here the stages of
 * STEPS_TOGETHER steps form a pipeline of tasks that advances along the bar, each task following the one
 * before it at a distance of a few cells: what one has written is still in the cache when the next one reads
 * it. Memory is read once for STEPS_TOGETHER steps, not once for each stage of each step.
 *
 *     cells    0 ........................................ n_cells
 *     map      ==========================>|
 *     fix      ==========================>|
 *     strain   ==================>|             at least CLEARANCE cells behind what it reads
 *     force    ==========>|
 *
 * The tasks are the same functions on ranges of cells (bar_do), and every sum has a fixed order, so the bits
 * are those of steps done one by one.
 *
 * What a task needs of the cells ahead is small: a cell's nodes reach support - 1 <= 3 cells further, and a
 * particle may come from the next cell. A distance of CLEARANCE cells covers both; tasks that need nothing
 * from ahead follow at once. A failure, or a particle that jumps over a whole cell, ends the pipeline, and
 * the caller does the steps again stage by stage over the whole bar (bar_steps.c). */
#include "base/assertion.h"
#include "methods/mpm/line/bar_mistakes.h"
#include "methods/mpm/line/bar_null.h"
#include "methods/mpm/line/bar_state.h"
#include "methods/mpm/line/kernels/bar_kernels.h"

enum {
    TILE = 128,         /* cells by which the first stage advances */
    CLEARANCE = 8,      /* also the largest vector, so that ranges are whole vectors */
    STEPS_TOGETHER = 8, /* steps in the pipeline */
    CELLS_LEAST = 600,  /* a shorter bar is in the cache anyway */
    TASKS_MAX = (STEPS_TOGETHER + 1) * (OP_COUNT + 2)
};

/* Beside the stages: what a row takes from the particles between steps and from the grid. */
enum { SUM_PARTICLES = OP_COUNT, SUM_NODES };

typedef struct Task {
    int what; /* a BarOp or one of the above */
    int step; /* counted from the first in the pipeline */
    int clearance;
    int done;  /* cells [0, done) are done */
    int ready; /* cells that the next task may count on */
} Task;

typedef struct Pipeline {
    int n_tasks;
    Task tasks[TASKS_MAX];
    struct { /* for the row of a step */
        BarSums sums;
        int places; /* that are in the sums */
        double grid[BAR_LANES];
        BarNull null;
        int64_t edges; /* cell edges passed in this step, to the right */
    } rows[STEPS_TOGETHER];
} Pipeline;

/* OP_FORCE needs nothing from ahead, but its cells give into the same arrays as those of OP_MAP. */
static int clearance_of(int what)
{
    switch (what) {
    case OP_FIX:
    case OP_INTEGRATE:
    case OP_MAP_AGAIN:
    case SUM_NODES:
        return 0;
    default:
        return CLEARANCE;
    }
}

static void add_task(Pipeline *pipeline, int what, int step)
{
    pipeline->tasks[pipeline->n_tasks++] =
        (Task){.what = what, .step = step, .clearance = clearance_of(what)};
}

/* The tasks in the order of the stages, step after step. A row is of the state after a step: its sums over
 * particles follow the step's last stage, its sums over nodes, if it has any, the next step's boundary
 * conditions. */
static void plan(Pipeline *pipeline, const Bar *bar, int steps, bool with_rows)
{
    const BarSchedule *schedule = bar_schedule(bar);
    const bool needs_grid = with_rows && bar_row_needs_grid(bar);
    pipeline->n_tasks = 0;
    for (int step = 0; step < steps; step++) {
        for (int stage = 0; stage < schedule->count; stage++) {
            add_task(pipeline, (int)schedule->ops[stage], step);
            if (needs_grid && step > 0 && schedule->ops[stage] == OP_FIX)
                add_task(pipeline, SUM_NODES, step - 1);
        }
        if (with_rows)
            add_task(pipeline, SUM_PARTICLES, step);
    }
    if (needs_grid) { /* the grid of the last row is that of the step after */
        add_task(pipeline, OP_MAP, steps);
        add_task(pipeline, OP_FIX, steps);
        add_task(pipeline, SUM_NODES, steps - 1);
    }
}

/* Places whose particles are all in cells [0, cell), in whole lanes; behind the last particle all of them,
 * or each tile of empty cells would go back to it. */
static int places_before(const Bar *bar, int cell)
{
    if (bar->first[cell] == bar->n_particles)
        return bar->places;
    return bar->first[cell] / bar->slots / BAR_LANES * BAR_LANES;
}

/* Advances one task to cell `end`. False: its work failed, or must be seen in order. */
static bool do_task(Bar *bar, Pipeline *pipeline, Task *task, int end)
{
    Status unused;
    int ready = end;
    if (task->what == SUM_PARTICLES) {
        int to = places_before(bar, end), *places = &pipeline->rows[task->step].places;
        bar->kernels->particle_sums(bar, *places, to, &pipeline->rows[task->step].sums);
        *places = to;
        /* what is not summed yet must stay as it is */
        while (ready < bar->n_cells && bar->first[ready] > to * bar->slots)
            ready--;
    } else if (task->what == SUM_NODES) {
        int last = end == bar->n_cells ? bar->n_nodes : end;
        if (bar->has_grid_energy)
            bar->kernels->node_sums(bar, task->done, last, pipeline->rows[task->step].grid);
        if (bar->has_null_energy)
            bar_null_add(bar, &pipeline->rows[task->step].null, end);
    } else {
        int64_t before = bar->head->cell_sum;
        bar->pipeline_step = task->step;
        if (!bar_do(bar, (BarOp)task->what, task->done, end, &unused))
            return false;
        if (task->what == OP_FORGET)
            pipeline->rows[task->step].edges += bar->head->cell_sum - before;
    }
    task->done = end;
    task->ready = ready;
    return true;
}

/* Drives all tasks along the bar: the first advances by a tile, each other up to the clearance behind what
 * its predecessor has finished, in whole multiples of CLEARANCE so that ranges hold whole vectors; at the
 * right end no clearance is left. False: a task failed. */
static bool run_pipeline(Bar *bar, Pipeline *pipeline)
{
    const Task *last = &pipeline->tasks[pipeline->n_tasks - 1];
    pipeline->tasks[0].clearance = 0;
    for (int front = TILE; last->done < bar->n_cells; front += TILE) {
        int ready = front < bar->n_cells ? front : bar->n_cells;
        for (int i = 0; i < pipeline->n_tasks; i++) {
            Task *task = &pipeline->tasks[i];
            int end = ready;
            if (ready < bar->n_cells)
                end = (ready - task->clearance) / CLEARANCE * CLEARANCE;
            if (end > task->done && !do_task(bar, pipeline, task, end))
                return false;
            ready = task->ready;
        }
    }
    return true;
}

/* Whether whole steps go in tiles. Not where something is summed in an order that tiles would change. */
bool bar_tiles_pay(const Bar *bar, bool with_rows)
{
    /* a load's work is summed over all nodes step by step, and so is the energy of the affine motion over the
     * cells, and of two materials: tiles would add them up in another order. One solution for all nodes needs
     * all of them. What a wrong code does is done stage by stage. */
    if (bar_mistake(bar) || !bar_is_lumped(bar) || bar_is_loaded(bar) ||
        (with_rows && (bar->head->transfer == MPM_APIC || bar->def.joint > 0.0)))
        return false;
    return bar->n_cells >= CELLS_LEAST;
}

/* `count` whole steps, STEPS_TOGETHER at a time, with the rows of their series if they are asked for. */
bool bar_tiled_steps(Bar *bar, long count, double *rows)
{
    ASSERT_INT(count, >=, 1);
    bool good = true;
    bar->keeps_crossings = true;
    bar->n_crossings = 0;
    while (count > 0 && good) {
        const int steps = count < STEPS_TOGETHER ? (int)count : STEPS_TOGETHER;
        int64_t cell_sum = bar->head->cell_sum;
        Pipeline pipeline = {0};
        plan(&pipeline, bar, steps, rows != NULL);
        good = run_pipeline(bar, &pipeline);
        if (!good)
            break;
        for (int step = 0; rows && step < steps; step++, rows += bar->sim.n_series) {
            cell_sum += pipeline.rows[step].edges;
            bar_write_row(bar, &pipeline.rows[step].sums, pipeline.rows[step].grid,
                          bar->has_null_energy ? bar_null_energy(bar, &pipeline.rows[step].null) : 0,
                          cell_sum, rows);
        }
        bar_report_crossings(bar);
        bar->sim.step += steps;
        count -= steps;
    }
    bar->keeps_crossings = false;
    bar->n_crossings = 0;
    return good;
}
