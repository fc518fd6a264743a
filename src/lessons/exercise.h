/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Exercises of a lesson: what a page asks for that is judged by the program, or kept for the teacher.
 *
 *     @answer EXPRESSION within TOLERANCE [%]   a number; the right one is that of the page's run at its end
 *     @goal EXPRESSION                          what the student's own run is to fulfil at its end
 *     @words                                    free text for the teacher
 *
 * A choice (@choice, @right) is an exercise too. Nothing of what is right is stored: it is calculated from a
 * run, since each student may have another variant. */
#ifndef LESSONS_EXERCISE_H
#define LESSONS_EXERCISE_H

#include "base/text.h"
#include "lessons/expression.h"

typedef enum ExerciseKind {
    EXERCISE_NONE,
    EXERCISE_CHOICE,
    EXERCISE_NUMBER,
    EXERCISE_GOAL,
    EXERCISE_WORDS
} ExerciseKind;

typedef struct Exercise {
    ExerciseKind kind;
    Expression expression; /* of a number or a goal */
    double tolerance;      /* of a number: in percent of the right one where `relative` */
    bool relative;
} Exercise;

/* Read what stands behind @answer and @goal. */
bool exercise_read_answer(const char *text, Exercise *, Status *);
bool exercise_read_goal(const char *text, Exercise *, Status *);

/* Whether an answer is near enough to the right one. */
bool exercise_accepts(const Exercise *, double right, double given);

/* What the number is as long as the run has not begun to move; NAN: it does not depend on that, or is not
 * known. `end` is what the run came to at its end. */
double exercise_at_start(const Exercise *, const ExpressionRun *end);

/* A number as a student writes it: "1.5", "1,5", "1.5 %", "100/17". */
bool exercise_read_number(const char *text, double *number);

/* A right answer as it is shown; "": it is not known. */
void exercise_write_number(double number, char out[NUMBER_TEXT_MAX]);

/* What a goal asks, in words: "error within 1 %; cells at most 60". `was`: NULL where no run is known. */
void exercise_tell_goal(const Exercise *, const ExpressionRun *was, char *out, size_t size);

/* Why a run does not fulfil a goal, and what it does: "cells 100, must be at most 60. Met: error"; false: it
 * fulfils all. */
bool exercise_failing(const Exercise *, const ExpressionRun *now, const ExpressionRun *was, char *out,
                      size_t size);

enum { ANSWER_MAX = 256 };

/* What became of an exercise. */
typedef struct ExerciseMark {
    int tries;
    bool judged, right;     /* not judged: the teacher's, or what is right is not known */
    char value[ANSWER_MAX]; /* the last answer */
    char right_answer[EXPRESSION_MAX];
} ExerciseMark;

#endif
