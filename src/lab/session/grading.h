/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Marks for homework: a session is done again without a screen, and what becomes of the exercises on the way
 * is their mark. Nothing that its file says of marks is believed, for it says nothing.
 *
 * Sessions are files from anybody: they are read with bounds, write nothing, see the lesson that the teacher
 * named and not the one that they name, and are given up after so many steps or so long. */
#ifndef LAB_SESSION_GRADING_H
#define LAB_SESSION_GRADING_H

#include "base/cancel.h"
#include "lessons/lesson.h"

typedef struct GradingTask {
    const char *lesson; /* by name or path */
    int threads;
    double seconds; /* that a session may take */
    Cancel cancel;  /* asked now and then; the share is that of the keys */
} GradingTask;

/* An exercise of the lesson and what became of it. */
typedef struct Grade {
    int page; /* from 0 */
    ExerciseMark mark;
    double seconds; /* of the session, when the last answer came; 0: none came */
} Grade;

enum { GRADING_REMARK_MAX = 256 };

typedef struct Grades {
    char student[STUDENT_MAX];       /* "": not known */
    char id[STUDENT_MAX];            /* "": not given */
    char remark[GRADING_REMARK_MAX]; /* why there are no marks, or what is to be known of them; "": nothing */
    Grade grades[LESSON_PAGES_MAX];
    int count; /* 0: there are no marks */
} Grades;

/* How sessions are distinguished: two of the same keys at the same steps are one, no matter whose name they
 * have and however fast and on whatever screen they were pressed. */
typedef struct GradingOrigin {
    bool known; /* it gets marks, and has keys enough to judge */
    uint64_t check, keys;
} GradingOrigin;

void grading_origin(const Lesson *, const char *file, GradingOrigin *);

/* Marks one session. What is wrong with it is the remark; false: cancelled, no memory, or the
 * lesson cannot be read, and the status says so. */
bool grading_session(const GradingTask *, const char *file, Grades *, Status *);

/* The right answers of a student's variants ("": of nobody's): each mark holds the right answer and, of a
 * goal, in its value what the way to it of the lesson comes to. An exercise that marks what says nothing is
 * refused: a number whose tolerance takes 0, what it is before the run has begun, or what is right for who
 * has the next value of a variant; a goal that the page's own run fulfils. */
bool grading_key(const GradingTask *, const char *student, Grades *, Status *);

#endif
