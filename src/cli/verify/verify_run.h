/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run as verification sees it: a scenario, its series with the references beside, and what it came to. */
#ifndef CLI_VERIFY_VERIFY_RUN_H
#define CLI_VERIFY_VERIFY_RUN_H

#include "scenario/settings.h"
#include "base/patience.h"
#include "problems/problem.h"
#include "answers/references.h"
#include "run/advance.h"

enum { VERIFY_STARTS = 21 };

typedef struct VerifyRun {
    const char *scenario; /* as the row names it; NULL: none was run */
    int threads;
    Settings settings;
    Run passing; /* at its end */
    References *refs;
    Column columns[COLUMNS_MAX];
    int n_columns;
    size_t count;   /* rows, that of step 0 included */
    double spacing; /* time between two rows */
    double *rows;
    Readout readout;
    Derived derived[DERIVED_MAX];
    int n_derived;
    bool starts_known;
    int n_starts;                 /* those of VERIFY_STARTS near this one that came to their end */
    double starts[VERIFY_STARTS]; /* what energy they have left, in order */
    Status failure;               /* why there is no run; code STATUS_DONE: there is */
} VerifyRun;

/* Runs a scenario: its name and KEY=VALUE ... behind, parted by spaces; rows every output.every steps. False:
 * the run's failure says why. The run is closed in any case by verify_run_close(). */
bool verify_run_open(VerifyRun *, const char *scenario, int threads, Patience);
void verify_run_close(VerifyRun *);

/* The settings alone. */
bool verify_settings(const char *scenario, Settings *, Status *);

/* A column's values from row 0 on, n_columns apart; NULL: the run has no such column. */
const double *verify_column(const VerifyRun *, const char *name);

/* The rows with from <= time <= to: from *first, as many as returned. */
size_t verify_rows_between(const VerifyRun *, double from, double to, size_t *first);

#endif
