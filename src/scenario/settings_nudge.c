/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From one value of a parameter to the next, and to the other answer to a question. */
#include "base/assertion.h"
#include "scenario/parameters.h"
#include "scenario/settings_values.h"
#include "base/math/functions.h"
#include "base/text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Rungs 1, 2, 5 of each decade are numbered: 0 is 1, 1 is 2, 2 is 5, 3 is 10, -1 is 0.5. */
static double rung_value(long rung)
{
    static const char steps[] = "125";
    long decade = (rung - (((rung % 3) + 3) % 3)) / 3;
    char text[NUMBER_TEXT_MAX];
    snprintf(text, sizeof text, "%ce%ld", steps[((rung % 3) + 3) % 3], decade);
    return strtod(text, NULL); /* as if it had been typed */
}

/* The first rung above a positive value (direction 1) or below it (-1). */
static long next_rung(double value, int direction)
{
    long rung = 3 * (long)floor(math_log10(value)) - 3;
    while (rung_value(rung) <= value * (1 + 1e-12))
        rung++;
    if (direction > 0)
        return rung;
    rung--;
    while (rung_value(rung) >= value * (1 - 1e-12))
        rung--;
    return rung;
}

/* Up and down the ladder ... -2 -1 0 1 2 5 ...; the least rung beside 0 depends on what is usual. */
static double next_on_ladder(double value, int direction, double usual, bool whole)
{
    double least = whole ? 1 : 1e-3 * (usual == 0 ? 1 : math_pow(10, floor(math_log10(fabs(usual)) + 1e-9)));
    int outwards = value < 0 ? -direction : direction;
    if (value == 0)
        return direction * rung_value(next_rung(least, 1) - 1);
    if (outwards < 0 && fabs(value) <= least * (1 + 1e-9))
        return 0;
    return copysign(rung_value(next_rung(fabs(value), outwards)), value);
}

/* What is written with twelve digits, so that 0.003 + 0.0005 is 0.0035 and nothing piles up. */
static double as_typed(double value)
{
    char text[NUMBER_TEXT_MAX];
    snprintf(text, sizeof text, "%.12g", value);
    return strtod(text, NULL);
}

/* One more or less in the second digit: 0.025 0.026, 70 71, 100 99. */
static double next_digit(double value, int direction, double usual)
{
    const double towards = value * (1 + direction * copysign(1e-9, value));
    if (value == 0)
        return next_on_ladder(0, direction, usual, false);
    const double next = as_typed(value + direction * math_pow(10, floor(math_log10(fabs(towards))) - 1));
    const double least = 1e-3 * math_pow(10, usual == 0 ? 0 : floor(math_log10(fabs(usual)) + 1e-9));
    return fabs(next) < fabs(value) && fabs(next) < least ? 0 : next;
}

/* Whole spacings more or less: what moves by a part of one cuts the same bonds. */
static double next_place(const Settings *settings, double value, double spacings)
{
    const double dx = lattice_spacing(settings);
    return as_typed((value / dx + spacings) * dx);
}

/* In the map of a body 40 columns wide what moved by this is in the next one. */
static double wide_step(const Settings *settings)
{
    return fmax(1, floor(settings_geometry(settings)->length / (40 * lattice_spacing(settings)) + 1e-9));
}

static double nudged_finely(const Settings *settings, const Parameter *parameter, double value, int direction)
{
    if (parameter->offset == VALUE_OFFSET(mesh.cell_size)) {
        /* A cell more or less in the bar. */
        const double cells = round(settings_geometry(settings)->length / value) - direction;
        return cells >= 1 ? settings_geometry(settings)->length / cells : value;
    }
    if (parameter->type == PARAMETER_INTEGER || parameter->nudge == NUDGE_ONE)
        return value + direction;
    if (parameter->nudge == NUDGE_SHARE)
        return as_typed(value + 0.001 * direction);
    if (parameter->nudge == NUDGE_FIFTH)
        return as_typed(value + 0.01 * direction);
    if (parameter->nudge == NUDGE_SPACING)
        return next_place(settings, value, 0.1 * direction);
    if (parameter->nudge == NUDGE_WIDE)
        return next_place(settings, value, direction);
    return next_digit(value, direction, parameter_in(parameter, settings->problem).usual);
}

static double nudged(const Settings *settings, const Parameter *parameter, double value, int direction)
{
    double usual = parameter_in(parameter, settings->problem).usual;
    int n = 0;
    switch (parameter->nudge) {
    case NUDGE_ONE:
        return value + direction;
    case NUDGE_DOUBLE:
        return direction > 0 ? value * 2 : value / 2;
    case NUDGE_1_2_5:
        return next_on_ladder(value, direction, usual, parameter->type == PARAMETER_INTEGER);
    case NUDGE_SHARE: {
        /* Up and down the shares of a whole. */
        static const double shares[] = {0, .1, .2, .5, .8, .9, .95, .98, .99, .995, .998, .999, 1};
        enum { SHARES = sizeof shares / sizeof *shares };
        int at = direction > 0 ? 0 : SHARES - 1;
        while (at >= 0 && at < SHARES && (shares[at] - value) * direction <= 1e-12)
            at += direction;
        return at >= 0 && at < SHARES ? shares[at] : value;
    }
    case NUDGE_FIFTH:
        return as_typed(value + 0.2 * direction);
    case NUDGE_SPACING:
        return next_place(settings, value, direction);
    case NUDGE_WIDE:
        return next_place(settings, value, direction * wide_step(settings));
    case NUDGE_NEXT:
        n = parameter_in(parameter, settings->problem).n_choices;
        return (int)(value + direction + n) % n;
    case NUDGE_NONE:
        break;
    }
    return value;
}

bool settings_nudge(Settings *settings, const Parameter *parameter, int direction, bool fine, Status *why)
{
    ASSERT(direction == 1 || direction == -1);
    enum { TRIES = 60 }; /* a rung that the other values do not allow is passed over */
    if (!parameter_applies_to(settings, parameter) || parameter->type == PARAMETER_TEXT)
        return false;
    if (parameter->wrong && settings->concealed) { /* its neighbours would reveal it */
        settings_put(settings, parameter, parameter->neutral);
        return true;
    }
    /* a length of the bar's lattice that was left to itself is nudged from what it comes to */
    const double start = parameter->offset == VALUE_OFFSET(lattice.spacing) ? lattice_spacing(settings)
                         : parameter->offset == VALUE_OFFSET(lattice.horizon)
                             ? lattice_horizon(settings)
                             : settings_number(settings, parameter);
    double value = start;
    const double word = parameter->automatic_value;
    if (word != 0 && (start == word ? direction > 0 : start == 0 && direction < 0)) { /* it stands below 0 */
        settings_put(settings, parameter, start == word ? 0 : word);
        return true;
    }
    const bool by_digit = fine && parameter->nudge != NUDGE_NEXT;
    for (int i = 0; i < TRIES; i++) {
        double next = (by_digit ? nudged_finely : nudged)(settings, parameter, value, direction);
        if (next == value || next == start || !settings_in_range(parameter, settings->problem, next))
            return false;
        Settings candidate = *settings;
        settings_put(&candidate, parameter, next);
        if (settings_check(&candidate, i == 0 ? why : NULL)) {
            *settings = candidate;
            return true;
        }
        if (!by_digit && parameter->nudge != NUDGE_NEXT && parameter->nudge != NUDGE_1_2_5)
            return false;
        value = next;
    }
    return false;
}

bool settings_row_nudge(Settings *settings, const RowPlace *place, int direction, bool fine)
{
    ASSERT(direction == 1 || direction == -1);
    const RowValue what = row_kinds[place->kind].columns[place->value - 1].value;
    const double value = settings_row_value(settings, place->kind, place->row, place->value - 1);
    Settings candidate = *settings;
    if (!isfinite(value))
        return false;
    settings_row_place_put(&candidate, place,
                           what != ROW_NUMBER && what != ROW_TIME
                               ? next_place(settings, value, direction * (fine ? 1 : wide_step(settings)))
                           : fine ? next_digit(value, direction, value)
                                  : next_on_ladder(value, direction, value, false));
    if (!settings_check(&candidate, NULL) ||
        settings_row_value(&candidate, place->kind, place->row, place->value - 1) == value)
        return false;
    *settings = candidate;
    return true;
}

bool settings_answer_otherwise(Settings *settings, const Parameter *parameter)
{
    char now[LIST_MAX];
    const Parameter row = parameter_in(parameter, settings->problem);
    if (parameter_is_size(parameter)) { /* one rung below the usual one and, from anywhere else, back to it */
        if (settings_number(settings, parameter) == row.usual)
            return settings_nudge(settings, parameter, -1, false, NULL);
        Settings candidate = *settings;
        settings_put(&candidate, parameter, row.usual);
        if (!settings_check(&candidate, NULL))
            return false;
        *settings = candidate;
        return true;
    }
    for (int i = 0; i < row.n_choices; i++) {
        const char *usual = row.choices[(int)row.usual];
        if (strcmp(parameter->choices[i], "none") != 0 || strcmp(usual, "none") == 0)
            continue;
        settings_get(settings, parameter, now);
        return settings_set(settings, parameter->key, strcmp(now, "none") == 0 ? usual : "none", NULL);
    }
    return settings_nudge(settings, parameter, 1, false, NULL);
}
