/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers of a run that an exercise may speak of, and that a scenario may be about: words for what the
 * readout, the energy, the findings and the crack come to. One row a word; the manual for writers of lessons
 * and scenarios is made from them. */
#ifndef ANSWERS_RUN_NUMBERS_H
#define ANSWERS_RUN_NUMBERS_H

#include "answers/summary.h"

typedef struct RunNumber {
    const char *word;                                      /* "error" */
    const char *help;                                      /* with its unit */
    double (*value)(const RunSummary *, const char *word); /* NAN: not known of this run */
    bool beforehand;                                       /* known of a run that has not begun */
    SummaryPart part;                                      /* the part of the summary that it is read from */
    const char *called;                                    /* in words; NULL: as the word */
    /* In large digits, where it stands alone: */
    const char *label;    /* "periods behind"; NULL: it is none that a scenario is about */
    const char *opposite; /* of a negative one, shown without its sign: "periods ahead"; NULL: with it */
    const char *unit;     /* "mm"; "": none */
    double scale;         /* what there is of that unit in one of the value's own */
    bool of_moment;       /* seen in a picture of one moment, not in one over time */
    bool judged;          /* against the exact answer: hidden where that is */
} RunNumber;

extern const RunNumber run_numbers[]; /* ended by a NULL word */

const RunNumber *run_number_find(const char *word); /* NULL: there is none */

/* What a scenario is about: its screen.about, or else what its problem is judged by. */
const RunNumber *run_number_about(const Settings *);

/* Fills in what is known of a run that has not begun; the rest is not known. False: there is no such run. */
bool run_numbers_beforehand(const Settings *, RunSummary *, Status *);

#endif
