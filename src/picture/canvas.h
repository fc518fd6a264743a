/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A grid of cells, each a glyph and a style: the screen as data. Panes draw on it; the terminal shows a copy
 * of it, and a test dumps it as text. No cell holds what would act on a terminal or move what is beside
 * it, wherever the text comes from. */
#ifndef PICTURE_CANVAS_H
#define PICTURE_CANVAS_H

#include "base/status.h"
#include "picture/glyph.h"

#include <stddef.h>
#include <stdint.h>

enum { CELL_FOLLOWS = 0x110000 }; /* no scalar value: the second half of the character before */

typedef struct Cell {
    uint32_t glyph; /* one Unicode scalar value; 0 counts as a space; CELL_FOLLOWS behind a wide one */
    uint16_t style; /* Style; a half-block cell of a heat map carries its lower colour in back */
    uint16_t back;  /* 0, or 1 + Style whose colour is the cell's background */
} Cell;

typedef struct Rect {
    int x, y, width, height;
} Rect;
bool rect_holds(Rect, int x, int y);

typedef struct Canvas {
    int width, height;
    Cell *cells;            /* height x width */
    int cursor_x, cursor_y; /* where the hardware cursor stands; -1: hidden */
    bool large;             /* to be read from afar: thick curves, few labels, no faint words */
    bool vectored;          /* lines and colours are described too, for a terminal that draws them finer */
    char *vectors;          /* that description, if there is one: commands of canvas_vector() */
    size_t vectors_used, vectors_room;
} Canvas;

bool canvas_open(Canvas *, int width, int height, Status *); /* all spaces; also resizes an open one */
void canvas_close(Canvas *);
void canvas_clear(Canvas *);

/* Adds to the description of what is drawn, where it is needed. Lengths are in 16ths of a cell, from the
 * upper left corner of the area that was named last; a command ends with the next one's ';'.
 *
 *     A X,Y,COLUMNS,ROWS               an area, in cells
 *     L|D|B STYLE,LINE,RANK X,Y ...    a stroke as plot.h has it: line, dots or band; '-' breaks a line;
 *                                      LINE of a band is its fill
 *     S STYLE,GLYPH X,Y                a mark by its glyph: a dot, ring, cross or piece of a cell; of U+2502
 *                                      a rule over all rows
 *     M COLUMNS,ROWS STYLES            colours across the area, row by row from above: the character '@' +
 *                                      Style, '.' nothing, each followed by how often where that is not once
 *
 * Without memory something is left out. */
void canvas_vector(Canvas *, const char *format, ...) __attribute__((format(printf, 2, 3)));
void canvas_mark(Canvas *, double x, double y, uint32_t glyph, Style); /* 'S', in cells */

/* Outside the canvas: nothing. What cannot be shown in cells (glyph_shown) becomes ' ' or '?'; of a wide
 * character that is cut or half overwritten nothing is left. */
void canvas_put(Canvas *, int x, int y, uint32_t glyph, Style);

/* Writes UTF-8 from (x, y), cut at `width` columns with an ellipsis as the last; of a number that does not
 * fit nothing is left. Returns the columns used. */
int canvas_text(Canvas *, int x, int y, int width, const char *text, Style);

/* The grid as UTF-8, a line a row, trailing spaces cut; for tests and scripts. malloc'ed; NULL: no memory. */
char *canvas_dump(const Canvas *);
/* Likewise the styles, one letter per cell. */
char *canvas_dump_styles(const Canvas *);

/* Replaces what is not ASCII, one column for one column, for terminals without UTF-8; a character without
 * substitute becomes '?' or, where letters stay, remains. */
void canvas_to_ascii(Canvas *, bool letters_stay);

/* --- a part of it --------------------------------------------------------------------------------- */

typedef struct Area {
    Canvas *canvas;
    Rect rect;
    Glyphs glyphs;
} Area;

/* The part of an area; cut where it would leave it. */
Area area_part(Area, int x, int y, int width, int height);

void area_put(Area, int x, int y, uint32_t glyph, Style);
const Cell *area_cell(Area, int x, int y);                                 /* in it */
void area_put_back(Area, int x, int y, uint32_t glyph, Style, Style back); /* on a coloured background */

/* Writes from (x, y) to the right edge at most, an ellipsis where it is cut. Returns the columns used. */
int area_text(Area, int x, int y, const char *text, Style);
int area_print(Area, int x, int y, Style, const char *format, ...) __attribute__((format(printf, 5, 6)));

/* Writes so that the text ends before column `end`; from the left edge on if it is too long. */
void area_text_right(Area, int end, int y, const char *text, Style);

/* Writes only if the whole text fits into `width` columns; returns the columns used, 0 if it was left out. */
int area_text_whole(Area, int x, int y, int width, const char *text, Style);

/* Breaks a text into lines at spaces; returns the lines used, at most `rows`. */
int area_paragraph(Area, int x, int y, int width, int rows, const char *text, Style);
int area_paragraph_lines(int width, const char *text);

/* Draws phrases separated by two spaces, each whole, on up to `rows` lines; returns the lines used. */
int area_phrases(Area, int x, int y, int width, int rows, const char *text, Style);
int area_rows_of_phrases(const char *text, int width); /* that it takes; INT_MAX: one has no room */

/* A bar that is in a cell, so much of it; at 0 as low as a bar can be. */
uint32_t area_bar(Area, double share);

/* Blanks from column `from` to end - 1. */
void area_blank(Area, int from, int end, int y, Style);

/* A horizontal line with a heading in it, in the first row. */
void area_rule(Area, const char *heading, Style heading_style);

#endif
