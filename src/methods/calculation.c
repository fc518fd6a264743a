/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sums written out with their numbers (calculation.h). The difficulty is the number of digits: a sum of
 * rounded terms seldom equals the rounded sum. So each sum is first written with few digits, the printed
 * numbers are worked out again, and digits are added to the terms, then taken from the result, until both
 * agree to half of the last digit shown. */
#include "methods/calculation.h"

#include "base/assertion.h"
#include "base/math/functions.h"
#include "base/text.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CALCULATION_SPACE "\u00a0" /* that no line is broken at */
enum { WORDS_DIGITS = 5 };

CalculationLabel calculation_label(int dimensions, const char *form, int axis, int number)
{
    CalculationLabel label = {""};
    const bool line = dimensions == 1;
    for (; *form; form++)
        if (*form == '@' || *form == '#' || (line && strncmp(form, "_@", 2) == 0)) {
            if (*form == '@' && !line)
                text_append(label.text, sizeof label.text, "%c", axis ? 'y' : 'x');
            if (*form == '#' && line)
                text_append(label.text, sizeof label.text, "%d", number);
        } else
            text_append(label.text, sizeof label.text, "%c", *form);
    return label;
}

void calculation_open(Calculation *calculation, char *out, size_t size, int terms)
{
    ASSERT_INT(size, >, 0);
    ASSERT_INT(terms, >=, 0);
    *calculation = (Calculation){out, size, 0, terms};
    if (size > 0)
        out[0] = '\0';
}

void calculation_write(Calculation *calculation, const char *format, ...)
{
    if (calculation->used + 1 >= calculation->size)
        return;
    va_list arguments;
    va_start(arguments, format);
    int n = vsnprintf(calculation->out + calculation->used, calculation->size - calculation->used, format,
                      arguments);
    va_end(arguments);
    const size_t room = calculation->size - calculation->used;
    if (n > 0)
        calculation->used += (size_t)n < room ? (size_t)n : room - 1;
}

void calculation_number(Calculation *calculation, const char *words, double value)
{
    calculation_write(calculation, "%s%s", words, text_rounded(value, WORDS_DIGITS).text);
}

void calculation_value(Calculation *calculation, const char *words, double value)
{
    calculation_number(calculation, words, value);
    calculation_write(calculation, "\n");
}

static double term_value(const CalculationTerm *term)
{
    double value = 1;
    for (int f = 0; f < term->factors; f++)
        value *= term->factor[f];
    return term->divisor != 0 ? value / term->divisor : value;
}

CalculationTerm *calculation_add(CalculationSum *sum, int factors, double a, double b, double c)
{
    ASSERT_INT(factors, >=, 1);
    ASSERT_INT(factors, <=, CALCULATION_FACTORS_MAX);
    ASSERT_INT(sum->count, <=, CALCULATION_TERMS_MAX);
    if (sum->count == CALCULATION_TERMS_MAX) {
        CalculationTerm *last = &sum->terms[CALCULATION_TERMS_MAX - 1];
        const double product = a * (factors > 1 ? b : 1) * (factors > 2 ? c : 1);
        *last = (CalculationTerm){.factors = 1, .factor = {term_value(last) + product}, .to = -1};
        return last;
    }
    CalculationTerm *term = &sum->terms[sum->count++];
    *term = (CalculationTerm){.factors = factors, .factor = {a, b, c}, .to = -1};
    return term;
}

/* --- how many digits ------------------------------------------------------------------------------ */

/* The place of the first digit: 0 for 1 to 9.99, -1 for 0.1. */
static int place_of(double value)
{
    return value == 0 ? 0 : (int)floor(math_log10(fabs(value)));
}

static double put(Calculation *text, double value, int digits)
{
    const NumberText number = text_rounded(value, digits < 1 ? 1 : digits > 15 ? 15 : digits);
    calculation_write(text, "%s", number.text);
    return strtod(number.text, NULL);
}

/* " + " or " - " before a number whose sign goes into it; the first one keeps its own. */
static double put_joint(Calculation *text, bool first, double value)
{
    if (first)
        return 1;
    calculation_write(text, " %s" CALCULATION_SPACE, signbit(value) && value != 0 ? "-" : "+");
    return signbit(value) && value != 0 ? -1 : 1;
}

static double put_term(Calculation *text, const CalculationTerm *term, bool first, int digits)
{
    double value = put_joint(text, first, term->factor[0]);
    for (int f = 0; f < term->factors; f++) {
        if (f > 0)
            calculation_write(text, CALCULATION_SPACE "×" CALCULATION_SPACE);
        value *= put(text, f == 0 && !first ? fabs(term->factor[0]) : term->factor[f], digits);
    }
    if (term->divisor != 0) {
        calculation_write(text, CALCULATION_SPACE "/" CALCULATION_SPACE);
        value /= put(text, term->divisor, digits);
    }
    if (term->to >= 0)
        calculation_write(text, CALCULATION_SPACE "to" CALCULATION_SPACE "%ld", term->to);
    return value;
}

/* The last place of a result of so many digits; of one that cancels, that of its largest term. */
static int last_place(const CalculationSum *sum, int digits)
{
    double most = 0;
    for (int i = 0; i < sum->count; i++)
        most = fmax(most, fabs(term_value(&sum->terms[i])));
    if (sum->scale != 0)
        most *= fabs(sum->scale);
    if (sum->divisor != 0)
        most /= fabs(sum->divisor);
    if (fabs(sum->result) > 1e-12 * most)
        return place_of(sum->result) - digits + 1;
    return place_of(most) - digits + 1;
}

/* Terms that are products each keep so many digits, terms that are single numbers the same last place: they
 * are in a column in the student's exercise book. Returns by how many of the result's last places the printed
 * numbers miss it. */
static double attempt(Calculation *text, const CalculationSum *sum, int shown, int term_digits,
                      int result_digits)
{
    const int last = last_place(sum, result_digits), count = sum->count;
    double total = 0, base = 0;
    calculation_write(text, "%s", sum->label);
    if (sum->has_base) {
        /* a guard digit or two, so that base and result are not rounded apart */
        const int guard = term_digits - 4 < 3 ? term_digits - 4 : 3;
        base = put(text, sum->base, place_of(sum->base) - last + 1 + (guard > 0 ? guard : 0));
        if (count == 0 || sum->scale != 0)
            calculation_write(text, " +" CALCULATION_SPACE);
    }
    const bool bracket = (sum->scale != 0 || sum->divisor != 0) && count > 1;
    double scale = 1;
    if (sum->scale != 0) {
        scale = put(text, sum->scale, term_digits);
        calculation_write(text, CALCULATION_SPACE "×" CALCULATION_SPACE);
    }
    if (bracket)
        calculation_write(text, "(");
    for (int i = 0; i < shown; i++) {
        const CalculationTerm *term = &sum->terms[i];
        int digits = term_digits;
        if (term->factors == 1 && term->divisor == 0 && sum->scale == 0 && sum->divisor == 0)
            digits = place_of(term->factor[0]) - last + 1 +
                     (term_digits > result_digits ? term_digits - result_digits : 0);
        total += put_term(text, term, i == 0 && (!sum->has_base || sum->scale != 0), digits);
    }
    if (shown < count) {
        double rest = 0;
        for (int i = shown; i < count; i++)
            rest += term_value(&sum->terms[i]);
        const double sign = put_joint(text, shown == 0, rest);
        total += sign * put(text, sign * rest, term_digits);
        calculation_write(text, CALCULATION_SPACE "(%d" CALCULATION_SPACE "more)", count - shown);
    }
    if (count == 0)
        calculation_write(text, "0");
    if (bracket)
        calculation_write(text, ")");
    if (sum->divisor != 0) {
        calculation_write(text, CALCULATION_SPACE "/" CALCULATION_SPACE);
        total /= put(text, sum->divisor, term_digits);
    }
    calculation_write(text, " =" CALCULATION_SPACE);
    const double zero = last_place(sum, 1) > place_of(sum->result) ? 0 : sum->result;
    const double result = put(text, zero, place_of(zero) - last + 1);
    if (sum->unit)
        calculation_write(text, CALCULATION_SPACE "%s", sum->unit);
    return (base + scale * total - result) / math_pow(10, last);
}

enum { LINE_MAX = 4096 };

void calculation_sum(Calculation *calculation, const CalculationSum *sum)
{
    char line[LINE_MAX];
    const int shown =
        calculation->terms > 0 && sum->count > calculation->terms ? calculation->terms - 1 : sum->count;
    /* what is added to a base must be readable in the result */
    int wanted = 5;
    const double gain = sum->result - sum->base;
    if (sum->has_base && gain != 0) {
        wanted = 3 + place_of(sum->result) - place_of(gain);
        wanted = wanted < 5 ? 5 : wanted > 9 ? 9 : wanted;
    }
    enum { LEAST = 2, CANCELLED = 4 }; /* digits of the result; more of the terms where it all but cancels */
    for (int result = wanted; result >= LEAST; result--) {
        const int most = 6 + (wanted - result) + (result == LEAST ? CANCELLED : 0);
        for (int term = sum->count > 1 ? 4 : 5; term <= most; term++) {
            Calculation text;
            calculation_open(&text, line, sizeof line, 0);
            const double off = attempt(&text, sum, shown, term, result);
            if (fabs(off) <= 0.5 * (1 + 1e-6) || (result == LEAST && term == most)) {
                calculation_write(calculation, "%s\n", line);
                return;
            }
        }
    }
}

void calculation_exchange(Calculation *calculation, CalculationSum *sum, const Simulation *sim, int exchange,
                          size_t index, const Link *links, size_t count)
{
    const Exchange *row = &sim->exchanges[exchange];
    bool leads = strncmp(row->factors, "m ", 2) == 0 || strncmp(row->factors, "Δt ", 4) == 0;
    double first = NAN, total = 0;
    for (size_t i = 0; i < count; i++) { /* masses differ beside a joint */
        const ExchangeTerm term = simulation_exchange(sim, exchange, index, &links[i]);
        leads = leads && (i == 0 || term.factors[0] == first);
        first = term.factors[0];
    }
    for (size_t i = 0; i < count; i++) {
        const ExchangeTerm term = simulation_exchange(sim, exchange, index, &links[i]);
        const double *own = leads ? term.factors + 1 : term.factors;
        if (term.count == 0)
            return;
        calculation_add(sum, leads ? term.count - 1 : term.count, own[0], own[1], own[2]);
        sum->scale = leads ? first : sum->scale;
        total += term.product;
    }
    const double now = simulation_named(sim, row->to, row->field, index);
    sum->has_base = row->adds;
    sum->base = now - total;
    sum->result = row->adds ? now : sum->scale != 0 && !leads ? sum->scale * total : total;
    calculation_sum(calculation, sum);
}

void calculation_change(Calculation *calculation, const char *label, double was, double factor, double rate,
                        double now, const char *unit)
{
    CalculationSum sum = {
        .label = label, .has_base = true, .base = was, .scale = factor, .result = now, .unit = unit};
    calculation_add(&sum, 1, rate, 0, 0);
    calculation_sum(calculation, &sum);
}

double calculation_before(const void *state, const double *now, const void *before)
{
    ASSERT(before);
    double value;
    memcpy(&value, (const char *)before + ((const char *)now - (const char *)state), sizeof value);
    return value;
}
