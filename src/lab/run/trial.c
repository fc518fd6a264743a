#include "lab/run/trial.h"
#include "lab/settings/changes.h"
#include "lab/settings/parameters.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

static const size_t record_budget = (size_t)32 << 20;
enum { BLOCK = 256 }; /* rows that a method writes at once */

/* --- life ----------------------------------------------------------------------------------------- */

static bool take_row(Trial *trial, const double *method_row, long step)
{
    double row[COLUMNS_MAX];
    references_row(trial->refs, step, (double)step * trial->sim->dt, method_row, row);
    return record_append(&trial->record, row);
}

static void copy_events(Trial *trial)
{
    const Simulation *sim = trial->sim;
    memcpy(trial->events, sim->events, (size_t)sim->n_events * sizeof sim->events[0]);
    trial->n_events = sim->n_events;
}

static void note_now(Trial *trial)
{
    if (trial->base.n_changes > 0)
        changes_in_force(&trial->base, trial->sim->step, &trial->now);
}

static bool out_of_memory(Status *status)
{
    return status_fail(status, STATUS_FAILED, "not enough memory for the run's record");
}

static bool begin(Trial *trial, size_t history, Status *status)
{
    Simulation *sim = trial->sim;
    trial->n_columns = references_columns(trial->refs, trial->columns);
    record_open(&trial->record, trial->n_columns, 1, record_budget);
    history_open(&trial->history, history);
    trial->last = problem_last_step(sim->dt, trial->base.time.end);
    trial->block = malloc(BLOCK * (size_t)sim->n_series * sizeof *trial->block);
    if (!trial->block)
        return out_of_memory(status);
    simulation_row(sim, trial->block);
    if (!take_row(trial, trial->block, 0))
        return out_of_memory(status);
    if (!changes_apply(&trial->base, sim, status))
        return false;
    copy_events(trial);
    changes_in_force(&trial->base, 0, &trial->now);
    return history_keep(&trial->history, sim) || out_of_memory(status);
}

bool trial_open(Trial *trial, const Settings *settings, size_t history, int threads, Status *status)
{
    memset(trial, 0, sizeof *trial);
    trial->base = *settings;
    if (!settings_check(settings, status) ||
        !changes_advice(settings, trial->advice, sizeof trial->advice, status))
        return false;
    trial->sim = problem_simulate(settings, threads, status);
    if (trial->sim)
        trial->refs = problem_references(settings, trial->sim, status);
    if (trial->refs && begin(trial, history, status))
        return true;
    trial_close(trial);
    return false;
}

bool trial_adopt(Trial *trial, const Settings *settings, Simulation *sim, size_t history, Status *status)
{
    memset(trial, 0, sizeof *trial);
    trial->base = *settings;
    trial->sim = sim;
    trial->refs = problem_no_references(sim, status);
    if (trial->refs && begin(trial, history, status))
        return true;
    trial_close(trial);
    return false;
}

void trial_rewind(Trial *trial, Record *old)
{
    Simulation *sim = trial->sim;
    simulation_restore(sim, history_nearest(&trial->history, 0)->bytes);
    history_reset(&trial->history);
    *old = trial->record;
    record_open(&trial->record, trial->n_columns, 1, record_budget);
    references_reset(trial->refs);
    simulation_row(sim, trial->block);
    if (!take_row(trial, trial->block, 0)) {
        /* no memory for another record: then there is nothing to hand over */
        record_close(&trial->record);
        trial->record = *old;
        *old = (Record){0};
        record_cut(&trial->record, 0);
    }
    trial->newest = 0;
    trial->failed = false;
    copy_events(trial);
    note_now(trial);
}

void trial_close(Trial *trial)
{
    references_destroy(trial->refs);
    simulation_destroy(trial->sim);
    record_close(&trial->record);
    history_close(&trial->history);
    free(trial->block);
    memset(trial, 0, sizeof *trial);
}

/* --- forwards ------------------------------------------------------------------------------------- */

/* At a whole step, its row taken: changes come into force, a keyframe is kept. */
static bool arrive(Trial *trial, Status *status)
{
    if (!changes_apply(&trial->base, trial->sim, status))
        return false;
    if (trial->sim->step == trial->newest)
        copy_events(trial);
    history_keep(&trial->history, trial->sim);
    note_now(trial);
    return true;
}

static long least(long a, long b)
{
    return a < b ? a : b;
}

/* Whole steps from a whole step, to the next place at which something has to be done. */
static bool one_block(Trial *trial, long steps, Status *status)
{
    Simulation *sim = trial->sim;
    bool fresh = sim->step >= trial->newest;
    long count = least(steps, trial->last - sim->step), next = changes_next(&trial->base, sim->step);
    count = least(count, history_next(&trial->history, sim->step));
    count = least(count, next == LONG_MAX ? count : next - sim->step);
    count = least(count, fresh ? BLOCK : trial->newest - sim->step);
    long before = sim->step, done;
    bool sound = simulation_steps(sim, count, fresh ? trial->block : NULL, &done, status);
    for (long k = 0; fresh && k < done; k++) {
        if (!take_row(trial, trial->block + k * sim->n_series, before + k + 1))
            return out_of_memory(status);
        trial->newest = before + k + 1;
    }
    return sound && arrive(trial, status);
}

static bool finish_step(Trial *trial, Status *status)
{
    Simulation *sim = trial->sim;
    while (sim->stage != 0)
        if (!simulation_stage(sim, status))
            return false;
    if (sim->step > trial->newest) {
        simulation_row(sim, trial->block);
        if (!take_row(trial, trial->block, sim->step))
            return out_of_memory(status);
        trial->newest = sim->step;
    }
    return arrive(trial, status);
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
static bool fail(Trial *trial, const Status *why, Status *status)
{
    Simulation *sim = trial->sim;
    trial->failed = true;
    trial->failure = *why;
    if (sim->stage == 0 && sim->item == 0 && sim->step == trial->newest) {
        wipe_failure(sim);
    } else {
        const Keyframe *frame = history_nearest(&trial->history, trial->newest);
        simulation_restore(sim, frame->bytes);
        while (sim->step < trial->newest)
            if (!one_block(trial, trial->newest - sim->step, NULL))
                break;
    }
    note_now(trial);
    if (status)
        *status = *why;
    return false;
}

static bool may_go_on(const Trial *trial, Status *status)
{
    if (!trial->failed || trial->sim->step < trial->newest)
        return true;
    if (status)
        *status = trial->failure;
    return false;
}

bool trial_steps(Trial *trial, long steps, Status *status)
{
    Status why = {0};
    if (trial->sim->stage != 0 && !finish_step(trial, &why))
        return fail(trial, &why, status);
    while (steps > 0 && trial->sim->step < trial->last) {
        if (!may_go_on(trial, status))
            return false;
        long before = trial->sim->step;
        if (!one_block(trial, steps, &why))
            return fail(trial, &why, status);
        steps -= trial->sim->step - before;
    }
    return true;
}

bool trial_stage(Trial *trial, Status *status)
{
    Status why = {0};
    Simulation *sim = trial->sim;
    if (sim->stage == 0 && sim->step >= trial->last)
        return true;
    if (!simulation_stage(sim, &why))
        return fail(trial, &why, status);
    return sim->stage != 0 || finish_step(trial, &why) || fail(trial, &why, status);
}

bool trial_slice(Trial *trial, size_t items, bool *whole, Status *status)
{
    Status why = {0};
    Simulation *sim = trial->sim;
    bool stage_done = false, begun = sim->stage != 0 || sim->item != 0;
    *whole = !begun && sim->step >= trial->last;
    if (*whole)
        return true;
    if (!begun && !may_go_on(trial, status))
        return false;
    if (!simulation_slice(sim, items, &stage_done, &why))
        return fail(trial, &why, status);
    *whole = stage_done && sim->stage == 0;
    return !*whole || finish_step(trial, &why) || fail(trial, &why, status);
}

/* --- backwards ------------------------------------------------------------------------------------ */

void trial_approach(Trial *trial, long step, int stage)
{
    Simulation *sim = trial->sim;
    const Keyframe *frame = history_nearest(&trial->history, step);
    bool beyond = sim->step > step || (sim->step == step && sim->stage > stage);
    if (frame && (beyond || frame->step > sim->step)) {
        simulation_restore(sim, frame->bytes);
        note_now(trial);
    }
}

/* --- another future ------------------------------------------------------------------------------- */

/* A filter looks back over rows that the record may have thinned out; then they are computed again. */
static void refill_references(Trial *trial, long step)
{
    long memory = references_memory(trial->refs);
    if (memory == 0)
        return;
    long first = step - memory > 0 ? step - memory : 0;
    double row[COLUMNS_MAX];
    size_t bytes = simulation_snapshot_size(trial->sim);
    void *present = malloc(bytes);
    const Keyframe *frame = history_nearest(&trial->history, first);
    references_reset(trial->refs);
    if (!present)
        return;
    simulation_snapshot(trial->sim, present);
    simulation_restore(trial->sim, frame->bytes);
    Simulation *sim = trial->sim;
    for (bool sound = true; sound; sound = one_block(trial, 1, NULL)) {
        if (sim->step >= first) {
            simulation_row(sim, trial->block);
            references_row(trial->refs, sim->step, simulation_time(sim), trial->block, row);
        }
        if (sim->step >= step)
            break;
    }
    simulation_restore(sim, present);
    free(present);
}

static int find_column(const Trial *trial, const char *name)
{
    for (int i = 0; i < trial->n_columns; i++)
        if (strcmp(trial->columns[i].quantity.name, name) == 0)
            return i;
    return -1;
}

static bool same_columns(const Trial *trial, const Column *columns, int n_columns)
{
    for (int i = 0; i < n_columns && n_columns == trial->n_columns; i++)
        if (find_column(trial, columns[i].quantity.name) != i)
            return false;
    return n_columns == trial->n_columns;
}

/* The kept rows up to a step as other references would have written them: what the method gave is in every
 * row, the answers beside it are worked out again. False: no memory. */
static bool write_rows_again(const Trial *trial, References *refs, const Column *columns, int n_columns,
                             long step, Record *out)
{
    int series[COLUMNS_MAX], kept[COLUMNS_MAX];
    double row[COLUMNS_MAX], *given = trial->block;
    for (int i = 0; i < trial->n_columns; i++)
        series[i] = simulation_find_series(trial->sim, trial->columns[i].quantity.name);
    for (int i = 0; i < n_columns; i++)
        kept[i] = find_column(trial, columns[i].quantity.name);
    const bool memory = references_memory(refs) > 0;
    record_open(out, n_columns, trial->record.spacing, record_budget);
    out->thinned = trial->record.thinned;
    for (size_t k = 0; k < trial->record.count && record_row(&trial->record, k)[0] <= (double)step; k++) {
        const double *old = record_row(&trial->record, k);
        for (int i = 0; i < trial->n_columns; i++)
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
static bool renew_references(Trial *trial, long step, Status *status)
{
    References *refs = problem_references(&trial->base, trial->sim, status);
    if (!refs)
        return false;
    Column columns[COLUMNS_MAX];
    const int n = references_columns(refs, columns);
    Record record;
    if (references_memory(trial->refs) > 0 && same_columns(trial, columns, n)) {
        references_destroy(refs); /* it would have to look back anew */
        return true;
    }
    if (!write_rows_again(trial, refs, columns, n, step, &record)) {
        references_destroy(refs);
        return out_of_memory(status);
    }
    record_close(&trial->record);
    trial->record = record;
    memcpy(trial->columns, columns, sizeof columns);
    trial->n_columns = n;
    references_destroy(trial->refs);
    trial->refs = refs;
    refill_references(trial, least(step, trial->newest));
    return true;
}

static void cut(Trial *trial, long step)
{
    bool shorter = trial->newest > step;
    history_cut(&trial->history, step);
    record_cut(&trial->record, step);
    if (shorter)
        trial->newest = step;
    while (trial->n_events > 0 && trial->events[trial->n_events - 1].step > step)
        trial->n_events--;
    trial->failed = trial->failed && !shorter;
    if (shorter)
        refill_references(trial, step);
}

bool trial_change(Trial *trial, long step, const char *key, const char *value, Status *status)
{
    Settings before = trial->base;
    if (!changes_add(&trial->base, step, key, value, status) || !settings_check(&trial->base, status) ||
        !renew_references(trial, step, status)) {
        trial->base = before;
        return false;
    }
    cut(trial, step);
    note_now(trial);
    trial->failed = false; /* what stopped the run may not stop the changed one */
    Simulation *sim = trial->sim;
    if (sim->stage != 0 || sim->step != step)
        return true;
    Status why = {0};
    bool others = changes_next(&before, step - 1) == step;
    if (others && step > 0) {
        /* the state must be that of a run which never knew another order of changes */
        simulation_restore(sim, history_nearest(&trial->history, step - 1)->bytes);
        while (sim->step < step)
            if (!one_block(trial, step - sim->step, &why))
                return fail(trial, &why, status);
        return true;
    }
    return arrive(trial, &why) || fail(trial, &why, status);
}

void trial_set_end(Trial *trial, double end)
{
    Simulation *sim = trial->sim;
    trial->base.time.end = trial->now.time.end = end;
    trial->last = problem_last_step(sim->dt, end);
    if (sim->step > trial->last || (sim->step == trial->last && sim->stage > 0)) {
        trial_approach(trial, trial->last, 0);
        trial_steps(trial, trial->last - sim->step, NULL);
    }
    if (trial->newest > trial->last)
        cut(trial, trial->last);
}
