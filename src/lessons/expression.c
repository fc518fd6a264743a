/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads an expression by descent into steps for a stack, and does them (expression.h). */
#include "lessons/expression.h"

#include "scenario/settings.h"
#include "base/text.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DEPTH_MAX = 24, TOKEN_MAX = 64 };

typedef struct Parser {
    Expression *out;
    const char *at; /* behind the token */
    char token[TOKEN_MAX];
    int token_start, token_end; /* in the text; where the one before it ended is `last_end` */
    int last_end;
    int depth;
    Status *status;
} Parser;

/* --- tokens ----------------------------------------------------------------------------------------- */

static bool is_letter(char c)
{
    return isalpha((unsigned char)c) || c == '_';
}

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
    if (is_letter(*text)) {
        while (is_letter(text[length]) || isdigit((unsigned char)text[length]) || text[length] == '.' ||
               (text[length] == '-' && is_letter(text[length + 1])))
            length++;
        return length;
    }
    if (isdigit((unsigned char)*text) || *text == '.')
        return number_length(text);
    if (strchr("<>!", *text) && text[0] && text[1] == '=')
        return 2;
    return *text != '\0';
}

static void next(Parser *parser)
{
    parser->last_end = parser->token_end;
    parser->at += strspn(parser->at, " \t");
    const size_t length = token_length(parser->at);
    parser->token_start = (int)(parser->at - parser->out->text);
    parser->at += length;
    parser->token_end = (int)(parser->at - parser->out->text);
    snprintf(parser->token, sizeof parser->token, "%.*s", (int)length, parser->at - length);
}

static bool is(const Parser *parser, const char *token)
{
    return strcmp(parser->token, token) == 0;
}

static bool take(Parser *parser, const char *token)
{
    if (!is(parser, token))
        return false;
    next(parser);
    return true;
}

static bool expected(Parser *parser, const char *what)
{
    return status_refuse(parser->status, "%s is wanted, not: %.40s", what,
                         *parser->token ? parser->token : "the end of the line");
}

/* --- steps ------------------------------------------------------------------------------------------ */

static bool put(Parser *parser, ExpressionStep step)
{
    Expression *out = parser->out;
    if (out->n_steps == EXPRESSION_STEPS_MAX)
        return status_refuse(parser->status, "is too long (at most %d numbers and signs)",
                             EXPRESSION_STEPS_MAX);
    out->steps[out->n_steps++] = step;
    return true;
}

static bool deeper(Parser *parser)
{
    return ++parser->depth <= DEPTH_MAX ||
           status_refuse(parser->status, "has too many parentheses within each other (at most %d)",
                         DEPTH_MAX);
}

/* Signs between two sides, by how close they bind; a side is a truth or a number. */
enum { OR, AND, RELATION, SUM, PRODUCT, LEVELS };

typedef struct Sign {
    const char *token;
    ExpressionVerb verb;
    int level;
} Sign;

static const Sign signs[] = {{"or", STEP_OR, OR},           {"and", STEP_AND, AND},
                             {"<", STEP_LESS, RELATION},    {"<=", STEP_NOT_MORE, RELATION},
                             {">", STEP_MORE, RELATION},    {">=", STEP_NOT_LESS, RELATION},
                             {"=", STEP_EQUAL, RELATION},   {"!=", STEP_UNEQUAL, RELATION},
                             {"+", STEP_ADD, SUM},          {"-", STEP_SUBTRACT, SUM},
                             {"*", STEP_MULTIPLY, PRODUCT}, {"/", STEP_DIVIDE, PRODUCT}};

/* The sign that comes next, if it binds so close; NULL: it does not. */
static const Sign *sign_at(const Parser *parser, int level)
{
    for (size_t i = 0; i < sizeof signs / sizeof *signs; i++)
        if (signs[i].level == level && is(parser, signs[i].token))
            return &signs[i];
    return NULL;
}

static bool check(Parser *parser, bool truth, bool wanted)
{
    return truth == wanted || (wanted ? expected(parser, "a relation (< <= > >= = !=)")
                                      : status_refuse(parser->status, "a number is wanted, not a relation"));
}

static bool read_level(Parser *, int level, bool *truth);

static bool read_number_at(Parser *parser, int level)
{
    bool truth;
    return read_level(parser, level, &truth) && check(parser, truth, false);
}

static bool read_word(Parser *parser, bool was)
{
    char word[TOKEN_MAX];
    const RunNumber *number = run_number_find(parser->token);
    const Parameter *key = parameter_find(parser->token);
    snprintf(word, sizeof word, "%s", parser->token);
    if (!number && !key)
        return status_refuse(parser->status,
                             "%.40s is neither a number of a run nor a parameter (see: man 5 matvib)", word);
    if (was && number && !number->beforehand)
        return status_refuse(parser->status,
                             "was %s: is known of a run that has ended only (was is for parameters, mesh and "
                             "time step)",
                             word);
    if (key && key->type == PARAMETER_TEXT)
        return status_refuse(parser->status, "%s is not a number", word);
    parser->out->has_was |= was;
    next(parser);
    return number ? put(parser, (ExpressionStep){.kind = STEP_WORD, .word = number, .was = was})
                  : put(parser, (ExpressionStep){.kind = STEP_KEY, .key = key, .was = was});
}

static bool read_number(Parser *parser)
{
    double value;
    if (!text_to_double(parser->token, &value))
        return expected(parser, "a number");
    next(parser);
    const bool percent = take(parser, "%");
    return put(parser, (ExpressionStep){.kind = STEP_CONSTANT, .number = value, .percent = percent});
}

static bool read_factor(Parser *parser, bool *truth)
{
    bool sound;
    *truth = false;
    if (!deeper(parser))
        return false;
    if (take(parser, "-")) {
        sound = read_number_at(parser, LEVELS) && put(parser, (ExpressionStep){.kind = STEP_MINUS});
    } else if (take(parser, "abs")) {
        sound = (take(parser, "(") || expected(parser, "( behind abs")) && read_number_at(parser, SUM) &&
                (take(parser, ")") || expected(parser, ")")) &&
                put(parser, (ExpressionStep){.kind = STEP_ABS});
    } else if (take(parser, "(")) {
        sound = read_level(parser, OR, truth) && (take(parser, ")") || expected(parser, ")"));
    } else if (take(parser, "was")) {
        sound = is_letter(*parser->token) ? read_word(parser, true)
                                          : expected(parser, "a parameter or a word of the mesh behind was");
    } else if (is_letter(*parser->token)) {
        sound = read_word(parser, false);
    } else {
        sound = read_number(parser);
    }
    parser->depth--;
    return sound;
}

/* The word of a choice behind its parameter, as the number that settings_number() has for it. */
static bool read_choice(Parser *parser, const Parameter *key)
{
    static const char *const flags[] = {"no", "yes", NULL};
    const char *const *choices = key->type == PARAMETER_FLAG ? flags : key->choices;
    char known[160] = "";
    for (int i = 0; choices[i]; i++) {
        if (is(parser, choices[i])) {
            next(parser);
            return put(parser, (ExpressionStep){.kind = STEP_CONSTANT, .number = i});
        }
        text_or(known, sizeof known, choices[i]);
    }
    return status_refuse(parser->status, "%s is compared with one of its choices (%s)", key->key, known);
}

/* The parameter with choices that is all of a side, which began with this step; NULL: it is none. */
static const Parameter *choice_at(const Parser *parser, int first)
{
    const ExpressionStep *step = &parser->out->steps[first];
    const bool has_words = parser->out->n_steps == first + 1 && step->kind == STEP_KEY &&
                           (step->key->type == PARAMETER_CHOICE || step->key->type == PARAMETER_FLAG);
    return has_words ? step->key : NULL;
}

/* Sides with the signs of a level between them, from the left; a relation has two. */
static bool read_level(Parser *parser, int level, bool *truth)
{
    const int first = parser->out->n_steps;
    const bool joins_truths = level < RELATION;
    const Sign *sign;
    if (level == LEVELS)
        return read_factor(parser, truth);
    if (!read_level(parser, level + 1, truth))
        return false;
    while ((sign = sign_at(parser, level)) != NULL) {
        const Parameter *key = level == RELATION ? choice_at(parser, first) : NULL;
        bool right = false;
        if (key && strchr("<>", *sign->token))
            return expected(parser, "= or !=");
        if (!check(parser, *truth, joins_truths))
            return false;
        next(parser);
        if (!(key ? read_choice(parser, key) : read_level(parser, level + 1, &right)) ||
            (!key && !check(parser, right, joins_truths)) ||
            !put(parser, (ExpressionStep){.kind = sign->verb}))
            return false;
        *truth = level <= RELATION;
        if (level == RELATION)
            break;
    }
    return true;
}

/* A goal is a list of claims, each of which is told by itself where it does not hold; with "or" between them
 * it is one. */
static bool read_claims(Parser *parser)
{
    Expression *out = parser->out;
    bool truth;
    do {
        const int text = parser->token_start, first = out->n_steps;
        if (out->n_claims == EXPRESSION_CLAIMS_MAX)
            return status_refuse(parser->status, "asks for too much (at most %d things)",
                                 EXPRESSION_CLAIMS_MAX);
        if (!read_level(parser, RELATION, &truth) || !check(parser, truth, true))
            return false;
        out->claims[out->n_claims++] = (ExpressionClaim){text, parser->last_end - text, first, out->n_steps};
    } while (take(parser, "and"));
    if (!is(parser, "or"))
        return true;
    for (; out->n_claims > 1; out->n_claims--)
        if (!put(parser, (ExpressionStep){.kind = STEP_AND}))
            return false;
    while (take(parser, "or"))
        if (!read_level(parser, AND, &truth) || !check(parser, truth, true) ||
            !put(parser, (ExpressionStep){.kind = STEP_OR}))
            return false;
    out->claims[0].length = parser->last_end - out->claims[0].text;
    out->claims[0].end = out->n_steps;
    return true;
}

bool expression_read(const char *text, ExpressionKind kind, Expression *out, Status *status)
{
    *out = (Expression){.kind = kind};
    if (strlen(text) >= sizeof out->text)
        return status_refuse(status, "is too long (at most %d bytes)", EXPRESSION_MAX - 1);
    strcpy(out->text, text);
    Parser parser = {.out = out, .at = out->text, .status = status};
    next(&parser);
    return (kind == EXPRESSION_TRUTH ? read_claims(&parser) : read_number_at(&parser, SUM)) &&
           (!*parser.token || expected(&parser, kind == EXPRESSION_TRUTH ? "and, or" : "+ - * /"));
}

/* --- values ----------------------------------------------------------------------------------------- */

static double value_of(const ExpressionStep *step, const ExpressionRun *run)
{
    if (step->kind == STEP_CONSTANT)
        return step->number;
    if (step->kind == STEP_WORD)
        return step->word->value(run->summary, step->word->word);
    /* what the run does not have is not known; nor is a word that stands for "as it comes" a number */
    char text[LIST_MAX];
    if (!parameter_applies_to(run->settings, step->key))
        return NAN;
    settings_get(run->settings, step->key, text);
    const char *automatic = parameter_automatic(step->key, run->settings->problem);
    return automatic && strcmp(automatic, text) == 0 ? NAN : settings_number(run->settings, step->key);
}

static double as_told(double number)
{
    return strtod(text_rounded(number, EXPRESSION_DIGITS).text, NULL);
}

/* The truth of a relation or the number of a sign, from what stands left and right of it; what is not known
 * fulfils no relation. */
static double combine(ExpressionVerb verb, double a, double b)
{
    const bool whole = a == floor(a) && b == floor(b);
    const bool same = a == b || (!whole && as_told(a) == as_told(b));
    switch (verb) {
    case STEP_ADD:
        return a + b;
    case STEP_SUBTRACT:
        return a - b;
    case STEP_MULTIPLY:
        return a * b;
    case STEP_DIVIDE:
        return a / b;
    case STEP_AND:
        return a != 0 && b != 0;
    case STEP_OR:
        return a != 0 || b != 0;
    case STEP_LESS:
        return a < b;
    case STEP_NOT_MORE:
        return a < b || same;
    case STEP_MORE:
        return a > b;
    case STEP_NOT_LESS:
        return a > b || same;
    case STEP_EQUAL:
        return same;
    default:
        return !same && !isnan(a) && !isnan(b);
    }
}

double expression_part(const Expression *expression, int first, int end, const ExpressionRun *now,
                       const ExpressionRun *was)
{
    double stack[EXPRESSION_STEPS_MAX];
    int top = 0;
    for (int i = first; i < end; i++) {
        const ExpressionStep *step = &expression->steps[i];
        if (step->kind <= STEP_KEY) {
            stack[top++] = value_of(step, step->was ? was : now);
        } else if (step->kind == STEP_MINUS || step->kind == STEP_ABS) {
            const double a = stack[top - 1];
            stack[top - 1] = step->kind == STEP_MINUS ? -a : fabs(a);
        } else {
            const double b = stack[--top];
            stack[top - 1] = combine(step->kind, stack[top - 1], b);
        }
    }
    return top > 0 ? stack[0] : NAN;
}

int expression_middle(const Expression *expression, const ExpressionClaim *claim)
{
    int middle = 0;
    for (int i = claim->first, top = 0; i < claim->end; i++) {
        const ExpressionStep *step = &expression->steps[i];
        if (step->kind >= STEP_LESS && step->kind <= STEP_UNEQUAL && i + 1 < claim->end)
            return 0;
        top += step->kind <= STEP_KEY ? 1 : step->kind == STEP_MINUS || step->kind == STEP_ABS ? 0 : -1;
        if (top == 1 && i + 1 < claim->end)
            middle = i + 1;
    }
    return middle;
}

bool expression_holds(const Expression *expression, const ExpressionClaim *claim, const ExpressionRun *now,
                      const ExpressionRun *was)
{
    return expression_part(expression, claim->first, claim->end, now, was) != 0;
}

double expression_value(const Expression *expression, const ExpressionRun *now, const ExpressionRun *was)
{
    if (expression->kind == EXPRESSION_NUMBER)
        return expression_part(expression, 0, expression->n_steps, now, was);
    for (int i = 0; i < expression->n_claims; i++)
        if (!expression_holds(expression, &expression->claims[i], now, was))
            return 0;
    return 1;
}
