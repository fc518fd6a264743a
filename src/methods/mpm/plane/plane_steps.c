/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Stages and whole steps of a beam as the driver asks for them (method.h). Whole steps go in batches
 * (batch.h). */
#include "base/assertion.h"
#include "methods/mpm/plane/plane_state.h"

#include <math.h>
#include <string.h>

static double energy(const Simulation *sim)
{
    return plane_energy(plane_of_const(sim));
}

/* Seen from the beam the channel moves nothing that it holds and does no work: its work in the laboratory,
 * some times the energy of the vibration, is left out. A beam that does not vibrate has what rounding makes
 * of its common speed, at most some 1e-20 of 1/2 m v0^2 in a million steps. */
static bool check_energy(Plane *plane, Status *status)
{
    const double body = plane->mass * plane->nxp * plane->nyp * plane->def.thickness;
    const double rounding = 1e-20 * body * plane->speed * plane->speed / 2;
    const GrowthNow now = {fmax(plane->energy_start, rounding), energy, 0, " s", "other shapes"};
    return batch_check_energy(&plane->sim, &plane->head->growth, &now, status);
}

/* One stage on its items [first, end), for whoever looks at a step from inside (method.h). */
bool plane_stage(Simulation *sim, int stage, size_t first, size_t end, Status *status)
{
    ASSERT_INDEX(stage, sim->n_stages);
    ASSERT_INT(first, <=, end);
    ASSERT_INT(end, <=, sim->stage_items);
    Plane *plane = plane_of(sim);
    const PlaneSchedule *schedule = plane_schedule(plane->head);
    /* what a step that can be looked at has not written yet is 0, so that its snapshots are the same bytes
     * whatever ran before */
    if (stage == 0 && first == 0)
        memset(plane->block + plane->bytes_particles, 0, plane->bytes_whole - plane->bytes_particles);
    if (!plane_do(plane, (PlaneTask){schedule->ops[stage], sim->step}, (int)first, (int)end, status))
        return false;
    return stage + 1 < schedule->count || end < sim->stage_items || check_energy(plane, status);
}

static void keep(Simulation *sim)
{
    Plane *plane = plane_of(sim);
    memcpy(plane->backup, plane->block, plane->bytes_particles);
}

static void put_back(Simulation *sim)
{
    Plane *plane = plane_of(sim);
    memcpy(plane->block, plane->backup, plane->bytes_particles);
}

/* A row may need the grid after map and supports, which are also the first two stages of the next step: they
 * are done once for both, and the map goes with the stages before it. */
static bool whole_steps(Simulation *sim, long count, double *rows, Status *status)
{
    Plane *plane = plane_of(sim);
    const PlaneSchedule *schedule = plane_schedule(plane->head);
    if (count > 0 && !plane_map_and_hold(plane, status))
        return false;
    for (long n = 0; n < count; n++) {
        const long step = plane->sim.step;
        PlaneTask tasks[PLANE_OPS];
        int n_tasks = 0;
        for (int stage = 2; stage < schedule->count; stage++)
            tasks[n_tasks++] = (PlaneTask){schedule->ops[stage], step};
        if (n + 1 < count || (rows && plane_row_needs_grid(plane))) {
            tasks[n_tasks++] = (PlaneTask){PLANE_MAP, step + 1};
            tasks[n_tasks++] = (PlaneTask){PLANE_HOLD, step + 1};
        }
        if (!plane_do_all(plane, tasks, n_tasks, status) || !check_energy(plane, status))
            return false;
        plane->sim.step++;
        if (rows)
            plane_write_row(plane, rows + n * sim->n_series, !sim->spares_rows || n + 1 == count);
    }
    return true;
}

bool plane_steps(Simulation *sim, long count, double *rows, long *done, Status *status)
{
    ASSERT_INT(count, >=, 0);
    ASSERT_INT(sim->stage, ==, 0);
    static const Batches batches = {keep, put_back, whole_steps};
    return batch_steps(sim, &batches, count, rows, done, status);
}
