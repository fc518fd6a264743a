/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stages and whole steps of a bar as the driver asks for them (method.h), and what may stop a run: the
 * energy, looked at after some steps. Whole steps go in batches; one that fails is taken back and done again
 * step by step, so that the run stands before the step that failed. */
#include "physics/mpm_bar/bar_state.h"

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

/* Fails where energy > energy_bound (E_0 + max |work|), and reports growth on the way. Looked at only at the
 * end of steps that are multiples of BAR_CHECK_EVERY, so that the outcome does not depend on how the run is
 * cut into batches. A NaN fails too: the comparison is written so. */
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

/* One stage on cells [first, end), for whoever looks at a step from inside (method.h). The energy is checked
 * behind the last stage. */
bool bar_stage(Simulation *sim, int stage, size_t first, size_t end, Status *status)
{
    Bar *bar = bar_of(sim);
    const BarSchedule *schedule = bar_schedule(bar);
    /* what a step that can be looked at has not written yet is 0, so that its snapshots are the same bytes
     * whatever ran before */
    if (stage == 0 && first == 0)
        memset((char *)bar->block + bar->bytes_apic, 0, bar->bytes_whole - bar->bytes_apic);
    if (!bar_do(bar, schedule->ops[stage], (int)first, (int)end, status))
        return false;
    return stage + 1 < schedule->count || end < sim->stage_items || check_energy(bar, status);
}

/* --- whole steps --------------------------------------------------------------------------------- */

/* The state to which a batch of steps returns if one of them fails; the particles are in bar->backup. */
typedef struct Mark {
    long step;
    int n_events;
    long events_beyond;
} Mark;

/* The part of the state that lasts from step to step; with APIC the slopes C are in it. */
static size_t particle_bytes(const Bar *bar)
{
    return bar->head->transfer == MPM_APIC ? bar->bytes_apic : bar->bytes_flip;
}

static Mark set_mark(Bar *bar)
{
    memcpy(bar->backup, bar->block, particle_bytes(bar));
    return (Mark){bar->sim.step, bar->sim.n_events, bar->sim.events_beyond};
}

/* Undoes everything since the mark. */
static void go_back(Bar *bar, Mark mark)
{
    memcpy(bar->block, bar->backup, particle_bytes(bar));
    bar_count_odd_cells(bar);
    bar->sim.step = mark.step;
    bar->sim.n_events = mark.n_events;
    bar->sim.events_beyond = mark.events_beyond;
    bar->sim.failed = false;
}

/* Whole steps over the whole bar, stage by stage. The row needs the grid after map and boundary conditions,
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
        if (rows)
            bar_row(&bar->sim, rows + n * BAR_SERIES);
        else if (n + 1 < count)
            bar_map_and_fix(bar);
    }
    return true;
}

/* `count` whole steps in batches that end where the energy is looked at. Three ways to the same bits: in
 * tiles where that pays, else stage by stage over the whole bar, and one step at a time once a batch has
 * failed, to find the step at which the run ends. */
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
        /* again one step at a time, so that the run ends before the step that fails */
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
