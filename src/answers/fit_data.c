/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Data and parameters of a fit (fit_data.h). */
#include "answers/fit_data.h"

#include "base/assertion.h"
#include "base/text.h"
#include "scenario/concern_time.h"
#include "scenario/parameters.h"
#include "scenario/settings.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

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
