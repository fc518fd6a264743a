/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Particles at t = 0. The deflection is w(x), the beam's sections stay plane and square to it:
 *
 *     supported    w = U sin(pi x/L)                                                     paper P, eq. 16
 *     cantilever   w = U (cosh kx - cos kx - r (sinh kx - sin kx)), k = z/L, x > 0       paper P, eq. 18
 *                  r = (sinh z - sin z)/(cosh z + cos z), 1 + cosh z cos z = 0
 *     particles    x = X - Y w'(X),  y = Y + w(X)
 *
 * A method that carries stress from step to step has to be told the stress of that shape:
 *
 *     beam         exx = -Y w''(X), nothing else
 *     grid         B u of the nodal displacements u = (-y w', w), as the first step would strain it
 *     relaxed      the same of u = (-y w', w + nu w'' y^2/2): sections that widen where they are pressed, so
 *                  that syy = 0. Without it 1 - (1 - nu^2) of the energy rings through the height.
 *
 * s = D e, rho = rho0/(1 + exx + eyy). `velocity` starts the straight beam with v = omega (-Y w', w), omega =
 * (z/L)^2 h sqrt(E/(12 rho)), z = pi or that of the cantilever: the same swing a quarter of a period on. */
#include "methods/mpm/plane/plane_state.h"

#include "base/math/functions.h"

#include <math.h>

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

/* sum B u at a place of the undeformed lattice, what the first step would find had the nodes moved there: the
 * stress that belongs to it is that of the mesh, not of the beam. Nodes at and behind the channel's end do
 * not move. */
static Strain strain_of_nodes(const Plane *plane, double X, double Y)
{
    const PlaneDef *def = &plane->def;
    int32_t base;
    double sx, sy;
    Strain strain = {0, 0, 0};
    if (!plane_find(plane, plane->xmin, X, Y, &base, &sx, &sy))
        return strain;
    const PlaneWeights w = plane_weights(plane, sx, sy);
    const int i = base % plane->gx, j = base / plane->gx;
    for (int a = 0; a < plane->support; a++) {
        const double x = plane->xmin + (i + a) * plane->dx;
        if (def->leaves_channel && x <= 1e-6 * plane->dx)
            continue;
        const Deflection bent = deflection(def, x);
        for (int b = 0; b < plane->support; b++) {
            const double y = plane->ymin + (j + b) * plane->dx;
            const double wide = def->stress == PLANE_RELAXED ? def->poisson * bent.curvature * y * y / 2 : 0;
            const double ux = -y * bent.slope, uy = bent.w + wide;
            const double bx = w.dnx[a] * w.ny[b] / plane->dx, by = w.nx[a] * w.dny[b] / plane->dx;
            strain.xx += bx * ux;
            strain.yy += by * uy;
            strain.xy += by * ux + bx * uy;
        }
    }
    return strain;
}

/* One particle at t = 0: position, velocity, stress, volume. An empty lane gets what a longer beam would have
 * there. */
static void place(Plane *plane, int at)
{
    const PlaneDef *def = &plane->def;
    const int P = def->particles_per_cell, vector = at / PLANE_LANES, in_block = vector % plane->n_vectors;
    const int column = (vector / plane->n_vectors * PLANE_LANES + at % PLANE_LANES) * P + in_block % P;
    const double X = plane->x_first + (column + 0.5) * plane->spacing;
    const double Y = (in_block / P + 0.5) * plane->spacing - def->height / 2;
    const Deflection bent = deflection(def, X);
    plane->x[at] = X;
    plane->y[at] = Y;
    plane->vx[at] = plane->speed;
    plane->vy[at] = 0;
    plane->volume[at] = plane->mass / def->density;
    plane->sxx[at] = plane->syy[at] = plane->sxy[at] = 0;
    if (def->start == PLANE_VELOCITY) {
        const double omega = mode_frequency(def);
        plane->vx[at] += omega * (-Y * bent.slope);
        plane->vy[at] = omega * bent.w;
        return;
    }
    plane->x[at] = X - Y * bent.slope;
    plane->y[at] = Y + bent.w;
    const Strain strain =
        def->stress == PLANE_EXACT ? (Strain){-Y * bent.curvature, 0, 0} : strain_of_nodes(plane, X, Y);
    plane->sxx[at] = plane->lambda * (strain.xx + def->poisson * strain.yy);
    plane->syy[at] = plane->lambda * (strain.yy + def->poisson * strain.xx);
    plane->sxy[at] = plane->shear * strain.xy;
    plane->volume[at] *= 1 + strain.xx + strain.yy;
}

/* All particles, as they are stored. False: given up, or the shape leaves the grid. */
bool plane_begin(Plane *plane, Status *status)
{
    int32_t base;
    double sx, sy;
    enum { PARTICLES_A_QUESTION = 4096 };
    for (int at = 0; at < plane->n_places; at++) {
        if (at % PARTICLES_A_QUESTION == 0 &&
            !patience_lasts(&plane->def.patience, (double)at / plane->n_places))
            return status_fail(status, "the building of the beam was given up");
        place(plane, at);
        if (at % PLANE_LANES >= plane_lanes(plane, at / PLANE_LANES / plane->n_vectors))
            continue;
        if (!plane_find(plane, plane->xmin, plane->x[at], plane->y[at], &base, &sx, &sy) ||
            !(plane->volume[at] > 0))
            return status_refuse(status,
                                 "initial.amplitude: %g bends the beam out of its grid (less, or more "
                                 "mesh.padding)",
                                 plane->def.amplitude);
    }
    plane->energy_start = plane_energy(plane);
    return isfinite(plane->energy_start) ||
           status_refuse(status, "initial.amplitude: the energy is no finite number");
}
