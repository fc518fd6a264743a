/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "theory/bar_motion.h"
#include "base/assertion.h"
#include "base/math/functions.h"
#include "theory/gsl_errors.h"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>

struct BarMotion {
    int count;
    double *frequency, *share; /* v_cm = sum share cos(frequency step dt) */
    double dt;
};

/* y^n = exp(i Omega n dt) gives 2 - 2 cos(Omega dt) = (omega dt)^2. */
double bar_motion_frequency(double omega, double dt)
{
    ASSERT_REAL(dt, >, 0);
    double half = omega * dt / 2;
    return half <= 1 ? 2 * math_asin(half) / dt : NAN;
}

BarMotion *bar_motion_create(int count, double dt)
{
    ASSERT_INT(count, >=, 0);
    BarMotion *motion = calloc(1, sizeof *motion);
    if (!motion)
        return NULL;
    *motion = (BarMotion){count, calloc((size_t)count + 1, sizeof(double)),
                          calloc((size_t)count + 1, sizeof(double)), dt};
    if (motion->frequency && motion->share)
        return motion;
    bar_motion_free(motion);
    return NULL;
}

void bar_motion_free(BarMotion *motion)
{
    if (!motion)
        return;
    free(motion->frequency);
    free(motion->share);
    free(motion);
}

void bar_motion_set(BarMotion *motion, int k, double share, double frequency)
{
    ASSERT_INT(k, <, motion->count);
    motion->share[k] = share;
    motion->frequency[k] = frequency;
}

bool bar_motion_resolve(BarMotion *motion, gsl_matrix *s, const double *start, const double *weights)
{
    ASSERT_INT(s->size1, ==, motion->count);
    ASSERT_INT(s->size2, ==, motion->count);
    static const double rounding = 1e-13; /* of the largest omega^2: such a mode does not move */
    const size_t n = (size_t)motion->count;
    gsl_errors_off();
    gsl_matrix *vectors = gsl_matrix_alloc(n, n);
    gsl_vector *squares = gsl_vector_alloc(n);
    gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc(n);
    bool sound = vectors && squares && work && gsl_can_converge(s) &&
                 gsl_eigen_symmv(s, squares, vectors, work) == GSL_SUCCESS;
    const double largest = sound ? gsl_vector_max(squares) : 0;
    for (size_t k = 0; sound && k < n; k++) {
        double along = 0, mean = 0;
        for (size_t i = 0; i < n; i++) {
            const double part = gsl_matrix_get(vectors, i, k);
            along += part * start[i];
            mean += part * weights[i];
        }
        const double square = gsl_vector_get(squares, k);
        const double frequency =
            bar_motion_frequency(square > rounding * largest ? sqrt(square) : 0, motion->dt);
        sound = isfinite(frequency);
        bar_motion_set(motion, (int)k, along * mean, frequency);
    }
    gsl_eigen_symmv_free(work);
    gsl_vector_free(squares);
    gsl_matrix_free(vectors);
    gsl_errors_on();
    return sound;
}

double bar_motion_centre_velocity(const BarMotion *motion, long step)
{
    ASSERT_INT(step, >=, 0);
    double sum = 0;
    for (int k = 0; k < motion->count; k++)
        sum += motion->frequency[k] == 0
                   ? motion->share[k]
                   : motion->share[k] * math_cos(motion->frequency[k] * (double)step * motion->dt);
    return sum;
}

/* The bar at rest under its own weight: with k = rho b/E the strain ln(dx/dX) is k (L - X), so that
 *
 *     x = int e^{k (L - X)} dX = (e^{kL} - e^{k (L - X)})/k
 *     mean of x over the bar   = (e^{kL} - (e^{kL} - 1)/(kL))/k */

static double rate(const HangingColumn *column)
{
    ASSERT_REAL(column->youngs_modulus, >, 0);
    return column->density * column->body_force / column->youngs_modulus;
}

double bar_column_stress(const HangingColumn *column, double x)
{
    return column->density * column->body_force * (column->length - x);
}

/* The difference of the exponentials without cancelling: e^{k (L - X)} (e^{kX} - 1). */
double bar_column_displacement(const HangingColumn *column, double x)
{
    const double k = rate(column);
    return k == 0 ? 0 : math_exp(k * (column->length - x)) * math_expm1(k * x) / k - x;
}

double bar_column_linear(const HangingColumn *column, double x)
{
    return rate(column) * x * (column->length - x / 2);
}

double bar_column_centre(const HangingColumn *column)
{
    const double k = rate(column), kl = k * column->length;
    if (fabs(kl) < 1e-4) /* by its series, as the closed form cancels */
        return column->length * (0.5 + kl / 3 + kl * kl / 8);
    return (math_exp(kl) - math_expm1(kl) / kl) / k;
}
