/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elementary functions (functions.h): the quick way, a double-double with a bound of its error.
 *
 * Arguments are brought near a place i/64 of a table, t = r - i/64, |t| <= 1/128, where the function is one
 * of the table's numbers and a short series of t. Of a sum T + a + b + ..., T and the next term are
 * double-doubles and the rest, below 2^-14, doubles: their rounding is 2^-67 of the sum. */
#include "base/math/functions.h"

#include "base/math/double_double.h"

#include <stdbool.h>

#include "base/math/tables.inc"

enum { FIRST_EXP = -23, FIRST_LOG = 45 };

static const DoubleDouble pi = {0x1.921fb54442d18p+1, 0x1.1a62633145c07p-53},
                          ln10 = {0x1.26bb1bbb55516p+1, -0x1.f48ad494ea3e9p-53},
                          two_by_root_pi = {0x1.20dd750429b6dp+0, 0x1.1ae3a914fed80p-56};

/* pi/2 in parts of 23 bits and a rest, ln 2 in 42 bits and a rest: whole numbers times a part are exact */
static const double half_pi_parts[] = {0x1.921fb4p+0, 0x1.4442dp-24, 0x1.846988p-48, 0x1.8cc51701b839ap-72},
                    ln2_parts[] = {0x1.62e42fefa3p-1, 0x1.3de6af278ece6p-42};

/* errors of the quick results, of themselves; tests measure less than half of it */
#define ERROR_SINE    0x1p-64
#define ERROR_ANGLE   0x1p-65
#define ERROR_EXP     0x1p-65
#define ERROR_SINH    0x1p-63 /* from 0.34 on */
#define ERROR_EXPM1   0x1p-58 /* and both below */
#define ERROR_ERF     0x1p-64
#define ERROR_LOG     0x1p-67
#define ERROR_ALGEBRA 0x1p-92

/* Whether every number within `error` of a's size from a is rounded to the same double: that one. Where
 * numbers are so small or large that double-doubles lose bits the answer is no, and of NAN too. */
static bool is_settled(DoubleDouble a, double error, double *rounded)
{
    const double size = fabs(a.high), margin = error * size;
    *rounded = a.high + (a.low + margin);
    return size > 0x1p-900 && size < 0x1p1000 && *rounded == a.high + (a.low - margin);
}

/* the nearest whole number, of numbers below 2^51 */
static double nearest(double x)
{
    return (x + 0x1.8p52) - 0x1.8p52;
}

static DoubleDouble exact(double x)
{
    return (DoubleDouble){x, 0};
}

static const DoubleDouble nowhere = {NAN, NAN};

/* --- angles ---------------------------------------------------------------------------------------- */

typedef struct Angle {
    DoubleDouble r; /* x - quadrant pi/2; NAN: not the quick way */
    int quadrant;   /* modulo 4 */
} Angle;

/* r = x - k pi/2, |r| <= pi/4, to k 2^-123, for |x| <= 1e9: k < 2^30, so that k times 23 bits is exact, and x
 * less the first of the products too. */
static Angle reduced(double x)
{
    if (fabs(x) < 0.785)
        return (Angle){exact(x), 0};
    if (!(fabs(x) <= 1e9))
        return (Angle){nowhere, 0};
    const double k = nearest(x * 0.6366197723675814);
    const DoubleDouble a = dd_sum(x - k * half_pi_parts[0], -k * half_pi_parts[1]),
                       b = dd_sum(a.high, -k * half_pi_parts[2]);
    const DoubleDouble r = dd_sum(b.high, a.low + (b.low - k * half_pi_parts[3]));
    return (Angle){fabs(r.high) > 0x1p-56 * fabs(k) ? r : nowhere, (int)((long)k & 3)};
}

/* sin (or, a turn on, cos) of r = i/64 + t + r_low, A = sin i/64 and B = cos i/64 (cos and -sin):
 *
 *     A cos t + B sin t = A + B t + (A (cos t - 1) + B (sin t - t)) */
static DoubleDouble sine(Angle angle, int turns)
{
    const int quadrant = (angle.quadrant + turns) & 3;
    const double sign = angle.r.high < 0 ? -1 : 1, r = sign * angle.r.high, r_low = sign * angle.r.low;
    if (!(r < 0.79))
        return nowhere;
    const double i = nearest(64 * r), t = r - i / 64, square = t * t;
    const double less = square * (-1.0 / 2 + square * (1.0 / 24 - square / 720)) - r_low * t;
    const double more = t * square * (-1.0 / 6 + square * (1.0 / 120 - square / 5040)) + r_low * (1 + less);
    const bool turned = quadrant & 1;
    const DoubleDouble a = turned ? table_cos[(int)i] : table_sin[(int)i],
                       b = turned ? dd_negative(table_sin[(int)i]) : table_cos[(int)i];
    const DoubleDouble step = dd_product(b.high, t), sum = dd_sum(a.high, step.high);
    const double rest = sum.low + (step.low + (a.low + b.low * t) + (b.high * more + a.high * less));
    const DoubleDouble value = dd_sum_quick(sum.high, rest);
    return (quadrant & 2 ? -1 : 1) * (turned ? 1 : sign) < 0 ? dd_negative(value) : value;
}

double math_sin(double x)
{
    double rounded;
    if (!isfinite(x) || x == 0)
        return isnan(x) ? x : x == 0 ? x : NAN;
    return is_settled(sine(reduced(x), 0), ERROR_SINE, &rounded) ? rounded : accurate_sin(x);
}

double math_cos(double x)
{
    double rounded;
    if (!isfinite(x))
        return NAN;
    return is_settled(sine(reduced(x), 1), ERROR_SINE, &rounded) ? rounded : accurate_cos(x);
}

/* the angle of (x, y), both > 0: atan(y/x) = atan(i/64) + atan z, z = (y - x i/64)/(x + y i/64), y <= x */
static DoubleDouble angle_of(DoubleDouble y, DoubleDouble x)
{
    const bool over = y.high > x.high;
    const DoubleDouble small = over ? x : y, large = over ? y : x;
    const double i = nearest(64 * (small.high / large.high)), place = i / 64;
    const DoubleDouble z = dd_divide(dd_add(small, dd_multiply(large, exact(-place))),
                                     dd_add(large, dd_multiply(small, exact(place))));
    const double square = z.high * z.high;
    const double series = z.high * square * (-1.0 / 3 + square * (1.0 / 5 - square * (1.0 / 7 - square / 9)));
    const DoubleDouble at = !isnan(i) ? table_atan[(int)i] : nowhere, sum = dd_sum(at.high, z.high);
    const DoubleDouble value = dd_sum_quick(sum.high, sum.low + ((z.low + at.low) + series));
    return over ? dd_add(dd_scaled(pi, 0.5), dd_negative(value)) : value;
}

double math_atan2(double y, double x)
{
    if (isnan(x) || isnan(y))
        return NAN;
    if (isinf(x) && isinf(y))
        y = copysign(1, y), x = copysign(1, x);
    if (y == 0 || isinf(x))
        return copysign(signbit(x) ? pi.high : 0, y);
    if (x == 0 || isinf(y))
        return copysign(pi.high / 2, y);

    /* scaled to where products neither over- nor underflow; what is 2^900 less than the other counts as 0 */
    int of_y, of_x;
    const double up = frexp(fabs(y), &of_y), along = frexp(fabs(x), &of_x);
    const int least = -900, apart = of_y - of_x;
    if (apart < least && x > 0)
        return accurate_atan2(y, x, 0);
    DoubleDouble angle = angle_of(exact(apart < least ? 0
                                        : apart > 0   ? up
                                                      : ldexp(up, apart)),
                                  exact(-apart < least ? 0
                                        : apart > 0    ? ldexp(along, -apart)
                                                       : along));
    if (x < 0)
        angle = dd_add(pi, dd_negative(angle));
    if (y < 0)
        angle = dd_negative(angle);
    double rounded;
    return is_settled(angle, ERROR_ANGLE, &rounded) ? rounded : accurate_atan2(y, x, angle.high);
}

double math_atan(double x)
{
    return math_atan2(x, 1);
}

/* sqrt((1 - x) (1 + x)) */
static DoubleDouble other_leg(double x)
{
    return dd_root(dd_multiply(dd_sum(1, -x), dd_sum(1, x)));
}

double math_asin(double x)
{
    if (!(fabs(x) < 1) || x == 0)
        return x == 0 ? x : fabs(x) == 1 ? copysign(pi.high / 2, x) : NAN;
    DoubleDouble angle = angle_of(exact(fabs(x)), other_leg(x));
    if (x < 0)
        angle = dd_negative(angle);
    double rounded;
    return is_settled(angle, ERROR_ANGLE, &rounded) ? rounded : accurate_asin(x, angle.high);
}

double math_acos(double x)
{
    if (!(fabs(x) < 1))
        return x == 1 ? 0 : x == -1 ? pi.high : NAN;
    DoubleDouble angle = angle_of(other_leg(x), exact(fabs(x)));
    if (x < 0)
        angle = dd_add(pi, dd_negative(angle));
    double rounded;
    return is_settled(angle, ERROR_ANGLE, &rounded) ? rounded : accurate_acos(x, angle.high);
}

/* --- exponentials ---------------------------------------------------------------------------------- */

typedef struct Power {
    DoubleDouble place, more; /* e^r = place + more, place = e^(i/64) */
    int exponent;             /* e^a = 2^exponent e^r */
} Power;

/* r = a - k ln 2 = i/64 + t, more = place (e^t - 1), e^t - 1 = t + t^2/2 + ...; |a| < 690. To 2^-66 of
 * place; and of a place 1 to 2^-60 of `more`, since it is t that is kept without loss. */
static Power power_of(DoubleDouble a)
{
    if (!(fabs(a.high) < 690))
        return (Power){nowhere, nowhere, 0};
    const double k = nearest(a.high * 1.4426950408889634);
    const DoubleDouble b = dd_sum(a.high, -k * ln2_parts[0]),
                       r = dd_sum(b.high, (b.low + a.low) - k * ln2_parts[1]);
    const double i = nearest(64 * r.high);
    const double t = r.high - i / 64;
    const double higher =
        1.0 / 2 + t * (1.0 / 6 + t * (1.0 / 24 + t * (1.0 / 120 + t * (1.0 / 720 + t / 5040))));
    const double rest = r.low * (1 + t) + t * t * higher;
    const DoubleDouble place = table_exp[(int)i - FIRST_EXP], step = dd_product(place.high, t);
    return (Power){place, dd_sum_quick(step.high, step.low + (place.high * rest + place.low * t)), (int)k};
}

static DoubleDouble exponential(DoubleDouble a)
{
    const Power power = power_of(a);
    return dd_scaled(dd_add(power.place, power.more), ldexp(1, power.exponent));
}

/* e^x - 1, |x| < 0.34 */
static DoubleDouble small_expm1(double x)
{
    const Power power = power_of(exact(x));
    return dd_add(dd_sum(power.place.high - 1, power.place.low), power.more);
}

double math_exp(double x)
{
    if (!(x < 710 && x > -746))
        return isnan(x) ? x : x > 0 ? INFINITY : 0;
    double rounded;
    return is_settled(exponential(exact(x)), ERROR_EXP, &rounded) ? rounded : accurate_exp(x);
}

double math_expm1(double x)
{
    if (!(x < 710 && x > -40) || x == 0)
        return isnan(x) || x == 0 ? x : x > 0 ? INFINITY : -1;
    double rounded;
    const DoubleDouble value = fabs(x) < 0.34 ? small_expm1(x) : dd_add(exponential(exact(x)), exact(-1));
    return is_settled(value, ERROR_EXPM1, &rounded) ? rounded : accurate_expm1(x);
}

/* twice sinh and cosh: e + e/(1 + e) with e = e^x - 1 where e^x - e^-x cancels; x > 0 */
static DoubleDouble double_sinh(double x)
{
    const DoubleDouble e = x < 0.34 ? small_expm1(x) : exponential(exact(x));
    return dd_add(e, x < 0.34 ? dd_divide(e, dd_add(exact(1), e)) : dd_negative(dd_divide(exact(1), e)));
}

static DoubleDouble double_cosh(double x)
{
    const DoubleDouble e = exponential(exact(x));
    return dd_add(e, dd_divide(exact(1), e));
}

double math_sinh(double x)
{
    if (!(fabs(x) < 711) || x == 0)
        return isnan(x) || x == 0 ? x : copysign(INFINITY, x);
    double rounded;
    const double error = fabs(x) < 0.34 ? ERROR_EXPM1 : ERROR_SINH;
    const DoubleDouble value = dd_scaled(double_sinh(fabs(x)), copysign(0.5, x));
    return is_settled(value, error, &rounded) ? rounded : accurate_sinh(x);
}

double math_cosh(double x)
{
    if (!(fabs(x) < 711))
        return isnan(x) ? x : INFINITY;
    double rounded;
    return is_settled(dd_scaled(double_cosh(fabs(x)), 0.5), ERROR_EXP, &rounded) ? rounded : accurate_cosh(x);
}

/* erf x = 2/sqrt(pi) e^(-x^2) x sum (2 x^2)^n/(1 3 5 ... (2 n + 1)), as accurate_erf: all terms are positive.
 * Those left out are below 2^-70 of it. */
static DoubleDouble double_erf(double x)
{
    const DoubleDouble square = dd_product(x, x), twice = dd_scaled(square, 2);
    DoubleDouble term = exact(x), sum = term;
    for (double k = 3; fabs(term.high) > 0x1p-72 * fabs(sum.high); k += 2) {
        term = dd_divide(dd_multiply(term, twice), exact(k));
        sum = dd_add(sum, term);
    }
    return dd_multiply(dd_multiply(two_by_root_pi, exponential(dd_negative(square))), sum);
}

/* beyond 6 it differs from 1 by less than 2^-55 */
double math_erf(double x)
{
    if (!(fabs(x) < 6) || x == 0)
        return isnan(x) || x == 0 ? x : copysign(1, x);
    double rounded;
    return is_settled(double_erf(x), ERROR_ERF, &rounded) ? rounded : accurate_erf(x);
}

/* --- logarithms and powers ------------------------------------------------------------------------- */

/* a = 2^k m, m = i/64 (1 + s)/(1 - s), s = (m - i/64)/(m + i/64), |s| < 2^-7:
 *
 *     log a = k ln 2 + log i/64 + 2 s + 2 s^3/3 + ... */
static DoubleDouble logarithm(DoubleDouble a)
{
    int k;
    double m = frexp(a.high, &k);
    if (m < 0.7071)
        m *= 2, k--;
    const double i = nearest(64 * m), place = i / 64, m_low = ldexp(a.low, -k);
    const DoubleDouble s = dd_divide(dd_sum(m - place, m_low), dd_add(dd_sum(m, place), exact(m_low)));
    const double square = s.high * s.high;
    const double series =
        s.high * square * (2.0 / 3 + square * (2.0 / 5 + square * (2.0 / 7 + square * (2.0 / 9))));
    const DoubleDouble at = table_log[(int)i - FIRST_LOG];
    const DoubleDouble b = dd_sum(k * ln2_parts[0], at.high), sum = dd_sum(b.high, 2 * s.high);
    const double rest = (sum.low + b.low) + (k * ln2_parts[1] + at.low + 2 * s.low + series);
    return dd_sum_quick(sum.high, rest);
}

/* of arguments at which no logarithm of any base is to be computed: it, or NAN for a domain error */
static bool has_limit(double x, double *limit)
{
    *limit = x == 0 ? -INFINITY : x == 1 ? 0 : x > 0 ? x : NAN;
    return !(x > 0) || isinf(x) || x == 1;
}

double math_log(double x)
{
    double rounded;
    if (has_limit(x, &rounded))
        return rounded;
    const DoubleDouble value = logarithm(exact(x));
    return is_settled(value, ERROR_LOG, &rounded) ? rounded : accurate_log(x, value.high);
}

double math_log10(double x)
{
    double rounded;
    if (has_limit(x, &rounded))
        return rounded;
    const DoubleDouble value = logarithm(exact(x));
    return is_settled(dd_divide(value, ln10), ERROR_LOG, &rounded) ? rounded : accurate_log10(x, value.high);
}

double math_log1p(double x)
{
    double rounded;
    if (x == 0)
        return x;
    if (has_limit(1 + x, &rounded) && rounded != 0)
        return rounded;
    const DoubleDouble value = logarithm(dd_sum(1, x));
    return is_settled(value, ERROR_LOG, &rounded) ? rounded : accurate_log1p(x, value.high);
}

/* x > 0, neither 0 nor 1 nor infinite, and y neither 0 nor infinite */
static double positive_power(double x, double y)
{
    double rounded;
    /* what equations are full of; the square has all its digits */
    const DoubleDouble square = dd_product(x, x);
    if ((y == 2 || y == 4) &&
        is_settled(y == 2 ? square : dd_multiply(square, square), ERROR_ALGEBRA, &rounded))
        return rounded;
    const DoubleDouble log_x = logarithm(exact(x));
    if (fabs(y * log_x.high) > 800 || fabs(y) < 0x1p-100)
        return fabs(y) < 0x1p-100 ? 1 : (y > 0) == (log_x.high > 0) ? INFINITY : 0;
    const DoubleDouble wanted = dd_multiply(exact(y), log_x);
    const double error = ERROR_EXP + ERROR_LOG * fabs(wanted.high);
    return is_settled(exponential(wanted), error, &rounded) ? rounded : accurate_pow(x, y, log_x.high);
}

double math_pow(double x, double y)
{
    if (y == 0 || x == 1)
        return 1;
    if (isnan(x) || isnan(y))
        return NAN;
    const bool whole = floor(y) == y, odd = whole && fabs(fmod(y, 2)) == 1;
    const double size = fabs(x), sign = odd && signbit(x) ? -1 : 1;
    if (isinf(y))
        return size == 1 ? 1 : (size > 1) == (y > 0) ? INFINITY : 0;
    if (x == 0 || isinf(x))
        return sign * ((x == 0) == (y < 0) ? INFINITY : 0);
    if (x < 0 && !whole)
        return NAN;
    return sign * (size == 1 ? 1 : positive_power(size, y));
}

double math_hypot(double x, double y)
{
    if (isinf(x) || isinf(y))
        return INFINITY;
    const double large = fmax(fabs(x), fabs(y)), small = fmin(fabs(x), fabs(y));
    if (isnan(x) || isnan(y))
        return NAN;
    if (small <= large * 0x1p-60)
        return large;
    double rounded;
    if (large < 0x1p400 && small > 0x1p-400 &&
        is_settled(dd_root(dd_add(dd_product(x, x), dd_product(y, y))), ERROR_ALGEBRA, &rounded))
        return rounded;
    return accurate_hypot(x, y);
}

/* GSL calls functions by these names (hypot in every QR factor and eigenvalue, pow for the size of a step,
 * cos for Gauss' points, sin, cos, log and exp in Ci, J0, J1 and Student's t), and what it finds enters
 * columns and answers: the program's own definitions stand before the C library's. */
#define FOR_LIBRARIES(name)                                                                                  \
    double name(double x)                                                                                    \
    {                                                                                                        \
        return math_##name(x);                                                                               \
    }
#define FOR_LIBRARIES_OF_TWO(name)                                                                           \
    double name(double x, double y)                                                                          \
    {                                                                                                        \
        return math_##name(x, y);                                                                            \
    }
FOR_LIBRARIES(sin)
FOR_LIBRARIES(cos)
FOR_LIBRARIES(asin)
FOR_LIBRARIES(acos)
FOR_LIBRARIES(atan)
FOR_LIBRARIES(sinh)
FOR_LIBRARIES(cosh)
FOR_LIBRARIES(exp)
FOR_LIBRARIES(expm1)
FOR_LIBRARIES(log)
FOR_LIBRARIES(log1p)
FOR_LIBRARIES_OF_TWO(atan2)
FOR_LIBRARIES_OF_TWO(pow)
FOR_LIBRARIES_OF_TWO(hypot)

#ifdef __GLIBC__
void sincos(double x, double *sine, double *cosine)
{
    *sine = math_sin(x);
    *cosine = math_cos(x);
}
#endif
