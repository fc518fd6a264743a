/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The runs that a picture shows: the present one, the second one of a duel, and the ghosts of earlier ones.
 * Every view draws this list, so that all of them tell the runs apart in the same way: by line, style, and a
 * letter at the end of the curve. */
#ifndef VIEWS_PLOTS_RUNS_H
#define VIEWS_PLOTS_RUNS_H

#include "panes/screen_runs.h"
#include "picture/picture.h"

enum { RUNS_MAX = GHOSTS_MAX + 2, RUN_WORD_MAX = LEGEND_MAX + 56, RUN_MARKS = 4 };

typedef struct ShownRun {
    char letter;             /* 'a' to 'e' a ghost, 'A' and 'B' in a duel; 0: the only run */
    char word[RUN_WORD_MAX]; /* for legends: "measured", "A USF", or what differs in a ghost */
    char key[4];             /* what stands for a ghost in a legend, "a:"; else "" */
    LineStyle line;
    Style style;
    int rank;
    char mark;  /* what ASCII draws it with */
    bool shown; /* if not, it only counts for the range of an axis */

    const Settings *settings;
    const Record *record;
    const Column *columns;
    int n_columns;
    const Readout *readout;
    const Experiment *experiment; /* NULL: a ghost */
    int ghost;                    /* its index; -1: none */
    const Profile *profile;       /* of a ghost: as it was last on screen, */
    const CrackLine *crack;       /* and its cracks */
} ShownRun;

/* From the back to the front: ghosts, the second run, the present one, which is always there. In a picture of
 * one run of a duel that one is the present. */
int runs_of(const Screen *, ShownRun runs[RUNS_MAX]);

/* Leaves only the runs that have a column; returns how many. */
int runs_with(ShownRun *, int n_runs, const char *column);

/* The column of a run's record by name; -1: there is none. */
int runs_column(const ShownRun *, const char *name);

/* Begins a stroke in the way of the run. */
void runs_begin(Picture *, const ShownRun *);

/* The run's entry in a legend. */
PictureKey runs_key(const ShownRun *);

/* Where along an axis the curve of a ghost that is kept has its letter once more, the k-th of RUN_MARKS
 * times: each ghost elsewhere, so that curves that lie on each other all have names. NAN: nowhere. */
double runs_mark(const ShownRun *, const Axis *, int k);

/* Puts the run's letter at a place of the plot, usually the end of its curve; or once more on it. */
void runs_letter(Picture *, const ShownRun *, double x, double y, MarkKind);

/* Adds the column's curves over time of all ghosts that are shown. */
void runs_add_ghosts(Picture *, const ShownRun *, int n_runs, const char *column);

/* The run's letter at the end of its curve over time. */
void runs_letter_over_time(Picture *, const ShownRun *, int column);

/* A letter at the end of the column's curve of every run that has one: a ghost is told by more than its faint
 * colour. */
void runs_add_letters(Picture *, const ShownRun *, int n_runs, const char *column);

/* "a: cell size 1  b: USL": what the ghosts' letters stand for, for pictures whose legend has no room for it.
 * "" without ghosts. What does not fit whole is left out. */
void runs_ghost_names(const Screen *, int columns, char *out, size_t size);

/* What the run comes to, in notes that are beside each other where there is room. Returns how many. */
int runs_note_findings(const Screen *, Picture *);

/* Legend entries of the ghosts among these runs. */
void runs_add_keys(Picture *, const ShownRun *, int n_runs);

#endif
