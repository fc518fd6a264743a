/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The run itself, from its beginning to its end: forwards by steps, stages and parts of a stage, back to a
 * keyframe, on into another future. */
#include "base/assertion.h"
#include "run/experiment_internal.h"
#include "scenario/concern_output.h"
#include "scenario/concern_time.h"
#include "scenario/changes.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static const size_t record_budget = (size_t)32 << 20;
/* What takes longer than a step is found every so many steps: no picture is as wide as a run has steps. A
 * power of two, so that a record that is thinned keeps these rows. */
enum { WHOLE_ROWS = 8 };

static bool out_of_memory(Status *status)
{
    return status_fail(status, "not enough memory for the run's record");
}

static void copy_events(Experiment *experiment)
{
    const Simulation *sim = experiment->run.sim;
    memcpy(experiment->events, sim->events, (size_t)sim->n_events * sizeof sim->events[0]);
    experiment->n_events = sim->n_events;
}

static void note_now(Experiment *experiment)
{
    if (experiment->base.n_changes > 0)
        changes_in_force(&experiment->base, experiment->run.sim->step, &experiment->now);
}

static bool keep_row(void *owner, Run *run, long step, const double *method_row, Status *status)
{
    Experiment *experiment = owner;
    double row[COLUMNS_MAX];
    references_row(experiment->refs, step, (double)step * run->sim->dt, method_row, row);
    if (!record_append(&experiment->record, row))
        return out_of_memory(status);
    experiment->newest = step;
    return true;
}

static long next_keyframe(const void *owner, long step)
{
    const Experiment *experiment = owner;
    return step < 0 ? 0 : step + history_next(&experiment->history, step);
}

static bool keep_frame(void *owner, Run *run, Status *status)
{
    Experiment *experiment = owner;
    return history_keep(&experiment->history, run->sim) || out_of_memory(status);
}

/* Rows that are recorded already are not worked out again. */
static void sinks_of(Experiment *experiment, Sink sinks[2])
{
    sinks[0] = (Sink){.every = 1,
                      .from = experiment->record.count > 0 ? experiment->newest + 1 : 0,
                      .row = keep_row,
                      .owner = experiment,
                      .beside = &sinks[1]};
    sinks[1] = (Sink){.next = next_keyframe, .state = keep_frame, .owner = experiment};
}

/* They do not depend on the state, and take searches for eigenvalues: once for all pictures that have the
 * same settings. */
void experiment_derive(const Experiment *experiment, Cancel cancel)
{
    Settings settings = experiment->now;
    settings.cancel = cancel;
    const int before = shortage_begin();
    experiment->worked->n_derived =
        problem_derived(&settings, experiment->run.sim, experiment->worked->derived);
    if (errno == ENOMEM || errno == ECANCELED) /* what is missing is asked for again */
        memset(&experiment->worked->derived_for, 0, sizeof experiment->worked->derived_for);
    else
        experiment->worked->derived_for = experiment->now;
    shortage_end(before);
}

static bool goes_on(const Settings *settings, Status *status)
{
    return !cancel_requested(&settings->cancel, 0) ||
           status_fail(status, "the building of the run was cancelled");
}

/* At t = 0, row 0 recorded; of an experiment that is all zeros. */
static bool begin(Experiment *experiment, const Settings *settings, size_t history, Status *status)
{
    experiment->base = *settings;
    if (!goes_on(settings, status) ||
        !changes_advice(settings, experiment->advice, sizeof experiment->advice, status))
        return false;
    /* a view may show any of the columns, whatever is written of the run */
    Settings shown = *settings;
    strcpy(settings_edit_output(&shown)->columns, "all");
    if (!run_open(&experiment->run, &experiment->base, problem_simulate(&shown, experiment->threads, status),
                  status))
        return false;
    experiment->run.cancel = (Cancel){0}; /* the caller does a little at a time */
    experiment->run.sim->whole_rows = WHOLE_ROWS;
    experiment->refs = references_create(settings, experiment->run.sim, status);
    if (!experiment->refs)
        return false;

    /* The record and the first keyframe; of a large beam each takes as long as one asks to hear of it. */
    Sink sinks[2];
    experiment->n_columns = references_columns(experiment->refs, experiment->columns);
    record_open(&experiment->record, experiment->n_columns, 1, record_budget);
    sinks_of(experiment, sinks);
    history_open(&experiment->history, history);
    if (!goes_on(&experiment->base, status) || !run_start(&experiment->run, sinks, status) ||
        !goes_on(&experiment->base, status))
        return false;
    copy_events(experiment);
    changes_in_force(&experiment->base, 0, &experiment->now);
    experiment_derive(experiment, settings->cancel);
    return true;
}

void experiment_destroy(Experiment *experiment)
{
    if (!experiment)
        return;
    for (int i = 0; i < GHOSTS_MAX; i++)
        experiment_drop_ghost(&experiment->ghosts[i]);
    references_destroy(experiment->refs);
    crack_fronts_free(&experiment->worked->fronts);
    run_close(&experiment->run);
    record_close(&experiment->record);
    history_close(&experiment->history);
    for (int i = 0; i < SPECTRUM_SPANS; i++)
        spectrum_close(&experiment->worked->spectra[i]);
    free(experiment->before.bytes);
    free(experiment->part.bytes);
    free(experiment->worked);
    free(experiment);
}

Experiment *experiment_create(const Settings *settings, size_t history, int threads, Status *status)
{
    ASSERT_INT(threads, >=, 1);
    Experiment *experiment = calloc(1, sizeof *experiment);
    if (!experiment || !(experiment->worked = calloc(1, sizeof *experiment->worked))) {
        status_fail(status, "not enough memory");
        free(experiment);
        return NULL;
    }
    experiment->threads = threads;
    experiment->worked->row_step = -1;
    memcpy(experiment->given, settings->changes, sizeof experiment->given);
    experiment->n_given = settings->n_changes;
    if (begin(experiment, settings, history, status))
        return experiment;
    experiment_destroy(experiment);
    return NULL;
}

void experiment_rewind(Experiment *experiment, Record *old)
{
    Simulation *sim = experiment->run.sim;
    simulation_restore(sim, history_nearest(&experiment->history, 0)->bytes);
    history_reset(&experiment->history);
    *old = experiment->record;
    record_open(&experiment->record, experiment->n_columns, 1, record_budget);
    references_reset(experiment->refs);
    simulation_row(sim, experiment->run.block);
    if (!keep_row(experiment, &experiment->run, 0, experiment->run.block, NULL)) {
        /* no memory for another record: then there is nothing to hand over */
        record_close(&experiment->record);
        experiment->record = *old;
        *old = (Record){0};
        record_cut(&experiment->record, 0);
    }
    experiment->newest = 0;
    experiment->run.last = problem_last_step(sim->dt, settings_time(&experiment->base)->end);
    experiment->run.failed = false;
    copy_events(experiment);
    note_now(experiment);
}

/* --- forwards ------------------------------------------------------------------------------------- */

static long least(long a, long b)
{
    return a < b ? a : b;
}

/* As run_advance(), and what is known of the place to which it came. */
static bool advance(Experiment *experiment, RunUnit unit, long count, Status *status)
{
    Run *run = &experiment->run;
    const long last = run->last;
    Sink sinks[2];
    sinks_of(experiment, sinks);
    const bool sound = run_advance(run, unit, count, sinks, status);
    if (run->last < last && experiment->goal_step >= run->last) {
        experiment->goal_step = run->last; /* at rest: what was asked for beyond is not pending */
        experiment->goal_stage = 0;
    }
    if (run->sim->stage == 0 && run->sim->step == experiment->newest)
        copy_events(experiment);
    note_now(experiment);
    return sound;
}

/* Back to the last sound whole step; the record holds everything up to there. */
static bool fail(Experiment *experiment, const Status *why, Status *status)
{
    Run *run = &experiment->run;
    run->failed = true;
    run->failure = *why;
    if (run->sim->step != experiment->newest || !run_is_sound(run)) {
        simulation_restore(run->sim, history_nearest(&experiment->history, experiment->newest)->bytes);
        if (run->sim->step < experiment->newest)
            advance(experiment, RUN_STEPS, experiment->newest - run->sim->step, NULL);
    }
    note_now(experiment);
    return status_take(status, why);
}

bool experiment_go(Experiment *experiment, RunUnit unit, long count, Status *status)
{
    Status why = {0};
    return advance(experiment, unit, count, &why) || fail(experiment, &why, status);
}

bool experiment_do_steps(Experiment *experiment, long steps, Status *status)
{
    ASSERT_INT(steps, >=, 0);
    const Run *run = &experiment->run;
    if (!experiment_go(experiment, RUN_STEPS, 0, status)) /* a step that has begun */
        return false;
    /* what is known of a run that failed, and not beyond */
    const long sound = run->failed ? least(steps, experiment->newest - run->sim->step) : steps;
    return experiment_go(experiment, RUN_STEPS, sound, status) &&
           (sound == steps || run->sim->step >= run->last || status_take(status, &run->failure));
}

void experiment_approach(Experiment *experiment, long step, int stage)
{
    ASSERT_INT(step, >=, 0);
    ASSERT_INT(stage, >=, 0);
    Simulation *sim = experiment->run.sim;
    const Keyframe *frame = history_nearest(&experiment->history, step);
    bool beyond = sim->step > step || (sim->step == step && sim->stage > stage);
    if (frame && (beyond || frame->step > sim->step)) {
        simulation_restore(sim, frame->bytes);
        note_now(experiment);
    }
}

/* --- another future ------------------------------------------------------------------------------- */

/* References that look back see rows again. */
static bool see_row(void *owner, Run *run, long step, const double *method_row, Status *status)
{
    double row[COLUMNS_MAX];
    (void)status;
    references_row(owner, step, (double)step * run->sim->dt, method_row, row);
    return true;
}

typedef struct Span {
    Experiment *experiment;
    long first, last;
} Span;

static void see_span(Simulation *sim, void *context)
{
    const Span *span = context;
    Run *run = &span->experiment->run;
    const Sink sink = {.every = 1, .from = span->first, .row = see_row, .owner = span->experiment->refs};
    if (sim->step >= span->first) {
        simulation_row(sim, run->block);
        see_row(sink.owner, run, sim->step, run->block, NULL);
    }
    run_advance(run, RUN_STEPS, span->last - sim->step, &sink, NULL);
}

/* A filter looks back over rows that the record may have thinned out; then they are computed again. */
static void refill_references(Experiment *experiment, long step)
{
    const long memory = references_memory(experiment->refs);
    if (memory == 0)
        return;
    const Span span = {experiment, step - memory > 0 ? step - memory : 0, step};
    references_reset(experiment->refs);
    simulation_visit(experiment->run.sim, history_nearest(&experiment->history, span.first)->bytes, see_span,
                     (void *)&span);
}

/* The kept rows up to a step as other references would have written them: what the method gave is in every
 * row, the answers beside it are worked out again. False: no memory. */
static bool write_rows_again(const Experiment *experiment, References *refs, const Column *columns,
                             int n_columns, long step, Record *out)
{
    int series[COLUMNS_MAX], kept[COLUMNS_MAX];
    double row[COLUMNS_MAX], *given = experiment->run.block;
    for (int i = 0; i < experiment->n_columns; i++)
        series[i] = simulation_find_series(experiment->run.sim, experiment->columns[i].quantity.name);
    for (int i = 0; i < n_columns; i++)
        kept[i] = references_column(experiment->columns, experiment->n_columns, columns[i].quantity.name);
    const bool memory = references_memory(refs) > 0;
    record_open(out, n_columns, experiment->record.spacing, record_budget);
    out->thinned = experiment->record.thinned;
    for (size_t k = 0; k < experiment->record.count; k++) {
        const double *old = record_row(&experiment->record, k);
        if (old[0] > (double)step)
            break;
        for (int i = 0; i < experiment->n_columns; i++)
            if (series[i] >= 0)
                given[series[i]] = old[i];
        references_row(refs, (long)old[0], old[1], given, row);
        /* what looked back over rows that the record no longer has */
        for (int i = 0; i < n_columns && memory; i++)
            row[i] = kept[i] >= 0 ? old[kept[i]] : row[i];
        if (!record_append(out, row)) {
            record_close(out);
            return false;
        }
    }
    return true;
}

/* The references of the run as it is now. Their columns may go and come back; the record up to `step` gets
 * those that a run from t = 0 would have. */
static bool renew_references(Experiment *experiment, long step, Status *status)
{
    if (cancel_requested(&experiment->base.cancel, 0))
        return status_fail(status, "the change was cancelled");
    References *refs = references_create(&experiment->base, experiment->run.sim, status);
    if (!refs)
        return false;
    Column columns[COLUMNS_MAX];
    const int n = references_columns(refs, columns);
    Record record;
    bool same = n == experiment->n_columns;
    for (int i = 0; i < n && same; i++)
        same = references_column(experiment->columns, experiment->n_columns, columns[i].quantity.name) == i;
    if (references_memory(experiment->refs) > 0 && same) {
        references_destroy(refs); /* it would have to look back again */
        return true;
    }
    if (!write_rows_again(experiment, refs, columns, n, step, &record)) {
        references_destroy(refs);
        return out_of_memory(status);
    }
    record_close(&experiment->record);
    experiment->record = record;
    memcpy(experiment->columns, columns, sizeof columns);
    experiment->n_columns = n;
    references_destroy(experiment->refs);
    experiment->refs = refs;
    refill_references(experiment, least(step, experiment->newest));
    return true;
}

static void cut(Experiment *experiment, long step)
{
    Run *run = &experiment->run;
    history_cut(&experiment->history, step);
    record_cut(&experiment->record, step);
    while (experiment->n_events > 0 && experiment->events[experiment->n_events - 1].step > step)
        experiment->n_events--;
    if (experiment->newest <= step)
        return;
    experiment->newest = step;
    run->failed = false;
    run->last = problem_last_step(run->sim->dt, settings_time(&experiment->base)->end);
    refill_references(experiment, step);
}

typedef struct Trial {
    const Settings *settings;
    Status why;
    bool good;
} Trial;

static void try_changes(Simulation *sim, void *context)
{
    Trial *trial = context;
    trial->good = changes_apply(trial->settings, sim, &trial->why);
}

bool experiment_change(Experiment *experiment, long step, const Settings *changed, Status *status)
{
    ASSERT_INT(step, >=, 0);
    Settings before = experiment->base;
    const bool here = experiment->run.sim->stage == 0 && experiment->run.sim->step == step;
    experiment->base = *changed;
    /* whether the method takes the changes of the present step in turn; nothing is changed by it */
    Trial trial = {.settings = &experiment->base, .good = !here};
    if (here && !simulation_visit(experiment->run.sim, NULL, try_changes, &trial))
        out_of_memory(&trial.why);
    if (trial.good ? !renew_references(experiment, step, status) : !status_take(status, &trial.why)) {
        experiment->base = before;
        return false;
    }
    cut(experiment, step);
    note_now(experiment);
    experiment_derive(experiment, experiment->base.cancel);
    experiment->run.failed = false; /* what stopped the run may not stop the changed one */
    Simulation *sim = experiment->run.sim;
    if (!here)
        return true;
    const bool others = changes_next(&before, step - 1) == step;
    if (others && step > 0) {
        /* the state must be that of a run which never knew another order of changes */
        simulation_restore(sim, history_nearest(&experiment->history, step - 1)->bytes);
        return experiment_go(experiment, RUN_STEPS, step - sim->step, status);
    }
    Status why = {0};
    if (!run_change(&experiment->run, &why))
        return fail(experiment, &why, status);
    copy_events(experiment);
    history_keep(&experiment->history, sim);
    note_now(experiment);
    return true;
}

void experiment_set_end(Experiment *experiment, double end)
{
    ASSERT_REAL(end, >=, 0);
    Simulation *sim = experiment->run.sim;
    const double before = settings_time(&experiment->base)->end;
    settings_edit_time(&experiment->base)->end = settings_edit_time(&experiment->now)->end = end;
    /* a run that has come to rest before does not go on */
    const bool rested = experiment->run.last < problem_last_step(sim->dt, before);
    const long last = problem_last_step(sim->dt, end);
    experiment->run.last = rested ? least(last, experiment->run.last) : last;
    if (sim->step > experiment->run.last || (sim->step == experiment->run.last && sim->stage > 0)) {
        experiment_approach(experiment, experiment->run.last, 0);
        experiment_do_steps(experiment, experiment->run.last - sim->step, NULL);
    }
    if (experiment->newest > experiment->run.last)
        cut(experiment, experiment->run.last);
}
