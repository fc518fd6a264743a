/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the columns of a foreign table are worth, once the right run has been laid beside them
 * (diagnose_internal.h): their sizes, and those without information, which are empty, zero,
 * copied, or no numbers. */
#include "answers/diagnose/diagnose_internal.h"

#include "answers/references.h"
#include "problems/problem.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* How much a column holds: in the file and in the right run. */
typedef struct Extent {
    size_t given;
    double theirs, ours; /* largest */
} Extent;

static Extent extent_of(const Search *search, int c)
{
    const DiagnoseTable *table = search->table;
    const size_t rows = diagnose_rows(table, search->walk.compared);
    Extent extent = {0, 0, 0};
    for (size_t row = 0; row < rows; row++) {
        const double theirs = diagnose_theirs(table, &table->as.columns[c], row);
        extent.given += isnan(theirs) ? 0 : 1;
        extent.theirs = fmax(extent.theirs, fabs(theirs)); /* NAN counts for nothing */
        extent.ours = fmax(extent.ours, fabs(search->values[row * (size_t)table->as.n_columns + (size_t)c]));
    }
    return extent;
}

/* Whether a column holds what is beside a run, an answer for each row, to its digits, and not the run. */
static bool is_copy(const Search *search, int c, const double *answers)
{
    const DiagnoseTable *table = search->table;
    const DiagnoseColumn *column = &table->as.columns[c];
    size_t other = 0, counted = 0;
    if (strncmp(column->unit, "mass*length", 11) == 0)
        return false; /* a run may keep momentum exactly */
    for (size_t row = 0; row < diagnose_rows(table, table->n_moments); row++) {
        const double theirs = diagnose_theirs(table, column, row);
        const double bound =
            diagnose_rounding(table, column, theirs) + diagnose_noise(table, column->natural, 0);
        const double ours = search->values[row * (size_t)table->as.n_columns + (size_t)c];
        if (isnan(theirs))
            continue;
        if (isnan(answers[row]) || fabs(theirs - answers[row]) > bound + 1e-9 * column->natural)
            return false;
        counted++;
        other += fabs(ours - answers[row]) > 2 * bound + 2e-9 * column->natural;
    }
    return other > 0 && counted > 1;
}

bool diagnose_is_still(const Search *search, int c)
{
    const DiagnoseTable *table = search->table;
    const size_t count = table->moments[0].count, wide = (size_t)table->as.n_columns;
    for (size_t row = 0; row < diagnose_rows(table, table->n_moments); row++)
        if (table->things[row] != table->things[row % count] ||
            search->values[row * wide + (size_t)c] != search->values[row % count * wide + (size_t)c])
            return false;
    return true;
}

/* A run that has blown up has no number left. Beside numbers that go on, what is none was not written. */
static void leave_out_lost(Search *search)
{
    DiagnoseTable *table = search->table;
    bool still[DIAGNOSE_COLUMNS_MAX];
    for (int c = 0; c < table->as.n_columns; c++)
        still[c] = diagnose_is_still(search, c);
    for (size_t row = 0; row < diagnose_rows(table, table->n_moments); row++) {
        bool goes_on = false;
        for (int c = 0; c < table->as.n_columns; c++)
            goes_on = goes_on || (!still[c] && isfinite(diagnose_theirs(table, &table->as.columns[c], row)));
        for (int c = 0; c < table->as.n_columns && goes_on; c++) {
            double *value = &table->file.columns[table->as.columns[c].theirs].values[table->rows[row]];
            if (!isinf(*value))
                continue;
            *value = NAN; /* in every reading that comes */
            size_t *lost = &search->lost[table->as.columns[c].theirs];
            *lost = *lost ? *lost : table->rows[row] + 1;
        }
    }
    for (int c = 0; c < table->as.n_columns; c++)
        if (search->lost[table->as.columns[c].theirs])
            diagnose_note(table, "its column %s is not a number from row %zu on: left out",
                          table->as.columns[c].name, search->lost[table->as.columns[c].theirs]);
}

static void judge_copy(Search *search, int c, const char *what, const double *answers)
{
    DiagnoseColumn *column = &search->table->as.columns[c];
    if (column->silent || !is_copy(search, c, answers))
        return;
    column->silent = true;
    search->found->verdict = DIAGNOSE_COPIED;
    diagnose_note(search->table, "its column %s is %s, to all its digits: an answer, not a run", column->name,
                  what);
}

/* Of a series: the answers that are beside it; those that need the past are left alone. */
static void find_copied_series(Search *search, References *refs, const double *nothing, double *answers)
{
    const DiagnoseTable *table = search->table;
    Column columns[COLUMNS_MAX];
    double row[COLUMNS_MAX];
    const int count = references_memory(refs) == 0 ? references_columns(refs, columns) : 0;
    for (int i = 0; i < count; i++)
        for (int c = 0; c < table->as.n_columns && columns[i].of >= 0; c++) {
            if (strcmp(columns[columns[i].of].quantity.name, table->as.columns[c].name) != 0)
                continue;
            for (size_t m = 0; m < table->n_moments; m++) {
                const long step = table->moments[m].step;
                references_row(refs, step, (double)step * table->as.dt, nothing, row);
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
    for (int c = 0; c < table->as.n_columns && place >= 0; c++) {
        const char *name = table->as.columns[c].name;
        for (size_t m = 0; m < table->n_moments; m++)
            for (size_t k = 0; k < table->moments[m].count; k++) {
                const size_t row = table->moments[m].first + k;
                answers[row] = references_profile(refs, strcmp(name, "velocity") == 0 ? "v" : name,
                                                  simulation_value(sim, place, table->things[row]),
                                                  (double)table->moments[m].step * table->as.dt);
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
    double *answers = malloc((diagnose_rows(table, table->n_moments) + 1) * sizeof *answers);
    const bool sound = refs && nothing && answers;
    if (sound && table->set < 0)
        find_copied_series(search, refs, nothing, answers);
    else if (sound)
        find_copied_things(search, refs, sim, answers);
    for (int c = 0; c < table->as.n_columns && search->found->verdict == DIAGNOSE_COPIED; c++)
        table->as.columns[c].silent = table->as.columns[c].silent || diagnose_is_still(search, c);
    references_destroy(refs);
    simulation_destroy(sim);
    free(nothing);
    free(answers);
    return sound;
}

/* Sizes; empty columns and zeros. */
static void silence(Search *search)
{
    DiagnoseTable *table = search->table;
    double size[DIAGNOSE_COLUMNS_MAX] = {0};
    Extent extents[DIAGNOSE_COLUMNS_MAX];
    for (int c = 0; c < table->as.n_columns; c++) {
        double *most = &size[table->as.columns[c].group];
        extents[c] = extent_of(search, c);
        *most = fmax(*most, extents[c].ours);
    }
    for (int c = 0; c < table->as.n_columns; c++) {
        DiagnoseColumn *column = &table->as.columns[c];
        const Extent extent = extents[c];
        /* what is 0 at the start, as the velocities of a run from rest, is as large as in the right run */
        if (column->natural == 0 && isfinite(size[column->group]))
            column->natural = size[column->group];
        const double least = 1e2 * table->noise * column->natural;
        if (extent.given == 0)
            diagnose_note(table, "its column %s is empty", column->name);
        else if (extent.theirs == 0 && extent.ours > least)
            diagnose_note(table,
                          "its column %s is zero throughout, where the right run moves: as good as empty",
                          column->name);
        column->silent =
            extent.given == 0 || extent.theirs == 0 || (extent.theirs <= least && extent.ours <= least);
    }
}

/* Whether a column is left. */
static bool is_telling(const DiagnoseTable *table)
{
    for (int c = 0; c < table->as.n_columns; c++)
        if (!table->as.columns[c].silent)
            return true;
    return false;
}

/* A column that was copied may leave others that were computed. */
bool diagnose_judge_columns(Search *search)
{
    DiagnoseTable *table = search->table;
    leave_out_lost(search);
    silence(search);
    bool tells = is_telling(table);
    if (tells && table->moments[table->n_moments - 1].step == 0) {
        diagnose_note(table, "it has t = 0 alone, which the scenario gives");
        tells = false;
    }
    if (tells && !table->of_stages && !find_copies(search))
        return false;
    const bool copied = search->found->verdict == DIAGNOSE_COPIED;
    search->found->verdict = tells && is_telling(table) ? DIAGNOSE_UNKNOWN
                             : copied                   ? DIAGNOSE_COPIED
                                                        : DIAGNOSE_MUTE;
    return true;
}
