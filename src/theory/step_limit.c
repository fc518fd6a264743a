/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The largest courant number with ends (step_limit.h), by two dense symmetric eigenproblems.
 *
 * With D = M_l^(-1/2) M M_l^(-1/2) = Q diag(d) Q^T the operator becomes Q diag(z) Q^T on both sides of the
 * scaled stiffness, and
 *
 *     lambda_max = that of diag(z)^(1/2) Q^T M_l^(-1/2) K M_l^(-1/2) Q diag(z)^(1/2)
 *     z = W/(1 + g) for USF and MUSL, T - W/(1 + g) for USL, T, W, g being those of F = d
 *
 * so two symmetric eigenproblems over the nodes suffice. They are dense because an iteration would hardly
 * converge: the gaps at the top of this spectrum fall as 1/n^2. CELLS_MOST bounds their size: its limit is at
 * most 1e-3 below that of a longer bar with the same ends, and never above it. */
#include "theory/step_limit.h"
#include "theory/bar_rest.h"
#include "theory/quiet.h"
#include "base/assertion.h"

#include <gsl/gsl_blas.h>
#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdlib.h>

enum { CELLS_MOST = 32 };

/* M_l^(-1/2) B M_l^(-1/2) of a band B. */
static void scaled(const BarRest *rest, const double *band, gsl_matrix *out)
{
    gsl_matrix_set_zero(out);
    for (int i = 0; i < rest->nodes; i++)
        for (int d = 0; d <= rest->reach && d <= i; d++) {
            const double x = band[i * (rest->reach + 1) + d] / sqrt(rest->mass[i]) / sqrt(rest->mass[i - d]);
            gsl_matrix_set(out, (size_t)i, (size_t)(i - d), x);
            gsl_matrix_set(out, (size_t)(i - d), (size_t)i, x);
        }
}

typedef struct Workspace {
    gsl_matrix *matrix, *basis, *product;
    gsl_vector *values;
    gsl_eigen_symmv_workspace *with_vectors;
    gsl_eigen_symm_workspace *alone;
} Workspace;

static bool reserve(Workspace *work, size_t n)
{
    *work = (Workspace){gsl_matrix_alloc(n, n), gsl_matrix_alloc(n, n),   gsl_matrix_alloc(n, n),
                        gsl_vector_alloc(n),    gsl_eigen_symmv_alloc(n), gsl_eigen_symm_alloc(n)};
    return work->matrix && work->basis && work->product && work->values && work->with_vectors && work->alone;
}

static void release(Workspace *work)
{
    gsl_matrix_free(work->matrix);
    gsl_matrix_free(work->basis);
    gsl_matrix_free(work->product);
    gsl_vector_free(work->values);
    gsl_eigen_symmv_free(work->with_vectors);
    gsl_eigen_symm_free(work->alone);
}

/* lambda_max as above; NAN: GSL found no eigenvalues. */
static double largest_eigenvalue(const BarRest *rest, const BarMesh *mesh, Workspace *work)
{
    scaled(rest, rest->consistent, work->matrix);
    if (!quiet_converges(work->matrix) ||
        gsl_eigen_symmv(work->matrix, work->values, work->basis, work->with_vectors))
        return NAN;
    for (size_t k = 0; k < (size_t)rest->nodes; k++) {
        const MeshResponse step = bar_mesh_response(mesh, gsl_vector_get(work->values, k));
        const double first = step.returns / (1 + step.kept);
        const double z = mesh->algorithm == MPM_USL ? step.moves - first : first;
        gsl_vector_view column = gsl_matrix_column(work->basis, k);
        gsl_vector_scale(&column.vector, sqrt(fmax(0, z)));
    }
    scaled(rest, rest->stiffness, work->matrix);
    gsl_blas_dgemm(CblasNoTrans, CblasNoTrans, 1, work->matrix, work->basis, 0, work->product);
    gsl_blas_dgemm(CblasTrans, CblasNoTrans, 1, work->basis, work->product, 0, work->matrix);
    return quiet_converges(work->matrix) && gsl_eigen_symm(work->matrix, work->values, work->alone) == 0
               ? gsl_vector_max(work->values)
               : NAN;
}

double step_limit_with_ends(const BarTheory *bar, const BarMesh *mesh)
{
    const double cells = round(bar->length / mesh->cell_size);
    const int kept = cells < CELLS_MOST ? (int)cells : CELLS_MOST;
    BarRest rest;
    Workspace work;
    double limit = NAN;
    gsl_errors_off();
    if (bar_rest_make(&rest, bar, mesh, kept)) {
        if (reserve(&work, (size_t)rest.nodes))
            limit = sqrt(2 / largest_eigenvalue(&rest, mesh, &work)) * bar_fastest_speed(bar) /
                    bar_wave_speed(bar);
        release(&work);
    } else if (rest.nodes < 1) {
        limit = INFINITY;
    }
    bar_rest_free(&rest);
    gsl_errors_on();
    return limit;
}

double step_limit(const BarTheory *bar, const BarMesh *mesh)
{
    return fmin(step_limit_with_ends(bar, mesh), dispersion_endless_courant(mesh));
}

/* Particles with their start and their share in v_cm; row p of `nodal` is column p of R. */
typedef struct Particles {
    int count;
    double *start, *weights, *nodal;
} Particles;

static double mass_in(const BarRest *rest, int cell)
{
    return (cell < rest->joint ? 1 : rest->density_beyond) / rest->per_cell;
}

/* False: not enough memory, or M is singular. */
static bool map_particles(const BarRest *rest, const BarTheory *bar, const BarMesh *mesh, Particles *all)
{
    double total = 0;
    for (int cell = 0; cell < rest->cells; cell++)
        total += rest->per_cell * mass_in(rest, cell);
    for (int p = 0; p < all->count; p++) {
        const int cell = p / rest->per_cell, j = p % rest->per_cell;
        const double root = sqrt(mass_in(rest, cell));
        const double xi = (j + 0.5 + rest->offset) / rest->per_cell;
        all->start[p] = root * bar_initial_velocity(bar, (cell + xi) * mesh->cell_size);
        all->weights[p] = root / total;
        double n[REST_SUPPORT_MAX], *row = all->nodal + (size_t)p * (size_t)rest->nodes;
        bar_rest_weights(rest, cell, j, n, NULL, NULL);
        for (int a = 0; a <= rest->degree; a++) {
            const int node = cell + rest->origin - rest->first_node + a;
            if (node >= 0 && node < rest->nodes)
                row[node] = root * n[a];
        }
        if (!bar_rest_solve_mass(rest, mesh->consistent, row))
            return false;
    }
    return true;
}

/* x . K y, in the units of the rest: of (c/dx)^2 */
static double through_stiffness(const BarRest *rest, const double *x, const double *y)
{
    double sum = 0;
    for (int i = 0; i < rest->nodes; i++) {
        const double *row = rest->stiffness + i * (rest->reach + 1);
        sum += row[0] * x[i] * y[i];
        for (int d = 1; d <= rest->reach && d <= i; d++)
            sum += row[d] * (x[i] * y[i - d] + x[i - d] * y[i]);
    }
    return sum;
}

static bool resolve(BarMotion *motion, const BarRest *rest, const BarTheory *bar, const BarMesh *mesh)
{
    const size_t n = (size_t)rest->cells * (size_t)rest->per_cell, nodes = (size_t)rest->nodes;
    const double rate = bar_wave_speed(bar) / mesh->cell_size;
    double *room = calloc(n * (2 + nodes), sizeof *room);
    Particles all = {(int)n, room, room ? room + n : NULL, room ? room + 2 * n : NULL};
    gsl_errors_off();
    gsl_matrix *s = gsl_matrix_alloc(n, n);
    gsl_errors_on();
    bool good = room && s && map_particles(rest, bar, mesh, &all);
    for (size_t p = 0; good && p < n; p++)
        for (size_t q = 0; q <= p; q++) {
            const double entry =
                rate * rate * through_stiffness(rest, all.nodal + p * nodes, all.nodal + q * nodes);
            gsl_matrix_set(s, p, q, entry);
            gsl_matrix_set(s, q, p, entry);
        }
    good = good && bar_motion_resolve(motion, s, all.start, all.weights);
    gsl_matrix_free(s);
    free(room);
    return good;
}

BarMotion *step_motion(const BarTheory *bar, const BarMesh *mesh)
{
    ASSERT_REAL(mesh->dt, >, 0);
    const double cells = round(bar->length / mesh->cell_size), particles = cells * mesh->particles_per_cell;
    if (mesh->algorithm == MPM_USL || mesh->fmpm_order > 0 || bar_mesh_flip(mesh) != 1 ||
        bar->body_force != 0 || bar->traction != 0 || bar->pulse.velocity != 0 || particles > STEP_MOTION_MAX)
        return NULL;
    BarRest rest;
    BarMotion *motion = bar_motion_create((int)particles, mesh->dt, mesh->algorithm == MPM_MUSL ? -0.5 : 0.5);
    if (!motion || !bar_rest_make(&rest, bar, mesh, (int)cells)) {
        bar_motion_free(motion);
        return NULL;
    }
    const bool good = resolve(motion, &rest, bar, mesh);
    bar_rest_free(&rest);
    if (good)
        return motion;
    bar_motion_free(motion);
    return NULL;
}
