/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elementary functions by numbers of 192 bits (double_double.h). Errors are below 2^-180 of the result where
 * nothing else is said; series end when a term is below 2^-200 of the sum. */
#include "base/math/double_double.h"
#include "base/assertion.h"

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Numbers of 192 bits, by integers alone: what functions.h's functions are made of when 64 bits are not
 * enough.
 *
 * Every operation cuts off what it cannot keep: an error below 2^-190 of its result. Sums that cancel keep
 * the error of what they were made of. Exponents are int: nothing here over- or underflows that began as a
 * double. */

enum { WIDE_DIGITS = 6 };

/* 0.d0 d1 d2 ... in base 2^32, times 2^exponent; the first bit is set unless the number is 0 (d0 = 0) */
typedef struct Wide {
    bool negative;
    int exponent;
    uint32_t digits[WIDE_DIGITS];
} Wide;

enum { BITS = 32 * WIDE_DIGITS, ROOM = 2 * WIDE_DIGITS + 1 };

static bool wide_is_zero(Wide a)
{
    return a.digits[0] == 0;
}

/* `count` digits, the first worth 2^(exponent - 32) and on; leading zeros are taken away */
static Wide wide_of_digits(bool negative, int exponent, const uint32_t *digits, int count)
{
    int first = 0;
    while (first < count && digits[first] == 0)
        first++;
    if (first == count)
        return (Wide){0};
    int shift = 0;
    while (!(digits[first] << shift & 0x80000000))
        shift++;
    Wide number = {.negative = negative, .exponent = exponent - 32 * first - shift};
    for (int i = 0; i < WIDE_DIGITS && first + i < count; i++) {
        const uint64_t pair =
            (uint64_t)digits[first + i] << 32 | (first + i + 1 < count ? digits[first + i + 1] : 0);
        number.digits[i] = (uint32_t)(pair << shift >> 32);
    }
    return number;
}

/* exact; the number is finite */
static Wide wide_of(double number)
{
    ASSERT(isfinite(number));
    int exponent;
    const uint64_t bits = (uint64_t)ldexp(fabs(frexp(number, &exponent)), 64 - 11) << 11;
    return wide_of_digits(number < 0, exponent, (uint32_t[]){(uint32_t)(bits >> 32), (uint32_t)bits}, 2);
}

/* To the nearest double, of two the even one, subnormal ones too; inf where it is too large. */
static double wide_to_double(Wide a)
{
    const uint64_t top = (uint64_t)a.digits[0] << 32 | a.digits[1];
    bool rest = false;
    for (int i = 2; i < WIDE_DIGITS; i++)
        rest = rest || a.digits[i];

    /* 53 bits are kept, of subnormal numbers those above 2^-1074 */
    const int kept = a.exponent >= -1021 ? 53 : a.exponent + 1074;
    if (kept < 0)
        return a.negative ? -0.0 : 0.0;
    const uint64_t half = (uint64_t)1 << (63 - kept), tail = top & (half - 1 + half);
    uint64_t bits = kept ? top >> (64 - kept) : 0;
    if (tail > half || (tail == half && (rest || bits & 1)))
        bits++;
    return ldexp(a.negative ? -(double)bits : (double)bits, a.exponent - kept);
}

/* Only the first `count` digits, to nearest: an error of less than half of what goes becomes none. */
static Wide wide_rounded(Wide a, int count)
{
    bool up = a.digits[count] & 0x80000000;
    for (int i = count; i < WIDE_DIGITS; i++)
        a.digits[i] = 0;
    for (int i = count - 1; i >= 0 && up; i--)
        up = ++a.digits[i] == 0;
    if (up)
        a.digits[0] = 0x80000000, a.exponent++;
    return a;
}

static Wide wide_negative(Wide a)
{
    a.negative = !a.negative;
    return a;
}

/* times 2^power, exact */
static Wide wide_scaled(Wide a, int power)
{
    a.exponent += power;
    return a;
}

/* whether |a| < |b| */
static bool is_less(const Wide *a, const Wide *b)
{
    if (wide_is_zero(*a) || wide_is_zero(*b))
        return !wide_is_zero(*b);
    if (a->exponent != b->exponent)
        return a->exponent < b->exponent;
    int i = 0;
    while (i < WIDE_DIGITS - 1 && a->digits[i] == b->digits[i])
        i++;
    return a->digits[i] < b->digits[i];
}

static Wide wide_add(Wide a, Wide b)
{
    if (is_less(&a, &b)) {
        const Wide kept = a;
        a = b, b = kept;
    }
    const int shift = a.exponent - b.exponent;
    if (wide_is_zero(b) || shift > BITS)
        return a;

    /* b moved to where a is, with as many digits again below; one digit above for the carry */
    uint32_t large[ROOM] = {0}, moved[ROOM] = {0};
    memcpy(large + 1, a.digits, sizeof a.digits);
    for (int i = 0; i < WIDE_DIGITS; i++) {
        const uint64_t pair = (uint64_t)b.digits[i] << (32 - shift % 32);
        moved[1 + i + shift / 32] |= (uint32_t)(pair >> 32);
        if (2 + i + shift / 32 < ROOM)
            moved[2 + i + shift / 32] |= (uint32_t)pair;
    }
    int64_t carry = 0;
    const int64_t sign = a.negative == b.negative ? 1 : -1;
    for (int i = ROOM - 1; i >= 0; i--) {
        carry += large[i] + sign * moved[i];
        large[i] = (uint32_t)(carry & 0xffffffff);
        carry = carry < 0 ? -1 : carry >> 32;
    }
    return wide_of_digits(a.negative, a.exponent + 32, large, ROOM);
}

static Wide wide_subtract(Wide a, Wide b)
{
    return wide_add(a, wide_negative(b));
}

static Wide wide_multiply(Wide a, Wide b)
{
    uint32_t product[2 * WIDE_DIGITS] = {0};
    for (int i = WIDE_DIGITS - 1; i >= 0; i--) {
        uint64_t carry = 0;
        for (int j = WIDE_DIGITS - 1; j >= 0; j--) {
            carry += (uint64_t)a.digits[i] * b.digits[j] + product[i + j + 1];
            product[i + j + 1] = (uint32_t)carry;
            carry >>= 32;
        }
        product[i] = (uint32_t)carry;
    }
    return wide_of_digits(a.negative != b.negative, a.exponent + b.exponent, product, 2 * WIDE_DIGITS);
}

static Wide wide_divide_small(Wide a, uint32_t b)
{
    uint32_t quotient[WIDE_DIGITS + 1];
    uint64_t rest = 0;
    for (int i = 0; i <= WIDE_DIGITS; i++) {
        rest = rest << 32 | (i < WIDE_DIGITS ? a.digits[i] : 0);
        quotient[i] = (uint32_t)(rest / b);
        rest %= b;
    }
    return wide_of_digits(a.negative, a.exponent, quotient, WIDE_DIGITS + 1);
}

/* y <- y + y (1 - b y), from 53 bits to 106 to all */
static Wide wide_divide(Wide a, Wide b)
{
    const Wide one = wide_of(1);
    const int power = b.exponent;
    b.exponent = 0;
    Wide inverse = wide_of(1 / wide_to_double(b));
    for (int i = 0; i < 2; i++)
        inverse = wide_add(inverse, wide_multiply(inverse, wide_subtract(one, wide_multiply(b, inverse))));
    return wide_scaled(wide_multiply(a, inverse), -power);
}

/* Of a number >= 0: y <- y + (a - y^2)/(2 y). */
static Wide wide_root(Wide a)
{
    if (wide_is_zero(a))
        return a;
    const int power = a.exponent & ~1;
    a.exponent -= power;
    Wide root = wide_of(sqrt(wide_to_double(a)));
    for (int i = 0; i < 2; i++)
        root =
            wide_add(root, wide_scaled(wide_divide(wide_subtract(a, wide_multiply(root, root)), root), -1));
    return wide_scaled(root, power / 2);
}

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
 * x = m 2^e with m an integer of 53 bits. Of m 2^e 2/pi only the part below 4 is needed, so bits of 2/pi that
 * are worth 4 and more when multiplied by 2^e are left out (M. Payne, R. Hanek, SIGNUM Newsletter 18, 1983):
 * a window of 320 bits from there, times m, is a fixed-point number with `point` bits behind the point. */
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

/* e^x - 1, |x| < 1, to 2^-180 of itself: t = x/2^8, t + t^2/2 + ..., 8 times (1 + e)^2 - 1 = e (2 + e) */
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

/* Roots too; others are further from a middle than 2^-160: x^2 + y^2 and the middle's square are multiples of
 * the smaller one's last bit squared. */
double accurate_hypot(double x, double y)
{
    const Wide a = wide_of(x), b = wide_of(y);
    return wide_to_double(wide_rounded(wide_root(wide_add(wide_multiply(a, a), wide_multiply(b, b))), 5));
}
