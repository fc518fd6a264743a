/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Arithmetic written out with its numbers, as on a blackboard: "p13 = 0.5 × (0.2 × 0.3 + 0.4 ×
 * 0.1) = 0.05". The digits are chosen so that what is printed adds up: a reader who works the printed numbers
 * out gets the printed result, to its last digit.
 *
 * UTF-8. No-break spaces (U+00A0) hold a term together; a line may be broken at every other space. */
#ifndef METHODS_CALCULATION_H
#define METHODS_CALCULATION_H

#include "methods/method.h"

enum { CALCULATION_FACTORS_MAX = 3, CALCULATION_TERMS_MAX = 64 };

/* Text that grows to its limit and no further. */
typedef struct Calculation {
    char *out;
    size_t size, used;
    int terms; /* a sum of more terms ends with "+ 0.3 (5 more)"; 0: any number is written out */
} Calculation;

typedef struct CalculationTerm {
    int factors;
    double factor[CALCULATION_FACTORS_MAX];
    double divisor; /* 0: none */
    long to;        /* "0.3 to 12"; -1: nothing */
} CalculationTerm;

/* label [base +] [scale ×] (terms) [/ divisor] = result unit */
typedef struct CalculationSum {
    const char *label;
    bool has_base;
    double base;
    double scale, divisor; /* 0: none */
    int count;
    CalculationTerm terms[CALCULATION_TERMS_MAX];
    double result;
    const char *unit; /* NULL: none */
} CalculationSum;

/* A form of words along an axis, of a thing by its number: "p@# = " is "px = ", along a line "p13 = ", and
 * "gain_@" there "gain". */
typedef struct CalculationLabel {
    char text[120];
} CalculationLabel;
CalculationLabel calculation_label(int dimensions, const char *form, int axis, int number);

void calculation_open(Calculation *, char *out, size_t size, int terms);

/* Words; a number of a few digits after words. */
void calculation_write(Calculation *, const char *format, ...) __attribute__((format(printf, 2, 3)));
void calculation_number(Calculation *, const char *words, double value);
void calculation_value(Calculation *, const char *words, double value); /* and ends the line */

/* Adds a term of one, two or three factors; what goes beyond CALCULATION_TERMS_MAX is put into the last one.
 */
CalculationTerm *calculation_add(CalculationSum *, int factors, double a, double b, double c);

/* Writes the sum and ends the line. */
void calculation_sum(Calculation *, const CalculationSum *);

/* What thing `index` is given by these links in an exchange, a term for each: a first factor that is that of
 * all (mass, time step) before the bracket. Of the sum label, unit and scale are given. Nothing where the
 * numbers are not at hand. */
void calculation_exchange(Calculation *, CalculationSum *, const Simulation *, int exchange, size_t index,
                          const Link *, size_t count);

/* What a stage changed: "label was + factor × rate = now unit", in a line; unit NULL: none. */
void calculation_change(Calculation *, const char *label, double was, double factor, double rate, double now,
                        const char *unit);

/* What stood in a number of the state when it was saved: `state` is the block as it is, `before` the bytes as
 * they were. */
double calculation_before(const void *state, const double *now, const void *before);

#endif
