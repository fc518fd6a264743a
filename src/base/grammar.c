/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/grammar.h"

#include "base/text.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum { DEPTH_MAX = 20, TOKEN_MAX = 64 };

/* --- tokens ----------------------------------------------------------------------------------------- */

/* Of any alphabet: micro is a prefix. */
bool grammar_is_letter(char c)
{
    return isalpha((unsigned char)c) || c == '_' || (unsigned char)c >= 0x80;
}

/* Digits with a point and an exponent, nothing else that strtod() takes. */
static size_t number_length(const char *text)
{
    size_t length = strspn(text, "0123456789.");
    if (length > 0 && (text[length] == 'e' || text[length] == 'E')) {
        const size_t sign = text[length + 1] == '-' || text[length + 1] == '+';
        const size_t digits = strspn(text + length + 1 + sign, "0123456789");
        length += digits > 0 ? 1 + sign + digits : 0;
    }
    return length;
}

static size_t token_length(const char *text)
{
    size_t length = 0;
    if (grammar_is_letter(*text)) {
        while (grammar_is_letter(text[length]) || isdigit((unsigned char)text[length]) ||
               text[length] == '.' || (text[length] == '-' && grammar_is_letter(text[length + 1])))
            length++;
        return length;
    }
    if (isdigit((unsigned char)*text) || *text == '.')
        return number_length(text);
    if (*text && strchr("<>!", *text) && text[1] == '=')
        return 2;
    return *text != '\0';
}

size_t grammar_token(const Grammar *grammar, char *out, size_t size)
{
    const size_t length = token_length(grammar->at);
    snprintf(out, size, "%.*s", (int)length, grammar->at);
    return length;
}

void grammar_pass(Grammar *grammar, size_t length)
{
    grammar->end = grammar->at += length;
    grammar->at += strspn(grammar->at, " \t");
}

bool grammar_take(Grammar *grammar, const char *token)
{
    const size_t length = strlen(token);
    if (token_length(grammar->at) != length || memcmp(grammar->at, token, length) != 0)
        return false;
    grammar_pass(grammar, length);
    return true;
}

bool grammar_refuse(Grammar *grammar, const char *wanted)
{
    char token[TOKEN_MAX];
    const size_t length = grammar_token(grammar, token, sizeof token);
    return grammar->dialect->refuse(grammar, wanted, length > 0 ? token : "the end of the line");
}

/* --- sides ------------------------------------------------------------------------------------------ */

typedef struct Sign {
    const char *token;
    GrammarVerb verb;
    GrammarLevel level;
} Sign;

static const Sign signs[] = {{"or", VERB_OR, LEVEL_OR},           {"and", VERB_AND, LEVEL_AND},
                             {"<", VERB_LESS, LEVEL_RELATION},    {"<=", VERB_NOT_MORE, LEVEL_RELATION},
                             {">", VERB_MORE, LEVEL_RELATION},    {">=", VERB_NOT_LESS, LEVEL_RELATION},
                             {"=", VERB_EQUAL, LEVEL_RELATION},   {"!=", VERB_UNEQUAL, LEVEL_RELATION},
                             {"+", VERB_ADD, LEVEL_SUM},          {"-", VERB_SUBTRACT, LEVEL_SUM},
                             {"*", VERB_MULTIPLY, LEVEL_PRODUCT}, {"/", VERB_DIVIDE, LEVEL_PRODUCT}};

/* The sign that comes next, if it binds so close; NULL: it does not. */
static const Sign *sign_at(const Grammar *grammar, GrammarLevel level)
{
    char token[TOKEN_MAX];
    grammar_token(grammar, token, sizeof token);
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++)
        if (signs[i].level == level && strcmp(token, signs[i].token) == 0)
            return &signs[i];
    return NULL;
}

static bool apply(Grammar *grammar, GrammarVerb verb, int power)
{
    grammar->operands++;
    return grammar->dialect->apply(grammar, verb, power);
}

bool grammar_expect(Grammar *grammar, bool truth, bool wanted)
{
    return truth == wanted ||
           (wanted ? grammar_refuse(grammar, "a relation (< <= > >= = !=)")
                   : grammar->dialect->refuse(grammar, NULL, "a number is expected, not a relation"));
}

static bool read_number_at(Grammar *grammar, GrammarLevel level)
{
    bool truth;
    return grammar_read(grammar, level, &truth) && grammar_expect(grammar, truth, false);
}

static bool read_primary(Grammar *grammar, bool *truth)
{
    char token[TOKEN_MAX];
    double value;
    *truth = false;
    if (grammar_take(grammar, "abs"))
        return (grammar_take(grammar, "(") || grammar_refuse(grammar, "( after abs")) &&
               read_number_at(grammar, LEVEL_SUM) &&
               (grammar_take(grammar, ")") || grammar_refuse(grammar, ")")) && apply(grammar, VERB_ABS, 0);
    if (grammar_take(grammar, "("))
        return grammar_read(grammar, grammar->dialect->level, truth) &&
               (grammar_take(grammar, ")") || grammar_refuse(grammar, ")"));
    grammar->operands++;
    if (grammar_is_letter(*grammar->at))
        return grammar->dialect->word(grammar);
    const size_t length = grammar_token(grammar, token, sizeof token);
    if (length >= sizeof token || number_length(token) == 0 || !text_to_double(token, &value))
        return grammar_refuse(grammar, "a number");
    grammar_pass(grammar, length);
    return grammar->dialect->number(grammar, value);
}

bool grammar_read_power(Grammar *grammar, int *power)
{
    const bool minus = *grammar->at == '-';
    const char *digit = grammar->at + (minus || *grammar->at == '+');
    if (!isdigit((unsigned char)digit[0]) || isdigit((unsigned char)digit[1]) || digit[1] == '.')
        return grammar->dialect->refuse(grammar, NULL, "has a power that is not a whole number up to 9");
    *power = minus ? '0' - *digit : *digit - '0';
    grammar_pass(grammar, (size_t)(digit + 1 - grammar->at));
    return true;
}

/* With its sign; brackets and signs alone are nested. */
static bool read_signed(Grammar *grammar, bool *truth)
{
    int power;
    bool sound;
    if (++grammar->depth > DEPTH_MAX)
        return grammar->dialect->refuse(grammar, NULL, "has too many brackets in each other (at most 20)");
    const bool minus = grammar_take(grammar, "-");
    *truth = false;
    if (minus || grammar_take(grammar, "+"))
        sound = read_number_at(grammar, LEVELS) && (!minus || apply(grammar, VERB_MINUS, 0));
    else
        sound = read_primary(grammar, truth) &&
                (!grammar_take(grammar, "%") ||
                 (grammar_expect(grammar, *truth, false) && apply(grammar, VERB_PERCENT, 0))) &&
                (!grammar_take(grammar, "^") ||
                 (grammar_expect(grammar, *truth, false) && grammar_read_power(grammar, &power) &&
                  apply(grammar, VERB_POWER, power)));
    grammar->depth--;
    return sound;
}

/* True: a unit comes next, as in "5 mm" and "3 1/ms". Of "1/ms" the 1 is passed in any case. */
static bool reach_unit(Grammar *grammar)
{
    if (!grammar->dialect->has_units)
        return false;
    if (grammar->at[0] == '1' && grammar->at[1] == '/' && grammar_is_letter(grammar->at[2]))
        grammar->at++;
    return grammar_is_letter(*grammar->at);
}

/* Sides with the signs of a level between them, from the left; a relation has two. */
bool grammar_read(Grammar *grammar, GrammarLevel level, bool *truth)
{
    static const Sign beside = {"", VERB_MULTIPLY, LEVEL_PRODUCT};
    const int first = grammar->operands;
    const bool joins_truths = level < LEVEL_RELATION;
    if (level == LEVELS)
        return read_signed(grammar, truth);
    if (!grammar_read(grammar, level + 1, truth))
        return false;
    for (;;) {
        const bool unit = level == LEVEL_PRODUCT && reach_unit(grammar);
        const Sign *sign = unit ? &beside : sign_at(grammar, level);
        bool chosen = false, right = false;
        if (!sign)
            return true;
        if (level == LEVEL_RELATION && grammar->dialect->choose && grammar->operands == first + 1 &&
            !grammar->dialect->choose(grammar, sign->verb, &chosen))
            return false;
        if (!chosen) {
            if (!grammar_expect(grammar, *truth, joins_truths))
                return false;
            grammar_pass(grammar, strlen(sign->token));
            if (!grammar_read(grammar, level + 1, &right) || !grammar_expect(grammar, right, joins_truths))
                return false;
        }
        if (!apply(grammar, sign->verb, 0))
            return false;
        *truth = level <= LEVEL_RELATION;
        if (level == LEVEL_RELATION)
            return true;
    }
}

Grammar grammar_of(const GrammarDialect *dialect, void *context, const char *text)
{
    return (Grammar){
        .dialect = dialect, .context = context, .text = text, .at = text + strspn(text, " \t"), .end = text};
}
