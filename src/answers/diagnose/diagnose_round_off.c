/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the round-off of a run grows to (diagnose_internal.h). */
#include "answers/diagnose/diagnose_internal.h"

#include "scenario/settings.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Whether all numbers that are written with more digits than single precision has are numbers of it, but for
 * noise of the eleventh digit. */
bool diagnose_is_single(const DiagnoseTable *table)
{
    /* of ten numbers one is single by chance, for each digit above seven */
    enum { DIGITS = 8, DIGITS_MOST = 11, LEAST = 10, ENTRIES = 5 };
    size_t counted = 0, entries = 0;
    for (int c = 0; c < table->as.n_columns; c++) {
        const OverlayColumn *column = &table->file.columns[table->as.columns[c].theirs];
        for (size_t k = 0; k < table->file.count && !table->as.columns[c].silent && column->digits >= DIGITS;
             k++) {
            const double value = column->values[k];
            if (!isfinite(value) || value == 0)
                continue;
            const double digit = fmax(0.51 * diagnose_last_digit(column, value), 5e-12 * fabs(value));
            if (fabs(value - (double)(float)value) > digit)
                return false;
            counted += (size_t)(fmin(column->digits, DIGITS_MOST) + 1 - DIGITS);
            entries++;
        }
    }
    return counted >= LEAST && entries >= ENTRIES;
}

double diagnose_terms(const Overlay *file, int column)
{
    enum { ENTRIES = 5, FINER = 16 }; /* any number is a multiple in a case of 16 or fewer */
    const OverlayColumn *one = &file->columns[column];
    const double most = fmax(fabs(one->least), fabs(one->largest));
    size_t entries = 0;
    if (!isfinite(most) || most == 0)
        return 0;
    double unit = ldexp(1, ilogb(most));
    for (size_t k = 0; k < file->count; k++) {
        const double value = one->values[k], digit = isfinite(value) ? diagnose_last_digit(one, value) : 0;
        if (!isfinite(value) || value == 0)
            continue;
        while (unit > FINER * digit && fabs(value - round(value / unit) * unit) > 0.51 * digit)
            unit /= 2;
        if (unit <= FINER * digit)
            return 0;
        entries++;
    }
    const double terms = 2 * unit / FLT_EPSILON;
    return entries >= ENTRIES && terms > 8 * most ? terms : 0;
}

int diagnose_digits_written(const DiagnoseTable *table)
{
    int most = 0;
    for (int c = 0; c < table->as.n_columns; c++)
        if (!table->as.columns[c].silent)
            most = (int)fmax(most, table->file.columns[table->as.columns[c].theirs].digits);
    return most;
}

/* The same run with a modulus and cells that are others in their last digit: its round-off is another one
 * throughout, that of places too. */
static bool disturb(Settings *settings)
{
    static const char *const keys[] = {"bar.youngs_modulus", "beam.youngs_modulus", "plate.youngs_modulus",
                                       "material.youngs_modulus", "mesh.cell_size"};
    bool other = false;
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        const Parameter *parameter = parameter_find(keys[i]);
        const Settings before = *settings;
        /* a box is whole cells, and particles lie in bodies to the last digit */
        if (!parameter_applies_to(settings, parameter) ||
            (other && settings->problem->concerns & CONCERN_BODIES))
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
    /* one run for all; where a stretch is a difference of lengths a step may lose more than the last digit */
    const double margin =
        table->noise < 1e-8 ? fmax(100, 1e-2 * table->noise / DBL_EPSILON) : 10 / DBL_EPSILON * FLT_EPSILON;
    const size_t wide = (size_t)table->as.n_columns;
    double size[DIAGNOSE_COLUMNS_MAX] = {0}, most[DIAGNOSE_COLUMNS_MAX] = {0};
    for (size_t m = 0; m < moments; m++) {
        for (size_t k = 0; k < table->moments[m].count; k++)
            for (int c = 0; c < table->as.n_columns; c++) {
                const DiagnoseColumn *column = &table->as.columns[c];
                const size_t at = (table->moments[m].first + k) * wide + (size_t)c;
                const double apart = margin * fabs(one[at] - other[at]);
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

double *diagnose_grown(const Search *search, const Settings *settings, size_t *moments, bool *stopped)
{
    const DiagnoseTable *table = search->table;
    Settings twin = *settings;
    const Settings *both[2] = {settings, &twin};
    double *values[2] = {diagnose_room(table), diagnose_room(table)};
    double *grown = calloc(table->file.count * (size_t)table->as.n_columns + 1, sizeof *grown);
    bool known = values[0] && values[1] && grown && disturb(&twin);
    *moments = table->n_moments;
    for (int i = 0; i < 2 && known; i++) {
        Walk walk = {.table = table, .to_end = true, .values = values[i]};
        diagnose_walk(&walk, search->task, both[i], NULL);
        *stopped = *stopped || walk.stopped;
        *moments = walk.compared < *moments ? walk.compared : *moments;
        known = !walk.stopped && walk.compared > 0;
    }
    if (known)
        *moments = growth(table, *moments, values[0], values[1], grown);
    else {
        free(grown);
        grown = NULL;
    }
    free(values[0]);
    free(values[1]);
    return grown;
}
