/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whole steps in batches, and the check of the energy (batch.h). */
#include "methods/batch.h"

#include "base/assertion.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>

/* The energy may be multiplied by this before the run is stopped. Heating by cell crossing is a matter of
 * some ten per cent, at worst a small factor; an unstable run gets to a hundred in velocity in a few hundred
 * steps, and a beam of hats that leaves its channel a while before its particles leave the grid. */
static const double energy_bound = 1e4;

/* Growth that is reported, each once. */
static const double energy_levels[] = {1.1, 2.0, 10.0, 100.0, 1000.0};
static const char *const energy_words[] = {"by 10 %", "to twice", "to 10 times", "to 100 times",
                                           "to 1000 times"};
enum { ENERGY_LEVELS = sizeof energy_levels / sizeof energy_levels[0] };

/* "in step 13, t = 1.3" for the step under way. */
static void batch_step_words(const Simulation *sim, const char *unit, char *out, size_t size)
{
    snprintf(out, size, "in step %ld, t = %s%s", sim->step + 1,
             text_rounded((double)(sim->step + 1) * sim->dt, 6).text, unit);
}

void batch_report(Simulation *sim, EventKind kind, const char *text)
{
    const int before = sim->n_events;
    simulation_report(sim, kind, text);
    if (sim->n_events > before)
        sim->events[before].step = sim->step + 1;
}

bool batch_fail_particle(Simulation *sim, Status *status, int particle, const char *what, const char *unit)
{
    ASSERT_INDEX(particle, sim->counts[0]);
    char when[80];
    batch_step_words(sim, unit, when, sizeof when);
    return simulation_fail(sim, status, "particle %d %s %s", particle, what, when);
}

/* A NaN fails too: the comparison is written so. */
bool batch_check_energy(Simulation *sim, Growth *growth, const GrowthNow *now, Status *status)
{
    if ((sim->step + 1) % BATCH_STEPS != 0)
        return true;
    growth->peak_work = fmax(growth->peak_work, fabs(now->work));
    const double reference = now->start + growth->peak_work, energy = now->energy(sim);
    if (!(energy <= energy_bound * reference)) {
        char when[80];
        batch_step_words(sim, now->unit, when, sizeof when);
        return simulation_fail(sim, status,
                               "the energy has grown to more than %g times what was put in, %s: the run is "
                               "unstable (a smaller Courant number, or %s)",
                               energy_bound, when, now->advice);
    }
    while (growth->level < ENERGY_LEVELS && energy > energy_levels[growth->level] * reference) {
        char text[80];
        snprintf(text, sizeof text, "the energy has grown %s", energy_words[growth->level++]);
        batch_report(sim, EVENT_ENERGY, text);
    }
    return true;
}

/* Where a batch of steps began, besides what was kept. */
typedef struct BatchMark {
    long step;
    int n_events;
    EventCounts events_beyond;
} BatchMark;

static BatchMark mark_of(Simulation *sim, const Batches *batches)
{
    batches->keep(sim);
    return (BatchMark){sim->step, sim->n_events, sim->events_beyond};
}

/* Undoes everything since the mark. */
static void batch_return(Simulation *sim, const Batches *batches, BatchMark mark)
{
    sim->step = mark.step;
    batches->put_back(sim);
    sim->n_events = mark.n_events;
    sim->events_beyond = mark.events_beyond;
    sim->failed = false;
}

bool batch_steps(Simulation *sim, const Batches *batches, long count, double *rows, long *done,
                 Status *status)
{
    ASSERT_INT(count, >=, 0);
    ASSERT_INT(sim->stage, ==, 0);
    *done = 0;
    while (*done < count && !sim->at_rest) {
        long batch = BATCH_STEPS - sim->step % BATCH_STEPS;
        if (batch > count - *done)
            batch = count - *done;
        double *here = rows ? rows + *done * sim->n_series : NULL;
        BatchMark mark = mark_of(sim, batches);
        if (batches->steps(sim, batch, here, status)) {
            *done += sim->step - mark.step;
            continue;
        }
        /* again one step at a time, so that the run ends before the step that fails */
        batch_return(sim, batches, mark);
        for (;;) {
            mark = mark_of(sim, batches);
            if (!batches->steps(sim, 1, here, status))
                break;
            ++*done;
            here = rows ? here + sim->n_series : NULL;
        }
        const Status failure = sim->failure;
        batch_return(sim, batches, mark);
        sim->failed = true;
        sim->failure = failure;
        return false;
    }
    return true;
}
