/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Makes steps for a stack of what the grammar reads (base/grammar.h), and does them (expression.h). */
#include "lessons/expression.h"

#include "base/grammar.h"
#include "scenario/settings.h"
#include "base/math/functions.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORD_MAX = 64 };

typedef struct Reader {
    Expression *out;
    Status *status;
} Reader;

static Reader *reader_of(Grammar *grammar)
{
    return grammar->context;
}

static bool refuse(Grammar *grammar, const char *wanted, const char *token)
{
    return wanted ? status_refuse(reader_of(grammar)->status, "%s is expected, not: %.40s", wanted, token)
                  : status_refuse(reader_of(grammar)->status, "%s", token);
}

/* --- steps ------------------------------------------------------------------------------------------ */

static bool put(Grammar *grammar, ExpressionStep step)
{
    Expression *out = reader_of(grammar)->out;
    if (out->n_steps == EXPRESSION_STEPS_MAX)
        return status_refuse(reader_of(grammar)->status, "is too long (at most %d numbers and signs)",
                             EXPRESSION_STEPS_MAX);
    out->steps[out->n_steps++] = step;
    return true;
}

static bool put_number(Grammar *grammar, double number)
{
    return put(grammar, (ExpressionStep){.kind = STEP_CONSTANT, .number = number});
}

/* A percent sign only says the unit of a number. */
static bool put_verb(Grammar *grammar, GrammarVerb verb, int power)
{
    Expression *out = reader_of(grammar)->out;
    ExpressionStep *last = &out->steps[out->n_steps - 1];
    if (verb != VERB_PERCENT)
        return put(grammar, (ExpressionStep){.kind = STEP_VERB, .verb = verb, .number = power});
    last->percent = last->kind == STEP_CONSTANT;
    return last->percent || refuse(grammar, "a number", "%");
}

static bool read_word(Grammar *grammar)
{
    Status *status = reader_of(grammar)->status;
    char word[WORD_MAX];
    const bool was = grammar_take(grammar, "was");
    if (was && !grammar_is_letter(*grammar->at))
        return grammar_refuse(grammar, "a parameter or a word of the mesh after was");
    const size_t length = grammar_token(grammar, word, sizeof word);
    const RunNumber *number = run_number_find(word);
    const Parameter *key = parameter_find(word);
    if (!number && !key)
        return status_refuse(status, "%.40s is neither a number of a run nor a parameter (see: man 5 matvib)",
                             word);
    if (was && number && !number->beforehand)
        return status_refuse(status,
                             "was %s: is known of a run that has ended only (was is for parameters, mesh and "
                             "time step)",
                             word);
    if (key && key->type == PARAMETER_TEXT)
        return status_refuse(status, "%s is not a number", word);
    reader_of(grammar)->out->has_was |= was;
    grammar_pass(grammar, length);
    return number ? put(grammar, (ExpressionStep){.kind = STEP_WORD, .word = number, .was = was})
                  : put(grammar, (ExpressionStep){.kind = STEP_KEY, .key = key, .was = was});
}

/* The word of a choice behind its parameter, as the number that settings_number() has for it. */
static bool choose(Grammar *grammar, GrammarVerb verb, bool *chosen)
{
    static const char *const flags[] = {"no", "yes", NULL};
    const Expression *out = reader_of(grammar)->out;
    const Parameter *key = out->steps[out->n_steps - 1].key;
    char known[160] = "";
    if (!key || (key->type != PARAMETER_CHOICE && key->type != PARAMETER_FLAG))
        return true;
    if (verb != VERB_EQUAL && verb != VERB_UNEQUAL)
        return grammar_refuse(grammar, "= or !=");
    grammar_pass(grammar, verb == VERB_EQUAL ? 1 : 2);
    *chosen = true;
    const char *const *choices = key->type == PARAMETER_FLAG ? flags : key->choices;
    for (int i = 0; choices[i]; i++) {
        if (grammar_take(grammar, choices[i]))
            return put_number(grammar, i);
        text_or(known, sizeof known, choices[i]);
    }
    return status_refuse(reader_of(grammar)->status, "%s is compared with one of its choices (%s)", key->key,
                         known);
}

static const GrammarDialect dialect = {.level = LEVEL_OR,
                                       .number = put_number,
                                       .word = read_word,
                                       .apply = put_verb,
                                       .choose = choose,
                                       .refuse = refuse};

/* A goal is a list of claims, each of which is reported by itself where it does not hold; with "or" between
 * them it is one. */
static bool read_claims(Grammar *grammar)
{
    Expression *out = reader_of(grammar)->out;
    bool truth;
    do {
        const int text = (int)(grammar->at - out->text), first = out->n_steps;
        if (out->n_claims == EXPRESSION_CLAIMS_MAX)
            return status_refuse(reader_of(grammar)->status, "asks for too much (at most %d things)",
                                 EXPRESSION_CLAIMS_MAX);
        if (!grammar_read(grammar, LEVEL_RELATION, &truth) || !grammar_expect(grammar, truth, true))
            return false;
        out->claims[out->n_claims++] =
            (ExpressionClaim){text, (int)(grammar->end - out->text) - text, first, out->n_steps};
    } while (grammar_take(grammar, "and"));
    if (!grammar_take(grammar, "or"))
        return true;
    for (; out->n_claims > 1; out->n_claims--)
        if (!put_verb(grammar, VERB_AND, 0))
            return false;
    do
        if (!grammar_read(grammar, LEVEL_AND, &truth) || !grammar_expect(grammar, truth, true) ||
            !put_verb(grammar, VERB_OR, 0))
            return false;
    while (grammar_take(grammar, "or"));
    out->claims[0].length = (int)(grammar->end - out->text) - out->claims[0].text;
    out->claims[0].end = out->n_steps;
    return true;
}

bool expression_read(const char *text, ExpressionKind kind, Expression *out, Status *status)
{
    bool truth = false;
    *out = (Expression){.kind = kind};
    if (strlen(text) >= sizeof out->text)
        return status_refuse(status, "is too long (at most %d bytes)", EXPRESSION_MAX - 1);
    strcpy(out->text, text);
    Reader reader = {out, status};
    Grammar grammar = grammar_of(&dialect, &reader, out->text);
    return (kind == EXPRESSION_TRUTH
                ? read_claims(&grammar)
                : grammar_read(&grammar, LEVEL_SUM, &truth) && grammar_expect(&grammar, truth, false)) &&
           (!*grammar.at || grammar_refuse(&grammar, kind == EXPRESSION_TRUTH ? "and, or" : "+ - * /"));
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
    const char *automatic = parameter_in(step->key, run->settings->problem).automatic;
    return automatic && strcmp(automatic, text) == 0 ? NAN : settings_number(run->settings, step->key);
}

static double as_told(double number)
{
    return strtod(text_rounded(number, EXPRESSION_DIGITS).text, NULL);
}

/* The truth of a relation or the number of a sign, from what stands left and right of it; what is not known
 * fulfils no relation. */
static double combine(GrammarVerb verb, double a, double b)
{
    const bool whole = a == floor(a) && b == floor(b);
    const bool same = a == b || (!whole && as_told(a) == as_told(b));
    switch (verb) {
    case VERB_ADD:
        return a + b;
    case VERB_SUBTRACT:
        return a - b;
    case VERB_MULTIPLY:
        return a * b;
    case VERB_DIVIDE:
        return a / b;
    case VERB_AND:
        return a != 0 && b != 0;
    case VERB_OR:
        return a != 0 || b != 0;
    case VERB_LESS:
        return a < b;
    case VERB_NOT_MORE:
        return a < b || same;
    case VERB_MORE:
        return a > b;
    case VERB_NOT_LESS:
        return a > b || same;
    case VERB_EQUAL:
        return same;
    default:
        return !same && !isnan(a) && !isnan(b);
    }
}

/* How many numbers a step takes from the stack; each puts one there. */
static int taken_by(const ExpressionStep *step)
{
    return step->kind != STEP_VERB ? 0 : step->verb < VERB_ADD ? 1 : 2;
}

double expression_part(const Expression *expression, int first, int end, const ExpressionRun *now,
                       const ExpressionRun *was)
{
    double stack[EXPRESSION_STEPS_MAX];
    int top = 0;
    for (int i = first; i < end; i++) {
        const ExpressionStep *step = &expression->steps[i];
        top += 1 - taken_by(step);
        double *a = &stack[top - 1];
        *a = step->kind != STEP_VERB    ? value_of(step, step->was ? was : now)
             : step->verb == VERB_MINUS ? -*a
             : step->verb == VERB_ABS   ? fabs(*a)
             : step->verb == VERB_POWER ? math_pow(*a, step->number)
                                        : combine(step->verb, a[0], a[1]);
    }
    return top > 0 ? stack[0] : NAN;
}

int expression_middle(const Expression *expression, const ExpressionClaim *claim)
{
    int middle = 0;
    for (int i = claim->first, top = 0; i < claim->end - 1; i++) {
        const ExpressionStep *step = &expression->steps[i];
        if (step->kind == STEP_VERB && step->verb >= VERB_LESS && step->verb <= VERB_UNEQUAL)
            return 0;
        top += 1 - taken_by(step);
        if (top == 1)
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
