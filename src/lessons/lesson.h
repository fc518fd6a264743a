/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lessons: pages of text beside the live laboratory, from a text file. Format: manual page matvib(5).
 *
 * A line that begins with '@' says something of the lesson or of a page, '#' begins a comment line, all else
 * is text: lines are joined, an empty line parts paragraphs.
 *
 *     @title TEXT           @about TEXT             of the lesson, before its first page
 *     @group WORD           under which lists have it
 *     @objective TEXT       what a student can do after it: "choose a mass matrix"
 *     @prerequisites NAME, NAME ...   lessons to be read before
 *     @minutes N            in class
 *     @page TITLE           a page begins
 *     @do LINE              what the laboratory does when the page is opened, as behind `:`; not every line
 *     @field KEY            a parameter to be changed beside the text
 *     @ask QUESTION         then two to four choices, one of them right:
 *     @choice TEXT          @right TEXT
 *     @reveal               what follows waits: text and @do for the answer,
 *                           text for the goal of a page that asks nothing
 *     @until CONDITION      the goal: step N | time T | end | crossing | break | touch | event | rest |
 *                           stage N | command NAME | value KEY VALUE
 *     @variant KEY from A to B   sets a parameter to a value of the student's own; "{KEY}" in a text is that
 *     @variant KEY from WORD, WORD ...   the same of a choice; a mistake is made, but not shown
 *     @right TEXT if KEY is WORD, WORD ...   right for those whose variant is one of these;
 *                           several, each for some
 *     @answer EXPRESSION within TOLERANCE   in place of choices: a number (exercise.h)
 *     @words                in place of choices: free text for the teacher
 *     @goal EXPRESSION      in place of @until: what the reader's own run is to fulfil
 *                           at its end (expression.h)
 *     @points N             what the page's exercise counts in a student's sum (1)
 *     @solve LINE           behind it: how it is reached, for the teacher's key and for the pages behind
 *
 * State: a page is entered as the pages before it leave the laboratory that begin with the last that did
 * `open`, each one read, answered rightly and brought to its goal - forwards, backwards, skipping or coming
 * back to the lesson later. So the first page opens a scenario, and one that shows another run, or the same
 * from its start, opens it again: that costs least and keeps no ghost. `run-pause` stands last, starts the
 * run and counts on its own page only; the goal of a command leaves nothing behind.
 *
 * Goals: to a time, a step, the end or an event the run stops by itself, seconds after Space; pages of stages
 * and steps go on by ] or Space, which never runs away under them. What must not be known beforehand stands
 * behind
 * @reveal, and no picture may show it either (`show`, `references none`, not quite the end of a run).
 *
 * Sheet: a page shows its text and one picture, that of its last `show`, or where the scenario's number is
 * seen; `sheet full`, behind `open`, is for a page that quotes a table or a summary, and holds on that page
 * alone.
 *
 * Keys: Enter serves a question or a field first, then goes on; n always goes on, b back; digits answer.
 *
 * Size: all of a page is seen at 80x24 (some ten lines of 35 characters), 132x43 and 60x18, within a step
 * with the box below it or a drawing that has its terms; tests/lab/check_lessons holds this, the states, and
 * that numbers are on the screen or in tests/lab/lesson-numbers; tests/cli/numbers.sh that they are right.
 */
#ifndef LESSONS_LESSON_H
#define LESSONS_LESSON_H

#include "lessons/exercise.h"
#include "lessons/variant.h"
#include "scenario/assignment.h"

#include <stdint.h>
#include <stdio.h>

enum { LESSON_CHOICES_MAX = 4, LESSON_FIELDS_MAX = 3, LESSON_PAGES_MAX = 64, LESSON_VARIANTS_MAX = 16 };

/* A part of a page: shown, and done. */
typedef struct LessonPart {
    char *text; /* paragraphs separated by '\n'; NULL: none */
    char **actions;
    int n_actions;
} LessonPart;

typedef enum UntilKind {
    UNTIL_NOTHING,
    UNTIL_STEP,    /* so many whole steps have been done: number */
    UNTIL_TIME,    /* number */
    UNTIL_STAGE,   /* in the middle of a step, so many of its stages: number */
    UNTIL_END,     /* of the run */
    UNTIL_EVENT,   /* something happens to it: word, of stop_event_words */
    UNTIL_COMMAND, /* a command of that name has been used: word */
    UNTIL_VALUE,   /* a parameter has a value: word, value */
    UNTIL_GOAL     /* a run has ended that fulfils the page's exercise */
} UntilKind;

/* What a page waits for before the next one. */
typedef struct LessonUntil {
    UntilKind kind;
    double number;
    char word[KEY_MAX], value[VALUE_MAX];
} LessonUntil;

typedef struct LessonPage {
    char *title;
    LessonPart first, revealed; /* the second once the question is answered or, without one, the goal met */
    char *question;             /* NULL: none */
    char *choices[LESSON_CHOICES_MAX];
    char *if_words[LESSON_CHOICES_MAX]; /* of a choice: right for whom one of these is drawn; NULL: for all */
    char if_key[KEY_MAX];               /* whose words they are */
    int n_choices, right; /* right: the first that is for somebody, until it is known for whom */
    char fields[LESSON_FIELDS_MAX][KEY_MAX];
    int n_fields;
    LessonUntil until;
    Exercise *exercise;  /* NULL: none, or a choice */
    double points;       /* that its exercise counts; 0: not said, which is 1 */
    LessonPart solution; /* of a goal: actions */
} LessonPage;

/* Where a variant's value is set. */
typedef struct LessonVariant {
    Variant variant;
    int page, action;
    char value[NUMBER_TEXT_MAX]; /* once it is drawn */
} LessonVariant;

typedef struct Lesson {
    char *title, *about;                       /* one line each */
    char *group;                               /* under which lists have it; NULL: none */
    char *objective, *prerequisites, *minutes; /* NULL: not given */
    LessonPage *pages;
    int n_pages;
    LessonVariant variants[LESSON_VARIANTS_MAX];
    int n_variants;
    uint64_t version; /* of its lines, and of those of the scenario files that it opens, without comments:
                         distinguishes one text of a lesson from another */
} Lesson;

/* A lesson that is part of the program, from data/lessons. */
typedef struct BuiltinLesson {
    const char *name; /* "one-step" */
    const char *text;
    const char *title, *about, *group, *objective, *prerequisites,
        *minutes; /* as its text says them; NULL: it does not */
    int n_pages;
} BuiltinLesson;

extern const BuiltinLesson builtin_lessons[]; /* generated; ended by a NULL name */

/* Whether a lesson may have this line done: it changes the laboratory and nothing else. A lesson is a file
 * from anybody, so a line that would write, draw a figure, record or leave is refused when it is read; which
 * lines those are is known to the table of commands (help/command.h). False: the status says why. */
typedef bool (*LessonJudge)(const char *line, Status *);

/* Reads a lesson by built-in name or, failing that, by path. The scenario files that a lesson in a file opens
 * are sought beside it. False: "FILE:LINE: what is wrong (what is
 * allowed)"; nothing is left to be freed. */
bool lesson_load(const char *name_or_path, LessonJudge, Lesson *lesson, Status *status);

/* The same with the variants of a student ("": of nobody in particular). */
bool lesson_load_for(const char *name_or_path, const char *student, LessonJudge, Lesson *lesson,
                     Status *status);

/* The same from a stream; `name` stands for FILE. */
bool lesson_read(FILE *stream, const char *name, LessonJudge, Lesson *lesson, Status *status);

/* Draws the variants of a student ("": of nobody in particular) and puts them into the texts; once. */
bool lesson_draw(Lesson *, const char *student, Status *);

/* The variant of a key on a page: the last one up to there. NULL: there is none. */
const LessonVariant *lesson_variant(const Lesson *, const char *key, int page);

/* Whether each "{KEY}" of a line has a variant; for who reads a lesson. */
bool lesson_knows_braces(const Lesson *, const char *line, Status *);

ExerciseKind lesson_exercise(const LessonPage *);
double lesson_points(const LessonPage *); /* 0: it has no exercise */

/* The scenario that a line opens, behind "open" or "full"; NULL: it opens none. */
const char *lesson_opening(const char *line);

void lesson_free(Lesson *lesson); /* also an empty one */

const BuiltinLesson *lesson_builtin(const char *name); /* NULL: there is none */

#endif
