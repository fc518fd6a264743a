/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Combinations shared out to worker processes, each combination to a process of its own: a run that crashes
 * or is killed takes no other with it, and every run starts from the same clean state, so that its numbers do
 * not depend on how many run beside it. */
#ifndef CLI_SWEEP_JOBS_H
#define CLI_SWEEP_JOBS_H

#include "cli/sweep/sweep_result.h"

typedef struct SweepWork {
    int jobs; /* processes at the same time */
    void *context;

    /* In the order in which they are begun; -1: there are no more. */
    int (*next)(void *context);

    /* In the worker: runs a combination and fills the result. `progress` and its context are for
     * export_run().
     */
    void (*run)(void *context, int combination, RunProgress progress, void *progress_context, SweepResult *);

    /* In the parent, in the order in which they come to their ends. False: the sweep stops, the status says
     * why. */
    bool (*finished)(void *context, int combination, const SweepResult *, Status *);

    /* In the parent, a few times a second: `begun` is the sum of the shares of those that run. */
    void (*progress)(void *context, double begun);
} SweepWork;

/* Returns the exit status: 0; that of the status; or 128 + n after signal n, with all workers gone. */
int sweep_jobs(const SweepWork *, Status *);

#endif
