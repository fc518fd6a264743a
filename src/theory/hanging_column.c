/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bar at rest under its own weight: with k = rho b/E the strain ln(dx/dX) is k (L - X), so that
 *
 *     x = int e^{k (L - X)} dX = (e^{kL} - e^{k (L - X)})/k
 *     mean of x over the bar   = (e^{kL} - (e^{kL} - 1)/(kL))/k */
#include "theory/hanging_column.h"

#include "base/assertion.h"
#include "base/math/functions.h"

#include <math.h>

static double rate(const HangingColumn *column)
{
    ASSERT_REAL(column->youngs_modulus, >, 0);
    return column->density * column->body_force / column->youngs_modulus;
}

double hanging_column_stress(const HangingColumn *column, double x)
{
    return column->density * column->body_force * (column->length - x);
}

/* The difference of the exponentials without cancelling: e^{k (L - X)} (e^{kX} - 1). */
double hanging_column_displacement(const HangingColumn *column, double x)
{
    const double k = rate(column);
    return k == 0 ? 0 : math_exp(k * (column->length - x)) * math_expm1(k * x) / k - x;
}

double hanging_column_linear(const HangingColumn *column, double x)
{
    return rate(column) * x * (column->length - x / 2);
}

double hanging_column_centre(const HangingColumn *column)
{
    const double k = rate(column), kl = k * column->length;
    if (fabs(kl) < 1e-4) /* by its series, as the closed form cancels */
        return column->length * (0.5 + kl / 3 + kl * kl / 8);
    return (math_exp(kl) - math_expm1(kl) / kl) / k;
}
