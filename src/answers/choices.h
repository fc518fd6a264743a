/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the papers are silent or do otherwise, and what is done here: the list behind a page of the help and
 * a section of the manual. Paper M is the bar's, paper P that of the beams. */
#ifndef ANSWERS_CHOICES_H
#define ANSWERS_CHOICES_H

#include "problems/problem.h"

typedef struct Choice {
    int concerns;      /* of the problems that it is about (problem.h): all of them */
    MethodKind method; /* that it is about */
    const char *what;  /* a heading: "horizon and spacing" */
    const char *paper; /* what the paper says */
    const char *here;  /* what is done here, and why where it matters */
} Choice;

extern const Choice choices[];
extern const int n_choices;

/* Whether a choice is about this problem by this method. */
bool choice_is_about(const Choice *, const Problem *, MethodKind);

#endif
