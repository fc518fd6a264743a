/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The critical time step 2 / omega_max: the largest frequency of the linear operator (1/rho) sum c G w V n
 * n.eta by Lanczos iteration:
 *
 *     beta_k q_{k+1} = A q_k - alpha_k q_k - beta_{k-1} q_{k-1},   alpha_k = q_k . A q_k,   |q_k| = 1
 *
 * The largest eigenvalue of the tridiagonal matrix of alphas and betas converges to omega_max^2 from below,
 * in far fewer products with A than power iteration needs (Golub and Van Loan, Matrix Computations, chapter
 * 10). It stops when the value moves by less than 1e-7 in CHECK_EVERY products. Called once, when a beam is
 * created.
 *
 * Nothing is held here. To hold nodes can only lower the largest frequency, so this step is safe for every
 * way of holding the beam, also for a clamp that the beam leaves on its way; it costs at most a few
 * hundredths of the step, at the coarsest spacings.
 *
 * The kernels serve as the operator: at displacements of 1e-9 spacings they are linear to 1e-9. */
#include "methods/bonds/plane/bonds_internal.h"

#include "base/linear.h"
#include "base/math/functions.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { STEPS_MAX = 1000, STEPS_MIN = 20, STEPS_USUAL = 40, CHECK_EVERY = 5 };

/* The start: neighbours of opposite sign, close to the fastest mode, with pseudo-random sizes (xorshift) so
 * that no mode is missed by symmetry; the same for every run. */
static void fill(const Beam *beam, double *x, double *y)
{
    const Lattice *lattice = &beam->lattice;
    uint32_t hash = 2463534242u;
    for (int j = 0; j < lattice->ny; j++)
        for (int i = 0; i < lattice->nx; i++) {
            size_t at = lattice_at(lattice, i, j);
            for (int component = 0; component < 2; component++) {
                hash ^= hash << 13, hash ^= hash >> 17, hash ^= hash << 5;
                double strength = 0.5 + (double)hash / 4294967296.0;
                (component ? y : x)[at] = (i + j) % 2 ? strength : -strength;
            }
        }
}

/* a . b over both components of all nodes; paddings are 0. */
static double dot(const Beam *beam, const double *a, const double *b)
{
    /* both components stand one after the other, padded to whole blocks */
    return beam->kernels->dot(a, b, 2 * beam->array);
}

/* The largest eigenvalue of the tridiagonal matrix that has been made so far. */
static double largest(const double *rows, int n)
{
    const Band band = {(size_t)n, 1, rows};
    return band_eigenvalue(&band, (size_t)n - 1, &(Cancel){0}); /* small */
}

/* omega_max^2 in 1/s^2; -1: interrupted by BeamDef.cancel, or not converged. A = K/rho: a displacement tiny
 * q gives the force density -tiny rho A q. v is q_k, previous q_{k-1}, each of 2 `array` doubles; f becomes A
 * q_k less its parts along both, so that its length is beta_k. The Lanczos vectors are not made orthogonal
 * again: that only repeats eigenvalues that have converged, and the largest stays right. */
static double iterate(Beam *beam, double *v, double *previous, Status *status)
{
    const size_t count = 2 * beam->array;
    const double tiny = 1e-9 * beam->lattice.spacing;
    double rows[2 * STEPS_MAX], value = 0;           /* of the band: alpha_k, beta_{k-1} */
    double *u = beam->nodes.ux, *f = beam->nodes.fx; /* uy and fy follow */

    fill(beam, v, v + beam->array);
    double norm = sqrt(dot(beam, v, v));
    for (size_t i = 0; i < count; i++)
        v[i] /= norm;
    memset(previous, 0, count * sizeof *previous);
    double last_beside = 0;
    /* a unit vector has no component above 1, so no displacement exceeds `tiny` */
    for (int k = 0; k < STEPS_MAX; k++) {
        /* how many iterations it takes is not known beforehand */
        double share = 1 - math_exp(-(double)k / STEPS_USUAL);
        share = BUILDING_CRITICAL + (1 - BUILDING_CRITICAL) * share;
        if (!beam_go_on(beam, share, status))
            return -1;
        for (size_t i = 0; i < count; i++)
            u[i] = tiny * v[i];
        if (!beam_ask_forces(beam, share, status))
            return -1;
        for (size_t i = 0; i < count; i++)
            f[i] = f[i] / (-tiny * beam->def.density) - last_beside * previous[i];
        if (!beam_go_on(beam, share, status))
            return -1;
        rows[2 * k] = dot(beam, f, v);
        rows[2 * k + 1] = last_beside;
        for (size_t i = 0; i < count; i++) {
            previous[i] = v[i];
            f[i] -= rows[2 * k] * v[i];
        }
        if (!beam_go_on(beam, share, status))
            return -1;
        last_beside = sqrt(dot(beam, f, f));
        if (last_beside == 0)
            return largest(rows, k + 1);
        for (size_t i = 0; i < count; i++)
            v[i] = f[i] / last_beside;
        if (k >= STEPS_MIN && k % CHECK_EVERY == 0) {
            double before = value;
            value = largest(rows, k + 1);
            if (value - before < 1e-7 * value)
                return value;
        }
    }
    status_fail(status, "the search for the critical time step did not converge");
    return -1;
}

/* *step = 2/omega_max, s. The iteration comes from below, so the step may be too large by some 1e-6.
 * The row-sum estimate sqrt(2 rho/sum c G w V/|xi|) would be up to 1.8 times too small. False: no
 * memory, given up, or not converged. */
bool beam_critical_step(Beam *beam, double *step, Status *status)
{
    size_t bytes = (2 * beam->array * sizeof(double) + 63) / 64 * 64;
    double *v = aligned_alloc(64, bytes), *previous = aligned_alloc(64, bytes);
    bool enough = v && previous;
    if (enough) {
        memset(v, 0, bytes);
        double value = iterate(beam, v, previous, status);
        enough = !(value < 0);
        *step = 2 / sqrt(value);
        memset(beam->nodes.ux, 0, 2 * beam->array * sizeof(double));
        memset(beam->nodes.fx, 0, 2 * beam->array * sizeof(double));
    } else {
        status_fail(status, "not enough memory for the critical time step");
    }
    free(v);
    free(previous);
    return enough;
}
