/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The numbers that a lesson's page quotes, and whether they stand on its screen of 80x24. */
#ifndef LESSON_NUMBERS_H
#define LESSON_NUMBERS_H

#include "lab/tui_case.h"

enum { SEEN_MAX = 4096 };

/* The numbers of the screens of a page so far, those of its text left out. */
typedef struct SeenNumbers {
    double values[SEEN_MAX];
    int count;
} SeenNumbers;

void lesson_numbers_see(Bench *, SeenNumbers *);

/* Each number of the page's text, question and right choice is among them, or has its reason in
 * tests/lab/lesson-numbers; no reason stands there for one that is seen. */
void lesson_numbers_check(Bench *, const char *lesson, const SeenNumbers *);

#endif
