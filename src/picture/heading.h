/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Legends and the heading line of a plot. */
#ifndef PICTURE_HEADING_H
#define PICTURE_HEADING_H

#include "picture/area.h"
#include "picture/plot.h"

/* One entry of a legend. */
typedef struct Legend {
    LineStyle line;
    char letter;
    Style style;
    const char *name;
    const char *key; /* what stands for it, 2 columns; NULL: a piece of the line */
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
int heading_draw(Area, Style heading, const char *name, const char *scale, const Legend *, int n_legend,
                 bool goes_on);

/* Writes a hint into a heading line, up to column `end`; false: there is no room behind column `begin`. */
bool heading_hint(Area, int begin, int end, const char *hint);

#endif
