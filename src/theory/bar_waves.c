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
 * is that of v, and the momentum changes by that of the stress at a fixed end.
 *
 * What leaves the joint at t comes of what left it a way to and fro earlier, and of the start before that. So
 * of two materials it is worked out for the times t - i tau_1 - j tau_2, the earliest first: each division is
 * met once, though 2^n ways lead through n of them. */
#include "theory/bar_waves.h"

#include "base/assertion.h"
#include "base/math/functions.h"

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

static Waves waves_of(const BarTheory *bar)
{
    Waves waves = {.bar = bar, .parts = bar_is_layered(bar) ? 2 : 1};
    const double edges[] = {0, waves.parts == 2 ? bar->joint : bar->length, bar->length};
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

/* Modes of the bar, and loads, are elastic_bar.h's; sines on two materials are none, and start as a velocity,
 * half to each side. */
static bool are_waves(const BarTheory *bar)
{
    return bar_is_layered(bar) && bar->of_sines;
}

/* Nothing but a pulse, or such sines, makes waves that elastic_bar.h does not know. */
static bool are_there(const BarTheory *bar)
{
    return bar->pulse.velocity != 0 || are_waves(bar);
}

/* How many pairs (i, j) there are at most, in both directions. */
static void count_ways(const Waves *waves, double t, double counts[2])
{
    for (int i = 0; i < 2; i++)
        counts[i] = floor(t / (2 * duration(&waves->part[i]))) + 1;
}

static bool is_within_reach(const Waves *waves, double t)
{
    double counts[2];
    if (waves->parts == 1)
        return true;
    count_ways(waves, t, counts);
    return counts[0] * counts[1] <= BAR_WAVES_MOST;
}

bool bar_waves_known(const BarTheory *bar, double end)
{
    ASSERT_REAL(end, >=, 0);
    const Waves waves = waves_of(bar);
    if (bar_is_layered(bar) && (bar->body_force != 0 || bar->traction != 0))
        return false;
    return !are_there(bar) || is_within_reach(&waves, end);
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
    return bar->pulse.velocity != 0 ? bar->pulse.velocity * math_exp(-s * s) : 0;
}

/* Its integral from the left end: A w sqrt(pi)/2 erf((x - x0)/w). */
static double pulse_until(const BarTheory *bar, double x)
{
    const double w = bar->pulse.width, half = sqrt(M_PI) / 2 * w * bar->pulse.velocity;
    if (bar->pulse.velocity == 0)
        return 0;
    return half * (math_erf((x - bar->pulse.centre) / w) + math_erf(bar->pulse.centre / w));
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
    const double impedance = sqrt(bar_modulus_at(bar, x) * bar_density_at(bar, x));
    return impedance * (2 * bar->pulse.to_left - 1) * pulse(bar, x);
}

/* int phi dx from the left end: (1 - cos beta x)/beta left fixed, sin(beta x)/beta left free; x of rigid
 * motion. */
static double mode_share_until(const Waves *waves, double x)
{
    const BarTheory *bar = waves->bar;
    double sum = 0;
    for (int i = 0; are_waves(bar) && i < bar->n_modes; i++) {
        const double beta = bar_wave_number(bar, bar->modes[i].number);
        const double whole = !(beta > 0)       ? bar_start_shape(bar, 0, x) * x
                             : bar->left_fixed ? (1 - math_cos(beta * x)) / beta
                                               : math_sin(beta * x) / beta;
        sum += bar->modes[i].velocity * whole / 2;
    }
    return sum;
}

/* --- along the characteristics -------------------------------------------------------------------- */

typedef enum Way { TO_RIGHT, TO_LEFT } Way;

static double edge_of(const Part *part, Way way)
{
    return way == TO_RIGHT ? part->right : part->left;
}

static Way opposite(Way way)
{
    return way == TO_RIGHT ? TO_LEFT : TO_RIGHT;
}

/* What an end makes of a velocity. */
static double sign_at(const Waves *waves, Way way)
{
    const bool fixed = way == TO_RIGHT ? waves->bar->right_fixed : waves->bar->left_fixed;
    return fixed ? -1 : 1;
}

/* How much of the pulse goes that way. */
static double pulse_share(const Waves *waves, Way way)
{
    return way == TO_LEFT ? waves->bar->pulse.to_left : 1 - waves->bar->pulse.to_left;
}

/* What is at x of the start itself: the wave from `begun`, or the integral over the time since. */
static double from_start(const Waves *waves, int of, Way way, bool integral, double x, double begun)
{
    const double c = waves->part[of].speed, sign = way == TO_RIGHT ? 1 : -1;
    if (!integral)
        return (are_waves(waves->bar) ? bar_initial_velocity(waves->bar, begun) / 2 : 0) +
               pulse_share(waves, way) * pulse(waves->bar, begun);
    double sum = mode_share_until(waves, x) - mode_share_until(waves, begun);
    sum += pulse_share(waves, way) * (pulse_until(waves->bar, x) - pulse_until(waves->bar, begun));
    return sum * sign / c;
}

/* What has come to the joint by t through part `of` and had not been there before: straight, then by the
 * end. It is all there after twice the duration. */
static double first_at_joint(const Waves *waves, int of, bool integral, double t)
{
    const Part *part = &waves->part[of];
    const Way way = of ? TO_LEFT : TO_RIGHT, back = opposite(way);
    const double joint = edge_of(part, way), end = edge_of(part, back), whole = duration(part);
    const double sign = way == TO_RIGHT ? 1 : -1, later = fmin(t - whole, whole);
    if (t <= whole)
        return from_start(waves, of, way, integral, joint, joint - sign * part->speed * t);
    const double by_end =
        sign_at(waves, back) * from_start(waves, of, back, integral, end, end + sign * part->speed * later);
    return integral ? from_start(waves, of, way, true, joint, end) + by_end : by_end;
}

/* What leaves the joint at t into both parts, from the earliest pair (i, j) to (0, 0): `row` has what left at
 * (i + 1, j) into the part whose way is the shorter, out[inner] what left at (i, j + 1) into the other. */
static void leaving_joint(const Waves *waves, bool integral, double t, double out[2])
{
    enum { ROW = 66 }; /* more than the root of BAR_WAVES_MOST: the inner ones are the fewer */
    _Static_assert((ROW - 1) * (ROW - 1) > BAR_WAVES_MOST, "a row has room");
    double counts[2], row[ROW];
    const Part *part = waves->part;
    const double z[2] = {part[0].impedance, part[1].impedance};
    const double back = (z[0] - z[1]) / (z[0] + z[1]); /* for the left part; for the right one its negative */
    const double on[2] = {1 - back, 1 + back};
    const double ways[2] = {2 * duration(&part[0]), 2 * duration(&part[1])};
    const int outer = ways[0] <= ways[1] ? 0 : 1, inner = 1 - outer;
    double all[2]; /* that comes to the joint from the start, and by an end */
    out[0] = out[1] = NAN;
    if (!is_within_reach(waves, t))
        return;
    count_ways(waves, t, counts);
    for (int k = 0; k < 2; k++)
        all[k] = integral ? first_at_joint(waves, k, true, ways[k]) : 0;
    int known = 0; /* of the row before */
    for (int i = (int)counts[outer]; i >= 0; i--) {
        const double at = t - i * ways[outer];
        int last = (int)counts[inner];
        while (last >= 0 && !(at - last * ways[inner] > 0))
            last--;
        for (int j = last; j >= 0; j--) {
            const double now = at - j * ways[inner];
            double met[2];
            met[outer] = j < known ? all[outer] + sign_at(waves, outer ? TO_RIGHT : TO_LEFT) * row[j]
                                   : first_at_joint(waves, outer, integral, fmin(now, ways[outer]));
            met[inner] = j < last ? all[inner] + sign_at(waves, inner ? TO_RIGHT : TO_LEFT) * out[inner]
                                  : first_at_joint(waves, inner, integral, fmin(now, ways[inner]));
            out[0] = back * met[0] + on[0] * met[1];
            out[1] = on[1] * met[0] - back * met[1];
            row[j] = out[outer];
        }
        known = last + 1;
    }
}

/* A wave at (x, t), or its integral over time up to there. */
static double wave(const Waves *waves, int of, Way way, bool integral, double x, double t)
{
    const Part *part = &waves->part[of];
    const Way back = opposite(way);
    const double c = part->speed, sign = way == TO_RIGHT ? 1 : -1;
    const double passed = fabs(x - edge_of(part, back)) / c;
    const double begun = x - sign * c * fmin(t, passed); /* where it was at t = 0, or the end */
    if (t <= passed)
        return from_start(waves, of, way, integral, x, begun);
    /* and what went out of an end or of the joint into the part */
    double out[2];
    if (waves->parts == 1 || (way == TO_RIGHT) == (of == 0))
        out[of] = sign_at(waves, back) * wave(waves, of, back, integral, edge_of(part, back), t - passed);
    else
        leaving_joint(waves, integral, t - passed, out);
    return (integral ? from_start(waves, of, way, true, x, begun) : 0) + out[of];
}

/* Of one material all comes back after four times the length: without so many such times, so that the way to
 * follow is short. */
static double shorten(const Waves *waves, double t)
{
    const double period = 4 * duration(&waves->part[0]);
    return waves->parts == 1 ? t - floor(t / period) * period : t;
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
    const int part = waves.parts > 1 && x > waves.part[0].right;
    return (Both){wave(&waves, part, TO_RIGHT, integral, x, late),
                  wave(&waves, part, TO_LEFT, integral, x, late), waves.part[part].impedance, t - late};
}

double bar_waves_velocity(const BarTheory *bar, double x, double t)
{
    const double rest = are_waves(bar) ? 0 : bar_velocity(bar, x, t);
    const Both both = both_at(bar, false, x, t);
    return rest + both.to_right + both.to_left;
}

double bar_waves_stress(const BarTheory *bar, double x, double t)
{
    const double rest = are_waves(bar) ? 0 : bar_stress(bar, x, t);
    const Both both = both_at(bar, false, x, t);
    return rest + both.impedance * (both.to_left - both.to_right);
}

/* The mass, and the momentum at t = 0 of what goes by waves. */
static double mass_of(const BarTheory *bar)
{
    const double joint = bar_is_layered(bar) ? bar->joint : bar->length;
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
    const double rest = are_waves(bar) ? 0 : bar_displacement(bar, x, t);
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
    ASSERT_REAL(t, >=, 0);
    const double rest = are_waves(bar) ? 0 : bar_centre_velocity(bar, t);
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
