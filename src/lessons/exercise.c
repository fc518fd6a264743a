/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads and judges exercises (exercise.h). */
#include "lessons/exercise.h"

#include "base/math/functions.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

bool exercise_read_answer(const char *text, Exercise *exercise, Status *status)
{
    static const char within[] = " within ";
    char sum[EXPRESSION_MAX], number[NUMBER_TEXT_MAX];
    const char *at = NULL;
    for (const char *found = text; (found = strstr(found, within)); found++)
        at = found;
    *exercise = (Exercise){.kind = EXERCISE_NUMBER};
    if (!at || at - text >= EXPRESSION_MAX)
        return status_refuse(status, "how near is right? (EXPRESSION within NUMBER, or NUMBER %%)");
    snprintf(sum, sizeof sum, "%.*s", (int)(at - text), text);
    at += strlen(within);
    const size_t length = strcspn(at, "%");
    exercise->relative = at[length] == '%';
    snprintf(number, sizeof number, "%.*s", (int)length, at);
    if (length >= sizeof number || !text_to_double(number, &exercise->tolerance) ||
        !(exercise->tolerance > 0) || (exercise->relative && at[length + 1]))
        return status_refuse(status, "within %.40s: is not a tolerance (NUMBER > 0, or NUMBER %%)", at);
    return expression_read(sum, EXPRESSION_NUMBER, &exercise->expression, status);
}

bool exercise_read_goal(const char *text, Exercise *exercise, Status *status)
{
    *exercise = (Exercise){.kind = EXERCISE_GOAL};
    return expression_read(text, EXPRESSION_TRUTH, &exercise->expression, status);
}

bool exercise_accepts(const Exercise *exercise, double right, double given)
{
    const double allowed = exercise->tolerance * (exercise->relative ? fabs(right) / 100 : 1);
    return fabs(given - right) <= allowed * (1 + 1e-9); /* 0.9 within 0.1 is 1, whatever 1 - 0.9 is in bits */
}

double exercise_at_start(const Exercise *exercise, const ExpressionRun *end)
{
    const Expression *sum = &exercise->expression;
    RunSummary start = *end->summary;
    bool of_motion = false;
    for (int i = 0; i < sum->n_steps; i++)
        of_motion |= sum->steps[i].kind == STEP_WORD && !sum->steps[i].word->beforehand;
    if (!of_motion || sum->has_was)
        return NAN;
    start.readout.measured_known = false;
    start.readout.error_frequency = start.readout.error_period = NAN;
    start.readout.late = start.energy_change = start.time = 0;
    start.steps = 0;
    start.crack = (CrackFacts){0};
    start.fronts = (FrontsFacts){0};
    start.price_known = false;
    start.n_findings = 0;
    start.broken_bonds *= 0; /* where there are any */
    return expression_value(sum, &(ExpressionRun){end->settings, &start}, end);
}

static bool read_plain(const char *text, double *number)
{
    char copy[ANSWER_MAX];
    if (strlen(text) >= sizeof copy)
        return false;
    strcpy(copy, text);
    for (size_t length = strlen(copy); length > 0 && strchr(" %", copy[length - 1]);)
        copy[--length] = '\0';
    static const char minus[] = "\u2212"; /* as word processors write it */
    if (strncmp(copy, minus, sizeof minus - 1) == 0) {
        memmove(copy + 1, copy + sizeof minus - 1, strlen(copy + sizeof minus - 1) + 1);
        copy[0] = '-';
    }
    char *comma = strchr(copy, ',');
    if (comma && !strchr(copy, '.'))
        *comma = '.';
    return text_to_double(copy, number);
}

bool exercise_read_number(const char *text, double *number)
{
    const char *slash = strchr(text, '/');
    char above[ANSWER_MAX];
    double below;
    if (!slash)
        return read_plain(text, number);
    if ((size_t)(slash - text) >= sizeof above)
        return false;
    snprintf(above, sizeof above, "%.*s", (int)(slash - text), text);
    for (slash++; *slash == ' ';)
        slash++;
    if (!read_plain(above, number) || !read_plain(slash, &below) || below == 0)
        return false;
    *number /= below;
    return isfinite(*number);
}

void exercise_write_number(double number, char out[NUMBER_TEXT_MAX])
{
    enum { DIGITS = 6 };
    strcpy(out, isfinite(number) ? text_rounded(number, DIGITS).text : "");
}

/* --- goals in words ---------------------------------------------------------------------------------- */

/* A claim, and the runs that it is held against; NULL: not known. */
typedef struct Telling {
    const Expression *goal;
    const ExpressionClaim *claim;
    int middle;                         /* behind its left side; 0: it is shown as it is written */
    const ExpressionStep *left, *right; /* the first of each side */
    const ExpressionRun *now, *was;
} Telling;

static bool is_size(const Telling *telling)
{
    return telling->middle > telling->claim->first + 1 &&
           telling->goal->steps[telling->middle - 1].verb == VERB_ABS &&
           telling->goal->steps[telling->middle - 1].kind == STEP_VERB;
}

/* "error", "cell size"; of a sum its text. */
static void tell_subject(const Telling *telling, char *out, size_t size)
{
    const ExpressionStep *step = telling->left;
    const char *text = telling->goal->text + telling->claim->text;
    const bool single = telling->middle - telling->claim->first == 1 + is_size(telling);
    size_t length = (size_t)telling->claim->length;
    if (telling->middle && single && step->kind == STEP_WORD) {
        text = step->word->called ? step->word->called : step->word->word;
        length = strlen(text);
    } else if (telling->middle && single && step->kind == STEP_KEY) {
        text = step->key->label;
        length = strlen(text);
    } else if (telling->middle) {
        length = strcspn(text, "<>=!");
        while (length > 0 && text[length - 1] == ' ')
            length--;
    }
    text_append(out, size, "%.*s", (int)length, text);
    if (single && step->kind == STEP_WORD)
        for (char *at = out; (at = strchr(at, '_'));)
            *at = ' ';
}

/* A side's value: the word of a choice; a number with its per cent, as many digits as distinguish it from the
 * other. */
static void tell_value(const Telling *telling, double value, double other, char *out, size_t size)
{
    static const char *const flags[] = {"no", "yes", NULL};
    const ExpressionStep *step = telling->left;
    const Parameter *key =
        step->kind == STEP_KEY && telling->middle == telling->claim->first + 1 ? step->key : NULL;
    const char *const *choices = !key ? NULL : key->type == PARAMETER_FLAG ? flags : key->choices;
    int digits = EXPRESSION_DIGITS;
    while (!choices && value != other && digits < 17 &&
           strcmp(text_rounded(value, digits).text, text_rounded(other, digits).text) == 0)
        digits++;
    if (choices)
        text_append(out, size, "%s", choices[(int)value]);
    else
        text_append(out, size, "%s%s", text_rounded(value, digits).text, telling->right->percent ? " %" : "");
}

static double side(const Telling *telling, bool right)
{
    return expression_part(telling->goal, right ? telling->middle : telling->claim->first,
                           right ? telling->claim->end - 1 : telling->middle, telling->now, telling->was);
}

/* "at most 60". */
static void tell_limit(const Telling *telling, char *out, size_t size)
{
    static const char *const words[] = {"below ", "at most ", "above ", "at least ", "", "not "};
    static const char *const sizes[] = {"within ", "within ", "beyond ", "beyond ", "", "not "};
    const int relation = (int)telling->goal->steps[telling->claim->end - 1].verb - (int)VERB_LESS;
    text_append(out, size, "%s", (is_size(telling) ? sizes : words)[relation]);
    const bool of_opening = telling->claim->end - telling->middle == 2 && telling->right->was;
    bool known = true; /* the runs are there that the right side speaks of */
    for (int i = telling->middle; i < telling->claim->end - 1; i++) {
        const ExpressionStep *step = &telling->goal->steps[i];
        if (step->kind == STEP_WORD || step->kind == STEP_KEY)
            known &= (step->was ? telling->was : telling->now) != NULL;
    }
    if (!telling->was && of_opening) {
        text_append(out, size, "as the page opens it");
    } else if (!known) {
        const char *text = telling->goal->text + telling->claim->text;
        size_t skipped = strcspn(text, "<>=!");
        skipped += strspn(text + skipped, "<>=! ");
        text_append(out, size, "%.*s", telling->claim->length - (int)skipped, text + skipped);
    } else {
        const double limit = side(telling, true);
        tell_value(telling, limit, telling->now ? side(telling, false) : limit, out, size);
    }
}

static void tell_failing(const Telling *telling, char *out, size_t size)
{
    tell_subject(telling, out, size);
    if (!telling->middle) {
        text_append(out, size, " does not hold");
        return;
    }
    const double left = side(telling, false);
    if (isnan(left))
        text_append(out, size, " is not known");
    else {
        text_append(out, size, " ");
        tell_value(telling, left, side(telling, true), out, size);
    }
    text_append(out, size, ", must be ");
    tell_limit(telling, out, size);
    if (isfinite(left)) {
        /* The Courant number with which a time step would be as long as it must be, where it comes from
         * one. */
        enum { DIGITS = 5 };
        const Parameter *courant = parameter_find("time.courant");
        const ExpressionStep *step = telling->left;
        if (step->kind != STEP_WORD || strcmp(step->word->word, "dt") != 0 ||
            telling->goal->steps[telling->claim->end - 1].verb != VERB_NOT_LESS ||
            !parameter_applies_to(telling->now->settings, courant))
            return;
        const double wanted =
            settings_number(telling->now->settings, courant) * side(telling, true) / side(telling, false);
        const double unit = math_pow(10, floor(math_log10(wanted)) - (DIGITS - 1));
        if (isfinite(wanted) && wanted > 0)
            text_append(out, size, " (Courant %s)",
                        text_rounded(ceil(wanted / unit * (1 - 1e-9)) * unit, DIGITS).text);
    }
}

static Telling telling_of(const Expression *goal, int claim, const ExpressionRun *now,
                          const ExpressionRun *was)
{
    const ExpressionClaim *one = &goal->claims[claim];
    const int middle = expression_middle(goal, one);
    return (Telling){goal, one, middle, &goal->steps[one->first], &goal->steps[middle], now, was};
}

void exercise_tell_goal(const Exercise *exercise, const ExpressionRun *was, char *out, size_t size)
{
    out[0] = '\0';
    for (int i = 0; i < exercise->expression.n_claims; i++) {
        const Telling telling = telling_of(&exercise->expression, i, NULL, was);
        char one[EXPRESSION_MAX] = "";
        tell_subject(&telling, one, sizeof one);
        if (telling.middle) {
            text_append(one, sizeof one, " ");
            tell_limit(&telling, one, sizeof one);
        }
        text_append(out, size, "%s%s", i > 0 ? "; " : "", one);
    }
}

bool exercise_failing(const Exercise *exercise, const ExpressionRun *now, const ExpressionRun *was, char *out,
                      size_t size)
{
    char met[ANSWER_MAX] = "";
    out[0] = '\0';
    for (int i = 0; i < exercise->expression.n_claims; i++) {
        const Telling telling = telling_of(&exercise->expression, i, now, was);
        char one[ANSWER_MAX] = "";
        if (expression_holds(&exercise->expression, telling.claim, now, was)) {
            tell_subject(&telling, one, sizeof one);
            text_append(met, sizeof met, "%s%s", *met ? ", " : "", one);
        } else {
            tell_failing(&telling, one, sizeof one);
            text_append(out, size, "%s%s", *out ? "; " : "", one);
        }
    }
    if (*out && *met)
        text_append(out, size, ". Met: %s", met);
    return *out != '\0';
}
