/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib sweep SCENARIO --vary KEY=A,B,C ...`: many runs that differ in some parameters, a row for each. The
 * threads of a pool take one combination after the other; every run has its row's place from the start, so
 * that neither the table nor the messages depend on how many run side by side. */
#include "base/hash.h"
#include "base/wait.h"
#include "scenario/settings.h"
#include "base/output.h"
#include "base/text.h"
#include "base/visible.h"
#include "cli/cli.h"
#include "cli/options.h"
#include "cli/sweep/sweep_plan.h"
#include "scenario/rows/rows.h"
#include "export/export.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

typedef struct Sweep {
    const Options *options;
    SweepPlan plan;
    const Problem *problem;
    uint64_t *numbers; /* of the combinations */
    double *keys;      /* plan.n_keys for each combination: the value, or the index of a choice */
    SweepResult *results;
    bool has[RESULT_COLUMNS]; /* columns that are written */
} Sweep;

/* --- the rows as a table: the varied keys, then the results ---------------------------------------- */

enum { TABLE_COLUMNS_MAX = AXES_MAX + RESULT_COLUMNS };

static int names_of(const Sweep *sweep, const char *names[TABLE_COLUMNS_MAX])
{
    int n = 0;
    for (int k = 0; k < sweep->plan.n_keys; k++)
        names[n++] = sweep->plan.keys[k].key;
    for (int column = 0; column < RESULT_COLUMNS; column++)
        if (sweep->has[column])
            names[n++] = sweep_columns[column].name;
    return n;
}

static void row_of(const Sweep *sweep, int combination, double row[TABLE_COLUMNS_MAX])
{
    int n = sweep->plan.n_keys;
    memcpy(row, sweep->keys + (size_t)combination * (size_t)n, (size_t)n * sizeof *row);
    for (int column = 0; column < RESULT_COLUMNS; column++)
        if (sweep->has[column])
            row[n++] = sweep->results[combination].cells[column];
}

static const char *word_of(const Parameter *parameter, const Problem *problem, double value)
{
    if (!parameter)
        return NULL;
    return parameter->choices                    ? parameter->choices[(int)value]
           : value == parameter->automatic_value ? parameter_in(parameter, problem).automatic
                                                 : NULL;
}

static void write_csv(const Sweep *sweep, FILE *stream)
{
    const Dialect dialect = sweep->options->outputs.dialect;
    const char *names[TABLE_COLUMNS_MAX];
    double row[TABLE_COLUMNS_MAX];
    int n = names_of(sweep, names);
    csv_header(stream, dialect, names, n);
    for (int i = 0; i < sweep->plan.n_combinations; i++)
        if (sweep->results[i].done) {
            int from = 0;
            row_of(sweep, i, row);
            for (int column = 0; column < sweep->plan.n_keys; column++) {
                /* The word of a value that is not a number, as contact.gap = off. */
                const Parameter *parameter = sweep->plan.keys[column].parameter;
                const char *word =
                    parameter && parameter->automatic_value < 0 && row[column] == parameter->automatic_value
                        ? word_of(parameter, sweep->problem, row[column])
                        : NULL;
                if (!word)
                    continue;
                csv_begin(stream, dialect, row + from, column - from, word);
                from = column + 1;
            }
            csv_row(stream, dialect, row + from, n - from);
        }
}

/* --- aligned -------------------------------------------------------------------------------------- */

static void cell_text(const Sweep *sweep, int column, double value, char out[VALUE_MAX])
{
    const SweepPlan *plan = &sweep->plan;
    const char *word =
        column < plan->n_keys ? word_of(plan->keys[column].parameter, sweep->problem, value) : NULL;
    if (word)
        snprintf(out, VALUE_MAX, "%s", word);
    else if (isnan(value))
        snprintf(out, VALUE_MAX, "-");
    else
        strcpy(out, text_rounded(value, 6).text);
}

/* Aligned for reading: six digits, choices as words. */
static void write_text(const Sweep *sweep, FILE *stream)
{
    const char *names[TABLE_COLUMNS_MAX];
    double row[TABLE_COLUMNS_MAX];
    char text[VALUE_MAX];
    int width[TABLE_COLUMNS_MAX] = {0}, n = names_of(sweep, names);
    for (int pass = 0; pass < 2; pass++) /* how wide columns are, then what they hold; -1: their names */
        for (int i = -1; i < sweep->plan.n_combinations; i++) {
            if (i >= 0 && !sweep->results[i].done)
                continue;
            if (i >= 0)
                row_of(sweep, i, row);
            for (int column = 0; column < n; column++) {
                snprintf(text, sizeof text, "%s", names[column]);
                if (i >= 0)
                    cell_text(sweep, column, row[column], text);
                if (pass == 1)
                    fprintf(stream, "%*s%s", width[column], text, column + 1 < n ? "  " : "\n");
                else if ((int)strlen(text) > width[column])
                    width[column] = (int)strlen(text);
            }
        }
}

/* --- what the columns mean ------------------------------------------------------------------------ */

static void describe_key(const Sweep *sweep, const SweepKey *key, FILE *stream)
{
    const Parameter *parameter = key->parameter;
    if (!parameter) {
        const RowColumn *column = row_key_column(key->key);
        fprintf(stream, "%s [%s]: %s of that row of the plate\n", key->key, column ? column->unit : "1",
                column ? column->word : "value");
        return;
    }
    const Parameter row = parameter_in(parameter, sweep->problem);
    fprintf(stream, "%s [%s]: %s", key->key, *row.unit ? row.unit : "1", row.help);
    if (parameter->type == PARAMETER_FLAG)
        fputs(" (0 = no, 1 = yes)", stream);
    else if (row.automatic)
        fprintf(stream, row.automatic_value < 0 ? " (or %s)" : " (0 = %s)", row.automatic);
    for (int i = 0; parameter->type == PARAMETER_CHOICE && parameter->choices[i]; i++)
        fprintf(stream, "%s%d = %s%s", i ? ", " : " (", i, parameter->choices[i],
                parameter->choices[i + 1] ? "" : ")");
    fputc('\n', stream);
}

/* --- before the first run ------------------------------------------------------------------------- */

static bool no_memory(Status *status)
{
    return status_fail(status, "not enough memory for the rows of the sweep");
}

/* A hash of the scenario of a combination: its file may change while others run. 0: there was no memory. */
static uint64_t number_of(const Settings *settings)
{
    char *text = NULL;
    size_t size = 0;
    FILE *stream = open_memstream(&text, &size);
    if (!stream)
        return 0;
    bool written = scenario_write(stream, settings, NULL, NULL);
    written = text_stream_close(stream, &text) && written;
    uint64_t number = written ? hash_bytes(HASH_BEGIN, text, size) | 1 : 0;
    free(text);
    return number;
}

/* Every combination is read and checked before the first one runs, so that bad input is found at once, not
 * after hours. */
static bool prepare(Sweep *sweep, Status *status)
{
    SweepPlan *plan = &sweep->plan;
    Settings settings;
    if (!sweep_plan_read(plan, sweep->options, status))
        return false;
    const int count = plan->n_combinations;
    sweep->numbers = calloc((size_t)count, sizeof *sweep->numbers);
    sweep->results = calloc((size_t)count, sizeof *sweep->results);
    sweep->keys = calloc((size_t)count * (size_t)plan->n_keys, sizeof *sweep->keys);
    if (!sweep->numbers || !sweep->results || !sweep->keys)
        return no_memory(status);
    for (int i = 0; i < count; i++) {
        if (!sweep_plan_load(plan, sweep->options, i, false, &settings, status))
            return false;
        for (int k = 0; k < plan->n_keys; k++) {
            const SweepKey *key = &plan->keys[k];
            const bool of_row = settings_row_is_key(&settings, key->key);
            const double value = of_row ? settings_row_number(&settings, key->key)
                                        : settings_number(&settings, key->parameter);
            if (of_row && isnan(value))
                return status_refuse(status,
                                     "%s: %s: is a whole row (one value of it can be varied, such as "
                                     "loads.NAME.sy)",
                                     key->origin, key->key);
            sweep->keys[(size_t)i * (size_t)plan->n_keys + (size_t)k] = value;
        }
        sweep->numbers[i] = number_of(&settings);
        if (sweep->numbers[i] == 0)
            return no_memory(status);
    }
    sweep->problem = settings.problem;
    return true;
}

/* --- the runs, on any thread ---------------------------------------------------------------------- */

static void run_one(void *owner, int combination, int threads, Cancel cancel)
{
    Sweep *sweep = owner;
    const Options *options = sweep->options;
    SweepResult *result = &sweep->results[combination];
    Settings settings;
    RunSummary summary;
    Status *why = &result->failure;
    if (!sweep_plan_load(&sweep->plan, options, combination, false, &settings, why))
        return;
    const uint64_t number = number_of(&settings);
    if (number != sweep->numbers[combination]) {
        number == 0 ? no_memory(why)
                    : status_fail(why, "%s has changed since the sweep began", options->words[0]);
        return;
    }
    if (options->steps > 0 && !sweep_plan_load(&sweep->plan, options, combination, true, &settings, why))
        return;
    settings.cancel = cancel;
    const double began = clock_seconds();
    if (export_run(&settings, &(Outputs){0}, threads, cancel.go_on, cancel.context, &summary, why))
        sweep_result_of(&summary, &settings, clock_seconds() - began, result);
}

static int run_all(Sweep *sweep, Status *status)
{
    const Options *options = sweep->options;
    if (!cli_each(sweep->plan.n_combinations, options->threads, options->quiet, run_one, sweep, status))
        return progress_result(false, status);
    for (int i = 0; i < sweep->plan.n_combinations; i++) {
        const SweepResult *result = &sweep->results[i];
        char values[512];
        if (!result->failure.text[0])
            continue;
        sweep_plan_describe(&sweep->plan, i, values, sizeof values);
        visible_print(stderr, "%s: %s: %s\n", result->done ? "no frequency" : "left out", values,
                      result->failure.text);
    }
    return STATUS_DONE;
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
static bool write_beside(const Sweep *sweep, OutputFile *file, Status *status)
{
    char *comment = NULL;
    size_t size = 0;
    Settings settings;
    bool quotes = true;
    FILE *text = open_memstream(&comment, &size);
    if (!text)
        return no_memory(status);
    fputs("matvib " PACKAGE_VERSION "\n\nmatvib sweep", text);
    for (int i = 0; i < sweep->options->n_arguments; i++) {
        const char *word = sweep->options->arguments[i];
        const size_t room = 4 * strlen(word) + 3; /* each of its characters may be quoted */
        char *quoted = calloc(room, 1);
        quotes = quotes && quoted;
        if (quoted)
            text_append_shell(quoted, room, word);
        fprintf(text, " %s", quoted ? quoted : "");
        free(quoted);
    }
    fputs("\n\nColumns:\n", text);
    /* A line for each column: name, unit, meaning; what the indices of choices stand for. */
    for (int k = 0; k < sweep->plan.n_keys; k++)
        describe_key(sweep, &sweep->plan.keys[k], text);
    for (int column = 0; column < RESULT_COLUMNS; column++)
        if (sweep->has[column])
            fprintf(text, "%s [%s]: %s\n", sweep_columns[column].name, sweep_columns[column].unit,
                    sweep_columns[column].meaning);
    fputs("\nThe first combination:\n", text);
    bool written = ((text_stream_close(text, &comment) && quotes) || no_memory(status)) &&
                   sweep_plan_load(&sweep->plan, sweep->options, 0, true, &settings, status) &&
                   scenario_write(file->stream, &settings, comment, status) && output_finish(file, status);
    free(comment);
    return written;
}

static bool write_files(const Sweep *sweep, Status *status)
{
    const Options *options = sweep->options;
    OutputFile file, beside = {0};
    if (!output_open(&file, ASKER_COMMAND_LINE, options->output, options->force, status))
        return false;
    write_csv(sweep, file.stream);
    bool good = output_finish(&file, status);
    if (good && file.target) {
        char *name = beside_name(options->output, status);
        good = name && output_open(&beside, ASKER_COMMAND_LINE, name, options->force, status) &&
               write_beside(sweep, &beside, status);
        free(name);
    }
    good = good && output_commit(&file, status) && output_commit(&beside, status);
    output_close(&file);
    output_close(&beside);
    return good;
}

static int write_all(Sweep *sweep, Status *status)
{
    const Options *options = sweep->options;
    const int all = sweep->plan.n_combinations;
    int rows = 0;
    for (int i = 0; i < all; i++) {
        rows += sweep->results[i].done;
        /* A column is written if a row has a number in it; a row that has none leaves its cell empty. */
        for (int column = 0; column < RESULT_COLUMNS && sweep->results[i].done; column++)
            sweep->has[column] |= isfinite(sweep->results[i].cells[column]);
    }
    if (rows == 0)
        return status_fail(status, "no combination has a row (%d left out)", all), STATUS_FAILED;
    if (options->output && !write_files(sweep, status))
        return (int)status->code;
    if (isatty(STDOUT_FILENO) && !(options->output && output_is_standard(options->output)))
        write_text(sweep, stdout);
    else if (!options->output)
        write_csv(sweep, stdout);
    if (rows == all)
        return STATUS_DONE;
    return status_fail(status, "%d of %d combinations have no row", all - rows, all), STATUS_FAILED;
}

/* --- the command ---------------------------------------------------------------------------------- */

static bool may_begin(const Sweep *sweep, Status *status)
{
    const Options *options = sweep->options;
    if (!options->output)
        return true;
    struct stat what;
    const bool is_regular =
        !output_is_standard(options->output) && (stat(options->output, &what) != 0 || S_ISREG(what.st_mode));
    char *beside = beside_name(options->output, status);
    const bool good = beside &&
                      output_may_begin(options->output, ASKER_COMMAND_LINE, options->force, status) &&
                      (!is_regular || output_may_begin(beside, ASKER_COMMAND_LINE, options->force, status));
    free(beside);
    return good;
}

int cli_sweep(Options *options, Status *status)
{
    Sweep sweep = {.options = options};
    const bool begins = prepare(&sweep, status) && may_begin(&sweep, status);
    int result = begins ? run_all(&sweep, status) : (int)status->code;
    if (result == STATUS_DONE)
        result = write_all(&sweep, status);
    sweep_plan_free(&sweep.plan);
    free(sweep.numbers);
    free(sweep.results);
    free(sweep.keys);
    return result;
}
