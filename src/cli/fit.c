/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib fit SCENARIO --data FILE --vary KEY,...`: the parameters with which a run agrees best with a
 * measured series, how well they are known, and a picture of both. */
#include "cli/cli.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"
#include "cli/options.h"
#include "base/output.h"
#include "base/text.h"
#include "picture/paper/figure_file.h"
#include "answers/fit_search.h"
#include "run/overlay.h"
#include "scenario/parameters.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { HISTORY = 64 << 20 };

/* The data that are there, in order. */
typedef struct Data {
    Overlay table;
    FitData taken;
    const char *column; /* of the series */
} Data;

/* The column of the series: as asked for, or the first that the table has too. The name kept is not the
 * simulation's, which goes. */
static bool choose_column(Data *data, const Options *options, const Settings *settings, Status *status)
{
    Settings asked = *settings;
    strcpy(settings_edit_output(&asked)->columns, "all");
    Simulation *simulation = problem_simulate(&asked, 1, status);
    if (!simulation)
        return false;
    char known[160] = "";
    const char *first = NULL; /* column of the table that has a name of ours */
    for (int i = 0; i < simulation->n_series; i++) {
        const char *name = simulation->series[i].name;
        text_list_add(known, sizeof known, name);
        for (int c = 0; c < data->table.n_columns && !first; c++)
            if (strcmp(data->table.columns[c].name, name) == 0)
                first = data->table.columns[c].name;
        if (options->column && strcmp(options->column, name) == 0)
            data->column = options->column;
    }
    simulation_destroy(simulation);
    if (!options->column)
        data->column = first;
    else if (data->column && first && data->table.n_columns == 2 && strcmp(first, data->column) != 0)
        return status_refuse(status, "%s: its column is %.60s, not %.60s", data->table.file, first,
                             data->column);
    if (!data->column)
        return status_refuse(status, "--column: %.60s is not a column of the series (%s)",
                             options->column ? options->column : "(none of the table)", known);
    return true;
}

static void print_result(const FitTask *task, const FitResult *result)
{
    char told[1024];
    printf("%s, %zu data, %ld runs: %d beginnings, %d search%s, %d iterations\n", task->column, task->count,
           result->runs, result->beginnings, result->searches, result->searches == 1 ? "" : "es",
           result->iterations);
    printf("%-24s %14s %14s %14s\n", "", "fitted", "+- (95 %)", "began at");
    for (int i = 0; i < task->n_keys; i++)
        printf("%-24s %14.8g %14.3g %14.8g\n", task->keys[i], result->values[i], result->noise.half_widths[i],
               fit_value(task->settings, task->keys[i]));
    for (int i = 0; i < task->n_keys; i++)
        for (int j = 0; j < i; j++)
            printf("correlation of %s and %s: %.3f\n", task->keys[j], task->keys[i],
                   result->noise.correlations[i][j]);
    fit_tell(task, result, told, sizeof told);
    printf("%s%s\n", told, fit_not_covered);
}

static void print_json(const Options *options, const FitTask *task, const FitResult *result)
{
    Quantities list = quantities_open(stdout, "fit");
    char told[1024];
    fit_tell(task, result, told, sizeof told);
    quantities_text(&list, "scenario", options->words[0]);
    quantities_text(&list, "data", options->data);
    quantities_text(&list, "column", task->column);
    quantities_text(&list, "told", told);
    quantities_begin(&list, "quantities");
    for (int i = 0; i < task->n_keys; i++) {
        const Parameter *parameter = parameter_find(task->keys[i]);
        const char *unit = parameter ? parameter_in(parameter, task->settings->problem).unit : NULL;
        quantities_add(&list, task->keys[i], result->values[i], unit && *unit ? unit : NULL);
        quantities_number(&list, "half_width_95", result->noise.half_widths[i]);
        quantities_number(&list, "began_at", fit_value(task->settings, task->keys[i]));
    }
    for (int i = 0; i < task->n_keys; i++)
        for (int j = 0; j < i; j++) {
            quantities_add(&list, "correlation", result->noise.correlations[i][j], "1");
            quantities_text(&list, "of", task->keys[j]);
            quantities_text(&list, "and", task->keys[i]);
        }
    quantities_close(&list);
}

static bool write_table(const Options *options, const FitTask *task, const FitResult *result, Status *status)
{
    OutputFile file;
    if (!output_open(&file, ASKER_COMMAND_LINE, options->output, options->force, status))
        return false;
    fprintf(file.stream, "time,%s,fitted,residual\n", task->column);
    for (size_t k = 0; k < task->count; k++) {
        const double numbers[] = {task->times[k], task->values[k], result->model[k],
                                  task->values[k] - result->model[k]};
        for (int i = 0; i < 4; i++) {
            char text[NUMBER_TEXT_MAX];
            text_shortest(text, numbers[i]);
            fprintf(file.stream, "%s%c", text, i < 3 ? ',' : '\n');
        }
    }
    return output_end(&file, true, status);
}

/* The data over the curve of the run with the parameters that were found. */
static bool draw(const Options *options, Data *data, const FitResult *result, Progress *progress,
                 Status *status)
{
    Screen screen;
    Figure figure;
    const View *view = NULL;
    char name[64];
    screen_default(&screen);
    screen.scenario = options->words[0];
    screen.overlay = &data->table;
    Experiment *experiment =
        experiment_create(&result->settings, HISTORY, progress_threads(options->threads), status);
    if (!experiment)
        return false;
    screen.experiment = experiment;
    screen.time.window = data->taken.times[data->taken.count - 1];
    snprintf(name, sizeof name, "probe:%s", data->column);
    figure_open(&figure, options->size[0], options->size[1]);
    experiment_seek(experiment, experiment_last_step(experiment), 0);
    const bool sound =
        experiment_work_off(experiment, (Cancel){progress_show, progress}, status) &&
        (figure_view(&screen, name, &view, NULL) || figure_view(&screen, "probe", &view, status)) &&
        figure_add(&figure, &screen, view, 1, status) &&
        figure_write(&figure, ASKER_COMMAND_LINE, options->figure, options->force, status);
    figure_close(&figure);
    experiment_destroy(experiment);
    return sound;
}

/* The run goes as far as the data do. */
static bool solve(const Options *options, Settings *settings, Data *data, FitTask *task, FitResult *result,
                  Progress *progress, Status *status)
{
    if (!overlay_load(&data->table, options->data, progress_show, progress, status) ||
        !choose_column(data, options, settings, status) ||
        !overlay_choose(&data->table, NULL, NULL, data->column, "", status))
        return false;
    if (data->table.along || data->table.y < 0)
        data->table.y = overlay_column_for(&data->table, data->column, false);
    if (data->table.along || data->table.y < 0)
        return status_refuse(status, "%s: no column of times with one of %s beside it", data->table.file,
                             data->column);
    if (!fit_data_take(&data->taken, &data->table, data->table.y, status) ||
        !fit_data_end(&data->taken, settings, status))
        return false;
    task->column = data->column;
    task->times = data->taken.times;
    task->values = data->taken.values;
    task->count = data->taken.count;
    task->threads = progress_threads(options->threads);
    task->cancel = (Cancel){progress_show, progress};
    return fit_solve(task, result, status);
}

int cli_fit(Options *options, Status *status)
{
    Settings settings;
    OutputNames names = {.asker = ASKER_COMMAND_LINE, .force = options->force};
    if (!options_load(options, options->words[0], &settings, status) ||
        !output_names_differ(&names,
                             output_names_take(&names, options->output, status) &&
                                 (!options->figure || figure_allowed(options->figure, status)) &&
                                 output_names_take(&names, options->figure, status),
                             status))
        return (int)status->code;
    if (!options->data || !options->sought)
        return progress_result(
            status_refuse(status, "fit: %s is missing", options->data ? "--vary KEY,..." : "--data FILE"),
            status);
    char *keys = strdup(options->sought);
    FitTask task = {.settings = &settings};
    FitResult result = {0};
    Data data = {.table = {.y = -1}};
    Progress progress;
    progress_begin(&progress, options->quiet);
    bool sound = (keys || status_fail(status, "out of memory")) &&
                 (fit_data_keys(keys, &task, status) || (status_prefix(status, "--vary"), false)) &&
                 solve(options, &settings, &data, &task, &result, &progress, status);
    const bool found = sound; /* what took long is printed, whatever becomes of the files */
    sound = sound && (!options->output || write_table(options, &task, &result, status)) &&
            (!options->figure || draw(options, &data, &result, &progress, status));
    progress_end(&progress);
    if (found && options->json)
        print_json(options, &task, &result);
    else if (found)
        print_result(&task, &result);
    if (sound && options->output && !options->json)
        printf("wrote %s\n", options->output);
    if (sound && options->figure && !options->json)
        printf("wrote %s\n", options->figure);
    fit_free(&result);
    overlay_close(&data.table);
    fit_data_free(&data.taken);
    free(keys);
    return progress_result(sound, status);
}
