/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Answers for the bar that both methods share: its theory, which column shows its frequency, exact answers
 * beside the run. */
#include "answers/bar_answers.h"
#include "theory/bar_waves.h"

#include "base/cancel.h"
#include "base/assertion.h"
#include "scenario/parameters.h"
#include "methods/method.h"
#include "scenario/concern_body.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "theory/oscillation.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

_Static_assert(OVERTONES_MAX + 1 <= BAR_MODES_MAX, "the theory has room for every overtone");

/* --- settings to theory --------------------------------------------------------------------------- */

bool bar_theory_of(const Settings *settings, BarTheory *theory, Status *status)
{
    static const double to_left[] = {[PULSE_RIGHT] = 0, [PULSE_LEFT] = 1, [PULSE_BOTH] = 0.5};
    const BarSupports ends = settings_supports(settings)->ends;
    *theory = (BarTheory){
        .length = settings_geometry(settings)->length,
        .youngs_modulus = settings_material(settings)->youngs_modulus,
        .density = settings_material(settings)->density,
        .left_fixed = ends == BAR_FIXED_FREE || ends == BAR_FIXED_FIXED,
        .right_fixed = ends == BAR_FREE_FIXED || ends == BAR_FIXED_FIXED,
        .body_force = settings_loads(settings)->body_force,
        .traction = settings_loads(settings)->traction,
    };
    if (settings->method == METHOD_MPM) { /* the others have no such parameters */
        Pulse pulse;
        if (!pulse_read(settings_start(settings)->pulse, &pulse, status))
            return false;
        theory->pulse.centre = pulse.centre;
        theory->pulse.width = pulse.width;
        theory->pulse.velocity = pulse.velocity;
        theory->pulse.to_left = to_left[settings_start(settings)->pulse_way];
        theory->joint = settings_joint(settings)->place;
        theory->joint_modulus = settings_joint(settings)->beyond.youngs_modulus;
        theory->joint_density = settings_joint(settings)->beyond.density;
        theory->of_sines = settings_start(settings)->shape == SHAPE_SINE && bar_is_layered(theory);
    }
    theory->modes[0].number = settings_start(settings)->mode;
    theory->modes[0].velocity = settings_start(settings)->velocity;
    Overtone overtones[OVERTONES_MAX];
    int count = overtones_read(settings_start(settings)->overtones, overtones, status);
    if (count < 0)
        return false;
    for (int i = 0; i < count; i++) {
        theory->modes[1 + i].number = overtones[i].mode;
        theory->modes[1 + i].velocity = overtones[i].velocity;
    }
    theory->n_modes = 1 + count;
    return true;
}

/* dt = courant dx/c, c = sqrt(E/rho) of the faster part where the bar has two; lattices take the same step,
 * so that a duel compares like with like. */
double bar_time_step(const Settings *settings)
{
    const Material *material = settings_material(settings), *beyond = &settings_joint(settings)->beyond;
    double speed = sqrt(material->youngs_modulus / material->density);
    if (settings->method == METHOD_MPM && settings_joint(settings)->place > 0)
        speed = fmax(speed, sqrt(beyond->youngs_modulus / beyond->density));
    return settings_time(settings)->courant * settings_mesh(settings)->cell_size / speed;
}

double bar_start(double x, const void *theory)
{
    return bar_waves_start_velocity(theory, x);
}

double bar_start_slope(double x, const void *theory)
{
    return bar_waves_start_slope(theory, x);
}

double bar_start_stress(double x, const void *theory)
{
    return bar_waves_start_stress(theory, x);
}

/* --- does it make sense? -------------------------------------------------------------------------- */

bool bar_check_modes(const Settings *settings, double particles, Status *status)
{
    if (settings_start(settings)->mode == 0 && settings_start(settings)->velocity != 0 &&
        settings_supports(settings)->ends != BAR_FREE_FREE)
        return status_refuse(status,
                             "initial.mode: 0 is rigid motion, which a held bar has not (1 or more, or "
                             "bar.supports = free-free)");
    if (settings_start(settings)->mode > particles)
        return status_refuse(
            status, "initial.mode: %d is finer than the particles can show (at most %.0f, their number)",
            settings_start(settings)->mode, particles);
    Overtone overtones[OVERTONES_MAX];
    int count = overtones_read(settings_start(settings)->overtones, overtones, status);
    for (int i = 0; i < count; i++) {
        if (overtones[i].mode == settings_start(settings)->mode)
            return status_refuse(status, "initial.overtones: mode %d is initial.mode already (other modes)",
                                 settings_start(settings)->mode);
        if (overtones[i].mode > particles)
            return status_refuse(status,
                                 "initial.overtones: mode %d is finer than the particles can show (at most "
                                 "%.0f, their number)",
                                 overtones[i].mode, particles);
    }
    return count >= 0;
}

/* --- what to watch -------------------------------------------------------------------------------- */

static bool is_loaded(const BarTheory *theory)
{
    return theory->body_force != 0 || theory->traction != 0;
}

int bar_watched_mode(const BarTheory *theory)
{
    for (int i = 0; i < theory->n_modes; i++)
        if (theory->modes[i].velocity != 0 && theory->modes[i].number > 0)
            return theory->modes[i].number;
    return 0;
}

/* Whether a mode moves the centre of mass: mean of its shape over the bar against rounding, of which symmetry
 * leaves none. */
static bool moves_centre(const BarTheory *theory, int mode)
{
    return fabs(bar_mode_mean(theory, mode)) > 1e-9;
}

/* By symmetry the centre of mass may stand still, or move evenly: then the strain energy is watched. It
 * oscillates twice in a period of a mode; under a load that pulls from rest it never turns its sign, and
 * oscillates once. */
BarWatch bar_watch(const BarTheory *theory)
{
    BarWatch watch = {.column = "v_cm", .times = 1, .kept = NAN, .overlap = 1};
    int mode = bar_watched_mode(theory);
    const bool by_load = mode == 0, held = theory->left_fixed || theory->right_fixed;
    const bool fixed_fixed = theory->left_fixed && theory->right_fixed;
    if (theory->pulse.velocity != 0)
        return watch; /* it is of many modes, and of no one frequency */
    /* a body force moves a free bar as a whole, and between fixed ends there is no traction */
    if (by_load && !(held && theory->body_force != 0) && !(theory->traction != 0 && !fixed_fixed))
        return watch;
    const bool centre = by_load ? held : moves_centre(theory, mode);
    mode = by_load ? 1 : mode;
    watch.moving = true;
    watch.mode = mode;
    if (!centre) {
        watch.column = "strain";
        watch.times = by_load ? 1 : 2;
    }
    watch.ratios[watch.n_lines++] = 1;
    watch.exact = bar_frequency(theory, mode);
    return watch;
}

/* --- what the step predicts ----------------------------------------------------------------------- */

/* Between shortage_begin() and shortage_end(): once cancelled, the modes that follow are not asked about. */
static StepModes *modes_from(BarStart *start_of, const Settings *settings, const BarTheory *theory,
                             bool whole)
{
    Simulation *sim = errno == ECANCELED ? NULL : start_of(settings, theory);
    StepModes *modes = sim ? step_modes_create(sim, whole, settings->cancel) : NULL;
    simulation_destroy(sim);
    return modes;
}

StepMode bar_step_mode(const BarStep *step, const Settings *settings, const BarTheory *theory, int number)
{
    StepMode mode = {.known = number == 0, .overlap = 1};
    BarTheory pure = *theory;
    pure.modes[0].number = number;
    pure.modes[0].velocity = pure.n_modes = 1;
    pure.of_sines = false;
    pure.pulse.velocity = 0;
    /* a wave shorter than two cells looks to the nodes like a longer one */
    if (number == 0 || bar_largest_wave_number(theory, number) * step->spacing > M_PI * (1 + 1e-12))
        return mode;
    StepModes *modes =
        theory->length > step->most * step->spacing ? NULL : modes_from(step->start, settings, &pure, false);
    if (modes)
        mode = step_modes_largest(modes);
    if (mode.known && theory->of_sines) {
        pure.of_sines = true;
        Simulation *start = step->start(settings, &pure);
        mode.overlap = start ? step_modes_overlap(modes, start) : NAN;
        simulation_destroy(start);
    }
    step_modes_free(modes);
    if (!mode.known && !bar_is_layered(theory)) {
        const Dispersion wave = step->wave(settings, theory, bar_wave_number(theory, number));
        mode = (StepMode){wave.known, wave.frequency, wave.decay, 1};
    }
    return mode;
}

bool bar_find_motion(BarAnswers *bar, const Settings *settings, BarStart *start_of)
{
    bool whole = true;
    /* mode by mode: the space of each closes soon, where that of all would drown in rounding */
    for (int k = 0; k < bar->theory.n_modes && whole; k++) {
        BarTheory one = bar->theory;
        one.modes[0] = one.modes[k];
        one.n_modes = 1;
        bar->modes[k] = modes_from(start_of, settings, &one, true);
        whole = bar->modes[k] && step_modes_are_whole(bar->modes[k]);
    }
    return whole;
}

static double predicted_v_cm(References *refs, long step, double time, const double *row)
{
    (void)time, (void)row;
    const BarAnswers *bar = bar_answers(refs);
    double sum = 0;
    for (int k = 0; k < bar->theory.n_modes; k++)
        sum += step_modes_v_cm(bar->modes[k], step);
    return sum;
}

/* With what is predicted beside it. */
static BarWatch predicted_watch(const Settings *settings, const BarTheory *theory, BarFrequency *frequency)
{
    BarWatch watch = bar_watch(theory);
    watch.predicted = watch.moving && frequency ? frequency(settings, theory, watch.mode) : NAN;
    watch.predicted_known = watch.predicted > 0;
    return watch;
}

enum { MODES_FITTED = 6 };

/* How much of a mode of two materials the column shows, of a start with sines. */
static double shown_of_sines(const BarTheory *theory, bool centre, int mode)
{
    double sum = 0;
    for (int i = 0; i < theory->n_modes; i++)
        sum += theory->modes[i].velocity * bar_share_of_sine(theory, theory->modes[i].number, mode);
    return fabs(centre ? sum * bar_mode_mean(theory, mode) : sum);
}

/* The modes of which a sine is made on two materials, those that show most first. Returns how many. */
static int modes_of_sines(const BarTheory *theory, bool centre, int first, int modes[MODES_FITTED])
{
    enum { BEYOND = 12 };
    for (int count = 0; count < MODES_FITTED; count++) {
        double most = 0;
        for (int mode = 1; mode <= first + BEYOND; mode++) {
            bool taken = mode == first;
            for (int k = 0; k < count; k++)
                taken = taken || modes[k] == mode;
            const double shown = taken ? 0 : shown_of_sines(theory, centre, mode);
            if (shown > most)
                most = shown, modes[count] = mode;
        }
        if (!(most > 0))
            return count;
    }
    return MODES_FITTED;
}

/* The modes that show in the column: the watched one, those that were given a velocity, and the lowest of
 * those that a load sets in motion, or those that a sine on two materials is made of. Returns how many. */
static int modes_shown(const BarTheory *theory, const BarWatch *watch, int modes[MODES_FITTED])
{
    enum { BY_LOAD = 12 }; /* modes up to this number; their shares fall as the square of it, or faster */
    const bool centre = strcmp(watch->column, "v_cm") == 0;
    int candidates[1 + BAR_MODES_MAX + BY_LOAD] = {watch->mode}, n = 1, count = 0;
    if (theory->of_sines)
        n += modes_of_sines(theory, centre, watch->mode, candidates + 1);
    for (int i = 0; i < theory->n_modes && !theory->of_sines; i++)
        if (theory->modes[i].velocity != 0 && theory->modes[i].number > 0)
            candidates[n++] = theory->modes[i].number;
    for (int mode = 1; is_loaded(theory) && mode <= BY_LOAD; mode++)
        candidates[n++] = mode;
    for (int i = 0; i < n && count < MODES_FITTED; i++) {
        bool known = centre && !moves_centre(theory, candidates[i]);
        for (int k = 0; k < count; k++)
            known = known || modes[k] == candidates[i];
        if (!known)
            modes[count++] = candidates[i];
    }
    return count;
}

/* Under a load, or with several modes in motion, the column is not a pure cosine: its other lines are fitted
 * beside, at the frequencies that the mesh gives them, else the continuum. The strain energy oscillates twice
 * as fast as each mode, and under a load as fast as it too. */
static void set_lines(BarWatch *watch, const Settings *settings, const BarTheory *theory,
                      BarFrequency *frequency)
{
    int modes[MODES_FITTED];
    const int n_modes = modes_shown(theory, watch, modes);
    const bool squares = strcmp(watch->column, "strain") == 0;
    if (n_modes == 1 && !is_loaded(theory))
        return;
    const double of_mesh = frequency(settings, theory, watch->mode);
    for (int i = 0; i < n_modes; i++) {
        double ratio = of_mesh > 0 ? frequency(settings, theory, modes[i]) / of_mesh
                                   : bar_frequency(theory, modes[i]) / watch->exact;
        for (int times = 1; times <= 2; times++) {
            const bool oscillates = squares ? times == 2 || is_loaded(theory) : times == 1;
            const bool first = i == 0 && times == (int)watch->times;
            if (oscillates && !first && ratio > 0 && watch->n_lines < FREQUENCY_LINES_MAX)
                watch->ratios[watch->n_lines++] = ratio * times / watch->times;
        }
    }
}

/* --- columns -------------------------------------------------------------------------------------- */

const BarAnswers *bar_answers(const References *refs)
{
    return refs->own;
}

static void release(void *own)
{
    BarAnswers *bar = own;
    for (int k = 0; k < BAR_MODES_MAX; k++)
        step_modes_free(bar->modes[k]);
}

BarAnswers *bar_answers_create(References *refs, const Settings *settings, Status *status)
{
    BarTheory theory;
    if (!bar_theory_of(settings, &theory, status))
        return NULL;
    BarAnswers *bar = plan_own(refs, sizeof *bar, release, status);
    if (bar)
        bar->theory = theory;
    return bar;
}

ANSWER(exact_v_cm, bar_waves_centre_velocity(&bar_answers(refs)->theory, time))

void bar_prepare(References *refs, const Settings *settings, const Simulation *sim, BarFrequency *frequency,
                 bool whole, const char *meaning)
{
    BarAnswers *bar = refs->own;
    bar->watch =
        predicted_watch(settings, &bar->theory, refs->unaccounted[REFERENCE_PREDICTED] ? NULL : frequency);
    if (bar->watch.moving)
        set_lines(&bar->watch, settings, &bar->theory, frequency);

    static const Quantity exact = {"v_cm_exact", "exact", "length/time",
                                   "velocity of the centre of mass of the continuum (eq. 20)"};
    const char *label = settings_mistake(settings) ? "predicted (right code)" : "predicted";
    const Quantity of_mesh = {"v_cm_predicted", label, "length/time", meaning};
    plan_method(refs, sim, "v_cm");
    plan_answer(refs, &exact, COLUMN_EXACT, "v_cm", exact_v_cm);
    if (whole)
        plan_answer(refs, &of_mesh, COLUMN_PREDICTED, "v_cm", predicted_v_cm);
}

double bar_profile(const References *refs, const char *field, double x, double time)
{
    const BarTheory *theory = &bar_answers(refs)->theory;
    if (!(x >= 0 && x <= theory->length))
        return NAN;
    if (strcmp(field, "u") == 0)
        return bar_waves_displacement(theory, x, time);
    if (strcmp(field, "x") == 0)
        return x + bar_waves_displacement(theory, x, time);
    if (strcmp(field, "v") == 0)
        return bar_waves_velocity(theory, x, time);
    if (strcmp(field, "stress") == 0)
        return bar_waves_stress(theory, x, time);
    /* a pulse's stress of the start stretches, and changes no density */
    const double modulus = bar_modulus_at(theory, x), strain = bar_waves_stress(theory, x, time) / modulus;
    if (strcmp(field, "strain") == 0)
        return strain;
    if (strcmp(field, "density") == 0)
        return bar_density_at(theory, x) / (1 + strain - bar_waves_start_stress(theory, x) / modulus);
    return NAN;
}

/* --- readout -------------------------------------------------------------------------------------- */

/* The frequency of the watched column by least squares (theory/frequency.h), started at what is predicted,
 * else exact. The strain energy goes as the square of the motion: its frequency is divided by watch->times.
 */
void bar_read_out(const References *refs, const double *rows, size_t n_rows, int n_columns, Readout *out)
{
    const BarWatch *watch = &bar_answers(refs)->watch;
    out->moving = watch->moving;
    out->column = watch->column;
    out->times = watch->times;
    out->mode = watch->mode;
    out->overlap = watch->overlap;
    if (!watch->moving)
        return;
    out->exact_known = true;
    out->exact = watch->exact;
    out->predicted_known = watch->predicted_known;
    out->predicted = watch->predicted_known ? watch->predicted : NAN;
    out->kept_predicted = watch->kept;
    int column = plan_find(refs, watch->column);
    double expected = watch->times * (watch->predicted_known ? watch->predicted : watch->exact);
    readout_fit(rows, n_rows, n_columns, column, expected, watch->ratios, watch->n_lines, out);
    /* without the first row: what the particles are given is not yet what comes back from the grid; beside
     * the middle of their shares they start in many modes, of which v_cm shows the lowest ones best */
    Oscillation oscillation;
    if (n_rows > 2 && watch->n_lines == 1 && bar_answers(refs)->mesh.offset == 0 &&
        oscillation_fit(rows + n_columns + column, (size_t)n_columns, n_rows - 1,
                        rows[(size_t)n_columns + 1] - rows[1], expected / watch->times, watch->times > 1,
                        &oscillation))
        out->kept_measured = oscillation_kept(oscillation.decay, watch->exact);
}

bool bar_prediction_is_whole(int before, double count, const char *parts, Status *status)
{
    shortage_end(before);
    if (errno == ECANCELED)
        return status_fail(status, "the prediction for the bar was cancelled");
    return errno != ENOMEM ||
           status_fail(status, "not enough memory to predict the motion of %g %s", count, parts);
}

/* --- derived numbers ------------------------------------------------------------------------------ */

void bar_derived_step(Derived out[DERIVED_MAX], int *n, double speed, double dt)
{
    ASSERT_REAL(speed, >, 0);
    ASSERT_REAL(dt, >, 0);
    derived_add(out, n, "wave_speed", "wave speed c", "length/time", speed, false);
    derived_add(out, n, "dt", "time step dt", "time", dt, false);
}

void bar_derived_wave(Derived out[DERIVED_MAX], int *n, const Settings *settings, const BarTheory *theory,
                      BarFrequency *frequency, double dt)
{
    ASSERT_REAL(dt, >, 0);
    const BarWatch watch = predicted_watch(settings, theory, frequency);
    if (!watch.moving)
        return;
    if (bar_is_layered(theory)) {
        derived_add(out, n, "beta", "wave number", "1/length", watch.exact / bar_wave_speed(theory), false);
        derived_add(out, n, "beta2", "  beyond the joint", "1/length",
                    watch.exact / sqrt(theory->joint_modulus / theory->joint_density), false);
    } else
        derived_add(out, n, "beta", "wave number", "1/length", bar_wave_number(theory, watch.mode), false);
    derived_add_answer(out, n, REFERENCE_FREQUENCY, "omega", "frequency w", "1/time", watch.exact);
    if (watch.predicted_known)
        derived_add_answer(out, n, REFERENCE_PREDICTED, "omega_predicted", "w of this mesh", "1/time",
                           watch.predicted);
    derived_add_answer(out, n, REFERENCE_FREQUENCY, "period", "period", "time", 2 * M_PI / watch.exact);
    derived_add_answer(out, n, REFERENCE_FREQUENCY, "steps_per_period", "steps/period", "1",
                       2 * M_PI / watch.exact / dt);
}

/* --- every mode ----------------------------------------------------------------------------------- */

int bar_modes_of(double count)
{
    return count >= 1 && count < INT_MAX ? (int)count : 0;
}

bool bar_mode(const Settings *settings, int number, BarWave *wave_of, BarFactors *factors_of, ModeOnMesh *out)
{
    ASSERT_INT(number, >=, 0);
    BarTheory theory;
    if (!bar_theory_of(settings, &theory, NULL))
        return false;
    const Dispersion wave = wave_of(settings, &theory, bar_wave_number(&theory, number));
    *out = (ModeOnMesh){.exact = bar_frequency(&theory, number), .predicted = NAN};
    if (wave.known && wave.frequency > 0) {
        out->predicted = wave.frequency;
        factors_of(&wave, out);
    }
    return true;
}

/* The sharp invariant of the bar by the material point method: answers/references.h says what it is. */
bool bar_invariant_kept(const Settings *settings)
{
    return settings_transfer(settings)->transfer == MPM_FLIP &&
           settings_transfer(settings)->flip_fraction == 1 && settings_loads(settings)->body_force == 0 &&
           settings_loads(settings)->traction == 0;
}

double bar_invariant(Simulation *sim, const Settings *settings)
{
    const size_t count = sim->counts[0];
    double *before = malloc(3 * count * sizeof *before), *after = before + count, *mass = before + 2 * count;
    double strain[2], sum = NAN;
    if (before && simulation_step_ahead(sim, before, after, strain)) {
        sim->method->field(sim, simulation_find_field(sim, 0, "mass"), 0, count, mass);
        sum = strain[settings_transfer(settings)->algorithm == MPM_USF];
        for (size_t i = 0; i < count; i++)
            sum += mass[i] * before[i] * after[i] / 2;
    }
    free(before);
    return sum;
}
