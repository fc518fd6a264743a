/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The search for the code that made a file's numbers (diagnose.h). */
#include "answers/diagnose_internal.h"
#include "scenario/settings.h"
#include "scenario/concern_body.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"

#include "answers/references.h"
#include "base/math/functions.h"
#include "base/text.h"
#include "problems/problem.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef struct Search {
    const DiagnoseTask *task;
    DiagnoseTable *table;
    Diagnosis *found;
    Settings right;    /* with the file's time step */
    bool units, taken; /* units of the file's own are sought; some was found */
    double *values;    /* of the right run */
    double *grown;     /* what its round-off grows to, where it departs; else NULL */
    Walk walk;         /* along it */
    Candidate first;   /* the first that explains it all */
    Settings by_first; /* its settings; without one the right ones */
    Status *status;
} Search;

/* --- columns that tell nothing -------------------------------------------------------------------------- */

/* What of a column there is: in the file and in the right run. */
typedef struct Extent {
    size_t given;
    double theirs, ours; /* largest */
} Extent;

static Extent extent_of(const Search *search, int c)
{
    const DiagnoseTable *table = search->table;
    Extent extent = {0, 0, 0};
    for (size_t m = 0; m < search->walk.compared; m++)
        for (size_t k = 0; k < table->moments[m].count; k++) {
            const size_t row = table->moments[m].first + k;
            const double theirs = diagnose_theirs(table, &table->columns[c], row);
            const double ours = search->values[row * (size_t)table->n_columns + (size_t)c];
            extent.given += isnan(theirs) ? 0 : 1;
            extent.theirs = fmax(extent.theirs, fabs(theirs)); /* NAN counts for nothing */
            extent.ours = fmax(extent.ours, fabs(ours));
        }
    return extent;
}

/* Another power of a thousand for a unit, as the first numbers tell that are not small: 1 without one. */
static double unit_of(const Search *search, int c)
{
    const DiagnoseTable *table = search->table;
    const DiagnoseColumn *column = &table->columns[c];
    const double least = 1e-3 * extent_of(search, c).ours;
    for (size_t m = 0; m < search->walk.compared; m++)
        for (size_t k = 0; k < table->moments[m].count; k++) {
            const size_t row = table->moments[m].first + k;
            const double theirs = diagnose_theirs(table, column, row);
            const double ours = search->values[row * (size_t)table->n_columns + (size_t)c];
            if (!(fabs(ours) > least) || !(theirs / ours > 0) || !isfinite(theirs / ours))
                continue;
            const double whole = round(math_log10(theirs / ours) / 3);
            const double bound = diagnose_bound(table, column, theirs, fabs(theirs), table->moments[m].step);
            return whole != 0 && fabs(theirs / ours / math_pow(10, 3 * whole) - 1) <= bound / fabs(theirs)
                       ? math_pow(10, -3 * whole)
                       : 1;
        }
    return 1;
}

static void find_units(Search *search)
{
    DiagnoseTable *table = search->table;
    for (int c = 0; c < table->n_columns && search->units; c++) {
        const double factor = table->columns[c].factor == 1 ? unit_of(search, c) : 1;
        if (factor == 1)
            continue;
        search->taken = true;
        diagnose_note(table, "its %s is in a unit of its own: %g of ours each", table->columns[c].name,
                      factor);
        for (int i = 0; i < table->n_columns; i++)
            if (table->columns[i].group == table->columns[c].group && table->columns[i].factor == 1)
                table->columns[i].factor = factor;
    }
}

/* The rows that are compared. */
static size_t rows_of(const DiagnoseTable *table)
{
    const DiagnoseMoment *last = &table->moments[table->n_moments - 1];
    return last->first + last->count;
}

/* Whether a column holds what stands beside a run, an answer for each row, to its digits, and not the run. */
static bool is_copy(const Search *search, int c, const double *answers)
{
    const DiagnoseTable *table = search->table;
    const DiagnoseColumn *column = &table->columns[c];
    size_t other = 0, counted = 0;
    for (size_t row = 0; row < rows_of(table); row++) {
        const double theirs = diagnose_theirs(table, column, row);
        const double bound = diagnose_bound(table, column, theirs, column->natural, 0);
        const double ours = search->values[row * (size_t)table->n_columns + (size_t)c];
        if (isnan(theirs))
            continue;
        if (isnan(answers[row]) || fabs(theirs - answers[row]) > bound + 1e-9 * column->natural)
            return false;
        counted++;
        other += fabs(ours - answers[row]) > 2 * bound + 2e-9 * column->natural;
    }
    return other > 0 && counted > 1;
}

/* A column that never changes in the right run, as a mass: beside copied ones it tells of no run. */
static bool is_still(const Search *search, int c)
{
    const DiagnoseTable *table = search->table;
    const size_t count = table->moments[0].count, wide = (size_t)table->n_columns;
    for (size_t row = 0; row < rows_of(table); row++)
        if (table->things[row] != table->things[row % count] ||
            search->values[row * wide + (size_t)c] != search->values[row % count * wide + (size_t)c])
            return false;
    return true;
}

/* A run that has blown up has no number left. Beside numbers that go on, what is none was not written. */
static void leave_out_lost(Search *search)
{
    DiagnoseTable *table = search->table;
    bool still[DIAGNOSE_COLUMNS_MAX], told[DIAGNOSE_COLUMNS_MAX] = {false};
    for (int c = 0; c < table->n_columns; c++)
        still[c] = is_still(search, c);
    for (size_t row = 0; row < rows_of(table); row++) {
        bool goes_on = false;
        for (int c = 0; c < table->n_columns; c++)
            goes_on = goes_on || (!still[c] && isfinite(diagnose_theirs(table, &table->columns[c], row)));
        for (int c = 0; c < table->n_columns && goes_on; c++) {
            double *value = &table->file.columns[table->columns[c].theirs].values[table->rows[row]];
            if (!isinf(*value))
                continue;
            *value = NAN;
            if (!told[c])
                diagnose_note(table, "its column %s is no number from row %zu on: left out",
                              table->columns[c].name, table->rows[row] + 1);
            told[c] = true;
        }
    }
}

static void judge_copy(Search *search, int c, const char *what, const double *answers)
{
    DiagnoseColumn *column = &search->table->columns[c];
    if (column->silent || !is_copy(search, c, answers))
        return;
    column->silent = true;
    search->found->verdict = DIAGNOSE_COPIED;
    diagnose_note(search->table, "its column %s is %s, to all its digits: an answer, not a run", column->name,
                  what);
}

/* Of a series: the answers that stand beside it; those that need the past are left alone. */
static void find_copied_series(Search *search, References *refs, const double *nothing, double *answers)
{
    const DiagnoseTable *table = search->table;
    Column columns[COLUMNS_MAX];
    double row[COLUMNS_MAX];
    const int count = references_memory(refs) == 0 ? references_columns(refs, columns) : 0;
    for (int i = 0; i < count; i++)
        for (int c = 0; c < table->n_columns && columns[i].of >= 0; c++) {
            if (strcmp(columns[columns[i].of].quantity.name, table->columns[c].name) != 0)
                continue;
            for (size_t m = 0; m < table->n_moments; m++) {
                const long step = table->moments[m].step;
                references_row(refs, step, (double)step * table->dt, nothing, row);
                answers[table->moments[m].first] = row[i];
            }
            judge_copy(search, c, columns[i].quantity.meaning, answers);
        }
}

/* Of things: the exact profile at their places of reference. */
static void find_copied_things(Search *search, const References *refs, const Simulation *sim, double *answers)
{
    const DiagnoseTable *table = search->table;
    int place = simulation_find_field(sim, table->set, "x0");
    place = place >= 0 ? place : simulation_find_field(sim, table->set, "x");
    for (int c = 0; c < table->n_columns && place >= 0; c++) {
        const char *name = table->columns[c].name;
        for (size_t m = 0; m < table->n_moments; m++)
            for (size_t k = 0; k < table->moments[m].count; k++) {
                const size_t row = table->moments[m].first + k;
                answers[row] = references_profile(refs, strcmp(name, "velocity") == 0 ? "v" : name,
                                                  simulation_value(sim, place, table->things[row]),
                                                  (double)table->moments[m].step * table->dt);
            }
        judge_copy(search, c, "the exact profile", answers);
    }
}

static bool find_copies(Search *search)
{
    DiagnoseTable *table = search->table;
    Simulation *sim = problem_simulate(&search->right, 1, search->status);
    References *refs = sim ? references_create(&search->right, sim, search->status) : NULL;
    double *nothing = sim ? calloc((size_t)sim->n_series + 1, sizeof *nothing) : NULL;
    double *answers = malloc((rows_of(table) + 1) * sizeof *answers);
    const bool sound = refs && nothing && answers;
    if (sound && table->set < 0)
        find_copied_series(search, refs, nothing, answers);
    else if (sound)
        find_copied_things(search, refs, sim, answers);
    for (int c = 0; c < table->n_columns && search->found->verdict == DIAGNOSE_COPIED; c++)
        table->columns[c].silent = table->columns[c].silent || is_still(search, c);
    references_destroy(refs);
    simulation_destroy(sim);
    free(nothing);
    free(answers);
    return sound;
}

/* What is 0 at the start, as the velocities of a run from rest, is as large as in the right run. */
static void size_from_rest(Search *search)
{
    DiagnoseTable *table = search->table;
    double size[DIAGNOSE_COLUMNS_MAX] = {0};
    for (int c = 0; c < table->n_columns; c++)
        size[table->columns[c].group] = fmax(size[table->columns[c].group], extent_of(search, c).ours);
    for (int c = 0; c < table->n_columns; c++)
        if (table->columns[c].natural == 0 && isfinite(size[table->columns[c].group]))
            table->columns[c].natural = size[table->columns[c].group];
}

/* Empty columns and zeros. Returns how many tell something. */
static int silence(Search *search)
{
    DiagnoseTable *table = search->table;
    int telling = 0;
    for (int c = 0; c < table->n_columns; c++) {
        DiagnoseColumn *column = &table->columns[c];
        const Extent extent = extent_of(search, c);
        const double least = 1e2 * table->noise * column->natural;
        if (extent.given == 0)
            diagnose_note(table, "its column %s is empty", column->name);
        else if (extent.theirs == 0 && extent.ours > least)
            diagnose_note(table,
                          "its column %s is zero throughout, where the right run moves: as good as empty",
                          column->name);
        column->silent =
            extent.given == 0 || extent.theirs == 0 || (extent.theirs <= least && extent.ours <= least);
        telling += !column->silent;
    }
    return telling;
}

/* --- what round-off grows to ---------------------------------------------------------------------------- */

/* The same run with a modulus and cells that are others in their last digit: its round-off is another one
 * throughout, that of places too. */
static bool disturb(Settings *settings)
{
    static const char *const keys[] = {"bar.youngs_modulus", "beam.youngs_modulus", "mesh.cell_size"};
    bool other = false;
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        const Parameter *parameter = parameter_find(keys[i]);
        const Settings before = *settings;
        if (!parameter_applies_to(settings, parameter))
            continue;
        settings_put(settings, parameter, settings_number(settings, parameter) * (1 + 2 * DBL_EPSILON));
        if (settings_check(settings, NULL))
            other = true;
        else
            *settings = before;
    }
    return other;
}

/* Of each moment and group of columns what two records have differed by up to there. Returns the moments
 * before that is as large as the numbers. */
static size_t growth(const DiagnoseTable *table, size_t moments, const double *one, const double *other,
                     double *grown)
{
    enum { MARGIN = 100 }; /* one run stands for all */
    const size_t wide = (size_t)table->n_columns;
    double size[DIAGNOSE_COLUMNS_MAX] = {0}, most[DIAGNOSE_COLUMNS_MAX] = {0};
    for (size_t m = 0; m < moments; m++) {
        for (size_t k = 0; k < table->moments[m].count; k++)
            for (int c = 0; c < table->n_columns; c++) {
                const DiagnoseColumn *column = &table->columns[c];
                const size_t at = (table->moments[m].first + k) * wide + (size_t)c;
                const double apart = MARGIN * fabs(one[at] - other[at]);
                if (column->silent || isnan(apart))
                    continue;
                size[column->group] = fmax(size[column->group], fmax(column->natural, fabs(one[at])));
                most[column->group] = fmax(most[column->group], apart);
                if (!(apart < 1e-3 * size[column->group]) && apart > 0)
                    return m;
            }
        memcpy(grown + m * wide, most, wide * sizeof *most);
    }
    return moments;
}

/* What the round-off of a run has grown to, [moment][group]; the caller frees it. *moments: those before it
 * is as large as the numbers. NULL: it is not known, or it was given up. */
static double *round_off_of(const Search *search, const Settings *settings, size_t *moments, bool *stopped)
{
    const DiagnoseTable *table = search->table;
    const size_t entries = table->file.count * (size_t)table->n_columns;
    double *values[2] = {malloc((entries + 1) * sizeof(double)), malloc((entries + 1) * sizeof(double))};
    double *grown = calloc(entries + 1, sizeof *grown);
    Settings twin = *settings;
    const Settings *both[2] = {settings, &twin};
    bool known = values[0] && values[1] && grown && disturb(&twin);
    *moments = table->n_moments;
    for (int i = 0; i < 2 && known; i++) {
        for (size_t k = 0; k < entries; k++)
            values[i][k] = NAN;
        Walk one = {.table = table, .moments = SIZE_MAX, .to_end = true, .values = values[i]};
        diagnose_walk(&one, both[i], search->task->threads, search->task->patience, NULL);
        *stopped = *stopped || one.stopped;
        *moments = one.compared < *moments ? one.compared : *moments;
        known = !one.stopped && one.compared > 0;
    }
    if (known)
        *moments = growth(table, *moments, values[0], values[1], grown);
    free(values[0]);
    free(values[1]);
    if (known)
        return grown;
    free(grown);
    return NULL;
}

/* --- the right run -------------------------------------------------------------------------------------- */

static bool walk_right(Search *search)
{
    search->walk = (Walk){.table = search->table,
                          .moments = SIZE_MAX,
                          .to_end = true,
                          .values = search->values,
                          .grown = search->grown};
    return diagnose_walk(&search->walk, &search->right, search->task->threads, search->task->patience,
                         search->status);
}

static bool is_quiet(const DiagnoseTable *table)
{
    for (int c = 0; c < table->n_columns; c++)
        if (!table->columns[c].silent)
            return false;
    return true;
}

/* Where the file departs it may do so by no more than round-off does that grows, as at a node that hardly has
 * mass. Rows in which that is as large as the numbers tell nothing. */
static bool walk_with_round_off(Search *search)
{
    size_t moments;
    bool stopped = false;
    search->grown = round_off_of(search, &search->right, &moments, &stopped);
    if (stopped)
        return status_fail(search->status, "interrupted");
    if (!search->grown || moments == 0)
        return true;
    if (moments < search->walk.compared) {
        search->table->n_moments = moments;
        diagnose_note(search->table, "round-off grows to the size of the numbers: compared up to step %ld",
                      search->table->moments[moments - 1].step);
    }
    return walk_right(search);
}

/* A column that was copied may leave others that were computed. */
static bool read_columns(Search *search)
{
    DiagnoseTable *table = search->table;
    if (!walk_right(search))
        return false;
    leave_out_lost(search);
    find_units(search);
    size_from_rest(search);
    const int telling = silence(search);
    if (telling > 0 && !table->of_stages && !find_copies(search))
        return false;
    if (telling == 0 || is_quiet(table)) {
        search->found->verdict = search->found->verdict == DIAGNOSE_COPIED ? DIAGNOSE_COPIED : DIAGNOSE_MUTE;
        return true;
    }
    search->found->verdict = DIAGNOSE_UNKNOWN;
    return walk_right(search) && (!search->walk.departure.is || walk_with_round_off(search));
}

static int digits_of(const Search *search, double worst)
{
    int most = 0;
    for (int c = 0; c < search->table->n_columns; c++)
        if (!search->table->columns[c].silent)
            most = (int)fmax(most, search->table->file.columns[search->table->columns[c].theirs].digits);
    const double digits = worst > 0 ? floor(-math_log10(worst)) : 17;
    return (int)fmax(0, fmin(fmin(digits, most), 16));
}

/* The row of the same thing before. */
static void look_back(Search *search)
{
    const DiagnoseTable *table = search->table;
    Departure *departure = &search->found->departure;
    const DiagnoseColumn *column = &table->columns[departure->column];
    for (size_t row = table->moments[departure->moment].first; row-- > 0;)
        if (table->things[row] == departure->thing) {
            departure->theirs_before = diagnose_theirs(table, column, row);
            departure->ours_before =
                search->values[row * (size_t)table->n_columns + (size_t)departure->column];
            return;
        }
}

static void name_departure(Search *search)
{
    const DiagnoseTable *table = search->table;
    Departure *departure = &search->found->departure;
    const DiagnoseColumn *column = &table->columns[departure->column];
    const double bound = diagnose_bound(table, column, departure->theirs, column->natural, departure->step);
    look_back(search);
    if (departure->ours != 0 && isfinite(departure->theirs))
        diagnose_name_factor(departure->theirs / departure->ours, 1e-12 + 2 * bound / fabs(departure->ours),
                             &search->right, departure->factors, sizeof departure->factors);
    const double change = departure->ours - departure->ours_before;
    if (isfinite(change) && fabs(change) > 20 * bound)
        diagnose_name_factor((departure->theirs - departure->theirs_before) / change,
                             1e-9 + 4 * bound / fabs(change), &search->right, departure->change_factors,
                             sizeof departure->change_factors);
    for (int c = 0; c < table->n_columns; c++)
        if (!table->columns[c].silent && !search->walk.departs[c] && !is_still(search, c))
            text_list_add(search->found->agreeing, sizeof search->found->agreeing, table->columns[c].name);
    search->found->farthest = search->walk.farthest;
    departure->row = table->rows[departure->row] + 1;
    if (departure->stage > 0)
        departure->stage_id = table->stage_ids[departure->stage - 1];
}

/* --- other codes ---------------------------------------------------------------------------------------- */

/* A code that agrees takes its place among those found. */
static void keep(Search *search, const Candidate *candidate, const Settings *wrong, const Walk *walk)
{
    Diagnosis *found = search->found;
    if (found->n_explanations == EXPLANATIONS_MAX) {
        found->more++;
        return;
    }
    Explanation *explanation = &found->explanations[found->n_explanations];
    diagnose_explain(candidate, &search->right, wrong, explanation);
    explanation->digits = digits_of(search, walk->worst);
    for (size_t m = 0; m < walk->compared; m++)
        explanation->rows += search->table->moments[m].count;
    explanation->grown = walk->failed || walk->moments < search->table->n_moments;
    if (found->n_explanations++ == 0 && search->walk.departure.is) {
        search->first = *candidate;
        search->by_first = *wrong;
        return;
    }
    if (candidate->kind != DIAGNOSE_SHIFT && search->first.kind != DIAGNOSE_SHIFT)
        diagnose_tell_apart(wrong, &search->by_first, search->table, explanation->apart,
                            sizeof explanation->apart);
}

/* A code that agrees for a while and then by less and less: compared again with what round-off grows to in
 * it. False: it was given up. */
static bool try_again(Search *search, const Settings *wrong, Walk *walk, bool *agrees)
{
    size_t moments;
    bool stopped = false;
    double *grown = round_off_of(search, wrong, &moments, &stopped);
    if (grown && moments > walk->departure.moment) {
        *walk = (Walk){.table = search->table, .moments = moments, .grown = grown};
        diagnose_walk(walk, wrong, search->task->threads, search->task->patience, NULL);
        stopped = walk->stopped;
        *agrees = !stopped && !walk->departure.is;
        walk->grown = NULL;
    }
    free(grown);
    return !stopped || status_fail(search->status, "interrupted");
}

/* So many moments beyond the right run's departure are no chance. */
enum { LEAST_BEYOND = 5 };

/* False: it was given up. */
static bool try_one(Search *search, const Candidate *candidate, Walk *walk, Settings *wrong, bool *agrees)
{
    *agrees = false;
    *walk = (Walk){
        .table = search->table, .moments = SIZE_MAX, .shift = candidate->shift, .grown = search->grown};
    if (!diagnose_settings_of(candidate, &search->right, search->table, wrong))
        return true;
    Status why = {STATUS_DONE, ""};
    search->found->tried++;
    if (!diagnose_walk(walk, wrong, search->task->threads, search->task->patience, &why) && walk->stopped) {
        if (search->status)
            *search->status = why;
        return false;
    }
    walk->grown = NULL;
    /* up to where a run fails it may agree; it has to agree beyond where the right one departs, or as far as
     * the right one does */
    const bool departs = search->walk.departure.is;
    const size_t shown = departs ? search->walk.departure.moment : 0;
    *agrees = !walk->departure.is && walk->entries > 0 &&
              (departs ? walk->compared > shown : walk->compared >= search->walk.compared);
    return *agrees || !departs || candidate->kind != DIAGNOSE_MISTAKE ||
           walk->departure.moment < shown + LEAST_BEYOND || try_again(search, wrong, walk, agrees);
}

static bool has_value(const Diagnosis *found, const Parameter *parameter)
{
    for (int i = 0; i < found->n_explanations; i++)
        if (found->explanations[i].kind != DIAGNOSE_MISTAKE &&
            strncmp(found->explanations[i].id, parameter->key, strlen(parameter->key)) == 0)
            return true;
    return false;
}

/* A factor of few digits: a slip, not a fit. */
static bool is_round(double factor, const Settings *right)
{
    char name[96];
    double shorter;
    diagnose_name_factor(factor, 1e-9, right, name, sizeof name);
    return *name || (text_to_double(text_rounded(factor, 3).text, &shorter) &&
                     fabs(shorter - factor) <= 1e-9 * fabs(factor));
}

/* Beyond it a value stands for something else, as no stiffness for no force. */
#define LEAST_FACTOR 1e-4

/* Fewer can be had with any value, or with two mistakes of some. */
enum { ENTRIES_LEAST = 3 };

/* Whether a code with that value makes a time step that the file's times may mean. */
static bool may_be_its_step(const Search *search, const Settings *wrong)
{
    double own;
    return problem_time_step(wrong, &own, NULL) &&
           fabs(own - search->table->dt) <= search->table->dt_bound + 1e-12 * search->table->dt;
}

/* One parameter's value, with the file's time step or with one that follows from it. Beside a simpler
 * explanation only a round one. False: it was given up. */
static bool try_value(Search *search, const Parameter *parameter, const TimeSettings *own_step, bool simpler)
{
    Candidate candidate = {DIAGNOSE_VALUE, parameter, 0, 0, 0, own_step};
    const DiagnoseTask task = {
        .settings = &search->right, .threads = search->task->threads, .patience = search->task->patience};
    Settings wrong;
    Walk walk;
    bool agrees;
    if (!diagnose_find_value(&task, search->table, &search->walk.departure, parameter, own_step,
                             &candidate.value, &search->found->tried))
        return patience_lasts(&search->task->patience, 0) || status_fail(search->status, "interrupted");
    const double now = settings_number(&search->right, parameter);
    const double factor = now != 0 ? candidate.value / now : candidate.value;
    if ((now != 0 && fabs(factor - 1) < 1e-8) || /* of another time step, or of fewer digits */
        (now != 0 && !(fabs(factor) > LEAST_FACTOR && fabs(factor) < 1 / LEAST_FACTOR)) ||
        (simpler && !is_round(factor, &search->right)))
        return true;
    if (!try_one(search, &candidate, &walk, &wrong, &agrees))
        return false;
    if (agrees && (!own_step || may_be_its_step(search, &wrong)))
        keep(search, &candidate, &wrong, &walk);
    return true;
}

/* One value that is wrong. Where times of few digits leave the step open, it may be that of the value. */
static bool try_values(Search *search)
{
    const DiagnoseTable *table = search->table;
    const bool simpler = search->found->n_explanations > 0, open = table->dt_bound > 1e-12 * table->dt;
    if (search->walk.departing < ENTRIES_LEAST)
        return true;
    for (int by_value = 0; by_value <= (open && !simpler); by_value++)
        for (int i = 0; i < n_parameters; i++)
            if (diagnose_is_tried(&search->right, &parameters[i]) && parameters[i].type == PARAMETER_REAL &&
                !has_value(search->found, &parameters[i]) &&
                !try_value(search, &parameters[i], by_value ? settings_time(search->task->settings) : NULL,
                           simpler))
                return false;
    return true;
}

/* Two mistakes, where no one thing explains the file. */
static bool try_pairs(Search *search)
{
    Candidate *pairs = malloc(CANDIDATES_MAX * sizeof *pairs);
    Settings wrong;
    Walk walk;
    bool sound = pairs || status_fail(search->status, "out of memory"), agrees;
    search->found->pairs_left = !search->task->pairs && search->right.problem->concerns & CONCERN_PLANE;
    const int count = sound && !search->found->pairs_left ? diagnose_pairs(&search->right, pairs) : 0;
    for (int i = 0; i < count && sound; i++) {
        sound = try_one(search, &pairs[i], &walk, &wrong, &agrees);
        if (sound && agrees)
            keep(search, &pairs[i], &wrong, &walk);
    }
    free(pairs);
    return sound;
}

/* `shown`: whether the file departs; else only mistakes count, those that it cannot show. */
static bool try_all(Search *search, bool shown)
{
    Candidate *candidates = malloc(CANDIDATES_MAX * sizeof *candidates);
    Settings wrong;
    Walk walk;
    bool sound = candidates || status_fail(search->status, "out of memory"), agrees;
    const int count = sound ? diagnose_candidates(&search->right, candidates) : 0;
    search->by_first = search->right;
    for (int i = 0; i < count && sound; i++) {
        if (!shown && candidates[i].kind != DIAGNOSE_MISTAKE)
            continue;
        sound = try_one(search, &candidates[i], &walk, &wrong, &agrees);
        if (sound && agrees)
            keep(search, &candidates[i], &wrong, &walk);
    }
    free(candidates);
    if (!sound || !shown)
        return sound;
    return try_values(search) &&
           (search->found->n_explanations > 0 || search->walk.departing < ENTRIES_LEAST || try_pairs(search));
}

/* --- the whole ------------------------------------------------------------------------------------------ */

static bool judge(Search *search)
{
    Diagnosis *found = search->found;
    const DiagnoseTable *table = search->table;
    const Walk *walk = &search->walk;
    if (!read_columns(search))
        return false;
    if (found->verdict != DIAGNOSE_UNKNOWN)
        return true;
    for (size_t m = 0; m < walk->compared; m++) {
        found->compared += table->moments[m].count;
        found->agreed += m < walk->agreed ? table->moments[m].count : 0;
    }
    found->agreed_step = walk->agreed > 0 ? table->moments[walk->agreed - 1].step : -1;
    found->digits = digits_of(search, walk->worst);
    found->naive =
        search->right.method == METHOD_PD && walk->worst > 1e-11 && walk->worst < table->noise * 10;
    found->departure = walk->departure;
    if (walk->departure.is)
        name_departure(search);
    if (!try_all(search, walk->departure.is))
        return false;
    found->verdict = !walk->departure.is         ? DIAGNOSE_RIGHT
                     : found->n_explanations > 0 ? DIAGNOSE_EXPLAINED
                                                 : DIAGNOSE_UNKNOWN;
    return true;
}

/* A power of a thousand may be a mistake and no unit: where no code explains the file with units of its own,
 * one may with ours. `begun`: the table as it was read. */
static bool judge_without_units(Search *search, const DiagnoseTable *begun)
{
    const Diagnosis before = *search->found;
    const DiagnoseTable table = *search->table;
    *search->table = *begun;
    *search->found = (Diagnosis){
        .agreed_step = -1, .verdict = DIAGNOSE_UNKNOWN, .rows = begun->file.count, .tried = before.tried};
    free(search->grown);
    search->grown = NULL;
    search->units = false;
    const bool sound = judge(search);
    if (!sound || search->found->verdict != DIAGNOSE_UNKNOWN)
        return sound;
    const long tried = search->found->tried;
    *search->table = table;
    *search->found = before;
    search->found->tried = tried;
    return true;
}

bool diagnose(const DiagnoseTask *task, DiagnoseTable *table, Diagnosis *found, Status *status)
{
    Search *search = calloc(1, sizeof *search);
    *found = (Diagnosis){.agreed_step = -1, .verdict = DIAGNOSE_UNKNOWN, .rows = table->file.count};
    if (!search)
        return status_fail(status, "out of memory");
    *search = (Search){.task = task,
                       .table = table,
                       .found = found,
                       .right = *task->settings,
                       .units = true,
                       .status = status};
    const DiagnoseTable begun = *table;
    search->values = malloc((table->file.count * (size_t)table->n_columns + 1) * sizeof *search->values);
    for (size_t i = 0; search->values && i < table->file.count * (size_t)table->n_columns; i++)
        search->values[i] = NAN;
    bool sound = search->values || status_fail(status, "out of memory");
    Status why = {STATUS_DONE, ""};
    sound = sound && (diagnose_hold_step(&search->right, table->dt, &why) ||
                      status_refuse(status, "%s: the scenario cannot be run with its time step %.10g%s%s",
                                    table->file.file, table->dt, *why.text ? ": " : "", why.text));
    sound = sound &&
            settings_refuse_mistake(&search->right, "a file is compared with the right code", status) &&
            judge(search) &&
            (!search->taken || found->verdict != DIAGNOSE_UNKNOWN || judge_without_units(search, &begun));
    free(search->values);
    free(search->grown);
    free(search);
    return sound;
}
