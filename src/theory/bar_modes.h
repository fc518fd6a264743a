/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The modes of a bar of two materials, exactly.
 *
 * In each material mode n is a sine of wave number k = omega/c, and at the joint velocity and stress are the
 * same on both sides. Written as v = r sin(theta), stress = Z omega r cos(theta), Z = sqrt(E rho), the phase
 * theta grows along a material by omega l/c, and at the joint r changes and theta within its quadrant:
 *
 *     tan(theta_2) = (Z_2/Z_1) tan(theta_1),   r_2^2 = r_1^2 (sin^2 theta_1 + (Z_1/Z_2)^2 cos^2 theta_1)
 *
 * From pi/2 at a free left end, 0 at a fixed one, theta must come to a multiple of pi at a fixed right end
 * and pi/2 beside it at a free one: mode n is where it has grown by beta_n L, as much as in a bar of one
 * material. Fixed-free that is Z_1 cos(k_1 l_1) cos(k_2 l_2) = Z_2 sin(k_1 l_1) sin(k_2 l_2). Theta grows
 * with omega, so that there is one omega for each n. Units: any consistent system. */
#ifndef THEORY_BAR_MODES_H
#define THEORY_BAR_MODES_H

#include "theory/elastic_bar.h"

/* In part i phi = size sin(phase + wave_number (x - from)); the greatest |phi| is 1. */
typedef struct BarMode {
    double frequency; /* radians per unit time, to about 1e-15 of it */
    double joint;
    struct {
        double from, wave_number, phase, size;
    } part[2];
} BarMode;

/* Of a bar with a joint; `growth` of the phase: beta_n L of mode n >= 1 (bar_wave_number). */
BarMode bar_modes_of_two(const BarTheory *, double growth);

double bar_modes_shape(const BarMode *, double x);
double bar_modes_slope(const BarMode *, double x);

/* int rho phi dx / int rho dx */
double bar_modes_mean(const BarTheory *, const BarMode *);

/* int rho phi s dx / int rho phi^2 dx for s = sin(phase + beta x). */
double bar_modes_share(const BarTheory *, const BarMode *, double beta, double phase);

#endif
