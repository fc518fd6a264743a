/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether the values of a definition fit each other. Each line names the key as in a scenario file, what is
 * wrong and what is allowed. The range of a single value is in its row of the parameter table. */
#include "methods/axial.h"
#include "methods/mpm/mistakes.h"

/* A particle takes some 150 to 200 bytes, and a step of so many a tenth of a second: more would not answer.
 */
enum { CELLS_MAX = 2000000, PARTICLES_MAX = 2000000, NODES_MAX = 4000000 };
enum { ROWS_MAX = 10000, PADDING_MAX = 1000 };

/* --- cells and time --------------------------------------------------------------------------------- */

static bool is_whole(double cells)
{
    return round(cells) >= 1 && fabs(cells - round(cells)) <= 1e-9 * cells;
}

/* A length of a beam, even ones only if asked. */
static bool whole_cells(const MpmDef *def, double length, bool even, const char *what, Status *status)
{
    const double cells = length / def->cell_size;
    return (is_whole(cells) && !(even && fmod(round(cells), 2) != 0)) ||
           status_refuse(status, "mesh.cell_size: the %s of %g m must be %s number of cells, not %.10g", what,
                         length, even ? "an even" : "a whole", cells);
}

static double wave_speed(const MpmDef *def)
{
    const double E = def->youngs_modulus, nu = def->poisson;
    if (def->problem == MPM_BODIES) /* c = sqrt(D_11/rho), of plane waves */
        return sqrt(
            (def->plane == PLANE_STRESS ? E / (1 - nu * nu) : E * (1 - nu) / ((1 + nu) * (1 - 2 * nu))) /
            def->density);
    if (def->problem == MPM_BEAM) /* of long waves along a plate in plane stress */
        return sqrt(E / (def->density * (1 - nu * nu)));
    const double first = sqrt(E / def->density);
    return def->joint > 0 ? fmax(first, sqrt(def->joint_modulus / def->joint_density)) : first;
}

/* Of a beam stable up to a Courant number of about 1.7 (USF, MUSL) or .75 (USL) on the undeformed lattice;
 * less once particles have moved (plane_modes.c). */
double mpm_time_step(const MpmDef *def)
{
    const double dx =
        def->problem == MPM_BAR ? def->length / round(def->length / def->cell_size) : def->cell_size;
    return def->courant * dx / wave_speed(def);
}

static bool check_step(const MpmDef *def, Status *status)
{
    static const char *const of[] = {"bar", "beam", "material"};
    const double speed = wave_speed(def), dt = def->courant * def->cell_size / speed;
    return (dt > 0 && isfinite(dt) && isfinite(speed)) ||
           status_refuse(status,
                         "%s.youngs_modulus: %g over the density %g makes waves of speed %g: no time step",
                         of[def->problem], def->youngs_modulus, def->density, speed);
}

/* --- in the plane ----------------------------------------------------------------------------------- */

static bool check_method(const MpmDef *def, Status *status)
{
    if (def->shape != MPM_HAT && def->shape != MPM_GIMP && def->shape != MPM_BSPLINE2)
        return status_refuse(status, "mpm.shape: is not for %s (hat, gimp, bspline2)",
                             def->problem == MPM_BEAM ? "beams" : "bodies");
    if (def->shape == MPM_GIMP && def->particles_per_cell < 2)
        return status_refuse(
            status, "mesh.particles_per_cell: 1 is not enough for gimp (at least 2 along each side)");
    return true;
}

/* --- bars ------------------------------------------------------------------------------------------- */

static bool check_bar(const MpmDef *def, Status *status)
{
    const double cells = def->length / def->cell_size, mu = def->mass_blend;
    /* M_c alone is singular where there are fewer particles than nodes, and nearly so where a cell at the end
     * of the bar is nearly empty: the largest stable step then falls with what is left in it. With mu > 0 it
     * has a floor that does not depend on how particles lie (USF and MUSL, hats: .24 at mu .05, .049 at .01)
     */
    const double best = bar_mass_blend_auto(def->shape, def->particles_per_cell, def->courant);
    if (mu == 0.0 && def->offset != 0.0)
        return status_refuse(status,
                             "mpm.mass_blend: auto is known for particles in the middle of their shares "
                             "(%g to 1, or initial.offset 0)",
                             BAR_MASS_BLEND_LEAST);
    if (mu == 0.0 && best < BAR_MASS_BLEND_LEAST)
        return status_refuse(
            status,
            "mpm.mass_blend: auto would be %.4g with this shape, and below %g the largest stable "
            "step nearly vanishes where a cell is nearly empty (%g to 1)",
            best, BAR_MASS_BLEND_LEAST, BAR_MASS_BLEND_LEAST);
    if (mu != 0.0 && !(mu >= BAR_MASS_BLEND_LEAST))
        return status_refuse(status,
                             "mpm.mass_blend: with %g the largest stable step nearly vanishes where a "
                             "cell is nearly empty (%g to 1, or auto)",
                             mu, BAR_MASS_BLEND_LEAST);
    if (mu != 1.0 && def->transfer != MPM_FLIP)
        return status_refuse(status,
                             "mpm.mass_blend: less than 1 is for mpm.transfer = flip (1, or that transfer)");
    if (!check_step(def, status))
        return false;
    if (!(cells <= CELLS_MAX))
        return status_refuse(status, "mesh.cell_size: %g makes more than %d cells of a bar of length %g",
                             def->cell_size, CELLS_MAX, def->length);
    if (!is_whole(cells))
        return status_refuse(status,
                             "mesh.cell_size: the length %g must be a whole number of cells, not %.10g",
                             def->length, cells);
    if ((long)round(cells) * def->particles_per_cell > PARTICLES_MAX)
        return status_refuse(status, "mesh.particles_per_cell: more than %d particles are not possible",
                             PARTICLES_MAX);
    if (def->joint != 0.0 &&
        !(def->joint < def->length * (1 - 1e-9) && is_whole(def->joint / def->cell_size)))
        return status_refuse(
            status,
            "bar2.joint: %g is not a node inside the bar (0, or a whole number of cells less than "
            "the length %g)",
            def->joint, def->length);
    return mpm_check_mistakes(def, status) &&
           axial_check_layer(def->traction_layer, def->cell_size / def->particles_per_cell, def->length,
                             status);
}

/* --- beams ------------------------------------------------------------------------------------------ */

static bool check_beam(const MpmDef *def, Status *status)
{
    if (def->padding < 1 || def->padding > PADDING_MAX)
        return status_refuse(status, "mesh.padding: %d is out of range (1 to %d)", def->padding, PADDING_MAX);
    if (!check_method(def, status) || !mpm_check_mistakes(def, status) ||
        !whole_cells(def, def->length, false, "length", status) ||
        !whole_cells(def, def->height, true, "height", status))
        return false;
    /* the channel must hold the beam to the end: more than v0 t_end of it lies behind the mouth at t = 0 */
    if (def->leaves_channel && !(def->channel > def->speed * def->end))
        return status_refuse(
            status, "motion.channel: %g is too short for time.end (more than motion.speed * time.end = %g)",
            def->channel, def->speed * def->end);
    if (def->leaves_channel && !(def->grid_velocity <= def->speed))
        return status_refuse(status, "mesh.velocity: %g is out of range (0 to motion.speed = %g)",
                             def->grid_velocity, def->speed);
    if ((def->leaves_channel && !whole_cells(def, def->channel, false, "channel", status)) ||
        !check_step(def, status))
        return false;
    const double length = def->length + (def->leaves_channel ? def->channel : 0);
    const double cells = length / def->cell_size * (def->height / def->cell_size);
    if (!(cells * def->particles_per_cell * def->particles_per_cell <= PARTICLES_MAX))
        return status_refuse(status, "mesh.cell_size: %g makes more than %d particles", def->cell_size,
                             PARTICLES_MAX);
    const double rows = def->height / def->cell_size + 2 * def->padding + 1;
    if (!(rows <= ROWS_MAX))
        return status_refuse(status, "mesh.cell_size: %g makes more than %d rows of nodes", def->cell_size,
                             ROWS_MAX);
    /* the last step may end behind the end */
    const double way =
        def->leaves_channel ? (def->speed - def->grid_velocity) * (def->end + mpm_time_step(def)) : 0;
    if (!((length + way) / def->cell_size + 2 * def->padding + 2 < NODES_MAX / rows))
        return status_refuse(status, "mesh.padding: the grid has more than %d nodes", NODES_MAX);
    return true;
}

/* --- bodies ----------------------------------------------------------------------------------------- */

static bool check_body(const MpmDef *def, const BodyDef *body, Status *status)
{
    const double box[2] = {def->length, def->height}, *const size = body->size;
    const double close = 1e-9 * (def->length + def->height);
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
                                 body->name, body->spin, bodies_walls[wall], bodies_walls[wall]);
    }
    return true;
}

static bool check_bodies(const MpmDef *def, Status *status)
{
    const double box[] = {def->length, def->height};
    const double cells[] = {def->length / def->cell_size, def->height / def->cell_size};
    for (int axis = 0; axis < 2; axis++)
        if (!is_whole(cells[axis]))
            return status_refuse(status,
                                 "domain.%s: %g is %.10g cells (a whole number of mesh.cell_size = %g)",
                                 axis ? "height" : "width", box[axis], cells[axis], def->cell_size);
    if (!check_method(def, status))
        return false;
    if (!(def->courant <= 1))
        return status_refuse(status, "time.courant: %g is out of range (above 0, at most 1)", def->courant);
    if (def->transfer != MPM_FLIP && def->transfer != MPM_APIC)
        return status_refuse(status, "mpm.transfer: is not for bodies (flip, apic)");
    if (def->law == LAW_NEO_HOOKEAN && def->plane == PLANE_STRESS)
        return status_refuse(
            status, "material.plane: stress is not for the neo-hookean law (strain, or law = hypoelastic)");
    if (def->n_bodies == 0)
        return status_refuse(status, "bodies: there is none (at least one line, NAME = disc CX CY R)");
    if (!check_step(def, status))
        return false;
    /* q loses damping dt q in a step: from 2 on it grows, from 1 on it turns about */
    const double dt = mpm_time_step(def);
    if (!(def->damping * dt < 1))
        return status_refuse(status,
                             "damping.rate: %g is too much for the time step %.4g (below 1/dt = %.4g)",
                             def->damping, dt, 1 / dt);
    const double fields = def->fields == FIELDS_EACH ? def->n_bodies : 1, more = 2 * BODIES_PADDING + 1;
    const double P = def->particles_per_cell;
    if (!(fields * (cells[0] + more) * (cells[1] + more) <= NODES_MAX) ||
        !(cells[0] * cells[1] * P * P <= 4.0 * PARTICLES_MAX))
        return status_refuse(status, "mesh.cell_size: %g makes more than %d nodes of all fields",
                             def->cell_size, NODES_MAX);
    if (!mpm_check_mistakes(def, status))
        return false;
    for (int k = 0; k < def->n_bodies; k++)
        if (!check_body(def, &def->bodies[k], status))
            return false;
    /* every body has a particle, and no particle two bodies */
    long all = 0;
    for (int k = 0; k < def->n_bodies; k++) {
        const long before = all;
        for (BodyWalk walk = bodies_walk(def, k); bodies_next(&walk); all++)
            for (int other = 0; other < k; other++)
                if (bodies_hold(&def->bodies[other], walk.x, walk.y))
                    return status_refuse(status, "bodies.%s: overlaps bodies.%s at (%g, %g)",
                                         def->bodies[k].name, def->bodies[other].name, walk.x, walk.y);
        if (all == before)
            return status_refuse(status,
                                 "bodies.%s: has no particle (larger, or a smaller mesh.cell_size than %g)",
                                 def->bodies[k].name, def->cell_size);
    }
    return all <= PARTICLES_MAX || status_refuse(status, "mesh.cell_size: %g makes more than %d particles",
                                                 def->cell_size, PARTICLES_MAX);
}

bool mpm_check(const MpmDef *def, Status *status)
{
    return def->problem == MPM_BAR    ? check_bar(def, status)
           : def->problem == MPM_BEAM ? check_beam(def, status)
                                      : check_bodies(def, status);
}
