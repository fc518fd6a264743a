/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The speed of the crack's tip from its places, and Rayleigh's speed to compare it with. In plane stress with
 * nu = 1/3 c_s^2 = G/rho with G = E/(2 (1 + nu)) = 3E/8, and x = (c_R/c_s)^2 solves Rayleigh's equation
 *
 *     x^3 - 8 x^2 + (24 - 16 k) x - 16 (1 - k) = 0,   k = (c_s/c_p)^2 = (1 - nu)/2 = 1/3,
 *
 * whose root between 0 and 1 is 2 - 2/sqrt(3). */
#include "methods/bonds/cracks/crack_speed.h"

#include "base/assertion.h"
#include "base/math/functions.h"

#include <math.h>

double crack_speed_rayleigh(double youngs_modulus, double density)
{
    ASSERT_REAL(youngs_modulus, >, 0);
    ASSERT_REAL(density, >, 0);
    return sqrt(2 - 2 / sqrt(3)) * sqrt(3 * youngs_modulus / (8 * density));
}

double crack_speed_window(double horizon, double youngs_modulus, double density)
{
    ASSERT_REAL(horizon, >, 0);
    return 4 * horizon / crack_speed_rayleigh(youngs_modulus, density);
}

/* The slope of the least-squares line through a_k over k, times 1/dt, of x and of y; then the length of both
 * together:
 *
 *     slope = sum (k - m) a_k / sum (k - m)^2,   m = (n - 1)/2,   sum (k - m)^2 = n (n^2 - 1)/12 */
double crack_speed(const double *x, const double *y, size_t n, double dt)
{
    double sum_x = 0, sum_y = 0;
    const double count = (double)n;
    if (n < 2)
        return 0;
    ASSERT_REAL(dt, >, 0);
    for (size_t k = 0; k < n; k++) {
        const double from_middle = (double)k - (count - 1) / 2;
        sum_x += from_middle * x[k];
        sum_y += from_middle * y[k];
    }
    return math_hypot(sum_x, sum_y) / (count * (count * count - 1) / 12 * dt);
}
