/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What an exercise asks of a run, as a line of text: "abs(error) < 1 and cells <= 60 and dt >= was dt",
 * in the grammar of base/grammar.h, with words, also as "was" WORD, and KEY ("=" | "!=") WORD for a relation.
 *
 * WORD is a number of a run (run_numbers.h), KEY a parameter ("mesh.cell_size"); a parameter with choices is
 * compared with one of them. The rows of a plate ("loads.top.sy") are not parameters and cannot be used.
 * `was` takes the value that a parameter, the mesh or the step had as the page was opened. A % behind a
 * number only says its unit: errors are in percent already. What is not known fulfils no relation. */
#ifndef LESSONS_EXPRESSION_H
#define LESSONS_EXPRESSION_H

#include "answers/run_numbers.h"
#include "base/grammar.h"
#include "scenario/parameters.h"

enum { EXPRESSION_MAX = 240, EXPRESSION_STEPS_MAX = 96, EXPRESSION_CLAIMS_MAX = 8 };

typedef enum ExpressionKind { EXPRESSION_NUMBER, EXPRESSION_TRUTH } ExpressionKind;

/* One step of a calculation with a stack. */
typedef struct ExpressionStep {
    enum { STEP_CONSTANT, STEP_WORD, STEP_KEY, STEP_VERB } kind;
    bool was;
    bool percent;  /* of a number: it says so behind it */
    double number; /* or the power */
    GrammarVerb verb;
    const RunNumber *word;
    const Parameter *key;
} ExpressionStep;

/* A part between "and" and "and", or all of a goal that has "or" outside parentheses: its text and its steps.
 */
typedef struct ExpressionClaim {
    int text, length;
    int first, end;
} ExpressionClaim;

typedef struct Expression {
    char text[EXPRESSION_MAX];
    ExpressionKind kind;
    ExpressionStep steps[EXPRESSION_STEPS_MAX];
    int n_steps;
    ExpressionClaim claims[EXPRESSION_CLAIMS_MAX]; /* of a truth */
    int n_claims;
    bool has_was;
} Expression;

/* A run that it is held against. */
typedef struct ExpressionRun {
    const Settings *settings;
    const RunSummary *summary;
} ExpressionRun;

/* Reads one of the requested kind. False: the status says what is wrong, and where. */
bool expression_read(const char *text, ExpressionKind, Expression *, Status *);

/* Its value, 1 or 0 of a truth; NAN: not known. `was` is for words behind "was", with what is known
 * beforehand. */
double expression_value(const Expression *, const ExpressionRun *now, const ExpressionRun *was);

/* Numbers are compared as they are shown to the student, with so many digits (whole ones exactly): 0.0099999
 * is not less than 0.01. */
enum { EXPRESSION_DIGITS = 4 };

/* Whether a claim of a truth holds. */
bool expression_holds(const Expression *, const ExpressionClaim *, const ExpressionRun *now,
                      const ExpressionRun *was);

/* The value of the steps from `first` to before `end`. */
double expression_part(const Expression *, int first, int end, const ExpressionRun *now,
                       const ExpressionRun *was);

/* Of a claim that is one relation the step behind its left side; 0: it is none, or several. */
int expression_middle(const Expression *, const ExpressionClaim *);

#endif
