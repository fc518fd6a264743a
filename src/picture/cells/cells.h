/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures in cells. Whatever has to give way to the size of a pane does so here, by one order for all of
 * them: ticks, words of the legend, lines of words below; the plot keeps four rows. */
#ifndef PICTURE_CELLS_CELLS_H
#define PICTURE_CELLS_CELLS_H

#include "picture/canvas.h"
#include "picture/picture.h"
#include "picture/plot.h"

/* Opens one for a pane, or as much of a page, of so many columns and rows. */
void cells_open(Picture *, int columns, int rows, Glyphs);

/* Finds the ticks for so many rows. */
void cells_fit(Picture *, int rows);

/* `colours`: that the screen has; with any they distinguish bands. */
void cells_draw(Picture *, Area, Style heading, int colours);

/* The mark nearest to a cell of the drawing in `rect` that the mouse can choose; NULL: none. */
const PictureMark *cells_target(const Picture *, Rect rect, int x, int y);

/* A list, drawn; the row under a cell, -1: none; the first row in sight; and of one that has rows, so many
 * lines on: the first row in sight then, and the chosen one, which is kept in sight. */
void cells_list(const Picture *, Area, Style heading);
long cells_row(const Picture *, Rect rect, int x, int y);
size_t cells_top(const Picture *, Rect rect);
size_t cells_scroll(const Picture *, Rect rect, int by, size_t *top);

/* One that is drawn with its dimensions: places in whole columns, and rows above 0. */
void cells_drawing(const Picture *, Area, Style heading);

/* Tables, drawn; what is in a cell, set -1: nothing; and the part below what is around, beside the
 * tables, without rows: there is none. */
void cells_tables(const Picture *, Area, Style heading);
PictureThing cells_thing(const Picture *, Rect rect, int x, int y);
Rect cells_below(const Picture *, Rect rect);

/* Draws both axes along the edges of an area: labels of y in a gutter of `gutter` columns at the left, labels
 * of x in the last row, `x_name` at its end. Returns the part that is left for the curves. */
Area axes_draw(Area, const Axis *x, const Axis *y, const char *x_name, int gutter);

/* Draws all strokes into an area that axes_draw() left. */
void plot_draw(const Plot *, Area);
/* Adds a mark of the plot that was drawn last to what its canvas describes (canvas_vector()). */
void plot_describe_mark(const Plot *, Area, double x, double y, uint32_t glyph, Style);

/* --- a body --------------------------------------------------------------------------------------- */

void cells_map(const Picture *, Area, Style heading, int colours);
void cells_map_body(const Picture *, Area, int colours); /* without words around it */

/* In cells a factor is a letter: the sign for it is wide in some fonts. `out` has room for the text. */
void cells_plain_factors(const char *text, char *out);

/* Where a place of the plot is drawn in the part `rect`. */
void cells_place(const PictureMap *, Rect, double x, double y, double *column, double *row);

/* In the pane `rect`: the piece drawn nearest to a cell of the screen, -1: none is near; and the place of the
 * undeformed body in the cell's middle, false: it is outside. */
long cells_map_piece(const Picture *, Rect, int x, int y);
bool cells_map_place(const Picture *, Rect, int x, int y, double place[2]);

/* --- legends and headings ------------------------------------------------------------------------- */

/* One entry of a legend. */
typedef struct Legend {
    LineStyle line;
    char letter;
    Style style;
    const char *name;
    const char *key; /* what stands for it, 2 columns; NULL: a piece of the line */
    int band;        /* 1 and a band's fill; 0: no band */
} Legend;

/* Draws entries of a legend from column x on as far as there is room; returns how many. */
int legend_draw(Area, int x, int y, const Legend *, int n_legend);

enum { LEGENDS_MAX = 32 }; /* under one heading */

/* The same with names that are shortened until there is room, of ghosts to their values; to the letter only
 * where not even the first one has it. */
int legend_draw_short(Area, int x, int y, const Legend *, int n_legend);

/* Draws the heading line of a plot: name, scale, legend as far as there is room. Where it is short names are
 * shortened first, then entries move together, then, if the legend does not go on below, ghosts keep their
 * letter only; the first ones, whose curves are solid, are kept. Returns how many entries of the legend that
 * were. */
int cells_heading_draw(Area, Style heading, const char *name, const char *scale, const Legend *, int n_legend,
                       bool goes_on);

#endif
