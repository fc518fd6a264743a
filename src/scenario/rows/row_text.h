/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The line of one row; for the files of this folder. `about` is the row's key, for messages. */
#ifndef SCENARIO_ROWS_ROW_TEXT_H
#define SCENARIO_ROWS_ROW_TEXT_H

#include "scenario/rows/rows.h"

/* Reads a whole line, and one value from its word; the name is kept. False: nothing is changed, the status
 * says what is allowed. */
bool row_read(const RowKind *, const char *text, Row *, const char *about, Status *);
bool row_read_value(const RowKind *, int column, const char *word, Row *, const char *about, Status *);

/* The line of a row with so many significant digits; 0: as it takes to read back to the same bits. */
void row_write(const RowKind *, const Row *, int digits, char out[ROW_TEXT_MAX]);

/* What a row has that another one has otherwise: "sy 7e+6 until 1e-5". */
void row_write_difference(const RowKind *, const Row *, const Row *other, char out[ROW_TEXT_MAX]);

/* Of what a place is: "plate", "box". */
const char *row_whole_word(const RowKind *);

bool row_same(const RowKind *, const Row *a, const Row *b);

#endif
