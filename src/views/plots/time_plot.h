/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What plots over time share: the window, curves from a record, the mark of the present. */
#ifndef VIEWS_PLOTS_TIME_PLOT_H
#define VIEWS_PLOTS_TIME_PLOT_H

#include "panes/screen_runs.h"
#include "picture/picture.h"

typedef struct Curve {
    const Record *record;
    int column;
    double (*value)(const double *row, const void *context); /* NULL, or the value is this of the row */
    const void *context;
} Curve;

/* Axes over time, y with its name and unit. The window begins at a whole cell, so that curves shift by whole
 * cells and do not shimmer. Rules mark breaks, touches, partings and tears that were told of, the present if
 * it is not the newest time, and the cursor. */
void time_plot_axes(const Screen *, Picture *, Axis y, const char *name, const char *unit);

/* The time at the left and right end of the time plots, as drawn at present. */
void time_plot_window(const Screen *, double *from, double *to);

/* Adds a curve's part in the window to the last stroke begun, extremes of each column of dots kept. */
void time_plot_curve(Picture *, const Curve *);

/* The distance of rows at which a whole record is looked through for the range of an axis: a picture must not
 * take longer because the run is long. Axes are rounded up, and swings have many rows. */
size_t time_plot_stride(const Record *);

/* The largest magnitude of a column in the whole record, so that the axis does not depend on the window. */
double time_plot_reach(const Record *, int column);

/* Between what the references among the columns will lie: asked for times to come, so that the axis is right
 * from the start. */
void time_plot_range_to_come(const Screen *, double least[COLUMNS_MAX], double most[COLUMNS_MAX]);

/* How the column of a record is drawn that answers another one: with which line, under which name. */
PictureKey time_plot_key(const Column *columns, int column);

/* Whether the reference curves that are shown are such as this one. */
bool time_plot_shows(const Screen *, const Column *);

#endif
