/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The motion of a bar by its characteristics.
 *
 * In each material the motion is a wave to the right and one to the left, each of them constant along its
 * way:
 *
 *     v = f(x - ct) + g(x + ct)     stress = Z (g - f)     Z = rho c = sqrt(E rho)
 *
 * f at a place and time is f at the left end of its material, earlier by the way over c, or at t = 0, if it
 * began later; g likewise from the right. What goes out from an end follows from what comes in:
 *
 *     fixed end   v = 0              f = -g
 *     free end    stress = 0         f = g
 *     joint       v and stress are the same on both sides:
 *                 g1 = ((Z1 - Z2) f1 + 2 Z2 g2)/(Z1 + Z2)     f2 = (2 Z1 f1 + (Z2 - Z1) g2)/(Z1 + Z2)
 *
 * Integrals over time obey the same, with the integral along the first part of the way added; a displacement
 * is that of v, and the momentum changes by that of the stress at a fixed end. */
#include "theory/bar_waves.h"

#include <math.h>

/* One material of the bar, from left to right; without a joint the second is empty. */
typedef struct Part {
    double left, right, speed, impedance;
} Part;

typedef struct Waves {
    const BarTheory *bar;
    Part part[2];
    int parts;
} Waves;

static bool has_joint(const BarTheory *bar)
{
    return bar->joint > 0;
}

double bar_waves_modulus(const BarTheory *bar, double x)
{
    return has_joint(bar) && x > bar->joint ? bar->joint_modulus : bar->youngs_modulus;
}

double bar_waves_density(const BarTheory *bar, double x)
{
    return has_joint(bar) && x > bar->joint ? bar->joint_density : bar->density;
}

static Waves waves_of(const BarTheory *bar)
{
    Waves waves = {.bar = bar, .parts = has_joint(bar) ? 2 : 1};
    const double edges[] = {0, has_joint(bar) ? bar->joint : bar->length, bar->length};
    for (int i = 0; i < waves.parts; i++) {
        const double e = i ? bar->joint_modulus : bar->youngs_modulus;
        const double rho = i ? bar->joint_density : bar->density;
        waves.part[i] = (Part){edges[i], edges[i + 1], sqrt(e / rho), sqrt(e * rho)};
    }
    return waves;
}

static double duration(const Part *part)
{
    return (part->right - part->left) / part->speed;
}

bool bar_waves_known(const BarTheory *bar, double end)
{
    const Waves waves = waves_of(bar);
    if (!has_joint(bar))
        return true;
    if (bar->body_force != 0 || bar->traction != 0)
        return false;
    return end <= BAR_WAVES_DIVIDED * 2 * fmin(duration(&waves.part[0]), duration(&waves.part[1]));
}

double bar_waves_reflected(const BarTheory *bar)
{
    const Waves waves = waves_of(bar);
    const double z1 = waves.part[0].impedance, z2 = waves.part[waves.parts - 1].impedance;
    return (z1 - z2) / (z1 + z2);
}

double bar_waves_transmitted(const BarTheory *bar)
{
    return 1 + bar_waves_reflected(bar);
}

/* --- the start ------------------------------------------------------------------------------------ */

/* v = A exp(-((x - x0)/w)^2) */
static double pulse(const BarTheory *bar, double x)
{
    const double s = (x - bar->pulse.centre) / bar->pulse.width;
    return bar->pulse.velocity != 0 ? bar->pulse.velocity * exp(-s * s) : 0;
}

/* Its integral from the left end: A w sqrt(pi)/2 erf((x - x0)/w). */
static double pulse_until(const BarTheory *bar, double x)
{
    const double w = bar->pulse.width, half = sqrt(M_PI) / 2 * w * bar->pulse.velocity;
    if (bar->pulse.velocity == 0)
        return 0;
    return half * (erf((x - bar->pulse.centre) / w) + erf(bar->pulse.centre / w));
}

double bar_waves_start_velocity(const BarTheory *bar, double x)
{
    return bar_initial_velocity(bar, x) + pulse(bar, x);
}

double bar_waves_start_slope(const BarTheory *bar, double x)
{
    if (bar->pulse.velocity == 0)
        return bar_initial_slope(bar, x);
    const double s = (x - bar->pulse.centre) / bar->pulse.width;
    return bar_initial_slope(bar, x) - 2 * s / bar->pulse.width * pulse(bar, x);
}

double bar_waves_start_stress(const BarTheory *bar, double x)
{
    return -sqrt(bar_waves_modulus(bar, x) * bar_waves_density(bar, x)) * pulse(bar, x);
}

/* The modes are waves of the one material; of two they start as a velocity, half to each side. */
static double mode_share(const Waves *waves, double x)
{
    return waves->parts > 1 ? bar_initial_velocity(waves->bar, x) / 2 : 0;
}

/* int phi dx from the left end: (1 - cos beta x)/beta left fixed, sin(beta x)/beta left free; x of rigid
 * motion. */
static double mode_share_until(const Waves *waves, double x)
{
    const BarTheory *bar = waves->bar;
    double sum = 0;
    for (int i = 0; waves->parts > 1 && i < bar->n_modes; i++) {
        const double beta = bar_wave_number(bar, bar->modes[i].number);
        const double whole = !(beta > 0)       ? bar_mode_shape(bar, 0, x) * x
                             : bar->left_fixed ? (1 - cos(beta * x)) / beta
                                               : sin(beta * x) / beta;
        sum += bar->modes[i].velocity * whole / 2;
    }
    return sum;
}

/* --- along the characteristics -------------------------------------------------------------------- */

typedef enum Way { TO_RIGHT, TO_LEFT } Way;

/* A wave at (x, t), or its integral over time up to there. */
static double wave(const Waves *waves, int of, Way way, bool integral, double x, double t);

/* What goes out of an end or of the joint into the part at time t. */
static double outgoing(const Waves *waves, int of, Way way, bool integral, double t)
{
    const Part *part = &waves->part[of];
    const double at = way == TO_RIGHT ? part->left : part->right;
    const int beyond = way == TO_RIGHT ? of - 1 : of + 1;
    const Way back = way == TO_RIGHT ? TO_LEFT : TO_RIGHT;
    const double met = wave(waves, of, back, integral, at, t);
    if (beyond < 0 || beyond >= waves->parts) {
        const bool fixed = way == TO_RIGHT ? waves->bar->left_fixed : waves->bar->right_fixed;
        return fixed ? -met : met;
    }
    const double z = part->impedance, other = waves->part[beyond].impedance;
    return ((z - other) * met + 2 * other * wave(waves, beyond, way, integral, at, t)) / (z + other);
}

static double wave(const Waves *waves, int of, Way way, bool integral, double x, double t)
{
    const Part *part = &waves->part[of];
    const double c = part->speed, sign = way == TO_RIGHT ? 1 : -1;
    const double from = way == TO_RIGHT ? part->left : part->right, passed = fabs(x - from) / c;
    const double begun = x - sign * c * fmin(t, passed); /* where it was at t = 0, or the end */
    double sum = 0;
    if (integral) {
        sum = mode_share_until(waves, x) - mode_share_until(waves, begun);
        sum += way == TO_RIGHT ? pulse_until(waves->bar, x) - pulse_until(waves->bar, begun) : 0;
        sum *= sign / c;
    } else if (t <= passed) {
        sum = mode_share(waves, begun) + (way == TO_RIGHT ? pulse(waves->bar, begun) : 0);
    }
    return t <= passed ? sum : sum + outgoing(waves, of, way, integral, t - passed);
}

/* Of one material all comes back after four times the length: without so many such times, so that the way to
 * follow is short. */
static double shorten(const Waves *waves, double t)
{
    const double period = 4 * duration(&waves->part[0]);
    return waves->parts == 1 ? t - floor(t / period) * period : t;
}

static int part_at(const Waves *waves, double x)
{
    return waves->parts > 1 && x > waves->part[0].right;
}

/* Nothing but a pulse, or two materials, makes waves that bar.h does not know. */
static bool are_there(const BarTheory *bar)
{
    return bar->pulse.velocity != 0 || has_joint(bar);
}

/* Both waves at a place and time, or their integrals over time; 0 where there are none. */
typedef struct Both {
    double to_right, to_left, impedance;
    double left_out; /* of the time, in which the waves came back as they were */
} Both;

static Both both_at(const BarTheory *bar, bool integral, double x, double t)
{
    if (!are_there(bar))
        return (Both){0};
    const Waves waves = waves_of(bar);
    const double late = shorten(&waves, t);
    const int part = part_at(&waves, x);
    return (Both){wave(&waves, part, TO_RIGHT, integral, x, late),
                  wave(&waves, part, TO_LEFT, integral, x, late), waves.part[part].impedance, t - late};
}

double bar_waves_velocity(const BarTheory *bar, double x, double t)
{
    const double rest = has_joint(bar) ? 0 : bar_velocity(bar, x, t);
    const Both both = both_at(bar, false, x, t);
    return rest + both.to_right + both.to_left;
}

double bar_waves_stress(const BarTheory *bar, double x, double t)
{
    const double rest = has_joint(bar) ? 0 : bar_stress(bar, x, t);
    const Both both = both_at(bar, false, x, t);
    return rest + both.impedance * (both.to_left - both.to_right);
}

/* The mass, and the momentum at t = 0 of what goes by waves. */
static double mass_of(const BarTheory *bar)
{
    const double joint = has_joint(bar) ? bar->joint : bar->length;
    return bar->density * joint + bar->joint_density * (bar->length - joint);
}

static double start_momentum(const Waves *waves)
{
    double sum = 0;
    for (int i = 0; i < waves->parts; i++) {
        const Part *part = &waves->part[i];
        const double of_modes = mode_share_until(waves, part->right) - mode_share_until(waves, part->left);
        const double of_pulse = pulse_until(waves->bar, part->right) - pulse_until(waves->bar, part->left);
        sum += part->impedance / part->speed * (2 * of_modes + of_pulse);
    }
    return sum;
}

double bar_waves_displacement(const BarTheory *bar, double x, double t)
{
    const double rest = has_joint(bar) ? 0 : bar_displacement(bar, x, t);
    const Both both = both_at(bar, true, x, t);
    double drift = 0;
    if (both.left_out > 0 && !bar->left_fixed && !bar->right_fixed) {
        const Waves waves = waves_of(bar);
        drift = start_momentum(&waves) / mass_of(bar) * both.left_out;
    }
    return rest + drift + both.to_right + both.to_left;
}

/* int stress dt at an end. */
static double impulse_at(const Waves *waves, int part, double x, double t)
{
    return waves->part[part].impedance *
           (wave(waves, part, TO_LEFT, true, x, t) - wave(waves, part, TO_RIGHT, true, x, t));
}

double bar_waves_centre_velocity(const BarTheory *bar, double t)
{
    const double rest = has_joint(bar) ? 0 : bar_centre_velocity(bar, t);
    if (!are_there(bar))
        return rest;
    const Waves waves = waves_of(bar);
    const double late = shorten(&waves, t);
    double momentum = start_momentum(&waves);
    if (bar->left_fixed)
        momentum -= impulse_at(&waves, 0, 0, late);
    if (bar->right_fixed)
        momentum += impulse_at(&waves, waves.parts - 1, bar->length, late);
    return rest + momentum / mass_of(bar);
}
