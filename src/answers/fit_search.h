/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which parameters make a run agree best with a series that was measured: least squares over runs.
 *
 *     minimise  chi^2(p) = sum_k (y_k - s(t_k; p))^2
 *
 * s is a column of the series of a run with the parameters p, taken linearly between its time steps; y_k are
 * the data at the times t_k. The run is the scenario's own, with its changes in mid-run; behind a run that
 * has come to rest s stays what it was there. All data weigh alike. By the Levenberg-Marquardt method of GSL,
 * the derivatives by central differences of runs, parameters relative to where they begin.
 *
 * chi^2 of what oscillates has a minimum for each number of oscillations by which run and data may differ.
 * The search therefore looks first at other beginnings, begins where chi^2 is least, and again elsewhere as
 * long as what is left does not look like noise; and at each alias of the data's frequency. Minima whose
 * chi^2 is larger by no more than noise makes of one parameter are reported. That finds the best of some
 * minima, not surely the least of all. */
#ifndef ANSWERS_FIT_SEARCH_H
#define ANSWERS_FIT_SEARCH_H

#include "scenario/settings.h"
#include "base/cancel.h"
#include "problems/problem.h"
#include "theory/noise.h"
#include "run/overlay.h"

enum { FIT_KEYS_MAX = NOISE_PARAMETERS_MAX };

typedef struct FitTask {
    const Settings *settings;       /* where the search begins */
    const char *keys[FIT_KEYS_MAX]; /* the parameters that are sought: real numbers, not 0 to begin with */
    int n_keys;
    const char *column;           /* of the method's series: "v_cm" */
    const double *times, *values; /* the data, `count` of each; times ascend from 0 on */
    size_t count;
    int threads;
    Cancel cancel;
} FitTask;

/* What is left between run and data. */
typedef enum FitLeft {
    FIT_NOTHING, /* no more than a millionth of the data: there is no noise to judge by */
    FIT_WHITE,   /* noise, each datum's its own: the intervals hold */
    FIT_LASTING, /* noise that lasts from datum to datum: the intervals allow for it */
    FIT_NO_NOISE /* something that the run has not: the intervals do not hold */
} FitLeft;

enum { FIT_MINIMA_MAX = 12 };

typedef struct FitMinimum {
    double values[FIT_KEYS_MAX];
    double rms; /* of the residuals */
} FitMinimum;

typedef struct FitResult {
    double values[FIT_KEYS_MAX];
    FitMinimum others[FIT_MINIMA_MAX]; /* that these data cannot distinguish from it */
    int n_others;
    Noise noise;            /* what is left of the data, as noise; the intervals and how they hang together */
    FitLeft left;           /* what it looks like */
    double share;           /* rms of the residuals over that of the data about their mean */
    double rms_before, rms; /* of the residuals, at the start and at the end */
    int iterations;         /* of all searches */
    int beginnings, searches; /* looked at, and gone on from */
    long runs;
    double *model;     /* s(t_k) at the end, `count` numbers */
    Settings settings; /* with the values that were found */
} FitResult;

/* False: a parameter cannot be sought or changes nothing, there are fewer data than parameters or one, no run
 * could be made, no search settles, or it was given up; the status says which. fit_free() the result in any
 * case. */
bool fit_solve(const FitTask *, FitResult *, Status *);
void fit_free(FitResult *);

/* In words: what the residuals are, whether the intervals hold, and which other minima are as deep. Lines
 * ended by '\n'. */
void fit_tell(const FitTask *, const FitResult *, char *out, size_t size);

/* The first of it in a few words. */
const char *fit_verdict(const FitResult *);

/* What no interval of a fit covers. */
extern const char fit_not_covered[];

/* What is sought, by its key: a parameter, or a value of a row such as "loads.top.sy". False: out of range.
 */
double fit_value(const Settings *, const char *key);
bool fit_put(Settings *, const char *key, double value);

/* What a fit is made from: a measured table and a list of parameters, as people give them. */

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
