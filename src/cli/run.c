/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib run SCENARIO`: from the start to the end without a screen, tables written on the way. */
#include "cli/cli.h"
#include "cli/options.h"
#include "cli/progress.h"
#include "base/text.h"
#include "lab/export/crate.h"
#include "lab/export/export.h"
#include "lab/answers/summary.h"

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

static void print_files(FILE *to, const Outputs *outputs)
{
    const char *const names[] = {outputs->series, outputs->particles, outputs->nodes, outputs->bonds,
                                 outputs->vtk};
    int printed = 0;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (names[i] && strcmp(names[i], "-") != 0)
            fprintf(to, "%s%s", printed++ ? ", " : "wrote ", names[i]);
    if (printed)
        fputc('\n', to);
}

static void print_summary(const Options *options, const Settings *settings, const RunSummary *summary,
                          double took)
{
    FILE *to = writes_to_standard_output(&options->outputs) ? stderr : stdout;
    char text[SUMMARY_MAX];
    summary_text(summary, settings, text);
    if (*settings->title)
        fprintf(to, "%s\n", settings->title);
    fprintf(to, "%swall time %.3g s\n", text, took);
    print_files(to, &options->outputs);
}

/* Times that no table is written at are a slip. Those of a scenario file wait for a run with tables. */
static bool times_are_used(const Options *options, Status *status)
{
    const Outputs *outputs = &options->outputs;
    if (outputs->particles || outputs->nodes || outputs->bonds || outputs->vtk)
        return true;
    for (int i = 0; i < options->n_overrides; i++) {
        const char *origin = options->overrides[i].origin;
        if (strcmp(origin, "--frames") == 0 || strcmp(origin, "--at") == 0)
            return status_fail(status, STATUS_USAGE,
                               "%s: there is no table to write at these times (--particles, --nodes, --bonds "
                               "or --vtk)",
                               origin);
    }
    return true;
}

/* Today in UTC, YYYY-MM-DD; SOURCE_DATE_EPOCH names another day, for those who want the same bytes again. */
static void read_date(char date[16])
{
    const char *given = getenv("SOURCE_DATE_EPOCH");
    long seconds;
    const time_t day = given && text_to_long(given, &seconds) ? (time_t)seconds : time(NULL);
    struct tm fields;
    if (!gmtime_r(&day, &fields) || strftime(date, 16, "%Y-%m-%d", &fields) == 0)
        strcpy(date, "1970-01-01");
}

static bool describe(const Options *options, const Settings *settings, Status *status)
{
    char date[16];
    read_date(date);
    return crate_write(&options->outputs, settings, date, status);
}

int cli_run(int count, char **arguments, Status *status)
{
    Options options;
    Settings settings;
    if (!options_parse("run", count, arguments, &options, status) ||
        !options_words(&options, 1, 1, "SCENARIO", status) ||
        !options_load(&options, options.words[0], &settings, status) || !times_are_used(&options, status) ||
        (options.crate && !crate_may_begin(&options.outputs, options.force, status)))
        return (int)status->code;
    Progress progress;
    progress_begin(&progress, options.quiet);
    settings.patience = (Patience){progress_show, &progress};
    RunSummary summary;
    bool done = export_run(&settings, &options.outputs, progress_threads(options.threads), progress_show,
                           &progress, &summary, status);
    done = done && (!options.crate || describe(&options, &settings, status));
    progress_end(&progress);
    if (progress_signal() != 0 && !done && !summary.failed)
        return 128 + progress_signal();
    if ((done || summary.failed) && !options.quiet)
        print_summary(&options, &settings, &summary, progress_seconds(&progress));
    if (!done)
        options_blame(&options, options.words[0], status);
    return done ? STATUS_DONE : (int)status->code;
}
