/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Columns of numbers that add up as they are printed. */
#include "picture/sum_column.h"

#include "base/assertion.h"
#include "base/math/functions.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static double rounded(double value, int decimals)
{
    char text[64];
    snprintf(text, sizeof text, "%.*f", decimals, value);
    const double back = strtod(text, NULL);
    return back == 0 ? 0 : back; /* no minus before a zero */
}

/* Whether the terms as printed are the gain as printed, and base and gain the sum. What is added to a base
 * keeps all decimals, so that base and sum are not rounded apart. */
static bool adds_up(const double *terms, size_t n, double base, double gain, double scale, Writing writing)
{
    const double half = 0.5 * math_pow(10, -writing.sum_decimals) * (1 + 1e-9);
    double total = 0;
    for (size_t i = 0; i < n; i++)
        total += rounded(terms[i] * scale, writing.decimals);
    if (base == 0)
        return fabs(total - rounded(gain * scale, writing.sum_decimals)) < half;
    const double said = rounded(gain * scale, writing.decimals);
    return fabs(total - said) < 0.5 * math_pow(10, -writing.decimals) &&
           fabs(rounded(base * scale, writing.decimals) + said -
                rounded((base + gain) * scale, writing.sum_decimals)) < half;
}

enum { DIGITS = 5 };

/* The columns that a number takes before its decimals: sign, digits, point. */
static int columns_before(double value)
{
    const double size = fabs(value);
    return (value < 0) + (size < 10 ? 1 : (int)floor(math_log10(size)) + 1) + 1;
}

static int larger(int a, int b)
{
    return a > b ? a : b;
}

Writing writing_of(const double *terms, size_t n, double base, double gain, int width)
{
    ASSERT_INT(width, >=, 1);
    const double sum = base + gain;
    double most = fmax(fabs(base), fabs(sum));
    for (size_t i = 0; i < n; i++)
        most = fmax(most, fabs(terms[i]));
    Writing writing = {0, DIGITS, DIGITS};
    if (!(most > 0))
        return (Writing){0, 0, 0};
    const int magnitude = (int)floor(math_log10(most));
    if (magnitude < -3 || magnitude > 3)
        writing.exponent = 3 * (int)floor(magnitude / 3.0);
    const double scale = math_pow(10, -writing.exponent);
    int before = larger(columns_before(base * scale), columns_before(sum * scale));
    before = larger(before, columns_before(gain * scale));
    for (size_t i = 0; i < n; i++)
        before = larger(before, columns_before(terms[i] * scale));
    const int room = width - before;
    const double least = fabs(gain) > 0 ? fabs(gain) : most;
    int wanted = DIGITS - 1 - (int)floor(math_log10(least * scale));
    wanted = wanted < room ? wanted : room;
    for (int sum_decimals = wanted; sum_decimals >= 0; sum_decimals--)
        for (int decimals = sum_decimals; decimals <= room; decimals++) {
            writing.decimals = decimals;
            writing.sum_decimals = sum_decimals;
            if (adds_up(terms, n, base, gain, scale, writing))
                return writing;
        }
    return writing;
}

void format_number(double value, Format format, char out[NUMBER_TEXT_MAX])
{
    if (!isfinite(value)) {
        text_shortest(out, value);
        return;
    }
    snprintf(out, NUMBER_TEXT_MAX, format.exponents ? "%.*e" : "%.*f", format.decimals,
             format.exponents ? value + 0.0 : rounded(value, format.decimals));
    text_trim_exponent(out);
}

Format format_of(const double *values, size_t n, int digits, int width)
{
    char text[NUMBER_TEXT_MAX];
    double most = 0;
    for (size_t i = 0; i < n; i++)
        if (isfinite(values[i]))
            most = fmax(most, fabs(values[i]));
    if (!(most > 0))
        return (Format){false, 0};
    const int magnitude = (int)floor(math_log10(most));
    Format format = {magnitude < -3 || magnitude > 5, 0};
    format.decimals = format.exponents ? digits - 1 : larger(digits - 1 - magnitude, 0);
    for (size_t i = 0; i < n; i++)
        for (; format.decimals > 0; format.decimals--) {
            format_number(values[i], format, text);
            if ((int)strlen(text) <= width)
                break;
        }
    /* zeros at the end of every number say nothing */
    for (; format.decimals > 0; format.decimals--)
        for (size_t i = 0; i < n; i++) {
            format_number(values[i], format, text);
            if (isfinite(values[i]) && text[strcspn(text, "e") - 1] != '0')
                return format;
        }
    return format;
}

int sum_column_number(double value, Writing writing, int decimals, char out[64])
{
    const double scaled = value * math_pow(10, -writing.exponent);
    snprintf(out, 64, "%.*f", decimals, rounded(scaled, decimals));
    return writing.decimals - decimals + (decimals == 0 && writing.decimals > 0);
}
