/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a fit is made of: a run as its model (the series at the times of the data, by the run's own steps,
 * changes in mid-run and rest), its data and parameters, and where it may begin. */
#include "base/assertion.h"
#include "answers/fit_internal.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"
#include "base/text.h"
#include "problems/problem.h"
#include "run/advance.h"
#include "scenario/parameters.h"
#include "answers/fit_search.h"
#include "scenario/concern_time.h"
#include "base/math/functions.h"
#include "theory/frequency.h"

#include <stdio.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* s at some times, on its way along a run. */
typedef struct Trace {
    int column;
    const double *times;
    double *values;
    size_t count, done;
    double time, value; /* the last row */
} Trace;

/* The next row: fills in what lies between the last one and it, linearly. */
static bool trace_row(void *owner, Run *run, long step, const double *row, Status *status)
{
    Trace *to = owner;
    const double time = (double)step * run->sim->dt, margin = 1e-9 * run->sim->dt; /* it may be rounded up */
    const double value = row[to->column];
    (void)status;
    for (; to->done < to->count && to->times[to->done] <= time + margin; to->done++) {
        const double passed = to->times[to->done] - to->time;
        const double share = time > to->time ? passed / (time - to->time) : 1;
        to->values[to->done] = share == 1 ? value : to->value + share * (value - to->value);
    }
    to->time = time;
    to->value = value;
    return true;
}

/* To the last of the times as any run goes: changes in mid-run come into force, rest ends it; what follows is
 * as it was then. */
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
    Trace to = {.times = times, .values = values, .count = count};
    const Sink sink = {.every = 1, .row = trace_row, .owner = &to};
    bool sound =
        run_open(&run, settings, problem_simulate(&asked, search->task->threads, &search->why), &search->why);
    if (sound && (to.column = simulation_find_series(run.sim, search->task->column)) < 0)
        sound =
            status_refuse(&search->why, "%s: the method's series has no such column", search->task->column);
    if (sound) {
        /* the data may end long before the run would, or after */
        run.last = problem_last_step(run.sim->dt, times[count - 1]) + 1;
        run.cancel = search->task->cancel;
        sound = run_start(&run, &sink, &search->why) && run_to_end(&run, &sink, &search->why);
        search->interrupted = !sound && !run.failed;
    }
    for (; sound && to.done < count; to.done++)
        values[to.done] = to.value;
    run_close(&run);
    return sound;
}

bool fit_run_at_data(Search *search, const Settings *settings)
{
    return fit_run(search, settings, search->task->times, search->model, search->task->count);
}

/* Of the run that is made. */
static double chi2_of(const Search *search)
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

/* Data and parameters of a fit. */

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

/* Where a fit may begin (fit_search.h).
 *
 * Of run and data that oscillate, with omega_s ~ p_i^e from two runs, at the p_i whose omega_s is
 * the data's, however far that is; at its aliases |2 pi j/Delta +- omega|, which data whose neighbours are
 * Delta apart cannot distinguish from it, up to FARTHEST times the frequency of the first run; and at those
 * that differ from each by one oscillation over the record, between which chi^2 has a minimum each. Then at
 * some shares and multiples of each p_i. */

enum { EVEN = 2048 }; /* points over the record, to find frequencies */

#define NUDGE      1.02 /* of a parameter, to see what it does to the frequency */
#define WEAKEST    0.2  /* power of a parameter with which the frequency goes, to be of use */
#define OSCILLATES 0.5  /* what may be left of a record beside one line, over its amplitude */
#define FARTHEST   3    /* ratio of frequencies between which aliases are looked at */

static const double multiples[MULTIPLES] = {0.6, 0.8, 1.25, 1.6};

/* The settings with one parameter at a multiple of what it begins at; false: out of its range. */
static bool place_one(const Search *search, int key, double factor, Settings *settings)
{
    *settings = *search->task->settings;
    return fit_put(settings, search->task->keys[key], factor * search->starts[key]);
}

static void begin_at(Beginning *list, int *count, int key, double factor, bool alias)
{
    if (*count < BEGINNINGS_MAX)
        list[(*count)++] = (Beginning){key, factor, INFINITY, alias};
}

/* The frequency of what oscillates over the record, at even times; 0: it does not. */
static double frequency_at(const Search *search, const double *values, size_t count)
{
    const FitTask *task = search->task;
    const double span = task->times[task->count - 1] - task->times[0];
    FrequencyFit fit;
    const bool found = span > 0 && frequency_fit(values, count, 0, span / (double)(count - 1), 0, &fit, NULL);
    return found && fit.residual < OSCILLATES ? fit.frequency : 0;
}

/* That of the data, taken linearly between them. */
static double frequency_of_data(const Search *search)
{
    const FitTask *task = search->task;
    const size_t count = task->count < EVEN ? task->count : EVEN;
    const double first = task->times[0], span = task->times[task->count - 1] - first;
    double even[EVEN];
    for (size_t k = 0, i = 0; k < count; k++) {
        const double time = first + span * (double)k / (double)(count - 1);
        for (; i + 2 < task->count && task->times[i + 1] < time; i++)
            ;
        const double apart = task->times[i + 1] - task->times[i];
        const double share = apart > 0 ? (time - task->times[i]) / apart : 0;
        even[k] = task->values[i] + share * (task->values[i + 1] - task->values[i]);
    }
    return frequency_at(search, even, count);
}

/* omega_s with one parameter at a multiple; 0: it does not oscillate, or no run can be made. */
static double frequency_of_run(Search *search, int key, double factor)
{
    const FitTask *task = search->task;
    const double first = task->times[0], span = task->times[task->count - 1] - first;
    double times[EVEN], even[EVEN];
    Settings settings;
    for (size_t k = 0; k < EVEN; k++)
        times[k] = first + span * (double)k / (EVEN - 1);
    const bool sound =
        place_one(search, key, factor, &settings) && fit_run(search, &settings, times, even, EVEN);
    return sound ? frequency_at(search, even, EVEN) : 0;
}

/* The values of one parameter at which the run oscillates as the data do, or as they cannot distinguish from
 * it. */
static void find_aliases(Search *search, int key, double own, double wanted, Beginning *list, int *count)
{
    const FitTask *task = search->task;
    const double nudged = frequency_of_run(search, key, NUDGE);
    const double power = nudged > 0 ? math_log(nudged / own) / math_log(NUDGE) : 0;
    if (fabs(power) < WEAKEST)
        return;
    const double span = task->times[task->count - 1] - task->times[0];
    const double fold = 2 * M_PI * (double)(task->count - 1) / span, oscillation = 2 * M_PI / span;
    const int before = *count;
    for (int j = 0; fold * j - wanted < FARTHEST * own && *count - before < ALIASES_MAX; j++)
        for (int side = j > 0 ? -1 : 1; side <= 1; side += 2)
            for (int beside = -1; beside <= 1; beside++) {
                const double omega = fold * j + side * wanted + beside * oscillation;
                if (omega > 0 && (j == 0 || (omega > own / FARTHEST && omega < own * FARTHEST)) &&
                    *count - before < ALIASES_MAX)
                    begin_at(list, count, key, math_pow(omega / own, 1 / power), beside == 0);
            }
}

static int by_chi2(const void *a, const void *b)
{
    const double one = ((const Beginning *)a)->chi2, other = ((const Beginning *)b)->chi2;
    return (one > other) - (one < other);
}

int fit_beginnings(Search *search, Beginning list[BEGINNINGS_MAX])
{
    const FitTask *task = search->task;
    int count = 0;
    if (!fit_run_at_data(search, task->settings))
        return 0;
    search->began = true;
    search->result->rms_before = sqrt(chi2_of(search) / (double)task->count);
    const double start = chi2_of(search), wanted = frequency_of_data(search);
    const double own = wanted > 0 ? frequency_of_run(search, 0, 1) : 0;
    begin_at(list, &count, 0, 1, false);
    for (int key = 0; key < task->n_keys && own > 0; key++)
        find_aliases(search, key, own, wanted, list, &count);
    for (int key = 0; key < task->n_keys; key++)
        for (int i = 0; i < MULTIPLES; i++)
            begin_at(list, &count, key, multiples[i], false);
    list[0].chi2 = start;
    for (int i = 1; i < count; i++) {
        Settings settings;
        if (place_one(search, list[i].key, list[i].factor, &settings) && fit_run_at_data(search, &settings))
            list[i].chi2 = chi2_of(search);
        if (search->interrupted)
            return 0;
    }
    qsort(list, (size_t)count, sizeof *list, by_chi2);
    return count;
}
