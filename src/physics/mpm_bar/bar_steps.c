/* Stages and whole steps of a bar: who calls the kernels on which cells, and what may stop a run. */
#include "physics/mpm_bar/bar_state.h"
#include "physics/mpm_bar/kernels.h"
#include "physics/mpm_bar/shape.h"

#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The energy may be multiplied by this before the run is stopped. Heating by cell crossing is a matter of
 * some ten per cent, at worst a small factor; beyond a factor of a hundred in velocity nothing of the bar is
 * left to be seen, and an unstable run gets there in a few hundred steps. */
static const double energy_bound = 1e4;

/* Growth that is reported, each once. */
static const double energy_levels[] = {1.1, 2.0, 10.0, 100.0, 1000.0};
static const char *const energy_words[] = {"by 10 %", "to twice", "to 10 times", "to 100 times",
                                           "to 1000 times"};
enum { ENERGY_LEVELS = sizeof energy_levels / sizeof energy_levels[0] };

/* --- the energy ----------------------------------------------------------------------------------- */

/* The partial sums of a sum, always in the same tree. */
static double fold(const double *lane)
{
    return ((lane[0] + lane[4]) + (lane[2] + lane[6])) + ((lane[1] + lane[5]) + (lane[3] + lane[7]));
}

/* sum m D C^2 / 2 with D = sum N d^2: what the particles' affine motion holds */
static double affine_energy(const Bar *bar)
{
    double sum = 0.0;
    for (int c = 0; c < bar->n_cells; c++)
        for (int p = bar->first[c]; p < bar->first[c + 1]; p++) {
            int j = p % bar->slots, k = p / bar->slots;
            double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX], spread = 0.0, s = bar->s[j][k];
            shape_at(bar->def.shape, bar->gimp_half, bar->n_cells, c, s, n, dn);
            for (int a = 0; a < bar->support; a++) {
                double arm = shape_node_offset(bar->def.shape, bar->n_cells, c, a) - s;
                spread += n[a] * (arm * arm);
            }
            double speed = bar->affine[j][k] * bar->dx;
            sum += spread * (speed * speed);
        }
    return 0.5 * bar->mass * sum;
}

static double kinetic_of(const Bar *bar, const BarSums *sums)
{
    double kinetic = 0.5 * bar->mass * fold(sums->square);
    return bar->head->transfer == MPM_APIC ? kinetic + affine_energy(bar) : kinetic;
}

static double strain_of(const Bar *bar, const BarSums *sums)
{
    return fold(sums->strain) / (2.0 * bar->def.youngs_modulus);
}

double bar_energy(const Bar *bar)
{
    BarSums sums = {.v = {0}};
    bar->kernels->particle_sums(bar, 0, bar->places, &sums);
    return kinetic_of(bar, &sums) + strain_of(bar, &sums);
}

/* At the end of some steps, the same ones however the run is cut and watched. */
static bool check_energy(Bar *bar, Status *status)
{
    if ((bar->sim.step + 1) % BAR_CHECK_EVERY != 0)
        return true;
    BarHead *head = bar->head;
    if (fabs(head->work) > head->peak_work)
        head->peak_work = fabs(head->work);
    double reference = bar->energy_start + head->peak_work, energy = bar_energy(bar);
    if (!(energy <= energy_bound * reference)) {
        char when[80];
        bar_step_words(bar, when, sizeof when);
        return simulation_fail(
            &bar->sim, status,
            "the energy has grown to more than %g times what was put in, %s: the run is unstable"
            " (a smaller courant number, or another algorithm)",
            energy_bound, when);
    }
    while (head->energy_level < ENERGY_LEVELS && energy > energy_levels[head->energy_level] * reference) {
        char text[80];
        snprintf(text, sizeof text, "the energy has grown %s", energy_words[head->energy_level++]);
        bar_report(bar, EVENT_ENERGY, text);
    }
    return true;
}

/* --- stages --------------------------------------------------------------------------------------- */

/* Supports hold the nodes that come with these cells. */
static void fix(Bar *bar, int first, int end)
{
    int last = end == bar->n_cells ? bar->n_nodes : end;
    for (int i = first; i < last && i < bar->fixed_left; i++)
        bar->node_momentum[i] = 0.0;
    for (int i = last - 1; i >= first && i >= bar->n_nodes - bar->fixed_right; i--)
        bar->node_momentum[i] = 0.0;
}

bool bar_do(Bar *bar, BarOp op, int first, int end, Status *status)
{
    const BarKernels *kernels = bar->kernels;
    switch (op) {
    case OP_MAP:
        kernels->map(bar, first, end);
        return true;
    case OP_FIX:
        fix(bar, first, end);
        return true;
    case OP_STRAIN: {
        int bad = kernels->strain(bar, first, end);
        return bad < 0 || bar_fail_particle(bar, status, bad, "was crushed (1 + de <= 0)");
    }
    case OP_FORCE:
        kernels->force(bar, first, end);
        return true;
    case OP_INTEGRATE:
        kernels->integrate(bar, first, end);
        return true;
    case OP_UPDATE:
        kernels->update(bar, first, end);
        return true;
    case OP_MAP_AGAIN:
        kernels->map(bar, first, end);
        fix(bar, first, end);
        return true;
    case OP_FORGET:
        return bar_settle(bar, first, end, status);
    case OP_COUNT:
        break;
    }
    return true;
}

bool bar_stage(Simulation *sim, int stage, size_t first, size_t end, Status *status)
{
    Bar *bar = bar_of(sim);
    const BarSchedule *schedule = bar_schedule(bar->head, bar->def.shape);
    /* what a step that can be looked at has not written yet is 0, so that its snapshots are the same bytes
     * whatever ran before */
    if (stage == 0 && first == 0)
        memset((char *)bar->block + bar->bytes_apic, 0, bar->bytes_whole - bar->bytes_apic);
    if (!bar_do(bar, schedule->ops[stage], (int)first, (int)end, status))
        return false;
    return stage + 1 < schedule->count || end < sim->stage_items || check_energy(bar, status);
}

/* --- rows and whole steps ------------------------------------------------------------------------- */

/* From the sums over the particles, and over the grid as it stands after map and boundary conditions. */
void bar_write_row(const Bar *bar, const BarSums *sums, const double *grid_lanes, int64_t cell_sum,
                   double *row)
{
    const double kinetic = kinetic_of(bar, sums), strain = strain_of(bar, sums);
    row[0] = fold(sums->v) / bar->n_particles;
    row[1] = bar->dx * (((double)cell_sum + fold(sums->s)) / bar->n_particles);
    row[2] = kinetic;
    row[3] = 0.5 * fold(grid_lanes);
    row[4] = strain;
    row[5] = bar->head->work;
    row[6] = kinetic + strain;
}

static void write_row(const Bar *bar, double *row)
{
    BarSums sums = {.v = {0}};
    double grid[BAR_LANES] = {0};
    bar->kernels->particle_sums(bar, 0, bar->places, &sums);
    bar->kernels->node_sums(bar, 0, bar->n_nodes, grid);
    bar_write_row(bar, &sums, grid, bar->head->cell_sum, row);
}

static void map_and_fix(Bar *bar)
{
    bar->kernels->map(bar, 0, bar->n_cells);
    fix(bar, 0, bar->n_cells);
}

void bar_row(Simulation *sim, double *row)
{
    Bar *bar = bar_of(sim);
    map_and_fix(bar); /* the grid is scratch between steps */
    write_row(bar, row);
}

/* What a batch of steps goes back to if one of them fails. */
typedef struct Mark {
    long step;
    int n_events;
    long events_beyond;
} Mark;

static size_t particle_bytes(const Bar *bar)
{
    return bar->head->transfer == MPM_APIC ? bar->bytes_apic : bar->bytes_flip;
}

static Mark set_mark(Bar *bar)
{
    memcpy(bar->backup, bar->block, particle_bytes(bar));
    return (Mark){bar->sim.step, bar->sim.n_events, bar->sim.events_beyond};
}

static void go_back(Bar *bar, Mark mark)
{
    memcpy(bar->block, bar->backup, particle_bytes(bar));
    bar_count_odd_cells(bar);
    bar->sim.step = mark.step;
    bar->sim.n_events = mark.n_events;
    bar->sim.events_beyond = mark.events_beyond;
    bar->sim.failed = false;
}

/* Whole steps over the whole bar, stage by stage. The map of the next step also serves the row. */
static bool whole_steps(Bar *bar, long count, double *rows, Status *status)
{
    const BarSchedule *schedule = bar_schedule(bar->head, bar->def.shape);
    if (count > 0)
        map_and_fix(bar);
    for (long n = 0; n < count; n++) {
        for (int stage = 2; stage < schedule->count; stage++)
            if (!bar_do(bar, schedule->ops[stage], 0, bar->n_cells, status))
                return false;
        if (!check_energy(bar, status))
            return false;
        bar->sim.step++;
        if (rows || n + 1 < count)
            map_and_fix(bar);
        if (rows)
            write_row(bar, rows + n * BAR_SERIES);
    }
    return true;
}

bool bar_steps(Simulation *sim, long count, double *rows, long *done, Status *status)
{
    Bar *bar = bar_of(sim);
    *done = 0;
    while (*done < count) {
        long batch = BAR_CHECK_EVERY - sim->step % BAR_CHECK_EVERY;
        if (batch > count - *done)
            batch = count - *done;
        double *here = rows ? rows + *done * BAR_SERIES : NULL;
        Mark mark = set_mark(bar);
        if (bar_tiles_pay(bar, rows != NULL)) {
            if (bar_tiled_steps(bar, batch, here)) {
                bar->sim.step--;
                bool good = check_energy(bar, status);
                bar->sim.step++;
                if (good) {
                    *done += batch;
                    continue;
                }
            }
            go_back(bar, mark);
        }
        if (whole_steps(bar, batch, here, status)) {
            *done += batch;
            continue;
        }
        /* find the step that fails, and stand before it */
        go_back(bar, mark);
        for (;;) {
            mark = set_mark(bar);
            if (!whole_steps(bar, 1, here, status))
                break;
            ++*done;
            here = rows ? here + BAR_SERIES : NULL;
        }
        Status failure = sim->failure;
        go_back(bar, mark);
        sim->failed = true;
        sim->failure = failure;
        return false;
    }
    return true;
}
