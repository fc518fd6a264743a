/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The exact solution for the bar as a continuum.
 *
 *     u_tt = c^2 u_xx + b,   u = 0 at a fixed end,   E u_x = t at a free end
 *     u = 0,   u_t = sum A phi at t = 0
 *
 * Vibration and load are superposed. The load's part is its static displacement w(x) less the free motion
 * that starts at rest from w, which d'Alembert gives: u = w(x) - (W(x - ct) + W(x + ct))/2, where W continues
 * w beyond the ends, oddly about a fixed end and evenly about a free one. Nothing holds the free-free bar:
 * there the body force accelerates it as a whole, u = b t^2/2, and only the traction stretches it. */
#include "theory/elastic_bar.h"
#include "base/assertion.h"
#include "theory/bar_modes.h"

#include "base/math/functions.h"

#include <math.h>

bool bar_is_layered(const BarTheory *bar)
{
    return bar->joint > 0 &&
           (bar->joint_modulus != bar->youngs_modulus || bar->joint_density != bar->density);
}

static bool is_beyond(const BarTheory *bar, double x)
{
    return bar->joint > 0 && x > bar->joint;
}

double bar_modulus_at(const BarTheory *bar, double x)
{
    return is_beyond(bar, x) ? bar->joint_modulus : bar->youngs_modulus;
}

double bar_density_at(const BarTheory *bar, double x)
{
    return is_beyond(bar, x) ? bar->joint_density : bar->density;
}

static bool is_free_free(const BarTheory *bar)
{
    return !bar->left_fixed && !bar->right_fixed;
}

double bar_wave_speed(const BarTheory *bar)
{
    return sqrt(bar->youngs_modulus / bar->density);
}

static double speed_beyond(const BarTheory *bar)
{
    return bar->joint > 0 ? sqrt(bar->joint_modulus / bar->joint_density) : bar_wave_speed(bar);
}

/* beta_n: (2n - 1) pi/2L with one free end, n pi/L with two equal ends; paper M's eq. 17 with L as a
 * length. */
double bar_wave_number(const BarTheory *bar, int number)
{
    ASSERT_INT(number, >=, 0);
    if (number < 1)
        return 0;
    bool one_free_end = bar->left_fixed != bar->right_fixed;
    return (one_free_end ? number - 0.5 : number) * M_PI / bar->length;
}

static BarMode mode_of_two(const BarTheory *bar, int number)
{
    return bar_modes_of_two(bar, bar_wave_number(bar, number) * bar->length);
}

double bar_largest_wave_number(const BarTheory *bar, int number)
{
    ASSERT_INT(number, >=, 0);
    return bar_is_layered(bar) ? bar_frequency(bar, number) / fmin(bar_wave_speed(bar), speed_beyond(bar))
                               : bar_wave_number(bar, number);
}

double bar_frequency(const BarTheory *bar, int number)
{
    ASSERT_INT(number, >=, 0);
    if (bar_is_layered(bar) && number > 0)
        return mode_of_two(bar, number).frequency;
    return bar_wave_number(bar, number) * bar_wave_speed(bar);
}

/* phi_n = sin beta_n x with the left end fixed, cos beta_n x with it free (eq. 16); mode 0 of the
 * free-free bar is rigid motion. */
static double sine_shape(const BarTheory *bar, int number, double x)
{
    if (number < 1)
        return is_free_free(bar) ? 1 : 0;
    double phase = bar_wave_number(bar, number) * x;
    return bar->left_fixed ? math_sin(phase) : math_cos(phase);
}

/* Whether a mode is one of two materials, which is no sine. */
static bool is_of_two(const BarTheory *bar, int number)
{
    return number > 0 && bar_is_layered(bar);
}

double bar_mode_shape(const BarTheory *bar, int number, double x)
{
    ASSERT_INT(number, >=, 0);
    if (!is_of_two(bar, number))
        return sine_shape(bar, number, x);
    const BarMode mode = mode_of_two(bar, number);
    return bar_modes_shape(&mode, x);
}

double bar_start_shape(const BarTheory *bar, int number, double x)
{
    ASSERT_INT(number, >=, 0);
    return bar->of_sines ? sine_shape(bar, number, x) : bar_mode_shape(bar, number, x);
}

/* The slope of sine_shape() */
static double sine_slope(const BarTheory *bar, int number, double x)
{
    double beta = bar_wave_number(bar, number);
    return bar->left_fixed ? beta * math_cos(beta * x) : -beta * math_sin(beta * x);
}

/* phi'(x) */
static double mode_slope(const BarTheory *bar, int number, double x)
{
    if (!is_of_two(bar, number))
        return sine_slope(bar, number, x);
    const BarMode mode = mode_of_two(bar, number);
    return bar_modes_slope(&mode, x);
}

/* int rho phi dx / int rho dx; of one material (1 - cos beta L)/(beta L) left fixed, sin(beta L)/(beta L)
 * left free; 0 free-free, where the motion is none of the whole. */
double bar_mode_mean(const BarTheory *bar, int number)
{
    if (is_free_free(bar))
        return number < 1 ? 1 : 0;
    if (number < 1)
        return 0;
    if (is_of_two(bar, number)) {
        const BarMode mode = mode_of_two(bar, number);
        return bar_modes_mean(bar, &mode);
    }
    double angle = bar_wave_number(bar, number) * bar->length;
    return (bar->left_fixed ? 1 - math_cos(angle) : math_sin(angle)) / angle;
}

double bar_initial_velocity(const BarTheory *bar, double x)
{
    double sum = 0;
    for (int i = 0; i < bar->n_modes; i++)
        sum += bar->modes[i].velocity * bar_start_shape(bar, bar->modes[i].number, x);
    return sum;
}

double bar_initial_slope(const BarTheory *bar, double x)
{
    double sum = 0;
    for (int i = 0; i < bar->n_modes; i++)
        sum +=
            bar->modes[i].velocity * (bar->of_sines ? sine_slope : mode_slope)(bar, bar->modes[i].number, x);
    return sum;
}

double bar_share_of_sine(const BarTheory *bar, int start, int number)
{
    ASSERT_INT(start, >=, 0);
    if (!is_of_two(bar, number))
        return start == number ? 1 : 0;
    const BarMode mode = mode_of_two(bar, number);
    /* cos(x) = sin(x + pi/2) */
    return bar_modes_share(bar, &mode, bar_wave_number(bar, start), bar->left_fixed ? 0 : M_PI / 2);
}

/* The static displacement under the loads, 0 <= x <= L: E w'' = -rho b with w = 0 or E w' = t at the ends.
 *
 *     fixed-fixed   rho b/E x (L - x)/2
 *     fixed-free    rho b/E x (L - x/2) + t/E x
 *     free-fixed    rho b/E (L - x)(L + x)/2 - t/E (L - x)
 *     free-free     t/E (x - L/2), about the centre of mass; b is in the rigid motion */
static double static_displacement(const BarTheory *bar, double x)
{
    double length = bar->length;
    double stretch = bar->traction / bar->youngs_modulus;
    double bend = bar->body_force * bar->density / bar->youngs_modulus;
    if (bar->left_fixed && bar->right_fixed)
        return bend * x * (length - x) / 2;
    if (bar->left_fixed)
        return bend * x * (length - x / 2) + stretch * x;
    if (bar->right_fixed)
        return bend * (length - x) * (length + x) / 2 - stretch * (length - x);
    return stretch * (x - length / 2);
}

static double static_slope(const BarTheory *bar, double x)
{
    double length = bar->length;
    double stretch = bar->traction / bar->youngs_modulus;
    double bend = bar->body_force * bar->density / bar->youngs_modulus;
    if (bar->left_fixed && bar->right_fixed)
        return bend * (length / 2 - x);
    if (bar->left_fixed)
        return bend * (length - x) + stretch;
    if (bar->right_fixed)
        return stretch - bend * x;
    return stretch;
}

/* The point of the bar whose image x is under reflections at the ends: W(x) = *sign w(result). A reflection
 * at a fixed end turns the sign of a displacement; *turned: an odd number of reflections, slopes change
 * theirs too. */
static double fold(const BarTheory *bar, double x, double *sign, bool *turned)
{
    double bars = floor(x / bar->length);
    double inside = x - bars * bar->length;
    /* to the right the right end is met first, to the left the left end */
    double met = bars < 0 ? -bars : bars;
    double first = ceil(met / 2), second = floor(met / 2);
    double left = bars < 0 ? first : second, right = bars < 0 ? second : first;
    bool flipped = (bar->left_fixed && fmod(left, 2) != 0) != (bar->right_fixed && fmod(right, 2) != 0);
    *sign = flipped ? -1 : 1;
    *turned = fmod(met, 2) != 0;
    return *turned ? bar->length - inside : inside;
}

static double continued_displacement(const BarTheory *bar, double x)
{
    double sign;
    bool turned;
    double inside = fold(bar, x, &sign, &turned);
    return sign * static_displacement(bar, inside);
}

static double continued_slope(const BarTheory *bar, double x)
{
    double sign;
    bool turned;
    double inside = fold(bar, x, &sign, &turned);
    return (turned ? -sign : sign) * static_slope(bar, inside);
}

static bool is_loaded(const BarTheory *bar)
{
    return bar->body_force != 0 || bar->traction != 0;
}

/* sum A phi sin(omega t)/omega + w(x) - (W(x - ct) + W(x + ct))/2, free-free + b t^2/2. */
double bar_displacement(const BarTheory *bar, double x, double t)
{
    double sum = 0;
    for (int i = 0; i < bar->n_modes; i++) {
        double omega = bar_frequency(bar, bar->modes[i].number);
        double shape = bar_mode_shape(bar, bar->modes[i].number, x);
        /* a rigid motion has no frequency: sin(omega t)/omega becomes t */
        sum += bar->modes[i].velocity * shape * (omega > 0 ? math_sin(omega * t) / omega : t);
    }
    if (is_loaded(bar)) {
        double way = bar_wave_speed(bar) * t;
        sum += static_displacement(bar, x);
        sum -= (continued_displacement(bar, x - way) + continued_displacement(bar, x + way)) / 2;
        sum += is_free_free(bar) ? bar->body_force * t * t / 2 : 0;
    }
    return sum;
}

/* Its derivative by t: sum A phi cos(omega t) + c (W'(x - ct) - W'(x + ct))/2. */
double bar_velocity(const BarTheory *bar, double x, double t)
{
    double sum = 0;
    for (int i = 0; i < bar->n_modes; i++) {
        int number = bar->modes[i].number;
        sum += bar->modes[i].velocity * bar_mode_shape(bar, number, x) *
               math_cos(bar_frequency(bar, number) * t);
    }
    if (is_loaded(bar)) {
        double c = bar_wave_speed(bar);
        sum += c / 2 * (continued_slope(bar, x - c * t) - continued_slope(bar, x + c * t));
        sum += is_free_free(bar) ? bar->body_force * t : 0;
    }
    return sum;
}

/* E u_x: E sum A phi' sin(omega t)/omega + E (w' - (W'(x - ct) + W'(x + ct))/2). */
double bar_stress(const BarTheory *bar, double x, double t)
{
    double strain = 0;
    for (int i = 0; i < bar->n_modes; i++) {
        int number = bar->modes[i].number;
        double omega = bar_frequency(bar, number);
        if (omega > 0)
            strain += bar->modes[i].velocity * mode_slope(bar, number, x) * math_sin(omega * t) / omega;
    }
    if (is_loaded(bar)) {
        double way = bar_wave_speed(bar) * t;
        strain += static_slope(bar, x);
        strain -= (continued_slope(bar, x - way) + continued_slope(bar, x + way)) / 2;
    }
    return bar_modulus_at(bar, x) * strain;
}

/* Eq. 20 for each mode, A mbar cos(omega t), mbar its mean over the bar; the load's part in closed form. */
double bar_centre_velocity(const BarTheory *bar, double t)
{
    double sum = 0;
    for (int i = 0; i < bar->n_modes; i++) {
        int number = bar->modes[i].number;
        sum += bar->modes[i].velocity * bar_mode_mean(bar, number) * math_cos(bar_frequency(bar, number) * t);
    }
    if (is_loaded(bar)) {
        /* int W'(x -+ ct) dx over the bar is a difference of two values of W */
        double c = bar_wave_speed(bar), length = bar->length;
        double right = continued_displacement(bar, length - c * t) - continued_displacement(bar, -c * t);
        double left = continued_displacement(bar, length + c * t) - continued_displacement(bar, c * t);
        sum += c / (2 * length) * (right - left);
        sum += is_free_free(bar) ? bar->body_force * t : 0;
    }
    return sum;
}
