/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads --vary and --with into axes (sweep_plan.h), numbers their combinations like nested loops, and
 * makes the settings and the command line of each; and the row of results that each one's run gives. */
#include "cli/sweep/sweep_plan.h"

#include "scenario/rows/rows.h"
#include "base/text.h"
#include "scenario/concern_bonds.h"
#include "scenario/settings.h"

#include <stdlib.h>
#include <string.h>
#include <math.h>
#include <stdio.h>

/* --- values --------------------------------------------------------------------------------------- */

static bool keep_value(SweepKey *key, const char *text, size_t length, Status *status)
{
    if (length == 0)
        return status_refuse(status, "%s: %s: an empty value (A,B,C or LO:HI:N)", key->origin, key->key);
    if (length >= VALUE_MAX)
        return status_refuse(status, "%s: %s: %.40s... is too long for a value", key->origin, key->key, text);
    if (key->count == SWEEP_COMBINATIONS_MAX)
        return status_refuse(status, "%s: %s: too many values (at most %d)", key->origin, key->key,
                             SWEEP_COMBINATIONS_MAX);
    if ((key->count & (key->count - 1)) == 0) {
        size_t room = key->count ? 2 * (size_t)key->count : 1;
        char(*larger)[VALUE_MAX] = realloc(key->values, room * sizeof *larger);
        if (!larger)
            return status_fail(status, "not enough memory for the values of %s", key->key);
        key->values = larger;
    }
    char *value = key->values[key->count++];
    memcpy(value, text, length);
    value[length] = '\0';
    return true;
}

static bool read_list(SweepKey *key, const char *text, Status *status)
{
    for (;;) {
        size_t length = strcspn(text, ",");
        if (!keep_value(key, text, length, status))
            return false;
        if (!text[length])
            return true;
        text += length + 1;
    }
}

/* LO:HI:N is N values, evenly spaced, both ends among them. Twelve digits keep the sums of tenths readable;
 * the ends are taken as they were written. */
static bool read_range(SweepKey *key, const char *text, Status *status)
{
    char parts[3][VALUE_MAX];
    double low, high;
    long count;
    const char *part = text;
    bool split = true;
    for (int i = 0; i < 3 && split; i++) {
        const size_t length = strcspn(part, ":");
        split = length < VALUE_MAX && (part[length] == ':') == (i < 2);
        snprintf(parts[i], VALUE_MAX, "%.*s", (int)length, part);
        part += length + 1;
    }
    if (!split || !text_to_double(parts[0], &low) || !text_to_double(parts[1], &high) ||
        !text_to_long(parts[2], &count) || count < 2 || count > SWEEP_COMBINATIONS_MAX)
        return status_refuse(status, "%s: %s: %.60s is not a range (LO:HI:N, N from 2 to %d)", key->origin,
                             key->key, text, SWEEP_COMBINATIONS_MAX);
    for (long i = 0; i < count; i++) {
        const NumberText value = text_rounded(low + (high - low) * (double)i / (double)(count - 1), 12);
        const char *kept = i == 0 ? parts[0] : i == count - 1 ? parts[1] : value.text;
        if (!keep_value(key, kept, strlen(kept), status))
            return false;
    }
    return true;
}

/* --- axes ----------------------------------------------------------------------------------------- */

static bool join_axis(SweepPlan *plan, SweepKey *key, Status *status)
{
    if (strcmp(key->origin, "--with") != 0) {
        key->axis = plan->n_axes++;
        long all = (long)plan->n_combinations * key->count;
        if (all > SWEEP_COMBINATIONS_MAX)
            return status_refuse(status, "--vary: %ld combinations are too many (at most %d)", all,
                                 SWEEP_COMBINATIONS_MAX);
        plan->n_combinations = (int)all;
        return true;
    }
    if (key == plan->keys)
        return status_refuse(status, "--with: %s: needs a --vary before it", key->key);
    const SweepKey *first = key - 1;
    key->axis = first->axis;
    if (key->count != first->count)
        return status_refuse(status, "--with: %s: has %d values beside %d of %s (as many)", key->key,
                             key->count, first->count, first->key);
    return true;
}

static bool read_key(SweepPlan *plan, const SweepAxis *axis, const Options *options, Status *status)
{
    /* counted even if it is bad: what it holds is freed with the others */
    SweepKey *key = &plan->keys[plan->n_keys++];
    const char *equals = strchr(axis->text, '=');
    *key = (SweepKey){.origin = axis->origin};
    if (!equals || equals == axis->text || equals - axis->text >= KEY_MAX)
        return status_refuse(status, "%s: \"%.80s\" varies nothing (KEY=A,B,C or KEY=LO:HI:N)", axis->origin,
                             axis->text);
    memcpy(key->key, axis->text, (size_t)(equals - axis->text));
    key->parameter = parameter_find(key->key);
    for (const SweepKey *other = plan->keys; other < key; other++)
        if (strcmp(other->key, key->key) == 0)
            return status_refuse(status, "%s: %s: is varied twice (once)", key->origin, key->key);
    if (strcmp(key->key, "time.end") == 0 && options->steps > 0)
        return status_refuse(status, "%s: time.end: --steps says when the run ends (one of them)",
                             key->origin);
    /* A text has no number, and every cell of the table is one. */
    const RowColumn *of_row = row_key_column(key->key);
    const bool edge = of_row && of_row->value == ROW_EDGE;
    if (key->parameter ? key->parameter->type == PARAMETER_TEXT : edge || parameter_text_find(key->key))
        return status_refuse(status, "%s: %s: is a text (numbers and choices can be varied)", key->origin,
                             key->key);
    if (strncmp(key->key, "output.", 7) == 0)
        return status_refuse(status, "%s: %s: does not change the run (a parameter that does)", key->origin,
                             key->key);
    const bool range = strchr(equals + 1, ':') != NULL;
    return (range ? read_range : read_list)(key, equals + 1, status) && join_axis(plan, key, status);
}

bool sweep_plan_read(SweepPlan *plan, const Options *options, Status *status)
{
    *plan = (SweepPlan){.n_combinations = 1};
    if (options->n_axes == 0)
        return status_refuse(status, "--vary is missing (--vary KEY=A,B,C or KEY=LO:HI:N)");
    for (int i = 0; i < options->n_axes; i++)
        if (!read_key(plan, &options->axes[i], options, status)) {
            sweep_plan_free(plan);
            return false;
        }
    return true;
}

void sweep_plan_free(SweepPlan *plan)
{
    for (int i = 0; i < plan->n_keys; i++)
        free(plan->keys[i].values);
    *plan = (SweepPlan){0};
}

/* --- combinations --------------------------------------------------------------------------------- */

static const char *value_of(const SweepPlan *plan, int combination, int key)
{
    int axis = plan->keys[key].axis, faster = 1;
    for (int i = 0, seen = axis; i < plan->n_keys; i++)
        if (plan->keys[i].axis > seen) {
            seen = plan->keys[i].axis;
            faster *= plan->keys[i].count;
        }
    return plan->keys[key].values[combination / faster % plan->keys[key].count];
}

bool sweep_plan_load(const SweepPlan *plan, const Options *options, int combination, bool with_steps,
                     Settings *settings, Status *status)
{
    Options all = *options;
    if (!with_steps)
        all.steps = 0;
    for (int i = 0; i < plan->n_keys; i++) {
        const SweepKey *key = &plan->keys[i];
        if (all.n_overrides == OVERRIDES_MAX)
            return status_refuse(status, "--set: too many values (at most %d with those varied)",
                                 OVERRIDES_MAX);
        const char *value = value_of(plan, combination, i);
        all.overrides[all.n_overrides++] = (Override){key->origin, key->key, value};
    }
    return options_load(&all, options->words[0], settings, status);
}

void sweep_plan_describe(const SweepPlan *plan, int combination, char *out, size_t size)
{
    out[0] = '\0';
    for (int i = 0; i < plan->n_keys; i++)
        text_append(out, size, "%s%s=%s", i ? " " : "", plan->keys[i].key, value_of(plan, combination, i));
}

/* --- the row of a run ------------------------------------------------------------------------------- */

#define COLUMN(name, unit, number, meaning) {#name, #name, unit, meaning},
const Quantity sweep_columns[RESULT_COLUMNS] = {
#include "cli/sweep/sweep_columns.inc"
};
#undef COLUMN

static double percent(double value, double reference)
{
    return 100 * (value / reference - 1);
}

/* The numbers of a run without motion are not answers, even where theory knows them. */
void sweep_result_of(const RunSummary *run, const Settings *settings, double wall, SweepResult *result)
{
    const Readout *readout = &run->readout;
    const FrontsFacts *fronts = &run->fronts;
    const bool period = readout->moving && readout->is_period, frequency = readout->moving && !period;
    const bool branched = run->fronts_known && fronts->branched;
    const bool breaks =
        settings->problem->concerns & CONCERN_BREAKING && settings_bonds(settings)->critical_stretch > 0;
    const double euler = run_summary_derived(run, "period_euler");
#define OF(known, number) ((known) ? (double)(number) : (double)NAN)
    const double off_exact =
        OF(readout->measured_known && readout->exact_known, percent(readout->measured, readout->exact));
#define COLUMN(name, unit, number, meaning) number,
    const double cells[RESULT_COLUMNS] = {
#include "cli/sweep/sweep_columns.inc"
    };
    memcpy(result->cells, cells, sizeof cells);
    result->done = true;
    if (readout->moving && !readout->measured_known)
        snprintf(result->failure.text, sizeof result->failure.text, "%s", readout->unmeasured);
}
