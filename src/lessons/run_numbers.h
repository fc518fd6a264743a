/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers of a run that an exercise may speak of: words for what the readout, the energy and the crack
 * come to. One row a word; the manual for writers of lessons is made from them. */
#ifndef LAB_RUN_NUMBERS_H
#define LAB_RUN_NUMBERS_H

#include "answers/summary.h"

typedef struct RunNumber {
    const char *word;                                      /* "error" */
    const char *help;                                      /* with its unit */
    double (*value)(const RunSummary *, const char *word); /* NAN: not known of this run */
    bool beforehand;                                       /* known of a run that has not begun */
} RunNumber;

extern const RunNumber run_numbers[]; /* ended by a NULL word */

const RunNumber *run_number_find(const char *word); /* NULL: there is none */

/* Fills in what is known of a run that has not begun; the rest is not known. False: there is no such run. */
bool run_numbers_beforehand(const Settings *, RunSummary *, Status *);

#endif
