/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers of 192 bits, by integers alone: what functions.h's functions are made of when 64 bits are not
 * enough.
 *
 * Every operation cuts off what it cannot keep: an error below 2^-190 of its result. Sums that cancel keep
 * the error of what they were made of. Exponents are int: nothing here over- or underflows that began as a
 * double. */
#ifndef BASE_MATH_WIDE_H
#define BASE_MATH_WIDE_H

#include <stdbool.h>
#include <stdint.h>

enum { WIDE_DIGITS = 6 };

/* 0.d0 d1 d2 ... in base 2^32, times 2^exponent; the first bit is set unless the number is 0 (d0 = 0) */
typedef struct Wide {
    bool negative;
    int exponent;
    uint32_t digits[WIDE_DIGITS];
} Wide;

/* `count` digits, the first worth 2^(exponent - 32) and on; leading zeros are taken away */
Wide wide_of_digits(bool negative, int exponent, const uint32_t *digits, int count);

/* exact; the number is finite */
Wide wide_of(double number);

/* To the nearest double, of two the even one, subnormal ones too; inf where it is too large. */
double wide_to_double(Wide);

/* Only the first `count` digits, to nearest: what is in error by less than half of what goes becomes exact.
 */
Wide wide_rounded(Wide, int count);

bool wide_is_zero(Wide);
Wide wide_negative(Wide);
Wide wide_scaled(Wide, int power); /* times 2^power, exact */
Wide wide_add(Wide, Wide);
Wide wide_subtract(Wide, Wide);
Wide wide_multiply(Wide, Wide);
Wide wide_divide(Wide, Wide);
Wide wide_divide_small(Wide, uint32_t);
Wide wide_root(Wide); /* of a number >= 0 */

#endif
