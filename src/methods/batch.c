/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whole steps in batches (batch.h). */
#include "methods/batch.h"

#include "base/assertion.h"
#include "base/text.h"

#include <stdio.h>

void batch_step_words(const Simulation *sim, const char *unit, char out[BATCH_WORDS_MAX])
{
    snprintf(out, BATCH_WORDS_MAX, "in step %ld, t = %s%s", sim->step + 1,
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
    char when[BATCH_WORDS_MAX];
    batch_step_words(sim, unit, when);
    return simulation_fail(sim, status, "particle %d %s %s", particle, what, when);
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
