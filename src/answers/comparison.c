/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of a duel: one function for each quantity writes its label and its value for either run, in
 * the order of the list at the end. A row is shown if at least one of the runs has a value. */
#include "answers/comparison.h"

#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "base/text.h"
#include "scenario/parameters.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A run at its present step. */
typedef struct Standing {
    const Experiment *experiment;
    const Readout *readout;
    CrackFacts crack;
    bool breaks; /* `crack` is known */
    FrontsFacts fronts;
    bool follows;  /* `fronts` are known */
    bool in_doubt; /* one of the two codes has a mistake */
} Standing;

/* A row: its label for this run and, if there is one, its value. False: the run has no such number. */
typedef bool Fill(const Standing *, char *label, char *value);

/* A number into a value's text. */
static bool put(char *value, const char *format, double number)
{
    snprintf(value, COMPARISON_TEXT_MAX, format, number);
    return true;
}

/* --- frequency or period --------------------------------------------------------------------------- */

static bool fill_answer(const Standing *run, const char *word, const char *format, bool known, double answer,
                        char *label, char *value)
{
    const Readout *readout = run->readout;
    if (!readout->moving)
        return false;
    snprintf(label, COMPARISON_TEXT_MAX, readout->is_period ? "T %s, ms" : "ω %s", word);
    return known && put(value, format, readout->is_period ? answer / 1e-3 : answer);
}

/* The measured frequency (or period, ms) by least squares over the record; while there is none, why. */
static bool fill_measured(const Standing *run, char *label, char *value)
{
    const Readout *readout = run->readout;
    /* while rows come in the fit is a little behind them, see experiment_rest() */
    const bool about = experiment_is_flowing(run->experiment);
    const bool known = readout->moving && readout->measured_known;
    fill_answer(run, "measured", "", false, NAN, label, value);
    snprintf(value, COMPARISON_TEXT_MAX,
             known                                ? (about ? "~" : "")
             : readout->unaccounted               ? "not known"
             : experiment_at_end(run->experiment) ? "none"
                                                  : "measuring");
    if (known)
        text_append(value, COMPARISON_TEXT_MAX, "%s", readout_text(readout, about ? 3 : 4).text);
    return readout->moving;
}

static bool fill_predicted(const Standing *run, char *label, char *value)
{
    return fill_answer(run, "predicted", "%.4f", run->readout->predicted_known, run->readout->predicted,
                       label, value);
}

static bool fill_exact(const Standing *run, char *label, char *value)
{
    return fill_answer(run, experiment_settings(run->experiment)->problem->answer, "%.4f",
                       run->readout->exact_known, run->readout->exact, label, value);
}

/* Relative error against the exact answer: 100 (measured/exact - 1) %, of a period the reciprocal's. */
static bool fill_error(const Standing *run, char *label, char *value)
{
    const Readout *readout = run->readout;
    snprintf(label, COMPARISON_TEXT_MAX, readout->is_period ? "T off by" : "ω off by");
    const bool about = experiment_is_flowing(run->experiment);
    snprintf(value, COMPARISON_TEXT_MAX, "%s%+.*f %%", about ? "~" : "",
             readout_error_decimals(readout, about ? 1 : 2),
             readout->is_period ? readout->error_period : readout->error_frequency);
    return readout->moving && readout->measured_known && readout->exact_known;
}

/* What the series begins with, to the digits in which a code with a mistake first leaves the right one. */
static bool fill_digits(const Standing *run, char *label, char *value)
{
    enum { FIRST = 2 }; /* behind step and time */
    const double *row = experiment_row(run->experiment);
    int n;
    const Column *columns = experiment_columns(run->experiment, &n);
    if (!run->in_doubt || n <= FIRST || !row)
        return false;
    snprintf(label, COMPARISON_TEXT_MAX, "%s", columns[FIRST].quantity.name);
    return put(value, "%.9g", row[FIRST]);
}

/* --- energy ---------------------------------------------------------------------------------------- */

/* 100 (E* now over E* at the start, - 1) %: the loss without the ripple of staggered velocities and stresses,
 * where E* is kept (references.h). */
static bool fill_loss(const Standing *run, char *label, char *value)
{
    double now, start;
    snprintf(label, COMPARISON_TEXT_MAX, "energy E* change");
    return experiment_invariant(run->experiment, &now, &start) && start > 0 &&
           put(value, "%+.3f %%", 100 * (now / start - 1));
}

/* kinetic + strain over their sum at the start, where there is no E* to tell more; of weight the sum, for the
 * zero of its potential is anywhere. */
static bool fill_total(const Standing *run, char *label, char *value)
{
    const int total = experiment_column(run->experiment, "total");
    const double *row = experiment_row(run->experiment);
    const Record *record = experiment_record(run->experiment);
    const bool weight = settings_loads(experiment_settings(run->experiment))->gravity != 0;
    double now, start;
    snprintf(label, COMPARISON_TEXT_MAX, weight ? "energy" : "energy, of start");
    if (experiment_invariant(run->experiment, &now, &start))
        return false; /* E* has it */
    if (weight && total >= 0 && row)
        return put(value, "%.4g", row[total]);
    if (total < 0 || !row || record->count == 0 || !(record_row(record, 0)[total] > 0))
        return false;
    return put(value, "%.2f %%", 100 * row[total] / record_row(record, 0)[total]);
}

/* A part of the kinetic energy that the grid's own does not hold, as a mean over a tenth of the run, or over
 * what there is of it: the motion that no nodal velocities represent, or what the nodes would have more of,
 * were their mass not lumped. */
static bool fill_part(const Standing *run, bool lumping, char *label, char *value)
{
    const int kinetic = experiment_column(run->experiment, "kinetic"),
              grid = experiment_column(run->experiment, "kinetic_grid");
    const int null = experiment_column(run->experiment, "kinetic_null");
    const Record *record = experiment_record(run->experiment);
    const double to = experiment_time(run->experiment),
                 span = settings_time(experiment_settings(run->experiment))->end / 10;
    const char *word = lumping ? "lumping" : "null";
    double all = 0, hidden = 0;
    if (to > span)
        snprintf(label, COMPARISON_TEXT_MAX, "%s, last t %.8s", word, text_rounded(span, 3).text);
    else
        snprintf(label, COMPARISON_TEXT_MAX, "%s, since t 0", word);
    if (kinetic < 0 || grid < 0 || null < 0 || record->count == 0)
        return false;
    for (size_t i = record_find(record, to - span); i < record->count && record_row(record, i)[1] <= to;
         i++) {
        const double *row = record_row(record, i);
        all += row[kinetic];
        hidden += lumping ? row[kinetic] - row[grid] - record_known(record, i, null)
                          : record_known(record, i, null);
    }
    return all > 0 && put(value, "%.2f %%", 100 * hidden / all);
}

static bool fill_null(const Standing *run, char *label, char *value)
{
    return fill_part(run, false, label, value);
}

static bool fill_lumping(const Standing *run, char *label, char *value)
{
    return fill_part(run, true, label, value);
}

/* --- what happened --------------------------------------------------------------------------------- */

static bool fill_crossing(const Standing *run, char *label, char *value)
{
    int count;
    const Simulation *sim = experiment_simulation(run->experiment);
    const Event *events = experiment_events(run->experiment, &count);
    snprintf(label, COMPARISON_TEXT_MAX, "first crossing");
    if (experiment_column(run->experiment, "kinetic_grid") < 0)
        return false; /* there is no grid */
    snprintf(value, COMPARISON_TEXT_MAX, "none yet");
    for (int i = 0; i < count; i++)
        if (events[i].kind == EVENT_CROSSING && events[i].step <= sim->step) {
            /* of a bar in its own unit, of a beam in seconds, which are few */
            const double time = (double)events[i].step * sim->dt;
            if (time >= 0.01)
                return put(value, "t %.2f", time);
            snprintf(value, COMPARISON_TEXT_MAX, "t %.12s", text_rounded(time, 3).text);
            break;
        }
    return true;
}

static bool fill_first_break(const Standing *run, char *label, char *value)
{
    snprintf(label, COMPARISON_TEXT_MAX, "first break, µs");
    if (run->breaks && isnan(run->crack.measured.first_break)) {
        snprintf(value, COMPARISON_TEXT_MAX, "none yet");
        return true;
    }
    return run->breaks && put(value, "%.1f", run->crack.measured.first_break / 1e-6);
}

static bool fill_work(const Standing *run, char *label, char *value)
{
    const int work = experiment_column(run->experiment, "work");
    const double *row = experiment_row(run->experiment);
    snprintf(label, COMPARISON_TEXT_MAX, "work of the load");
    return work >= 0 && !simulation_has(experiment_simulation(run->experiment), HAS_RELATIVE_ENERGY) && row &&
           fabs(row[work]) > 0 && put(value, "%.4g", row[work]);
}

/* Where one of the two stands apart: it failed. */
static bool fill_stop(const Standing *run, char *label, char *value)
{
    const Simulation *sim = experiment_simulation(run->experiment);
    const Problem *facts = experiment_settings(run->experiment)->problem;
    snprintf(label, COMPARISON_TEXT_MAX, "stopped at t%s%s", facts->si ? "," : "", facts->shown_time_unit);
    return experiment_failed(run->experiment, NULL) &&
           put(value, "%.4g", (double)experiment_newest(run->experiment) * sim->dt / facts->shown_time);
}

/* --- those of one expression ------------------------------------------------------------------------- */

#define FILL(name, words, format, known, number)                                                             \
    static bool fill_##name(const Standing *run, char *label, char *value)                                   \
    {                                                                                                        \
        snprintf(label, COMPARISON_TEXT_MAX, words);                                                         \
        return (known) && put(value, format, number);                                                        \
    }

/* By how many periods of the exact answer the run is behind at its present time. */
FILL(late, "periods behind", "%.2f",
     run->readout->moving && run->readout->measured_known && isfinite(run->readout->late), run->readout->late)
FILL(broken, "broken bonds", "%.0f", run->breaks || run->follows,
     (double)(run->breaks ? run->crack.measured.broken : run->fronts.broken))
FILL(tips, "tips of cracks", "%.0f", run->follows, run->fronts.n_tips)
FILL(fastest, "fastest, m/s", "%.0f", isfinite(run->fronts.fastest) && run->follows, run->fronts.fastest)
FILL(branch, "branched at t, µs", "%.1f", run->follows && run->fronts.branched,
     run->fronts.branch_time / 1e-6)
FILL(length, "crack's length, mm", "%.1f", run->breaks, run->crack.measured.length / 1e-3)
FILL(tip_x, "its tip at x, mm", "%.1f", run->breaks && run->crack.measured.begun,
     run->crack.measured.x / 1e-3)
FILL(tip_y, "and y, mm", "%.1f", run->breaks && run->crack.measured.begun, run->crack.measured.y / 1e-3)
FILL(step, "time step", "%.4g", true, experiment_simulation(run->experiment)->dt)

static const struct {
    Fill *fill;
    ColumnKind kind;
    bool if_different; /* else it is not worth a row */
} quantities[] = {
    {fill_stop, COLUMN_MEASURED, false},        {fill_digits, COLUMN_MEASURED, false},
    {fill_measured, COLUMN_MEASURED, false},    {fill_predicted, COLUMN_PREDICTED, false},
    {fill_exact, COLUMN_EXACT, false},          {fill_broken, COLUMN_MEASURED, false},
    {fill_first_break, COLUMN_MEASURED, false}, {fill_tips, COLUMN_MEASURED, false},
    {fill_fastest, COLUMN_MEASURED, false},     {fill_branch, COLUMN_MEASURED, false},
    {fill_length, COLUMN_MEASURED, false},      {fill_tip_x, COLUMN_MEASURED, false},
    {fill_tip_y, COLUMN_MEASURED, false},       {fill_loss, COLUMN_MEASURED, false},
    {fill_null, COLUMN_MEASURED, false},        {fill_crossing, COLUMN_MEASURED, false},
    {fill_error, COLUMN_EXACT, false},          {fill_late, COLUMN_EXACT, false},
    {fill_lumping, COLUMN_MEASURED, false},     {fill_total, COLUMN_MEASURED, false},
    {fill_work, COLUMN_MEASURED, false},        {fill_step, COLUMN_MEASURED, true},
};
enum { QUANTITIES = sizeof quantities / sizeof *quantities };

/* --- the table ------------------------------------------------------------------------------------- */

/* What several rows need of a run, asked once. */
static Standing standing_of(const Experiment *experiment)
{
    Standing run = {.experiment = experiment, .readout = experiment_readout(experiment)};
    run.breaks = crack_facts(experiment_simulation(experiment), &run.crack);
    const CrackFronts *fronts = experiment_fronts(experiment);
    run.follows = fronts != NULL;
    if (fronts)
        crack_fronts_facts(fronts, &run.fronts);
    return run;
}

/* The keys in which the two differ, as they are in a scenario file. */
static int add_keys(const Duel *duel, Comparison *rows)
{
    const Settings *settings[2] = {experiment_settings(duel->a), experiment_settings(duel->b)};
    int count = 0;
    for (int i = 0; i < duel->n_keys; i++) {
        const Parameter *parameter = parameter_find(duel->keys[i].key);
        const char *key = duel->keys[i].key;
        char value[LIST_MAX];
        if (!parameter && !settings_row_is_key(settings[0], key))
            continue;
        Comparison *row = &rows[count++];
        *row = (Comparison){.kind = COLUMN_MEASURED};
        snprintf(row->label, sizeof row->label, "%s", parameter ? parameter->label : key);
        for (int run = 0; run < 2; run++) {
            if (parameter && !parameter_applies_to(settings[run], parameter))
                strcpy(value, "-"); /* its method has no such thing */
            else if (parameter)
                settings_show(settings[run], parameter, value);
            else
                settings_row_key_show(settings[run], key, value);
            snprintf(row->values[run], sizeof row->values[run], "%.*s", COMPARISON_TEXT_MAX - 1, value);
        }
    }
    return count;
}

int comparison_of_duel(const Duel *duel, Comparison rows[COMPARISONS_MAX])
{
    if (!duel->b)
        return 0;
    Standing runs[2] = {standing_of(duel->a), standing_of(duel->b)};
    runs[0].in_doubt = runs[1].in_doubt =
        settings_mistake(experiment_settings(duel->a)) || settings_mistake(experiment_settings(duel->b));
    int count = add_keys(duel, rows);
    for (int i = 0; i < QUANTITIES; i++) {
        Comparison row = {.kind = quantities[i].kind};
        bool any = false;
        for (int run = 0; run < 2; run++)
            if (quantities[i].fill(&runs[run], row.label, row.values[run]))
                any = true;
            else
                strcpy(row.values[run], "-");
        if (any && !(quantities[i].if_different && strcmp(row.values[0], row.values[1]) == 0))
            rows[count++] = row;
    }
    return count;
}
