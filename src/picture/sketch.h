/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a view has drawn, kept as strokes, axes, marks and words in place of cells: the display list that
 * figures on paper are made of. A canvas with a sketch has no cells; everything that a view draws on it in
 * the usual way (axes_draw, plot_draw, axes_mark, heading_draw, area_text, ...) goes into the sketch in the
 * coordinates of the plot. What is drawn cell by cell (area_put) is of the screen alone and leaves nothing.
 */
#ifndef VIEW_SKETCH_H
#define VIEW_SKETCH_H

#include "picture/plot.h"

enum { SKETCH_KEYS_MAX = 16, SKETCH_NOTES_MAX = 8, SKETCH_LABELS_MAX = 16, SKETCH_TEXT_MAX = 256 };

/* An entry of the legend. */
typedef struct SketchKey {
    LineStyle line;
    Style style;
    char letter; /* of an earlier run; 0: none */
    char name[SKETCH_TEXT_MAX];
} SketchKey;

enum { SKETCH_RULE = '|' }; /* a mark that is a vertical line across the plot */

/* A dot, ring or letter at a place of the plot. */
typedef struct SketchMark {
    double x, y;
    uint32_t glyph;
    Style style;
} SketchMark;

/* A line of words beside the picture. */
typedef struct SketchNote {
    bool faint; /* an explanation, not a result */
    char text[SKETCH_TEXT_MAX];
} SketchNote;

/* A body of coloured pieces on a lattice: piece k lies in column k % nx and row k / nx, row 0 below, and is
 * centred at (x, y) as drawn, displacements enlarged, in the coordinates of the plot. */
typedef struct SketchMap {
    int nx, ny;
    double *x, *y, *value; /* value NAN: not drawn */
    double size;           /* of a piece, both ways */
    double enlarged;       /* the factor of the displacements */
    double low, high;      /* range of the colours */
    bool is_signed;        /* zero is in the middle */
    char unit[16];         /* SI; "" for a number */
} SketchMap;

/* Words at a place of the plot, centred on its height, no higher than 1 in its coordinates. */
typedef struct SketchLabel {
    double x, y;
    int side;     /* of the place on which they stand: -1 left, 0 both, 1 right */
    bool on_line; /* which is broken for them */
    Style style;
    char text[64];
} SketchLabel;

typedef struct Sketch {
    char time[48];                 /* "t 12.34" */
    bool of_moment;                /* of that time alone, not of all up to it */
    char heading[SKETCH_TEXT_MAX]; /* what is drawn: the name of the vertical axis where there are axes */
    char x_name[SKETCH_TEXT_MAX];
    bool has_axes;  /* if not, the view had nothing to draw and the notes say why */
    bool compares;  /* its curves are of one quantity: words say how far the measured one is from others */
    bool upright;   /* what is plotted goes across, over a height */
    bool bare;      /* the axes only say where things are: a drawing, with labels */
    double stretch; /* a length upwards is drawn so many times as long as one across; 0: as there is room */
    Plot plot;      /* its axes, and the strokes of all that was plotted */
    SketchMap *map; /* NULL: it is a plot */
    SketchMark *marks;
    size_t n_marks, marks_room;
    SketchLabel labels[SKETCH_LABELS_MAX];
    int n_labels;
    SketchKey keys[SKETCH_KEYS_MAX];
    int n_keys;
    SketchNote notes[SKETCH_NOTES_MAX];
    int n_notes;
} Sketch;

void sketch_open(Sketch *);
void sketch_close(Sketch *);

/* What the drawing functions add. Without memory something is left out. */
void sketch_heading(Sketch *, const char *text);
void sketch_axes(Sketch *, const Axis *x, const Axis *y, const char *x_name);
void sketch_plot(Sketch *, const Plot *);

/* Room for a map of so many pieces, to be filled; NULL: no memory. */
SketchMap *sketch_map(Sketch *, int nx, int ny);

void sketch_mark(Sketch *, double x, double y, uint32_t glyph, Style);
void sketch_rule(Sketch *, double x, Style); /* a vertical line across the plot */
void sketch_label(Sketch *, const SketchLabel *);
void sketch_key(Sketch *, const SketchKey *);
void sketch_note(Sketch *, const char *text, bool faint);

#endif
