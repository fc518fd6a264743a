/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The definition of bodies: whether it is sound, and which particles it makes. Each line names the key as in
 * a scenario file, what is wrong and what is allowed. */
#include "methods/mpm/bodies_inner.h"

#include <string.h>

enum { PARTICLES_MAX = 2000000, NODES_MAX = 4000000 };

static const char *const wall_names[WALLS] = {"left", "right", "bottom", "top"};

/* --- shapes --------------------------------------------------------------------------------------- */

void bodies_centre(const BodyDef *body, double centre[2])
{
    const bool block = body->shape == BODY_BLOCK;
    for (int axis = 0; axis < 2; axis++)
        centre[axis] = block ? 0.5 * (body->size[axis] + body->size[2 + axis]) : body->size[axis];
}

void bodies_bounds(const BodyDef *body, double low[2], double high[2])
{
    const double radius = body->size[body->shape == BODY_RING ? 3 : 2];
    for (int axis = 0; axis < 2; axis++) {
        const bool block = body->shape == BODY_BLOCK;
        low[axis] = block ? body->size[axis] : body->size[axis] - radius;
        high[axis] = block ? body->size[2 + axis] : body->size[axis] + radius;
    }
}

bool bodies_hold(const BodyDef *body, double x, double y)
{
    const double *const size = body->size;
    if (body->shape == BODY_BLOCK)
        return x > size[0] && x < size[2] && y > size[1] && y < size[3];
    const double X = x - size[0], Y = y - size[1], squared = X * X + Y * Y;
    return body->shape == BODY_DISC ? squared < size[2] * size[2]
                                    : squared > size[2] * size[2] && squared < size[3] * size[3];
}

int bodies_body_of(const Mpm *mpm, int particle)
{
    int body = 0;
    while (mpm->bodies->first[body + 1] <= particle)
        body++;
    return body;
}

/* --- one value, one body -------------------------------------------------------------------------- */

static bool above(double value, const char *key, Status *status)
{
    return (value > 0 && isfinite(value)) ||
           status_refuse(status, "%s: %g is out of range (above 0)", key, value);
}

static bool at_least_zero(double value, const char *key, Status *status)
{
    return (value >= 0 && isfinite(value)) ||
           status_refuse(status, "%s: %g is out of range (at least 0)", key, value);
}

static bool whole_cells(double length, const char *key, double dx, Status *status)
{
    const double cells = length / dx;
    return (round(cells) >= 1 && fabs(cells - round(cells)) <= 1e-9 * cells) ||
           status_refuse(status, "%s: %g is %.10g cells (a whole number of mesh.cell_size = %g)", key, length,
                         cells, dx);
}

static bool check_numbers(const BodiesDef *def, Status *status)
{
    return above(def->width, "domain.width", status) && above(def->height, "domain.height", status) &&
           at_least_zero(def->wall_friction, "domain.wall_friction", status) &&
           above(def->youngs_modulus, "material.youngs_modulus", status) &&
           above(def->density, "material.density", status) &&
           ((def->poisson >= 0 && def->poisson <= 0.499) ||
            status_refuse(status, "material.poisson: %g is out of range (0 to 0.499)", def->poisson)) &&
           above(def->cell_size, "mesh.cell_size", status) &&
           whole_cells(def->width, "domain.width", def->cell_size, status) &&
           whole_cells(def->height, "domain.height", def->cell_size, status) &&
           at_least_zero(def->friction, "contact.friction", status) &&
           (def->gap > 0 ||
            status_refuse(status, "contact.gap: %g is out of range (above 0, or off)", def->gap)) &&
           at_least_zero(def->damping, "damping.rate", status) &&
           ((def->courant > 0 && def->courant <= 1) ||
            status_refuse(status, "time.courant: %g is out of range (above 0, at most 1)", def->courant));
}

static bool check_method(const BodiesDef *def, Status *status)
{
    if (def->particles_per_cell < 1 || def->particles_per_cell > 8)
        return status_refuse(status, "mesh.particles_per_cell: %d is out of range (1 to 8)",
                             def->particles_per_cell);
    if (def->shape == MPM_GIMP && def->particles_per_cell < 2)
        return status_refuse(
            status, "mesh.particles_per_cell: 1 is not enough for gimp (at least 2 along each side)");
    if (def->shape != MPM_HAT && def->shape != MPM_GIMP && def->shape != MPM_BSPLINE2)
        return status_refuse(status, "mpm.shape: is not for bodies (hat, gimp, bspline2)");
    if (def->transfer != MPM_FLIP && def->transfer != MPM_APIC)
        return status_refuse(status, "mpm.transfer: is not for bodies (flip, apic)");
    if (def->law == LAW_NEO_HOOKEAN && def->plane == PLANE_STRESS)
        return status_refuse(
            status, "material.plane: stress is not for the neo-hookean law (strain, or law = hypoelastic)");
    return true;
}

static bool check_body(const BodiesDef *def, const BodyDef *body, Status *status)
{
    const double box[2] = {def->width, def->height}, *const size = body->size;
    const double close = 1e-9 * (def->width + def->height);
    double low[2], high[2];
    if (body->shape != BODY_BLOCK && !(size[2] > 0))
        return status_refuse(status, "bodies.%s: radius %g is out of range (above 0)", body->name, size[2]);
    if (body->shape == BODY_RING && !(size[3] > size[2]))
        return status_refuse(status, "bodies.%s: outer radius %g is not above the inner one, %g", body->name,
                             size[3], size[2]);
    if (body->shape == BODY_BLOCK && !(size[2] > size[0] && size[3] > size[1]))
        return status_refuse(status, "bodies.%s: is empty (a block has x0 < x1 and y0 < y1)", body->name);
    if (body->shape != BODY_BLOCK && body->wave != 0)
        return status_refuse(status, "bodies.%s: wave is for a block (its first mode along x)", body->name);
    bodies_bounds(body, low, high);
    for (int axis = 0; axis < 2; axis++)
        if (!(low[axis] >= -close && high[axis] <= box[axis] + close))
            return status_refuse(status, "bodies.%s: reaches out of the box, %s from %g to %g (0 to %s = %g)",
                                 body->name, axis ? "y" : "x", low[axis], high[axis],
                                 axis ? "domain.height" : "domain.width", box[axis]);
    for (int wall = 0; wall < WALLS; wall++) {
        const double edge = wall % 2 ? high[wall / 2] : low[wall / 2];
        if (def->walls[wall] == WALL_CLAMP && body->spin != 0 &&
            fabs(edge - (wall % 2 ? box[wall / 2] : 0)) <= close)
            return status_refuse(status,
                                 "bodies.%s: spin %g, but the %s wall clamps it (0, or domain.%s = open)",
                                 body->name, body->spin, wall_names[wall], wall_names[wall]);
    }
    return true;
}

/* --- the whole ------------------------------------------------------------------------------------ */

/* c = sqrt(D_11/rho), of plane waves; dt = courant dx/c. */
static double wave_speed(const BodiesDef *def)
{
    const double nu = def->poisson, E = def->youngs_modulus;
    const double D11 =
        def->plane == PLANE_STRESS ? E / (1 - nu * nu) : E * (1 - nu) / ((1 + nu) * (1 - 2 * nu));
    return sqrt(D11 / def->density);
}

double bodies_step(const BodiesDef *def)
{
    return def->courant * def->cell_size / wave_speed(def);
}

/* Every body has a particle, and no particle two bodies. */
static bool check_particles(const BodiesDef *def, Status *status)
{
    const double d = def->cell_size / def->particles_per_cell;
    long all = 0;
    for (int k = 0; k < def->n_bodies; k++) {
        double low[2], high[2];
        long own = 0;
        bodies_bounds(&def->bodies[k], low, high);
        for (long j = (long)floor(low[1] / d) - 1; j <= (long)ceil(high[1] / d); j++)
            for (long i = (long)floor(low[0] / d) - 1; i <= (long)ceil(high[0] / d); i++) {
                const double x = ((double)i + 0.5) * d, y = ((double)j + 0.5) * d;
                if (!bodies_hold(&def->bodies[k], x, y))
                    continue;
                own++;
                for (int other = 0; other < k; other++)
                    if (bodies_hold(&def->bodies[other], x, y))
                        return status_refuse(status, "bodies.%s: overlaps bodies.%s at (%g, %g)",
                                             def->bodies[k].name, def->bodies[other].name, x, y);
            }
        if (own == 0)
            return status_refuse(status,
                                 "bodies.%s: has no particle (larger, or a smaller mesh.cell_size than %g)",
                                 def->bodies[k].name, def->cell_size);
        all += own;
    }
    return all <= PARTICLES_MAX || status_refuse(status, "mesh.cell_size: %g makes more than %d particles",
                                                 def->cell_size, PARTICLES_MAX);
}

bool bodies_check(const BodiesDef *def, Status *status)
{
    if (!check_numbers(def, status) || !check_method(def, status))
        return false;
    if (def->n_bodies == 0)
        return status_refuse(status, "bodies: there is none (at least one line, NAME = disc CX CY R)");
    if (!(bodies_step(def) > 0 && isfinite(bodies_step(def))))
        return status_refuse(
            status, "material.youngs_modulus: %g over the density %g makes waves of speed %g: no time step",
            def->youngs_modulus, def->density, wave_speed(def));
    /* q loses damping dt q in a step: from 2 on it grows, from 1 on it turns about */
    if (!(def->damping * bodies_step(def) < 1))
        return status_refuse(status,
                             "damping.rate: %g is too much for the time step %.4g (below 1/dt = %.4g)",
                             def->damping, bodies_step(def), 1 / bodies_step(def));
    const double fields = def->fields == FIELDS_EACH ? def->n_bodies : 1, more = 2 * BODIES_PADDING + 1;
    const double P = def->particles_per_cell,
                 cells[2] = {def->width / def->cell_size, def->height / def->cell_size};
    if (!(fields * (cells[0] + more) * (cells[1] + more) <= NODES_MAX) ||
        !(cells[0] * cells[1] * P * P <= 4.0 * PARTICLES_MAX))
        return status_refuse(status, "mesh.cell_size: %g makes more than %d nodes of all fields",
                             def->cell_size, NODES_MAX);
    if (!bodies_mistake_check(def, status))
        return false;
    for (int k = 0; k < def->n_bodies; k++)
        if (!check_body(def, &def->bodies[k], status))
            return false;
    return check_particles(def, status);
}
