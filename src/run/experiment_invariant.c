/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sharp invariant (invariant.h) as the laboratory shows it: worked out once for each step that is looked
 * at, not while large bars run. */
#include "run/experiment_internal.h"
#include "answers/invariant.h"

#include <math.h>
#include <stdlib.h>

enum { RUNNING_MAX = 20000, PAUSED_MAX = 500000 }; /* particles; a picture must not wait for more */

/* At t = 0. */
static double invariant_at_start(Experiment *experiment)
{
    const Keyframe *first = history_nearest(&experiment->history, 0);
    void *present = first ? malloc(simulation_snapshot_size(experiment->sim)) : NULL;
    if (!present)
        return NAN;
    simulation_snapshot(experiment->sim, present);
    simulation_restore(experiment->sim, first->bytes);
    const double value = invariant_now(experiment->sim, &experiment->base);
    simulation_restore(experiment->sim, present);
    free(present);
    return value;
}

bool experiment_invariant(Experiment *experiment, double *now, double *start)
{
    Simulation *sim = experiment->sim;
    Invariant *known = &experiment->invariant;
    if (!invariant_exists(&experiment->now) || !invariant_exists(&experiment->base))
        return false;
    if (sim->counts[0] > PAUSED_MAX)
        return false;
    const bool busy = experiment->flowing && sim->counts[0] > RUNNING_MAX;
    if (!known->any) {
        *known = (Invariant){.any = true, .step = -1};
        known->start = invariant_at_start(experiment);
    }
    if (known->step != sim->step && sim->stage == 0 && sim->item == 0 && !busy && !sim->failed) {
        known->now = invariant_now(sim, &experiment->now);
        known->step = sim->step;
    }
    *now = known->now;
    *start = known->start;
    /* within a step: whether it was looked at before the step must not be seen */
    return known->step == sim->step && sim->stage == 0 && isfinite(*now) && isfinite(*start);
}
