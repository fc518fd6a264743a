/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A foreign series, a student's or an experiment's, to be drawn over the curves of a run: a table of numbers
 * read from a CSV file of any origin.
 *
 * Comma, semicolon, tab or blanks between the cells (found from the first line), decimal comma where the
 * comma is free, names in the first line, in a comment (#) above the first row, or none, any line ends, a
 * byte order mark, quoted cells, lines of comment (#) and empty lines. An empty cell, NaN or NA is a value
 * that is missing. Anything else that is not a number is refused with file and line. */
#ifndef RUN_OVERLAY_H
#define RUN_OVERLAY_H

#include "base/status.h"

#include <stddef.h>
#include <stdio.h>

enum {
    OVERLAY_NAME_MAX = 48,     /* bytes of a column's or a file's name, with the final zero */
    OVERLAY_COLUMNS_MAX = 256, /* more is a wrong file */
    OVERLAY_LINE_MAX = 16384,  /* bytes of a line */
    OVERLAY_CELLS_MAX = 64000000
};

#define OVERLAY_BYTES_MAX ((long)(sizeof(long) < 8 ? 2000000000LL : 4000000000LL))

typedef struct OverlayColumn {
    char name[OVERLAY_NAME_MAX]; /* UTF-8; "" without a first line of names */
    double *values;              /* one for each row; NAN: missing */
    double least, largest;       /* of those that are there; NAN: none is */
    int digits, places; /* as written, the most of any: significant ones, and decimals (-2: hundreds) */
} OverlayColumn;

typedef struct Overlay {
    char file[OVERLAY_NAME_MAX]; /* its name without folder */
    OverlayColumn *columns;
    int n_columns;
    size_t count; /* rows; after overlay_choose() ascending in x, and x is never missing */
    int x;        /* the column that the axis of x reads */
    bool along;   /* x is a place along the bar or beam, for profiles; else it is time */
    int y;        /* the column to be drawn with `curve`; -1: with every curve the column of its name */
    char curve[OVERLAY_NAME_MAX];
} Overlay;

/* Receives the share that is read in [0, 1]; false stops the reading. May be NULL. */
typedef bool (*OverlayProgress)(double share, void *context);

/* What a cell stands for that begins with a letter, such as the name of a stage, or is not finite; false: it
 * is read as a number. NULL: so is every cell. */
typedef bool (*OverlayWord)(const char *column, const char *cell, double *value, void *context);

/* Whether a cell is what C, Fortran and Windows print for a number that is not finite: nan, -nan(ind),
 * Infinity, 1.#INF. */
bool overlay_is_not_finite(const char *cell);

/* Reads a table; `file` stands for FILE in an error. False: the status says why, the overlay is empty. */
bool overlay_read(Overlay *, FILE *stream, const char *file, OverlayWord, OverlayProgress, void *context,
                  Status *);
bool overlay_load(Overlay *, const char *path, OverlayProgress, void *context, Status *);
void overlay_close(Overlay *);

/* A column by its name, in any case, or by its number (from 1 on); -1: there is none, and the status says
 * what there is. */
int overlay_column(const Overlay *, const char *name, Status *);

/* Chooses the columns, each by name or by number (from 1 on); NULL: time, or else x or x0, or else the first
 * column; and the column of the curve's name, or else the only other one. `curve` is the name of the series
 * over time that is on screen, `field` that of the field along the bar; "" for what there is not. */
bool overlay_choose(Overlay *, const char *x, const char *y, const char *curve, const char *field, Status *);

/* The column that belongs to a curve (over time, or along the bar); -1: none does. */
int overlay_column_for(const Overlay *, const char *curve, bool along);

/* The last row with x <= a value; `count` if there is none. */
size_t overlay_find(const Overlay *, double x);

#endif
