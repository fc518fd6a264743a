/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The forces of a node's bonds as they add up to its own, by the side on which they pull. */
#include "views/inspector/family.h"
#include "scenario/concern_loads.h"
#include "scenario/settings.h"
#include "base/math/functions.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SIDES = 3, FORCE_ROWS_MAX = 8, FORCE_COLUMN = 11 };

/* A row of the sum. */
typedef struct ForceRow {
    const char *name;
    double value[2];
    bool is_sum, is_changed;
} ForceRow;

typedef struct ForceSum {
    ForceRow rows[FORCE_ROWS_MAX]; /* the sides, all bonds, then load and force, or the force alone */
    double exact[FORCE_ROWS_MAX][2];
    int count;
} ForceSum;

double family_field(const Family *family, const char *name, size_t node)
{
    return simulation_value(family->sim, simulation_find_field(family->sim, 0, name), node);
}

static void add_row(ForceSum *sum, const char *name, double x, double y, bool is_sum, bool is_changed)
{
    sum->exact[sum->count][0] = x;
    sum->exact[sum->count][1] = y;
    sum->rows[sum->count++] = (ForceRow){name, {x, y}, is_sum, is_changed};
}

/* The load on the node at the time to which its force belongs, N/m^3. */
static double load_on(const Family *family)
{
    const Settings *settings = family->settings;
    const double time = (double)(family->sim->step + (family->sim->stage > 0)) * family->sim->dt;
    const double share =
        settings_loads(settings)->ramp > 0 ? fmin(1, time / settings_loads(settings)->ramp) : 1;
    return family_field(family, "loaded", family->node) > 0
               ? -settings_loads(settings)->stress * share / family->body.spacing
               : 0;
}

/* What the force of the node is made of, as far as this step has come. */
static void sum_forces(const Family *family, ForceSum *sum)
{
    static const char *const names[SIDES] = {"bonds to the left", "bonds up and down", "bonds to the right"};
    const Simulation *sim = family->sim;
    const int bonds = simulation_find_stage(sim, "bonds"), load = simulation_find_stage(sim, "body-force");
    const int drift = simulation_find_stage(sim, "drift");
    double sides[SIDES][2] = {{0}}, total[2] = {0, 0};
    for (int k = 0; k < family->count; k++) {
        const Ray *ray = &family->rays[k];
        for (int d = 0; d < 2; d++) {
            sides[1 + (ray->p > 0) - (ray->p < 0)][d] += ray->pull * ray->direction[d];
            total[d] += ray->pull * ray->direction[d];
        }
    }
    *sum = (ForceSum){.count = 0};
    const bool moved = sim->stage > drift && sim->stage <= bonds; /* the force is still the last step's */
    const bool just_bonds = sim->stage == bonds + 1, just_load = sim->stage == load + 1;
    for (int side = 0; side < SIDES; side++)
        add_row(sum, names[side], sides[side][0], sides[side][1], false, false);
    add_row(sum, "all its bonds", total[0], total[1], true, just_bonds);
    const double fx = family_field(family, "fx", family->node), fy = family_field(family, "fy", family->node);
    if (moved) {
        add_row(sum, "f, of the last step", fx, fy, true, false);
        return;
    }
    if (!just_bonds)
        add_row(sum, "load on the node", 0, load_on(family), false, just_load);
    add_row(sum, just_bonds ? "f, without the load" : "f of the node", fx, fy, true, just_bonds || just_load);
}

/* The terms of a sum are rounded so that a pencil finds the sum as it is printed: those that come nearest to
 * the next number take it. */
static void round_to_sum(double *terms, int count, double sum, double unit)
{
    double rounded[FORCE_ROWS_MAX], missing = sum;
    for (int i = 0; i < count; i++) {
        rounded[i] = round(terms[i] / unit) * unit;
        missing -= rounded[i];
    }
    for (int todo = (int)fmin(fabs(round(missing / unit)), count); todo > 0; todo--) {
        const double way = missing > 0 ? 1 : -1;
        int best = 0;
        for (int i = 1; i < count; i++)
            if (way * (terms[i] - rounded[i]) > way * (terms[best] - rounded[best]))
                best = i;
        rounded[best] += way * unit;
        missing -= way * unit;
    }
    memcpy(terms, rounded, (size_t)count * sizeof *terms);
}

/* The numbers that are printed, in units of 10^exponent. */
static void round_rows(ForceSum *sum, int exponent, int decimals)
{
    enum { ALL = SIDES, LOAD, F };
    const double unit = math_pow(10, -decimals);
    for (int d = 0; d < 2; d++) {
        double terms[SIDES];
        for (int i = 0; i < sum->count; i++) {
            sum->rows[i].value[d] = round(sum->rows[i].value[d] * math_pow(10, -exponent) / unit) * unit;
            if (i < SIDES)
                terms[i] = sum->exact[i][d] * math_pow(10, -exponent);
        }
        /* from the force of the node upwards */
        if (sum->count > F)
            sum->rows[ALL].value[d] = sum->rows[F].value[d] - sum->rows[LOAD].value[d];
        round_to_sum(terms, SIDES, sum->rows[ALL].value[d], unit);
        for (int i = 0; i < SIDES; i++)
            sum->rows[i].value[d] = terms[i];
    }
}

int family_forces(const Family *family, Area area)
{
    enum { DECIMALS = 5 };
    const Simulation *sim = family->sim;
    ForceSum sum;
    sum_forces(family, &sum);
    double most = 0;
    for (int i = 0; i < sum.count; i++)
        for (int d = 0; d < 2; d++)
            most = fmax(most, fabs(sum.rows[i].value[d]));
    const int exponent = most > 0 && isfinite(most) ? 3 * (int)floor(math_log10(most) / 3) : 0;
    const double size = most * math_pow(10, -exponent);
    const int decimals = DECIMALS - (size >= 10) - (size >= 100);
    round_rows(&sum, exponent, decimals);
    const int name_columns = area.rect.width < FAMILY_WORDS ? area.rect.width - 2 * FORCE_COLUMN : 20;
    area_text(area, 0, 0, "forces on it", STYLE_HEADING);
    area_text_right(area, name_columns + FORCE_COLUMN, 0, "fx", STYLE_HEADING);
    area_text_right(area, name_columns + 2 * FORCE_COLUMN, 0, "fy", STYLE_HEADING);
    int y = 1;
    for (int i = 0; i < sum.count; i++, y++) {
        const ForceRow *row = &sum.rows[i];
        const Style style = row->is_changed ? STYLE_CHANGED : row->is_sum ? STYLE_HEADING : STYLE_NORMAL;
        area_text(area, 0, y, row->name, style);
        for (int d = 0; d < 2; d++) {
            char text[48];
            snprintf(text, sizeof text, "%.*f", decimals, row->value[d] + 0.0);
            area_text_right(area, name_columns + (d + 1) * FORCE_COLUMN, y, text, style);
        }
    }
    const int next = sim->stage;
    const char *unit = area.glyphs == GLYPHS_ASCII ? "N/m^3" : "N/m³";
    char scale[24] = "";
    if (exponent != 0)
        snprintf(scale, sizeof scale, "x10^%d ", exponent);
    area_print(area, 0, y, STYLE_FAINT, "%s%s; next: %s", scale, unit,
               sim->stages[next < sim->n_stages ? next : 0].name);
    return y + 1;
}
