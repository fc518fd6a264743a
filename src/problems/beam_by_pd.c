/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams by peridynamics: settings to simulation, derived numbers, advice. */
#include "answers/beam_answers.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "problems/solver.h"
#include "methods/bonds/cracks/crack.h"
#include "base/assertion.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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
    enum { ROWS_MAX = 200 };
    BeamFacts facts;
    beam_facts(sim, &facts);
    BeamBody body = {.real = real_theory(settings, sim),
                     .predicted = NAN,
                     .damping = facts.damping,
                     .weight = settings_loads(settings)->body_force,
                     .solved = NAN,
                     .plane = NAN,
                     .rings = true};
    /* what rings through the height beside the bending; left out where the lattice is so high that it would
     * take long to find */
    const size_t rows = (size_t)facts.ny;
    double *stiffness = facts.ny <= ROWS_MAX ? malloc(rows * rows * sizeof *stiffness) : NULL;
    if (stiffness && beam_row_stiffness(sim, stiffness))
        body.n_thickness = beam_thickness_modes(stiffness, facts.ny, settings_material(settings)->density,
                                                sim->dt, body.thickness, THICKNESS_LINES_MAX);
    free(stiffness);
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
    const int cut = beam_find_cut(&plate, false), outer = beam_find_cut(&plate, true);
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

/* --- a beam or a plate as its engine wants it ------------------------------------------------------ */

static void copy_name(char to[PLATE_NAME_MAX], const Row *row)
{
    _Static_assert((int)PLATE_NAME_MAX == (int)ROW_NAME_MAX, "names go over whole");
    memcpy(to, row->name, PLATE_NAME_MAX);
}

/* Columns 0 to 3 are a rectangle; 4 and 5 velocities. */
static int take_regions(const Settings *settings, int kind, bool moved, PlateRegion out[PLATE_ROWS_MAX])
{
    const RowList *list = &settings->rows[kind];
    for (int row = 0; row < list->count; row++) {
        double value[6] = {0};
        for (int k = 0; k < (moved ? 6 : 4); k++)
            value[k] = settings_row_value(settings, kind, row, k);
        out[row] = (PlateRegion){.x0 = value[0],
                                 .y0 = value[1],
                                 .x1 = value[2],
                                 .y1 = value[3],
                                 .gives_x = list->rows[row].given >> 4 & 1,
                                 .gives_y = list->rows[row].given >> 5 & 1,
                                 .vx = value[4],
                                 .vy = value[5]};
        copy_name(out[row].name, &list->rows[row]);
    }
    return list->count;
}

/* The rows of the scenario in metres. */
static PlateDef plate_definition(const Settings *settings)
{
    static const PlateEdge edges[] = {[ROW_TOP] = PLATE_TOP,
                                      [ROW_BOTTOM] = PLATE_BOTTOM,
                                      [ROW_LEFT] = PLATE_LEFT,
                                      [ROW_RIGHT] = PLATE_RIGHT};
    const RowList *cuts = &settings->rows[ROWS_CUTS], *loads = &settings->rows[ROWS_LOADS];
    PlateDef plate = {.n_cuts = cuts->count, .n_loads = loads->count};
    double value[7];
    _Static_assert((int)PLATE_ROWS_MAX == (int)ROWS_OF_KIND_MAX, "rows go over whole");
    if (!settings_have_rows(settings, ROWS_PROBE))
        return plate;
    for (int row = 0; row < cuts->count; row++) {
        for (int k = 0; k < 4; k++)
            value[k] = settings_row_value(settings, ROWS_CUTS, row, k);
        plate.cuts[row] = (PlateCut){.x0 = value[0], .y0 = value[1], .x1 = value[2], .y1 = value[3]};
        copy_name(plate.cuts[row].name, &cuts->rows[row]);
    }
    for (int row = 0; row < loads->count; row++) {
        for (int k = 0; k < 7; k++)
            value[k] = settings_row_value(settings, ROWS_LOADS, row, k);
        plate.loads[row] = (PlateLoad){.edge = edges[(int)value[0]],
                                       .from = value[1],
                                       .to = value[2],
                                       .sx = value[3],
                                       .sy = value[4],
                                       .ramp = value[5],
                                       .until = value[6]};
        copy_name(plate.loads[row].name, &loads->rows[row]);
    }
    plate.n_supports = take_regions(settings, ROWS_SUPPORTS, true, plate.supports);
    plate.n_impulses = take_regions(settings, ROWS_IMPULSES, true, plate.impulses);
    plate.n_unbreakable = take_regions(settings, ROWS_PROTECTED, false, plate.unbreakable);
    plate.probe_x = settings_row_value(settings, ROWS_PROBE, 0, 0);
    plate.probe_y = settings_row_value(settings, ROWS_PROBE, 0, 1);
    return plate;
}

BeamDef beam_definition(const Settings *settings, int threads)
{
    ASSERT_INT(threads, >=, 1);
    const int concerns = settings->problem->concerns;
    return (BeamDef){
        .problem = concerns & CONCERN_PLATE    ? BEAM_PLATE
                   : concerns & CONCERN_MOTION ? BEAM_MOVING_CANTILEVER
                   : concerns & CONCERN_NOTCH  ? BEAM_NOTCHED
                                               : BEAM_SIMPLY_SUPPORTED,
        .length = settings_geometry(settings)->length,
        .height = settings_geometry(settings)->height,
        .thickness = settings_geometry(settings)->thickness,
        .youngs_modulus = settings_material(settings)->youngs_modulus,
        .density = settings_material(settings)->density,
        .horizon = settings_lattice(settings)->horizon,
        .spacing = settings_lattice(settings)->spacing,
        .surface_correction = settings_lattice(settings)->surface_correction,
        .volume_correction = settings_lattice(settings)->volume_correction,
        .influence = settings_lattice(settings)->influence,
        .stepping = settings_lattice(settings)->stepping,
        .critical_stretch = settings_bonds(settings)->critical_stretch,
        .protected_depth = settings_bonds(settings)->protected_depth,
        .amplitude = settings_start(settings)->amplitude,
        .speed = settings_motion(settings)->speed,
        .channel = settings_motion(settings)->channel,
        .clamp = settings_motion(settings)->clamp,
        .notch_position = settings_notch(settings)->position,
        .notch_depth = settings_notch(settings)->depth,
        .load_stress = settings_loads(settings)->stress,
        .load_ramp = settings_loads(settings)->ramp,
        .load_position = settings_loads(settings)->position,
        .load_width = settings_loads(settings)->width,
        .support_left = settings_supports(settings)->left,
        .support_right = settings_supports(settings)->right,
        .pinned = settings_supports(settings)->pinned,
        .plate = plate_definition(settings),
        .body_force = settings_loads(settings)->body_force,
        .damping =
            settings_damping(settings)->rate == DAMPING_CRITICAL ? 0 : settings_damping(settings)->rate,
        .critically_damped = settings_damping(settings)->rate == DAMPING_CRITICAL ||
                             (settings_time(settings)->rest && settings_damping(settings)->rate == 0),
        .to_rest = settings_time(settings)->rest,
        .changes_until = settings->n_changes > 0 ? settings->changes[settings->n_changes - 1].step : 0,
        .mistake = settings_lattice(settings)->mistake,
        .conceals_mistake = settings->concealed,
        .mistake_beside = settings_lattice(settings)->mistake_beside,
        .dt = settings_time(settings)->step,
        .step_is_known = settings_lattice(settings)->step_is_known,
        .end = settings_time(settings)->end,
        .threads = threads,
        .cancel = settings->cancel,
    };
}
