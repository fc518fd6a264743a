/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What commands that run for a while share: a bar on standard error, and an end by signal that takes back
 * temporary files. */
#ifndef CLI_PROGRESS_H
#define CLI_PROGRESS_H

#include "base/status.h"

#include <stdbool.h>

typedef struct Progress {
    bool visible; /* standard error is a terminal */
    double began, shown;
} Progress;

/* Also notes the signals that ask for an end from here on (signals_catch). */
void progress_begin(Progress *, bool quiet);
void progress_end(const Progress *); /* wipes the bar */
double progress_seconds(const Progress *);

/* A RunProgress: draws the bar; false once a signal came. */
bool progress_show(double share, void *progress);

/* The signal that came; 0: none. */
int progress_signal(void);

/* The exit status of a command: 0, 128 + n after signal n, or the status's code. */
int progress_result(bool done, const Status *);

/* The number given with --threads, else as many as this process may use. */
int progress_threads(long wanted);

#endif
