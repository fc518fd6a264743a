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

#include "base/math/functions.h"

#include <math.h>

/* The modes of a bar of two materials, exactly.
 *
 * In each material mode n is a sine of wave number k = omega/c, and at the joint velocity and stress are the
 * same on both sides. Written as v = r sin(theta), stress = Z omega r cos(theta), Z = sqrt(E rho), the phase
 * theta grows along a material by omega l/c, and at the joint r changes and theta within its quadrant:
 *
 *     tan(theta_2) = (Z_2/Z_1) tan(theta_1),   r_2^2 = r_1^2 (sin^2 theta_1 + (Z_1/Z_2)^2 cos^2 theta_1)
 *
 * From pi/2 at a free left end, 0 at a fixed one, theta must come to a multiple of pi at a fixed right end
 * and pi/2 beside it at a free one: mode n is where it has grown by beta_n L, as much as in a bar of one
 * material. Fixed-free that is Z_1 cos(k_1 l_1) cos(k_2 l_2) = Z_2 sin(k_1 l_1) sin(k_2 l_2). Theta grows
 * with omega, so that there is one omega for each n. Units: any consistent system. */

/* In part i phi = size sin(phase + wave_number (x - from)); the greatest |phi| is 1. */
typedef struct BarMode {
    double frequency; /* radians per unit time, to about 1e-15 of it */
    struct {
        double from, wave_number, phase, size;
    } part[2];
} BarMode;

/* The bar as its phase sees it: the time that a wave takes through each part, and Z_2/Z_1. */
typedef struct Way {
    double first, through[2], ratio; /* first: theta at the left end */
} Way;

/* theta behind the joint from that before it: in the same quadrant, tan(theta_2) = q tan(theta). */
static double across(double q, double theta)
{
    const double s = math_sin(theta), c = math_cos(theta);
    return theta + math_atan2((q - 1) * s * c, c * c + q * s * s);
}

/* How much theta has grown at the right end, and its derivative by omega. */
static double growth_at(const Way *way, double omega, double *slope)
{
    const double theta = way->first + omega * way->through[0];
    const double s = math_sin(theta), c = math_cos(theta), q = way->ratio;
    *slope = q / (c * c + q * q * s * s) * way->through[0] + way->through[1];
    return across(q, theta) - way->first + omega * way->through[1];
}

/* Of that growth by Newton's method between bounds: the joint moves theta by less than pi/2. */
static double find_frequency(const Way *way, double wanted)
{
    enum { TURNS = 200 };
    const double whole = way->through[0] + way->through[1];
    double low = fmax(0, wanted - M_PI / 2) / whole, high = (wanted + M_PI / 2) / whole;
    double omega = wanted / whole;
    for (int turn = 0; turn < TURNS; turn++) {
        double slope;
        const double error = growth_at(way, omega, &slope) - wanted, next = omega - error / slope;
        if (fabs(next - omega) <= 2e-16 * omega)
            return next;
        if (error > 0)
            high = omega;
        else
            low = omega;
        omega = next > low && next < high ? next : (low + high) / 2;
    }
    return omega;
}

/* The greatest |sin| from one phase to a later one: 1 where a crest lies between. */
static double crest(double from, double to)
{
    return floor(to / M_PI - 0.5) >= ceil(from / M_PI - 0.5) ? 1
                                                             : fmax(fabs(math_sin(from)), fabs(math_sin(to)));
}

/* Mode n >= 1 of a bar with a joint, whose phase grows by beta_n L. */
static BarMode mode_of_two(const BarTheory *bar, int number)
{
    ASSERT_REAL(bar->joint, >, 0);
    ASSERT_REAL(bar->joint, <, bar->length);
    const double c1 = bar_wave_speed(bar), c2 = sqrt(bar->joint_modulus / bar->joint_density);
    const Way way = {.first = bar->left_fixed ? 0 : M_PI / 2,
                     .through = {bar->joint / c1, (bar->length - bar->joint) / c2},
                     .ratio = sqrt(bar->joint_modulus * bar->joint_density) /
                              sqrt(bar->youngs_modulus * bar->density)};
    BarMode mode = {.frequency = find_frequency(&way, bar_wave_number(bar, number) * bar->length)};
    for (int i = 0; i < 2; i++) {
        mode.part[i].from = i ? bar->joint : 0;
        mode.part[i].wave_number =
            mode.frequency * way.through[i] / (i ? bar->length - bar->joint : bar->joint);
    }
    const double met = way.first + mode.frequency * way.through[0];
    mode.part[0].phase = way.first;
    mode.part[1].phase = across(way.ratio, met);
    const double beyond = math_hypot(math_sin(met), math_cos(met) / way.ratio);
    const double most =
        fmax(crest(way.first, met),
             beyond * crest(mode.part[1].phase, mode.part[1].phase + mode.frequency * way.through[1]));
    mode.part[0].size = 1 / most;
    mode.part[1].size = beyond / most;
    return mode;
}

static double phase_at(const BarMode *mode, int i, double x)
{
    return mode->part[i].phase + mode->part[i].wave_number * (x - mode->part[i].from);
}

static double end_of(const BarTheory *bar, int i)
{
    return i ? bar->length : bar->joint;
}

static double density_of(const BarTheory *bar, int i)
{
    return i ? bar->joint_density : bar->density;
}

/* int cos(u + w x) dx over a length about x = 0 */
static double cosine(double u, double w, double length)
{
    const double half = w * length / 2;
    return length * math_cos(u) * (fabs(half) > 1e-8 ? math_sin(half) / half : 1);
}

/* 2 sin a sin b = cos(a - b) - cos(a + b) */
static double product(double phase1, double k1, double phase2, double k2, double length)
{
    return (cosine(phase1 - phase2, k1 - k2, length) - cosine(phase1 + phase2, k1 + k2, length)) / 2;
}

/* Of one material, and what a run asks of either. */

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

double bar_largest_wave_number(const BarTheory *bar, int number)
{
    ASSERT_INT(number, >=, 0);
    if (!bar_is_layered(bar))
        return bar_wave_number(bar, number);
    return bar_frequency(bar, number) /
           fmin(bar_wave_speed(bar), sqrt(bar->joint_modulus / bar->joint_density));
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

/* Whether a mode is one of two materials, which is not a sine. */
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
    const int i = x > bar->joint;
    return mode.part[i].size * math_sin(phase_at(&mode, i, x));
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
    const int i = x > bar->joint;
    return mode.part[i].size * mode.part[i].wave_number * math_cos(phase_at(&mode, i, x));
}

/* int rho phi dx / int rho dx; of one material (1 - cos beta L)/(beta L) left fixed, sin(beta L)/(beta L)
 * left free; 0 free-free, where the motion is none of the whole; of two by int size sin(phase + k x) dx =
 * size (cos(at its beginning) - cos(at its end))/k. */
double bar_mode_mean(const BarTheory *bar, int number)
{
    if (is_free_free(bar))
        return number < 1 ? 1 : 0;
    if (number < 1)
        return 0;
    double angle = bar_wave_number(bar, number) * bar->length;
    if (!is_of_two(bar, number))
        return (bar->left_fixed ? 1 - math_cos(angle) : math_sin(angle)) / angle;
    const BarMode mode = mode_of_two(bar, number);
    double momentum = 0, mass = 0;
    for (int i = 0; i < 2; i++) {
        const double rho = density_of(bar, i), from = mode.part[i].from, to = end_of(bar, i);
        momentum += rho * mode.part[i].size *
                    (math_cos(phase_at(&mode, i, from)) - math_cos(phase_at(&mode, i, to))) /
                    mode.part[i].wave_number;
        mass += rho * (to - from);
    }
    return momentum / mass;
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
    /* s = sin(phase + beta x), for cos(x) = sin(x + pi/2) */
    const BarMode mode = mode_of_two(bar, number);
    const double beta = bar_wave_number(bar, start), phase = bar->left_fixed ? 0 : M_PI / 2;
    double both = 0, own = 0;
    for (int i = 0; i < 2; i++) {
        const double from = mode.part[i].from, to = end_of(bar, i), middle = (from + to) / 2;
        const double k = mode.part[i].wave_number, at = phase_at(&mode, i, middle);
        const double size = mode.part[i].size, weight = density_of(bar, i) * size;
        both += weight * product(at, k, phase + beta * middle, beta, to - from);
        own += weight * size * product(at, k, at, k, to - from);
    }
    return both / own;
}

/* The static displacement under the loads, 0 <= x <= L: E w'' = -rho b with w = 0 or E w' = t at the ends.
 *
 *     fixed-fixed   rho b/E x (L - x)/2
 *     fixed-free    rho b/E x (L - x/2) + t/E x
 *     free-fixed    rho b/E (L - x)(L + x)/2 - t/E (L - x)
 *     free-free     t/E (x - L/2), about the centre of mass; b is in the rigid motion */
typedef struct AtRest {
    double w, slope; /* w' */
} AtRest;

static AtRest rest_at(const BarTheory *bar, double x)
{
    double length = bar->length;
    double stretch = bar->traction / bar->youngs_modulus;
    double bend = bar->body_force * bar->density / bar->youngs_modulus;
    if (bar->left_fixed && bar->right_fixed)
        return (AtRest){bend * x * (length - x) / 2, bend * (length / 2 - x)};
    if (bar->left_fixed)
        return (AtRest){bend * x * (length - x / 2) + stretch * x, bend * (length - x) + stretch};
    if (bar->right_fixed)
        return (AtRest){bend * (length - x) * (length + x) / 2 - stretch * (length - x), stretch - bend * x};
    return (AtRest){stretch * (x - length / 2), stretch};
}

/* W and W' at x, which is the image of a point of the bar under reflections at the ends. A reflection at a
 * fixed end turns the sign of a displacement; an odd number of reflections that of slopes too. */
static AtRest continued(const BarTheory *bar, double x)
{
    double bars = floor(x / bar->length);
    double inside = x - bars * bar->length;
    /* to the right the right end is met first, to the left the left end */
    double met = bars < 0 ? -bars : bars;
    double first = ceil(met / 2), second = floor(met / 2);
    double left = bars < 0 ? first : second, right = bars < 0 ? second : first;
    bool flipped = (bar->left_fixed && fmod(left, 2) != 0) != (bar->right_fixed && fmod(right, 2) != 0);
    const double sign = flipped ? -1 : 1;
    const bool turned = fmod(met, 2) != 0;
    const AtRest there = rest_at(bar, turned ? bar->length - inside : inside);
    return (AtRest){sign * there.w, (turned ? -sign : sign) * there.slope};
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
        sum += rest_at(bar, x).w;
        sum -= (continued(bar, x - way).w + continued(bar, x + way).w) / 2;
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
        sum += c / 2 * (continued(bar, x - c * t).slope - continued(bar, x + c * t).slope);
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
        strain += rest_at(bar, x).slope;
        strain -= (continued(bar, x - way).slope + continued(bar, x + way).slope) / 2;
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
        double right = continued(bar, length - c * t).w - continued(bar, -c * t).w;
        double left = continued(bar, length + c * t).w - continued(bar, c * t).w;
        sum += c / (2 * length) * (right - left);
        sum += is_free_free(bar) ? bar->body_force * t : 0;
    }
    return sum;
}
