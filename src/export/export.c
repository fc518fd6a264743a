/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run from its start to its end without a screen, tables and frames written on the way: the engine of
 * `matvib run` and of a sweep. Goes in batches of steps up to the next row, frame, change or question whether
 * to go on. */
#include "base/text.h"
#include "scenario/changes.h"
#include "export/export_internal.h"
#include "answers/invariant.h"
#include "scenario/parameters.h"
#include "answers/summary.h"
#include "base/math/functions.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The rows from which the summary's frequency is measured: as many as the laboratory keeps. */
static const size_t record_budget = (size_t)32 << 20;

enum { BLOCK = 256 }; /* rows that a method writes at once */

/* --- the run --------------------------------------------------------------------------------------- */

static bool take_row(Export *export, const double *method_row, long step, Status *status)
{
    double *row = export->newest;
    references_row(export->refs, step, (double)step * export->sim->dt, method_row, row);
    bool due = step % export->settings->output.every == 0 || step == export->last;
    if (!due)
        return true;
    if (!record_append(&export->record, row))
        return status_fail(status, STATUS_FAILED, "not enough memory for the run's record");
    return export_write_row(export, row, status);
}

static long least(long a, long b)
{
    return a < b ? a : b;
}

/* How far to go before something has to be done. Sets *every_row if each of these steps needs a row. */
static long next_stop(const Export *export, bool *every_row)
{
    const Simulation *sim = export->sim;
    long every = export->settings->output.every, next = changes_next(export->settings, sim->step);
    long count = export->last - sim->step;
    *every_row = every == 1 || references_memory(export->refs) > 0;
    count = least(least(count, BLOCK), simulation_steps_a_question(sim));
    if (!*every_row)
        count = least(count, every - sim->step % every);
    if (next != LONG_MAX)
        count = least(count, next - sim->step);
    if (export->next_frame<export->frames.count &&export->frames.steps[export->next_frame]> sim->step)
        count = least(count, export->frames.steps[export->next_frame] - sim->step);
    return count;
}

/* False with `*stopped`: the run itself failed, all before it is sound. */
static bool go_on(Export *export, bool *stopped, Status *status)
{
    Simulation *sim = export->sim;
    bool every_row;
    long count = next_stop(export, &every_row), before = sim->step, done;
    bool sound = simulation_steps(sim, count, every_row ? export->block : NULL, &done, status);
    for (long k = 0; every_row && k < done; k++)
        if (!take_row(export, export->block + k * sim->n_series, before + k + 1, status))
            return false;
    *stopped = !sound;
    if (!sound)
        return false;
    if (!every_row && (sim->step % export->settings->output.every == 0 || sim->step == export->last)) {
        simulation_row(sim, export->block);
        if (!take_row(export, export->block, sim->step, status))
            return false;
    }
    if (!changes_apply(export->settings, sim, status)) {
        *stopped = true;
        return false;
    }
    return export_write_due_frame(export, false, status);
}

/* The run has failed, or come to rest: its last sound step is its last one. */
static bool end_early(Export *export, Status *status)
{
    Simulation *sim = export->sim;
    if (sim->stage != 0) { /* a method that cannot go back to its last sound step: rows alone */
        export->last = sim->step;
        return true;
    }
    /* the failure is known; rows and tables of the sound state are wanted */
    size_t size = simulation_snapshot_size(sim);
    void *state = malloc(size);
    if (!state)
        return status_fail(status, STATUS_FAILED, "not enough memory to end the run");
    simulation_snapshot(sim, state);
    simulation_restore(sim, state);
    free(state);
    export->last = sim->step;
    const Record *record = &export->record;
    if (record_row(record, record->count - 1)[0] < (double)sim->step) {
        simulation_row(sim, export->block);
        if (references_memory(export->refs) > 0) {
            if (!export_write_row(export, export->newest, status)) /* the filter has seen it */
                return false;
        } else if (!take_row(export, export->block, sim->step, status)) {
            return false;
        }
    }
    bool written = export->next_frame > 0 && export->frames.steps[export->next_frame - 1] == sim->step;
    return written || export_write_due_frame(export, true, status);
}

/* --- the whole ------------------------------------------------------------------------------------- */

/* E* at the present step; NAN where the change of E* over the whole run means nothing. */
static double invariant_of(const Export *export)
{
    Settings then;
    if (export->sim->failed || export->sim->stage != 0 || !invariant_exists(export->settings))
        return NAN;
    changes_in_force(export->settings, export->sim->step, &then);
    return invariant_exists(&then) ? invariant_now(export->sim, &then) : NAN;
}

/* What cannot be worked out stays away from a summary; for want of memory it must not. */
static bool sum_up(const Export *export, RunSummary *summary, Status *status)
{
    const Record *record = &export->record;
    errno = 0;
    size_t rows = record->count - (record->loose_last && record->count > 0 ? 1 : 0);
    summary->steps = export->sim->step;
    summary->dt = export->sim->dt;
    summary->time = simulation_time(export->sim);
    summary->rows = export->rows;
    summary->frames = export->next_frame > 0 ? export->frames.count : 0;
    references_readout(export->refs, record->rows, rows, record->n_columns, &summary->readout);
    summary->readout.time = summary->time;
    summary->readout.late = readout_late(&summary->readout, summary->time);
    const double invariant[2] = {export->invariant, invariant_of(export)};
    summary->n_findings = references_findings(export->refs, export->sim, summary->findings);
    summary_rows(summary, export->sim, export->columns, export->n_columns, record->rows, record->count,
                 invariant);
    summary->n_derived = problem_derived(export->settings, export->sim, summary->derived);
    summary_crack(summary, export->sim, export->settings);
    if (!patience_lasts(&export->settings->patience, 1)) /* the cost of many broken bonds takes its time */
        return status_fail(status, STATUS_FAILED, "interrupted");
    return errno != ENOMEM || status_fail(status, STATUS_FAILED, "not enough memory to sum the run up");
}

bool export_writes(const Settings *settings, const Simulation *sim, int i, const char *column)
{
    const char *asked = settings->output.columns;
    return i < 2 ||
           (asked[strspn(asked, ", ")] ? simulation_asks(asked, column) : !simulation_is_costly(sim, column));
}

/* What is written, in the order of the series; what is asked for is there. */
static bool choose_columns(Export *export, Status *status)
{
    const char *asked = export->settings->output.columns, *at = asked + strspn(asked, ", ");
    char known[512] = "all";
    for (int i = 0; i < export->n_columns; i++) {
        const char *name = export->columns[i].quantity.name;
        if (export_writes(export->settings, export->sim, i, name))
            export->written[export->n_written++] = i;
        text_list_add(known, sizeof known, name);
    }
    for (; *at; at += strspn(at, ", ")) {
        char name[80];
        snprintf(name, sizeof name, "%.*s", (int)strcspn(at, ", "), at);
        at += strcspn(at, ", ");
        bool found = strcmp(name, "all") == 0;
        for (int i = 0; i < export->n_columns; i++)
            found = found || strcmp(name, export->columns[i].quantity.name) == 0;
        if (!found)
            return status_fail(status, STATUS_USAGE, "output.columns: %.60s is no column of the series (%s)",
                               name, known);
    }
    return true;
}

static bool prepare(Export *export, int threads, Status *status)
{
    const Settings *settings = export->settings;
    char advice[160];
    if (!settings_check(settings, status) || !changes_advice(settings, advice, sizeof advice, status))
        return false;
    export->sim = problem_simulate(settings, threads, status);
    if (!export->sim)
        return false;
    export->sim->spares_rows = !export->outputs->series; /* then nobody reads them column by column */
    export->last = export->planned_last = problem_last_step(export->sim->dt, settings->time.end);
    if (!frames_plan(&export->frames, settings, export->sim->dt, export->last, status) ||
        !export_check_names(export, status))
        return false;
    export->refs = references_create(settings, export->sim, status);
    if (!export->refs)
        return false;
    export->n_columns = references_columns(export->refs, export->columns);
    if (!choose_columns(export, status))
        return false;
    export->block = malloc(BLOCK * (size_t) export->sim->n_series * sizeof *export->block);
    export->vtk = calloc(export->frames.count + 1, sizeof *export->vtk);
    if (!export->block || !export->vtk)
        return status_fail(status, STATUS_FAILED, "not enough memory for the run");
    record_open(&export->record, export->n_columns, settings->output.every, record_budget);
    return export_open_files(export, status);
}

static bool start(Export *export, Status *status)
{
    simulation_row(export->sim, export->block);
    if (!take_row(export, export->block, 0, status))
        return false;
    errno = 0;
    export->invariant = invariant_of(export);
    if (errno == ENOMEM)
        return status_fail(status, STATUS_FAILED, "not enough memory for the energy at the start");
    return changes_apply(export->settings, export->sim, status) &&
           export_write_due_frame(export, false, status);
}

/* Towards rest it goes by the kinetic energy that is left, by powers of ten, and not by time. */
static double done_share(const Export *export)
{
    const double left = export->sim->kinetic_left, by_time = (double)export->sim->step / (double)export->last;
    return left > 0 ? fmax(by_time, fmin(1, -math_log10(left) / 10)) : by_time;
}

/* True if the run came to its end or failed by itself; what it wrote is good either way. */
static bool run(Export *export, RunProgress progress, void *context, RunSummary *summary, Status *status)
{
    if (!start(export, status))
        return false;
    while (export->sim->step < export->last && !export->sim->at_rest) {
        bool stopped = false;
        if (progress && !progress(done_share(export), context))
            return status_fail(status, STATUS_FAILED, "interrupted");
        if (go_on(export, &stopped, status))
            continue;
        if (!stopped)
            return false;
        summary->failed = true;
        export->failure = summary->failure = *status;
        return end_early(export, status);
    }
    if (export->sim->at_rest && !end_early(export, status))
        return false;
    return !progress || progress(1, context) || status_fail(status, STATUS_FAILED, "interrupted");
}

static void close_all(Export *export)
{
    export_close_files(export);
    free(export->vtk);
    free(export->block);
    record_close(&export->record);
    frames_free(&export->frames);
    references_destroy(export->refs);
    simulation_destroy(export->sim);
}

bool export_run(const Settings *settings, const Outputs *outputs, int threads, RunProgress progress,
                void *context, RunSummary *summary, Status *status)
{
    Export export = {.settings = settings, .outputs = outputs};
    RunSummary own;
    Status why = {0};
    if (!summary)
        summary = &own;
    if (!status)
        status = &why;
    *summary = (RunSummary){0};
    const bool written = prepare(&export, threads, status) &&
                         run(&export, progress, context, summary, status) &&
                         export_finish_files(&export, status) && export_commit_files(&export, status) &&
                         sum_up(&export, summary, status);
    close_all(&export);
    if (written && summary->failed)
        *status = summary->failure;
    return written && !summary->failed;
}
