/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The motion of one particle in one cell, by its invariant.
 *
 * v^2/2 + c^2 ((w - 1) e^w + 1) = v0^2/2 is a circle: with the root h of 2 ((w - 1) e^w + 1) that has the
 * sign of w,
 *
 *     c h = v0 sin(phi)     v = v0 cos(phi)     h h' = w e^w w'     so  dt = (dx/c) h/(w e^w) dphi
 *
 * and the period is the integral over a whole turn of a smooth function that comes back to itself: the sum of
 * equal parts converges faster than any power of their number. Between, the equations of motion are
 * integrated in equal steps of the period (Runge and Kutta's fourth order; a 4096th of a turn leaves 1e-12 at
 * the fastest, and far less else). */
#include "theory/large_strain.h"

#include "base/assertion.h"
#include "base/math/functions.h"

#include <math.h>

/* 2 ((w - 1) e^w + 1) = sum over k >= 2 of 2 (k - 1) w^k/k!; its first terms cancel in the closed form. */
static double twice_potential(double w)
{
    if (fabs(w) > 0.5)
        return 2 * ((w - 1) * math_exp(w) + 1);
    double sum = 0, term = w;
    for (int k = 2; k < 24; k++) {
        term *= w / k;
        sum += 2 * (k - 1) * term;
    }
    return sum;
}

/* The strain whose h is given, by Newton's rule: h' = w e^w / h. */
static double strain_of_root(double h)
{
    double w = h;
    if (h == 0)
        return 0;
    for (int i = 0; i < 60; i++) {
        const double root = copysign(sqrt(twice_potential(w)), w),
                     step = (root - h) * root / (w * math_exp(w));
        w -= step;
        if (fabs(step) <= 1e-16 * fabs(w))
            break;
    }
    return w;
}

/* int (dx/c) h/(w e^w) dphi over a turn */
static double period_of(const Oscillator *oscillator)
{
    enum { PARTS = 512 };
    double sum = 0;
    for (int i = 0; i < PARTS; i++) {
        const double phi = 2 * M_PI * (i + 0.5) / PARTS;
        const double h = oscillator->velocity / oscillator->speed * math_sin(phi), w = strain_of_root(h);
        sum += h / (w * math_exp(w));
    }
    return oscillator->cell / oscillator->speed * 2 * M_PI * sum / PARTS;
}

static double acceleration(const Oscillator *oscillator, double w)
{
    return -oscillator->speed * oscillator->speed / oscillator->cell * w * math_exp(w);
}

static void advance(const Oscillator *oscillator, double time, double *w, double *v)
{
    const double dx = oscillator->cell;
    const double w1 = *v / dx, v1 = acceleration(oscillator, *w);
    const double w2 = (*v + time / 2 * v1) / dx, v2 = acceleration(oscillator, *w + time / 2 * w1);
    const double w3 = (*v + time / 2 * v2) / dx, v3 = acceleration(oscillator, *w + time / 2 * w2);
    const double w4 = (*v + time * v3) / dx, v4 = acceleration(oscillator, *w + time * w3);
    *w += time / 6 * (w1 + 2 * w2 + 2 * w3 + w4);
    *v += time / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
}

bool oscillator_make(Oscillator *oscillator, double cell, double speed, double velocity)
{
    ASSERT_REAL(cell, >, 0);
    ASSERT_REAL(speed, >, 0);
    oscillator->cell = cell;
    oscillator->speed = speed;
    oscillator->velocity = velocity;
    oscillator->period = 2 * M_PI * cell / speed;
    if (!(fabs(velocity) <= speed))
        return false;
    if (velocity != 0)
        oscillator->period = period_of(oscillator);
    double w = 0, v = velocity;
    for (int i = 0; i < OSCILLATOR_TABLE; i++) {
        oscillator->table[i].strain = w;
        oscillator->table[i].velocity = v;
        advance(oscillator, oscillator->period / OSCILLATOR_TABLE, &w, &v);
    }
    return true;
}

void oscillator_at(const Oscillator *oscillator, double time, double *strain, double *velocity)
{
    ASSERT_REAL(time, >=, 0);
    ASSERT_REAL(oscillator->period, >, 0);
    const double part = oscillator->period / OSCILLATOR_TABLE, rest = fmod(time, oscillator->period);
    int i = (int)(rest / part);
    i = i < OSCILLATOR_TABLE ? i : OSCILLATOR_TABLE - 1;
    *strain = oscillator->table[i].strain;
    *velocity = oscillator->table[i].velocity;
    advance(oscillator, rest - i * part, strain, velocity);
}

double oscillator_energy(const Oscillator *oscillator, double strain, double velocity)
{
    return (velocity * velocity + oscillator->speed * oscillator->speed * twice_potential(strain)) / 2;
}

/* The bar at rest under its own weight: with k = rho b/E the strain ln(dx/dX) is k (L - X), so that
 *
 *     x = int e^{k (L - X)} dX = (e^{kL} - e^{k (L - X)})/k
 *     mean of x over the bar   = (e^{kL} - (e^{kL} - 1)/(kL))/k */

static double rate(const HangingColumn *column)
{
    ASSERT_REAL(column->youngs_modulus, >, 0);
    return column->density * column->body_force / column->youngs_modulus;
}

double hanging_column_stress(const HangingColumn *column, double x)
{
    return column->density * column->body_force * (column->length - x);
}

/* The difference of the exponentials without cancelling: e^{k (L - X)} (e^{kX} - 1). */
double hanging_column_displacement(const HangingColumn *column, double x)
{
    const double k = rate(column);
    return k == 0 ? 0 : math_exp(k * (column->length - x)) * math_expm1(k * x) / k - x;
}

double hanging_column_linear(const HangingColumn *column, double x)
{
    return rate(column) * x * (column->length - x / 2);
}

double hanging_column_centre(const HangingColumn *column)
{
    const double k = rate(column), kl = k * column->length;
    if (fabs(kl) < 1e-4) /* by its series, as the closed form cancels */
        return column->length * (0.5 + kl / 3 + kl * kl / 8);
    return (math_exp(kl) - math_expm1(kl) / kl) / k;
}
