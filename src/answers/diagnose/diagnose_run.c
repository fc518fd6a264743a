/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run beside the table of a foreign code (diagnose_internal.h): ours for each of its entries, up to the
 * first that departs or to its end. */
#include "answers/diagnose/diagnose_internal.h"

#include "base/assertion.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "scenario/concern_output.h"

#include "base/math/functions.h"
#include "base/text.h"
#include "problems/problem.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* --- the accuracy of an entry --------------------------------------------------------------------------- */

double diagnose_theirs(const DiagnoseTable *table, const DiagnoseColumn *column, size_t row)
{
    ASSERT_INDEX(column->theirs, table->file.n_columns);
    ASSERT_INDEX(table->rows[row], table->file.count);
    return table->file.columns[column->theirs].values[table->rows[row]] * column->factor;
}

double diagnose_last_digit(const OverlayColumn *column, double number)
{
    const double place = -fmin(column->places, 300);
    if (number == 0)
        return math_pow(10, place);
    return math_pow(10, fmax(place, floor(math_log10(fabs(number))) - fmin(column->digits, 17) + 1));
}

double diagnose_rounding(const DiagnoseTable *table, const DiagnoseColumn *column, double theirs)
{
    ASSERT_INDEX(column->theirs, table->file.n_columns);
    ASSERT(column->factor != 0);
    const OverlayColumn *written = &table->file.columns[column->theirs];
    return 0.51 * diagnose_last_digit(written, theirs / column->factor) * fabs(column->factor);
}

double diagnose_noise(const DiagnoseTable *table, double size, long step)
{
    return table->noise * (1 + table->noise_growth * (double)step) * size;
}

Departure diagnose_departure(const DiagnoseTable *table, size_t moment, size_t row, int column, double theirs,
                             double ours)
{
    const DiagnoseMoment *at = &table->moments[moment];
    return (Departure){.is = true,
                       .moment = moment,
                       .row = row,
                       .step = at->step,
                       .stage = at->stage,
                       .thing = table->things[row],
                       .column = column,
                       .theirs = theirs,
                       .ours = ours};
}

/* --- on the way ----------------------------------------------------------------------------------------- */

typedef struct Walker {
    Walk *walk;
    size_t moment; /* the next one */
    int ours[DIAGNOSE_COLUMNS_MAX];
    double size[DIAGNOSE_COLUMNS_MAX]; /* of groups, so far */
    double *row, *field;               /* room for ours: a row of the series, a field of the set */
    int stage_of[DIAGNOSE_STAGES_MAX]; /* which number the right code gives the stage */
    bool done;
} Walker;

static void depart(Walker *walker, size_t row, int column, double theirs, double ours)
{
    Walk *walk = walker->walk;
    const DiagnoseTable *table = walk->table;
    const DiagnoseMoment *moment = &table->moments[walker->moment];
    walk->departing++;
    walk->departs[column] = true;
    walker->done = !walk->to_end;
    if (walk->departure.is)
        return;
    walk->departure = diagnose_departure(table, walker->moment, row, column, theirs, ours);
    if (walker->moment > 0 && moment->step == moment[-1].step + 1)
        walk->jump = fabs(theirs - ours) / walker->size[table->as.columns[column].group];
}

static void compare(Walker *walker, size_t row, int c, double ours)
{
    Walk *walk = walker->walk;
    const DiagnoseTable *table = walk->table;
    const DiagnoseColumn *column = &table->as.columns[c];
    const double theirs = diagnose_theirs(table, column, row);
    if (walk->values)
        walk->values[row * (size_t)table->as.n_columns + (size_t)c] = ours;
    if (column->silent || isnan(theirs) || isnan(ours) || (isinf(theirs) && isinf(ours)))
        return;
    if (isinf(theirs)) {
        walk->farthest = INFINITY;
        depart(walker, row, c, theirs, ours);
        return;
    }
    double *size = &walker->size[column->group];
    *size = fmax(*size, fabs(theirs));
    const double difference = fabs(theirs - ours);
    const double grown =
        walk->grown ? walk->grown[walker->moment * (size_t)table->as.n_columns + (size_t)column->group] : 0;
    if (*size > 0)
        walk->farthest = fmax(walk->farthest, difference / *size);
    const double rounding = diagnose_rounding(table, column, theirs);
    walk->most[c] = fmax(walk->most[c], fabs(theirs));
    walk->off[c] = fmax(walk->off[c], difference - rounding);
    if (difference > grown + rounding + diagnose_noise(table, *size, table->moments[walker->moment].step))
        depart(walker, row, c, theirs, ours);
    else if (!walk->departure.is) {
        walk->entries++;
        if (*size > 0)
            walk->worst = fmax(walk->worst, difference / *size);
        if (difference > rounding && *size > 0) {
            walk->beyond = fmax(walk->beyond, (difference - rounding * (0.5 / 0.51)) / *size);
            walk->off_digits++;
        }
    }
}

/* The values of things: one by one where few of many are needed. */
static void compare_things(Walker *walker, Simulation *sim)
{
    const DiagnoseTable *table = walker->walk->table;
    const DiagnoseMoment *moment = &table->moments[walker->moment];
    const size_t things = sim->counts[table->set];
    const bool all = moment->count * 8 >= things;
    for (int c = 0; c < table->as.n_columns; c++) {
        const int field = walker->ours[c];
        if (all)
            sim->method->field(sim, field, 0, things, walker->field);
        for (size_t k = 0; k < moment->count && !walker->done; k++) {
            const size_t row = moment->first + k, thing = table->things[row];
            compare(walker, row, c, all ? walker->field[thing] : simulation_value(sim, field, thing));
        }
    }
}

/* As a table has them that is written at whole steps. */
static void compare_later(Simulation *sim, void *context)
{
    Walker *walker = context;
    simulation_make_ready(sim, walker->walk->table->set);
    compare_things(walker, sim);
}

/* The state of the next moment. False: nothing more is compared. */
static bool take_state(void *owner, Run *run, Status *status)
{
    Walker *walker = owner;
    Walk *walk = walker->walk;
    const DiagnoseTable *table = walk->table;
    const int set = table->set;
    (void)status;
    if (set < 0) {
        simulation_row(run->sim, walker->row);
        for (int c = 0; c < table->as.n_columns && !walker->done; c++)
            compare(walker, table->moments[walker->moment].first, c, walker->row[walker->ours[c]]);
    } else if (table->of_stages || run->sim->sets[set].ready_after == 0)
        compare_things(walker, run->sim);
    else if (!simulation_visit(run->sim, NULL, compare_later, walker))
        walk->stopped = true;
    walk->agreed += !walk->departure.is;
    walk->compared++;
    walker->moment++;
    walker->done = walker->done || walker->moment >= walk->moments;
    return !walker->done && !walk->stopped;
}

static long next_moment(const void *owner, long step)
{
    const Walker *walker = owner;
    const Walk *walk = walker->walk;
    (void)step;
    return walker->moment < walk->moments ? walk->table->moments[walker->moment].step : LONG_MAX;
}

/* Stages of a step may come in another order by another scheme. */
static bool take_stage(void *owner, Run *run, long step, int stage, Status *status)
{
    Walker *walker = owner;
    const DiagnoseTable *table = walker->walk->table;
    const DiagnoseMoment *next = &table->moments[walker->moment],
                         *end = &table->moments[walker->walk->moments];
    const int number = table->stages_by_id ? walker->stage_of[stage - 1] : stage;
    while (next < end && next->step == step && next->stage < number)
        next++; /* it has no such stage, or has it later */
    walker->moment = (size_t)(next - table->moments);
    walker->done = next == end;
    return !walker->done && (next->step != step || next->stage != number || take_state(owner, run, status));
}

size_t diagnose_rows(const DiagnoseTable *table, size_t moments)
{
    return moments > 0 ? table->moments[moments - 1].first + table->moments[moments - 1].count : 0;
}

double *diagnose_room(const DiagnoseTable *table)
{
    const size_t entries = table->file.count * (size_t)table->as.n_columns;
    double *values = malloc((entries + 1) * sizeof *values);
    for (size_t i = 0; values && i < entries; i++)
        values[i] = NAN;
    return values;
}

/* --- a run ---------------------------------------------------------------------------------------------- */

/* Where the columns are in this simulation. False: it lacks one, so it is not the code. */
static bool find_columns(Walker *walker, const Simulation *sim)
{
    const DiagnoseTable *table = walker->walk->table;
    for (int c = 0; c < table->as.n_columns; c++) {
        const char *name = table->as.columns[c].name;
        walker->ours[c] =
            table->set < 0 ? simulation_find_series(sim, name) : simulation_find_field(sim, table->set, name);
        if (walker->ours[c] < 0)
            return false;
        walker->size[c] = table->as.columns[c].natural;
    }
    for (int i = 0; i < sim->n_stages && i < DIAGNOSE_STAGES_MAX; i++)
        for (int k = 0; k < table->n_stages; k++)
            if (strcmp(table->stage_ids[k], sim->stages[i].id) == 0)
                walker->stage_of[i] = k + 1;
    return table->set < 0 || table->set < sim->n_sets;
}

static void go(Walker *walker, Run *run, Status *status)
{
    Walk *walk = walker->walk;
    const DiagnoseTable *table = walk->table;
    const long last = table->moments[walk->moments - 1].step;
    const Sink states = {.next = next_moment, .state = take_state, .owner = walker};
    const Sink stages = {.stage = take_stage, .first = table->moments[0].step, .last = last, .owner = walker};
    const Sink *sink = table->of_stages ? &stages : &states;
    if (!run->settings->problem->end_matters || last < run->last)
        run->last = last;
    const bool to_end = run_start(run, sink, status) && run_to_end(run, sink, status) && !walker->done;
    walk->failed = run->failed;
    walk->stopped =
        walk->stopped || (to_end ? cancel_requested(&run->cancel, 1) : !run->failed && !walker->done);
}

bool diagnose_walk(Walk *walk, const DiagnoseTask *task, const Settings *settings, Status *status)
{
    const DiagnoseTable *table = walk->table;
    Settings asked = *settings;
    Output *output = settings_edit_output(&asked);
    Run run;
    Walker walker = {.walk = walk};
    Status why = {STATUS_DONE, ""};
    if (walk->moments == 0 || walk->moments > table->n_moments)
        walk->moments = table->n_moments;
    output->columns[0] = output->follow[0] = '\0';
    for (int c = 0; c < table->as.n_columns && table->set < 0; c++)
        if (*table->as.columns[c].point)
            text_list_add(output->follow, sizeof output->follow, table->as.columns[c].point);
        else if (strlen(output->columns) + strlen(table->as.columns[c].name) + 3 < sizeof output->columns)
            text_list_add(output->columns, sizeof output->columns, table->as.columns[c].name);
    bool sound = run_open(&run, &asked, problem_simulate(&asked, task->threads, &why), &why);
    run.cancel = task->cancel;
    if (sound && find_columns(&walker, run.sim)) {
        walker.row = malloc(((size_t)run.sim->n_series + 1) * sizeof *walker.row);
        walker.field =
            malloc(((table->set < 0 ? 0 : run.sim->counts[table->set]) + 1) * sizeof *walker.field);
        sound = (walker.row && walker.field) || status_fail(&why, "out of memory");
        if (sound)
            go(&walker, &run, &why);
    } else if (sound)
        walk->departure.is = true;
    if (walk->stopped && why.code == STATUS_DONE)
        status_fail(&why, "interrupted");
    walk->beyond = walk->off_digits < DIAGNOSE_ENTRIES_LEAST ? 0 : walk->beyond;
    run_close(&run);
    free(walker.row);
    free(walker.field);
    return (sound && !walk->stopped) || status_take(status, &why);
}

bool diagnose_hold_step(Settings *settings, double dt, Status *status)
{
    ASSERT_REAL(dt, >, 0);
    double now;
    if (settings->problem->concerns & CONCERN_STEP && settings->method == METHOD_PD) {
        settings_edit_time(settings)->step = dt;
        return settings_check(settings, status);
    }
    if (!settings_check(settings, status) || !problem_time_step(settings, &now, status))
        return false;
    if (fabs(now - dt) <= 1e-12 * dt)
        return true;
    settings_edit_time(settings)->courant *= dt / now;
    return settings_check(settings, status) && problem_time_step(settings, &now, status) &&
           fabs(now - dt) <= 1e-12 * dt;
}
