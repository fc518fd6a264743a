/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One particle in one cell: the smallest bar, with its exact motion at any amplitude. The engine is that of
 * the bar; the problem has of its parameters what one particle needs. */
#include "answers/bar_answers.h"
#include "scenario/concern_body.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/settings.h"
#include "problems/solver.h"
#include "theory/large_strain.h"
#include "base/math/functions.h"

#include <math.h>
#include <string.h>

/* As a bar of one cell, whose left end is held. */
static Settings as_bar(const Settings *settings)
{
    Settings bar = *settings;
    settings_edit_geometry(&bar)->length = settings_mesh(settings)->cell_size;
    settings_edit_supports(&bar)->ends = BAR_FIXED_FREE;
    settings_edit_start(&bar)->mode = 1;
    return bar;
}

static double wave_speed(const Settings *settings)
{
    return sqrt(settings_material(settings)->youngs_modulus / settings_material(settings)->density);
}

static bool check(const Settings *settings, Status *status)
{
    const Settings bar = as_bar(settings);
    if (settings_mesh(settings)->particles_per_cell != 1)
        return status_refuse(status, "mesh.particles_per_cell: %d is not allowed (1: there is one particle)",
                             settings_mesh(settings)->particles_per_cell);
    return mpm_check_settings(&bar, status);
}

static double start(double x, const void *settings)
{
    (void)x;
    return settings_start(((const Settings *)settings))->velocity;
}

static Simulation *simulate(const Settings *settings, int threads, Status *status)
{
    const Settings bar = as_bar(settings);
    MpmDef def = mpm_definition(&bar, threads);
    def.initial_velocity = start;
    def.initial_context = settings;
    return mpm_create(&def, status);
}

static double exact_v_cm(References *refs, long step, double time, const double *row)
{
    double strain, velocity;
    (void)step, (void)row;
    oscillator_at(refs->own, time, &strain, &velocity);
    return velocity;
}

static double exact_x_cm(References *refs, long step, double time, const double *row)
{
    double strain, velocity;
    (void)step, (void)row;
    oscillator_at(refs->own, time, &strain, &velocity);
    return ((const Oscillator *)refs->own)->cell / 2 * math_exp(strain);
}

static bool prepare(References *refs, const Settings *settings, const Simulation *sim, Status *status)
{
    static const Quantity v = {"v_cm_exact", "exact", "length/time", "velocity of the particle, exact"};
    static const Quantity x = {"x_cm_exact", "exact", "length", "place of the particle, exact"};
    Oscillator *oscillator = plan_own(refs, sizeof *oscillator, NULL, status);
    if (!oscillator)
        return false;
    oscillator_make(oscillator, settings_mesh(settings)->cell_size, wave_speed(settings),
                    settings_start(settings)->velocity);
    plan_method(refs, sim, "v_cm");
    plan_answer(refs, &v, COLUMN_EXACT, "v_cm", exact_v_cm);
    plan_method(refs, sim, "x_cm");
    plan_answer(refs, &x, COLUMN_EXACT, "x_cm", exact_x_cm);
    return true;
}

/* The cell has the one particle's strain, and moves with it in the middle. */
static double profile(const References *refs, const char *field, double x, double time)
{
    const Oscillator *oscillator = refs->own;
    double strain, velocity;
    oscillator_at(oscillator, time, &strain, &velocity);
    const double u = oscillator->cell / 2 * math_expm1(strain);
    return strcmp(field, "u") == 0        ? u
           : strcmp(field, "x") == 0      ? x + u
           : strcmp(field, "v") == 0      ? velocity
           : strcmp(field, "strain") == 0 ? strain
                                          : NAN;
}

static void read_out(const References *refs, const double *rows, size_t n_rows, int n_columns, Readout *out)
{
    enum { HARMONICS = 5 };
    static const double ratios[HARMONICS] = {1, 2, 3, 4, 5};
    const Oscillator *oscillator = refs->own;
    out->column = "v_cm";
    out->moving = oscillator->velocity != 0;
    if (!out->moving)
        return;
    out->exact_known = true;
    out->exact = 2 * M_PI / oscillator->period;
    readout_fit(rows, n_rows, n_columns, plan_find(refs, "v_cm"), out->exact, ratios, HARMONICS, out);
}

/* What the motion keeps, as a share of what it was. Velocity and stress of one time are half a step apart and
 * would make it ripple, so v^2 is the product of the velocities before and after the present stress acts. */
static int findings(const References *refs, const Simulation *sim, Finding *out)
{
    const Oscillator *oscillator = refs->own;
    const double strain = simulation_named(sim, 0, "strain", 0), velocity = simulation_named(sim, 0, "v", 0);
    if (oscillator->velocity == 0)
        return 0;
    const double change = -sim->dt * simulation_named(sim, 0, "stress", 0) /
                          (simulation_named(sim, 0, "density", 0) * oscillator->cell);
    const bool has_acted = simulation_find_stage(sim, "strain") < simulation_find_stage(sim, "force");
    out[0] = (Finding){
        "invariant",
        "invariant/start",
        (oscillator_energy(oscillator, strain, velocity) + velocity * (has_acted ? -change : change) / 2) /
            oscillator_energy(oscillator, 0, oscillator->velocity),
        1,
        NULL,
        NULL};
    return 1;
}

static int derived(const Settings *settings, const Simulation *sim, Derived out[DERIVED_MAX])
{
    Oscillator oscillator;
    int n = 0;
    const double c = wave_speed(settings), dt = sim ? sim->dt : bar_time_step(settings);
    const bool known = oscillator_make(&oscillator, settings_mesh(settings)->cell_size, c,
                                       settings_start(settings)->velocity);
    bar_derived_step(out, &n, c, dt);
    derived_add(out, &n, "period_small", "period, small", "time",
                2 * M_PI * settings_mesh(settings)->cell_size / c, false);
    if (known) {
        derived_add_answer(out, &n, REFERENCE_EXACT, "period", "period", "time", oscillator.period);
        derived_add_answer(out, &n, REFERENCE_EXACT, "steps_per_period", "steps/period", "1",
                           oscillator.period / dt);
    }
    return n;
}

static bool limit(const Settings *settings, char *text, size_t size, Status *status)
{
    const Settings bar = as_bar(settings);
    return bar_limit(&bar, text, size, status);
}

/* Faster than waves its motion is not worked out. */
static const char *unaccounted(const Settings *settings, Reference reference)
{
    (void)reference;
    return fabs(settings_start(settings)->velocity) <= wave_speed(settings) ? NULL : "initial.velocity";
}

/* The equations are those of hats and of what nothing filters. */
static const char *const of_motion[] = {
    "bar.youngs_modulus", "bar.density",    "initial.velocity", "mesh.particles_per_cell",
    "mesh.padding",       "mesh.cell_size", "mpm.algorithm",    "time.courant",
    "time.unstable",      "time.end",       "mpm.affine_start", NULL};

static const Solver one_particle_by_mpm = {
    .method = METHOD_MPM,
    .validity = {[REFERENCE_EXACT] = {of_motion, NULL}, [REFERENCE_FREQUENCY] = {of_motion, NULL}},
    .unaccounted = unaccounted,
    .check = check,
    .simulate = simulate,
    .limit = limit,
    .derived = derived,
    .prepare = prepare,
    .profile = profile,
    .readout = read_out,
    .findings = findings,
};

static const ParameterUse uses[] = {
    {USE("bar.youngs_modulus", 100)},
    {USE("bar.density", 1)},
    {USE("initial.velocity", 1), .help = "velocity of the particle at t = 0"},
    {USE("mesh.cell_size", 1), .help = "size dx of the cell; the particle starts in its middle"},
    {USE("mesh.particles_per_cell", 1), .help = "one, or it is a bar"},
    {USE("mesh.padding", 4)},
    {USE("time.courant", 0.1)},
    {USE("time.end", 20)},
};

const Problem problem_one_particle = {
    .word = "one-particle",
    .body = "particle",
    .title = "one particle in one cell",
    .about = "late",
    .concerns = CONCERN_POINT | CONCERN_MESH,
    USES(uses),
    SOLVED_BY(&one_particle_by_mpm),
    IN_OWN_UNITS,
};
