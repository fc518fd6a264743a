/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The directions in which a stress has no shear, by Mohr's circle: its middle is the mean stress, its radius
 *
 *     r = sqrt(((sxx - syy)/2)^2 + sxy^2),   tan 2a = 2 sxy/(sxx - syy) */
#include "answers/stress.h"

#include "base/math/functions.h"

Principal stress_principal(double xx, double yy, double xy)
{
    const double mean = (xx + yy) / 2, half = (xx - yy) / 2, radius = math_hypot(half, xy);
    return (Principal){mean + radius, mean - radius, math_atan2(xy, half) / 2};
}
