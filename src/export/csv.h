/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines of a CSV table: numbers as the shortest text that reads back to the same double, LF. */
#ifndef EXPORT_CSV_H
#define EXPORT_CSV_H

#include "export/export.h"

#include <stdio.h>

/* A number that is not known (NAN) leaves its cell empty. */
void csv_header(FILE *, Dialect, const char *const *names, int count);
/* The first cells of a row that goes on: numbers, and a word that needs no quotes (NULL: none). */
void csv_begin(FILE *, Dialect, const double *row, int count, const char *word);
void csv_row(FILE *, Dialect, const double *row, int count);

/* Words, in quotes where they hold a quote, a separator or a line end. A text that a spreadsheet would take
 * for a formula (it begins with = + - @ or a control character, and is not a number) gets an apostrophe in
 * front. */
void csv_words(FILE *, Dialect, const char *const *cells, int count);

#endif
