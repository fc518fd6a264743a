/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the two runs of a duel come to, in a table of two columns: the keys that differ first, then what each
 * is judged by, what matters most first. */
#ifndef ANSWERS_COMPARISON_H
#define ANSWERS_COMPARISON_H

#include "run/duel.h"

enum { COMPARISONS_MAX = DUEL_MAX + 24, COMPARISON_TEXT_MAX = 28 };

typedef struct Comparison {
    char label[COMPARISON_TEXT_MAX + 16]; /* with its unit: "T measured, ms" */
    char values[2][COMPARISON_TEXT_MAX];  /* of A and B; "-" where one has none */
    ColumnKind kind;                      /* a number of theory can be hidden from a class that is to guess */
} Comparison;

/* At the present step of each, which stand between steps. Rows that neither run has are left out. Returns how
 * many there are; 0: there is no duel. */
int comparison_of_duel(const Duel *, Comparison rows[COMPARISONS_MAX]);

#endif
