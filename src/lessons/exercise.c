/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads and judges exercises (exercise.h). */
#include "lessons/exercise.h"

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
        return status_refuse(status, "within %.40s: is no tolerance (NUMBER > 0, or NUMBER %%)", at);
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
    for (int i = 0; i < start.n_columns; i++)
        if (strcmp(start.columns[i].quantity.name, "broken_bonds") == 0)
            start.last_row[i] = 0;
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

bool exercise_failing(const Exercise *exercise, const ExpressionRun *now, const ExpressionRun *was, char *out,
                      size_t size)
{
    const Expression *goal = &exercise->expression;
    double left;
    const int failing = expression_failing(goal, now, was, &left);
    out[0] = '\0';
    if (failing < 0)
        return false;
    const ExpressionClaim *claim = &goal->claims[failing];
    snprintf(out, size, "%.*s", claim->length, goal->text + claim->text);
    if (isfinite(left) && claim->end - claim->first == 3 && goal->steps[claim->first].kind == STEP_KEY &&
        goal->steps[claim->first].key->choices)
        return true; /* a choice has a word, not a number */
    if (isfinite(left))
        text_append(out, size, ": it is %s", text_rounded(left, 4).text);
    return true;
}
