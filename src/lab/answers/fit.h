/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which parameters make a run agree best with a series that was measured: least squares over runs.
 *
 *     minimise  chi^2(p) = sum_k (y_k - s(t_k; p))^2
 *
 * s is a column of the series of a run with the parameters p, taken linearly between its time steps; y_k are
 * the data at the times t_k. All data weigh alike. By the Levenberg-Marquardt method of GSL, the derivatives
 * by central differences of runs, parameters relative to where they begin. */
#ifndef LAB_FIT_H
#define LAB_FIT_H

#include "base/patience.h"
#include "lab/problems/problem.h"

enum { FIT_KEYS_MAX = 8 };

typedef struct FitTask {
    const Settings *settings;       /* where the search begins */
    const char *keys[FIT_KEYS_MAX]; /* the parameters that are sought: real numbers, not 0 to begin with */
    int n_keys;
    const char *column;           /* of the method's series: "v_cm" */
    const double *times, *values; /* the data, `count` of each; times ascend from 0 on */
    size_t count;
    int threads;
    Patience patience;
} FitTask;

typedef struct FitResult {
    double values[FIT_KEYS_MAX];
    double half_widths[FIT_KEYS_MAX];               /* of the 95 % intervals, by Student's t */
    double correlation[FIT_KEYS_MAX][FIT_KEYS_MAX]; /* -1 to 1 */
    double rms_before, rms;                         /* of the residuals, at the start and at the end */
    int iterations;
    long runs;
    double *model;     /* s(t_k) at the end, `count` numbers */
    Settings settings; /* with the values that were found */
} FitResult;

/* False: a parameter cannot be sought, there are fewer data than parameters or one, no run could be made, the
 * search does not settle, or it was given up; the status says which. fit_free() the result in any case. */
bool fit_solve(const FitTask *, FitResult *, Status *);
void fit_free(FitResult *);

/* What is sought, by its key: a parameter, or a value of a row such as "loads.top.sy". False: out of range.
 */
double fit_value(const Settings *, const char *key);
bool fit_put(Settings *, const char *key, double value);

#endif
