/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a fit is made from: a measured table and a list of parameters, as people give them. */
#ifndef ANSWERS_FIT_DATA_H
#define ANSWERS_FIT_DATA_H

#include "answers/fit_search.h"
#include "run/overlay.h"

/* The data of a table over time, `count` of each; freed by fit_data_free(). */
typedef struct FitData {
    double *times, *values;
    size_t count;
} FitData;

/* Takes column `y` of the table; values that are missing are left out. False: a time lies before the run, or
 * no memory. */
bool fit_data_take(FitData *, const Overlay *, int y, Status *);
void fit_data_free(FitData *);

/* "bar.density,bar.length" into the task; the list is cut to pieces and stays in use. */
bool fit_data_keys(char *list, FitTask *, Status *);

/* The settings of a run that goes as far as the data do. */
bool fit_data_end(const FitData *, Settings *, Status *);

#endif
