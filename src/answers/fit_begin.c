/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where a fit may begin (fit_search.h).
 *
 * Of run and data that oscillate, with omega_s ~ p_i^e from two runs, at the p_i whose omega_s is
 * the data's, however far that is; at its aliases |2 pi j/Delta +- omega|, which data whose neighbours are
 * Delta apart cannot tell from it, up to FARTHEST times the frequency of the first run; and at those that
 * differ from each by one oscillation over the record, between which chi^2 has a minimum each. Then at some
 * shares and multiples of each p_i. */
#include "answers/fit_internal.h"
#include "scenario/settings.h"
#include "base/math/functions.h"
#include "theory/frequency.h"

#include <math.h>
#include <stdlib.h>

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

/* The values of one parameter at which the run oscillates as the data do, or as they cannot tell from it. */
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
    search->result->rms_before = sqrt(fit_chi2(search) / (double)task->count);
    const double start = fit_chi2(search), wanted = frequency_of_data(search);
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
            list[i].chi2 = fit_chi2(search);
        if (search->interrupted)
            return 0;
    }
    qsort(list, (size_t)count, sizeof *list, by_chi2);
    return count;
}
