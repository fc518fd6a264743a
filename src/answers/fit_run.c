/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run as the model of a fit: the series at the times of the data, by the run's own steps, changes in
 * mid-run and rest. */
#include "base/assertion.h"
#include "answers/fit_internal.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"
#include "base/text.h"
#include "problems/problem.h"
#include "run/advance.h"
#include "scenario/parameters.h"
#include "answers/fit_data.h"
#include "scenario/concern_time.h"

#include <stdio.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* s at some times, on its way along a run. */
typedef struct Trace {
    const double *times;
    double *values;
    size_t count, done;
    double time, value; /* the last row */
} Trace;

/* The next row: fills in what lies between the last one and it, linearly. `margin`: the last time may be
 * rounded up. */
static void trace(Trace *to, double time, double margin, double value)
{
    for (; to->done < to->count && to->times[to->done] <= time + margin; to->done++) {
        const double passed = to->times[to->done] - to->time;
        const double share = time > to->time ? passed / (time - to->time) : 1;
        to->values[to->done] = share == 1 ? value : to->value + share * (value - to->value);
    }
    to->time = time;
    to->value = value;
}

typedef struct Follow {
    Trace to;
    int column;
} Follow;

static bool follow_row(void *owner, Run *run, long step, const double *row, Status *status)
{
    Follow *follow = owner;
    (void)status;
    trace(&follow->to, (double)step * run->sim->dt, 1e-9 * run->sim->dt, row[follow->column]);
    return true;
}

/* A run to the last of the times as any run goes: changes in mid-run come into force, rest ends it; what
 * follows is as it was then. False: it failed on the way, or was given up. */
static bool follow_to_end(Search *search, Run *run, Trace *to)
{
    Follow follow = {.to = *to, .column = simulation_find_series(run->sim, search->task->column)};
    const Sink sink = {.every = 1, .row = follow_row, .owner = &follow};
    if (follow.column < 0)
        return status_refuse(&search->why, "%s: the method's series has no such column",
                             search->task->column);
    /* the data may end long before the run would, or after */
    run->last = to->count > 0 ? problem_last_step(run->sim->dt, to->times[to->count - 1]) + 1 : 0;
    run->cancel = search->task->cancel;
    if (!run_start(run, &sink, &search->why) || !run_to_end(run, &sink, &search->why)) {
        search->interrupted = !run->failed;
        return false;
    }
    for (; follow.to.done < to->count; follow.to.done++)
        to->values[follow.to.done] = follow.to.value;
    return true;
}

bool fit_run(Search *search, const Settings *settings, const double *times, double *values, size_t count)
{
    ASSERT_INT(count, >=, 1);
    if (search->interrupted)
        return false;
    search->why = (Status){0};
    search->result->runs++;
    Settings asked = *settings;
    snprintf(settings_edit_output(&asked)->columns, sizeof settings_output(&asked)->columns, "%s",
             search->task->column);
    Run run = {.sim = NULL};
    const bool sound =
        run_open(&run, settings, problem_simulate(&asked, search->task->threads, &search->why),
                 &search->why) &&
        follow_to_end(search, &run, &(Trace){.times = times, .values = values, .count = count});
    run_close(&run);
    return sound;
}

bool fit_run_at_data(Search *search, const Settings *settings)
{
    return fit_run(search, settings, search->task->times, search->model, search->task->count);
}

double fit_chi2(const Search *search)
{
    double sum = 0;
    for (size_t k = 0; k < search->task->count; k++) {
        const double f = search->model[k] - search->task->values[k];
        sum += f * f;
    }
    return sum;
}

double fit_value(const Settings *settings, const char *key)
{
    const Parameter *parameter = parameter_find(key);
    return parameter ? settings_number(settings, parameter) : settings_row_number(settings, key);
}

bool fit_put(Settings *settings, const char *key, double value)
{
    const Parameter *parameter = parameter_find(key);
    char text[NUMBER_TEXT_MAX];
    if (!parameter) {
        snprintf(text, sizeof text, "%.17g", value);
        return settings_row_key_set(settings, key, text, NULL);
    }
    if (!settings_in_range(parameter, settings->problem, value))
        return false;
    settings_put(settings, parameter, value);
    return true;
}

/* Data and parameters of a fit (fit_data.h). */

bool fit_data_take(FitData *data, const Overlay *table, int y, Status *status)
{
    ASSERT_INDEX(table->x, table->n_columns);
    ASSERT_INDEX(y, table->n_columns);
    const double *times = table->columns[table->x].values, *values = table->columns[y].values;
    *data = (FitData){.times = malloc((table->count + 1) * sizeof(double)),
                      .values = malloc((table->count + 1) * sizeof(double))};
    if (!data->times || !data->values)
        return status_fail(status, "out of memory");
    for (size_t k = 0; k < table->count; k++)
        if (isfinite(times[k]) && isfinite(values[k])) {
            if (times[k] < 0)
                return status_refuse(status, "%s: a time below 0: %g (a run begins at 0)", table->file,
                                     times[k]);
            data->times[data->count] = times[k];
            data->values[data->count++] = values[k];
        }
    return true;
}

void fit_data_free(FitData *data)
{
    free(data->times);
    free(data->values);
    *data = (FitData){.times = NULL};
}

bool fit_data_keys(char *list, FitTask *task, Status *status)
{
    char *place;
    for (char *key = strtok_r(list, ", ", &place); key; key = strtok_r(NULL, ", ", &place)) {
        if (task->n_keys == FIT_KEYS_MAX)
            return status_refuse(status, "at most %d parameters", FIT_KEYS_MAX);
        task->keys[task->n_keys++] = key;
    }
    return task->n_keys > 0 || status_refuse(status, "no parameter is named (KEY,KEY)");
}

/* Data far beyond a run have a slip in their times, and many runs so long end in no lecture. */
enum { TIMES_LONGER = 1000 };

bool fit_data_end(const FitData *data, Settings *settings, Status *status)
{
    char end[NUMBER_TEXT_MAX];
    const double last = data->count > 0 ? data->times[data->count - 1] : 0;
    if (last > TIMES_LONGER * settings_time(settings)->end)
        return status_refuse(
            status, "the data end at t = %.6g, more than %d times the run's own end (time.end = %.6g)", last,
            TIMES_LONGER, settings_time(settings)->end);
    text_shortest(end, last);
    return !(last > 0) || settings_set(settings, "time.end", end, status);
}
