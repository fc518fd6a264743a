/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams by the material point method: derived numbers, the largest step, answers. */
#include "answers/beam_answers.h"
#include "scenario/concern_body.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/settings.h"
#include "problems/solver.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* The plane problem's own period belongs to ends that are held as whole sections. */
static double plane_period(const Settings *settings)
{
    const BeamTheory theory = beam_theory_of(settings);
    return settings_supports(settings)->sections == PLANE_SECTION ? beam_period_plane(&theory) : NAN;
}

static bool make_body(const Settings *settings, BeamBody *body, Status *status)
{
    const MpmDef def = mpm_right_definition(settings);
    *body = (BeamBody){.real = beam_theory_of(settings),
                       .plane = plane_period(settings),
                       .from_tip = def.cell_size / def.particles_per_cell / 2};
    return plane_predicted_period(&def, &body->predicted, status);
}

/* `theory` is the limit of ever smaller cells. */
static bool predict(const Settings *settings, Prediction *out, Status *status)
{
    BeamBody body;
    if (!make_body(settings, &body, status))
        return false;
    *out = (Prediction){body.predicted, body.plane, body.plane, settings_geometry(settings)->height};
    if (!isfinite(body.plane))
        out->theory = out->real_size = beam_period_timoshenko(&body.real);
    return true;
}

static bool prepare_supported(References *refs, const Settings *settings, const Simulation *sim,
                              Status *status)
{
    BeamBody body;
    return make_body(settings, &body, status) && beam_prepare_supported(refs, settings, sim, &body, status);
}

static bool prepare_moving(References *refs, const Settings *settings, const Simulation *sim, Status *status)
{
    BeamBody body;
    return make_body(settings, &body, status) && beam_prepare_moving(refs, settings, sim, &body, status);
}

/* --- derived numbers and advice ------------------------------------------------------------------- */

static int derived(const Settings *settings, const Simulation *sim, Derived out[DERIVED_MAX])
{
    const MpmDef def = mpm_definition(settings, 1);
    int n = 0;
    derived_add(out, &n, "dt", "time step dt", "s", mpm_time_step(&def), false);
    derived_add(out, &n, "wave_speed", "wave speed c", "m/s",
                def.courant * def.cell_size / mpm_time_step(&def), false);
    derived_add(out, &n, "cells_in_height", "cells in height", "1", round(def.height / def.cell_size), true);
    if (sim) {
        derived_add(out, &n, "particles", "particles", "1", (double)sim->counts[0], true);
        derived_add(out, &n, "columns", "columns", "1", (double)sim->columns, true);
        derived_add(out, &n, "rows", "rows", "1", (double)sim->rows, true);
        derived_add(out, &n, "nodes", "nodes", "1", (double)sim->counts[1], true);
    }
    if (!def.leaves_channel) {
        const BeamTheory theory = beam_theory_of(settings);
        derived_add_answer(out, &n, REFERENCE_FREQUENCY, "period_euler", "T Euler", "s",
                           beam_period_euler(&theory));
        derived_add_answer(out, &n, REFERENCE_FREQUENCY, "period_timoshenko", "T Timoshenko", "s",
                           beam_period_timoshenko(&theory));
        if (isfinite(plane_period(settings)))
            derived_add_answer(out, &n, REFERENCE_FREQUENCY, "period_plane", "T plane", "s",
                               plane_period(settings));
    }
    return n;
}

/* Below these Courant numbers no mesh is near its limit, which is not worked out then. */
static bool limit(const Settings *settings, char *text, size_t size, Status *status)
{
    const MpmDef def = mpm_right_definition(settings);
    double largest;
    if (def.courant < (def.algorithm == MPM_USL ? 0.6 : 1))
        return true;
    if (!plane_courant_limit(&def, &largest, status))
        return false;
    return problem_limit_courant(settings, largest, largest, text, size, status);
}

/* Hats on a mesh that stays behind: each cell that a particle enters makes its strain rate jump. */
static bool advice(const Settings *settings, char *text, size_t size, Status *status)
{
    (void)status;
    if (settings->problem->concerns & CONCERN_MOTION && settings_transfer(settings)->shape == MPM_HAT &&
        settings_mesh(settings)->velocity < settings_motion(settings)->speed)
        snprintf(text, size, "hats do not survive many crossings of cells: gimp does, or mesh.velocity = %g",
                 settings_motion(settings)->speed);
    return true;
}

static const char *damping(const Settings *settings)
{
    if (settings_transfer(settings)->flip_fraction < 1)
        return "PIC damping";
    return settings_transfer(settings)->algorithm == MPM_USL ? "USL damping" : NULL;
}

/* E* (answers/references.h): sum of m v^n v^(n+1)/2 and the strain energy that belongs to it. */
static double invariant(Simulation *sim, const Settings *settings)
{
    const size_t count = 2 * sim->counts[0];
    double *before = malloc(2 * count * sizeof *before), *after = before + count, strain[2], sum = 0;
    const bool known = before && simulation_step_ahead(sim, before, after, strain);
    for (size_t i = 0; known && i < count; i++)
        sum += before[i] * after[i];
    free(before);
    const double mass = settings_material(settings)->density * sim->spacing * sim->spacing;
    return known ? sum / 2 * mass * settings_geometry(settings)->thickness +
                       strain[settings_transfer(settings)->algorithm == MPM_USF]
                 : NAN;
}

/* A channel does work. */
static bool invariant_kept(const Settings *settings)
{
    return settings_transfer(settings)->flip_fraction == 1 && !(settings->problem->concerns & CONCERN_MOTION);
}

#define BEAM_KEYS                                                                                            \
    "scenario.method", "beam.length", "beam.height", "beam.thickness", "beam.youngs_modulus",                \
        "beam.density", "beam.poisson", "initial.amplitude", "motion.speed", "motion.channel",               \
        "motion.clamp", "mesh.cell_size", "mesh.particles_per_cell", "mesh.padding", "mesh.velocity",        \
        "mpm.algorithm", "mpm.shape", "mpm.flip_fraction", "mpm.rotation", "supports.ends",                  \
        "initial.stress", "time.courant", "time.unstable", "time.end"

/* The motion beside is that of a deflection let go, frequencies are of any start, both of the right code. */
static const char *const of_motion[] = {BEAM_KEYS, "mpm.mistake", NULL};
static const char *const of_any_start[] = {BEAM_KEYS, "initial.start", "mpm.mistake", NULL};
static const char *const of_energy[] = {BEAM_KEYS, "initial.start", NULL};
static const char *const of_mistakes[] = {"mpm.mistake", NULL};
static const char *const changes[] = {"mpm.algorithm", "mpm.flip_fraction", "mpm.mistake", NULL};
static const char *const energy_changes[] = {"mpm.algorithm", "mpm.flip_fraction", NULL};

#define ALIKE                                                                                                \
    .method = METHOD_MPM, .check = mpm_check_settings, .simulate = mpm_simulate, .derived = derived,         \
    .limit = limit, .advice = advice, .damping = damping, .invariant = invariant,                            \
    .invariant_kept = invariant_kept,                                                                        \
    .validity = {[REFERENCE_EXACT] = {of_motion, changes},                                                   \
                 [REFERENCE_PREDICTED] = {of_any_start, of_mistakes},                                        \
                 [REFERENCE_FREQUENCY] = {of_any_start, changes},                                            \
                 [REFERENCE_ENERGY] = {of_energy, energy_changes}}

/* A mesh of splines has lower modes than the beam's (plane_modes.c). */
static const char *unaccounted(const Settings *settings, Reference reference)
{
    const bool spline = settings_transfer(settings)->shape == MPM_BSPLINE2;
    return reference == REFERENCE_PREDICTED && spline ? "mpm.shape" : NULL;
}

const Solver beam_by_mpm_supported = {
    ALIKE,
    .unaccounted = unaccounted,
    .predict = predict,
    .prepare = prepare_supported,
    .profile = beam_supported_profile,
    .section = beam_supported_section,
    .readout = beam_read_supported,
};

const Solver beam_by_mpm_moving = {
    ALIKE,
    .prepare = prepare_moving,
    .section = beam_moving_section,
    .readout = beam_read_moving,
    .envelope = beam_moving_envelope,
    .standing_frequency = beam_moving_frequency,
};
