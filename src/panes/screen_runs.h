/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What panes and views ask of the runs on screen. */
#ifndef PANES_SCREEN_RUNS_H
#define PANES_SCREEN_RUNS_H

#include "panes/screen.h"
#include "picture/style.h"

/* One picture, one number and few parameters: by the sheet, or for a lecture. */
bool screen_is_plain(const Screen *);

/* What `t` would try: "cell size 0.5". False: nothing is asked. */
bool screen_question(const Screen *, char *out, size_t size);

/* The number that the scenario is about at the step on screen, in digits and what stands behind them:
 * "periods late". False: it is not known, or hidden: "..." or "?". */
enum { NUMBER_DIGITS_MAX = 16, NUMBER_WORDS_MAX = 80 };
bool screen_number(const Screen *, char digits[NUMBER_DIGITS_MAX], char words[NUMBER_WORDS_MAX]);

/* How events are marked in timelines and plots; where several share a cell the one further down is seen. */
typedef struct EventMark {
    EventKind kind;
    const char *letter;
    Style style;
    const char *word; /* for the legend */
} EventMark;
enum { SCREEN_MARKS = 10 };
extern const EventMark screen_marks[SCREEN_MARKS];
const char *screen_event_letter(EventKind); /* " ": it has none */

/* The second run of a duel; NULL: there is none. */
const Experiment *screen_second_run(const Screen *);

/* The run beside the one on this screen, A of B and B of A; NULL: there is one alone. */
const Experiment *screen_other_run(const Screen *);

/* Both runs of a duel share the picture: what only one of them can have is left to the pictures of one run.
 */
bool screen_is_shared(const Screen *);

/* The screen of one run of a duel, for a picture of its own. */
Screen screen_of_side(const Screen *, DuelSide);

/* The run whose times the axes of time go by: A, in a picture of B as well. */
const Experiment *screen_clock_run(const Screen *);

bool screen_shows_exact(const Screen *);
bool screen_shows_predicted(const Screen *);
bool screen_is_focused(const Screen *, PaneId);
bool screen_is_running(const Screen *);
bool screen_is_rewound(const Screen *); /* more has been computed than is shown */

/* The time of the run with so many decimals less than the step has, but with two at least where it has them.
 */
void screen_shorter_time(const Screen *, int less, char *out, size_t size);

/* What is settled by the problem of the run shown, its units above all. */
const Problem *screen_problem(const Screen *);

/* "t 12.34" with as many decimals as the time step has: columns do not dance. */
void screen_time_text(const Screen *, double time, char *out, size_t size);

/* How far a particle field reaches: what it is now and, where the exact answer is known, will be; rounded up
 * so that a scale made of it keeps still. */
double screen_field_reach(const Screen *, int field, const double *now, size_t count);

/* The column of the record by name; -1: there is none. */
int screen_column(const Screen *, const char *name);

/* A derived number by name; NAN: there is none. */
double screen_derived(const Screen *, const char *name);

/* The stage that the box speaks of: the last one done (*done) or, between steps, the next. */
int screen_box_stage(const Screen *, bool *done);

/* A field of all nodes as it is or was before the last stage, so that what they held can be drawn when the
 * grid has been put back. The largest amount; -1: they have no such field. */
double screen_node_values(const Screen *, const char *field, bool before, double *out);

/* " m/s" after a value of a field; "" where it has none, and for the bar, whose units are whatever one likes
 * so long as they fit together. */
void screen_unit_text(const Screen *, const Field *, char *out, size_t size);

#endif
