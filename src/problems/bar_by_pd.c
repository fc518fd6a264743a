/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bar by peridynamics: settings to simulation, exact and predicted answers beside. */
#include "answers/bar_answers.h"
#include "base/math/functions.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "problems/solver.h"
#include "theory/pd_waves.h"

#include <math.h>
#include <stdio.h>

BeamDef bar_pd_definition(const Settings *settings)
{
    const BarSupports ends = settings_supports(settings)->ends;
    return (BeamDef){
        .problem = BEAM_BAR,
        .length = settings_geometry(settings)->length,
        .youngs_modulus = settings_material(settings)->youngs_modulus,
        .density = settings_material(settings)->density,
        .left_fixed = ends == BAR_FIXED_FREE || ends == BAR_FIXED_FIXED,
        .right_fixed = ends == BAR_FREE_FIXED || ends == BAR_FIXED_FIXED,
        .spacing = lattice_spacing(settings),
        .horizon = lattice_horizon(settings),
        .surface_correction = settings_lattice(settings)->surface_correction,
        .volume_correction = settings_lattice(settings)->volume_correction,
        .influence = settings_lattice(settings)->influence,
        .body_force = settings_loads(settings)->body_force,
        .traction = settings_loads(settings)->traction,
        .traction_layer = settings_loads(settings)->traction_layer,
        .dt = bar_time_step(settings),
        .stepping = settings_lattice(settings)->stepping,
        .mistake = settings_lattice(settings)->mistake,
        .mistake_beside = settings_lattice(settings)->mistake_beside,
        .conceals_mistake = settings->concealed,
        .cancel = settings->cancel,
    };
}

/* Of a right code, without loads. Codes that kick once a step have the frequencies of velocity Verlet. */
static BeamDef right_definition(const Settings *settings)
{
    BeamDef def = bar_pd_definition(settings);
    def.mistake = def.mistake_beside = 0;
    def.body_force = def.traction = 0;
    def.stepping = STEPPING_VERLET;
    def.cancel = (Cancel){0}; /* the steps ask */
    return def;
}

static bool check(const Settings *settings, Status *status)
{
    /* the mesh is checked too: the nodes lie where its particles would, and its cells make the time step */
    MpmDef mesh = mpm_definition(settings, 1);
    mesh.mistake_beside = 0; /* it is one of bonds */
    const BeamDef def = bar_pd_definition(settings);
    return mpm_check(&mesh, status) && beam_check(&def, status) &&
           bar_check_modes(settings, round(def.length / def.spacing), status) &&
           problem_check_steps(settings_time(settings)->end, def.dt, status);
}

static Simulation *create(BeamDef def, const BarTheory *theory, Status *status)
{
    def.initial_velocity = bar_start;
    def.initial_context = theory;
    return beam_create(&def, status);
}

static Simulation *simulate(const Settings *settings, int threads, Status *status)
{
    (void)threads; /* a bar is too small to be shared */
    BarTheory theory;
    return bar_theory_of(settings, &theory, status) ? create(bar_pd_definition(settings), &theory, status)
                                                    : NULL;
}

/* --- what the step predicts ----------------------------------------------------------------------- */

static Simulation *start_of(const Settings *settings, const BarTheory *theory)
{
    return create(right_definition(settings), theory, NULL);
}

/* On an endless lattice, by bonds of one shape. Velocity Verlet turns u'' = -omega^2 u into sin(Omega dt/2) =
 * omega dt/2. A wave shorter than two spacings is a longer one to the nodes. */
static Dispersion wave_by(const Settings *settings, Influence shape, double wave_number)
{
    BeamDef def = right_definition(settings);
    Dispersion wave = {.space_only = NAN, .frequency = NAN, .filter = 1};
    def.influence = shape;
    if (!(fabs(wave_number) * def.spacing <= M_PI * (1 + 1e-12)))
        return wave;
    wave.space_only = bonds_line_wave(&def, wave_number);
    const double half = wave.space_only * def.dt / 2;
    wave.known = half <= 1;
    if (wave.known)
        wave.frequency = 2 * math_asin(half) / def.dt;
    return wave;
}

static Dispersion wave_on_lattice(const Settings *settings, const BarTheory *theory, double wave_number)
{
    (void)theory;
    return wave_by(settings, settings_lattice(settings)->influence, wave_number);
}

static double predicted_frequency(const Settings *settings, const BarTheory *theory, int number)
{
    const BarStep step = {start_of, wave_on_lattice, lattice_spacing(settings), 2000};
    const StepMode mode = bar_step_mode(&step, settings, theory, number);
    return mode.known ? mode.frequency : NAN;
}

static bool prepare(References *refs, const Settings *settings, const Simulation *sim, Status *status)
{
    BarAnswers *bar = bar_answers_create(refs, settings, status);
    if (!bar)
        return false;
    const BeamDef lattice = bar_pd_definition(settings);
    const int before = shortage_begin();
    /* with one kick a step v is half a step off, and the frequency the same */
    const bool whole = !refs->unaccounted[REFERENCE_PREDICTED] && lattice.body_force == 0 &&
                       lattice.traction == 0 && lattice.stepping == STEPPING_VERLET &&
                       bar_find_motion(bar, settings, start_of);
    bar_prepare(refs, settings, sim, predicted_frequency, whole,
                "velocity of the centre of mass predicted for this lattice");
    return bar_prediction_is_whole(before, round(lattice.length / lattice.spacing), "nodes", status);
}

static int derived(const Settings *settings, const Simulation *sim, Derived out[DERIVED_MAX])
{
    const double dt = sim ? sim->dt : bar_time_step(settings), spacing = lattice_spacing(settings);
    const double nodes = round(settings_geometry(settings)->length / spacing);
    int n = 0;
    BarTheory theory;
    if (!bar_theory_of(settings, &theory, NULL))
        return 0;
    const int before = shortage_begin();
    bar_derived_step(out, &n, bar_wave_speed(&theory), dt);
    bar_derived_wave(out, &n, settings, &theory, predicted_frequency, dt);
    shortage_end(before);
    derived_add(out, &n, "particles", "particles", "1", nodes, true);
    derived_add(out, &n, "lattice_spacing", "spacing h", "length", spacing, false);
    derived_add(out, &n, "lattice_horizon", "horizon delta", "length", lattice_horizon(settings), false);
    if (!sim)
        return n;
    BeamFacts facts;
    beam_facts(sim, &facts);
    derived_add(out, &n, "family", "bonds of a node", "1", (double)facts.family, true);
    derived_add(out, &n, "micromodulus", "micromodulus c", "force/length^4", facts.micromodulus, false);
    derived_add(out, &n, "modulus_of_bonds", "E of the bonds", "force/area", facts.modulus, false);
    derived_add(out, &n, "end_factor", "g at a free end", "1", facts.end_factor, false);
    derived_add(out, &n, "dt_crit", "critical dt", "time", facts.critical_step, false);
    derived_add(out, &n, "largest_courant", "courant limit", "1",
                settings_time(settings)->courant * facts.critical_step / dt, false);
    return n;
}

static bool limit(const Settings *settings, char *text, size_t size, Status *status)
{
    const BeamDef def = bar_pd_definition(settings);
    const double courant = settings_time(settings)->courant;
    double critical;
    if (!bonds_line_critical_step(&def, &critical, status))
        return false;
    if (def.dt > critical)
        return status_refuse(status,
                             "time.courant: the time step %.6g is above the critical one, %.6g (courant at "
                             "most %.5g)",
                             def.dt, critical, courant * critical / def.dt);
    if (def.dt > 0.95 * critical)
        snprintf(text, size, "time step %.4g is near the critical one, %.5g", def.dt, critical);
    return true;
}

/* --- every mode on the lattice -------------------------------------------------------------------- */

static int modes(const Settings *settings)
{
    return bar_modes_of(round(settings_geometry(settings)->length / lattice_spacing(settings)));
}

static void lattice_factors(const Dispersion *wave, ModeOnMesh *mode)
{
    mode->factors[0] =
        (ModeFactor){"lattice", "each node bonded to all within the horizon", wave->space_only / mode->exact};
    mode->factors[1] = (ModeFactor){"dt", NULL, wave->frequency / wave->space_only};
    mode->n_factors = 2;
}

static bool mode(const Settings *settings, int number, ModeOnMesh *out)
{
    return bar_mode(settings, number, wave_on_lattice, lattice_factors, out);
}

/* Answers are those of the right code; v is half a step off where there is one kick a step. */
static const char *const of_continuum[] = {BAR_KEYS,     BAR_MESH_KEYS, BAR_LATTICE_KEYS,
                                           "pd.mistake", "pd.stepping", NULL};
static const char *const changes[] = {"pd.mistake", NULL};
static const char *const load_changes[] = {"load.body_force", "load.traction", "pd.mistake",
                                           NULL}; /* no frequency */

/* Both shapes of the micromodulus on this lattice, and the integrals that they stand for. */
static const char *other_way(const Settings *settings, int which, int number, double *frequency)
{
    static const char *const names[] = {"constant", "conical", "its integral", "its integral"};
    BarTheory theory;
    if (which >= (int)(sizeof names / sizeof *names) || !bar_theory_of(settings, &theory, NULL))
        return NULL;
    const double wave = bar_wave_number(&theory, number);
    const Influence shape = which % 2 ? INFLUENCE_CONICAL : INFLUENCE_CONSTANT;
    *frequency = which < 2 ? wave_by(settings, shape, wave).frequency
                           : wave * bar_wave_speed(&theory) *
                                 sqrt(pd_waves_line(shape, wave * lattice_horizon(settings)));
    return names[which];
}

const Solver bar_by_pd = {
    .method = METHOD_PD,
    .validity = {[REFERENCE_EXACT] = {of_continuum, changes},
                 [REFERENCE_PREDICTED] = {of_continuum, changes},
                 [REFERENCE_FREQUENCY] = {of_continuum, load_changes}},
    .check = check,
    .simulate = simulate,
    .limit = limit,
    .derived = derived,
    .prepare = prepare,
    .profile = bar_profile,
    .readout = bar_read_out,
    .modes = modes,
    .mode = mode,
    .other_way = other_way,
};
