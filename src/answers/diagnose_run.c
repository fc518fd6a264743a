/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run beside the table of a foreign code (diagnose_internal.h): ours for each of its entries, up to the
 * first that departs or to its end. */
#include "answers/diagnose_internal.h"

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

/* --- the accuracy of an entry -----------------------------------------------------------------------------
 */

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

/* Half a unit of the last digit of an entry, in our units. */
static double rounding_of(const DiagnoseTable *table, const DiagnoseColumn *column, double theirs)
{
    ASSERT_INDEX(column->theirs, table->file.n_columns);
    ASSERT(column->factor != 0);
    const OverlayColumn *written = &table->file.columns[column->theirs];
    return 0.51 * diagnose_last_digit(written, theirs / column->factor) * fabs(column->factor);
}

/* The round-off of two right codes is a share of a column's size. */
static double bound_of(const DiagnoseTable *table, double rounding, double size, long step)
{
    return rounding + table->noise * (1 + table->noise_growth * (double)step) * size;
}

double diagnose_bound(const DiagnoseTable *table, const DiagnoseColumn *column, double theirs, double size,
                      long step)
{
    return bound_of(table, rounding_of(table, column, theirs), size, step);
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
    if (!walk->departure.is)
        walk->departure = (Departure){.is = true,
                                      .moment = walker->moment,
                                      .row = row,
                                      .step = moment->step,
                                      .stage = moment->stage,
                                      .thing = table->things[row],
                                      .column = column,
                                      .theirs = theirs,
                                      .ours = ours,
                                      .theirs_before = NAN,
                                      .ours_before = NAN};
    if (walk->departing == 1 && walker->moment > 0 && moment->step == moment[-1].step + 1)
        walk->jump = fabs(theirs - ours) / walker->size[table->columns[column].group];
    walker->done = !walk->to_end;
}

static void compare(Walker *walker, size_t row, int c, double ours)
{
    Walk *walk = walker->walk;
    const DiagnoseTable *table = walk->table;
    const DiagnoseColumn *column = &table->columns[c];
    const double theirs = diagnose_theirs(table, column, row);
    if (walk->values)
        walk->values[row * (size_t)table->n_columns + (size_t)c] = ours;
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
        walk->grown ? walk->grown[walker->moment * (size_t)table->n_columns + (size_t)column->group] : 0;
    if (*size > 0)
        walk->farthest = fmax(walk->farthest, difference / *size);
    const double rounding = rounding_of(table, column, theirs);
    walk->most[c] = fmax(walk->most[c], fabs(theirs));
    walk->off[c] = fmax(walk->off[c], difference - rounding);
    if (difference > grown + bound_of(table, rounding, *size, table->moments[walker->moment].step))
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
    for (int c = 0; c < table->n_columns; c++) {
        const int field = walker->ours[c];
        if (all)
            sim->method->field(sim, field, 0, things, walker->field);
        for (size_t k = 0; k < moment->count && !walker->done; k++) {
            const size_t row = moment->first + k, thing = table->things[row];
            compare(walker, row, c, all ? walker->field[thing] : simulation_value(sim, field, thing));
        }
    }
}

static void compare_series(Walker *walker, Simulation *sim)
{
    const DiagnoseTable *table = walker->walk->table;
    simulation_row(sim, walker->row);
    for (int c = 0; c < table->n_columns && !walker->done; c++)
        compare(walker, table->moments[walker->moment].first, c, walker->row[walker->ours[c]]);
}

/* As a table has them that is written at whole steps. */
static void compare_later(Simulation *sim, void *context)
{
    Walker *walker = context;
    simulation_make_ready(sim, walker->walk->table->set);
    compare_things(walker, sim);
}

static bool compare_moment(Walker *walker, Simulation *sim)
{
    Walk *walk = walker->walk;
    const int set = walk->table->set;
    if (set < 0)
        compare_series(walker, sim);
    else if (walk->table->of_stages || sim->sets[set].ready_after == 0)
        compare_things(walker, sim);
    else if (!simulation_visit(sim, NULL, compare_later, walker))
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

static bool take_state(void *owner, Run *run, Status *status)
{
    (void)status;
    return compare_moment(owner, run->sim);
}

/* Stages of a step may come in another order by another scheme. */
static bool take_stage(void *owner, Run *run, long step, int stage, Status *status)
{
    Walker *walker = owner;
    const DiagnoseTable *table = walker->walk->table;
    const int number = table->stages_by_id ? walker->stage_of[stage - 1] : stage;
    (void)status;
    while (walker->moment < walker->walk->moments && table->moments[walker->moment].step == step &&
           table->moments[walker->moment].stage < number && number > 0)
        walker->moment++; /* it has no such stage, or has it later */
    if (walker->moment >= walker->walk->moments) {
        walker->done = true;
        return false;
    }
    return table->moments[walker->moment].step != step || table->moments[walker->moment].stage != number ||
           compare_moment(walker, run->sim);
}

/* --- a run ---------------------------------------------------------------------------------------------- */

/* Where the columns are in this simulation. False: it lacks one, so it is not the code. */
static bool find_columns(Walker *walker, const Simulation *sim)
{
    const DiagnoseTable *table = walker->walk->table;
    for (int c = 0; c < table->n_columns; c++) {
        const char *name = table->columns[c].name;
        walker->ours[c] =
            table->set < 0 ? simulation_find_series(sim, name) : simulation_find_field(sim, table->set, name);
        if (walker->ours[c] < 0)
            return false;
        walker->size[c] = table->columns[c].natural;
    }
    for (int i = 0; i < sim->n_stages && i < DIAGNOSE_STAGES_MAX; i++)
        for (int k = 0; k < table->n_stages; k++)
            if (strcmp(table->stage_ids[k], sim->stages[i].id) == 0)
                walker->stage_of[i] = k + 1;
    return table->set < 0 || table->set < sim->n_sets;
}

static bool go(Walker *walker, Run *run, Status *status)
{
    Walk *walk = walker->walk;
    const DiagnoseTable *table = walk->table;
    const long last = table->moments[walk->moments - 1].step;
    const Sink states = {.next = next_moment, .state = take_state, .owner = walker};
    const Sink stages = {.stage = take_stage, .first = table->moments[0].step, .last = last, .owner = walker};
    const Sink *sink = table->of_stages ? &stages : &states;
    if (!run->settings->problem->end_matters || last < run->last)
        run->last = last;
    if (run_start(run, sink, status) && run_to_end(run, sink, status) && !walker->done)
        walk->stopped = walk->stopped || cancel_requested(&run->cancel, 1);
    else
        walk->stopped = walk->stopped || !(run->failed || walker->done);
    walk->failed = run->failed;
    return !walk->stopped;
}

static bool make_room(Walker *walker, const Simulation *sim, Status *status)
{
    const int set = walker->walk->table->set;
    walker->row = malloc(((size_t)sim->n_series + 1) * sizeof *walker->row);
    walker->field = malloc(((set < 0 ? 0 : sim->counts[set]) + 1) * sizeof *walker->field);
    return (walker->row && walker->field) || status_fail(status, "out of memory");
}

bool diagnose_walk(Walk *walk, const Settings *settings, int threads, Cancel cancel, Status *status)
{
    Settings asked = *settings;
    Run run;
    Walker walker = {.walk = walk};
    const Walk given = *walk;
    *walk = (Walk){.table = given.table,
                   .moments = given.moments < given.table->n_moments ? given.moments : given.table->n_moments,
                   .to_end = given.to_end,
                   .values = given.values,
                   .grown = given.grown};
    settings_edit_output(&asked)->columns[0] = settings_edit_output(&asked)->follow[0] = '\0';
    for (int c = 0; c < walk->table->n_columns && walk->table->set < 0; c++)
        if (*walk->table->columns[c].point)
            text_list_add(settings_edit_output(&asked)->follow, sizeof settings_output(&asked)->follow,
                          walk->table->columns[c].point);
        else if (strlen(settings_output(&asked)->columns) + strlen(walk->table->columns[c].name) + 3 <
                 sizeof settings_output(&asked)->columns)
            text_list_add(settings_edit_output(&asked)->columns, sizeof settings_output(&asked)->columns,
                          walk->table->columns[c].name);
    bool sound = run_open(&run, &asked, problem_simulate(&asked, threads, status), status);
    run.cancel = cancel;
    if (sound && find_columns(&walker, run.sim))
        sound = make_room(&walker, run.sim, status) && go(&walker, &run, status);
    else if (sound)
        walk->departure.is = true;
    if (walk->stopped && status && status->code == STATUS_DONE)
        status_fail(status, "interrupted");
    run_close(&run);
    free(walker.row);
    free(walker.field);
    return sound;
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
