/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is right beside the run: calculated on the spot, of the page's run for a number and of the reader's
 * own for a goal, so that a session that is done again gets its marks again. All is about the page that is
 * open. */
#ifndef LAB_LESSON_LESSON_JUDGE_H
#define LAB_LESSON_LESSON_JUDGE_H

#include "scenario/settings.h"
#include "lessons/lesson.h"
#include "answers/run_summary.h"

typedef struct Laboratory Laboratory;

/* What became of the exercises of the lesson that the laboratory was opened with, page by page. */
typedef struct Homework {
    ExerciseMark marks[LESSON_PAGES_MAX];
    ExerciseMark elsewhere; /* of a page of another lesson: not kept */
} Homework;

/* What a page leaves its reader with: the run that is asked about. */
typedef struct ExerciseRun {
    bool known; /* not of a page that was given up on its way */
    Settings entered;
    Settings judged; /* the last run that was held against a goal */
    bool was_judged;
} ExerciseRun;

/* The page's state is reached: from here the reader answers. */
void lesson_judge_enter(Laboratory *);

bool lesson_judge_counts(const Laboratory *); /* what is answered is of the lesson that was opened with */
ExerciseMark *lesson_judge_mark(Laboratory *);

/* Says on the page how it went. */
void lesson_judge_say(Laboratory *, bool right, const char *text);

/* Holds the run against the page's goal, where it has ended and has not been held yet. True: it is met. */
bool lesson_judge_goal(Laboratory *);

/* What a run comes to, done to its end on the spot. False: it failed or was given up. */
bool lesson_judge_run(Laboratory *, const Settings *, RunSummary *, Status *);

/* What the page's exercise is of a run that came to this; NAN: not known. False: `was` has no run. */
bool lesson_judge_value(const Laboratory *, const Settings *, const RunSummary *, double *value, Status *);

/* The right number of the page, from a run of its own to the end. NAN: it is not known. False: the run failed
 * or was given up. */
bool lesson_judge_number(Laboratory *, double *right, Status *);

#endif
