/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers with arithmetic and units (quantity.h), by recursive descent:
 *
 *     sum      [+|-] product { (+|-) product }
 *     product  power { (*|/) power | unit }            a unit behind a number multiplies it
 *     power    (number | unit | pi | ( sum )) [%] [^ [-] whole number]
 *              a digit right behind a unit is its power
 *
 * "1/2 mm" is half a millimetre, "kN/mm^2" and "kN/mm2" what they say, "3 1/ms" three in a millisecond. Every
 * value carries a power of ten beside its number, applied at the end: factors of units are powers of ten, so
 * nothing is rounded on the way. */
#include "base/quantity.h"

#include "base/math/functions.h"
#include "base/text.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LENGTH, MASS, TIME, BASES };
enum { DEPTH_MAX = 20, POWER_MAX = 9, TENS_MAX = 400, LETTERS_MAX = 4 };

typedef struct Value {
    double number;
    int tens;         /* times 10^tens */
    int bases[BASES]; /* m, kg, s */
} Value;

enum { UNIT_NAME_MAX = 32 };

typedef struct Reader {
    const char *text, *at;
    int depth;
    const char *why;          /* NULL: sound so far */
    char name[UNIT_NAME_MAX]; /* of a unit that there is none of; "" */
} Reader;

static const struct {
    const char *name;
    int tens, bases[BASES];
} units[] = {{"m", 0, {1, 0, 0}},    {"g", -3, {0, 1, 0}}, {"s", 0, {0, 0, 1}}, {"N", 0, {1, 1, -2}},
             {"Pa", 0, {-1, 1, -2}}, {"J", 0, {2, 1, -2}}, {"W", 0, {2, 1, -3}}};
/* no Hz: a rate is no count of cycles */

static const struct {
    const char *name;
    int tens;
} prefixes[] = {{"T", 12}, {"G", 9},  {"M", 6},         {"k", 3},         {"c", -2}, {"m", -3},
                {"u", -6}, {"n", -9}, {"\302\265", -6}, {"\316\274", -6}, {"p", -12}};

static bool fail(Reader *reader, const char *why)
{
    if (!reader->why)
        reader->why = why;
    return false;
}

static void skip_spaces(Reader *reader)
{
    while (*reader->at == ' ' || *reader->at == '\t')
        reader->at++;
}

/* The number that is written with the decimal point so many places further. */
static double shifted(double number, int tens)
{
    char text[2 * NUMBER_TEXT_MAX];
    if (tens == 0 || number == 0 || !isfinite(number))
        return number;
    text_shortest(text, number);
    char *e = strchr(text, 'e');
    const long own = e ? strtol(e + 1, NULL, 10) : 0;
    snprintf(e ? e : text + strlen(text), NUMBER_TEXT_MAX, "e%ld", own + tens);
    return strtod(text, NULL);
}

/* --- units ------------------------------------------------------------------------------------------- */

static bool is_letter(char c)
{
    return isalpha((unsigned char)c) || (unsigned char)c >= 0x80;
}

static const char *prefix_of(const char *word, int *tens)
{
    for (size_t i = 0; i < sizeof prefixes / sizeof *prefixes; i++) {
        const size_t length = strlen(prefixes[i].name);
        if (strncmp(word, prefixes[i].name, length) == 0) {
            *tens = prefixes[i].tens;
            return word + length;
        }
    }
    return NULL;
}

static bool unit_of(const char *word, int tens, Value *value)
{
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strcmp(units[i].name, word) == 0) {
            *value = (Value){.number = 1, .tens = tens + units[i].tens};
            memcpy(value->bases, units[i].bases, sizeof value->bases);
            return true;
        }
    return false;
}

/* What no unit is called so, with what is written behind it, "t/m^3"; where no number stands before, it is
 * none. */
static bool fail_unit(Reader *reader, const char *word)
{
    size_t length = 0;
    if (strcspn(reader->text, "0123456789") >= (size_t)(word - reader->text))
        return fail(reader, "is not a number");
    while (length < UNIT_NAME_MAX - 1 && word[length] &&
           (is_letter(word[length]) || strchr("0123456789^/*-", word[length])))
        length++;
    for (size_t whole = length; whole > 0; whole--) /* whole characters, where they are some */
        if (((unsigned char)word[whole] & 0xc0) != 0x80) {
            length = whole;
            break;
        }
    if (!reader->why)
        snprintf(reader->name, sizeof reader->name, "%.*s", (int)length, word);
    return fail(reader, "cannot be read");
}

/* A unit, one with a prefix, or a prefix alone (not c); "m" is a metre. */
static bool read_word(Reader *reader, Value *value)
{
    char word[8];
    const char *begin = reader->at;
    size_t length = 0;
    int tens = 0;
    while (is_letter(reader->at[length]))
        length++;
    if (length > LETTERS_MAX)
        return fail_unit(reader, begin);
    memcpy(word, reader->at, length);
    word[length] = '\0';
    reader->at += length;
    if (strcmp(word, "pi") == 0) {
        *value = (Value){.number = 3.14159265358979323846};
        return true;
    }
    if (unit_of(word, 0, value))
        return true;
    const char *rest = prefix_of(word, &tens);
    if (rest && *rest)
        return unit_of(rest, tens, value) || fail_unit(reader, begin);
    *value = (Value){.number = 1, .tens = tens};
    return (rest && tens != -2) || fail_unit(reader, begin);
}

/* --- arithmetic --------------------------------------------------------------------------------------- */

static bool read_sum(Reader *reader, Value *value);

/* Digits with a point and an exponent, nothing else that strtod() takes. */
static bool read_number(Reader *reader, Value *value)
{
    char text[64];
    const char *end = reader->at;
    while (isdigit((unsigned char)*end) || *end == '.')
        end++;
    if (*end == 'e' || *end == 'E') {
        const char *digits = end + 1 + (end[1] == '+' || end[1] == '-');
        if (isdigit((unsigned char)*digits))
            for (end = digits; isdigit((unsigned char)*end);)
                end++;
    }
    const size_t length = (size_t)(end - reader->at);
    if (length == 0 || length >= sizeof text)
        return fail(reader, "is not a number");
    memcpy(text, reader->at, length);
    text[length] = '\0';
    *value = (Value){.number = 0};
    reader->at = end;
    return text_to_double(text, &value->number) || fail(reader, "is not a number");
}

static bool read_primary(Reader *reader, Value *value)
{
    skip_spaces(reader);
    if (*reader->at != '(')
        return is_letter(*reader->at) ? read_word(reader, value) : read_number(reader, value);
    reader->at++;
    if (!read_sum(reader, value))
        return false;
    skip_spaces(reader);
    if (*reader->at != ')')
        return fail(reader, "has a bracket that is not closed");
    reader->at++;
    return true;
}

/* Far from what a unit or a number can be, and from what an int can hold. */
static bool is_bounded(Reader *reader, const Value *value)
{
    bool bounded = abs(value->tens) <= TENS_MAX;
    for (int i = 0; i < BASES; i++)
        bounded &= abs(value->bases[i]) <= POWER_MAX;
    return bounded || fail(reader, "is not a number");
}

static bool to_power(Reader *reader, Value *value)
{
    const bool minus = *reader->at == '-';
    reader->at += minus || *reader->at == '+';
    if (!isdigit((unsigned char)*reader->at) || isdigit((unsigned char)reader->at[1]) || reader->at[1] == '.')
        return fail(reader, "has a power that is no whole number up to 9");
    const int power = minus ? '0' - *reader->at++ : *reader->at++ - '0';
    if (power < 0 && value->number == 0)
        return fail(reader, "divides by zero");
    value->number = math_pow(value->number, power);
    value->tens *= power;
    for (int i = 0; i < BASES; i++)
        value->bases[i] *= power;
    return is_bounded(reader, value);
}

static bool read_power(Reader *reader, Value *value)
{
    const int none[BASES] = {0};
    if (!read_primary(reader, value))
        return false;
    if (is_letter(reader->at[-1]) && isdigit((unsigned char)*reader->at) &&
        memcmp(value->bases, none, sizeof none) != 0)
        return to_power(reader, value);
    skip_spaces(reader);
    if (*reader->at == '%') {
        reader->at++;
        value->tens -= 2;
        skip_spaces(reader);
    }
    if (*reader->at != '^')
        return true;
    reader->at++;
    skip_spaces(reader);
    return to_power(reader, value);
}

static bool combine(Reader *reader, Value *value, const Value *other, bool divides)
{
    if (divides && other->number == 0)
        return fail(reader, "divides by zero");
    value->number = divides ? value->number / other->number : value->number * other->number;
    value->tens += divides ? -other->tens : other->tens;
    for (int i = 0; i < BASES; i++)
        value->bases[i] += divides ? -other->bases[i] : other->bases[i];
    return is_bounded(reader, value);
}

static bool read_product(Reader *reader, Value *value)
{
    if (!read_power(reader, value))
        return false;
    for (;;) {
        Value other;
        skip_spaces(reader);
        if (reader->at[0] == '1' && reader->at[1] == '/' && is_letter(reader->at[2]))
            reader->at++; /* "3 1/ms" */
        const bool divides = *reader->at == '/';
        if (divides || *reader->at == '*')
            reader->at++;
        else if (!is_letter(*reader->at))
            return true;
        if (!read_power(reader, &other) || !combine(reader, value, &other, divides))
            return false;
    }
}

static bool add(Reader *reader, Value *value, const Value *other, int sign)
{
    if (memcmp(value->bases, other->bases, sizeof value->bases) != 0)
        return fail(reader, "adds what has different units");
    value->number = shifted(value->number, value->tens) + sign * shifted(other->number, other->tens);
    value->tens = 0;
    return true;
}

static bool read_sum(Reader *reader, Value *value)
{
    if (++reader->depth > DEPTH_MAX)
        return fail(reader, "has too many brackets");
    skip_spaces(reader);
    int sign = *reader->at == '-' ? -1 : 1;
    reader->at += *reader->at == '-' || *reader->at == '+';
    if (!read_product(reader, value))
        return false;
    value->number *= sign;
    for (skip_spaces(reader); *reader->at == '+' || *reader->at == '-'; skip_spaces(reader)) {
        Value other;
        sign = *reader->at++ == '-' ? -1 : 1;
        if (!read_product(reader, &other) || !add(reader, value, &other, sign))
            return false;
    }
    reader->depth--;
    return true;
}

/* --- the whole ------------------------------------------------------------------------------------------ */

static bool read_all(Reader *reader, Value *value)
{
    if (!read_sum(reader, value))
        return false;
    return *reader->at == '\0' || fail(reader, "is not a number");
}

static bool read_any(const char *text, const char *unit, double *value, char *why)
{
    if (text_to_double(text, value))
        return true;
    Value read = {0}, wanted = {0};
    const int none[BASES] = {0};
    Reader reader = {.text = text, .at = text}, known = {.text = unit, .at = unit};
    const bool sound = read_all(&reader, &read);
    const double number = sound ? shifted(read.number, read.tens) : NAN;
    if (!sound || !isfinite(number)) {
        if (reader.name[0])
            snprintf(why, QUANTITY_WHY_MAX, "%s: no unit %s here", reader.why, reader.name);
        else
            snprintf(why, QUANTITY_WHY_MAX, "%s", sound ? "is too large" : reader.why);
        return false;
    }
    if (memcmp(read.bases, none, sizeof none) == 0) {
        *value = number; /* in whatever unit is wanted */
        return true;
    }
    if (!read_all(&known, &wanted) || memcmp(wanted.bases, none, sizeof none) == 0)
        snprintf(why, QUANTITY_WHY_MAX, "has a unit where none is known");
    else if (memcmp(read.bases, wanted.bases, sizeof none) != 0)
        snprintf(why, QUANTITY_WHY_MAX, "is not in %.40s", unit);
    else {
        *value = shifted(number, -wanted.tens);
        return true;
    }
    return false;
}

bool quantity_read(const char *text, const char *unit, double *value, char *why)
{
    double any;
    if (!read_any(text, unit, &any, why))
        return false;
    if (!quantity_is_sound(any)) {
        snprintf(why, QUANTITY_WHY_MAX, "is too %s to compute with", fabs(any) < 1 ? "small" : "large");
        return false;
    }
    *value = any;
    return true;
}
