/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files behind fit_search.h share: a search under way. */
#ifndef ANSWERS_FIT_INTERNAL_H
#define ANSWERS_FIT_INTERNAL_H

#include "answers/fit_search.h"

typedef struct Search {
    const FitTask *task;
    FitResult *result;
    double starts[FIT_KEYS_MAX];
    double *model; /* of the run that is made, at the data */
    bool began;    /* a run has been made: what fails from here on is a step too far */
    bool interrupted;
    bool fixed[FIT_KEYS_MAX]; /* no run can be made beside where the parameter is */
    Status why_fixed;         /* of the last of those */
    Status why;               /* the last run could not be made */
} Search;

/* s(t; p) at `count` times. False: the settings are unsound, the run failed or was given up. */
bool fit_run(Search *, const Settings *, const double *times, double *values, size_t count);
bool fit_run_at_data(Search *, const Settings *); /* into search->model */

/* A value of one parameter at which the search may begin. */
typedef struct Beginning {
    int key;
    double factor, chi2; /* of what it is in the settings */
    bool alias;          /* the run oscillates there as the data do, or as they cannot distinguish from it */
} Beginning;

enum {
    ALIASES_MAX = 27, /* of one parameter, and those beside them */
    MULTIPLES = 4,    /* and other values of it */
    BEGINNINGS_MAX = FIT_KEYS_MAX * (ALIASES_MAX + MULTIPLES) + 1
};

/* Fills in what there is, the least chi^2 first, and returns how many; what no run can be made of has an
 * infinite one. 0: no run can be made of the settings, or it was given up. Notes rms_before. */
int fit_beginnings(Search *, Beginning list[BEGINNINGS_MAX]);

#endif
