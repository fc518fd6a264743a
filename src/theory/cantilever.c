/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The axially moving cantilever, Euler-Bernoulli on L(t) = L0 + v t, by its modal equations.
 *
 * With s = x/L, phi_n the clamped-free modes (int phi^2 = 1, phi_n(1) = +-2) and w = sum q_n(t) phi_n(s):
 *
 *     q'' + (2 v/L) B q' + (v/L)^2 (C - 2 B) q + (E h^2 / (12 rho)) (lambda/L)^4 q = 0
 *     B_mn = int phi_m (1 - s) phi_n' ds,   C_mn = int phi_m (1 - s)^2 phi_n'' ds
 *     q(0) = (U, 0, ...),   q'(0) = -(v/L) B q(0)
 *
 * The initial rate makes the body stand still across while it moves along. The tip is always the same
 * material point, so its velocity is sum q_n' phi_n(1). A point at a small distance d before it moves by
 * phi_n(1)
 * - (d/L) phi_n'(1) in place of phi_n(1).
 *
 * The solution is kept as displacement, velocity and acceleration of the tip at equal times, close enough
 * that the quintic between two of them is as good as the solver; beside it the q_n, from which bending moment
 * and shear force of a section follow, M = E I w'' and Q = E I w'''. */
#include "theory/elastic_beam.h"
#include "theory/gsl_errors.h"
#include "base/math/functions.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>
#include <gsl/gsl_odeiv2.h>
#include <gsl/gsl_roots.h>
#include <math.h>
#include <stdlib.h>

/* Four modes are right to a nanometre in six micrometres, ten to the digits that the tests know. The fast
 * modes hardly move, so few samples of them suffice. */
enum { MODES = 10, GAUSS_POINTS = 64, SAMPLES_PER_FAST_PERIOD = 16 };

/* More take many minutes and a quarter of a gigabyte. */
#define SAMPLES_MAX 1e7
enum { SAMPLES_A_QUESTION = 64, STEPS_A_SAMPLE = 10000 };

/* What bends a section is computed for a motion of so many samples at most: 160 MB. */
#define MODAL_SAMPLES_MAX 1000000

typedef struct Tip {
    double displacement, velocity, acceleration;
} Tip;

typedef struct Modes {
    double lambda[MODES];
    double b[MODES][MODES], c[MODES][MODES];
    double length, speed, stiffness; /* L0, v, E h^2 / (12 rho) */
    double from_tip;                 /* d */
    double slope[MODES];             /* phi_n'(1) */
} Modes;

struct MovingCantilever {
    Modes modes;
    double end;  /* s */
    double step; /* between two samples, s */
    size_t count;
    double (*modal)[2 * MODES]; /* of each sample q_n, then q_n', m and m/s; NULL: there are too many */
    Tip samples[];
};

/* --- the modes ----------------------------------------------------------------------------------- */

/* (1 + cosh x cos x) / cosh x: the same roots, without its growth. */
static double characteristic(double x, void *context)
{
    (void)context;
    return 1 / math_cosh(x) + math_cos(x);
}

/* The n-th root, n from 1, lies near (n - 1/2) pi. NAN: the solver gave up (not seen). */
static double clamped_free_root(gsl_root_fsolver *solver, int n)
{
    gsl_function function = {characteristic, NULL};
    double centre = (n - 0.5) * M_PI;
    if (gsl_root_fsolver_set(solver, &function, centre - 0.5, centre + 0.5) != GSL_SUCCESS)
        return NAN;
    for (int i = 0; i < 100; i++) {
        if (gsl_root_fsolver_iterate(solver) != GSL_SUCCESS)
            return NAN;
        double low = gsl_root_fsolver_x_lower(solver), high = gsl_root_fsolver_x_upper(solver);
        if (gsl_root_test_interval(low, high, 0, 1e-15) == GSL_SUCCESS)
            break;
    }
    return gsl_root_fsolver_root(solver);
}

/* phi, phi', phi'' or phi''' (derivative 0 to 3) of the mode with root lambda. cosh - sigma sinh is written
 * with exponentials, for their difference loses its digits towards the tip. */
static double mode_derivative(double lambda, int derivative, double s)
{
    const double sine = math_sin(lambda), cosine = math_cos(lambda), sum = math_cosh(lambda) + cosine;
    double sigma = (math_sinh(lambda) - sine) / sum;
    /* 1 - sigma, without subtracting two like numbers */
    double rest = (math_exp(-lambda) + cosine + sine) / sum;
    double x = lambda * s;
    double grows = rest / 2 * math_exp(x), falls = (1 + sigma) / 2 * math_exp(-x);
    double square = derivative == 0 ? 1 : derivative == 1 ? lambda : lambda * lambda;
    double hyperbolic = derivative % 2 == 1 ? grows - falls : grows + falls;
    const double sin_x = math_sin(x), cos_x = math_cos(x);
    double circular = derivative == 0   ? -cos_x + sigma * sin_x
                      : derivative == 1 ? sin_x + sigma * cos_x
                      : derivative == 2 ? cos_x - sigma * sin_x
                                        : -sin_x - sigma * cos_x;
    return (derivative == 3 ? lambda : 1) * square * (hyperbolic + circular);
}

/* B and C by Gauss-Legendre quadrature over s in [0, 1]: 64 points are about six for each half wave of the
 * highest mode. Both MODES x MODES, without unit. */
static void integrate_couplings(Modes *modes, const gsl_integration_glfixed_table *table)
{
    for (size_t i = 0; i < GAUSS_POINTS; i++) {
        double s, weight;
        gsl_integration_glfixed_point(0, 1, i, &s, &weight, table);
        double phi[3][MODES]; /* with their first two derivatives */
        for (int derivative = 0; derivative < 3; derivative++)
            for (int n = 0; n < MODES; n++)
                phi[derivative][n] = mode_derivative(modes->lambda[n], derivative, s);
        for (int m = 0; m < MODES; m++)
            for (int n = 0; n < MODES; n++) {
                double left = weight * phi[0][m] * (1 - s);
                modes->b[m][n] += left * phi[1][n];
                modes->c[m][n] += left * (1 - s) * phi[2][n];
            }
    }
}

/* lambda, B and C: what does not depend on the beam. False: not enough memory. */
static bool build_modes(Modes *modes, Status *status)
{
    gsl_root_fsolver *solver = gsl_root_fsolver_alloc(gsl_root_fsolver_brent);
    gsl_integration_glfixed_table *table = gsl_integration_glfixed_table_alloc(GAUSS_POINTS);
    bool sound = solver && table;
    if (sound) {
        for (int n = 0; n < MODES; n++) {
            modes->lambda[n] = clamped_free_root(solver, n + 1);
            modes->slope[n] = mode_derivative(modes->lambda[n], 1, 1);
            sound = sound && isfinite(modes->lambda[n]);
        }
        integrate_couplings(modes, table);
    }
    gsl_root_fsolver_free(solver);
    gsl_integration_glfixed_table_free(table);
    return sound || status_fail(status, "not enough memory for the modes of the cantilever");
}

/* --- the equations of motion --------------------------------------------------------------------- */

/* The modal equations solved for q'': y holds q_1 .. q_MODES, then their rates; q is over U and so without
 * unit, times in s. The shift of the modes along the growing beam gives 2 (v/L) B q', a force like Coriolis',
 * and the terms in (v/L)^2; bending gives omega_n^2 = E h^2/(12 rho) (lambda_n/L)^4 at the length that the
 * beam has now. */
static int modal_equations(double t, const double y[], double rate[], void *context)
{
    const Modes *modes = context;
    double length = modes->length + modes->speed * t, ratio = modes->speed / length;
    for (int m = 0; m < MODES; m++) {
        double wave_number = modes->lambda[m] / length;
        double sum = modes->stiffness * math_pow(wave_number, 4) * y[m];
        for (int n = 0; n < MODES; n++) {
            sum += 2 * ratio * modes->b[m][n] * y[MODES + n];
            sum += ratio * ratio * (modes->c[m][n] - 2 * modes->b[m][n]) * y[n];
        }
        rate[m] = y[MODES + m];
        rate[MODES + m] = -sum;
    }
    return GSL_SUCCESS;
}

/* w at s = 1 - r with its first two rates, r = d/L: the sum over modes with phi_n(1) = 2, -2, 2, ...; r' =
 * -r v/L, (r v/L)' = -2 r (v/L)^2. */
static Tip tip_of(const Modes *modes, double t, const double y[])
{
    double rate[2 * MODES];
    modal_equations(t, y, rate, (void *)modes);
    const double length = modes->length + modes->speed * t, r = modes->from_tip / length;
    const double ratio = modes->speed / length, rise = r * ratio;
    Tip tip = {0};
    for (int n = 0; n < MODES; n++) {
        const double at_tip = (n % 2 ? -2 : 2) - r * modes->slope[n], turn = rise * modes->slope[n];
        tip.displacement += at_tip * y[n];
        tip.velocity += at_tip * y[MODES + n] + turn * y[n];
        tip.acceleration += at_tip * rate[MODES + n] + 2 * turn * y[MODES + n] - 2 * ratio * turn * y[n];
    }
    return tip;
}

/* Fills the samples for U = 1 and scales them: the equations are linear, and the solver's tolerance is
 * relative to 1. */
static bool integrate_motion(const Modes *modes, const BeamTheory *beam, MovingCantilever *solution,
                             Status *status)
{
    gsl_odeiv2_system system = {modal_equations, NULL, 2 * MODES, (void *)modes};
    /* velocities are larger than displacements by about omega_1 */
    double omega = sqrt(modes->stiffness) * math_pow(modes->lambda[0] / modes->length, 2);
    double weights[2 * MODES];
    for (int n = 0; n < MODES; n++)
        weights[n] = 1, weights[MODES + n] = omega;
    gsl_odeiv2_driver *driver = gsl_odeiv2_driver_alloc_scaled_new(
        &system, gsl_odeiv2_step_rk8pd, solution->step, 1e-13, 1e-12, 1, 0, weights);
    if (!driver)
        return status_fail(status, "not enough memory for the moving cantilever");
    gsl_odeiv2_driver_set_nmax(driver, STEPS_A_SAMPLE);
    double y[2 * MODES] = {1}, t = 0;
    for (int m = 0; m < MODES; m++)
        y[MODES + m] = -modes->speed / modes->length * modes->b[m][0];
    bool sound = true;
    for (size_t k = 0; sound && k < solution->count; k++) {
        const double next = solution->step * (double)k, amplitude = beam->amplitude;
        if (k % SAMPLES_A_QUESTION == 0 &&
            cancel_requested(&beam->cancel, (double)k / (double)solution->count)) {
            gsl_odeiv2_driver_free(driver);
            return status_fail(status, "the solving of the cantilever's motion was cancelled");
        }
        sound = k == 0 || gsl_odeiv2_driver_apply(driver, &t, next, y) == GSL_SUCCESS;
        Tip tip = tip_of(modes, next, y);
        sound = sound && isfinite(tip.displacement) && isfinite(tip.velocity) && isfinite(tip.acceleration);
        for (int i = 0; solution->modal && i < 2 * MODES; i++)
            solution->modal[k][i] = amplitude * y[i];
        solution->samples[k] =
            (Tip){amplitude * tip.displacement, amplitude * tip.velocity, amplitude * tip.acceleration};
    }
    gsl_odeiv2_driver_free(driver);
    return sound || status_fail(status,
                                "the moving cantilever's equations cannot be solved beyond "
                                "%g s",
                                t);
}

static MovingCantilever *solve(const BeamTheory *beam, double speed, double end, Status *status)
{
    Modes modes = {.length = beam->length,
                   .speed = speed,
                   .from_tip = beam->from_tip,
                   .stiffness = beam->youngs_modulus * beam->height * beam->height / (12 * beam->density)};
    if (!build_modes(&modes, status))
        return NULL;
    /* the fastest mode is fastest where the beam is shortest */
    double shortest = fmin(beam->length, beam->length + speed * end);
    double fastest = sqrt(modes.stiffness) * math_pow(modes.lambda[MODES - 1] / shortest, 2);
    double spacing = 2 * M_PI / fastest / SAMPLES_PER_FAST_PERIOD;
    double steps = ceil(fmax(1, end / spacing));
    if (!(steps <= SAMPLES_MAX))
        return status_refuse(
                   status,
                   "time.end: the exact motion until %g s is that of %.3g oscillations (at most %.3g)", end,
                   steps / SAMPLES_PER_FAST_PERIOD, SAMPLES_MAX / SAMPLES_PER_FAST_PERIOD),
               NULL;
    size_t count = (size_t)steps + 1;
    const bool tells_sections = count <= MODAL_SAMPLES_MAX;
    MovingCantilever *solution = malloc(sizeof *solution + count * sizeof solution->samples[0]);
    if (solution)
        solution->modal = tells_sections ? malloc(count * sizeof *solution->modal) : NULL;
    if (!solution || (tells_sections && !solution->modal)) {
        free(solution);
        status_fail(status, "not enough memory for the moving cantilever");
        return NULL;
    }
    solution->modes = modes;
    /* a beam that comes out is sampled at times that do not depend on the end: the same digits whether the
     * motion is asked for until then or for longer */
    solution->step = end > 0 && speed < 0 ? end / steps : spacing;
    solution->end = end;
    solution->count = end > 0 ? count : 1;
    if (!integrate_motion(&modes, beam, solution, status)) {
        moving_cantilever_free(solution);
        return NULL;
    }
    return solution;
}

MovingCantilever *moving_cantilever_solve(const BeamTheory *beam, double speed, double end, Status *status)
{
    const double positive[] = {beam->length, beam->height, beam->youngs_modulus, beam->density};
    MovingCantilever *solution = NULL;
    bool sound = true;
    for (size_t i = 0; i < sizeof positive / sizeof *positive; i++)
        sound = sound && positive[i] > 0 && isfinite(positive[i]);
    gsl_errors_off();
    if (!sound)
        status_refuse(status, "length, height, Young's modulus and density of a beam must be above 0");
    else if (!(end >= 0) || !isfinite(end) || !isfinite(speed) || !isfinite(beam->amplitude))
        status_refuse(status, "no moving cantilever until t = %g at speed %g", end, speed);
    else if (!(beam->length + speed * end > 0))
        status_refuse(status, "the cantilever has no length left at t = %g (speed %g)", end, speed);
    else
        solution = solve(beam, speed, end, status);
    gsl_errors_on();
    return solution;
}

void moving_cantilever_free(MovingCantilever *solution)
{
    if (solution)
        free(solution->modal);
    free(solution);
}

/* --- between the samples ------------------------------------------------------------------------- */

/* The sample before a time, and how far behind it the time lies, in samples. */
static double sample_before(const MovingCantilever *solution, double t, size_t *k)
{
    t = fmin(fmax(t, 0), solution->end);
    const double place = fmin(t / solution->step, (double)(solution->count - 1));
    *k = (size_t)place;
    if (*k + 1 >= solution->count)
        *k = solution->count > 1 ? solution->count - 2 : 0;
    return place - (double)*k;
}

/* The quintic p(u), u = (t - t_k)/h, that has displacement, velocity and acceleration of the samples at both
 * its ends; coefficients from u^0 to u^5. From p(1), p'(1) and p''(1) less what the first three coefficients
 * give,
 *
 *     c_3 = 10 r - 4 s + q,   c_4 = -15 r + 7 s - 2 q,   c_5 = 6 r - 3 s + q
 *
 * with r, s and q called rise, turn and bend here. Its error is at most h^6/46080 max|w^(6)|: with 16 samples
 * a period 1e-7 of the amplitude of the fastest mode, which hardly moves. Returns u. */
static double quintic(const MovingCantilever *solution, double t, double coefficients[6])
{
    size_t k;
    const double u = sample_before(solution, t, &k);
    const Tip *from = &solution->samples[k];
    const Tip *to = solution->count > 1 ? from + 1 : from;
    double h = solution->step;
    double v0 = from->velocity * h, v1 = to->velocity * h;
    double a0 = from->acceleration * h * h / 2, a1 = to->acceleration * h * h / 2;
    double rise = to->displacement - from->displacement - v0 - a0;
    double turn = v1 - v0 - 2 * a0;
    double bend = a1 - a0;
    coefficients[0] = from->displacement, coefficients[1] = v0, coefficients[2] = a0;
    coefficients[3] = 10 * rise - 4 * turn + bend;
    coefficients[4] = -15 * rise + 7 * turn - 2 * bend;
    coefficients[5] = 6 * rise - 3 * turn + bend;
    return u;
}

double moving_cantilever_tip(const MovingCantilever *solution, double t)
{
    double c[6];
    double u = quintic(solution, t, c);
    return c[0] + u * (c[1] + u * (c[2] + u * (c[3] + u * (c[4] + u * c[5]))));
}

/* p'(u)/h. Times before 0 and behind the end are taken as these. */
double moving_cantilever_tip_velocity(const MovingCantilever *solution, double t)
{
    double c[6];
    double u = quintic(solution, t, c);
    double rate = c[1] + u * (2 * c[2] + u * (3 * c[3] + u * (4 * c[4] + u * 5 * c[5])));
    return rate / solution->step;
}

/* --- sections ------------------------------------------------------------------------------------- */

/* The cubic that has q_n and q_n' of the samples at both its ends. */
static double modal_at(const MovingCantilever *solution, size_t k, double u, int n)
{
    const double *from = solution->modal[k], *to = solution->modal[solution->count > 1 ? k + 1 : k];
    const double h = solution->step, v = 1 - u;
    return v * v * ((1 + 2 * u) * from[n] + u * h * from[MODES + n]) +
           u * u * ((1 + 2 * v) * to[n] - v * h * to[MODES + n]);
}

/* w'' or w''' (derivative 2 or 3) at a distance from the root, sum q_n phi_n''(s)/L^2 and so on. What is in
 * the channel, before the root, is straight. */
static double bent(const MovingCantilever *solution, int derivative, double x, double t)
{
    if (!solution->modal)
        return NAN;
    size_t k;
    const double u = sample_before(solution, t, &k);
    const double length = solution->modes.length + solution->modes.speed * fmin(fmax(t, 0), solution->end);
    if (x < 0 || x > length * (1 + 1e-9))
        return x < 0 ? 0 : NAN;
    double sum = 0;
    for (int n = 0; n < MODES; n++)
        sum += modal_at(solution, k, u, n) *
               mode_derivative(solution->modes.lambda[n], derivative, fmin(x / length, 1));
    return sum / math_pow(length, derivative);
}

/* sxx = -M y/I = -E y w''. */
double moving_cantilever_bending_stress(const MovingCantilever *solution, const BeamTheory *beam, double x,
                                        double y, double t)
{
    return -beam->youngs_modulus * y * bent(solution, 2, x, t);
}

/* From dsxx/dx + dsxy/dy = 0 and no stress at the edges: sxy = -E w''' h^2/8 (1 - (2 y/h)^2), which is
 * -3 Q/(2 A) in the middle. */
double moving_cantilever_shear_stress(const MovingCantilever *solution, const BeamTheory *beam, double x,
                                      double y, double t)
{
    const double share = 2 * y / beam->height;
    return -beam->youngs_modulus * bent(solution, 3, x, t) * beam->height * beam->height / 8 *
           (1 - share * share);
}
