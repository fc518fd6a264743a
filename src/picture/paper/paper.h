/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What figures are drawn on: lines, areas, discs and words, in points (1/72 inch) from the upper left corner,
 * y downwards. One interface, a back end for each kind of file: SVG is written here, with its words as text;
 * PDF and PNG come through cairo. The same calls give the same bytes. Private to src/picture/paper. */
#ifndef PICTURE_PAPER_PAPER_H
#define PICTURE_PAPER_PAPER_H

#include "base/status.h"

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
    void (*page)(Paper *); /* the next one, of a PDF; NULL: there is one only */
    bool (*finish)(Paper *, Status *);
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

/* Ends the file and frees the paper. */
bool paper_finish(Paper *, Status *);

#endif
