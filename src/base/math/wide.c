/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers of 192 bits (wide.h): school arithmetic in base 2^32. */
#include "base/math/wide.h"

#include "base/assertion.h"

#include <math.h>
#include <string.h>

enum { BITS = 32 * WIDE_DIGITS, ROOM = 2 * WIDE_DIGITS + 1 };

bool wide_is_zero(Wide a)
{
    return a.digits[0] == 0;
}

Wide wide_of_digits(bool negative, int exponent, const uint32_t *digits, int count)
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

Wide wide_of(double number)
{
    ASSERT(isfinite(number));
    int exponent;
    const uint64_t bits = (uint64_t)ldexp(fabs(frexp(number, &exponent)), 64 - 11) << 11;
    return wide_of_digits(number < 0, exponent, (uint32_t[]){(uint32_t)(bits >> 32), (uint32_t)bits}, 2);
}

double wide_to_double(Wide a)
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

Wide wide_rounded(Wide a, int count)
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

Wide wide_negative(Wide a)
{
    a.negative = !a.negative;
    return a;
}

Wide wide_scaled(Wide a, int power)
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

Wide wide_add(Wide a, Wide b)
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

Wide wide_subtract(Wide a, Wide b)
{
    return wide_add(a, wide_negative(b));
}

Wide wide_multiply(Wide a, Wide b)
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

Wide wide_divide_small(Wide a, uint32_t b)
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
Wide wide_divide(Wide a, Wide b)
{
    const Wide one = wide_of(1);
    const int power = b.exponent;
    b.exponent = 0;
    Wide inverse = wide_of(1 / wide_to_double(b));
    for (int i = 0; i < 2; i++)
        inverse = wide_add(inverse, wide_multiply(inverse, wide_subtract(one, wide_multiply(b, inverse))));
    return wide_scaled(wide_multiply(a, inverse), -power);
}

/* y <- y + (a - y^2)/(2 y) */
Wide wide_root(Wide a)
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
