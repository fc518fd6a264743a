/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Columns of numbers that add up as they are printed: who adds the printed terms gets the printed sum. */
#ifndef PICTURE_SUM_COLUMN_H
#define PICTURE_SUM_COLUMN_H

#include "base/text.h"

#include <stdbool.h>
#include <stddef.h>

/* How a column is written: its numbers stand for themselves times 10^exponent. */
typedef struct Writing {
    int exponent;
    int decimals;     /* of the terms */
    int sum_decimals; /* of the sum */
} Writing;

/* For terms that add up to `gain` and, on top of `base`, to base + gain (base 0: to the gain itself), in at
 * most `width` columns. With a base, base and gain are to be written with all decimals, the sum with
 * sum_decimals. */
Writing writing_of(const double *terms, size_t n, double base, double gain, int width);

/* For values that are under each other and are not added: `digits` of the largest one at most, as many as
 * none of them needs left out, in at most `width` columns. What is very small or large has its own exponent
 * in every row. */
typedef struct Format {
    bool exponents;
    int decimals;
} Format;
Format format_of(const double *values, size_t n, int digits, int width);
void format_number(double value, Format, char out[NUMBER_TEXT_MAX]);

/* A number of the column; returns how many columns further left it ends, so that points are aligned. */
int sum_column_number(double value, Writing, int decimals, char out[64]);

#endif
