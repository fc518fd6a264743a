/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How fast a recorded oscillation dies. */
#ifndef THEORY_OSCILLATION_H
#define THEORY_OSCILLATION_H

#include <stdbool.h>
#include <stddef.h>

typedef struct Oscillation {
    double frequency; /* radians per unit time */
    double decay;     /* amplitude ~ exp(-decay t), 1/time; negative: it grows */
} Oscillation;

/* Of samples dt apart, one every `stride` doubles: offset + a exp(-decay t) cos(frequency t + phase), or, of
 * an energy, the square of such an oscillation (`squared`), which turns twice as fast. `frequency` is about
 * what it is. Exact where there is nothing else in the record. False: less than a period of the samples,
 * fewer than four samples in one of them, or nothing that oscillates. */
bool oscillation_fit(const double *values, size_t stride, size_t count, double dt, double frequency,
                     bool squared, Oscillation *out);

/* The share of the energy that is left after a period of another frequency, to compare oscillations by:
 * exp(-2 decay 2 pi/frequency). */
double oscillation_kept(double decay, double frequency);

#endif
