/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The layout of a figure's page, in points. Private to src/picture/paper. */
#ifndef PICTURE_PAPER_PAGE_H
#define PICTURE_PAPER_PAGE_H

#include "picture/paper/figure_file.h"
#include "picture/paper/paper.h"

double page_width(const Figure *);

double page_height(const Figure *); /* as asked for, or as much as it takes */

void page_draw(const Figure *, Paper *);

/* How large one of so many panels is, counted in characters of its labels. */
void page_panel_cells(const Figure *, int panels, int *columns, int *rows);

#endif
