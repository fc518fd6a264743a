/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elementary functions by numbers of 192 bits (accurate.h). Errors are below 2^-180 of the result where
 * nothing else is said; series end when a term is below 2^-200 of the sum. */
#include "base/math/accurate.h"

#include "base/math/wide.h"

#include <math.h>

enum { SERIES_BITS = 200, HALVINGS = 8, WINDOW = 10 };

static const Wide half_pi = {false,
                             1,
                             {0xc90fdaa2, 0x2168c234, 0xc4c6628b, 0x80dc1cd1, 0x29024e08, 0x8a67cc74}},
                  ln2 = {false, 0, {0xb17217f7, 0xd1cf79ab, 0xc9e3b398, 0x03f2f6af, 0x40f34326, 0x7298b62d}},
                  ln10 = {false, 2, {0x935d8ddd, 0xaaa8ac16, 0xea56d62b, 0x82d30a28, 0xe28fecf9, 0xda5df90e}},
                  two_by_root_pi = {
                      false, 1, {0x906eba82, 0x14db688d, 0x71d48a7f, 0x6bfec344, 0x1409a0eb, 0xac3e7517}};

static Wide one(void)
{
    return wide_of(1);
}

/* whether a term still changes the sum */
static bool counts(Wide term, Wide sum)
{
    return !wide_is_zero(term) && term.exponent > sum.exponent - SERIES_BITS;
}

/* --- angles ---------------------------------------------------------------------------------------- */

/* 2/pi, 1280 bits: a double reaches 2^1024 */
static const uint32_t two_by_pi[] = {
    0xa2f9836e, 0x4e441529, 0xfc2757d1, 0xf534ddc0, 0xdb629599, 0x3c439041, 0xfe5163ab, 0xdebbc561,
    0xb7246e3a, 0x424dd2e0, 0x06492eea, 0x09d1921c, 0xfe1deb1c, 0xb129a73e, 0xe88235f5, 0x2ebb4484,
    0xe99c7026, 0xb45f7e41, 0x3991d639, 0x835339f4, 0x9c845f8b, 0xbdf9283b, 0x1ff897ff, 0xde05980f,
    0xef2f118b, 0x5a0a6d1f, 0x6d367ecf, 0x27cb09b7, 0x4f463f66, 0x9e5fea2d, 0x7527bac7, 0xebe5f17b,
    0x3d0739f7, 0x8a5292ea, 0x6bfb5fb1, 0x1f8d5d08, 0x56033046, 0xfc7b6bab, 0xf0cfbc20, 0x9af4361d};

/* x = (quadrant + f) pi/2, |f| <= 1/2, and r = f pi/2 to 2^-170 of itself: no double is nearer to a multiple
 * of pi/2 than 2^-62 of that multiple (J.-M. Muller, Elementary Functions (2006), chapter 9).
 *
 * x = m 2^e with m an integer of 53 bits. Of m 2^e 2/pi only the part below 4 is wanted, so bits of 2/pi that
 * are worth 4 and more when multiplied by 2^e are left out (M. Payne, R. Hanek, SIGNUM Newsletter 18, 1983):
 * a window of 320 bits beginning there, times m, is a fixed-point number with `point` bits behind the point.
 */
static Wide reduced(double x, int *quadrant)
{
    *quadrant = 0;
    if (fabs(x) < 0.785)
        return wide_of(x);
    int e;
    const uint64_t m = (uint64_t)ldexp(frexp(fabs(x), &e), 53);
    e -= 53;
    const int first = e > 2 ? (e - 2) / 32 : 0, point = 32 * (first + WINDOW) - e;
    uint32_t product[WINDOW + 2] = {0};
    const uint32_t factor[2] = {(uint32_t)(m >> 32), (uint32_t)m};
    for (int i = WINDOW - 1; i >= 0; i--) {
        uint64_t carry = 0;
        for (int j = 1; j >= 0; j--) {
            carry += (uint64_t)two_by_pi[first + i] * factor[j] + product[i + j + 1];
            product[i + j + 1] = (uint32_t)carry;
            carry >>= 32;
        }
        product[i] = (uint32_t)carry;
    }

    /* the bits above the point are the quadrant; those below are f, or f + 1, whose digits are turned over
     * then (what 1 differs from all ones is too little) */
    const int place = WINDOW + 1 - point / 32, bit = point % 32, half = point - 1;
    const uint32_t above = product[place] >> bit | (bit == 31 ? product[place - 1] << 1 : 0);
    const bool over = product[WINDOW + 1 - half / 32] >> half % 32 & 1;
    *quadrant = (int)((above + over) & 3);
    for (int i = place; over && i < WINDOW + 2; i++)
        product[i] = ~product[i];
    product[place] &= ((uint32_t)1 << bit) - 1;
    const Wide part = wide_of_digits((x < 0) != over, 32 * (WINDOW + 2 - place) - point, product + place,
                                     WINDOW + 2 - place);
    if (x < 0)
        *quadrant = (4 - *quadrant) & 3;
    return wide_multiply(part, half_pi);
}

/* first - first r^2/(k (k + 1)) + ... : sin from r and k = 2, cos from 1 and k = 1 */
static Wide circular(Wide first, Wide r, uint32_t k)
{
    const Wide square = wide_negative(wide_multiply(r, r));
    Wide sum = first;
    for (Wide term = first; counts(term, sum); k += 2) {
        term = wide_divide_small(wide_multiply(term, square), k * (k + 1));
        sum = wide_add(sum, term);
    }
    return sum;
}

/* sin(x + turns pi/2) */
static Wide sine(double x, int turns)
{
    int quadrant;
    const Wide r = reduced(x, &quadrant);
    quadrant = (quadrant + turns) & 3;
    const Wide value = quadrant & 1 ? circular(one(), r, 1) : circular(r, r, 2);
    return quadrant & 2 ? wide_negative(value) : value;
}

double accurate_sin(double x)
{
    return wide_to_double(sine(x, 0));
}

double accurate_cos(double x)
{
    return wide_to_double(sine(x, 1));
}

double accurate_tan(double x)
{
    return wide_to_double(wide_divide(sine(x, 0), sine(x, 1)));
}

/* the angle of (x, y): near + atan z, z = (y cos near - x sin near)/(x cos near + y sin near), |z| < 2^-40,
 * and z^7/7 is too little. A z^2 that would be lost beside 1 is made larger: the angle is below z, which may
 * lie in the middle of two subnormal numbers. */
static double angle(Wide y, Wide x, double near)
{
    const Wide s = sine(near, 0), c = sine(near, 1);
    const Wide z = wide_divide(wide_subtract(wide_multiply(y, c), wide_multiply(x, s)),
                               wide_add(wide_multiply(x, c), wide_multiply(y, s)));
    const Wide square = z.exponent < -90 ? wide_scaled(one(), -184) : wide_multiply(z, z);
    const Wide after = wide_divide_small(wide_multiply(square, square), 5);
    const Wide series = wide_subtract(one(), wide_subtract(wide_divide_small(square, 3), after));
    return wide_to_double(wide_add(wide_of(near), wide_multiply(z, series)));
}

double accurate_atan2(double y, double x, double near)
{
    return angle(wide_of(y), wide_of(x), near);
}

/* sqrt(1 - x^2) */
static Wide other_leg(double x)
{
    return wide_root(wide_multiply(wide_subtract(one(), wide_of(x)), wide_add(one(), wide_of(x))));
}

double accurate_asin(double x, double near)
{
    return angle(wide_of(x), other_leg(x), near);
}

double accurate_acos(double x, double near)
{
    return angle(other_leg(x), wide_of(x), near);
}

/* --- exponentials ---------------------------------------------------------------------------------- */

/* e^x - 1, |x| < 1, to 2^-180 of itself: t = x/2^8, t + t^2/2 + ..., then 8 times (1 + e)^2 - 1 = e (2 + e)
 */
static Wide small_expm1(Wide x)
{
    const Wide t = wide_scaled(x, -HALVINGS);
    Wide sum = t;
    uint32_t k = 2;
    for (Wide term = t; counts(term, sum); k++) {
        term = wide_divide_small(wide_multiply(term, t), k);
        sum = wide_add(sum, term);
    }
    for (int i = 0; i < HALVINGS; i++)
        sum = wide_multiply(sum, wide_add(sum, wide_of(2)));
    return sum;
}

/* e^x = 2^k e^r, r = x - k ln 2 */
static Wide exponential(Wide x)
{
    const double k = nearbyint(wide_to_double(x) * 1.4426950408889634);
    const Wide r = wide_subtract(x, wide_multiply(wide_of(k), ln2));
    return wide_scaled(wide_add(small_expm1(r), one()), (int)k);
}

static Wide exponential_less_1(Wide x)
{
    return x.exponent < 0 ? small_expm1(x) : wide_subtract(exponential(x), one());
}

double accurate_exp(double x)
{
    return wide_to_double(exponential(wide_of(x)));
}

double accurate_expm1(double x)
{
    return wide_to_double(exponential_less_1(wide_of(x)));
}

/* sinh |x| = (e + e/(1 + e))/2, e = e^|x| - 1 */
double accurate_sinh(double x)
{
    const Wide e = exponential_less_1(wide_of(fabs(x)));
    const double value = wide_to_double(wide_scaled(wide_add(e, wide_divide(e, wide_add(e, one()))), -1));
    return copysign(value, x);
}

double accurate_cosh(double x)
{
    const Wide e = exponential(wide_of(x));
    return wide_to_double(wide_scaled(wide_add(e, wide_divide(one(), e)), -1));
}

/* tanh x = e/(e + 2), e = e^(2 x) - 1 */
double accurate_tanh(double x)
{
    const Wide e = exponential_less_1(wide_scaled(wide_of(x), 1));
    return wide_to_double(wide_divide(e, wide_add(e, wide_of(2))));
}

/* erf x = 2/sqrt(pi) e^(-x^2) x sum (2 x^2)^n/(1 3 5 ... (2 n + 1)): all terms are positive (Abramowitz and
 * Stegun 7.1.6) */
double accurate_erf(double x)
{
    const Wide square = wide_multiply(wide_of(x), wide_of(x));
    Wide sum = wide_of(x);
    uint32_t k = 3;
    for (Wide term = sum; counts(term, sum); k += 2) {
        term = wide_divide_small(wide_scaled(wide_multiply(term, square), 1), k);
        sum = wide_add(sum, term);
    }
    const Wide bell = exponential(wide_negative(square));
    return wide_to_double(wide_multiply(wide_multiply(two_by_root_pi, bell), sum));
}

/* --- logarithms and powers ------------------------------------------------------------------------- */

/* log(a (or 1 + a)) = near + log(1 + z), z = a e^-near - 1 = a + m + a m, m = e^-near - 1 in the second case,
 * which keeps the bits of an argument near 1; log(1 + z) = 2 s + 2 s^3/3 + ..., s = z/(2 + z) */
static Wide logarithm(Wide a, bool of_1_more, double near)
{
    Wide z;
    if (of_1_more) {
        const Wide m = exponential_less_1(wide_of(-near));
        z = wide_add(wide_add(a, m), wide_multiply(a, m));
    } else {
        z = wide_subtract(wide_multiply(a, exponential(wide_of(-near))), one());
    }
    const Wide s = wide_divide(z, wide_add(z, wide_of(2)));
    const Wide cube = wide_divide_small(wide_multiply(s, wide_multiply(s, s)), 3);
    return wide_add(wide_of(near), wide_scaled(wide_add(s, cube), 1));
}

static Wide natural(double x, double near)
{
    return x > 0.5 && x < 2 ? logarithm(wide_subtract(wide_of(x), one()), true, near)
                            : logarithm(wide_of(x), false, near);
}

double accurate_log(double x, double near)
{
    return wide_to_double(natural(x, near));
}

double accurate_log2(double x, double near_log)
{
    return wide_to_double(wide_divide(natural(x, near_log), ln2));
}

double accurate_log10(double x, double near_log)
{
    return wide_to_double(wide_divide(natural(x, near_log), ln10));
}

double accurate_log1p(double x, double near)
{
    return wide_to_double(fabs(x) < 0.5 ? logarithm(wide_of(x), true, near)
                                        : logarithm(wide_add(one(), wide_of(x)), false, near));
}

/* Powers may be doubles or lie in the middle of two: what is left to error, 2^-165, is rounded away. */
double accurate_pow(double x, double y, double near_log)
{
    return wide_to_double(wide_rounded(exponential(wide_multiply(wide_of(y), natural(x, near_log))), 5));
}

/* y <- y + (x/y^2 - y)/3 */
double accurate_cbrt(double x, double near)
{
    Wide root = wide_of(near);
    for (int i = 0; i < 2; i++)
        root = wide_add(
            root,
            wide_divide_small(wide_subtract(wide_divide(wide_of(x), wide_multiply(root, root)), root), 3));
    return wide_to_double(root);
}

/* Roots too; others are further from a middle than 2^-160: x^2 + y^2 and the middle's square are multiples of
 * the smaller one's last bit squared. */
double accurate_hypot(double x, double y)
{
    const Wide a = wide_of(x), b = wide_of(y);
    return wide_to_double(wide_rounded(wide_root(wide_add(wide_multiply(a, a), wide_multiply(b, b))), 5));
}
