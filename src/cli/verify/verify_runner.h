/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The one runner of checks, and its counts: what reproduces our reference, what is bounded as it should be,
 * and what agrees with the paper. */
#ifndef CLI_VERIFY_VERIFY_RUNNER_H
#define CLI_VERIFY_VERIFY_RUNNER_H

#include "cli/progress.h"
#include "cli/quantities.h"
#include "cli/verify/verify_row.h"

#include <stdio.h>

/* One verification: where it is printed, and the counts so far. */
typedef struct Verify {
    FILE *out;
    Quantities *json; /* NULL: it is printed as text */
    int threads;
    Progress *progress; /* NULL: not shown, and nothing stops it */
    long to_do;         /* rows, for the progress */
    VerifyRun run;      /* the last one, which following rows may use again */
    long rows;
    long references[VERDICT_GOOD + 1], bounds[VERDICT_GOOD + 1];
    long papers[AGREEMENTS];
} Verify;

/* Runs the rows of a check, with --full all of them, and prints each. A run that cannot be made is a miss of
 * its rows. After a signal nothing more is run or printed. */
void verify_check_run(Verify *, const VerifyCheck *, bool full);

/* The last lines, with all counts, and the exit status: 1, with a status that says so, if anything was
 * missed; what differs from the paper is only printed. 0 where nothing can be written any more: closing
 * the stream reports that. 128 + n after signal n. */
int verify_end(Verify *, Status *);

#endif
