/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What plots of runs share: runs and how they are distinguished, curves over time, a foreign series. */
#ifndef VIEWS_PLOTS_PLOTS_H
#define VIEWS_PLOTS_PLOTS_H

#include "panes/screen.h"
#include "picture/picture.h"

/* --- the runs of a picture ------------------------------------------------------------------------ */

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

/* The letter of every run that has one, at the end of the column's curve: not faint alone. */
void runs_add_letters(Picture *, const ShownRun *, int n_runs, const char *column);

/* "a: cell size 1  b: USL": what the ghosts' letters stand for, for pictures whose legend has no room for it.
 * "" without ghosts. What does not fit whole is left out. */
void runs_ghost_names(const Screen *, int columns, char *out, size_t size);

/* Findings in the words of a note. */
enum { READOUT_TEXT = 640 };
void runs_findings_text(const Screen *, const Finding *, int count, char *out, size_t size);

/* What the run comes to, in notes that are beside each other where there is room. Returns how many. */
int runs_note_findings(const Screen *, Picture *);

/* Legend entries of the ghosts among these runs. */
void runs_add_keys(Picture *, const ShownRun *, int n_runs);

/* --- over time ------------------------------------------------------------------------------------ */

typedef struct TimeCurve {
    const Record *record;
    int column;
    double (*value)(const double *row, const void *context); /* NULL, or the value is this of the row */
    const void *context;
} TimeCurve;

/* Axes over time, y with its name and unit. The window begins at a whole cell, so that curves shift by whole
 * cells and do not shimmer. Rules mark breaks, touches, partings and tears that were told of, the present if
 * it is not the newest time, and the cursor. */
void time_plot_axes(const Screen *, Picture *, Axis y, const char *name, const char *unit);

/* The time at the left and right end of the time plots, as drawn at present. */
void time_plot_window(const Screen *, double *from, double *to);

/* Adds a curve's part in the window to the last stroke begun, extremes of each column of dots kept. */
void time_plot_curve(Picture *, const TimeCurve *);

/* The distance of rows at which a whole record is looked through for the range of an axis: a picture must not
 * take longer because the run is long. Axes are rounded up, and oscillations have many rows. */
size_t time_plot_stride(const Record *);

/* The largest magnitude of a column in the whole record, so that the axis does not depend on the window. */
double time_plot_reach(const Record *, int column);

/* Between what the references among the columns will lie, so that the axis is right from the start. */
void time_plot_range_to_come(const Screen *, double least[COLUMNS_MAX], double most[COLUMNS_MAX]);

/* How the column of a record is drawn that answers another one: with which line, under which name. */
PictureKey time_plot_key(const Column *columns, int column);

/* Whether the reference curves that are shown are such as this one. */
bool time_plot_shows(const Screen *, const Column *);

/* --- a foreign series ----------------------------------------------------------------------------- */

/* Widens a range so that the axis of y holds it. */
void overlay_widen(const Screen *, const char *curve, bool along, double *least, double *most);

/* Adds its dots, the first, least, largest and last value of each column of them, with marks and a name. */
void overlay_add(const Screen *, Picture *, const char *curve, bool along);

/* Its value at a time or place, that of the nearest row; NAN: it has none there. */
double overlay_value(const Screen *, const char *curve, bool along, double x);

#endif
