/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lines of a CSV table: numbers as the shortest text that reads back to the same double, LF, no quotes. */
#ifndef LAB_CSV_H
#define LAB_CSV_H

#include "lab/export/export.h"

#include <stddef.h>
#include <stdio.h>

/* A number that is not known (NAN) leaves its cell empty. */
void csv_header(FILE *, Dialect, const char *const *names, int count);
void csv_row(FILE *, Dialect, const double *row, int count);

#endif
