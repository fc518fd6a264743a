/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A plot is a short list of strokes in the plot's own coordinates: lines, dots, filled bands. Back ends draw
 * the same list with braille dots, half blocks or letters.
 *
 * Where strokes share a cell the one of higher rank is seen and the other is not: a measured curve stays
 * clean where the exact one lies beside it. */
#ifndef PICTURE_PLOT_H
#define PICTURE_PLOT_H

#include "picture/axes.h"
#include "picture/glyph.h"

#include <stddef.h>

typedef enum StrokeKind {
    STROKE_LINE, /* through its points; a NAN breaks it */
    STROKE_DOTS, /* a dot at each point */
    STROKE_BAND  /* filled between two curves: points come in pairs (x, low), (x, high) */
} StrokeKind;

typedef enum LineStyle { LINE_SOLID, LINE_DOTTED, LINE_DASHED } LineStyle;

/* Who is seen where strokes meet. */
enum { RANK_BAND, RANK_GHOST, RANK_EXACT, RANK_PREDICTED, RANK_SECOND, RANK_MEASURED, RANK_MARK };

/* The same over a body, where the grid lies behind its particles. */
enum { RANK_GRID, RANK_ZONE, RANK_ANGLE, RANK_BEFORE, RANK_WALL, RANK_NOTCH, RANK_PATH };

/* How a line is drawn. */
typedef struct Pen {
    LineStyle line;
    char letter; /* what ASCII draws it with */
    Style style;
    int rank;
    int fill; /* of a band: 0 dense to 3 thin */
} Pen;

/* What is measured, the other run or curve of the kind, and what is known. */
extern const Pen pen_measured, pen_second, pen_exact, pen_predicted;

typedef struct Stroke {
    StrokeKind kind;
    LineStyle line;
    Style style;
    int rank;
    int fill;            /* of a band: 0 dense to 3 thin */
    char letter;         /* what ASCII draws it with; over a body 0: what shows its direction */
    int wall;            /* over a body: it stands still just above (1) or below (-1) its line; 0: on it */
    bool coarse;         /* it is shown by the colours under it where they are fine: not on a page */
    size_t first, count; /* its points */
} Stroke;

enum { STROKES_MAX = 96 };

typedef struct Plot {
    Axis x, y;
    Stroke strokes[STROKES_MAX];
    int n_strokes;
    double *points; /* x, y, x, y, ... */
    size_t n_points, room;
    bool lost; /* memory was short for a point */
} Plot;

void plot_close(Plot *);

/* Begins a stroke; plot_point() adds to the last one begun. Without memory a point is lost. */
void plot_begin(Plot *, StrokeKind, Pen);
void plot_point(Plot *, double x, double y);

/* A curve of many samples, cut to the axis of x: for each of `columns` columns the first, least, largest and
 * last sample, in the order in which they come, so that nothing that the curve does is left out. */
typedef double PlotSample(const void *context, size_t index, double *x); /* returns y */
void plot_curve(Plot *, PlotSample *, const void *context, size_t first, size_t end, int columns);

/* A short sample of a line for a legend, 2 columns: UTF-8. */
const char *plot_key(LineStyle, char letter, Glyphs);

/* A curve's or a picture's name where room is short: "measured" is "meas", "displacement" is "displ.". */
const char *legend_short_name(const char *name);

/* How finely the glyphs of an area can draw: dots in a cell. */
int plot_dots_across(Glyphs);
int plot_dots_down(Glyphs);

#endif
