/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A beam: its numbers, and its particles at t = 0; m = rho d^2 with d = dx/P.
 *
 * At t = 0 the deflection is w(x), the beam's sections stay plane and square to it:
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
 * on. */
#include "base/math/functions.h"
#include "methods/mpm/mistakes.h"

/* --- numbers -------------------------------------------------------------------------------------- */

/* Columns of cells whose particles are worked on together: some chunks for threads to share, each with rows
 * long enough to be read ahead. */
static int chunk_cells(int columns)
{
    const int cells = columns / 16;
    return cells < 8 ? 8 : cells > 64 ? 64 : cells;
}

/* A node is inactive up to 1e-12 of a full cell's mass (anything from 1e-14 to 1e-8 gives the same). The grid
 * has `padding` cells all round, and on the right as many more as a cantilever gets ahead of it. */
void plane_derive(Mpm *mpm)
{
    const MpmDef *def = &mpm->def;
    const int P = def->particles_per_cell, rows = (int)lround(def->height / def->cell_size);
    const int columns = (int)lround((def->length + def->channel) / def->cell_size);
    mpm->dx = def->height / rows;
    mpm->spacing = mpm->dx / P;
    mpm->mass[0] =
        def->density * mpm->spacing * mpm->spacing * (mpm_does(mpm, WRONG_MASS_OF_CELL) ? P * P : 1);
    mpm->floor = 1e-12 * def->density * mpm->dx * mpm->dx;
    mpm->nxp = columns * P;
    mpm->nyp = rows * P;
    mpm->joint = mpm->n_particles = mpm->nxp * mpm->nyp;
    mpm->n_chunks = (columns + chunk_cells(columns) - 1) / chunk_cells(columns);
    const double steps = ceil(def->end * (1 - 1e-9) / mpm->dt);
    const double way = (def->speed - def->grid_velocity) * steps * mpm->dt / mpm->dx;
    mpm->gx = columns + 2 * def->padding + (int)ceil(way) + 1;
    mpm->gy = rows + 2 * def->padding + 1;
    mpm->n_nodes = mpm->gx * mpm->gy;
    mpm->cells = 1 << 30; /* no spline is an end's */
    /* a box, of a spline a cell, begins half of it before its middle, and lies on the grid whole */
    const double box = def->shape == MPM_GIMP ? 2 * mpm->half : def->shape == MPM_BSPLINE2 ? 1 : 0;
    mpm->edge = -box / 2;
    mpm->high[0] = mpm->gx - 1 - box;
    mpm->high[1] = mpm->gy - 1 - box;
    mpm->xmin = -def->channel - def->padding * mpm->dx;
    mpm->ymin = -def->height / 2 - def->padding * mpm->dx;
    mpm->speed = def->speed;
    /* the mean of the middle two rows: over the two columns beside mid-span, or in the last column */
    for (int k = 0; k < 4; k++) {
        const int column = def->leaves_channel ? mpm->nxp - 1 : k % 2 ? mpm->nxp / 2 : (mpm->nxp - 1) / 2;
        mpm->probe[k] = (k / 2 ? mpm->nyp / 2 : (mpm->nyp - 1) / 2) * mpm->nxp + column; /* a particle */
    }
}

/* --- particles at t = 0 ----------------------------------------------------------------------------- */

static const double cantilever_root = 1.8751040687119611; /* the first of 1 + cosh z cos z = 0 */

/* w, w' and w''. */
typedef struct Deflection {
    double w, slope, curvature;
} Deflection;

/* w, w' and w'' at x (m, 1, 1/m) by eqs. 16 and 18; 0 in the channel. */
static Deflection deflection(const MpmDef *def, double x)
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

/* sum B u at a particle's place on the undeformed lattice, what the first step would find had the nodes moved
 * there: the stress that belongs to it is that of the mesh, not of the beam. Nodes at and behind the
 * channel's end do not move. */
static void strain_of_nodes(const Mpm *mpm, int p, double e[MPM_STRESSES])
{
    const MpmDef *def = &mpm->def;
    const int i = (int)mpm->rest[0][p], j = (int)mpm->rest[1][p];
    const double s[MPM_AXES] = {mpm->rest[0][p] - i, mpm->rest[1][p] - j};
    const MpmWeights w = mpm_weights(mpm, mpm->half, 0, s);
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
            e[0] += bx * ux;
            e[1] += by * uy;
            e[2] += by * ux + bx * uy;
        }
    }
}

/* One particle at t = 0: displacement, velocity, stress, volume. */
static void place(Mpm *mpm, int p)
{
    const MpmDef *def = &mpm->def;
    const double X = mpm_rest(mpm, 0, p), Y = mpm_rest(mpm, 1, p);
    const Deflection bent = deflection(def, X);
    mpm->rest[0][p] = mpm_grid_place(mpm, 0, X);
    mpm->rest[1][p] = mpm_grid_place(mpm, 1, Y);
    mpm->v[0][p] = mpm->speed;
    mpm->volume[p] = mpm->mass[0] / def->density;
    if (def->start == PLANE_VELOCITY) {
        /* omega = (z/L)^2 h sqrt(E/(12 rho)), 1/s: Euler and Bernoulli's, of a beam without shear */
        const double k = (def->leaves_channel ? cantilever_root : M_PI) / def->length;
        const double omega = k * k * def->height * sqrt(def->youngs_modulus / (12 * def->density));
        mpm->v[0][p] += omega * (-Y * bent.slope);
        mpm->v[1][p] = omega * bent.w;
        return;
    }
    mpm->u[0][p] = -Y * bent.slope;
    mpm->u[1][p] = bent.w;
    double e[MPM_STRESSES] = {def->stress == PLANE_EXACT ? -Y * bent.curvature : 0};
    if (def->stress != PLANE_EXACT)
        strain_of_nodes(mpm, p, e);
    mpm->stress[0][p] = mpm->D11 * (e[0] + def->poisson * e[1]);
    mpm->stress[1][p] = mpm->D11 * (e[1] + def->poisson * e[0]);
    mpm->stress[2][p] = mpm->shear * e[2];
    mpm->volume[p] *= 1 + e[0] + e[1];
}

/* All particles. False: given up, or the shape leaves the grid. */
bool plane_begin(Mpm *mpm, Status *status)
{
    enum { PARTICLES_A_QUESTION = 4096 };
    const int P = mpm->def.particles_per_cell, width = chunk_cells(mpm->nxp / P) * P;
    bool sound = true;
    for (int k = 0; k < mpm->n_chunks; k++) {
        const int first = k * width, rest = mpm->nxp - first;
        mpm_put_chunk(mpm, k, (MpmChunk){first, rest < width ? rest : width, mpm->nyp, .stride = mpm->nxp});
    }
    for (int p = 0; p < mpm->n_particles; p++) {
        if (p % PARTICLES_A_QUESTION == 0 && cancel_requested(&mpm->def.cancel, (double)p / mpm->n_particles))
            return status_fail(status, "the building of the beam was cancelled");
        place(mpm, p);
        if (mpm_does(mpm, WRONG_VOLUME_LATE))
            mpm->kept_volume[p] = mpm->volume[p];
        sound = sound && mpm->volume[p] > 0;
    }
    if (!mpm_find_all(mpm) || !sound)
        return status_refuse(
            status, "initial.amplitude: %g bends the beam out of its grid (less, or more mesh.padding)",
            mpm->def.amplitude);
    mpm->energy_start = mpm_energy(mpm);
    return isfinite(mpm->energy_start) ||
           status_refuse(status, "initial.amplitude: the energy is not a finite number");
}
