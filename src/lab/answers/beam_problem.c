/* Beams by peridynamics: settings to simulation, beam theories beside. */
#include "lab/answers/problem_rows.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- settings to simulation ----------------------------------------------------------------------- */

BeamDef beam_definition(const Settings *settings, int threads)
{
    return (BeamDef){
        .problem = problem_facts[settings->problem].beam,
        .length = settings->geometry.length,
        .height = settings->geometry.height,
        .thickness = settings->geometry.thickness,
        .youngs_modulus = settings->material.youngs_modulus,
        .density = settings->material.density,
        .horizon = settings->lattice.horizon,
        .spacing = settings->lattice.spacing,
        .surface_correction = settings->lattice.surface_correction,
        .volume_correction = settings->lattice.volume_correction,
        .critical_stretch = settings->bonds.critical_stretch,
        .protected_depth = settings->bonds.protected_depth,
        .amplitude = settings->start.amplitude,
        .speed = settings->motion.speed,
        .channel = settings->motion.channel,
        .clamp = settings->motion.clamp,
        .notch_position = settings->notch.position,
        .notch_depth = settings->notch.depth,
        .load_stress = settings->loads.stress,
        .load_ramp = settings->loads.ramp,
        .load_position = settings->loads.position,
        .load_width = settings->loads.width,
        .support_left = settings->supports.left,
        .support_right = settings->supports.right,
        .pinned = settings->supports.pinned,
        .dt = settings->time.step,
        .end = settings->time.end,
        .threads = threads,
        .go_on = settings->building.go_on,
        .go_on_context = settings->building.context,
    };
}

static Simulation *simulate(const Settings *settings, int threads, Status *status)
{
    BeamDef def = beam_definition(settings, threads);
    return beam_create(&def, status);
}

static BeamTheory theory_of(const Settings *settings)
{
    return (BeamTheory){.length = settings->geometry.length,
                        .height = settings->geometry.height,
                        .youngs_modulus = settings->material.youngs_modulus,
                        .density = settings->material.density,
                        .amplitude = settings->start.amplitude};
}

static BeamTheory real_theory_of(const Settings *settings, const Simulation *sim)
{
    BeamTheory real = theory_of(settings);
    BeamFacts facts;
    beam_facts(sim, &facts);
    real.height = facts.real_height;
    real.length = facts.real_span;
    return real;
}

/* What rings through the height beside the bending; left out where the lattice is so high that it would take
 * long to find. */
static void find_thickness_lines(BeamAnswers *beam, const Settings *settings, const Simulation *sim)
{
    enum { ROWS_MAX = 200 };
    BeamFacts facts;
    beam_facts(sim, &facts);
    const size_t rows = (size_t)facts.ny;
    double *stiffness = facts.ny <= ROWS_MAX ? malloc(rows * rows * sizeof *stiffness) : NULL;
    if (stiffness && beam_row_stiffness(sim, stiffness))
        beam->n_thickness = thickness_modes(stiffness, facts.ny, settings->material.density, sim->dt,
                                            beam->thickness, THICKNESS_LINES_MAX);
    free(stiffness);
}

static double no_profile(const References *refs, const char *field, double x, double time)
{
    (void)refs, (void)field, (void)x, (void)time;
    return NAN;
}

/* The zeros of a column: how many, the first and the last two. */
typedef struct Zeros {
    long count;
    double first, last, before;
} Zeros;

static Zeros find_zeros(const double *rows, size_t n_rows, int n_columns, int column, long most)
{
    Zeros zeros = {0, NAN, NAN, NAN};
    const size_t width = (size_t)n_columns, at = (size_t)column;
    for (size_t k = 1; k < n_rows && zeros.count < most; k++) {
        const double *a = rows + (k - 1) * width, *b = rows + k * width;
        if ((a[at] < 0) == (b[at] < 0))
            continue;
        zeros.before = zeros.last;
        zeros.last = a[1] + (b[1] - a[1]) * a[at] / (a[at] - b[at]);
        if (zeros.count++ == 0)
            zeros.first = zeros.last;
    }
    return zeros;
}

/* --- simply supported ----------------------------------------------------------------------------- */

static double u_euler(References *refs, long step, double time, const double *row)
{
    (void)step, (void)row;
    return beam_midpoint(&refs->beam.theory, refs->beam.euler, time);
}

static double v_euler(References *refs, long step, double time, const double *row)
{
    (void)step, (void)row;
    return beam_midpoint_velocity(&refs->beam.theory, refs->beam.euler, time);
}

static double u_timoshenko(References *refs, long step, double time, const double *row)
{
    (void)step, (void)row;
    return beam_midpoint(&refs->beam.theory, refs->beam.timoshenko, time);
}

static double v_timoshenko(References *refs, long step, double time, const double *row)
{
    (void)step, (void)row;
    return beam_midpoint_velocity(&refs->beam.theory, refs->beam.timoshenko, time);
}

static bool prepare_supported(References *refs, const Settings *settings, const Simulation *sim,
                              Status *status)
{
    (void)status;
    static const Quantity u_e = {"u_euler", "Euler", "m", "mid-point displacement by Euler-Bernoulli"};
    static const Quantity v_e = {"v_euler", "Euler", "m/s", "mid-point velocity by Euler-Bernoulli"};
    static const Quantity u_t = {"u_timoshenko", "Timoshenko", "m", "mid-point displacement by Timoshenko"};
    static const Quantity v_t = {"v_timoshenko", "Timoshenko", "m/s", "mid-point velocity by Timoshenko"};
    BeamAnswers *beam = &refs->beam;
    beam->theory = theory_of(settings);
    beam->real = real_theory_of(settings, sim);
    find_thickness_lines(beam, settings, sim);
    beam->euler = beam_period_euler(&beam->theory);
    beam->timoshenko = beam_period_timoshenko(&beam->theory);
    beam->timoshenko_real = beam_period_timoshenko(&beam->real);
    plan_method(refs, sim, "u_probe");
    plan_method(refs, sim, "v_probe");
    plan_answer(refs, &u_e, COLUMN_EXACT, "u_probe", u_euler);
    plan_answer(refs, &v_e, COLUMN_EXACT, "v_probe", v_euler);
    plan_answer(refs, &u_t, COLUMN_EXACT, "u_probe", u_timoshenko);
    plan_answer(refs, &v_t, COLUMN_EXACT, "v_probe", v_timoshenko);
    return true;
}

/* Timoshenko's beam keeps the sine: what a two-dimensional body should give. */
static double supported_profile(const References *refs, const char *field, double x, double time)
{
    const BeamTheory *beam = &refs->beam.theory;
    if (!(x >= 0 && x <= beam->length))
        return NAN;
    double shape = sin(M_PI * x / beam->length);
    if (strcmp(field, "uy") == 0)
        return shape * beam_midpoint(beam, refs->beam.timoshenko, time);
    if (strcmp(field, "vy") == 0)
        return shape * beam_midpoint_velocity(beam, refs->beam.timoshenko, time);
    return NAN;
}

/* Exact is Timoshenko's period of the beam as it was asked for; predicted that of the beam as it lies on the
 * lattice, a little thinner and shorter. */
static void read_supported(const References *refs, const double *rows, size_t n_rows, int n_columns,
                           Readout *out)
{
    out->is_period = true;
    out->column = "u_probe";
    out->moving = refs->beam.theory.amplitude != 0;
    if (!out->moving)
        return;
    out->exact_known = out->predicted_known = true;
    out->exact = refs->beam.timoshenko;
    out->predicted = refs->beam.timoshenko_real;
    double frequency;
    if (readout_fit(rows, n_rows, n_columns, plan_find(refs, "u_probe"), 2 * M_PI / out->predicted,
                    &(double){1}, 1, &frequency)) {
        out->measured = 2 * M_PI / frequency;
        out->measured_known = true;
    }
    const Zeros zeros = find_zeros(rows, n_rows, n_columns, plan_find(refs, "u_probe"), LONG_MAX);
    if (zeros.count > 1)
        out->by_zeros = 2 * (zeros.last - zeros.first) / (double)(zeros.count - 1);
}

/* --- axially moving cantilever -------------------------------------------------------------------- */

static double u_modal(References *refs, long step, double time, const double *row)
{
    (void)step, (void)row;
    return moving_cantilever_tip(refs->beam.moving, time);
}

static double v_modal(References *refs, long step, double time, const double *row)
{
    (void)step, (void)row;
    return moving_cantilever_tip_velocity(refs->beam.moving, time);
}

/* The straight line through the velocities of the last 0.1 ms (least squares), read at its newest end. A
 * mean over the same window would lag by half of it; the line does not, and damps the thickness modes
 * (1 MHz and more) to a hundredth all the same. The first rows stand for themselves until two are there. */
static double v_filtered(References *refs, long step, double time, const double *row)
{
    (void)step, (void)time;
    const Window *window = &refs->beam.window;
    long n = window->filled;
    if (n < 3)
        return row[refs->beam.v_probe];
    /* with k = 0 for the newest and going back: value at 0 of the line */
    double sum = 0, moment = 0;
    for (long k = 0; k < n; k++) {
        long at = window->next - 1 - k;
        double value = window->values[at < 0 ? at + window->size : at];
        sum += value;
        moment += (double)k * value;
    }
    double count = (double)n;
    return (2 * (2 * count - 1) * sum - 6 * moment) / (count * (count + 1));
}

static bool prepare_moving(References *refs, const Settings *settings, const Simulation *sim, Status *status)
{
    static const Quantity u_m = {"u_modal", "modal", "m", "tip displacement by the modal equations"};
    static const Quantity v_m = {"v_modal", "modal", "m/s", "the tip's material velocity by the same"};
    static const Quantity v_f = {"v_filtered", "filtered 0.1 ms", "m/s",
                                 "v_probe without its thickness modes: the end of the straight line "
                                 "through the last 0.1 ms"};
    const double window = 1e-4;
    BeamAnswers *beam = &refs->beam;
    beam->theory = theory_of(settings);
    /* the last step may lie beyond the end by almost a step */
    double end = (double)problem_last_step(sim->dt, settings->time.end) * sim->dt;
    beam->moving = moving_cantilever_solve(&beam->theory, settings->motion.speed, fmax(end, sim->dt), status);
    if (!beam->moving)
        return false;
    beam->speed = settings->motion.speed;
    find_thickness_lines(beam, settings, sim);
    beam->v_probe = simulation_find_series(sim, "v_probe");
    beam->window.size = lround(window / sim->dt) + 1;
    if (beam->window.size > 1000000)
        beam->window.size = 1000000;
    beam->window.values = malloc((size_t)beam->window.size * sizeof *beam->window.values);
    if (!beam->window.values)
        return status_fail(status, STATUS_FAILED, "not enough memory to filter the velocity");
    plan_method(refs, sim, "u_probe");
    plan_method(refs, sim, "v_probe");
    plan_method(refs, sim, "length");
    plan_answer(refs, &u_m, COLUMN_EXACT, "u_probe", u_modal);
    plan_answer(refs, &v_m, COLUMN_EXACT, "v_probe", v_modal);
    plan_filter(refs, &v_f, "v_probe", v_filtered);
    return true;
}

/* The period grows with the length, so the time between the last two zeros is told (twice, for a whole
 * period), against that between the same zeros of the modal solution. */
static void read_moving(const References *refs, const double *rows, size_t n_rows, int n_columns,
                        Readout *out)
{
    out->is_period = true;
    out->drifting = true;
    out->column = "u_probe";
    out->moving = refs->beam.theory.amplitude != 0;
    if (!out->moving)
        return;
    int u = plan_find(refs, "u_probe"), modal = plan_find(refs, "u_modal");
    Zeros measured = find_zeros(rows, n_rows, n_columns, u, LONG_MAX);
    Zeros exact = find_zeros(rows, n_rows, n_columns, modal, LONG_MAX);
    long both = measured.count < exact.count ? measured.count : exact.count;
    if (both < 2)
        return;
    if (measured.count > both)
        measured = find_zeros(rows, n_rows, n_columns, u, both);
    if (exact.count > both)
        exact = find_zeros(rows, n_rows, n_columns, modal, both);
    out->measured_known = out->exact_known = true;
    out->measured = 2 * (measured.last - measured.before);
    out->exact = 2 * (exact.last - exact.before);
    out->late = (measured.last - exact.last) / out->exact;
}

/* --- notched -------------------------------------------------------------------------------------- */

static bool prepare_notched(References *refs, const Settings *settings, const Simulation *sim, Status *status)
{
    (void)settings, (void)status;
    plan_method(refs, sim, "u_probe");
    plan_method(refs, sim, "v_probe");
    return true;
}

static void read_nothing(const References *refs, const double *rows, size_t n_rows, int n_columns,
                         Readout *out)
{
    (void)refs, (void)rows, (void)n_rows, (void)n_columns;
    out->is_period = true;
    out->column = "u_probe";
}

/* --- derived numbers and advice ------------------------------------------------------------------- */

static int derived(const Settings *settings, const Simulation *sim, Derived out[DERIVED_MAX])
{
    const Lattice *lattice = &settings->lattice;
    int n = 0;
    derived_add(out, &n, "horizon_over_spacing", "horizon/spacing", "1", lattice->horizon / lattice->spacing,
                false);
    double stretch = settings->bonds.critical_stretch;
    derived_add(out, &n, "critical_stretch", "critical s0", "1", stretch, false);
    derived_add(out, &n, "critical_energy", "critical G0", "J/m^2",
                stretch * stretch * 9 * settings->material.youngs_modulus * lattice->horizon / (4 * M_PI),
                false);
    if (sim) {
        BeamFacts facts;
        beam_facts(sim, &facts);
        derived_add(out, &n, "dt", "time step dt", "s", sim->dt, false);
        derived_add(out, &n, "dt_crit", "critical dt", "s", facts.critical_step, false);
        derived_add(out, &n, "micromodulus", "micromodulus c", "N/m^6", facts.micromodulus, false);
        derived_add(out, &n, "particles", "particles", "1", (double)facts.nx * facts.ny, true);
        derived_add(out, &n, "columns", "columns", "1", facts.nx, true);
        derived_add(out, &n, "rows", "rows", "1", facts.ny, true);
        derived_add(out, &n, "family", "family", "1", (double)facts.family, true);
        derived_add(out, &n, "bonds", "bonds", "1", (double)facts.bonds, true);
        if (settings->problem == PROBLEM_NOTCHED_BEAM)
            derived_add(out, &n, "notch_bonds", "cut by notch", "1", (double)facts.notch_bonds, true);
        derived_add(out, &n, "real_height", "real height", "m", facts.real_height, false);
        derived_add(out, &n, "real_span", "real span", "m", facts.real_span, false);
    }
    if (settings->problem == PROBLEM_SUPPORTED_BEAM) {
        BeamTheory theory = theory_of(settings);
        derived_add(out, &n, "period_euler", "T Euler", "s", beam_period_euler(&theory), false);
        derived_add(out, &n, "period_timoshenko", "T Timoshenko", "s", beam_period_timoshenko(&theory),
                    false);
        if (sim) {
            BeamTheory real = real_theory_of(settings, sim);
            derived_add(out, &n, "period_real", "T real size", "s", beam_period_timoshenko(&real), false);
        }
    }
    return n;
}

static bool advice(const Settings *settings, char *text, size_t size, Status *status)
{
    (void)status; /* the time step is checked against the critical one when the beam is made */
    double ratio = settings->lattice.horizon / settings->lattice.spacing;
    if (!(ratio >= 3 * (1 - 1e-9) && ratio <= 4 * (1 + 1e-9)))
        snprintf(text, size, "the horizon is %.3g spacings; 3 to 4 are usual", ratio);
    return true;
}

const ProblemRow supported_pd_row = {
    .problem = PROBLEM_SUPPORTED_BEAM,
    .method = METHOD_PD,
    .simulate = simulate,
    .prepare = prepare_supported,
    .profile = supported_profile,
    .readout = read_supported,
    .derived = derived,
    .advice = advice,
};

const ProblemRow moving_pd_row = {
    .problem = PROBLEM_MOVING_CANTILEVER,
    .method = METHOD_PD,
    .simulate = simulate,
    .prepare = prepare_moving,
    .profile = no_profile,
    .readout = read_moving,
    .derived = derived,
    .advice = advice,
};

const ProblemRow notched_pd_row = {
    .problem = PROBLEM_NOTCHED_BEAM,
    .method = METHOD_PD,
    .simulate = simulate,
    .prepare = prepare_notched,
    .profile = no_profile,
    .readout = read_nothing,
    .derived = derived,
    .advice = advice,
};
