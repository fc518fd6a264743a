/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "theory/step_motion.h"
#include "base/assertion.h"
#include "theory/bar_rest.h"
#include "theory/quiet.h"

#include <math.h>
#include <stdlib.h>

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
    quiet_begin();
    gsl_matrix *s = gsl_matrix_alloc(n, n);
    quiet_end();
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
