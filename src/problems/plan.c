/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What solvers build their answers from: the plan of columns, and derived numbers. */
#include "problems/solver.h"

#include "base/assertion.h"
#include "scenario/concern_time.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

double derived_named(const Derived *derived, int count, const char *name)
{
    for (int i = 0; i < count; i++)
        if (strcmp(derived[i].name, name) == 0)
            return derived[i].value;
    return NAN;
}

void derived_add(Derived out[DERIVED_MAX], int *count, const char *name, const char *label, const char *unit,
                 double value, bool integer)
{
    ASSERT_INT(*count, <, DERIVED_MAX);
    if (*count < DERIVED_MAX)
        out[(*count)++] =
            (Derived){.name = name, .label = label, .unit = unit, .value = value, .integer = integer};
}

void derived_add_answer(Derived out[DERIVED_MAX], int *count, Reference reference, const char *name,
                        const char *label, const char *unit, double value)
{
    ASSERT_INDEX(reference, REFERENCES);
    const int before = *count;
    derived_add(out, count, name, label, unit, value, false);
    if (*count > before) {
        out[before].by_reference = true;
        out[before].reference = reference;
    }
}

bool problem_limit_courant(const Settings *settings, double largest, double allowed, char *text, size_t size,
                           Status *status)
{
    const double courant = settings_time(settings)->courant;
    if (courant > largest && !settings_time(settings)->unstable)
        return status_refuse(
            status, "time.courant: %.6g is unstable on this mesh (at most %s, or time.unstable = yes)",
            courant, text_limit(allowed, 5).text);
    if (courant > largest)
        snprintf(text, size, "courant %.4g is beyond the largest stable one, %.5g: this run will blow up",
                 courant, largest);
    else if (courant > 0.9 * largest)
        snprintf(text, size, "courant %.4g is near the largest stable one, %.5g", courant, largest);
    return true;
}

int plan_find(const References *refs, const char *column)
{
    for (int i = 0; i < refs->n_columns; i++)
        if (strcmp(refs->plan[i].column.quantity.name, column) == 0)
            return i;
    return -1;
}

static void plan_add(References *refs, PlannedColumn planned)
{
    ASSERT_INT(refs->n_columns, <, COLUMNS_MAX);
    if (refs->n_columns < COLUMNS_MAX)
        refs->plan[refs->n_columns++] = planned;
}

void plan_method(References *refs, const Simulation *sim, const char *series)
{
    int index = simulation_find_series(sim, series);
    if (index >= 0 && plan_find(refs, series) < 0)
        plan_add(refs, (PlannedColumn){{sim->series[index], COLUMN_MEASURED, -1}, index, NULL, false});
}

void plan_rest_of_method(References *refs, const Simulation *sim)
{
    for (int i = 0; i < sim->n_series; i++)
        plan_method(refs, sim, sim->series[i].name);
}

void plan_answer(References *refs, const Quantity *quantity, ColumnKind kind, const char *of, Answer *answer)
{
    if ((kind == COLUMN_EXACT && refs->unaccounted[REFERENCE_EXACT]) ||
        (kind == COLUMN_PREDICTED && refs->unaccounted[REFERENCE_PREDICTED]))
        return;
    plan_add(refs, (PlannedColumn){{*quantity, kind, of ? plan_find(refs, of) : -1}, -1, answer, false});
}

void plan_filter(References *refs, const Quantity *quantity, const char *of, Answer *answer)
{
    plan_add(refs, (PlannedColumn){{*quantity, COLUMN_MEASURED, plan_find(refs, of)}, -1, answer, true});
}

void *plan_own(References *refs, size_t size, void (*release)(void *own), Status *status)
{
    ASSERT(!refs->own);
    refs->own = calloc(1, size);
    refs->release = release;
    if (!refs->own)
        status_fail(status, "not enough memory for the reference solutions");
    return refs->own;
}

bool plan_window(References *refs, const Simulation *sim, const char *series, long rows)
{
    ASSERT_INT(rows, >=, 1);
    Window *window = &refs->window;
    window->of = simulation_find_series(sim, series);
    window->size = rows;
    window->values = malloc((size_t)rows * sizeof *window->values);
    return window->values != NULL;
}
