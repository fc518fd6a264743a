/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One particle in one cell, between a node that is held and one that is free: the smallest bar of the
 * material point method, and an oscillator whose motion is known at any amplitude.
 *
 * With the strain w = stress/E and the hat's slopes +-1/dx,
 *
 *     w' = v/dx        v' = -(c^2/dx) w e^w        x = x0 e^w        c^2 = E/rho
 *
 * (e^w is the volume over that at the start.) Units: any consistent system. */
#ifndef THEORY_OSCILLATOR_H
#define THEORY_OSCILLATOR_H

#include <stdbool.h>

enum { OSCILLATOR_TABLE = 4096 };

typedef struct Oscillator {
    double cell, speed; /* dx, c */
    double velocity;    /* v0, the strain being 0 */
    double period;
    struct {
        double strain, velocity;
    } table[OSCILLATOR_TABLE]; /* at so many equal parts of the period */
} Oscillator;

/* False: the velocity is above the speed of waves; beyond sqrt(2) of it the particle would not come back. */
bool oscillator_make(Oscillator *, double cell, double speed, double velocity);

void oscillator_at(const Oscillator *, double time, double *strain, double *velocity);

/* v^2/2 + c^2 ((w - 1) e^w + 1), which the motion keeps. */
double oscillator_energy(const Oscillator *, double strain, double velocity);

#endif
