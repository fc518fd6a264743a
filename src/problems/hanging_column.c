/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A bar that hangs: gravity from t = 0 on, damping by the transfer until it is at rest, and beside it the
 * exact state of rest at any strain. The engine is that of the bar. */
#include "answers/bar_answers.h"
#include "scenario/concern_body.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "problems/solver.h"
#include "theory/large_strain.h"
#include "base/math/functions.h"

#include <math.h>
#include <string.h>

static HangingColumn column_of(const Settings *settings)
{
    return (HangingColumn){.length = settings_geometry(settings)->length,
                           .youngs_modulus = settings_material(settings)->youngs_modulus,
                           .density = settings_material(settings)->density,
                           .body_force = settings_loads(settings)->body_force};
}

ANSWER(exact_x_cm, hanging_column_centre(refs->own))

static bool prepare(References *refs, const Settings *settings, const Simulation *sim, Status *status)
{
    static const Quantity x = {"x_cm_exact", "exact", "length", "centre of mass of the bar at rest, exact"};
    HangingColumn *column = plan_own(refs, sizeof *column, NULL, status);
    if (!column)
        return false;
    *column = column_of(settings);
    plan_method(refs, sim, "x_cm");
    plan_answer(refs, &x, COLUMN_EXACT, "x_cm", exact_x_cm);
    return true;
}

static double profile(const References *refs, const char *field, double x, double time)
{
    const HangingColumn *column = refs->own;
    (void)time;
    if (!(x >= 0 && x <= column->length))
        return NAN;
    const double u = hanging_column_displacement(column, x), stress = hanging_column_stress(column, x);
    const double strain = stress / column->youngs_modulus;
    return strcmp(field, "u") == 0         ? u
           : strcmp(field, "x") == 0       ? x + u
           : strcmp(field, "v") == 0       ? 0
           : strcmp(field, "stress") == 0  ? stress
           : strcmp(field, "strain") == 0  ? strain
           : strcmp(field, "density") == 0 ? column->density * math_exp(-strain)
                                           : NAN;
}

static void read_out(const References *refs, const double *rows, size_t n_rows, int n_columns, Readout *out)
{
    (void)refs, (void)rows, (void)n_rows, (void)n_columns;
    out->column = "x_cm"; /* which comes to rest: there is no frequency */
}

static int findings(const References *refs, const Simulation *sim, Finding *out)
{
    const HangingColumn *column = refs->own;
    const size_t last = sim->counts[0] - 1;
    out[0] = (Finding){.name = "u_last",
                       .label = "last particle's u",
                       .measured = simulation_named(sim, 0, "u", last),
                       .exact = hanging_column_displacement(column, simulation_named(sim, 0, "x0", last))};
    out[1] = (Finding){.name = "stress_first",
                       .label = "first particle's stress",
                       .measured = simulation_named(sim, 0, "stress", 0),
                       .exact = hanging_column_stress(column, simulation_named(sim, 0, "x0", 0))};
    return 2;
}

static int derived(const Settings *settings, const Simulation *sim, Derived out[DERIVED_MAX])
{
    const HangingColumn column = column_of(settings);
    const double cells = round(column.length / settings_mesh(settings)->cell_size),
                 count = settings_mesh(settings)->particles_per_cell;
    const double last = column.length - settings_mesh(settings)->cell_size / count / 2;
    int n = 0;
    bar_derived_step(out, &n, sqrt(column.youngs_modulus / column.density),
                     sim ? sim->dt : bar_time_step(settings));
    derived_add(out, &n, "cells", "cells", "1", cells, true);
    derived_add(out, &n, "particles", "particles", "1", cells * count, true);
    derived_add_answer(
        out, &n, REFERENCE_EXACT, "stress_support", "support bears", "force/area",
        hanging_column_stress(&column, 0)); /* rho b L; the first particle stands a little below */
    derived_add_answer(out, &n, REFERENCE_EXACT, "strain_largest", "largest strain", "1",
                       hanging_column_stress(&column, 0) / column.youngs_modulus);
    derived_add_answer(out, &n, REFERENCE_EXACT, "u_last", "last u, exact", "length",
                       hanging_column_displacement(&column, last));
    derived_add_answer(out, &n, REFERENCE_EXACT, "u_last_linear", "  for small strain", "length",
                       hanging_column_linear(&column, last));
    return n;
}

/* Rest does not know by what way it was come to. */
static const char *const of_rest[] = {BAR_KEYS, BAR_MESH_KEYS, BAR_TRANSFER_KEYS, NULL};
static const char *const changes[] = {"mpm.algorithm", "mpm.transfer", "mpm.flip_fraction", NULL};

static const Solver hanging_column_by_mpm = {
    .method = METHOD_MPM,
    .validity = {[REFERENCE_EXACT] = {of_rest, changes}},
    .check = mpm_check_settings,
    .simulate = mpm_simulate,
    .limit = bar_limit,
    .derived = derived,
    .prepare = prepare,
    .profile = profile,
    .readout = read_out,
    .findings = findings,
};

static const ParameterUse uses[] = {
    {USE("bar.length", 25)},
    {USE("bar.youngs_modulus", 100)},
    {USE("bar.density", 1)},
    {USE("bar.supports", BAR_FIXED_FREE), .choices = 1, .others = "is for bars that vibrate"},
    {USE("mesh.cell_size", 1)},
    {USE("mesh.particles_per_cell", 2)},
    {USE("mesh.padding", 40)},
    {USE("mpm.shape", MPM_GIMP)},
    {USE("mpm.flip_fraction", 0)},
    {USE("load.body_force", 0.1)},
    {USE("time.courant", 0.1)},
    {USE("time.end", 300)},
};

const Problem problem_hanging_column = {
    .word = "hanging-column",
    .body = "column",
    .title = "a bar that hangs at rest",
    .about = "late",
    .concerns = CONCERN_BAR | CONCERN_MESH | CONCERN_WEIGHT,
    USES(uses),
    SOLVED_BY(&hanging_column_by_mpm),
    IN_OWN_UNITS,
};
