/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Exact answers at any strain: one particle in one cell, and a bar that hangs at rest.
 *
 * One particle in one cell, between a node that is held and one that is free: the smallest bar of the
 * material point method, and an oscillator whose motion is known at any amplitude.
 *
 * With the strain w = stress/E and the hat's slopes +-1/dx,
 *
 *     w' = v/dx        v' = -(c^2/dx) w e^w        x = x0 e^w        c^2 = E/rho
 *
 * (e^w is the volume over that at the start.) Units: any consistent system. */
#ifndef THEORY_LARGE_STRAIN_H
#define THEORY_LARGE_STRAIN_H

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

/* A bar that hangs from its left end at rest, exact at any strain where stress = E ln(stretch) and the
 * section stays as it is: at the place X of the bar without load hangs the weight rho b (L - X) below it.
 * Units: any consistent system. */

typedef struct HangingColumn {
    double length, youngs_modulus, density, body_force;
} HangingColumn;

double hanging_column_stress(const HangingColumn *, double x);       /* rho b (L - X) */
double hanging_column_displacement(const HangingColumn *, double x); /* at a place of the bar without load */
double hanging_column_linear(const HangingColumn *, double x);       /* for small strains, k (L X - X^2/2) */
double hanging_column_centre(const HangingColumn *);                 /* where the centre of mass hangs */

#endif
