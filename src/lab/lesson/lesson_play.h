/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lessons: pages beside the run, what is right there, how a page is entered, and what the laboratory does
 * when one is opened.
 *
 * What is right is calculated on the spot, of the page's run for a number and of the reader's
 * own for a goal, so that a session that is done again gets its marks again. All is about the page that is
 * open. */
#ifndef LAB_LESSON_LESSON_PLAY_H
#define LAB_LESSON_LESSON_PLAY_H

#include "scenario/settings.h"
#include "lessons/lesson.h"
#include "lessons/lesson_shown.h"
#include "answers/run_summary.h"
#include "base/output.h"
#include "terminal/keys.h"
#include "help/command.h"
#include "lab/player.h"

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

bool lesson_judge_counts(const Laboratory *); /* what is answered is of the lesson that was opened with */
ExerciseMark *lesson_judge_mark(Laboratory *);

/* Says on the page how it went. */
void lesson_judge_say(Laboratory *, bool right, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/* Holds the run against the page's goal, where it has ended and has not been held yet. True: it is met. */
bool lesson_judge_goal(Laboratory *);

/* What a run comes to, done to its end on the spot. False: it failed or was given up. */
bool lesson_judge_run(Laboratory *, const Settings *, RunSummary *, Status *);

/* What the page's exercise is of a run that came to this; NAN: not known. False: `was` has no run. */
bool lesson_judge_value(const Laboratory *, const Settings *, const RunSummary *, double *value, Status *);

/* The right number of the page, from a run of its own; NAN: not known. False: that failed or was given up. */
bool lesson_judge_number(Laboratory *, double *right, Status *);

/* How a page of a lesson is entered: in one state, whichever way one came.
 *
 * That state is what the pages leave behind that begin with the last one that opens a scenario, as if each
 * had been read: what it does, what follows its answer, and where its goal is. From the page before nothing
 * needs to be done again where its reader left it just so. */

enum { LESSON_QUEUE_MAX = 256, LESSON_NAME_MAX = 256, LESSON_KEYS_MAX = 64 };

/* What is still to be done: a line as behind `:`, or to come where the goal of a page is. */
typedef struct LessonAction {
    const char *line; /* NULL: the goal */
    const LessonUntil *goal;
} LessonAction;

/* The lesson that is open, and what is still to be done for its page. */
typedef struct LessonPlay {
    LessonShown shown; /* behind screen.lesson */
    Lesson lesson;
    char name[LESSON_NAME_MAX];
    LessonAction queue[LESSON_QUEUE_MAX];
    int n_queue, next;
    bool arriving;                /* the page's state is not reached as yet */
    Key waiting[LESSON_KEYS_MAX]; /* for it: keys that came meanwhile */
    int n_waiting;
    bool hurries;      /* the run goes on to what the goal of a page before waits for */
    bool touched;      /* since then the reader did more than to run and to step */
    Place place;       /* where the page leaves the run, its goal apart */
    CommandSet used;   /* since the page was opened */
    int digit;         /* in the list, the first of two that was typed; 0: none */
    bool warned;       /* that the page still waits */
    int resumes;       /* the page, from 1 on, that is opened because the reader had come to it; 0: none */
    Asker asker;       /* who turned to the page */
    char refused[320]; /* what it wanted to do and could not, and why; "": nothing */
    ExerciseRun run;   /* of a page with an exercise */
    bool busy;
    bool full;  /* the reader has turned to the full sheet, which stays to the end of the lesson */
    int before; /* Sheet: the one to which its end returns */
} LessonPlay;

/* The page that is open; NULL: there is none, or the list of lessons. */
const LessonPage *lesson_entry_page(const Laboratory *);

/* Turns to a page, and brings about its state. */
void lesson_entry_show(Laboratory *, int page);

/* The row of the parameter pane that the arrows change, so that fields beside a text work as there. */
void lesson_entry_select(Laboratory *, const char *key);

/* How fast a run goes under the page that is open; without one, as anywhere. */
void lesson_entry_choose_pace(Laboratory *);

/* How far one has come in the lesson that is open; NULL: it is a file, whose progress is not kept. */
int *lesson_entry_reached(Laboratory *);

/* What follows the answer. */
void lesson_entry_reveal(Laboratory *);

/* To be told of each key that the reader presses. */
void lesson_entry_note(Laboratory *, const Key *);

/* An answer or an edit means the run that the page asks about, so that while the page is on its way keys wait
 * for it, but for those that leave it. True: this one does, or is for nothing (of the mouse: what it points
 * at goes). */
bool lesson_entry_keeps(Laboratory *, const Key *);

/* The next key that has waited, once the page is there. */
bool lesson_entry_next_key(Laboratory *, Key *);

/* What is on its way, to a time or a page to its state, stays where it is; nothing is asked about the run of
 * such a page until it is entered again. False: nothing is. */
bool lesson_entry_cancel(Laboratory *);

/* What is left to be done, once the run has come to where it should be. */
void lesson_play_continue(Laboratory *);

bool lesson_play_open(Laboratory *, const char *name, Status *);
void lesson_play_close(Laboratory *);
void lesson_play_toggle(Laboratory *);
bool lesson_play_turn(Laboratory *, int direction); /* false: the keys are not those of a page */
bool lesson_play_key(Laboratory *, const Key *);    /* false: it is not for the lesson */
void lesson_play_search(Laboratory *);              /* asks for words; in the list */
void lesson_play_move(Laboratory *, int x, int y);
void lesson_play_enter(Laboratory *);               /* opens the chosen one, serves the page, or goes on */
bool lesson_play_click(Laboratory *, int x, int y); /* false: there is none in that cell */

#endif
