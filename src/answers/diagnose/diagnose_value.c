/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The one wrong value that would explain a file (diagnose_internal.h): a search by Gauss and Newton on the
 * entries up to where the file departs, which goes on from there to the next departure. Near the first one
 * the run depends smoothly on any parameter; the farther it agrees, the sharper the value is known. */
#include "answers/diagnose/diagnose_internal.h"
#include "scenario/settings.h"

#include "base/text.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

typedef struct Seek {
    const DiagnoseTask *task;
    const DiagnoseTable *table;
    const Parameter *parameter;
    const TimeSettings *own_step; /* of Candidate */
    double scale;                 /* of a step of the parameter */
    double *values[2];            /* ours, with the value and beside it */
    long *tried;
} Seek;

/* A run with a value. False: there is none. */
static bool walk_with(Seek *seek, double value, Walk *walk)
{
    Settings settings;
    const Candidate candidate = {DIAGNOSE_VALUE, seek->parameter, value, 0, seek->own_step};
    const double now = settings_number(seek->task->settings, seek->parameter);
    const bool size = seek->parameter->nudge != NUDGE_1_2_5 && !diagnose_is_share(seek->parameter);
    if (size && now != 0 && !(value / now > 0.5 && value / now < 2)) /* the work grows with it */
        return false;
    ++*seek->tried;
    return diagnose_settings_of(&candidate, seek->task->settings, seek->table, &settings) &&
           diagnose_walk(walk, seek->task, &settings, NULL);
}

/* The change of the value that least squares of the entries asks for; NAN: they do not depend on it. Each
 * entry counts by its accuracy. */
static double newton(const Seek *seek, size_t moments, double change)
{
    const DiagnoseTable *table = seek->table;
    double size[DIAGNOSE_COLUMNS_MAX] = {0}, product = 0, square = 0;
    for (size_t m = 0; m < moments; m++)
        for (size_t k = 0; k < table->moments[m].count; k++)
            for (int c = 0; c < table->as.n_columns; c++) {
                const DiagnoseColumn *column = &table->as.columns[c];
                const size_t row = table->moments[m].first + k,
                             at = row * (size_t)table->as.n_columns + (size_t)c;
                const double theirs = diagnose_theirs(table, column, row);
                if (column->silent || !isfinite(theirs) || isnan(seek->values[0][at]) ||
                    isnan(seek->values[1][at]))
                    continue;
                double *most = &size[column->group];
                *most = fmax(*most, fmax(column->natural, fabs(theirs)));
                const double bound = diagnose_rounding(table, column, theirs) +
                                     diagnose_noise(table, *most, table->moments[m].step);
                if (!(bound > 0))
                    continue;
                const double slope = (seek->values[1][at] - seek->values[0][at]) / bound;
                const double left = (theirs - seek->values[0][at]) / bound;
                product += slope * left;
                square += slope * slope;
            }
    return square > 0 && isfinite(square) ? product / square * change : NAN;
}

/* The shortest number near a value with which the run agrees all the same. */
static double rounded(Seek *seek, double value)
{
    for (int digits = 1; digits <= 8; digits++) {
        double shorter;
        if (!text_to_double(text_rounded(value, digits).text, &shorter) ||
            fabs(shorter - value) > 1e-2 * fabs(value) ||
            (digits > 3 && fabs(shorter - value) > 1e-6 * fabs(value)))
            continue;
        Walk walk = {.table = seek->table};
        if (walk_with(seek, shorter, &walk) && !walk.departure.is && walk.compared > 0)
            return shorter;
    }
    return value;
}

/* One step of the search over so many moments. False: it leads nowhere. */
static bool improve(Seek *seek, size_t moments, double *value)
{
    double change = 1e-6 * fmax(fabs(*value), seek->scale);
    if (!settings_in_range(seek->parameter, seek->task->settings->problem, *value + change))
        change = -change;
    for (int side = 0; side < 2; side++) {
        Walk walk = {.table = seek->table, .moments = moments, .to_end = true, .values = seek->values[side]};
        if (!walk_with(seek, *value + side * change, &walk) || walk.failed || walk.compared < moments)
            return false;
    }
    const double by = newton(seek, moments, change);
    *value += by;
    return isfinite(by);
}

/* What the file's first departure is in proportion to, or to the square of. False: neither agrees. */
static bool guess_value(Seek *seek, const Departure *departure, double *value)
{
    const double ratio = departure->theirs / departure->ours, now = *value;
    const double guesses[] = {now * ratio, now * sqrt(ratio)};
    for (size_t i = 0; i < sizeof guesses / sizeof *guesses; i++) {
        Walk walk = {.table = seek->table};
        if (isfinite(guesses[i]) && guesses[i] != now && walk_with(seek, guesses[i], &walk) &&
            !walk.departure.is && walk.compared > 0 && !walk.failed) {
            *value = guesses[i];
            return true;
        }
    }
    return false;
}

static bool seek_value(Seek *seek, size_t moments, double *value)
{
    enum { TURNS = 40 };
    int stays = 0;
    for (int turn = 0; turn < TURNS && stays < 6; turn++) {
        Walk walk = {.table = seek->table};
        if (!improve(seek, moments, value) || !walk_with(seek, *value, &walk))
            return false;
        if (!walk.departure.is)
            return walk.compared > 0 && !walk.failed;
        const size_t reached = walk.departure.moment + 1;
        stays = reached > moments ? 0 : stays + 1;
        moments = reached > moments ? reached : moments;
    }
    return false;
}

bool diagnose_find_value(const DiagnoseTask *task, const DiagnoseTable *table, const Departure *departure,
                         const Parameter *parameter, const TimeSettings *own_step, double *value, long *tried)
{
    const size_t entries = table->file.count * (size_t)table->as.n_columns;
    Settings moved = *task->settings;
    const double now = settings_number(task->settings, parameter);
    Seek seek = {.task = task, .table = table, .parameter = parameter, .own_step = own_step, .tried = tried};
    if (!settings_nudge(&moved, parameter, 1, true, NULL) &&
        !settings_nudge(&moved, parameter, -1, true, NULL))
        return false;
    seek.scale = fabs(settings_number(&moved, parameter) - now);
    seek.values[0] = malloc(entries * sizeof(double));
    seek.values[1] = malloc(entries * sizeof(double));
    *value = now;
    const bool found =
        seek.values[0] && seek.values[1] &&
        (guess_value(&seek, departure, value) || seek_value(&seek, departure->moment + 1, value));
    if (found)
        *value = rounded(&seek, *value);
    free(seek.values[0]);
    free(seek.values[1]);
    return found;
}
