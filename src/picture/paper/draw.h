/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parts of a page, each drawn into a box. Private to src/picture/paper. */
#ifndef PICTURE_PAPER_DRAW_H
#define PICTURE_PAPER_DRAW_H

#include "picture/paper/ink.h"

#define SIZE_TITLE 11.0
#define SIZE_WORDS 8.0
#define SIZE_TICKS 7.5
#define SIZE_SMALL 6.5
enum { FIGURE_WORDS_MAX = 640 };

#define LINE_HEIGHT 1.35 /* in sizes */

/* Axes, curves, marks; or a map with its lines and signs. */
void draw_plot(Paper *, const Picture *, Box);

/* The height at which a map of that width is drawn to its scale; 0: it is a plot, and any will do. */
double draw_plot_height(const Picture *, double width);

/* A place of the plot in points: x0 + scale_x x, y0 + scale_y y. */
typedef struct Place {
    double x0, scale_x, y0, scale_y;
    Box seen;
} Place;

void draw_heat(Paper *, const PictureMap *, const Place *);

/* The colours of a map with their values, from the top of the box on; returns the height. Paper NULL: it is
 * only measured; so the others. */
double draw_heat_bar(Paper *, const Picture *, Box);

/* The legend, in as many rows as it takes from the top of the box on; returns their height. Paper NULL: it is
 * only measured. */
double draw_legend_rows(Paper *, const Picture *, Box);

/* Phrases that are parted by two spaces, wrapped, from the top of the box on; returns their height. Paper
 * NULL: likewise. */
double draw_phrases(Paper *, const char *text, Box, const Type *);

/* Heading, notes and tables of a picture that has them. */
void draw_tables(Paper *, const Picture *, Box);

/* One line of words, its base line at y; and how wide it is. */
void draw_words(Paper *, double x, double y, const char *text, const Type *);
double draw_words_width(const char *text, const Type *);

#endif
