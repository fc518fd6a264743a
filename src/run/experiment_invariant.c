/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sharp invariant (invariant.h) as the laboratory shows it: worked out once for each step that is looked
 * at, not while large bars run. */
#include "run/experiment_internal.h"
#include "answers/invariant.h"

#include <math.h>

enum { RUNNING_MAX = 20000, PAUSED_MAX = 500000 }; /* particles; a picture must not wait for more */

typedef struct Start {
    const Settings *base;
    double energy;
} Start;

static void look(Simulation *sim, void *context)
{
    Start *start = context;
    start->energy = invariant_now(sim, start->base);
}

bool experiment_invariant(const Experiment *experiment, double *now, double *start)
{
    Simulation *sim = experiment->run.sim;
    Invariant *known = &experiment->worked->invariant;
    if (!invariant_exists(&experiment->now) || !invariant_exists(&experiment->base))
        return false;
    if (sim->counts[0] > PAUSED_MAX)
        return false;
    const bool busy = experiment->flowing && sim->counts[0] > RUNNING_MAX;
    if (!known->any) {
        *known = (Invariant){.any = true, .step = -1};
        Start at_first = {&experiment->base, NAN};
        simulation_visit(sim, history_nearest(&experiment->history, 0)->bytes, look, &at_first);
        known->start = at_first.energy;
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
