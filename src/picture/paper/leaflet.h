/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pages of plain text on A4 paper, as PDF: what a teacher hands out and gives back. Lines are broken at words
 * and pages at lines. The same text gives the same bytes. */
#ifndef PICTURE_PAPER_LEAFLET_H
#define PICTURE_PAPER_LEAFLET_H

#include "base/output.h"

#include <stdbool.h>

typedef struct Paper Paper;

typedef enum LeafletStyle { LEAFLET_TITLE, LEAFLET_HEADING, LEAFLET_TEXT, LEAFLET_SMALL } LeafletStyle;

typedef struct Leaflet {
    OutputFile file;
    Paper *paper;
    double y;  /* where the next line goes, points */
    bool used; /* something stands on the page */
} Leaflet;

/* Whether a leaflet can be begun: its name ends in .pdf, there is cairo, and output_may_begin(). */
bool leaflet_allowed(const char *file, Asker, bool force, Status *);

bool leaflet_open(Leaflet *, Asker, const char *file, bool force, const char *title, Status *);

/* What follows begins a page, unless this one is empty. */
void leaflet_page(Leaflet *);

/* A paragraph. */
void leaflet_line(Leaflet *, LeafletStyle, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Lines to be written on by hand. */
void leaflet_lines(Leaflet *, int count);

/* Gives the file its name. */
bool leaflet_finish(Leaflet *, Status *);

/* Takes back what was not finished; also one that was not opened. */
void leaflet_close(Leaflet *);

#endif
