/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a pulse on a bar is judged by (references.h, Finding): how far it is from the exact one, how high it
 * still is and how late; where it meets a second material, what comes back and what goes on. */
#include "answers/bar_answers.h"
#include "theory/bar_waves.h"

#include <math.h>
#include <stdlib.h>

enum { PARTICLES_READ = 4000 }; /* of a bar of more, so many, evenly */

/* Where particles were at t = 0, their velocity now, and the exact one. */
typedef struct Sample {
    const BarTheory *theory;
    double *x, *v, *exact;
    size_t count;
    double spacing, time;
} Sample;

static bool sample_take(Sample *sample, const BarTheory *theory, const Simulation *sim)
{
    const int x = simulation_find_field(sim, 0, "x0"), v = simulation_find_field(sim, 0, "v");
    const size_t all = sim->counts[0], stride = (all + PARTICLES_READ - 1) / PARTICLES_READ;
    *sample = (Sample){.theory = theory, .count = all / stride, .time = simulation_time(sim)};
    sample->spacing = theory->length / (double)all * (double)stride;
    sample->x = malloc(3 * sample->count * sizeof *sample->x);
    if (!sample->x || x < 0 || v < 0) {
        free(sample->x);
        return false;
    }
    sample->v = sample->x + sample->count;
    sample->exact = sample->v + sample->count;
    for (size_t i = 0; i < sample->count; i++) {
        sim->method->field(sim, x, i * stride, 1, &sample->x[i]);
        sim->method->field(sim, v, i * stride, 1, &sample->v[i]);
        sample->exact[i] = bar_waves_velocity(theory, sample->x[i], sample->time);
    }
    return true;
}

/* sqrt(sum (v - exact)^2 / sum exact^2) */
static double relative_distance(const Sample *sample)
{
    double off = 0, whole = 0;
    for (size_t i = 0; i < sample->count; i++) {
        off += (sample->v[i] - sample->exact[i]) * (sample->v[i] - sample->exact[i]);
        whole += sample->exact[i] * sample->exact[i];
    }
    return sqrt(off / whole);
}

static double largest(const double *values, size_t count)
{
    double most = 0;
    for (size_t i = 0; i < count; i++)
        most = fmax(most, fabs(values[i]));
    return most;
}

/* sum v(x) exact(x, t - delay): how well the run goes with the exact motion of a little earlier. */
static double likeness(const Sample *sample, double delay)
{
    double sum = 0;
    for (size_t i = 0; i < sample->count; i++)
        sum += sample->v[i] * bar_waves_velocity(sample->theory, sample->x[i], sample->time - delay);
    return sum;
}

/* The delay of the greatest likeness, over a width of the pulse and a half to both sides; then by a parabola.
 */
static double delay_of(const Sample *sample)
{
    enum { EACH_WAY = 12 };
    const double c = bar_wave_speed(sample->theory), step = 1.5 * sample->theory->pulse.width / c / EACH_WAY;
    double best = 0, most = -INFINITY, beside[3];
    for (int k = -EACH_WAY; k <= EACH_WAY; k++) {
        const double here = k * step <= sample->time ? likeness(sample, k * step) : -INFINITY;
        if (here > most)
            most = here, best = k * step;
    }
    for (double fine = step; fine > 1e-3 * step; fine /= 4) {
        for (int k = 0; k < 3; k++)
            beside[k] = likeness(sample, fmin(best + (k - 1) * fine, sample->time));
        const double bend = beside[0] - 2 * beside[1] + beside[2];
        if (bend < 0)
            best += fine * fmax(-1, fmin(1, 0.5 * (beside[0] - beside[2]) / bend));
    }
    return best;
}

/* int v dx over the bar on one side of the joint, over that of the pulse at the start. */
static double share_of_pulse(const Sample *sample, bool beyond)
{
    const BarTheory *bar = sample->theory;
    double sum = 0;
    for (size_t i = 0; i < sample->count; i++)
        sum += (sample->x[i] > bar->joint) == beyond ? sample->v[i] * sample->spacing : 0;
    return sum / (bar->pulse.velocity * bar->pulse.width * sqrt(M_PI));
}

/* From when on, and up to when, what a joint has made of the pulse is in one piece on one side of it: while
 * nothing else is there, it has left the joint, and no fixed end has begun to turn it. */
typedef struct Span {
    double from, to;
} Span;

static Span span_in_one_piece(const BarTheory *bar, bool beyond)
{
    const double half = 3.5; /* widths to each side: 4e-7 of the pulse are beyond them */
    const double c = bar_wave_speed(bar), passing = half * bar->pulse.width / c;
    const double left = bar->joint / c;
    const double right = (bar->length - bar->joint) / sqrt(bar->joint_modulus / bar->joint_density);
    const double met = (bar->joint - bar->pulse.centre) / c;
    const bool turned = beyond ? bar->right_fixed : bar->left_fixed;
    const double again = fmin(2 * fmin(left, right), turned ? beyond ? right : left : INFINITY);
    const bool whole = bar->pulse.to_left == 0 && met >= passing && bar->pulse.centre / c >= passing;
    return (Span){met + passing, whole ? met + again - passing : -INFINITY};
}

/* What is sent back, or let on beyond the joint. `over`: the pulse there is so many times as long. */
static Finding joint_finding(const Sample *sample, const char *name, const char *label, bool beyond,
                             double over, double exact)
{
    const Span span = span_in_one_piece(sample->theory, beyond);
    Finding finding = {name, label, NAN, exact, NULL, NULL};
    if (sample->time > span.to && span.to > 0)
        finding.missing = "no longer";
    else if (!(span.from < span.to))
        finding.missing = "never in one piece";
    else if (sample->time >= span.from)
        finding.measured = share_of_pulse(sample, beyond) / over;
    return finding;
}

static int joint_findings(const Sample *sample, Finding *out)
{
    const BarTheory *bar = sample->theory;
    const double speeds = sqrt(bar->joint_modulus / bar->joint_density) / bar_wave_speed(bar);
    for (int i = 0; i < bar->n_modes; i++)
        if (bar->modes[i].velocity != 0)
            return 0; /* what moves there is not of the pulse alone */
    out[0] = joint_finding(sample, "reflected", "sent back R", false, 1, bar_waves_reflected(bar));
    out[1] = joint_finding(sample, "transmitted", "let on T", true, speeds, bar_waves_transmitted(bar));
    return 2;
}

int bar_findings(const References *refs, const Simulation *sim, Finding out[FINDINGS_MAX])
{
    const BarTheory *theory = &bar_answers(refs)->theory;
    Sample sample;
    int n = 0;
    if (theory->pulse.velocity == 0 || !sample_take(&sample, theory, sim))
        return 0;
    if (theory->joint > 0)
        n = joint_findings(&sample, out);
    out[n++] = (Finding){"v_error", "L2 error of v", relative_distance(&sample), 0, NULL, NULL};
    if (theory->joint == 0) {
        const double start = fabs(theory->pulse.velocity), peak = largest(sample.v, sample.count) / start,
                     exact = largest(sample.exact, sample.count) / start;
        const double behind = delay_of(&sample) * bar_wave_speed(theory);
        out[n++] = (Finding){"v_peak", "peak/start", peak, exact, NULL, NULL};
        out[n++] =
            (Finding){"lag", "cells behind", behind / bar_answers(refs)->mesh.cell_size, 0, NULL, NULL};
    }
    free(sample.x);
    return n;
}
