/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams by peridynamics: settings to simulation, derived numbers, advice. */
#include "answers/beam_answers.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "problems/solver.h"
#include "methods/bonds/plane/bonds_plane.h"
#include "methods/bonds/cracks/crack.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

/* --- settings to simulation ----------------------------------------------------------------------- */

static bool check(const Settings *settings, Status *status)
{
    const BeamDef beam = beam_definition(settings, 1);
    /* a step that is to be found is known to problem_simulate() only */
    return beam_check(&beam, status) &&
           (beam.dt == 0 || problem_check_steps(settings_time(settings)->end, beam.dt, status));
}

static Simulation *simulate(const Settings *settings, int threads, Status *status)
{
    BeamDef def = beam_definition(settings, threads);
    return beam_create(&def, status);
}

/* --- answers -------------------------------------------------------------------------------------- */

static BeamTheory real_theory(const Settings *settings, const Simulation *sim)
{
    BeamTheory real = beam_theory_of(settings);
    BeamFacts facts;
    beam_facts(sim, &facts);
    real.height = facts.real_height;
    real.length = facts.real_span;
    return real;
}

/* What rings through the height beside the bending; left out where the lattice is so high that it would take
 * long to find. */
static void find_thickness_lines(BeamBody *body, const Settings *settings, const Simulation *sim)
{
    enum { ROWS_MAX = 200 };
    BeamFacts facts;
    beam_facts(sim, &facts);
    const size_t rows = (size_t)facts.ny;
    double *stiffness = facts.ny <= ROWS_MAX ? malloc(rows * rows * sizeof *stiffness) : NULL;
    if (stiffness && beam_row_stiffness(sim, stiffness))
        body->n_thickness = beam_thickness_modes(stiffness, facts.ny, settings_material(settings)->density,
                                                 sim->dt, body->thickness, THICKNESS_LINES_MAX);
    free(stiffness);
}

/* Of the lattice as it is damped; that of critical damping oscillates no more. */
static bool predict(const Settings *settings, Prediction *out, Status *status)
{
    BeamDef def = beam_definition(settings, 1);
    def.mistake = def.mistake_beside = 0; /* it is that of the right code */
    BeamTheory theory = beam_theory_of(settings);
    out->theory = beam_damped_period(beam_period_timoshenko(&theory), def.damping);
    if (!beam_predicted_period(&def, &out->predicted, &theory.length, &theory.height, status))
        return false;
    out->predicted = def.critically_damped ? NAN : beam_damped_period(out->predicted, def.damping);
    out->real_size = beam_damped_period(beam_period_timoshenko(&theory), def.damping);
    out->real_height = theory.height;
    return true;
}

static BeamBody make_body(const Settings *settings, const Simulation *sim)
{
    BeamFacts facts;
    beam_facts(sim, &facts);
    BeamBody body = {.real = real_theory(settings, sim),
                     .predicted = NAN,
                     .damping = facts.damping,
                     .weight = settings_loads(settings)->body_force,
                     .solved = NAN,
                     .plane = NAN,
                     .rings = true};
    find_thickness_lines(&body, settings, sim);
    return body;
}

static bool prepare_supported(References *refs, const Settings *settings, const Simulation *sim,
                              Status *status)
{
    BeamLinear linear;
    BeamBody body;
    Simulation *right = NULL;
    if (settings_lattice(settings)->mistake != 0) { /* the answers are those of the right code */
        BeamDef def = beam_definition(settings, 1);
        def.mistake = def.mistake_beside = 0;
        right = beam_create(&def, status);
        if (!right)
            return false;
    }
    body = make_body(settings, right ? right : sim);
    const bool known = beam_linear(right ? right : sim, &linear, status);
    simulation_destroy(right);
    if (!known)
        return false;
    body.predicted = linear.period;
    body.solved = body.weight * linear.sag;
    return beam_prepare_supported(refs, settings, sim, &body, status);
}

static bool prepare_moving(References *refs, const Settings *settings, const Simulation *sim, Status *status)
{
    const BeamBody body = make_body(settings, sim);
    return beam_prepare_moving(refs, settings, sim, &body, status);
}

/* --- derived numbers and advice ------------------------------------------------------------------- */

static int derived(const Settings *settings, const Simulation *sim, Derived out[DERIVED_MAX])
{
    const Lattice *lattice = settings_lattice(settings);
    int n = 0;
    derived_add(out, &n, "horizon_over_spacing", "horizon/spacing", "1", lattice->horizon / lattice->spacing,
                false);
    derived_add(out, &n, "critical_stretch", "critical s0", "1", settings_bonds(settings)->critical_stretch,
                false);
    derived_add(out, &n, "critical_energy", "critical G0", "J/m^2", settings_bonds(settings)->critical_energy,
                false);
    if (settings->problem->concerns & (CONCERN_NOTCH | CONCERN_PLATE))
        derived_add(out, &n, "rayleigh_speed", "Rayleigh c_R", "m/s",
                    crack_speed_rayleigh(settings_material(settings)->youngs_modulus,
                                         settings_material(settings)->density),
                    false);
    if (sim) {
        BeamFacts facts;
        beam_facts(sim, &facts);
        derived_add(out, &n, "dt", "time step dt", "s", sim->dt, false);
        derived_add(out, &n, "dt_crit", "critical dt", "s", facts.critical_step, false);
        derived_add(out, &n, "micromodulus", "micromodulus c", "N/m^5", facts.micromodulus, false);
        derived_add(out, &n, "particles", "particles", "1", (double)facts.nx * facts.ny, true);
        derived_add(out, &n, "columns", "columns", "1", facts.nx, true);
        derived_add(out, &n, "rows", "rows", "1", facts.ny, true);
        derived_add(out, &n, "family", "family", "1", (double)facts.family, true);
        derived_add(out, &n, "bonds", "bonds", "1", (double)facts.bonds, true);
        if (settings->problem->concerns & CONCERN_NOTCH)
            derived_add(out, &n, "notch_bonds", "cut by notch", "1", (double)facts.notch_bonds, true);
        if (settings->problem->concerns & CONCERN_PLATE)
            derived_add(out, &n, "cut_bonds", "cut bonds", "1", (double)facts.notch_bonds, true);
        if (facts.damping > 0)
            derived_add(out, &n, "damping", "damping alpha", "1/s", facts.damping, false);
        derived_add(out, &n, "real_height", "real height", "m", facts.real_height, false);
        if (settings->problem->concerns & CONCERN_PLATE) {
            derived_add(out, &n, "real_length", "real length", "m", facts.nx * sim->spacing, false);
            return n;
        }
        derived_add(out, &n, "real_span", "real span", "m", facts.real_span, false);
    }
    if (beam_definition(settings, 1).problem == BEAM_SIMPLY_SUPPORTED) {
        BeamTheory theory = beam_theory_of(settings);
        derived_add_answer(out, &n, REFERENCE_FREQUENCY, "period_euler", "T Euler", "s",
                           beam_period_euler(&theory));
        derived_add_answer(out, &n, REFERENCE_FREQUENCY, "period_timoshenko", "T Timoshenko", "s",
                           beam_period_timoshenko(&theory));
        if (sim) {
            BeamTheory real = real_theory(settings, sim);
            derived_add_answer(out, &n, REFERENCE_PREDICTED, "period_real", "T real size", "s",
                               beam_period_timoshenko(&real));
        }
    }
    return n;
}

static bool advice(const Settings *settings, char *text, size_t size, Status *status)
{
    (void)status; /* the time step is checked against the critical one when the beam is made */
    double ratio = settings_lattice(settings)->horizon / settings_lattice(settings)->spacing;
    if (!(ratio >= 3 * (1 - 1e-9) && ratio <= 4 * (1 + 1e-9)))
        snprintf(text, size, "the horizon is %.3g spacings; 3 to 4 are usual", ratio);
    return true;
}

/* A cut on which nodes lie is one-sided. */
static bool advice_plate(const Settings *settings, char *text, size_t size, Status *status)
{
    const BeamDef plate = beam_definition(settings, 1);
    const int cut = beam_one_sided_cut(&plate), outer = beam_outer_cut(&plate);
    if (cut < 0 && outer < 0)
        return advice(settings, text, size, status);
    if (cut < 0) {
        snprintf(text, size, "cut %s runs along an edge and parts no bond", plate.plate.cuts[outer].name);
        return true;
    }
    snprintf(text, size, "cut %s runs along nodes, which hang on its right: shift it by half a spacing, %g m",
             plate.plate.cuts[cut].name, plate.spacing / 2);
    return true;
}

#define BEAM_KEYS                                                                                            \
    "scenario.method", "beam.length", "beam.height", "beam.thickness", "beam.youngs_modulus",                \
        "beam.density", "initial.amplitude", "pd.spacing", "pd.horizon", "pd.surface_correction",            \
        "pd.volume_correction", "pd.influence", "pd.stepping", "pd.mistake", "time.step", "time.end"

/* Theory's beam is whole: it knows nothing of bonds that break. That of the supported beam is braked, and may
 * hang. */
static const char *const of_beam[] = {BEAM_KEYS, "motion.speed", "motion.channel", "motion.clamp", NULL};
static const char *const of_supported[] = {BEAM_KEYS, "load.body_force", "damping.rate", "time.rest", NULL};

/* They are those of the right code, whatever is done instead. */
static const char *const of_changes[] = {"pd.mistake", NULL};

#define UNDERSTAND(keys)                                                                                     \
    .validity = {[REFERENCE_EXACT] = {keys, of_changes},                                                     \
                 [REFERENCE_PREDICTED] = {keys, of_changes},                                                 \
                 [REFERENCE_FREQUENCY] = {keys, of_changes}}

#define BY_PD_ALIKE .method = METHOD_PD, .check = check, .simulate = simulate, .derived = derived

const Solver beam_by_pd_supported = {
    BY_PD_ALIKE,
    .advice = advice,
    UNDERSTAND(of_supported),
    .findings = beam_find_rest,
    .predict = predict,
    .prepare = prepare_supported,
    .profile = beam_supported_profile,
    .readout = beam_read_supported,
    .thickness_lines = beam_thickness_lines,
};

const Solver beam_by_pd_moving = {
    BY_PD_ALIKE,
    .advice = advice,
    UNDERSTAND(of_beam),
    .prepare = prepare_moving,
    .readout = beam_read_moving,
    .envelope = beam_moving_envelope,
    .standing_frequency = beam_moving_frequency,
    .thickness_lines = beam_thickness_lines,
};

const Solver beam_by_pd_notched = {
    BY_PD_ALIKE,
    .advice = advice,
    .prepare = beam_prepare_notched,
    .readout = beam_read_nothing,
};

const Solver beam_by_pd_plate = {
    BY_PD_ALIKE,
    .advice = advice_plate,
    .prepare = beam_prepare_notched,
    .readout = beam_read_nothing,
};
