/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the parts of the drawing of a body before it moves have in common: where places are, and how lines,
 * signs and words get into cells or onto paper. Private to src/views/map. Places in columns and rows, whole
 * ones in cells. */
#ifndef VIEW_MAP_DRAWING_H
#define VIEW_MAP_DRAWING_H

#include "views/map/map.h"
#include "picture/picture.h"

enum { DIMENSIONS_MAX = 4 };

/* A length between two places, with its row below the beam. */
typedef struct Dimension {
    double from, to; /* m */
    int row;
} Dimension;

typedef struct Drawing {
    const Settings *settings;
    MapScene scene;
    const Body *body;
    Area area;
    Picture *picture;   /* NULL: it is drawn in cells */
    double low, scale;  /* column = 1 + (x - low) scale */
    double top, bottom; /* rows of the upper and lower edge */
    Dimension lengths[DIMENSIONS_MAX];
    int n_dimensions, dimension_rows;
} Drawing;

Picture *drawing_paper(const Drawing *); /* NULL: it is drawn in cells */
double drawing_column(const Drawing *, double x);
double drawing_row(const Drawing *, double share); /* of the height */

/* Through places on paper; `kind` as in plot.h. */
void drawing_trace(const Drawing *, StrokeKind, Style, int count, const double (*places)[2]);
void drawing_put(const Drawing *, double x, double y, uint32_t glyph, Style);

/* Words that begin (side 1), have their middle (0) or end (-1) at a place; those in the middle break a line.
 * The spaces around them are for cells. */
void drawing_label(const Drawing *, double x, double y, int side, const char *text, Style);

void drawing_rows(const Drawing *); /* what a plate has by rows */

#endif
