/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run as the model of a fit: the series at the times of the data, by the run's own steps, changes in
 * mid-run and rest. */
#include "answers/fit_internal.h"

#include "base/text.h"
#include "scenario/changes.h"
#include "scenario/parameters.h"

#include <stdio.h>
#include <stdlib.h>

enum { BLOCK = 256 };

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
        to->values[to->done] = to->value + share * (value - to->value);
    }
    to->time = time;
    to->value = value;
}

/* A run to the last of the times as any run goes: changes in mid-run come into force, rest ends it; what
 * follows is as it was then. False: it failed on the way, or was given up. */
static bool follow(Search *search, const Settings *settings, Simulation *simulation, int column, double *rows,
                   Trace *to)
{
    const double margin = 1e-9 * simulation->dt;
    simulation_row(simulation, rows);
    to->value = rows[column];
    trace(to, 0, 0, to->value);
    if (!changes_apply(settings, simulation, &search->why))
        return false;
    while (to->done < to->count && !simulation->at_rest) {
        const long next = changes_next(settings, simulation->step);
        long count = simulation_steps_a_question(simulation), got = 0;
        count = count < BLOCK ? count : BLOCK;
        count = next - simulation->step < count ? next - simulation->step : count;
        if (!simulation_steps(simulation, count, rows, &got, &search->why))
            return false;
        for (long k = 0; k < got; k++)
            trace(to, (double)(simulation->step - got + k + 1) * simulation->dt, margin,
                  rows[k * simulation->n_series + column]);
        if (!changes_apply(settings, simulation, &search->why))
            return false;
        if (!patience_lasts(&search->task->patience, 0)) {
            search->interrupted = true;
            return status_fail(&search->why, STATUS_FAILED, "interrupted");
        }
    }
    for (; to->done < to->count; to->done++)
        to->values[to->done] = to->value;
    return true;
}

bool fit_run(Search *search, const Settings *settings, const double *times, double *values, size_t count)
{
    if (search->interrupted)
        return false;
    search->why = (Status){0};
    search->result->runs++;
    if (!settings_check(settings, &search->why))
        return false;
    Settings asked = *settings;
    snprintf(asked.output.columns, sizeof asked.output.columns, "%s", search->task->column);
    Simulation *simulation = problem_simulate(&asked, search->task->threads, &search->why);
    if (!simulation)
        return false;
    const int column = simulation_find_series(simulation, search->task->column);
    double *rows = column >= 0 ? malloc(BLOCK * (size_t)simulation->n_series * sizeof *rows) : NULL;
    Trace to = {.times = times, .values = values, .count = count};
    bool sound = rows != NULL;
    if (column < 0)
        status_fail(&search->why, STATUS_USAGE, "%s: the method's series has no such column",
                    search->task->column);
    else if (!rows)
        status_fail(&search->why, STATUS_FAILED, "out of memory");
    sound = sound && follow(search, settings, simulation, column, rows, &to);
    free(rows);
    simulation_destroy(simulation);
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
