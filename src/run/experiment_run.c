/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The run itself: forwards by steps, stages and parts of a stage, back to a keyframe, on into another future.
 */
#include "run/experiment_internal.h"
#include "scenario/changes.h"
#include "scenario/parameters.h"

#include <errno.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

static const size_t record_budget = (size_t)32 << 20;
enum { BLOCK = 256 }; /* rows that a method writes at once */

/* What takes longer than a step is found every so many steps: no picture is as wide as a run has steps. A
 * power of two, so that a record that is thinned keeps these rows. */
enum { WHOLE_ROWS = 8 };

/* --- life ----------------------------------------------------------------------------------------- */

static bool take_row(Experiment *experiment, const double *method_row, long step)
{
    double row[COLUMNS_MAX];
    references_row(experiment->refs, step, (double)step * experiment->sim->dt, method_row, row);
    return record_append(&experiment->record, row);
}

static void copy_events(Experiment *experiment)
{
    const Simulation *sim = experiment->sim;
    memcpy(experiment->events, sim->events, (size_t)sim->n_events * sizeof sim->events[0]);
    experiment->n_events = sim->n_events;
}

static void note_now(Experiment *experiment)
{
    if (experiment->base.n_changes > 0)
        changes_in_force(&experiment->base, experiment->sim->step, &experiment->now);
}

/* They do not depend on the state, and take searches for eigenvalues: once for all pictures that have the
 * same settings. */
void experiment_derive(Experiment *experiment, Patience patience)
{
    Settings settings = experiment->now;
    settings.patience = patience;
    const int before = errno; /* of whoever draws, and asks for memory too */
    errno = 0;
    experiment->n_derived = problem_derived(&settings, experiment->sim, experiment->derived);
    if (errno == ENOMEM || errno == ECANCELED) /* what is missing is asked for again */
        memset(&experiment->derived_for, 0, sizeof experiment->derived_for);
    else {
        experiment->derived_for = experiment->now;
        errno = before;
    }
}

static bool out_of_memory(Status *status)
{
    return status_fail(status, STATUS_FAILED, "not enough memory for the run's record");
}

static bool goes_on(const Settings *settings, Status *status)
{
    return patience_lasts(&settings->patience, 0) ||
           status_fail(status, STATUS_FAILED, "the building of the run was given up");
}

/* The record and the first keyframe; of a large beam each takes as long as one asks to hear of it. */
static bool begin(Experiment *experiment, size_t history, Status *status)
{
    Simulation *sim = experiment->sim;
    experiment->n_columns = references_columns(experiment->refs, experiment->columns);
    record_open(&experiment->record, experiment->n_columns, 1, record_budget);
    history_open(&experiment->history, history);
    experiment->last = problem_last_step(sim->dt, experiment->base.time.end);
    experiment->block = malloc(BLOCK * (size_t)sim->n_series * sizeof *experiment->block);
    if (!experiment->block)
        return out_of_memory(status);
    if (!goes_on(&experiment->base, status))
        return false;
    simulation_row(sim, experiment->block);
    if (!take_row(experiment, experiment->block, 0))
        return out_of_memory(status);
    if (!goes_on(&experiment->base, status) || !changes_apply(&experiment->base, sim, status))
        return false;
    copy_events(experiment);
    changes_in_force(&experiment->base, 0, &experiment->now);
    return history_keep(&experiment->history, sim) || out_of_memory(status);
}

bool experiment_open(Experiment *experiment, const Settings *settings, size_t history, int threads,
                     Status *status)
{
    experiment->base = *settings;
    if (!goes_on(settings, status) || !settings_check(settings, status) ||
        !changes_advice(settings, experiment->advice, sizeof experiment->advice, status))
        return false;
    /* a view may show any of the columns, whatever is written of the run */
    Settings shown = *settings;
    strcpy(shown.output.columns, "all");
    experiment->sim = problem_simulate(&shown, threads, status);
    if (experiment->sim)
        experiment->sim->whole_rows = WHOLE_ROWS;
    if (experiment->sim)
        experiment->refs = references_create(settings, experiment->sim, status);
    if (!experiment->refs || !begin(experiment, history, status))
        return false;
    experiment_derive(experiment, settings->patience);
    return true;
}

void experiment_rewind(Experiment *experiment, Record *old)
{
    Simulation *sim = experiment->sim;
    simulation_restore(sim, history_nearest(&experiment->history, 0)->bytes);
    history_reset(&experiment->history);
    *old = experiment->record;
    record_open(&experiment->record, experiment->n_columns, 1, record_budget);
    references_reset(experiment->refs);
    simulation_row(sim, experiment->block);
    if (!take_row(experiment, experiment->block, 0)) {
        /* no memory for another record: then there is nothing to hand over */
        record_close(&experiment->record);
        experiment->record = *old;
        *old = (Record){0};
        record_cut(&experiment->record, 0);
    }
    experiment->newest = 0;
    experiment->last = problem_last_step(sim->dt, experiment->base.time.end);
    experiment->failed = false;
    copy_events(experiment);
    note_now(experiment);
}

void experiment_close(Experiment *experiment)
{
    references_destroy(experiment->refs);
    crack_fronts_free(&experiment->fronts);
    simulation_destroy(experiment->sim);
    record_close(&experiment->record);
    history_close(&experiment->history);
    free(experiment->block);
}

/* --- forwards ------------------------------------------------------------------------------------- */

/* At a whole step, its row taken: changes come into force, a keyframe is kept. */
static bool arrive(Experiment *experiment, Status *status)
{
    if (!changes_apply(&experiment->base, experiment->sim, status))
        return false;
    if (experiment->sim->step == experiment->newest)
        copy_events(experiment);
    history_keep(&experiment->history, experiment->sim);
    note_now(experiment);
    return true;
}

static long least(long a, long b)
{
    return a < b ? a : b;
}

/* A run that is to end at rest ends where it has come to it; what was asked for beyond is not pending. */
static void end_at_rest(Experiment *experiment)
{
    if (!experiment->sim->at_rest || experiment->sim->stage != 0)
        return;
    experiment->last = experiment->sim->step;
    if (experiment->goal_step >= experiment->last) {
        experiment->goal_step = experiment->last;
        experiment->goal_stage = 0;
    }
}

/* Whole steps from a whole step, to the next place at which something has to be done. */
static bool one_block(Experiment *experiment, long steps, Status *status)
{
    Simulation *sim = experiment->sim;
    bool fresh = sim->step >= experiment->newest;
    long count = least(steps, experiment->last - sim->step),
         next = changes_next(&experiment->base, sim->step);
    count = least(count, history_next(&experiment->history, sim->step));
    count = least(count, next == LONG_MAX ? count : next - sim->step);
    count = least(count, fresh ? BLOCK : experiment->newest - sim->step);
    long before = sim->step, done;
    bool sound = simulation_steps(sim, count, fresh ? experiment->block : NULL, &done, status);
    end_at_rest(experiment);
    for (long k = 0; fresh && k < done; k++) {
        if (!take_row(experiment, experiment->block + k * sim->n_series, before + k + 1))
            return out_of_memory(status);
        experiment->newest = before + k + 1;
    }
    return sound && arrive(experiment, status);
}

static bool finish_step(Experiment *experiment, Status *status)
{
    Simulation *sim = experiment->sim;
    while (sim->stage != 0)
        if (!simulation_stage(sim, status))
            return false;
    end_at_rest(experiment);
    if (sim->step > experiment->newest) {
        simulation_row(sim, experiment->block);
        if (!take_row(experiment, experiment->block, sim->step))
            return out_of_memory(status);
        experiment->newest = sim->step;
    }
    return arrive(experiment, status);
}

/* A simulation that has failed goes no further even where it is sound; its own snapshot, put back, wipes the
 * failure away, so that one can walk up to it again. */
static void wipe_failure(Simulation *sim)
{
    void *bytes = malloc(simulation_snapshot_size(sim));
    if (!bytes)
        return;
    simulation_snapshot(sim, bytes);
    simulation_restore(sim, bytes);
    free(bytes);
}

/* Back to the last sound whole step; the record holds everything up to there. */
static bool fail(Experiment *experiment, const Status *why, Status *status)
{
    Simulation *sim = experiment->sim;
    experiment->failed = true;
    experiment->failure = *why;
    if (sim->stage == 0 && sim->item == 0 && sim->step == experiment->newest) {
        wipe_failure(sim);
    } else {
        const Keyframe *frame = history_nearest(&experiment->history, experiment->newest);
        simulation_restore(sim, frame->bytes);
        while (sim->step < experiment->newest)
            if (!one_block(experiment, experiment->newest - sim->step, NULL))
                break;
    }
    note_now(experiment);
    if (status)
        *status = *why;
    return false;
}

static bool may_go_on(const Experiment *experiment, Status *status)
{
    if (!experiment->failed || experiment->sim->step < experiment->newest)
        return true;
    if (status)
        *status = experiment->failure;
    return false;
}

bool experiment_do_steps(Experiment *experiment, long steps, Status *status)
{
    Status why = {0};
    if (experiment->sim->stage != 0 && !finish_step(experiment, &why))
        return fail(experiment, &why, status);
    while (steps > 0 && experiment->sim->step < experiment->last) {
        if (!may_go_on(experiment, status))
            return false;
        long before = experiment->sim->step;
        if (!one_block(experiment, steps, &why))
            return fail(experiment, &why, status);
        steps -= experiment->sim->step - before;
    }
    return true;
}

bool experiment_do_stage(Experiment *experiment, Status *status)
{
    Status why = {0};
    Simulation *sim = experiment->sim;
    if (sim->stage == 0 && sim->step >= experiment->last)
        return true;
    if (!simulation_stage(sim, &why))
        return fail(experiment, &why, status);
    return sim->stage != 0 || finish_step(experiment, &why) || fail(experiment, &why, status);
}

bool experiment_do_slice(Experiment *experiment, size_t items, bool *whole, Status *status)
{
    Status why = {0};
    Simulation *sim = experiment->sim;
    bool stage_done = false, begun = sim->stage != 0 || sim->item != 0;
    *whole = !begun && sim->step >= experiment->last;
    if (*whole)
        return true;
    if (!begun && !may_go_on(experiment, status))
        return false;
    if (!simulation_slice(sim, items, &stage_done, &why))
        return fail(experiment, &why, status);
    *whole = stage_done && sim->stage == 0;
    return !*whole || finish_step(experiment, &why) || fail(experiment, &why, status);
}

/* --- backwards ------------------------------------------------------------------------------------ */

void experiment_approach(Experiment *experiment, long step, int stage)
{
    Simulation *sim = experiment->sim;
    const Keyframe *frame = history_nearest(&experiment->history, step);
    bool beyond = sim->step > step || (sim->step == step && sim->stage > stage);
    if (frame && (beyond || frame->step > sim->step)) {
        simulation_restore(sim, frame->bytes);
        note_now(experiment);
    }
}

/* --- another future ------------------------------------------------------------------------------- */

/* A filter looks back over rows that the record may have thinned out; then they are computed again. */
static void refill_references(Experiment *experiment, long step)
{
    long memory = references_memory(experiment->refs);
    if (memory == 0)
        return;
    long first = step - memory > 0 ? step - memory : 0;
    double row[COLUMNS_MAX];
    size_t bytes = simulation_snapshot_size(experiment->sim);
    void *present = malloc(bytes);
    const Keyframe *frame = history_nearest(&experiment->history, first);
    references_reset(experiment->refs);
    if (!present)
        return;
    simulation_snapshot(experiment->sim, present);
    simulation_restore(experiment->sim, frame->bytes);
    Simulation *sim = experiment->sim;
    for (bool sound = true; sound; sound = one_block(experiment, 1, NULL)) {
        if (sim->step >= first) {
            simulation_row(sim, experiment->block);
            references_row(experiment->refs, sim->step, simulation_time(sim), experiment->block, row);
        }
        if (sim->step >= step)
            break;
    }
    simulation_restore(sim, present);
    free(present);
}

static int find_column(const Experiment *experiment, const char *name)
{
    for (int i = 0; i < experiment->n_columns; i++)
        if (strcmp(experiment->columns[i].quantity.name, name) == 0)
            return i;
    return -1;
}

static bool same_columns(const Experiment *experiment, const Column *columns, int n_columns)
{
    for (int i = 0; i < n_columns && n_columns == experiment->n_columns; i++)
        if (find_column(experiment, columns[i].quantity.name) != i)
            return false;
    return n_columns == experiment->n_columns;
}

/* The kept rows up to a step as other references would have written them: what the method gave is in every
 * row, the answers beside it are worked out again. False: no memory. */
static bool write_rows_again(const Experiment *experiment, References *refs, const Column *columns,
                             int n_columns, long step, Record *out)
{
    int series[COLUMNS_MAX], kept[COLUMNS_MAX];
    double row[COLUMNS_MAX], *given = experiment->block;
    for (int i = 0; i < experiment->n_columns; i++)
        series[i] = simulation_find_series(experiment->sim, experiment->columns[i].quantity.name);
    for (int i = 0; i < n_columns; i++)
        kept[i] = find_column(experiment, columns[i].quantity.name);
    const bool memory = references_memory(refs) > 0;
    record_open(out, n_columns, experiment->record.spacing, record_budget);
    out->thinned = experiment->record.thinned;
    for (size_t k = 0; k < experiment->record.count && record_row(&experiment->record, k)[0] <= (double)step;
         k++) {
        const double *old = record_row(&experiment->record, k);
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
    if (!patience_lasts(&experiment->base.patience, 0))
        return status_fail(status, STATUS_FAILED, "the change was given up");
    References *refs = references_create(&experiment->base, experiment->sim, status);
    if (!refs)
        return false;
    Column columns[COLUMNS_MAX];
    const int n = references_columns(refs, columns);
    Record record;
    if (references_memory(experiment->refs) > 0 && same_columns(experiment, columns, n)) {
        references_destroy(refs); /* it would have to look back anew */
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
    bool shorter = experiment->newest > step;
    history_cut(&experiment->history, step);
    record_cut(&experiment->record, step);
    if (shorter)
        experiment->newest = step;
    while (experiment->n_events > 0 && experiment->events[experiment->n_events - 1].step > step)
        experiment->n_events--;
    experiment->failed = experiment->failed && !shorter;
    if (shorter)
        experiment->last = problem_last_step(experiment->sim->dt, experiment->base.time.end);
    if (shorter)
        refill_references(experiment, step);
}

bool experiment_change(Experiment *experiment, long step, const char *key, const char *value, Status *status)
{
    Settings before = experiment->base;
    if (!changes_add(&experiment->base, step, key, value, status) ||
        !settings_check(&experiment->base, status) || !renew_references(experiment, step, status)) {
        experiment->base = before;
        return false;
    }
    cut(experiment, step);
    note_now(experiment);
    experiment_derive(experiment, experiment->base.patience);
    experiment->failed = false; /* what stopped the run may not stop the changed one */
    Simulation *sim = experiment->sim;
    if (sim->stage != 0 || sim->step != step)
        return true;
    Status why = {0};
    bool others = changes_next(&before, step - 1) == step;
    if (others && step > 0) {
        /* the state must be that of a run which never knew another order of changes */
        simulation_restore(sim, history_nearest(&experiment->history, step - 1)->bytes);
        while (sim->step < step)
            if (!one_block(experiment, step - sim->step, &why))
                return fail(experiment, &why, status);
        return true;
    }
    return arrive(experiment, &why) || fail(experiment, &why, status);
}

void experiment_set_end(Experiment *experiment, double end)
{
    Simulation *sim = experiment->sim;
    const double before = experiment->base.time.end;
    experiment->base.time.end = experiment->now.time.end = end;
    /* a run that has come to rest before does not go on */
    const bool rested = experiment->last < problem_last_step(sim->dt, before);
    const long last = problem_last_step(sim->dt, end);
    experiment->last = rested ? least(last, experiment->last) : last;
    if (sim->step > experiment->last || (sim->step == experiment->last && sim->stage > 0)) {
        experiment_approach(experiment, experiment->last, 0);
        experiment_do_steps(experiment, experiment->last - sim->step, NULL);
    }
    if (experiment->newest > experiment->last)
        cut(experiment, experiment->last);
}
