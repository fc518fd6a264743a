/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A body in cells: in a pane its field's name stands above it, its colours below. Columns and rows are cells
 * of the part between, a row counted downwards. */
#ifndef PICTURE_CELLS_CELLS_MAP_H
#define PICTURE_CELLS_CELLS_MAP_H

#include "picture/area.h"
#include "picture/picture.h"

void cells_map(const Picture *, Area, Style heading, int colours);
void cells_map_body(const Picture *, Area, int colours); /* without words around it */

/* One that is drawn with its dimensions: places in whole columns, and rows above 0. */
void cells_drawing(const Picture *, Area, Style heading);

/* In cells a factor is told by a letter: the sign for it is wide in some fonts. `out` has room for the text.
 */
void cells_plain_factors(const char *text, char *out);

/* Where a place of the plot is drawn in the part `rect`. */
void cells_place(const PictureMap *, Rect, double x, double y, double *column, double *row);

/* In the pane `rect`: the piece drawn nearest to a cell of the screen, -1: none is near; and the place of the
 * undeformed body in the cell's middle, false: it is outside. */
long cells_map_piece(const Picture *, Rect, int x, int y);
bool cells_map_place(const Picture *, Rect, int x, int y, double place[2]);

#endif
