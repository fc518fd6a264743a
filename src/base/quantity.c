/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers with arithmetic and units (quantity.h): the grammar's dialect of units, worked out as it is read.
 *
 * "1/2 mm" is half a millimetre, "kN/mm^2" and "kN/mm2" what they say, a digit right behind a unit being its
 * power, "3 1/ms" three in a millisecond. Every value carries a power of ten beside its number, applied at
 * the end: factors of units are powers of ten, so nothing is rounded on the way. */
#include "base/quantity.h"

#include "base/grammar.h"
#include "base/math/functions.h"
#include "base/text.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LENGTH, MASS, TIME, BASES };
enum { VALUES_MAX = 128, POWER_MAX = 9, TENS_MAX = 400, LETTERS_MAX = 4 };

typedef struct Value {
    double number;
    int tens;         /* times 10^tens */
    int bases[BASES]; /* m, kg, s */
} Value;

enum { UNIT_NAME_MAX = 32 };

typedef struct Reader {
    Value values[VALUES_MAX]; /* a stack */
    int count;
    const char *why;          /* NULL: sound so far */
    char name[UNIT_NAME_MAX]; /* of a unit that there is none of; "" */
} Reader;

static const struct {
    const char *name;
    int tens, bases[BASES];
} units[] = {{"m", 0, {1, 0, 0}},    {"g", -3, {0, 1, 0}}, {"s", 0, {0, 0, 1}}, {"N", 0, {1, 1, -2}},
             {"Pa", 0, {-1, 1, -2}}, {"J", 0, {2, 1, -2}}, {"W", 0, {2, 1, -3}}};
/* no Hz: a rate is not a count of cycles */

static const struct {
    const char *name;
    int tens;
} prefixes[] = {{"T", 12}, {"G", 9},  {"M", 6},         {"k", 3},         {"c", -2}, {"m", -3},
                {"u", -6}, {"n", -9}, {"\302\265", -6}, {"\316\274", -6}, {"p", -12}};

static bool fail(Reader *reader, const char *why)
{
    reader->why = why;
    return false;
}

static bool refuse(Grammar *grammar, const char *wanted, const char *token)
{
    return fail(grammar->context, !wanted                    ? token
                                  : strcmp(wanted, ")") == 0 ? "has a bracket that is not closed"
                                                             : "is not a number");
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
static bool fail_unit(Grammar *grammar)
{
    Reader *reader = grammar->context;
    const char *word = grammar->at;
    size_t length = 0;
    if (strcspn(grammar->text, "0123456789") >= (size_t)(word - grammar->text))
        return fail(reader, "is not a number");
    while (length < UNIT_NAME_MAX - 1 && word[length] &&
           (grammar_is_letter(word[length]) || strchr("0123456789^/*-", word[length])))
        length++;
    for (size_t whole = length; whole > 0; whole--) /* whole characters, where they are some */
        if (((unsigned char)word[whole] & 0xc0) != 0x80) {
            length = whole;
            break;
        }
    snprintf(reader->name, sizeof reader->name, "%.*s", (int)length, word);
    return fail(reader, "cannot be read");
}

/* A unit, one with a prefix, or a prefix alone (not c); "m" is a metre. */
static bool find_word(const char *word, Value *value)
{
    *value = (Value){.number = 3.14159265358979323846};
    if (strcmp(word, "pi") == 0 || unit_of(word, 0, value))
        return true;
    for (size_t i = 0; i < sizeof prefixes / sizeof *prefixes; i++) {
        const size_t length = strlen(prefixes[i].name);
        if (strncmp(word, prefixes[i].name, length) != 0)
            continue;
        *value = (Value){.number = 1, .tens = prefixes[i].tens};
        return word[length] ? unit_of(word + length, prefixes[i].tens, value) : prefixes[i].tens != -2;
    }
    return false;
}

static bool put(Grammar *grammar, Value value)
{
    Reader *reader = grammar->context;
    if (reader->count == VALUES_MAX)
        return fail(reader, "is too long");
    reader->values[reader->count++] = value;
    return true;
}

static bool read_number(Grammar *grammar, double number)
{
    return put(grammar, (Value){.number = number});
}

static bool apply(Grammar *, GrammarVerb, int power);

static bool read_word(Grammar *grammar)
{
    char word[LETTERS_MAX + 1] = "";
    const int none[BASES] = {0};
    int power;
    size_t length = 0;
    Value value;
    while (grammar_is_letter(grammar->at[length]))
        length++;
    if (length <= LETTERS_MAX)
        memcpy(word, grammar->at, length);
    if (length > LETTERS_MAX || !find_word(word, &value))
        return fail_unit(grammar);
    const bool powered =
        isdigit((unsigned char)grammar->at[length]) && memcmp(value.bases, none, sizeof none) != 0;
    grammar_pass(grammar, length);
    return put(grammar, value) &&
           (!powered || (grammar_read_power(grammar, &power) && apply(grammar, VERB_POWER, power)));
}

/* --- arithmetic --------------------------------------------------------------------------------------- */

/* Far from what a unit or a number can be, and from what an int can hold. */
static bool is_bounded(Reader *reader, const Value *value)
{
    bool bounded = abs(value->tens) <= TENS_MAX;
    for (int i = 0; i < BASES; i++)
        bounded &= abs(value->bases[i]) <= POWER_MAX;
    return bounded || fail(reader, "is not a number");
}

static bool multiply(Reader *reader, Value *value, const Value *other, bool divides)
{
    if (divides && other->number == 0)
        return fail(reader, "divides by zero");
    value->number = divides ? value->number / other->number : value->number * other->number;
    value->tens += divides ? -other->tens : other->tens;
    for (int i = 0; i < BASES; i++)
        value->bases[i] += divides ? -other->bases[i] : other->bases[i];
    return is_bounded(reader, value);
}

static bool apply(Grammar *grammar, GrammarVerb verb, int power)
{
    Reader *reader = grammar->context;
    const Value *last = &reader->values[reader->count - 1];
    reader->count -= verb >= VERB_ADD; /* of two values one is left */
    Value *value = &reader->values[reader->count - 1];
    switch (verb) {
    case VERB_ADD:
    case VERB_SUBTRACT:
        if (memcmp(value->bases, last->bases, sizeof value->bases) != 0)
            return fail(reader, "adds what has different units");
        value->number = shifted(value->number, value->tens) +
                        (verb == VERB_ADD ? 1 : -1) * shifted(last->number, last->tens);
        value->tens = 0;
        return true;
    case VERB_MULTIPLY:
    case VERB_DIVIDE:
        return multiply(reader, value, last, verb == VERB_DIVIDE);
    case VERB_POWER:
        if (power < 0 && value->number == 0)
            return fail(reader, "divides by zero");
        value->number = math_pow(value->number, power);
        value->tens *= power;
        for (int i = 0; i < BASES; i++)
            value->bases[i] *= power;
        return is_bounded(reader, value);
    case VERB_PERCENT:
        value->tens -= 2;
        return true;
    default:
        value->number = verb == VERB_ABS ? fabs(value->number) : -value->number;
        return true;
    }
}

static const GrammarDialect dialect = {.level = LEVEL_SUM,
                                       .has_units = true,
                                       .number = read_number,
                                       .word = read_word,
                                       .apply = apply,
                                       .refuse = refuse};

static bool read_all(Reader *reader, const char *text)
{
    bool truth;
    Grammar grammar = grammar_of(&dialect, reader, text);
    return grammar_read(&grammar, LEVEL_SUM, &truth) && (!*grammar.at || grammar_refuse(&grammar, "+ - * /"));
}

static bool read_any(const char *text, const char *unit, double *value, char *why)
{
    if (text_to_double(text, value))
        return true;
    const int none[BASES] = {0};
    Reader reader = {.count = 0}, known = {.count = 0};
    const bool sound = read_all(&reader, text);
    const Value read = reader.values[0];
    const double number = sound ? shifted(read.number, read.tens) : NAN;
    if (!sound || !isfinite(number)) {
        if (reader.name[0])
            snprintf(why, QUANTITY_WHY_MAX, "%s: no unit %s here", reader.why, reader.name);
        else
            snprintf(why, QUANTITY_WHY_MAX, "%s", sound ? "is too large" : reader.why);
        return false;
    }
    if (memcmp(read.bases, none, sizeof none) == 0) {
        *value = number; /* in whatever unit is needed */
        return true;
    }
    const bool has_unit = read_all(&known, unit);
    const Value wanted = known.values[0];
    if (!has_unit || memcmp(wanted.bases, none, sizeof none) == 0)
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
