/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A pencil for sums on screen: works out what is printed, as a student would. */
#ifndef TESTS_SUMS_H
#define TESTS_SUMS_H

#include <stdbool.h>

/* One printed sum: "m13 = 0.5 × (0.2 + 0.3 (2 more)) = 0.25 kg". */
typedef struct PrintedSum {
    char label[64]; /* what stands before the first '=' or ':' */
    double value;   /* what the printed numbers come to */
    double result;  /* what is printed as the result */
    double largest; /* of the printed numbers */
    double last;    /* half of the result's last printed place */
} PrintedSum;

/* Reads the sum of one line, UTF-8, no-break spaces allowed. False: the line is words, not a sum. */
bool read_sum(const char *line, PrintedSum *);

#endif
