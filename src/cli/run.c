/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib run SCENARIO`: from the start to the end without a screen, tables written on the way. */
#include "cli/cli.h"
#include "scenario/settings.h"
#include "cli/options.h"
#include "cli/sweep/sweep_plan.h"
#include "base/text.h"
#include "export/export.h"
#include "answers/summary.h"
#include "scenario/changes.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

static bool writes_to_standard_output(const Outputs *outputs)
{
    const char *const names[] = {outputs->series, outputs->particles, outputs->nodes, outputs->bonds};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (names[i] && strcmp(names[i], "-") == 0)
            return true;
    return false;
}

static const char *const event_words[EVENT_KINDS] = {
    [EVENT_CROSSING] = "crossing", [EVENT_BREAK] = "break",   [EVENT_TOUCH] = "touch", [EVENT_PART] = "part",
    [EVENT_TEAR] = "tear",         [EVENT_ENERGY] = "energy", [EVENT_REST] = "rest",
};

/* By the columns that a sweep has of a run: those that this one has an answer for. */
static void print_json(const Options *options, const Settings *settings, const RunSummary *summary,
                       double took)
{
    Quantities list = quantities_open(stdout, "run");
    SweepResult result = {.done = false};
    const char *unit_of_time = settings->problem->si ? settings->problem->unit_of_time : "time";
    sweep_result_of(summary, settings, took, &result);
    quantities_text(&list, "scenario", options->words[0]);
    quantities_text(&list, "title", *settings->title ? settings->title : NULL);
    quantities_text(&list, "mistake", summary->mistake);
    quantities_text(&list, "failure", summary->failed ? summary->failure.text : NULL);
    quantities_begin(&list, "events");
    for (int i = 0; i < summary->n_events; i++) {
        const Event *event = &summary->events[i];
        quantities_add(&list, event_words[event->kind], (double)event->step * summary->dt, unit_of_time);
        quantities_number(&list, "step", (double)event->step);
        quantities_text(&list, "text", event->text);
    }
    quantities_end(&list);
    quantities_begin(&list, "quantities");
    quantities_add(&list, "time", summary->time, unit_of_time);
    quantities_add(&list, "dt", summary->dt, unit_of_time);
    const ResultColumn measured =
        summary->readout.is_period ? RESULT_period_measured : RESULT_frequency_measured;
    for (int i = 0; i < RESULT_COLUMNS; i++) {
        const bool missed = summary->readout.moving && i == (int)measured && isnan(result.cells[i]);
        if (!missed && !isfinite(result.cells[i]))
            continue;
        quantities_add(&list, sweep_columns[i].name, result.cells[i], sweep_columns[i].unit);
        if (missed && *result.failure.text)
            quantities_text(&list, "why", result.failure.text);
    }
    if (isfinite(summary->readout.late) && summary->readout.measured_known)
        quantities_add(&list, "late", summary->readout.late, "period");
    for (int i = 0; i < summary->n_findings; i++) {
        const Finding *finding = &summary->findings[i];
        quantities_add(&list, finding->name, finding->measured, NULL);
        quantities_text(&list, "label", finding->label);
        quantities_number(&list, finding->word ? finding->word : "exact", finding->exact);
    }
    quantities_close(&list);
}

static void print_summary(const Options *options, const Settings *settings, const RunSummary *summary,
                          double took)
{
    if (options->json) {
        print_json(options, settings, summary, took);
        return;
    }
    FILE *to = writes_to_standard_output(&options->outputs) ? stderr : stdout;
    char text[SUMMARY_MAX];
    char advice[240] = "";
    Status ignored = {STATUS_DONE, ""};
    summary_text(summary, settings, text);
    changes_advice(settings, advice, sizeof advice, &ignored);
    if (*settings->title)
        fprintf(to, "%s\n", settings->title);
    if (*advice)
        fprintf(to, "%s\n", advice);
    fprintf(to, "%swall time %.3g s\n", text, took);
    /* What was written, of many frames for ParaView the file that names them; without memory as it was asked
     * for. */
    const char *asked = summary->frames > 0 ? options->outputs.vtk : NULL;
    char *vtk = !asked                ? NULL
                : summary->frames > 1 ? vtk_collection_name(asked)
                                      : vtk_frame_name(asked, 0, 1);
    const char *const names[] = {options->outputs.series, options->outputs.particles, options->outputs.nodes,
                                 options->outputs.bonds, vtk ? vtk : asked};
    int printed = 0;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (names[i] && strcmp(names[i], "-") != 0)
            fprintf(to, "%s%s", printed++ ? ", " : "wrote ", names[i]);
    if (printed)
        fputc('\n', to);
    free(vtk);
}

/* --stages FROM:TO, or the number of one step. */
static bool read_stages(Options *options, Status *status)
{
    const Outputs *outputs = &options->outputs;
    const char *text = options->stages, *colon = text ? strchr(text, ':') : NULL;
    char first[24] = "";
    long *stages = options->outputs.stages;
    if (!text)
        return true;
    text_append(first, sizeof first, "%.*s", colon ? (int)(colon - text) : 20, text);
    if (!text_to_long(first, &stages[0]) || !text_to_long(colon ? colon + 1 : first, &stages[1]) ||
        stages[0] < 1 || stages[1] < stages[0])
        return status_refuse(status, "--stages: FROM:TO, two numbers of steps from 1 on, not \"%.40s\"",
                             text);
    if (!outputs->particles && !outputs->nodes && !outputs->bonds)
        return status_refuse(status, "--stages: which table? (--particles, --nodes, --bonds)");
    if (outputs->vtk)
        return status_refuse(status, "--stages: writes tables, not --vtk");
    for (int i = 0; i < options->n_overrides; i++)
        if (strcmp(options->overrides[i].origin, "--frames") == 0 ||
            strcmp(options->overrides[i].origin, "--at") == 0)
            return status_refuse(status, "--stages: in place of %s", options->overrides[i].origin);
    return true;
}

int cli_run(Options *options, Status *status)
{
    Settings settings;
    const Outputs *outputs = &options->outputs;
    if (!options_load(options, options->words[0], &settings, status))
        return (int)status->code;
    /* Times that no table is written at are a slip. Those of a scenario file wait for a run with tables. */
    const bool has_tables = outputs->particles || outputs->nodes || outputs->bonds || outputs->vtk;
    for (int i = 0; i < options->n_overrides && !has_tables; i++) {
        const char *origin = options->overrides[i].origin;
        if (strcmp(origin, "--frames") == 0 || strcmp(origin, "--at") == 0)
            return progress_result(
                status_refuse(status,
                              "%s: there is no table to write at these times (--particles, --nodes, --bonds "
                              "or --vtk)",
                              origin),
                status);
    }
    if (!read_stages(options, status))
        return (int)status->code;
    if (options->json && writes_to_standard_output(outputs))
        return progress_result(status_refuse(status, "--json: standard output has a table (--series FILE)"),
                               status);
    Progress progress;
    progress_begin(&progress, options->quiet);
    settings.cancel = (Cancel){progress_show, &progress};
    RunSummary summary;
    bool done = export_run(&settings, outputs, progress_threads(options->threads), progress_show, &progress,
                           &summary, status);
    progress_end(&progress);
    if (progress_signal() != 0 && !done && !summary.failed)
        return progress_result(false, status);
    if ((done || summary.failed) && (options->json || !options->quiet))
        print_summary(options, &settings, &summary, progress_seconds(&progress));
    if (!done)
        options_blame(options, options->words[0], status);
    return done ? STATUS_DONE : (int)status->code; /* of a run that failed, though a signal came behind it */
}
