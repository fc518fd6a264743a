/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "theory/bar_modes.h"

#include "base/assertion.h"
#include "base/math/functions.h"

#include <math.h>

/* The bar as its phase sees it: the time that a wave takes through each part, and Z_2/Z_1. */
typedef struct Way {
    double first, through[2], ratio; /* first: theta at the left end */
} Way;

static Way way_of(const BarTheory *bar)
{
    const double c1 = sqrt(bar->youngs_modulus / bar->density),
                 c2 = sqrt(bar->joint_modulus / bar->joint_density);
    return (Way){.first = bar->left_fixed ? 0 : M_PI / 2,
                 .through = {bar->joint / c1, (bar->length - bar->joint) / c2},
                 .ratio = sqrt(bar->joint_modulus * bar->joint_density) /
                          sqrt(bar->youngs_modulus * bar->density)};
}

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

BarMode bar_modes_of_two(const BarTheory *bar, double growth)
{
    ASSERT_REAL(bar->joint, >, 0);
    ASSERT_REAL(bar->joint, <, bar->length);
    const Way way = way_of(bar);
    BarMode mode = {.joint = bar->joint};
    mode.frequency = find_frequency(&way, growth);
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

double bar_modes_shape(const BarMode *mode, double x)
{
    const int i = x > mode->joint;
    return mode->part[i].size * math_sin(phase_at(mode, i, x));
}

double bar_modes_slope(const BarMode *mode, double x)
{
    const int i = x > mode->joint;
    return mode->part[i].size * mode->part[i].wave_number * math_cos(phase_at(mode, i, x));
}

static double end_of(const BarTheory *bar, int i)
{
    return i ? bar->length : bar->joint;
}

static double density_of(const BarTheory *bar, int i)
{
    return i ? bar->joint_density : bar->density;
}

/* int size sin(phase + k x) dx = size (cos(at its beginning) - cos(at its end))/k */
double bar_modes_mean(const BarTheory *bar, const BarMode *mode)
{
    double momentum = 0, mass = 0;
    for (int i = 0; i < 2; i++) {
        const double rho = density_of(bar, i), from = mode->part[i].from, to = end_of(bar, i);
        momentum += rho * mode->part[i].size *
                    (math_cos(phase_at(mode, i, from)) - math_cos(phase_at(mode, i, to))) /
                    mode->part[i].wave_number;
        mass += rho * (to - from);
    }
    return momentum / mass;
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

double bar_modes_share(const BarTheory *bar, const BarMode *mode, double beta, double phase)
{
    double both = 0, own = 0;
    for (int i = 0; i < 2; i++) {
        const double from = mode->part[i].from, to = end_of(bar, i), middle = (from + to) / 2;
        const double k = mode->part[i].wave_number, at = phase_at(mode, i, middle);
        const double size = mode->part[i].size, weight = density_of(bar, i) * size;
        both += weight * product(at, k, phase + beta * middle, beta, to - from);
        own += weight * size * product(at, k, at, k, to - from);
    }
    return both / own;
}
