/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lesson beside the run, in place of the parameters. */
#ifndef LESSONS_LESSON_SHOWN_H
#define LESSONS_LESSON_SHOWN_H

#include "lessons/lesson.h"

enum { LESSONS_MAX = 32 };

typedef struct LessonShown {
    bool open;
    const Lesson *lesson; /* NULL: the list of lessons */
    int chosen;           /* in the list */
    int page;
    int answer;        /* the choice that was taken; -1: none as yet */
    int marked;        /* the choice that the arrows stand on, which Enter takes; -1: none */
    bool met;          /* what the page waits for has happened */
    char verdict[320]; /* on the last answer, or the last run; "": none */
    bool verdict_right;
    bool counts; /* answers are somebody's homework: of a choice the first one is marked */
    int scroll;
    int reached[LESSONS_MAX]; /* per lesson of the program: pages that were turned to */
} LessonShown;

#endif
