/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stages and whole steps of a beam as the driver asks for them (method.h), and the energy check that may stop
 * a run. Whole steps go in batches; one that fails is taken back and done again step by step, so that the run
 * stands before the step that failed. */
#include "physics/mpm_plane/plane_state.h"

#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* The energy may be multiplied by this before the run is stopped: a beam of hats that leaves its channel gets
 * there a while before its particles leave the grid, and shows by then what there is to be seen. */
static const double energy_bound = 1e4;

/* Growth that is reported, each once. */
static const double energy_levels[] = {1.1, 2.0, 10.0, 100.0, 1000.0};
static const char *const energy_words[] = {"by 10 %", "to twice", "to 10 times", "to 100 times",
                                           "to 1000 times"};
enum { ENERGY_LEVELS = sizeof energy_levels / sizeof energy_levels[0] };

/* Events belong to the step under way, which the driver has not counted yet. */
static void report(Plane *plane, EventKind kind, const char *text)
{
    const int before = plane->sim.n_events;
    simulation_report(&plane->sim, kind, text);
    if (plane->sim.n_events > before)
        plane->sim.events[before].step = plane->sim.step + 1;
}

/* Fails where energy > energy_bound (E_0 + max |work|), looked at only behind steps that are multiples of
 * PLANE_CHECK_EVERY, so that the outcome does not depend on how a run is cut into batches. A NaN fails too:
 * the comparison is written so. */
static bool check_energy(Plane *plane, Status *status)
{
    if ((plane->sim.step + 1) % PLANE_CHECK_EVERY != 0)
        return true;
    PlaneHead *head = plane->head;
    head->peak_work = fmax(head->peak_work, fabs(head->work));
    const double reference = plane->energy_start + head->peak_work, energy = plane_energy(plane);
    if (!(energy <= energy_bound * reference)) {
        char time[NUMBER_TEXT_MAX];
        text_rounded(time, (double)(plane->sim.step + 1) * plane->dt, 6);
        return simulation_fail(&plane->sim, status,
                               "the energy has grown to more than %g times what was put in, in step %ld, t = "
                               "%s s: the run is unstable (a smaller courant number, or other shapes)",
                               energy_bound, plane->sim.step + 1, time);
    }
    while (head->energy_level < ENERGY_LEVELS && energy > energy_levels[head->energy_level] * reference) {
        char text[80];
        snprintf(text, sizeof text, "the energy has grown %s", energy_words[head->energy_level++]);
        report(plane, EVENT_ENERGY, text);
    }
    return true;
}

/* One stage on its items [first, end), for whoever looks at a step from inside (method.h). */
bool plane_stage(Simulation *sim, int stage, size_t first, size_t end, Status *status)
{
    Plane *plane = plane_of(sim);
    const PlaneSchedule *schedule = plane_schedule(plane->head);
    /* what a step that can be looked at has not written yet is 0, so that its snapshots are the same bytes
     * whatever ran before */
    if (stage == 0 && first == 0)
        memset(plane->block + plane->bytes_particles, 0, plane->bytes_whole - plane->bytes_particles);
    if (!plane_do(plane, schedule->ops[stage], (int)first, (int)end, status))
        return false;
    return stage + 1 < schedule->count || end < sim->stage_items || check_energy(plane, status);
}

/* The state to which a batch of steps returns if one of them fails; the particles are in plane->backup. */
typedef struct Mark {
    long step;
    int n_events;
    long events_beyond;
} Mark;

static Mark set_mark(Plane *plane)
{
    memcpy(plane->backup, plane->block, plane->bytes_particles);
    return (Mark){plane->sim.step, plane->sim.n_events, plane->sim.events_beyond};
}

static void go_back(Plane *plane, Mark mark)
{
    memcpy(plane->block, plane->backup, plane->bytes_particles);
    plane->sim.step = mark.step;
    plane->sim.n_events = mark.n_events;
    plane->sim.events_beyond = mark.events_beyond;
    plane->sim.failed = false;
}

/* The row needs the grid after map and supports, which are also the first two stages of the next step: they
 * are done once for both, and the map goes with the stages before it. */
static bool whole_steps(Plane *plane, long count, double *rows, Status *status)
{
    const PlaneSchedule *schedule = plane_schedule(plane->head);
    if (count > 0 && !plane_map_and_hold(plane, status))
        return false;
    for (long n = 0; n < count; n++) {
        const long step = plane->sim.step;
        PlaneTask tasks[PLANE_OPS];
        int n_tasks = 0;
        for (int stage = 2; stage < schedule->count; stage++)
            tasks[n_tasks++] = (PlaneTask){schedule->ops[stage], step};
        if (rows || n + 1 < count) {
            tasks[n_tasks++] = (PlaneTask){PLANE_MAP, step + 1};
            tasks[n_tasks++] = (PlaneTask){PLANE_HOLD, step + 1};
        }
        if (!plane_do_all(plane, tasks, n_tasks, status) || !check_energy(plane, status))
            return false;
        plane->sim.step++;
        if (rows)
            plane_write_row(plane, rows + n * plane->sim.n_series);
    }
    return true;
}

/* `count` whole steps in batches that end where the energy is looked at; one step at a time once a batch has
 * failed. */
bool plane_steps(Simulation *sim, long count, double *rows, long *done, Status *status)
{
    Plane *plane = plane_of(sim);
    *done = 0;
    while (*done < count) {
        long batch = PLANE_CHECK_EVERY - sim->step % PLANE_CHECK_EVERY;
        if (batch > count - *done)
            batch = count - *done;
        double *here = rows ? rows + *done * sim->n_series : NULL;
        Mark mark = set_mark(plane);
        if (whole_steps(plane, batch, here, status)) {
            *done += batch;
            continue;
        }
        /* again one step at a time, so that the run ends before the step that fails */
        go_back(plane, mark);
        for (;;) {
            mark = set_mark(plane);
            if (!whole_steps(plane, 1, here, status))
                break;
            ++*done;
            here = rows ? here + sim->n_series : NULL;
        }
        const Status failure = sim->failure;
        go_back(plane, mark);
        sim->failed = true;
        sim->failure = failure;
        return false;
    }
    return true;
}
