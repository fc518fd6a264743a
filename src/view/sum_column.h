/* Columns of numbers that add up as they are printed: whoever adds the printed terms gets the printed sum. */
#ifndef VIEW_SUM_COLUMN_H
#define VIEW_SUM_COLUMN_H

#include "view/area.h"

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

/* Writes a number of the column so that the points stand under each other; it ends before column `end`. */
void write_number(Area, int end, int y, double value, Writing, int decimals, Style);

#endif
