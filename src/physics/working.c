#include "physics/working.h"

#include "base/text.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORDS_DIGITS = 5 };

void working_open(Working *working, char *out, size_t size, int terms)
{
    *working = (Working){out, size, 0, terms};
    if (size > 0)
        out[0] = '\0';
}

void working_say(Working *working, const char *format, ...)
{
    if (working->used + 1 >= working->size)
        return;
    va_list arguments;
    va_start(arguments, format);
    int n = vsnprintf(working->out + working->used, working->size - working->used, format, arguments);
    va_end(arguments);
    const size_t room = working->size - working->used;
    if (n > 0)
        working->used += (size_t)n < room ? (size_t)n : room - 1;
}

void working_number(Working *working, const char *words, double value)
{
    char number[NUMBER_TEXT_MAX];
    text_rounded(number, value, WORDS_DIGITS);
    working_say(working, "%s%s", words, number);
}

void working_end_line(Working *working)
{
    working_say(working, "\n");
}

static double term_value(const WorkingTerm *term)
{
    double value = 1;
    for (int f = 0; f < term->factors; f++)
        value *= term->factor[f];
    return term->divisor != 0 ? value / term->divisor : value;
}

WorkingTerm *working_add(WorkingSum *sum, int factors, double a, double b, double c)
{
    if (sum->count == WORKING_TERMS_MAX) {
        WorkingTerm *last = &sum->terms[WORKING_TERMS_MAX - 1];
        const double product = a * (factors > 1 ? b : 1) * (factors > 2 ? c : 1);
        *last = (WorkingTerm){.factors = 1, .factor = {term_value(last) + product}, .to = -1};
        return last;
    }
    WorkingTerm *term = &sum->terms[sum->count++];
    *term = (WorkingTerm){.factors = factors, .factor = {a, b, c}, .to = -1};
    return term;
}

/* --- how many digits ------------------------------------------------------------------------------ */

/* The place of the first digit: 0 for 1 to 9.99, -1 for 0.1. */
static int place_of(double value)
{
    return value == 0 ? 0 : (int)floor(log10(fabs(value)));
}

/* A sum as it is printed with so many digits, and what the printed numbers come to. */
typedef struct Attempt {
    Working text;
    double value;
} Attempt;

static double put(Working *text, double value, int digits)
{
    char number[NUMBER_TEXT_MAX];
    text_rounded(number, value, digits < 1 ? 1 : digits > 15 ? 15 : digits);
    working_say(text, "%s", number);
    return strtod(number, NULL);
}

/* " + " or " - " before a number whose sign goes into it; the first one keeps its own. */
static double put_joint(Working *text, bool first, double value)
{
    if (first)
        return 1;
    working_say(text, " %s" WORKING_SPACE, signbit(value) && value != 0 ? "-" : "+");
    return signbit(value) && value != 0 ? -1 : 1;
}

static double put_term(Working *text, const WorkingTerm *term, bool first, int digits)
{
    double value = put_joint(text, first, term->factor[0]);
    for (int f = 0; f < term->factors; f++) {
        if (f > 0)
            working_say(text, WORKING_SPACE "×" WORKING_SPACE);
        value *= put(text, f == 0 && !first ? fabs(term->factor[0]) : term->factor[f], digits);
    }
    if (term->divisor != 0) {
        working_say(text, WORKING_SPACE "/" WORKING_SPACE);
        value /= put(text, term->divisor, digits);
    }
    if (term->to >= 0)
        working_say(text, WORKING_SPACE "to" WORKING_SPACE "%ld", term->to);
    return value;
}

/* The last place of a result of so many digits; of one that cancels, that of its largest term. */
static int last_place(const WorkingSum *sum, int digits)
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
 * stand in a column in the student's exercise book. */
static void attempt(Attempt *try, const WorkingSum *sum, int shown, int term_digits, int result_digits)
{
    Working *text = &try->text;
    const int last = last_place(sum, result_digits), count = sum->count;
    double total = 0, base = 0;
    working_say(text, "%s", sum->label);
    if (sum->has_base) {
        /* a guard digit or two, so that base and result are not rounded apart */
        const int guard = term_digits - 4 < 3 ? term_digits - 4 : 3;
        base = put(text, sum->base, place_of(sum->base) - last + 1 + (guard > 0 ? guard : 0));
        if (count > 0 && sum->scale == 0)
            ;
        else
            working_say(text, " +" WORKING_SPACE);
    }
    const bool bracket = (sum->scale != 0 || sum->divisor != 0) && count > 1;
    double scale = 1;
    if (sum->scale != 0) {
        scale = put(text, sum->scale, term_digits);
        working_say(text, WORKING_SPACE "×" WORKING_SPACE);
    }
    if (bracket)
        working_say(text, "(");
    for (int i = 0; i < shown; i++) {
        const WorkingTerm *term = &sum->terms[i];
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
        working_say(text, WORKING_SPACE "(%d" WORKING_SPACE "more)", count - shown);
    }
    if (count == 0)
        working_say(text, "0");
    if (bracket)
        working_say(text, ")");
    if (sum->divisor != 0) {
        working_say(text, WORKING_SPACE "/" WORKING_SPACE);
        total /= put(text, sum->divisor, term_digits);
    }
    working_say(text, " =" WORKING_SPACE);
    const double zero = last_place(sum, 1) > place_of(sum->result) ? 0 : sum->result;
    const double result = put(text, zero, place_of(zero) - last + 1);
    if (sum->unit)
        working_say(text, WORKING_SPACE "%s", sum->unit);
    try->value = (base + scale * total - result) / pow(10, last);
}

enum { LINE_MAX = 4096 };

void working_sum(Working *working, const WorkingSum *sum)
{
    char line[LINE_MAX];
    const int shown = working->terms > 0 && sum->count > working->terms ? working->terms - 1 : sum->count;
    /* what is added to a base must be readable in the result */
    int wanted = 5;
    const double gain = sum->result - sum->base;
    if (sum->has_base && gain != 0) {
        wanted = 3 + place_of(sum->result) - place_of(gain);
        wanted = wanted < 5 ? 5 : wanted > 9 ? 9 : wanted;
    }
    for (int result = wanted; result >= 2; result--)
        for (int term = sum->count > 1 ? 4 : 5; term <= 6 + (wanted - result); term++) {
            Attempt try = {.value = 0};
            working_open(&try.text, line, sizeof line, 0);
            attempt(&try, sum, shown, term, result);
            if (fabs(try.value) <= 0.5 * (1 + 1e-6) || (result == 2 && term == 6 + (wanted - result))) {
                working_say(working, "%s\n", line);
                return;
            }
        }
}

void working_change(Working *working, const char *label, double was, double factor, double rate, double now,
                    const char *unit)
{
    WorkingSum sum = {
        .label = label, .has_base = true, .base = was, .scale = factor, .result = now, .unit = unit};
    working_add(&sum, 1, rate, 0, 0);
    working_sum(working, &sum);
}

double working_before(const void *state, const double *now, const void *before)
{
    double value;
    memcpy(&value, (const char *)before + ((const char *)now - (const char *)state), sizeof value);
    return value;
}
