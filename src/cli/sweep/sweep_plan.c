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

static bool split_range(const char *text, char parts[3][VALUE_MAX])
{
    for (int i = 0; i < 3; i++) {
        size_t length = strcspn(text, ":");
        if (length >= VALUE_MAX || (text[length] == ':') != (i < 2))
            return false;
        memcpy(parts[i], text, length);
        parts[i][length] = '\0';
        text += length + 1;
    }
    return true;
}

/* LO:HI:N is N values, evenly spaced, both ends among them. Twelve digits keep the sums of tenths readable;
 * the ends are taken as they were written. */
static bool read_range(SweepKey *key, const char *text, Status *status)
{
    char parts[3][VALUE_MAX];
    double low, high;
    long count;
    if (!split_range(text, parts) || !text_to_double(parts[0], &low) || !text_to_double(parts[1], &high) ||
        !text_to_long(parts[2], &count) || count < 2 || count > SWEEP_COMBINATIONS_MAX)
        return status_refuse(status, "%s: %s: %.60s is no range (LO:HI:N, N from 2 to %d)", key->origin,
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

/* A text has no number, and every cell of the table is one. */
static bool has_a_number(const SweepKey *key, Status *status)
{
    const RowColumn *of_row = row_key_column(key->key);
    const bool edge = of_row && of_row->value == ROW_EDGE;
    if (key->parameter ? key->parameter->type == PARAMETER_TEXT : edge || text_key_find(key->key))
        return status_refuse(status, "%s: %s: is a text (numbers and choices can be varied)", key->origin,
                             key->key);
    return strncmp(key->key, "output.", 7) != 0 ||
           status_refuse(status, "%s: %s: does not change the run (a parameter that does)", key->origin,
                         key->key);
}

static bool is_new(const SweepPlan *plan, const SweepKey *key, const Options *options, Status *status)
{
    for (int i = 0; i < plan->n_keys; i++)
        if (strcmp(plan->keys[i].key, key->key) == 0)
            return status_refuse(status, "%s: %s: is varied twice (once)", key->origin, key->key);
    if (strcmp(key->key, "time.end") == 0 && options->steps > 0)
        return status_refuse(status, "%s: time.end: --steps says when the run ends (one of them)",
                             key->origin);
    return true;
}

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
    if (plan->n_keys == 0)
        return status_refuse(status, "--with: %s: needs a --vary before it", key->key);
    const SweepKey *first = &plan->keys[plan->n_keys - 1];
    key->axis = first->axis;
    if (key->count != first->count)
        return status_refuse(status, "--with: %s: has %d values beside %d of %s (as many)", key->key,
                             key->count, first->count, first->key);
    return true;
}

static bool read_key(SweepPlan *plan, const SweepAxis *axis, const Options *options, Status *status)
{
    SweepKey *key = &plan->keys[plan->n_keys];
    const char *equals = strchr(axis->text, '=');
    *key = (SweepKey){.origin = axis->origin};
    if (!equals || equals == axis->text || equals - axis->text >= KEY_MAX)
        return status_refuse(status, "%s: \"%.80s\" varies nothing (KEY=A,B,C or KEY=LO:HI:N)", axis->origin,
                             axis->text);
    memcpy(key->key, axis->text, (size_t)(equals - axis->text));
    key->parameter = parameter_find(key->key);
    bool range = strchr(equals + 1, ':') != NULL;
    bool read = is_new(plan, key, options, status) && has_a_number(key, status) &&
                (range ? read_range : read_list)(key, equals + 1, status) && join_axis(plan, key, status);
    plan->n_keys++; /* even if it is bad: what it holds is freed with the others */
    return read;
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
    size_t used = 0;
    for (int i = 0; i < plan->n_keys && used < size; i++)
        used += (size_t)snprintf(out + used, size - used, "%s%s=%s", i ? " " : "", plan->keys[i].key,
                                 value_of(plan, combination, i));
}

/* The columns of the result of a sweep: name, unit and meaning of each, and the numbers of a finished run.
 * A column is a bar's (frequency), a beam's (period) or of cracks. */

static const struct {
    const char *name, *unit, *meaning;
} texts[RESULT_COLUMNS] = {
    [RESULT_FREQUENCY_MEASURED] = {"frequency_measured", "1/time",
                                   "bar: radians per time, fitted to the series"},
    [RESULT_FREQUENCY_UNCERTAINTY] = {"frequency_uncertainty", "1/time",
                                      "its standard deviation if the residual is noise"},
    [RESULT_FREQUENCY_R2] = {"frequency_r2", "1",
                             "share of the series' variance that the fit explains; below 0.5 it is not one "
                             "frequency, and there is none measured"},
    [RESULT_FREQUENCY_PREDICTED] = {"frequency_predicted", "1/time",
                                    "the same by the equations of this very mesh or lattice"},
    [RESULT_FREQUENCY_EXACT] = {"frequency_exact", "1/time", "the same of the continuum"},
    [RESULT_FREQUENCY_ERROR] = {"frequency_error", "%", "measured against exact"},
    [RESULT_PERIOD_MEASURED] = {"period_measured", "s", "beam: fitted to the series"},
    [RESULT_PERIOD_UNCERTAINTY] = {"period_uncertainty", "s",
                                   "its standard deviation if the residual is noise"},
    [RESULT_PERIOD_R2] = {"period_r2", "1", "as frequency_r2"},
    [RESULT_PERIOD_PREDICTED] = {"period_predicted", "s",
                                 "the same by the equations of this very lattice (supported beam)"},
    [RESULT_PERIOD_THEORY] = {"period_theory", "s",
                              "the same by beam theory: Timoshenko's (supported beam), the modal equations "
                              "(moving cantilever)"},
    [RESULT_PERIOD_ERROR] = {"period_error", "%", "measured against theory"},
    [RESULT_PERIOD_EULER] = {"period_euler", "s", "period by Euler-Bernoulli's theory"},
    [RESULT_PERIOD_ERROR_EULER] = {"period_error_euler", "%", "measured against Euler-Bernoulli's"},
    [RESULT_REAL_HEIGHT] = {"real_height", "m", "height of the lattice: rows times spacing"},
    [RESULT_REAL_SPAN] = {"real_span", "m", "length of the lattice that vibrates"},
    [RESULT_FIRST_BREAK] = {"first_break", "s", "time at which the first bond breaks at the notch's end"},
    [RESULT_CRACK_ANGLE] = {"crack_angle", "degree",
                            "between the notch and the straight line through the whole path of the crack; of "
                            "a plate between a cut and the fastest crack from it"},
    [RESULT_CRACK_LENGTH] = {"crack_length", "m", "length of the crack at the end"},
    [RESULT_TIP_SPEED] = {"tip_speed", "m/s",
                          "of the crack's tip at its fastest, until it came to the protected zone; of a "
                          "plate the fastest of all tips"},
    [RESULT_TIPS] = {"tips", "1", "plate: tips of cracks at the end"},
    [RESULT_BRANCHED] = {"branched", "1", "plate: 1 where a crack has branched, else 0"},
    [RESULT_BRANCH_X] = {"branch_x", "m", "plate: where along it the first crack that branched did so"},
    [RESULT_BRANCH_TIME] = {"branch_time", "s", "when it did"},
    [RESULT_HALF_ANGLE] = {"half_angle", "degree", "half of the angle between its two branches"},
    [RESULT_CRACK_COST] = {"crack_cost", "J/m^2",
                           "energy of all broken bonds over the area of the cracks; to be set beside "
                           "pd.critical_energy"},
    [RESULT_BROKEN_BONDS] = {"broken_bonds", "1", "bonds broken at the end"},
    [RESULT_ENERGY_LEFT] =
        {"energy_left", "1",
         "energy at the end as a share of that at the start: E* where there is one, else the "
         "means of total less the work of loads over the first and the last period"},
    [RESULT_STEPS] = {"steps", "1", "time steps done"},
    [RESULT_WALL] = {"wall", "s", "seconds that the run took"},
    [RESULT_KEPT_MEASURED] = {"kept_measured", "1",
                              "share of its energy that the motion keeps in one exact period, fitted to the "
                              "series"},
    [RESULT_KEPT_PREDICTED] = {"kept_predicted", "1",
                               "the same as predicted: by this very mesh, or by the damping"},
    [RESULT_MISTAKE] = {"with_a_mistake", "1",
                        "1: by a code that is wrong in one place (mpm.mistake, pd.mistake)"},
};

const char *sweep_result_name(ResultColumn column)
{
    return texts[column].name;
}

Quantity sweep_result_quantity(ResultColumn column)
{
    return (Quantity){texts[column].name, texts[column].name, texts[column].unit, texts[column].meaning};
}

static double percent(double value, double reference)
{
    return 100 * (value / reference - 1);
}

/* The numbers of a run without motion are no answers, even where theory knows them. */
static void put_readout(const RunSummary *summary, double cells[RESULT_COLUMNS])
{
    const Readout *readout = &summary->readout;
    if (!readout->moving)
        return;
    /* six columns for either: measured, its uncertainty, R2, predicted, exact or theory, and the error */
    double *six = cells + (readout->is_period ? RESULT_PERIOD_MEASURED : RESULT_FREQUENCY_MEASURED);
    if (readout->measured_known)
        six[0] = readout->measured;
    six[1] = readout->uncertainty;
    six[2] = readout->r2;
    if (readout->predicted_known)
        six[3] = readout->predicted;
    if (readout->exact_known)
        six[4] = readout->exact;
    six[5] = percent(six[0], six[4]);
    cells[RESULT_KEPT_MEASURED] = readout->kept_measured;
    cells[RESULT_KEPT_PREDICTED] = readout->kept_predicted;
    cells[RESULT_PERIOD_EULER] = run_summary_derived(summary, "period_euler");
    cells[RESULT_PERIOD_ERROR_EULER] = percent(cells[RESULT_PERIOD_MEASURED], cells[RESULT_PERIOD_EULER]);
}

void sweep_result_of(const RunSummary *summary, const Settings *settings, double wall, SweepResult *result)
{
    double *cells = result->cells;
    for (int i = 0; i < RESULT_COLUMNS; i++)
        cells[i] = NAN;
    put_readout(summary, cells);
    cells[RESULT_REAL_HEIGHT] = run_summary_derived(summary, "real_height");
    cells[RESULT_REAL_SPAN] = run_summary_derived(summary, "real_span");
    if (settings->problem->concerns & CONCERN_BREAKING && settings_bonds(settings)->critical_stretch > 0)
        cells[RESULT_BROKEN_BONDS] = summary->broken_bonds;
    /* The notched beam has one crack, a plate any number. */
    const FrontsFacts *fronts = &summary->fronts;
    if (summary->crack_known) {
        cells[RESULT_FIRST_BREAK] = summary->crack.measured.first_break;
        cells[RESULT_CRACK_ANGLE] = summary->crack.angle;
        if (summary->crack.measured.fastest > 0)
            cells[RESULT_TIP_SPEED] = summary->crack.measured.fastest;
    }
    if (summary->fronts_known) {
        cells[RESULT_CRACK_ANGLE] = fronts->angle;
        cells[RESULT_TIP_SPEED] = fronts->fastest;
        cells[RESULT_TIPS] = fronts->n_tips;
        cells[RESULT_BRANCHED] = fronts->branched;
    }
    if (summary->fronts_known && fronts->branched) {
        cells[RESULT_BRANCH_X] = fronts->branch[0];
        cells[RESULT_BRANCH_TIME] = fronts->branch_time;
        cells[RESULT_HALF_ANGLE] = fronts->half_angle;
    }
    if (summary->price_known)
        cells[RESULT_CRACK_COST] = summary->price.cost.total / summary->price.cost.area;
    cells[RESULT_CRACK_LENGTH] = summary->crack_length;
    if (summary->energy_measure != ENERGY_NOT_KNOWN && !summary->energy_of_work)
        cells[RESULT_ENERGY_LEFT] = 1 + summary->energy_change / 100;
    cells[RESULT_STEPS] = (double)summary->steps;
    cells[RESULT_WALL] = wall;
    if (summary->mistake)
        cells[RESULT_MISTAKE] = 1;
    result->done = true;
    if (summary->readout.moving && !summary->readout.measured_known)
        snprintf(result->failure.text, sizeof result->failure.text, "%s", summary->readout.unmeasured);
}
