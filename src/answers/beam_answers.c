/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Answers for the beams that do not depend on the method: beam theories beside, zeros and periods of a
 * record. */
#include "answers/beam_answers.h"

#include "scenario/concern_body.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "base/math/functions.h"
#include "theory/elastic_beam.h"
#include "theory/oscillation.h"

#include <limits.h>
#include <math.h>
#include <string.h>

/* What References.own is of a beam. */
typedef struct BeamAnswers {
    BeamTheory theory;                         /* as the scenario has it */
    BeamBody body;                             /* as the method has it */
    double euler, timoshenko, timoshenko_real; /* periods of the simply supported beam */
    MovingCantilever *moving;
    double speed; /* of the same */
} BeamAnswers;

static const BeamAnswers *own(const References *refs)
{
    return refs->own;
}

static void release(void *answers)
{
    BeamAnswers *beam = answers;
    if (beam->moving)
        moving_cantilever_free(beam->moving);
}

BeamTheory beam_theory_of(const Settings *settings)
{
    return (BeamTheory){.length = settings_geometry(settings)->length,
                        .height = settings_geometry(settings)->height,
                        .youngs_modulus = settings_material(settings)->youngs_modulus,
                        .density = settings_material(settings)->density,
                        .poisson =
                            settings->method == METHOD_MPM ? settings_material(settings)->poisson : 1.0 / 3,
                        .amplitude = settings_start(settings)->amplitude};
}

/* The zeros of a column: how many, the first and the last two. */
typedef struct Zeros {
    long count;
    double first, last, before;
} Zeros;

/* Changes of sign of a column, at most `most` of them, each placed by the straight line between its two rows
 * (column 1 of a row is its time). */
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

ANSWER(u_euler, beam_midpoint(&own(refs)->theory, own(refs)->euler, time))
ANSWER(v_euler, beam_midpoint_velocity(&own(refs)->theory, own(refs)->euler, time))
ANSWER(u_timoshenko, beam_midpoint(&own(refs)->theory, own(refs)->timoshenko, time))
ANSWER(v_timoshenko, beam_midpoint_velocity(&own(refs)->theory, own(refs)->timoshenko, time))
ANSWER(u_plane, beam_midpoint(&own(refs)->theory, own(refs)->body.plane, time))
ANSWER(v_plane, beam_midpoint_velocity(&own(refs)->theory, own(refs)->body.plane, time))

/* Under a weight that is there from t = 0 on the state of rest is beside the run, whatever the way to it.
 */
ANSWER(u_rest, beam_sag(&own(refs)->body.real, own(refs)->body.weight))
ANSWER(u_solved, own(refs)->body.solved)

/* Under its weight: what the lattice comes to rest at against one solution of it, and that against theory. */
int beam_find_rest(const References *refs, const Simulation *sim, Finding *out)
{
    const BeamBody *body = &own(refs)->body;
    double row[COLUMNS_MAX];
    int n = 0;
    if (body->weight == 0)
        return 0;
    const double theory = beam_sag(&body->real, body->weight);
    if (sim->stage != 0 || sim->item != 0)
        row[simulation_find_series(sim, "u_probe")] = NAN;
    else
        sim->method->row((Simulation *)sim, row);
    const double now = row[simulation_find_series(sim, "u_probe")];
    if (isfinite(body->solved)) {
        out[n++] = (Finding){"u_middle", "middle", now, body->solved, "one solution", NULL};
        out[n++] = (Finding){"off", "off by", now / body->solved - 1, 0, NULL, NULL};
        out[n++] =
            (Finding){"sag_ratio", "one solution over Timoshenko", body->solved / theory, 0, NULL, NULL};
    } else {
        out[n++] = (Finding){"u_middle", "middle", now, theory, "Timoshenko", NULL};
    }
    if (sim->kinetic_left > 0 || sim->at_rest)
        out[n++] = (Finding){"kinetic_left", "kinetic over its largest", sim->kinetic_left, 0, NULL, NULL};
    return n;
}

bool beam_prepare_supported(References *refs, const Settings *settings, const Simulation *sim,
                            const BeamBody *body, Status *status)
{
    static const Quantity u_e = {"u_euler", "Euler", "m", "mid-point displacement by Euler-Bernoulli"};
    static const Quantity v_e = {"v_euler", "Euler", "m/s", "mid-point velocity by Euler-Bernoulli"};
    static const Quantity u_t = {"u_timoshenko", "Timoshenko", "m", "mid-point displacement by Timoshenko"};
    static const Quantity v_t = {"v_timoshenko", "Timoshenko", "m/s", "mid-point velocity by Timoshenko"};
    static const Quantity u_p = {"u_plane", "plane", "m",
                                 "mid-point displacement by the exact plane problem"};
    static const Quantity v_p = {"v_plane", "plane", "m/s", "mid-point velocity by the exact plane problem"};
    static const Quantity rest = {"u_rest", "Timoshenko", "m",
                                  "the middle at rest by Timoshenko, at the beam's real span and height"};
    static const Quantity solved = {"u_solved", "one solution", "m",
                                    "the probe of this very lattice at rest, by one solution"};
    BeamAnswers *beam = plan_own(refs, sizeof *beam, release, status);
    if (!beam)
        return false;
    beam->theory = beam_theory_of(settings);
    beam->body = *body;
    beam->euler = beam_period_euler(&beam->theory);
    beam->timoshenko = beam_period_timoshenko(&beam->theory);
    beam->timoshenko_real = beam_period_timoshenko(&body->real);
    beam->theory.damping = body->damping;
    plan_method(refs, sim, "u_probe");
    plan_method(refs, sim, "v_probe");
    if (body->weight != 0) {
        plan_answer(refs, &rest, COLUMN_EXACT, "u_probe", u_rest);
        if (isfinite(body->solved))
            plan_answer(refs, &solved, COLUMN_PREDICTED, "u_probe", u_solved);
        return true;
    }
    plan_answer(refs, &u_e, COLUMN_EXACT, "u_probe", u_euler);
    plan_answer(refs, &v_e, COLUMN_EXACT, "v_probe", v_euler);
    plan_answer(refs, &u_t, COLUMN_EXACT, "u_probe", u_timoshenko);
    plan_answer(refs, &v_t, COLUMN_EXACT, "v_probe", v_timoshenko);
    if (isfinite(body->plane)) {
        plan_answer(refs, &u_p, COLUMN_EXACT, "u_probe", u_plane);
        plan_answer(refs, &v_p, COLUMN_EXACT, "v_probe", v_plane);
    }
    return true;
}

/* Timoshenko's beam keeps the sine: what a two-dimensional body should give. */
double beam_supported_profile(const References *refs, const char *field, double x, double time)
{
    const BeamTheory *beam = &own(refs)->theory;
    if (!(x >= 0 && x <= beam->length))
        return NAN;
    const BeamBody *body = &own(refs)->body;
    if (body->weight != 0) {
        const double between = x - (beam->length - body->real.length) / 2;
        return strcmp(field, "vy") == 0 ? 0
               : strcmp(field, "uy") == 0 && between >= 0 && between <= body->real.length
                   ? beam_sag_at(&body->real, body->weight, between)
                   : NAN;
    }
    double shape = math_sin(M_PI * x / beam->length);
    if (strcmp(field, "uy") == 0)
        return shape * beam_midpoint(beam, own(refs)->timoshenko, time);
    if (strcmp(field, "vy") == 0)
        return shape * beam_midpoint_velocity(beam, own(refs)->timoshenko, time);
    return NAN;
}

/* y = 0 in the middle. */
double beam_supported_section(const References *refs, const char *field, double x, double y, double time)
{
    const BeamTheory *beam = &own(refs)->theory;
    if (!(x >= 0 && x <= beam->length) || own(refs)->body.weight != 0)
        return NAN;
    if (strcmp(field, "sxx") == 0)
        return beam_bending_stress(beam, x, y, time);
    if (strcmp(field, "sxy") == 0)
        return beam_shear_stress(beam, x, y, time);
    return NAN;
}

/* Beam theory is Timoshenko's period of the beam as it was asked for, and the same at its real size that of
 * the beam as it lies on the lattice, a little thinner and shorter; predicted is the lattice's own. */
void beam_read_supported(const References *refs, const double *rows, size_t n_rows, int n_columns,
                         Readout *out)
{
    out->is_period = true;
    out->column = "u_probe";
    const BeamAnswers *beam = own(refs);
    const double damping = beam->body.damping;
    out->exact = beam_damped_period(beam->timoshenko, damping);
    /* a beam that is braked almost critically does not come back often enough to be measured */
    const double most = 0.9, slowest = fmax(beam->timoshenko, beam->body.predicted); /* without NAN */
    out->moving =
        (beam->theory.amplitude != 0 || beam->body.weight != 0) && damping * slowest / (4 * M_PI) < most;
    if (!out->moving)
        return;
    out->exact_known = true;
    out->predicted = beam_damped_period(beam->body.predicted, damping);
    out->predicted_known = isfinite(out->predicted);
    out->real_size = beam_damped_period(beam->timoshenko_real, damping);
    if (damping > 0) {
        out->decay_exact = own(refs)->body.damping / 2;
        out->kept_predicted = oscillation_kept(out->decay_exact, 2 * M_PI / out->exact);
    }
    const double expected = out->predicted_known ? out->predicted : out->real_size;
    readout_fit(rows, n_rows, n_columns, plan_find(refs, "u_probe"), 2 * M_PI / expected, &(double){1}, 1,
                out);
    if (damping > 0) { /* one fit gives period and decay */
        if (isfinite(out->decay_measured))
            out->kept_measured = oscillation_kept(out->decay_measured, 2 * M_PI / out->exact);
        return;
    }
    const Zeros zeros = find_zeros(rows, n_rows, n_columns, plan_find(refs, "u_probe"), LONG_MAX);
    if (zeros.count > 1)
        out->by_zeros = 2 * (zeros.last - zeros.first) / (double)(zeros.count - 1);
}

/* --- axially moving cantilever -------------------------------------------------------------------- */

ANSWER(u_modal, moving_cantilever_tip(own(refs)->moving, time))
ANSWER(v_modal, moving_cantilever_tip_velocity(own(refs)->moving, time))

/* The straight line v = a + b k through the velocities of the last 0.1 ms by least squares, read at its
 * newest end, k = 0, going back:
 *
 *     a = (2 (2n - 1) sum v_k - 6 sum k v_k)/(n (n + 1))
 *
 * A mean over the same window would lag by half of it; the line does not, and damps the thickness modes (1
 * MHz and more) to a hundredth all the same. The first rows stand for themselves until three are there. */
static double v_filtered(References *refs, long step, double time, const double *row)
{
    (void)step, (void)time;
    const Window *window = &refs->window;
    long n = window->filled;
    if (n < 3)
        return row[refs->window.of];
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

bool beam_prepare_moving(References *refs, const Settings *settings, const Simulation *sim,
                         const BeamBody *body, Status *status)
{
    static const Quantity u_m = {"u_modal", "modal", "m", "tip displacement by the modal equations"};
    static const Quantity v_m = {"v_modal", "modal", "m/s", "the tip's material velocity by the same"};
    static const Quantity v_f = {"v_filtered", "filtered 0.1 ms", "m/s",
                                 "v_probe without its thickness modes: the end of the straight line "
                                 "through the last 0.1 ms"};
    const double window = 1e-4;
    BeamAnswers *beam = plan_own(refs, sizeof *beam, release, status);
    if (!beam)
        return false;
    beam->theory = beam_theory_of(settings);
    /* the last step may lie beyond the end by almost a step */
    double end = (double)problem_last_step(sim->dt, settings_time(settings)->end) * sim->dt;
    BeamTheory asking = beam->theory;
    asking.from_tip = body->from_tip;
    asking.cancel = settings->cancel;
    beam->moving =
        moving_cantilever_solve(&asking, settings_motion(settings)->speed, fmax(end, sim->dt), status);
    if (!beam->moving)
        return false;
    beam->speed = settings_motion(settings)->speed;
    beam->body = *body;
    const long rows = lround(window / sim->dt) + 1;
    if (body->rings && !plan_window(refs, sim, "v_probe", rows < 1000000 ? rows : 1000000))
        return status_fail(status, "not enough memory to filter the velocity");
    plan_method(refs, sim, "u_probe");
    plan_method(refs, sim, "v_probe");
    plan_method(refs, sim, "length");
    plan_answer(refs, &u_m, COLUMN_EXACT, "u_probe", u_modal);
    plan_answer(refs, &v_m, COLUMN_EXACT, "v_probe", v_modal);
    if (body->rings)
        plan_filter(refs, &v_f, "v_probe", v_filtered);
    return true;
}

/* x of the beam at t = 0, 0 at the mouth; it moves out of it. */
double beam_moving_section(const References *refs, const char *field, double x, double y, double time)
{
    const BeamAnswers *beam = own(refs);
    const double from_root = x + beam->speed * time;
    if (strcmp(field, "sxx") == 0)
        return moving_cantilever_bending_stress(beam->moving, &beam->theory, from_root, y, time);
    if (strcmp(field, "sxy") == 0)
        return moving_cantilever_shear_stress(beam->moving, &beam->theory, from_root, y, time);
    return NAN;
}

/* How well half a sine between two zeros explains the rows y_k there, and how well these give its period T:
 *
 *     y ~ A sin(w (t - t_1)) + B sin(2 w (t - t_1)),  w = pi/(t_2 - t_1),  A = sum y sin/sum sin^2, B
 * likewise R2 = 1 - sum r^2/sum (y - mean)^2,   s^2 = sum r^2/(n - 2),   sigma_T = 2 sqrt(2) s/(|A| w)
 *
 * for a zero is displaced by s over the slope A w there, and T is twice the time between two. B is what the
 * sine leans over while the beam lengthens; over half a period the two are orthogonal. */
static void judge_half_period(const double *rows, size_t n_rows, int n_columns, int column,
                              const Zeros *zeros, Readout *out)
{
    const double w = M_PI / (zeros->last - zeros->before);
    double n = 0, sum = 0, squares = 0, both = 0, of_sine = 0, lean = 0, of_lean = 0;
    for (size_t k = 0; k < n_rows; k++) {
        const double *row = rows + k * (size_t)n_columns, y = row[column];
        if (row[1] < zeros->before || row[1] > zeros->last)
            continue;
        const double phase = w * (row[1] - zeros->before), sine = math_sin(phase),
                     twice = math_sin(2 * phase);
        n++, sum += y, squares += y * y, both += y * sine, of_sine += sine * sine;
        lean += y * twice, of_lean += twice * twice;
    }
    if (n < 4 || both == 0)
        return;
    const double left = fmax(squares - both * both / of_sine - lean * lean / of_lean, 0);
    out->r2 = 1 - left / (squares - sum * sum / n);
    out->uncertainty = 2 * sqrt(2 * left / (n - 2)) / (fabs(both / of_sine) * w);
}

/* The period grows with the length, so the time between the last two zeros is given (twice, for a whole
 * period), against that between the same zeros of the modal solution. */
void beam_read_moving(const References *refs, const double *rows, size_t n_rows, int n_columns, Readout *out)
{
    out->is_period = true;
    out->drifting = true;
    out->column = "u_probe";
    out->moving = own(refs)->theory.amplitude != 0;
    if (!out->moving)
        return;
    int u = plan_find(refs, "u_probe"), modal = plan_find(refs, "u_modal");
    if (u < 0 || modal < 0)
        return; /* theory does not know this run */
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
    judge_half_period(rows, n_rows, n_columns, u, &measured, out);
    out->exact = 2 * (exact.last - exact.before);
    out->late = (measured.last - exact.last) / out->exact;
}

/* --- notched -------------------------------------------------------------------------------------- */

bool beam_prepare_notched(References *refs, const Settings *settings, const Simulation *sim, Status *status)
{
    (void)settings, (void)status;
    plan_method(refs, sim, "u_probe");
    plan_method(refs, sim, "v_probe");
    return true;
}

void beam_read_nothing(const References *refs, const double *rows, size_t n_rows, int n_columns, Readout *out)
{
    (void)refs, (void)rows, (void)n_rows, (void)n_columns;
    out->is_period = out->unjudged = true;
    out->column = "u_probe";
}

/* --- moving: what its lengthening alone does ------------------------------------------------------- */

static double length_at(const References *refs, double time)
{
    return own(refs)->theory.length + own(refs)->speed * time;
}

double beam_moving_envelope(const References *refs, const char *column, double time)
{
    const BeamTheory *beam = &own(refs)->theory;
    const double growth = length_at(refs, time) / beam->length, tip = 2 * fabs(beam->amplitude);
    if (strcmp(column, "u_probe") == 0)
        return tip * sqrt(growth);
    if (strcmp(column, "v_probe") == 0)
        return tip * beam_cantilever_frequency(beam, beam->length) * math_pow(growth, -1.5);
    return NAN;
}

double beam_moving_frequency(const References *refs, double time)
{
    return beam_cantilever_frequency(&own(refs)->theory, length_at(refs, time)) / (2 * M_PI);
}

int beam_thickness_lines(const References *refs, double out[THICKNESS_LINES_MAX])
{
    memcpy(out, own(refs)->body.thickness, sizeof own(refs)->body.thickness);
    return own(refs)->body.n_thickness;
}
