/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Time passes here (advance.h): by blocks of steps up to the next place at which a sink, a change or the
 * caller wants something, by stages, or by items of a stage. */
#include "run/advance.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "base/assertion.h"
#include "base/math/functions.h"
#include "problems/problem.h"
#include "scenario/changes.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

enum { BLOCK = 256 }; /* rows that a method writes at once */

static long least(long a, long b)
{
    return a < b ? a : b;
}

bool run_open(Run *run, const Settings *settings, Simulation *sim, Status *status)
{
    *run = (Run){.settings = settings, .sim = sim, .cancel = settings->cancel};
    if (!sim)
        return false;
    run->last = problem_last_step(sim->dt, settings_time(settings)->end);
    run->block = malloc(BLOCK * (size_t)sim->n_series * sizeof *run->block);
    return run->block || status_fail(status, "not enough memory for the run");
}

void run_close(Run *run)
{
    simulation_destroy(run->sim);
    free(run->block);
    *run = (Run){0};
}

/* --- what sinks get -------------------------------------------------------------------------------- */

static bool is_due(const Run *run, const Sink *sink, long step)
{
    return sink->every > 0 && step >= sink->from && (step % sink->every == 0 || step == run->last);
}

static bool give_row(Run *run, const Sink *sinks, long step, const double *row, Status *status)
{
    for (const Sink *sink = sinks; sink; sink = sink->beside)
        if (is_due(run, sink, step) && !sink->row(sink->owner, run, step, row, status))
            return false;
    return true;
}

/* The row of a step at which the simulation stands, if somebody wants it. */
static bool give_row_here(Run *run, const Sink *sinks, Status *status)
{
    for (const Sink *sink = sinks; sink; sink = sink->beside)
        if (is_due(run, sink, run->sim->step)) {
            simulation_row(run->sim, run->block);
            return give_row(run, sinks, run->sim->step, run->block, status);
        }
    return true;
}

/* Whether somebody looks after each stage of this step. */
static bool is_looked_into(const Sink *sinks, long step)
{
    for (const Sink *sink = sinks; sink; sink = sink->beside)
        if (sink->stage && step >= sink->first && step <= sink->last)
            return true;
    return false;
}

static bool fail(Run *run, const Status *why, Status *status)
{
    run->failed = true;
    run->failure = *why;
    return status_take(status, why);
}

bool run_change(Run *run, Status *status)
{
    Status why = {0};
    return changes_apply(run->settings, run->sim, &why) || fail(run, &why, status);
}

/* At a whole step, its row given: changes come into force, the state is looked at by those that wanted it
 * when the simulation stood at `before`. */
static bool arrive(Run *run, const Sink *sinks, long before, Status *status)
{
    const long step = run->sim->step;
    if (!run_change(run, status))
        return false;
    for (const Sink *sink = sinks; sink; sink = sink->beside)
        if (sink->next && sink->next(sink->owner, before) == step && !sink->state(sink->owner, run, status))
            return false;
    return true;
}

/* A run that is to end at rest ends where it has come to it. */
static void end_at_rest(Run *run)
{
    if (run->sim->at_rest && run->sim->stage == 0)
        run->last = run->sim->step;
}

/* --- forwards ------------------------------------------------------------------------------------- */

/* From a whole step to the next place at which something has to be done. Sets *rows if each of these steps
 * needs one. */
static long next_place(const Run *run, const Sink *sinks, long steps, bool *rows)
{
    const long step = run->sim->step, change = changes_next(run->settings, step);
    long place = least(run->last, steps < LONG_MAX - step ? step + steps : LONG_MAX);
    place = least(place, change);
    if (run->cancel.go_on)
        place = least(place, step + simulation_steps_per_poll(run->sim));
    *rows = false;
    for (const Sink *sink = sinks; sink; sink = sink->beside) {
        const long from = sink->from > step ? sink->from : step + 1;
        if (sink->next)
            place = least(place, sink->next(sink->owner, step));
        if (sink->stage && sink->first > step + 1)
            place = least(place, sink->first - 1);
        if (sink->every == 1 && from == step + 1)
            *rows = true;
        else if (sink->every > 0) /* up to where each step has a row, or to the next that has one */
            place = least(place,
                          sink->every == 1 ? from - 1 : (from + sink->every - 1) / sink->every * sink->every);
    }
    return *rows ? least(place, step + BLOCK) : place;
}

static bool one_block(Run *run, const Sink *sinks, long steps, Status *status)
{
    Simulation *sim = run->sim;
    Status why = {0};
    bool rows;
    const long before = sim->step, place = next_place(run, sinks, steps, &rows);
    long done;
    ASSERT_INT(place, >, before);
    const bool sound = simulation_steps(sim, place - before, rows ? run->block : NULL, &done, &why);
    end_at_rest(run);
    for (long k = 0; rows && k < done; k++)
        if (!give_row(run, sinks, before + k + 1, run->block + k * sim->n_series, status))
            return false;
    if (!sound)
        return fail(run, &why, status);
    return (rows || give_row_here(run, sinks, status)) && arrive(run, sinks, before, status);
}

/* After the last stage of a step. */
static bool end_step(Run *run, const Sink *sinks, Status *status)
{
    end_at_rest(run);
    return give_row_here(run, sinks, status) && arrive(run, sinks, run->sim->step - 1, status);
}

/* What is left of a stage, or the next one. */
static bool one_stage(Run *run, const Sink *sinks, Status *status)
{
    Status why = {0};
    if (!simulation_stage(run->sim, &why))
        return fail(run, &why, status);
    const Simulation *sim = run->sim;
    const bool whole = sim->stage == 0;
    const long step = whole ? sim->step : sim->step + 1;
    for (const Sink *sink = sinks; sink; sink = sink->beside)
        if (sink->stage && step >= sink->first && step <= sink->last &&
            !sink->stage(sink->owner, run, step, whole ? sim->n_stages : sim->stage, status))
            return false;
    return sim->stage != 0 || end_step(run, sinks, status);
}

/* Towards rest it goes by the kinetic energy that is left, by powers of ten, and not by time. */
static double share_done(const Run *run)
{
    const double left = run->sim->kinetic_left, by_time = (double)run->sim->step / (double)run->last;
    return left > 0 ? fmax(by_time, fmin(1, -math_log10(left) / 10)) : by_time;
}

bool run_start(Run *run, const Sink *sinks, Status *status)
{
    ASSERT_INT(run->sim->step, ==, 0);
    ASSERT_INT(run->sim->stage, ==, 0);
    return give_row_here(run, sinks, status) && arrive(run, sinks, -1, status);
}

bool run_advance(Run *run, RunUnit unit, long count, const Sink *sinks, Status *status)
{
    const Simulation *sim = run->sim;
    ASSERT_INT(count, >=, 0);
    if (unit == RUN_STEPS)
        while (sim->stage != 0 || sim->item != 0)
            if (!one_stage(run, sinks, status))
                return false;
    for (long left = count; left > 0;) {
        const long before = sim->step;
        const bool whole = sim->stage == 0 && sim->item == 0;
        if (whole && before >= run->last)
            return true;
        if (unit == RUN_ITEMS) {
            Status why = {0};
            bool stage_done = false;
            if (!simulation_slice(run->sim, (size_t)left, &stage_done, &why))
                return fail(run, &why, status);
            return !stage_done || sim->stage != 0 || end_step(run, sinks, status);
        }
        if (whole && unit != RUN_STAGES && cancel_requested(&run->cancel, share_done(run)))
            return status_fail(status, "interrupted");
        const bool by_stages = unit == RUN_STAGES || !whole || is_looked_into(sinks, before + 1);
        if (by_stages ? !one_stage(run, sinks, status) : !one_block(run, sinks, left, status))
            return false;
        left -= unit == RUN_STAGES ? 1 : sim->step - before;
    }
    return true;
}

bool run_to_end(Run *run, const Sink *sinks, Status *status)
{
    return run_advance(run, RUN_STEPS, LONG_MAX, sinks, status);
}

bool run_is_sound(Run *run)
{
    return run->sim->stage == 0 && run->sim->item == 0 && simulation_forget_failure(run->sim);
}
