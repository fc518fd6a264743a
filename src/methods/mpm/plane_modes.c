/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Small motion about the undeformed lattice, on which hats and boxes are the same numbers; of B-splines there
 * is a column or row of nodes more all round. With the nodal masses M_L (lumped) and M_C = sum m N_i N_j
 * (consistent) and the stiffness K = sum V B'D B, a step maps what the grid sees as
 *
 *     v' = G v + dt S f,   S = M_L^-1 M_C M_L^-1,   G = alpha + (1 - alpha) M_L^-1 M_C      (flip fraction)
 *     f' = f - dt K v'  (USF, MUSL)        f' = f - dt K (v + dt M_L^-1 f)  (USL)
 *
 * because a force goes to particles and comes back through M_C. So the mode x of the lowest omega^2 of S K,
 *
 *     K x = omega^2 M_L M_C^-1 M_L x,      x <- K^-1 M_L M_C^-1 M_L x  (inverse iteration),
 *
 * oscillates with Omega = (2/dt) asin(omega dt/2) where alpha = 1; with w^2 = x'Kx / x'M_L x, F = omega^2/w^2
 * and g = alpha + (1 - alpha) F in general
 *
 *     cos(Omega dt) = tr/(2 sqrt(det)),   USF, MUSL: tr = g + 1 - F w^2 dt^2,  det = g
 *                                         USL: tr = g + 1 - w^2 dt^2,  det = g (1 - w^2 dt^2) + F w^2 dt^2.
 *
 * The step is too large where an eigenvalue reaches -1. Put v' = -v, f' = -f:
 *
 *     USF, MUSL: dt^2 = 2/max eig(W K)     USL: dt^2 = 2/max eig((M_L^-1 - W) K)
 *     W = (1 + G)^-1 S = ((1 + alpha) M_L + (1 - alpha) M_C)^-1 M_C M_L^-1,
 *
 * W and M_L^-1 - W symmetric and not negative, so that Lanczos' method in the product of K finds the largest
 * eigenvalue (base/linear.h has both iterations). Held components are left out throughout. */
#include "methods/mpm/engine.h"

#include "base/linear.h"
#include "base/math/functions.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>

enum { NUMBERS_MAX = 1 << 25 };

/* Unknown 2 (i rows + j) + component: nodes by columns. */
typedef struct Lattice2 {
    Mpm model;
    MpmShape shape;
    int ghosts, columns, rows; /* of nodes, those beyond the body's ends included */
    size_t size, width;
    void *memory; /* of all that follows */
    bool *held;
    double *lumped, *work;    /* work: 4 vectors */
    Cholesky stiffness, mass; /* K and M_C; held unknowns stand alone */
    Cholesky blend;           /* (1 + alpha) M_L + (1 - alpha) M_C */
} Lattice2;

static double *entry(Cholesky *band, size_t row, size_t column)
{
    return &band->rows[row * (band->width + 1) + (row - column)];
}

/* One particle's share of K = sum V B'D B and of M_C, at s in the cell whose first node is (i, j): per unit
 * thickness, N/m^2 and kg/m. A spline's first node is the one nearest to it less one. */
static void add_particle(Lattice2 *lattice, int i, int j, double sx, double sy)
{
    const Mpm *model = &lattice->model;
    const double area = model->spacing * model->spacing, nu = model->def.poisson, dx = model->dx;
    const MpmShape shape = lattice->shape;
    const int S = shape_support(shape);
    double nx[SHAPE_SUPPORT_MAX], ny[SHAPE_SUPPORT_MAX], dnx[SHAPE_SUPPORT_MAX], dny[SHAPE_SUPPORT_MAX];
    if (shape == MPM_BSPLINE2) {
        i += sx >= 0.5, j += sy >= 0.5;
        sx += sx < 0.5 ? 0.5 : -0.5, sy += sy < 0.5 ? 0.5 : -0.5;
    }
    shape_at(shape, 0, model->cells, 2, sx, nx, dnx);
    shape_at(shape, 0, model->cells, 2, sy, ny, dny);
    for (int a = 0; a < S * S; a++)
        for (int b = 0; b < S * S; b++) {
            const size_t row = 2 * (size_t)((i + a / S) * lattice->rows + j + a % S);
            const size_t column = 2 * (size_t)((i + b / S) * lattice->rows + j + b % S);
            const double n = nx[a / S] * ny[a % S], m = nx[b / S] * ny[b % S];
            const double px = dnx[a / S] * ny[a % S] / dx, py = nx[a / S] * dny[a % S] / dx;
            const double qx = dnx[b / S] * ny[b % S] / dx, qy = nx[b / S] * dny[b % S] / dx;
            const double k[2][2] = {
                {model->D11 * (px * qx) + model->shear * (py * qy),
                 model->D11 * (nu * (px * qy)) + model->shear * (py * qx)},
                {model->D11 * (nu * (py * qx)) + model->shear * (px * qy),
                 model->D11 * (py * qy) + model->shear * (px * qx)},
            };
            for (int r = 0; r < 2; r++) {
                for (int c = 0; c < 2; c++)
                    if (row + (size_t)r >= column + (size_t)c && !lattice->held[row + (size_t)r] &&
                        !lattice->held[column + (size_t)c])
                        *entry(&lattice->stiffness, row + (size_t)r, column + (size_t)c) += k[r][c] * area;
                lattice->lumped[row + (size_t)r] += model->mass[0] * (n * m);
                if (row >= column && !lattice->held[row + (size_t)r] && !lattice->held[column + (size_t)r])
                    *entry(&lattice->mass, row + (size_t)r, column + (size_t)r) += model->mass[0] * (n * m);
            }
        }
}

static bool given_up(Status *status)
{
    return status_fail(status, "what the mesh predicts was cancelled");
}

/* K, M_C and M_L of the undeformed lattice; a held unknown gets 1 on its diagonals and is coupled to nothing.
 * Of a displaced body of boxes this would not do: its feather-light nodes give K spurious zeros. False: given
 * up. */
static bool assemble(Lattice2 *lattice)
{
    const Mpm *model = &lattice->model;
    const int P = model->def.particles_per_cell, padding = model->def.padding - lattice->ghosts;
    const int cells[2] = {model->nxp / P, model->nyp / P};
    for (int i = 0; i < lattice->columns; i++)
        for (int j = 0; j < lattice->rows; j++) {
            const unsigned held = mpm_held(model, 0, (j + padding) * model->gx + i + padding);
            const size_t at = 2 * (size_t)(i * lattice->rows + j);
            lattice->held[at] = held & HELD_X;
            lattice->held[at + 1] = held & HELD_Y;
        }
    for (int i = 0; i < cells[0]; i++) {
        if (cancel_requested(&model->def.cancel, (double)i / lattice->columns))
            return false;
        for (int j = 0; j < cells[1]; j++)
            for (int k = 0; k < P * P; k++)
                add_particle(lattice, i, j, (k % P + 0.5) / P, (k / P + 0.5) / P);
    }
    for (size_t u = 0; u < lattice->size; u++)
        if (lattice->held[u])
            *entry(&lattice->stiffness, u, u) = *entry(&lattice->mass, u, u) = 1;
    return true;
}

/* False: the status says why. *fits: the matrices are there. */
static bool build(Lattice2 *lattice, const MpmDef *def, bool *fits, Status *status)
{
    *lattice = (Lattice2){.size = 0};
    mpm_derive(&lattice->model, def);
    const int P = def->particles_per_cell;
    lattice->shape = def->shape == MPM_BSPLINE2 ? MPM_BSPLINE2 : MPM_HAT;
    lattice->ghosts = def->shape == MPM_BSPLINE2 ? 1 : 0;
    lattice->columns = lattice->model.nxp / P + 1 + 2 * lattice->ghosts;
    lattice->rows = lattice->model.nyp / P + 1 + 2 * lattice->ghosts;
    lattice->size = 2 * (size_t)lattice->columns * (size_t)lattice->rows;
    lattice->width = 2 * (size_t)((lattice->rows + 1) * (shape_support(lattice->shape) - 1)) + 1;
    const size_t n = lattice->size, numbers = n * (lattice->width + 1);
    *fits = 3 * (double)n * (double)(lattice->width + 1) <= NUMBERS_MAX;
    if (!*fits)
        return true;
    double *const rows = lattice->memory = calloc(3 * numbers + 6 * n, sizeof *rows);
    if (!rows)
        return status_fail(status, "not enough memory for what the mesh predicts");
    lattice->stiffness = (Cholesky){n, lattice->width, rows};
    lattice->mass = (Cholesky){n, lattice->width, rows + numbers};
    lattice->blend = (Cholesky){n, lattice->width, rows + 2 * numbers};
    lattice->lumped = rows + 3 * numbers;
    lattice->work = lattice->lumped + n;
    lattice->held = (bool *)(lattice->work + 4 * n);
    return assemble(lattice) || given_up(status);
}

static void clear_held(const Lattice2 *lattice, double *x)
{
    for (size_t u = 0; u < lattice->size; u++)
        if (lattice->held[u])
            x[u] = 0;
}

static bool factor(Cholesky *band, const MpmDef *def, bool *sound, Status *status)
{
    const CholeskyEnd end = cholesky_factor(band, &def->cancel);
    *sound = end == CHOLESKY_DONE;
    return end != CHOLESKY_GIVEN_UP || given_up(status);
}

/* --- the period ----------------------------------------------------------------------------------- */

/* out = M_L M_C^-1 M_L x; M_C is factored. */
static bool weigh(void *context, const double *x, double *out)
{
    const Lattice2 *lattice = context;
    for (size_t u = 0; u < lattice->size; u++)
        out[u] = lattice->lumped[u] * x[u];
    if (!cholesky_solve(&lattice->mass, out, &lattice->model.def.cancel))
        return false;
    for (size_t u = 0; u < lattice->size; u++)
        out[u] *= lattice->lumped[u];
    clear_held(lattice, out);
    return true;
}

/* T = 2 pi/Omega, s, from omega^2 and w^2 by the formulas above; with alpha = 1 and USF or MUSL Omega =
 * (2/dt) asin(omega dt/2), which keeps all digits of a small omega dt. */
static double period_of(const MpmDef *def, double dt, double omega2, double lumped2)
{
    const double F = omega2 / lumped2, g = def->flip_fraction + (1 - def->flip_fraction) * F;
    const double w = lumped2 * dt * dt;
    if (def->flip_fraction == 1 && def->algorithm != MPM_USL)
        return M_PI * dt / math_asin(sqrt(omega2) * dt / 2);
    const bool last = def->algorithm == MPM_USL;
    const double trace = g + 1 - (last ? w : F * w), det = last ? g * (1 - w) + F * w : g;
    return 2 * M_PI * dt / math_acos(trace / (2 * sqrt(det)));
}

/* *period in s; NAN where the band would take more than NUMBERS_MAX numbers, for the cantilever, which has
 * none, and of B-splines: S K has lower modes there, of nodes at the corners that particles hardly see. The
 * mode is found from half a wave. */
bool plane_predicted_period(const MpmDef *def, double *period, Status *status)
{
    Lattice2 lattice;
    bool sound; /* the matrices fit and are factors */
    *period = NAN;
    if (def->leaves_channel || def->shape == MPM_BSPLINE2)
        return true;
    bool good = build(&lattice, def, &sound, status);
    good = good && (!sound || factor(&lattice.stiffness, def, &sound, status));
    good = good && (!sound || factor(&lattice.mass, def, &sound, status));
    if (good && sound) {
        const LinearMap map = {weigh, &lattice};
        const size_t n = lattice.size;
        double *x = lattice.work, *y = x + n, omega2, lumped = 0; /* omega^2 of S K, x'M_L x */
        for (size_t u = 1; u < n; u += 2)
            x[u] = math_sin(M_PI * (double)(u / 2 / (size_t)lattice.rows) / (lattice.columns - 1));
        clear_held(&lattice, x);
        good = (linear_lowest(&lattice.stiffness, &map, x, &omega2, &def->cancel) && weigh(&lattice, x, y)) ||
               given_up(status);
        for (size_t u = 0; u < n; u++)
            lumped += lattice.lumped[u] * x[u] * x[u];
        if (good) /* w^2 = x'Kx/x'M_L x */
            *period = period_of(def, lattice.model.dt, omega2, omega2 * linear_dot(x, y, n) / lumped);
    }
    free(lattice.memory);
    return good;
}

/* --- the largest step ----------------------------------------------------------------------------- */

/* Of an endless mesh: waves along it with theta = k dx, K = 4 sin^2(theta/2), F = 1 - (1/3 + 1/(6 P^2)) (1 -
 * cos theta), and the Courant number C of the largest of them: C^2 F K = 2 (1 + g), or C^2 K (1 - F/(1 + g))
 * = 2. */
static double endless_limit(const MpmDef *def)
{
    enum { WAVES = 2000 };
    const double P = def->particles_per_cell, alpha = def->flip_fraction;
    double most = 0;
    for (int k = 1; k <= WAVES; k++) {
        const double theta = M_PI * k / WAVES, K = 2 * (1 - math_cos(theta));
        const double F = 1 - (1.0 / 3 + 1 / (6 * P * P)) * (1 - math_cos(theta)), g = alpha + (1 - alpha) * F;
        const double inverse = def->algorithm == MPM_USL ? K * (1 - F / (1 + g)) / 2 : F * K / (2 * (1 + g));
        most = fmax(most, inverse);
    }
    return sqrt(1 / most);
}

/* out = W x or (M_L^-1 - W) x; the blend is factored. */
static bool drive(void *context, const double *x, double *out)
{
    const Lattice2 *lattice = context;
    const size_t n = lattice->size;
    double *over = lattice->work;
    for (size_t u = 0; u < n; u++)
        over[u] = lattice->held[u] ? 0 : x[u] / lattice->lumped[u];
    cholesky_multiply(&lattice->mass, over, out);
    if (!cholesky_solve(&lattice->blend, out, &lattice->model.def.cancel))
        return false;
    for (size_t u = 0; u < n; u++)
        out[u] = lattice->model.def.algorithm == MPM_USL ? over[u] - out[u] : out[u];
    clear_held(lattice, out);
    return true;
}

static bool stiffen(void *context, const double *x, double *out)
{
    const Lattice2 *lattice = context;
    cholesky_multiply(&lattice->stiffness, x, out);
    return true;
}

/* By the beam's own matrices where they fit and the search for their largest eigenvalue converges, else of an
 * endless mesh, less one per cent. Particles that have moved can lower it: hats down to 1.39 of 1.72. */
bool plane_courant_limit(const MpmDef *def, double *courant, Status *status)
{
    Lattice2 lattice;
    bool fits, sound = false;
    *courant = 0.99 * endless_limit(def);
    bool good = build(&lattice, def, &fits, status);
    if (good && fits) {
        Cholesky *blend = &lattice.blend;
        for (size_t k = 0; k < lattice.size * (lattice.width + 1); k++)
            blend->rows[k] = (1 - def->flip_fraction) * lattice.mass.rows[k];
        for (size_t u = 0; u < lattice.size; u++)
            *entry(blend, u, u) += (1 + def->flip_fraction) * lattice.lumped[u];
        good = factor(blend, def, &sound, status);
    }
    if (good && sound) {
        const LinearMap stiffness = {stiffen, &lattice};
        double *start = lattice.work + lattice.size; /* any vector that has a part of every mode */
        uint32_t noise = 1;
        for (size_t u = 0; u < lattice.size; u++) {
            noise = noise * 1664525u + 1013904223u;
            start[u] = (double)noise / 4294967296.0 - 0.5;
        }
        clear_held(&lattice, start);
        const double eigenvalue =
            linear_largest(lattice.size, (LinearMap){drive, &lattice}, &stiffness, 1e-6, start);
        good = !isnan(eigenvalue) || errno == 0 ||
               (errno == ENOMEM ? status_fail(status, "not enough memory for the largest step")
                                : given_up(status));
        if (isfinite(eigenvalue))
            *courant = def->courant * sqrt(2 / eigenvalue) / lattice.model.dt;
    }
    free(lattice.memory);
    return good;
}
