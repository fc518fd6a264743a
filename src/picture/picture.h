/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a view has drawn, kept as strokes, axes, marks and words in place of cells: the display list that
 * figures on paper are made of. A canvas with a picture has no cells; everything that a view draws on it in
 * the usual way (axes_draw, plot_draw, axes_mark, heading_draw, area_text, ...) goes into the picture in the
 * coordinates of the plot. What is drawn cell by cell (area_put) is of the screen alone and leaves nothing.
 */
#ifndef VIEW_PICTURE_H
#define VIEW_PICTURE_H

#include "picture/plot.h"

enum { PICTURE_KEYS_MAX = 16, PICTURE_NOTES_MAX = 8, PICTURE_LABELS_MAX = 16, PICTURE_TEXT_MAX = 256 };

/* An entry of the legend. */
typedef struct PictureKey {
    LineStyle line;
    Style style;
    char letter; /* of an earlier run; 0: none */
    char name[PICTURE_TEXT_MAX];
} PictureKey;

enum { PICTURE_RULE = '|' }; /* a mark that is a vertical line across the plot */

/* A dot, ring or letter at a place of the plot. */
typedef struct PictureMark {
    double x, y;
    uint32_t glyph;
    Style style;
} PictureMark;

/* A line of words beside the picture. */
typedef struct PictureNote {
    bool faint; /* an explanation, not a result */
    char text[PICTURE_TEXT_MAX];
} PictureNote;

/* A body of coloured pieces on a lattice: piece k lies in column k % nx and row k / nx, row 0 below, and is
 * centred at (x, y) as drawn, displacements enlarged, in the coordinates of the plot. */
typedef struct PictureMap {
    int nx, ny;
    double *x, *y, *value; /* value NAN: not drawn */
    double size;           /* of a piece, both ways */
    double enlarged;       /* the factor of the displacements */
    double low, high;      /* range of the colours */
    bool is_signed;        /* zero is in the middle */
    char unit[16];         /* SI; "" for a number */
} PictureMap;

/* Words at a place of the plot, centred on its height, no higher than 1 in its coordinates. */
typedef struct PictureLabel {
    double x, y;
    int side;     /* of the place on which they stand: -1 left, 0 both, 1 right */
    bool on_line; /* which is broken for them */
    Style style;
    char text[64];
} PictureLabel;

typedef struct Picture {
    char time[48];                  /* "t 12.34" */
    bool of_moment;                 /* of that time alone, not of all up to it */
    char heading[PICTURE_TEXT_MAX]; /* what is drawn: the name of the vertical axis where there are axes */
    char x_name[PICTURE_TEXT_MAX];
    bool has_axes;   /* if not, the view had nothing to draw and the notes say why */
    bool compares;   /* its curves are of one quantity: words say how far the measured one is from others */
    bool upright;    /* what is plotted goes across, over a height */
    bool bare;       /* the axes only say where things are: a drawing, with labels */
    double stretch;  /* a length upwards is drawn so many times as long as one across; 0: as there is room */
    Plot plot;       /* its axes, and the strokes of all that was plotted */
    PictureMap *map; /* NULL: it is a plot */
    PictureMark *marks;
    size_t n_marks, marks_room;
    PictureLabel labels[PICTURE_LABELS_MAX];
    int n_labels;
    PictureKey keys[PICTURE_KEYS_MAX];
    int n_keys;
    PictureNote notes[PICTURE_NOTES_MAX];
    int n_notes;
} Picture;

void picture_open(Picture *);
void picture_close(Picture *);

/* What the drawing functions add. Without memory something is left out. */
void picture_heading(Picture *, const char *text);
void picture_axes(Picture *, const Axis *x, const Axis *y, const char *x_name);
void picture_plot(Picture *, const Plot *);

/* Room for a map of so many pieces, to be filled; NULL: no memory. */
PictureMap *picture_map(Picture *, int nx, int ny);

void picture_mark(Picture *, double x, double y, uint32_t glyph, Style);
void picture_rule(Picture *, double x, Style); /* a vertical line across the plot */
void picture_label(Picture *, const PictureLabel *);
void picture_key(Picture *, const PictureKey *);
void picture_note(Picture *, const char *text, bool faint);

#endif
