/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run from its start to its end without a screen, tables and frames written on the way: the engine of
 * `matvib run` and of a sweep. */
#include "export/export.h"
#include "base/text.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"
#include "scenario/changes.h"
#include "export/export_internal.h"
#include "answers/references.h"
#include "answers/summary.h"
#include "scenario/parameters.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The rows from which the summary's frequency is measured: as many as the laboratory keeps. */
static const size_t record_budget = (size_t)32 << 20;

/* --- on the way ------------------------------------------------------------------------------------ */

static bool take_row(void *owner, Run *run, long step, const double *method_row, Status *status)
{
    Export *export = owner;
    double *row = export->newest;
    references_row(export->refs, step, (double)step * run->sim->dt, method_row, row);
    if (step % settings_output(export->settings)->every != 0 && step != run->last)
        return true; /* references that look back want every step */
    if (!record_append(&export->record, row))
        return status_fail(status, "not enough memory for the run's record");
    return export_write_row(export, row, status);
}

static long next_frame(const void *owner, long step)
{
    const Export *export = owner;
    (void)step;
    return export->next_frame < export->frames.count ? export->frames.steps[export->next_frame] : LONG_MAX;
}

static bool take_frame(void *owner, Run *run, Status *status)
{
    (void)run;
    return export_write_frame(owner, status);
}

static bool take_stage(void *owner, Run *run, long step, int stage, Status *status)
{
    (void)run;
    return export_write_stage(owner, step, stage, status);
}

/* The run has failed, or come to rest: its last sound step is its last one, with a row, and with the frame
 * that takes the place of all that were to come. */
static bool end_early(Export *export, Status *status)
{
    Run *run = &export->run;
    const long step = run->sim->step;
    run->last = step;
    if (run->sim->stage != 0) /* a method that cannot go back to its last sound step: rows alone */
        return true;
    if (run->failed && !run_is_sound(run))
        return status_fail(status, "not enough memory to end the run");
    const Record *record = &export->record;
    if (record_row(record, record->count - 1)[0] < (double)step) {
        if (export->newest[0] < (double)step) {
            simulation_row(run->sim, run->block);
            references_row(export->refs, step, simulation_time(run->sim), run->block, export->newest);
        }
        if (!record_append(&export->record, export->newest))
            return status_fail(status, "not enough memory for the run's record");
        if (!export_write_row(export, export->newest, status))
            return false;
    }
    const bool written = export->next_frame > 0 && export->frames.steps[export->next_frame - 1] == step;
    return written || next_frame(export, step) == LONG_MAX || export_write_frame(export, status);
}

/* --- the whole ------------------------------------------------------------------------------------- */

/* E* at the present step; NAN where the change of E* over the whole run means nothing. */
static double invariant_of(const Export *export)
{
    Settings then;
    if (export->run.sim->failed || export->run.sim->stage != 0 ||
        !references_have_invariant(export->settings))
        return NAN;
    changes_in_force(export->settings, export->run.sim->step, &then);
    return references_have_invariant(&then) ? references_invariant(export->run.sim, &then) : NAN;
}

/* What cannot be worked out stays away from a summary; for want of memory it must not. */
static bool sum_up(const Export *export, RunSummary *summary, Status *status)
{
    const Record *record = &export->record;
    errno = 0;
    size_t rows = record->count - (record->loose_last && record->count > 0 ? 1 : 0);
    summary->mistake = settings_mistake(export->settings);
    summary->steps = export->run.sim->step;
    summary->dt = export->run.sim->dt;
    summary->time = simulation_time(export->run.sim);
    summary->rows = export->rows;
    summary->frames = export->next_frame > 0 ? export->frames.count : 0;
    references_readout(export->refs, record->rows, rows, record->n_columns, &summary->readout);
    summary->readout.time = summary->time;
    summary->readout.late = readout_late(&summary->readout, summary->time);
    const double invariant[2] = {export->invariant, invariant_of(export)};
    summary->n_findings = references_findings(export->refs, export->run.sim, summary->findings);
    for (int i = 0; i < export->run.sim->n_events && summary->n_events < SUMMARY_EVENTS_MAX; i++)
        if (export->run.sim->events[i].kind != EVENT_CROSSING)
            summary->events[summary->n_events++] = export->run.sim->events[i];
    summary_rows(summary, export->run.sim, export->columns, export->n_columns, record->rows, record->count,
                 invariant);
    summary->n_derived = problem_derived(export->settings, export->run.sim, summary->derived);
    summary_crack(summary, export->run.sim, export->settings);
    if (cancel_requested(&export->settings->cancel, 1)) /* the cost of many broken bonds takes its time */
        return status_fail(status, "interrupted");
    return errno != ENOMEM || status_fail(status, "not enough memory to sum the run up");
}

bool export_writes(const Settings *settings, const Simulation *sim, int i, const char *column)
{
    const char *asked = settings_output(settings)->columns;
    return i < 2 || (asked[strspn(asked, ", ")] ? simulation_asks(asked, column)
                                                : !simulation_is_on_request(sim, column));
}

static bool is_field(const Simulation *sim, const char *name)
{
    for (int i = 0; i < sim->n_fields; i++)
        if (strcmp(sim->fields[i].quantity.name, name) == 0)
            return true;
    return false;
}

static bool is_column(const Export *export, const char *name)
{
    for (int i = 0; i < export->n_columns; i++)
        if (strcmp(export->columns[i].quantity.name, name) == 0)
            return true;
    return false;
}

/* What is written, in the order of the series; what is asked for is there. */
static bool choose_columns(Export *export, Status *status)
{
    const char *asked = settings_output(export->settings)->columns;
    char known[512] = "all";
    for (int i = 0; i < export->n_columns; i++) {
        const char *name = export->columns[i].quantity.name;
        if (export_writes(export->settings, export->run.sim, i, name))
            export->written[export->n_written++] = i;
        text_list_add(known, sizeof known, name);
    }
    for (int i = 0; i < export->run.sim->n_askable; i++)
        if (!is_column(export, export->run.sim->series_own[i].name))
            text_list_add(known, sizeof known, export->run.sim->series_own[i].name);
    const bool tables = export->outputs->particles || export->outputs->nodes || export->outputs->bonds;
    for (char name[80]; text_next_item(&asked, name, sizeof name);)
        if (strcmp(name, "all") != 0 && !is_column(export, name) &&
            !(tables && is_field(export->run.sim, name)))
            return status_refuse(status, "output.columns: %.60s is not a column of the series (%s)", name,
                                 known);
    return true;
}

/* Tables of stages are in the place of those at frames. */
static bool stages_fit(Export *export, Status *status)
{
    const long *stages = export->outputs->stages;
    if (stages[0] == 0)
        return true;
    export->frames.count = 0;
    return stages[1] <= export->run.last ||
           status_refuse(status, "--stages: the run has %ld steps", export->run.last);
}

static bool prepare(Export *export, int threads, Status *status)
{
    const Settings *settings = export->settings;
    char advice[160];
    if (!changes_advice(settings, advice, sizeof advice, status))
        return false;
    if (!run_open(&export->run, settings, problem_simulate(settings, threads, status), status))
        return false;
    export->run.sim->spares_rows = !export->outputs->series; /* then nobody reads them column by column */
    export->planned_last = export->run.last;
    if (!frames_plan(&export->frames, settings, export->run.sim->dt, export->run.last, status) ||
        !stages_fit(export, status) || !export_check_names(export, status))
        return false;
    export->refs = references_create(settings, export->run.sim, status);
    if (!export->refs)
        return false;
    export->n_columns = references_columns(export->refs, export->columns);
    if (!choose_columns(export, status))
        return false;
    export->vtk = calloc(export->frames.count + 1, sizeof *export->vtk);
    if (!export->vtk)
        return status_fail(status, "not enough memory for the run");
    record_open(&export->record, export->n_columns, settings_output(settings)->every, record_budget);
    return export_open_files(export, status);
}

/* True if the run came to its end or failed by itself; what it wrote is good either way. */
static bool go(Export *export, RunSummary *summary, Status *status)
{
    Run *run = &export->run;
    Sink sinks[3];
    errno = 0;
    export->invariant = invariant_of(export);
    if (errno == ENOMEM)
        return status_fail(status, "not enough memory for the energy at the start");
    /* Series, frames, and the stages of some steps. */
    const long every = references_memory(export->refs) > 0 ? 1 : settings_output(export->settings)->every;
    sinks[0] = (Sink){.every = every, .row = take_row, .owner = export, .beside = &sinks[1]};
    sinks[1] = (Sink){.next = next_frame, .state = take_frame, .owner = export, .beside = &sinks[2]};
    sinks[2] = (Sink){.stage = take_stage,
                      .first = export->outputs->stages[0],
                      .last = export->outputs->stages[1],
                      .owner = export};
    if (!run_start(run, sinks, status) || (!run_to_end(run, sinks, status) && !run->failed))
        return false;
    summary->failed = run->failed;
    summary->failure = run->failure;
    if ((run->failed || run->sim->at_rest) && !end_early(export, status))
        return false;
    return run->failed || !cancel_requested(&run->cancel, 1) || status_fail(status, "interrupted");
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
    bool written = prepare(&export, threads, status);
    export.run.cancel = (Cancel){progress, context};
    written = written && go(&export, summary, status) && export_finish_files(&export, status) &&
              export_commit_files(&export, status) && sum_up(&export, summary, status);
    export_close_files(&export);
    free(export.vtk);
    record_close(&export.record);
    frames_free(&export.frames);
    references_destroy(export.refs);
    run_close(&export.run);
    if (written && summary->failed)
        status_take(status, &summary->failure);
    return written && !summary->failed;
}

static void add(Frames *frames, long step)
{
    if (frames->count == 0 || frames->steps[frames->count - 1] < step)
        frames->steps[frames->count++] = step;
}

bool frames_plan(Frames *frames, const Settings *settings, double dt, long last, Status *status)
{
    double times[TIMES_MAX];
    int n_times = settings_times_read(settings_output(settings)->at, times, status);
    if (n_times < 0)
        return false;
    size_t most = settings_output(settings)->frames > 1 ? (size_t)settings_output(settings)->frames : 1;
    if ((size_t)n_times > most)
        most = (size_t)n_times;
    frames->count = 0;
    frames->steps = malloc(most * sizeof *frames->steps);
    if (!frames->steps)
        return status_fail(status, "not enough memory for %zu frames", most);
    if (settings_output(settings)->frames > 1)
        for (int i = 0; i < settings_output(settings)->frames; i++)
            add(frames, lround((double)last * i / (settings_output(settings)->frames - 1)));
    else if (n_times > 0)
        for (int i = 0; i < n_times; i++) {
            long step = lround(times[i] / dt);
            add(frames, step < last ? step : last);
        }
    else
        add(frames, last);
    return true;
}

void frames_free(Frames *frames)
{
    free(frames->steps);
    *frames = (Frames){0};
}
