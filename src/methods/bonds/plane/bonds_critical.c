/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The critical time step 2 / omega_max: the largest frequency of the linear operator (1/rho) sum c G w V n
 * n.eta by Lanczos' method (base/linear.h). Called once, when a beam is created.
 *
 * Nothing is held here. To hold nodes can only lower the largest frequency, so this step is safe for every
 * way of holding the beam, also for a clamp that the beam leaves on its way; it costs at most a few
 * hundredths of the step, at the coarsest spacings.
 *
 * The kernels serve as the operator: at displacements of 1e-9 spacings they are linear to 1e-9. */
#include "methods/bonds/plane/bonds_internal.h"

#include "base/linear.h"
#include "base/math/functions.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

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

typedef struct Search {
    Beam *beam;
    int products;
    Status *status;
} Search;

/* A v, A = K/rho: a displacement tiny v gives the force density -tiny rho A v. A unit vector has no component
 * above 1, so no displacement exceeds `tiny`. */
static bool apply(void *context, const double *v, double *out)
{
    enum { PRODUCTS_USUAL = 40 };
    Search *search = context;
    Beam *beam = search->beam;
    const size_t count = 2 * beam->array; /* both components stand one after the other */
    const double tiny = 1e-9 * beam->lattice.spacing;
    /* how many products it takes is not known beforehand */
    const double part = 1 - math_exp(-(double)search->products++ / PRODUCTS_USUAL);
    const double share = BUILDING_CRITICAL + (1 - BUILDING_CRITICAL) * part;
    for (size_t i = 0; i < count; i++)
        beam->nodes.ux[i] = tiny * v[i];
    if (!beam_go_on(beam, share, search->status) || !beam_ask_forces(beam, share, search->status))
        return false;
    for (size_t i = 0; i < count; i++)
        out[i] = beam->nodes.fx[i] / (-tiny * beam->def.density);
    return beam_go_on(beam, share, search->status);
}

/* *step = 2/omega_max, s. The iteration comes from below, so the step may be too large by some 1e-6.
 * The row-sum estimate sqrt(2 rho/sum c G w V/|xi|) would be up to 1.8 times too small. False: no
 * memory, given up, or not converged. */
bool beam_critical_step(Beam *beam, double *step, Status *status)
{
    Search search = {beam, 0, status};
    double *v = calloc(2 * beam->array, sizeof *v), value = NAN;
    if (v) {
        fill(beam, v, v + beam->array);
        value = linear_largest(2 * beam->array, (LinearMap){apply, &search}, NULL, 1e-7, v);
    }
    if (!v || (isnan(value) && errno == ENOMEM))
        status_fail(status, "not enough memory for the critical time step");
    else if (isnan(value) && errno != ECANCELED)
        status_fail(status, "the search for the critical time step did not converge");
    free(v);
    *step = 2 / sqrt(value);
    memset(beam->nodes.ux, 0, 2 * beam->array * sizeof(double));
    memset(beam->nodes.fx, 0, 2 * beam->array * sizeof(double));
    return !isnan(value);
}
