/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib sweep SCENARIO --vary KEY=A,B,C ...`: many runs that differ in some parameters, a row for each. */
#include "base/text.h"
#include "base/threads.h"
#include "base/visible.h"
#include "cli/cli.h"
#include "cli/describe.h"
#include "cli/options.h"
#include "cli/sweep/sweep_jobs.h"
#include "cli/sweep/sweep_partial.h"
#include "cli/sweep/sweep_plan.h"
#include "cli/sweep/sweep_table.h"
#include "base/output.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { JOBS_MAX = 1024 };

typedef struct Sweep {
    const Options *options;
    SweepPlan plan;
    uint64_t *numbers; /* of the combinations */
    double *keys;
    SweepResult *results;
    const Problem *problem;
    SweepPartial partial;
    int threads, jobs;
    int next, ready, to_do, left_out;
    bool written; /* the rows are where they were wanted */
    bool shows_progress;
    double began, shown;
} Sweep;

static double seconds(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* --- before the first run ------------------------------------------------------------------------- */

static bool no_memory(Status *status)
{
    return status_fail(status, STATUS_FAILED, "not enough memory for the rows of the sweep");
}

/* Every combination is read and checked before the first one runs, so that bad input is found at once, not
 * after hours. */
static bool check_combinations(Sweep *sweep, Status *status)
{
    const SweepPlan *plan = &sweep->plan;
    Settings settings;
    for (int i = 0; i < plan->n_combinations; i++) {
        if (!sweep_plan_load(plan, sweep->options, i, false, &settings, status))
            return false;
        for (int k = 0; k < plan->n_keys; k++) {
            const SweepKey *key = &plan->keys[k];
            const bool of_row = settings_row_is_key(&settings, key->key);
            const double value = of_row ? settings_row_number(&settings, key->key)
                                        : settings_number(&settings, key->parameter);
            if (of_row && isnan(value))
                return status_fail(status, STATUS_USAGE,
                                   "%s: %s: is a whole row (one value of it can be varied, such as "
                                   "loads.NAME.sy)",
                                   key->origin, key->key);
            sweep->keys[(size_t)i * (size_t)plan->n_keys + (size_t)k] = value;
        }
        sweep->numbers[i] = sweep_partial_number(&settings, sweep->options->steps);
        if (sweep->numbers[i] == 0)
            return no_memory(status);
    }
    sweep->problem = settings.problem;
    return true;
}

static bool prepare(Sweep *sweep, Status *status)
{
    const Options *options = sweep->options;
    if (options->jobs > JOBS_MAX)
        return status_fail(status, STATUS_USAGE, "--jobs: %ld are too many (1 to %d)", options->jobs,
                           JOBS_MAX);
    if (!sweep_plan_read(&sweep->plan, options, status))
        return false;
    int count = sweep->plan.n_combinations;
    sweep->numbers = calloc((size_t)count, sizeof *sweep->numbers);
    sweep->results = calloc((size_t)count, sizeof *sweep->results);
    sweep->keys = calloc((size_t)count * (size_t)sweep->plan.n_keys, sizeof *sweep->keys);
    if (!sweep->numbers || !sweep->results || !sweep->keys)
        return no_memory(status);
    const int cores = threads_default(false);
    sweep->jobs = options->jobs == 0 ? 1 : options->jobs < count ? (int)options->jobs : count;
    sweep->threads = options->threads > 0       ? (int)options->threads
                     : cores >= 2 * sweep->jobs ? cores / sweep->jobs
                                                : 1;
    return check_combinations(sweep, status);
}

static void give_back(Sweep *sweep)
{
    sweep_plan_free(&sweep->plan);
    free(sweep->numbers);
    free(sweep->results);
    free(sweep->keys);
}

/* --- one run, in a worker ------------------------------------------------------------------------- */

static void run_combination(void *context, int combination, RunProgress progress, void *progress_context,
                            SweepResult *result)
{
    const Sweep *sweep = context;
    Settings settings;
    RunSummary summary;
    Status *why = &result->failure;
    if (!sweep_plan_load(&sweep->plan, sweep->options, combination, false, &settings, why))
        return;
    const uint64_t number = sweep_partial_number(&settings, sweep->options->steps);
    if (number == 0) {
        no_memory(why);
        return;
    }
    if (number != sweep->numbers[combination]) {
        status_fail(why, STATUS_FAILED, "%s has changed since the sweep began", sweep->options->words[0]);
        return;
    }
    if (sweep->options->steps > 0 &&
        !sweep_plan_load(&sweep->plan, sweep->options, combination, true, &settings, why))
        return;
    settings.patience = (Patience){progress, progress_context};
    double began = seconds();
    if (export_run(&settings, &(Outputs){0}, sweep->threads, progress, progress_context, &summary, why))
        sweep_result_of(&summary, &settings, seconds() - began, result);
}

/* --- meanwhile, in the parent --------------------------------------------------------------------- */

static int next_combination(void *context)
{
    Sweep *sweep = context;
    while (sweep->next < sweep->plan.n_combinations && sweep->results[sweep->next].done)
        sweep->next++;
    return sweep->next < sweep->plan.n_combinations ? sweep->next++ : -1;
}

static void wipe_bar(const Sweep *sweep)
{
    if (sweep->shown > 0)
        visible_progress(stderr, "%s", "");
}

static void warn(const Sweep *sweep, const char *what, int combination, const char *why)
{
    char values[512];
    wipe_bar(sweep);
    sweep_plan_describe(&sweep->plan, combination, values, sizeof values);
    visible_print(stderr, "%s: %s: %s\n", what, values, why);
}

static bool take_result(void *context, int combination, const SweepResult *result, Status *status)
{
    Sweep *sweep = context;
    sweep->results[combination] = *result;
    sweep->ready++;
    if (result->done && result->failure.text[0])
        warn(sweep, "no frequency", combination, result->failure.text);
    if (result->done)
        return sweep_partial_add(&sweep->partial, sweep->numbers[combination], result, status);
    warn(sweep, "left out", combination, result->failure.text);
    sweep->left_out++;
    return true;
}

static void show_progress(void *context, double begun)
{
    enum { WIDTH = 30 };
    Sweep *sweep = context;
    double now = sweep->shows_progress ? seconds() : 0;
    if (!sweep->shows_progress || now - sweep->began < 0.5 || now - sweep->shown < 0.1)
        return;
    sweep->shown = now;
    char bar[WIDTH + 1];
    double share = (sweep->ready + begun) / sweep->to_do;
    double left = share > 0 ? (now - sweep->began) * (1 - share) / share : 0;
    for (int i = 0; i < WIDTH; i++)
        bar[i] = i < (int)(share * WIDTH) ? '#' : '.';
    bar[WIDTH] = '\0';
    visible_progress(stderr, "[%s] %3.0f %%  %d of %d runs  %.0f s left ", bar, floor(100 * share),
                     sweep->ready, sweep->to_do, ceil(left));
}

static int run_all(Sweep *sweep, Status *status)
{
    int count = sweep->plan.n_combinations, there = 0;
    for (int i = 0; i < count; i++)
        there += sweep->results[i].done;
    sweep->to_do = count - there;
    if (there > 0)
        visible_print(stderr, "%d of %d rows are in %s already\n", there, count, sweep->partial.name);
    sweep->shows_progress = !sweep->options->quiet && isatty(STDERR_FILENO);
    sweep->began = seconds();
    SweepWork work = {.jobs = sweep->jobs,
                      .context = sweep,
                      .next = next_combination,
                      .run = run_combination,
                      .finished = take_result,
                      .progress = show_progress};
    int result = sweep_jobs(&work, status);
    wipe_bar(sweep);
    if (result > 128 && sweep->partial.stream)
        status_fail(status, STATUS_FAILED, "interrupted; %ld of %d rows are in %s, the same command goes on",
                    sweep->partial.rows, count, sweep->partial.name);
    else if (result > 128)
        status_fail(status, STATUS_FAILED, "interrupted");
    return result;
}

/* --- the table ------------------------------------------------------------------------------------ */

static char *beside_name(const char *output, Status *status)
{
    char *name;
    if (asprintf(&name, "%s.ini", output) >= 0)
        return name;
    no_memory(status);
    return NULL;
}

/* The scenario of the first combination; as comments the command and the columns. */
static bool write_beside(const Sweep *sweep, const SweepTable *table, int count, char **arguments,
                         OutputFile *file, Status *status)
{
    char *comment = NULL;
    size_t size = 0;
    Settings settings;
    FILE *text = open_memstream(&comment, &size);
    if (!text)
        return no_memory(status);
    fputs("matvib " PACKAGE_VERSION "\n\nmatvib sweep", text);
    for (int i = 0; i < count; i++) {
        fputc(' ', text);
        sweep_shell_quote(text, arguments[i]);
    }
    fputs("\n\nColumns:\n", text);
    sweep_table_describe(table, text);
    fputs("\nThe first combination:\n", text);
    bool written = (text_stream_close(text, &comment) || no_memory(status)) &&
                   sweep_plan_load(&sweep->plan, sweep->options, 0, true, &settings, status) &&
                   scenario_write(file->stream, &settings, comment, status) && output_finish(file, status);
    free(comment);
    return written;
}

static bool write_files(const Sweep *sweep, const SweepTable *table, int count, char **arguments,
                        Status *status)
{
    const Options *options = sweep->options;
    OutputFile file, beside = {0};
    if (!output_open(&file, ASKER_COMMAND_LINE, options->output, options->force, status))
        return false;
    sweep_table_write_csv(table, options->outputs.dialect, file.stream);
    bool good = output_finish(&file, status);
    if (good && file.target) {
        char *name = beside_name(options->output, status);
        good = name && output_open(&beside, ASKER_COMMAND_LINE, name, options->force, status) &&
               write_beside(sweep, table, count, arguments, &beside, status);
        free(name);
    }
    good = good && output_commit(&file, status) && output_commit(&beside, status);
    output_close(&file);
    output_close(&beside);
    return good;
}

static Crate crate_of(const Options *options)
{
    return (Crate){
        .tables = {{options->output, "Table of a sweep: a row for each combination of parameters"}},
        .command = "matvib sweep",
        .source = "Scenario of the first combination; its comments hold the command and the columns",
        .asker = ASKER_COMMAND_LINE,
        .force = options->force,
    };
}

static bool describe_table(const Sweep *sweep, Status *status)
{
    const Crate crate = crate_of(sweep->options);
    Settings settings;
    return !sweep->options->crate ||
           (sweep_plan_load(&sweep->plan, sweep->options, 0, true, &settings, status) &&
            describe(sweep->options, &crate, &settings, status));
}

static int write_all(Sweep *sweep, int count, char **arguments, Status *status)
{
    const Options *options = sweep->options;
    SweepTable table = {
        .plan = &sweep->plan, .problem = sweep->problem, .keys = sweep->keys, .results = sweep->results};
    sweep_table_choose_columns(&table);
    int all = sweep->plan.n_combinations;
    if (table.rows == 0)
        return status_fail(status, STATUS_FAILED, "no combination has a row (%d left out)", all),
               STATUS_FAILED;
    if (options->output &&
        !(write_files(sweep, &table, count, arguments, status) && describe_table(sweep, status)))
        return (int)status->code;
    bool terminal = isatty(STDOUT_FILENO);
    if (terminal && !(options->output && output_is_standard(options->output)))
        sweep_table_write_text(&table, stdout);
    else if (!options->output)
        sweep_table_write_csv(&table, options->outputs.dialect, stdout);
    sweep->written = true;
    if (sweep->left_out == 0)
        return STATUS_DONE;
    return status_fail(status, STATUS_FAILED, "%d of %d combinations have no row", sweep->left_out, all),
           STATUS_FAILED;
}

/* --- the command ---------------------------------------------------------------------------------- */

static bool is_regular(const char *name)
{
    struct stat what;
    return !output_is_standard(name) && (stat(name, &what) != 0 || S_ISREG(what.st_mode));
}

static bool open_partial(Sweep *sweep, Status *status)
{
    const Options *options = sweep->options;
    if (!options->output)
        return true;
    char *beside = beside_name(options->output, status);
    bool good = beside && output_may_begin(options->output, options->force, status) &&
                (!is_regular(options->output) || output_may_begin(beside, options->force, status));
    free(beside);
    return good && (!is_regular(options->output) ||
                    sweep_partial_open(&sweep->partial, options->output, sweep->numbers,
                                       sweep->plan.n_combinations, options->force, sweep->results, status));
}

static int print_plan(const Sweep *sweep, Status *status)
{
    OutputFile file;
    const Options *options = sweep->options;
    if (!output_open(&file, ASKER_COMMAND_LINE, options->output ? options->output : "-", options->force,
                     status))
        return (int)status->code;
    sweep_plan_print(&sweep->plan, options, file.stream);
    bool good = output_finish(&file, status) && output_commit(&file, status);
    output_close(&file);
    return good ? STATUS_DONE : (int)status->code;
}

static int sweep_through(Sweep *sweep, int count, char **arguments, Status *status)
{
    const Crate crate = crate_of(sweep->options);
    if (!prepare(sweep, status))
        return (int)status->code;
    if (sweep->options->plan)
        return print_plan(sweep, status);
    if (!describe_may_begin(sweep->options, &crate, status) || !open_partial(sweep, status))
        return (int)status->code;
    int result = run_all(sweep, status);
    if (result == STATUS_DONE)
        result = write_all(sweep, count, arguments, status);
    sweep_partial_close(&sweep->partial, sweep->written);
    return result;
}

int cli_sweep(int count, char **arguments, Status *status)
{
    Options options;
    if (!options_parse("sweep", count, arguments, &options, status) ||
        !options_words(&options, 1, 1, "SCENARIO", status))
        return (int)status->code;
    Sweep sweep = {.options = &options};
    int result = sweep_through(&sweep, count, arguments, status);
    give_back(&sweep);
    return result;
}
