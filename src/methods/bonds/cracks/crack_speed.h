/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How fast a crack runs, beside how fast it can: no crack that is pulled open outruns the surface wave of its
 * own edges (Rayleigh's). SI units. */
#ifndef METHODS_BONDS_CRACKS_CRACK_SPEED_H
#define METHODS_BONDS_CRACKS_CRACK_SPEED_H

#include <stddef.h>

/* Rayleigh's speed in plane stress with Poisson's ratio 1/3, where its equation has a root in closed form:
 * c_R/c_s = sqrt(2 - 2/sqrt(3)), c_s = sqrt(3 E/(8 rho)). m/s. */
double crack_speed_rayleigh(double youngs_modulus, double density);

/* The time over which a crack's speed is taken: 4 horizons at Rayleigh's speed, s. The tip moves in jumps of
 * a spacing: over a shorter time its speed would exceed Rayleigh's, over twice as long the peak loses a
 * twentieth. */
double crack_speed_window(double horizon, double youngs_modulus, double density);

/* The speed of a tip from its places (x, y) at n times dt apart, oldest first: the slopes of the straight
 * lines (least squares) through x and through y over time, put together. It belongs to the middle of these
 * times. 0: fewer than two places. */
double crack_speed(const double *x, const double *y, size_t n, double dt);

#endif
