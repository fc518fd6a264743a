/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A beam by the material point method is made and changed. The grid has `padding` cells all round, and on the
 * right as many more as a cantilever gets ahead of it; m = rho d^2 with d = dx/P.
 *
Particles at t = 0. The deflection is w(x), the beam's sections stay plane and square to it:
 *
 *     supported    w = U sin(pi x/L)                                                     paper P, eq. 16
 *     cantilever   w = U (cosh kx - cos kx - r (sinh kx - sin kx)), k = z/L, x > 0       paper P, eq. 18
 *                  r = (sinh z - sin z)/(cosh z + cos z), 1 + cosh z cos z = 0
 *     particles    x = X - Y w'(X),  y = Y + w(X)
 *
 * A method that carries stress from step to step has to be given the stress of that shape:
 *
 *     beam         exx = -Y w''(X), nothing else
 *     grid         B u of the nodal displacements u = (-y w', w), as the first step would strain it
 *     relaxed      the same of u = (-y w', w + nu w'' y^2/2): sections that widen where they are pressed, so
 *                  that syy = 0. Without it 1 - (1 - nu^2) of the energy rings through the height.
 *
 * s = D e, rho = rho0/(1 + exx + eyy). `velocity` starts the straight beam with v = omega (-Y w', w), omega =
 * (z/L)^2 h sqrt(E/(12 rho)), z = pi or that of the cantilever: the same oscillation a quarter of a period
on. */
#include "base/assertion.h"
#include "base/math/functions.h"
#include "methods/mpm/mistakes.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

/* --- particles at t = 0 ----------------------------------------------------------------------------- */

static const double cantilever_root = 1.8751040687119611; /* the first of 1 + cosh z cos z = 0 */

/* w, w' and w''. */
typedef struct Deflection {
    double w, slope, curvature;
} Deflection;

/* w, w' and w'' at x (m, 1, 1/m) by eqs. 16 and 18; 0 in the channel. */
static Deflection deflection(const PlaneDef *def, double x)
{
    const double U = def->amplitude;
    if (!def->leaves_channel) {
        const double k = M_PI / def->length;
        return (Deflection){U * math_sin(k * x), U * k * math_cos(k * x), -U * k * k * math_sin(k * x)};
    }
    if (!(x > 0))
        return (Deflection){0, 0, 0};
    const double z = cantilever_root, k = z / def->length, a = k * x;
    const double r = (math_sinh(z) - math_sin(z)) / (math_cosh(z) + math_cos(z));
    const double cosh_a = math_cosh(a), sinh_a = math_sinh(a), cos_a = math_cos(a), sin_a = math_sin(a);
    return (Deflection){U * (cosh_a - cos_a - r * (sinh_a - sin_a)),
                        U * k * (sinh_a + sin_a - r * (cosh_a - cos_a)),
                        U * k * k * (cosh_a + cos_a - r * (sinh_a + sin_a))};
}

/* omega = (z/L)^2 h sqrt(E/(12 rho)), 1/s: Euler and Bernoulli's, of a beam without shear. */
static double mode_frequency(const PlaneDef *def)
{
    const double z = def->leaves_channel ? cantilever_root : M_PI, k = z / def->length;
    return k * k * def->height * sqrt(def->youngs_modulus / (12 * def->density));
}

typedef struct Strain {
    double xx, yy, xy; /* xy: gamma */
} Strain;

/* sum B u at a particle's place on the undeformed lattice, what the first step would find had the nodes moved
 * there: the stress that belongs to it is that of the mesh, not of the beam. Nodes at and behind the
 * channel's end do not move. */
static Strain strain_of_nodes(const Mpm *mpm, int p)
{
    const PlaneDef *def = &mpm->plane;
    Strain strain = {0, 0, 0};
    MpmWeights w;
    const int i = (int)mpm->rest[0][p], j = (int)mpm->rest[1][p];
    const double s[MPM_AXES] = {mpm->rest[0][p] - i, mpm->rest[1][p] - j};
    mpm_weights(mpm, 2, mpm->shape, mpm->half, 0, s, &w);
    for (int a = 0; a < mpm->support; a++) {
        const double x = mpm->xmin + (i + a) * mpm->dx;
        if (def->leaves_channel && x <= 1e-6 * mpm->dx)
            continue;
        const Deflection bent = deflection(def, x);
        for (int b = 0; b < mpm->support; b++) {
            const double y = mpm->ymin + (j + b) * mpm->dx;
            const double wide = def->stress == PLANE_RELAXED ? def->poisson * bent.curvature * y * y / 2 : 0;
            const double ux = -y * bent.slope, uy = bent.w + wide;
            const double bx = w.dn[0][a] * w.n[1][b] / mpm->dx, by = w.n[0][a] * w.dn[1][b] / mpm->dx;
            strain.xx += bx * ux;
            strain.yy += by * uy;
            strain.xy += by * ux + bx * uy;
        }
    }
    return strain;
}

/* One particle at t = 0: displacement, velocity, stress, volume. */
static void place(Mpm *mpm, int p)
{
    const PlaneDef *def = &mpm->plane;
    const double X = mpm_rest(mpm, 0, p), Y = mpm_rest(mpm, 1, p);
    const Deflection bent = deflection(def, X);
    mpm->rest[0][p] = mpm_grid_place(mpm, 0, X);
    mpm->rest[1][p] = mpm_grid_place(mpm, 1, Y);
    mpm->v[0][p] = mpm->speed;
    mpm->volume[p] = mpm->mass[0] / def->density;
    if (def->start == PLANE_VELOCITY) {
        const double omega = mode_frequency(def);
        mpm->v[0][p] += omega * (-Y * bent.slope);
        mpm->v[1][p] = omega * bent.w;
        return;
    }
    mpm->u[0][p] = -Y * bent.slope;
    mpm->u[1][p] = bent.w;
    const Strain strain =
        def->stress == PLANE_EXACT ? (Strain){-Y * bent.curvature, 0, 0} : strain_of_nodes(mpm, p);
    mpm->stress[0][p] = mpm->D11 * (strain.xx + def->poisson * strain.yy);
    mpm->stress[1][p] = mpm->D11 * (strain.yy + def->poisson * strain.xx);
    mpm->stress[2][p] = mpm->shear * strain.xy;
    mpm->volume[p] *= 1 + strain.xx + strain.yy;
}

/* All particles. False: given up, or the shape leaves the grid. */
static bool begin(Mpm *mpm, Status *status)
{
    enum { PARTICLES_A_QUESTION = 4096 };
    const int P = mpm->plane.particles_per_cell, width = plane_chunk_cells(mpm->nxp / P) * P;
    bool sound = true;
    *mpm->head = (MpmHead){.algorithm = mpm->plane.algorithm,
                           .flip_fraction = mpm->plane.flip_fraction,
                           .mass_blend = 1,
                           .mistake = mpm->plane.mistake};
    for (int k = 0; k < mpm->n_chunks; k++) { /* even ones first: engine.h */
        const int even = (mpm->n_chunks + 1) / 2, which = k < even ? 2 * k : 2 * (k - even) + 1;
        const int first = which * width, rest = mpm->nxp - first;
        mpm->chunks[k] = (MpmChunk){first, rest < width ? rest : width, mpm->nyp, mpm->nxp};
    }
    for (int p = 0; p < mpm->n_particles; p++) {
        if (p % PARTICLES_A_QUESTION == 0 &&
            cancel_requested(&mpm->plane.cancel, (double)p / mpm->n_particles))
            return status_fail(status, "the building of the beam was cancelled");
        place(mpm, p);
        if (mpm_does(mpm, WRONG_VOLUME_LATE))
            mpm->kept_volume[p] = mpm->volume[p];
        sound = sound && mpm->volume[p] > 0;
    }
    if (!mpm_find_all(mpm) || !sound)
        return status_refuse(
            status, "initial.amplitude: %g bends the beam out of its grid (less, or more mesh.padding)",
            mpm->plane.amplitude);
    mpm->energy_start = mpm_energy(mpm);
    return isfinite(mpm->energy_start) ||
           status_refuse(status, "initial.amplitude: the energy is not a finite number");
}

/* --- made and changed ------------------------------------------------------------------------------- */

/* A live parameter, between steps only: it belongs to the state, so a snapshot brings back its own. */
static bool change(Simulation *sim, const char *key, double value, Status *status)
{
    Mpm *mpm = mpm_of(sim);
    ASSERT_INT(sim->stage, ==, 0);
    if (strcmp(key, "mpm.algorithm") == 0) {
        if (!(value >= 0 && value <= MPM_MUSL && value == floor(value)))
            return status_refuse(status, "%s: %g is not a choice (0 to %d)", key, value, MPM_MUSL);
        mpm->head->algorithm = (MpmAlgorithm)value;
    } else if (strcmp(key, "mpm.flip_fraction") == 0) {
        if (!(value >= 0 && value <= 1))
            return status_refuse(status, "%s: %g is out of range (0 to 1)", key, value);
        mpm->head->flip_fraction = value;
    } else if (strcmp(key, "mpm.mistake") == 0 && value >= 0 && value == floor(value) && value < INT_MAX) {
        PlaneDef def = mpm->plane;
        def.algorithm = mpm->head->algorithm;
        def.mistake = (int)value;
        if (!plane_check(&def, status) || !mpm_change_mistake(mpm, def.mistake, def.conceals_mistake, status))
            return false;
    } else
        return status_refuse(status, "%s: cannot be changed in mid-run", key);
    mpm_take_schedule(mpm);
    return true;
}

static const Method method = {MPM_METHOD, .on_request = mpm_on_request, .change = change};

Simulation *plane_create(const PlaneDef *definition, Status *status)
{
    static const MpmMaker maker = {"beam",       &method, HAS_PLANE | HAS_MESH,
                                   plane_derive, begin,   mpm_set_series};
    ASSERT(plane_check(definition, NULL));
    Mpm *mpm = calloc(1, sizeof *mpm);
    if (mpm)
        mpm->plane = *definition;
    Simulation *sim = mpm_create(mpm, &maker, (int[]){definition->mistake, definition->mistake_beside},
                                 definition->threads, status);
    if (sim) {
        sim->has |= mpm->speed > 0 ? HAS_RELATIVE_ENERGY : 0u;
        sim->common_speed = mpm->speed;
    }
    return sim;
}
