/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Double-double arithmetic: a number as the sum of two doubles, the second below half an ulp of the first.
 *
 * Sums without loss after Knuth (The Art of Computer Programming 2, section 4.2.2), products without loss by
 * splitting after Dekker (Numerische Mathematik 18, 1971): + - * / alone, which IEEE 754 rounds in one way,
 * and no fused operation, so that every processor and compiler makes the same bits. Sum and product below are
 * good to 2^-102, quotient and root to 2^-98 of themselves, while nothing over- or underflows: factors stay
 * below 2^990, and what they make above 2^-960. */
#ifndef BASE_MATH_DOUBLE_DOUBLE_H
#define BASE_MATH_DOUBLE_DOUBLE_H

#include <float.h>
#include <math.h>

_Static_assert(FLT_EVAL_METHOD == 0, "doubles have to be computed as doubles: on x86 of 32 bits, "
                                     "configure with CFLAGS='-O2 -msse2 -mfpmath=sse'");

typedef struct DoubleDouble {
    double high, low;
} DoubleDouble;

/* a + b = high + low; of the quick one |a| >= |b| or a = 0 */
static inline DoubleDouble dd_sum_quick(double a, double b)
{
    const double high = a + b;
    return (DoubleDouble){high, b - (high - a)};
}

static inline DoubleDouble dd_sum(double a, double b)
{
    const double high = a + b, of_b = high - a;
    return (DoubleDouble){high, (a - (high - of_b)) + (b - of_b)};
}

/* a = high + low, 26 bits each */
static inline DoubleDouble dd_split(double a)
{
    const double moved = 134217729 * a, high = moved - (moved - a); /* 2^27 + 1 */
    return (DoubleDouble){high, a - high};
}

/* a b = high + low */
static inline DoubleDouble dd_product(double a, double b)
{
    const DoubleDouble u = dd_split(a), v = dd_split(b);
    const double high = a * b;
    return (DoubleDouble){high, ((u.high * v.high - high) + u.high * v.low + u.low * v.high) + u.low * v.low};
}

static inline DoubleDouble dd_add(DoubleDouble a, DoubleDouble b)
{
    const DoubleDouble high = dd_sum(a.high, b.high), low = dd_sum(a.low, b.low);
    const DoubleDouble sum = dd_sum_quick(high.high, high.low + low.high);
    return dd_sum_quick(sum.high, sum.low + low.low);
}

static inline DoubleDouble dd_negative(DoubleDouble a)
{
    return (DoubleDouble){-a.high, -a.low};
}

/* by a power of two: exact */
static inline DoubleDouble dd_scaled(DoubleDouble a, double power)
{
    return (DoubleDouble){a.high * power, a.low * power};
}

static inline DoubleDouble dd_multiply(DoubleDouble a, DoubleDouble b)
{
    const DoubleDouble product = dd_product(a.high, b.high);
    return dd_sum_quick(product.high, product.low + (a.high * b.low + a.low * b.high));
}

/* q1 = a/b rounded, q2 = (a - q1 b)/b, and once more for the last bits */
static inline DoubleDouble dd_divide(DoubleDouble a, DoubleDouble b)
{
    const double first = a.high / b.high;
    const DoubleDouble rest = dd_add(a, dd_negative(dd_multiply((DoubleDouble){first, 0}, b)));
    return dd_sum_quick(first, rest.high / b.high);
}

/* s = sqrt(a) rounded, then (a - s^2)/(2 s) */
static inline DoubleDouble dd_root(DoubleDouble a)
{
    if (a.high <= 0)
        return (DoubleDouble){0, 0};
    const double first = sqrt(a.high);
    const DoubleDouble rest = dd_add(a, dd_negative(dd_product(first, first)));
    return dd_sum_quick(first, rest.high / (2 * first));
}

/* The functions of functions.h to 2^-165 of themselves, hence correctly rounded: by numbers of 192 bits, in
 * some microseconds. For arguments at which the function is finite and no constant.
 *
 * `near` is the result to 2^-40 of itself or better, from which a step of Newton's goes to all bits. */

double accurate_sin(double);
double accurate_cos(double);
double accurate_asin(double, double near);
double accurate_acos(double, double near);
double accurate_atan2(double y, double x, double near);
double accurate_sinh(double);
double accurate_cosh(double);
double accurate_exp(double);
double accurate_expm1(double);
double accurate_log(double, double near);
double accurate_log10(double, double near_log); /* near_log: of the natural one */
double accurate_log1p(double, double near);
double accurate_pow(double x, double y, double near_log); /* x > 0; near_log: of log x */
double accurate_hypot(double x, double y);
double accurate_erf(double);

#endif
