/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What figures are drawn on: lines, areas, discs and words, in points (1/72 inch) from the upper left corner,
 * y downwards. One interface, a back end for each kind of file: SVG is written here, with its words as text;
 * PDF and PNG come through cairo. The same calls give the same bytes. Private to src/picture/paper. */
#ifndef PICTURE_PAPER_PAPER_H
#define PICTURE_PAPER_PAPER_H

#include "base/status.h"
#include "picture/picture.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

typedef uint32_t Colour; /* 0xrrggbb */

typedef struct Box {
    double x, y, width, height;
} Box;

typedef struct Pencil {
    Colour colour;
    double width;
    double dashes[4]; /* lengths on, off, on, off; of a solid line the first is 0 */
    bool round;       /* ends; a dash of almost no length is a dot then */
} Pencil;

typedef enum Align { ALIGN_LEFT, ALIGN_CENTRE, ALIGN_RIGHT } Align;

typedef struct Type {
    double size;
    bool bold;
    Colour colour;
    Align align;
    bool upwards; /* turned by a quarter, read from below */
} Type;

typedef struct Paper Paper;

typedef struct PaperKind {
    void (*line)(Paper *, const double *points, size_t count, const Pencil *); /* through x, y, x, y, ... */
    void (*fill)(Paper *, const double *points, size_t count, Colour);         /* a closed area */
    void (*disc)(Paper *, double x, double y, double radius, Colour, const Pencil *edge); /* edge: or NULL */
    void (*text)(Paper *, double x, double y, const char *, const Type *); /* (x, y): on the base line */
    void (*clip)(Paper *, const Box *);                                    /* NULL: no more */
    void (*page)(Paper *);             /* the next one, of a PDF; NULL: there is one only */
    bool (*finish)(Paper *, Status *); /* ends the file and frees the paper */
} PaperKind;

/* A back end's own struct begins with it. */
struct Paper {
    const PaperKind *kind;
    FILE *stream;
};

/* NULL: no memory, the status says so. `title` is for the file's own description. */
Paper *paper_svg(FILE *, double width, double height, const char *title, Status *);
Paper *paper_pdf(FILE *, double width, double height, const char *title, Status *);
Paper *paper_png(FILE *, double width, double height, Status *);

/* --- how the styles of the screen look on white paper --------------------------------------------- */

#define BLACK 0x000000u
#define WHITE 0xffffffu
#define GREY  0x5f5f5fu /* words that explain */
#define GRID  0xe4e4e4u

Colour ink_of(Style);

/* Whether it is that of an earlier run behind. */
bool ink_is_ghost(Style);

/* The line of a stroke or of a legend's entry. Earlier runs have dashes of their own, by their letter. */
Pencil ink_pencil(Style, LineStyle, char letter);

/* draw_plot.c: that of a stroke, by the legend's entry if it is of an earlier run. */
Pencil draw_pencil(const Picture *, int stroke);

Colour ink_pale(Colour); /* halfway to white */

/* A band: the denser it is filled on screen, the darker. */
Colour ink_fill(Style, int fill);

/* Of a heat map: share 0 to 1 of its range. Light is little; of a signed field white is zero. */
Colour ink_heat(double share, bool is_signed);

/* Words with the powers of ten and squares of a printed text: "x10^-3" as a times sign and raised digits. */
void ink_words(const char *text, char *out, size_t size);

/* --- the parts of a page, each drawn into a box --------------------------------------------------- */

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

/* The colours of a map with their values, from the top of the box on. These return the height that they
 * take; paper NULL: they only measure it. */
double draw_heat_bar(Paper *, const Picture *, Box);

/* The legend, in as many rows as it takes. */
double draw_legend_rows(Paper *, const Picture *, Box);

/* Phrases that are separated by two spaces, wrapped. */
double draw_phrases(Paper *, const char *text, Box, const Type *);

/* Heading, notes and tables of a picture that has them. */
void draw_tables(Paper *, const Picture *, Box);

/* One line of words, its base line at y; and how wide it is. */
void draw_words(Paper *, double x, double y, const char *text, const Type *);
double draw_words_width(const char *text, const Type *);

#endif
