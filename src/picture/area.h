/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A part of the canvas with its own origin: what is drawn on it never leaves it. */
#ifndef PICTURE_AREA_H
#define PICTURE_AREA_H

#include "picture/canvas.h"

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

/* Draws phrases that are parted by two spaces, each whole, on as many lines as it takes up to `rows`. Returns
 * the lines used. */
int area_phrases(Area, int x, int y, int width, int rows, const char *text, Style);
int area_rows_of_phrases(const char *text, int width); /* that it takes; INT_MAX: one has no room */

/* A bar that is in a cell, so much of it; at 0 as low as a bar can be. */
uint32_t area_bar(Area, double share);

/* A horizontal line with a heading in it. */
void area_rule(Area, int y, const char *heading, Style heading_style);

#endif
