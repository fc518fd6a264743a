/* Whole steps tile by tile.
 *
 * Stage after stage over the whole bar, a long bar passes through the processor's cache once for each stage.
 * Here several steps go along the bar together, each stage following the one before it at a distance of a few
 * cells: what a stage has written is still in the cache when the next one comes. The stages are the same
 * functions on ranges of cells, so the bits are the same.
 *
 * What a stage needs of the cells ahead is small: a cell's nodes reach support - 1 <= 3 cells further, and a
 * particle may come from the next cell. A distance of CLEARANCE cells covers both; stages that need nothing
 * from ahead follow at once. */
#include "physics/mpm_bar/bar_null.h"
#include "physics/mpm_bar/bar_state.h"
#include "physics/mpm_bar/kernels.h"

#include <string.h>

enum {
    TILE = 128,        /* cells by which the first stage advances */
    CLEARANCE = 8,     /* also the largest vector, so that ranges are whole vectors */
    IN_FLIGHT = 8,     /* steps that go together */
    CELLS_LEAST = 600, /* a shorter bar is in the cache anyway */
    TASKS_MAX = (IN_FLIGHT + 1) * (OP_COUNT + 2)
};

/* Beside the stages: what a row takes from the particles between steps and from the grid. */
enum { SUM_PARTICLES = OP_COUNT, SUM_NODES };

typedef struct Task {
    int what; /* a BarOp or one of the above */
    int step; /* of those that go together */
    int clearance;
    int done;  /* cells [0, done) are done */
    int ready; /* cells that the next task may count on */
} Task;

typedef struct Flight {
    int n_tasks;
    Task tasks[TASKS_MAX];
    struct { /* for the row of a step */
        BarSums sums;
        int places; /* that are in the sums */
        double grid[BAR_LANES];
        BarNull null;
        int64_t edges; /* cell edges passed in this step, to the right */
    } rows[IN_FLIGHT];
} Flight;

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

static void add_task(Flight *flight, int what, int step)
{
    flight->tasks[flight->n_tasks++] = (Task){.what = what, .step = step, .clearance = clearance_of(what)};
}

static void plan(Flight *flight, const Bar *bar, int steps, bool with_rows)
{
    const BarSchedule *schedule = bar_schedule(bar->head, bar->def.shape);
    flight->n_tasks = 0;
    for (int step = 0; step < steps; step++) {
        for (int stage = 0; stage < schedule->count; stage++) {
            add_task(flight, (int)schedule->ops[stage], step);
            if (with_rows && step > 0 && schedule->ops[stage] == OP_FIX)
                add_task(flight, SUM_NODES, step - 1);
        }
        if (with_rows)
            add_task(flight, SUM_PARTICLES, step);
    }
    if (with_rows) { /* the grid of the last row is that of the step after */
        add_task(flight, OP_MAP, steps);
        add_task(flight, OP_FIX, steps);
        add_task(flight, SUM_NODES, steps - 1);
    }
}

/* Places whose particles are all in cells [0, cell), in whole lanes. */
static int places_before(const Bar *bar, int cell)
{
    if (cell == bar->n_cells)
        return bar->places;
    return bar->first[cell] / bar->slots / BAR_LANES * BAR_LANES;
}

static bool do_task(Bar *bar, Flight *flight, Task *task, int end)
{
    Status unused;
    int ready = end;
    if (task->what == SUM_PARTICLES) {
        int to = places_before(bar, end), *places = &flight->rows[task->step].places;
        bar->kernels->particle_sums(bar, *places, to, &flight->rows[task->step].sums);
        *places = to;
        /* what is not summed yet must stay as it is */
        while (ready < bar->n_cells && bar->first[ready] > to * bar->slots)
            ready--;
    } else if (task->what == SUM_NODES) {
        int last = end == bar->n_cells ? bar->n_nodes : end;
        bar->kernels->node_sums(bar, task->done, last, flight->rows[task->step].grid);
        bar_null_add(bar, &flight->rows[task->step].null, end);
    } else {
        int64_t before = bar->head->cell_sum;
        bar->step_in_flight = task->step;
        if (!bar_do(bar, (BarOp)task->what, task->done, end, &unused))
            return false;
        if (task->what == OP_FORGET)
            flight->rows[task->step].edges += bar->head->cell_sum - before;
    }
    task->done = end;
    task->ready = ready;
    return true;
}

/* All tasks from one end of the bar to the other. */
static bool fly(Bar *bar, Flight *flight)
{
    const Task *last = &flight->tasks[flight->n_tasks - 1];
    flight->tasks[0].clearance = 0;
    for (int front = TILE; last->done < bar->n_cells; front += TILE) {
        int ready = front < bar->n_cells ? front : bar->n_cells;
        for (int i = 0; i < flight->n_tasks; i++) {
            Task *task = &flight->tasks[i];
            int end = ready;
            if (ready < bar->n_cells)
                end = (ready - task->clearance) / CLEARANCE * CLEARANCE;
            if (end > task->done && !do_task(bar, flight, task, end))
                return false;
            ready = task->ready;
        }
    }
    return true;
}

bool bar_tiles_pay(const Bar *bar, bool with_rows)
{
    /* the work of a load is a sum over the nodes, and the energy of the affine motion one over the cells,
     * step by step: these would come in another order */
    if (bar_is_loaded(bar) || (with_rows && bar->head->transfer == MPM_APIC))
        return false;
    return bar->n_cells >= CELLS_LEAST;
}

bool bar_tiled_steps(Bar *bar, long count, double *rows)
{
    bool good = true;
    bar->keeps_crossings = true;
    bar->n_crossings = 0;
    while (count > 0 && good) {
        const int steps = count < IN_FLIGHT ? (int)count : IN_FLIGHT;
        int64_t cell_sum = bar->head->cell_sum;
        Flight flight = {0};
        plan(&flight, bar, steps, rows != NULL);
        good = fly(bar, &flight);
        if (!good)
            break;
        for (int step = 0; rows && step < steps; step++, rows += BAR_SERIES) {
            cell_sum += flight.rows[step].edges;
            bar_write_row(bar, &flight.rows[step].sums, flight.rows[step].grid,
                          bar_null_energy(bar, &flight.rows[step].null), cell_sum, rows);
        }
        bar_report_crossings(bar);
        bar->sim.step += steps;
        count -= steps;
    }
    bar->keeps_crossings = false;
    bar->n_crossings = 0;
    return good;
}
