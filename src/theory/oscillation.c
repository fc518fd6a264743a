/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Frequency and decay of an oscillation from three or four samples at a time, about a quarter of a turn h
 * apart.
 *
 * With a constant beside it, an oscillation obeys y(t + 2h) = s y(t + h) - q y(t) + c, whose roots are
 * exp((-decay +- i omega) h):
 *
 *     s = 2 exp(-decay h) cos(omega h),   q = exp(-2 decay h)
 *
 * Its square, an energy, is E^(t/h) (1 + cos(2 omega t + ...))/2 with E = exp(-2 decay h), and obeys
 * y(t + 3h) = s y(t + 2h) + r y(t + h) + q y(t) with the roots E and E exp(+-2 i omega h):
 *
 *     s = E (1 + 2 cos(2 omega h)),   q = E^3
 *
 * Three unknowns either way, by least squares over the whole record: what has died counts for nothing. */
#include "theory/oscillation.h"

#include "base/assertion.h"
#include "theory/gsl_errors.h"
#include "base/math/functions.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <math.h>

enum { UNKNOWNS = 3 };

/* Minimises sum (x . row - value)^2 by normal equations: a quarter of a turn apart the columns are nearly
 * orthogonal. */
static bool least_squares(const double *values, size_t stride, size_t count, size_t lag, bool squared,
                          double x[UNKNOWNS])
{
    double matrix[UNKNOWNS * UNKNOWNS] = {0};
    for (int i = 0; i < UNKNOWNS; i++)
        x[i] = 0;
    const size_t reach = (squared ? 3 : 2) * lag;
    for (size_t k = 0; k + reach < count; k++) {
        const double *at = values + k * stride;
        const size_t step = lag * stride;
        const double here = at[reach * stride],
                     row[UNKNOWNS] = {squared ? at[2 * step] : at[step], squared ? at[step] : at[0],
                                      squared ? at[0] : 1};
        for (int i = 0; i < UNKNOWNS; i++) {
            x[i] += row[i] * here;
            for (int j = 0; j < UNKNOWNS; j++)
                matrix[UNKNOWNS * i + j] += row[i] * row[j];
        }
    }
    gsl_matrix_view view = gsl_matrix_view_array(matrix, UNKNOWNS, UNKNOWNS);
    gsl_vector_view vector = gsl_vector_view_array(x, UNKNOWNS);
    gsl_errors_off();
    const bool solved = gsl_linalg_cholesky_decomp1(&view.matrix) == GSL_SUCCESS &&
                        gsl_linalg_cholesky_svx(&view.matrix, &vector.vector) == GSL_SUCCESS;
    gsl_errors_on();
    return solved;
}

bool oscillation_fit(const double *values, size_t stride, size_t count, double dt, double frequency,
                     bool squared, Oscillation *out)
{
    ASSERT_INT(stride, >=, 1);
    ASSERT_REAL(dt, >, 0);
    const double turn = 2 * M_PI / (squared ? 2 * frequency : frequency), span = turn / dt;
    if (!(span >= 4 && span < (double)count))
        return false;
    const size_t lag = (size_t)lround(span / 4);
    const double h = (double)lag * dt;
    double x[UNKNOWNS];
    if (!least_squares(values, stride, count, lag, squared, x))
        return false;
    const double kept = squared ? math_pow(x[2], 1.0 / 3) : -x[1]; /* exp(-2 decay h) */
    const double cosine = squared ? (x[0] / kept - 1) / 2 : x[0] / (2 * sqrt(kept));
    if (!(kept > 0 && fabs(cosine) < 1))
        return false;
    *out = (Oscillation){math_acos(cosine) / h / (squared ? 2 : 1), -math_log(kept) / (2 * h)};
    return true;
}

double oscillation_kept(double decay, double frequency)
{
    ASSERT_REAL(frequency, >, 0);
    return math_exp(-2 * decay * 2 * M_PI / frequency);
}
