/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What front ends read of a beam: fields, links, shapes. Computed when read, from the state as it stands in
 * mid-step too; a node's field is 0 before its stage. */
#include "methods/mpm/plane/plane_state.h"

#include "base/assertion.h"

#include <math.h>

enum FieldIndex {
    P_X0,
    P_Y0,
    P_X,
    P_Y,
    P_UX,
    P_UY,
    P_VX,
    P_VY,
    P_SXX,
    P_SYY,
    P_SXY,
    P_DENSITY,
    P_MASS,
    P_MISES,
    P_SPEED,
    P_STRAIN_ENERGY,
    P_KINETIC_ENERGY,
    P_EXX,
    P_EYY,
    P_GXY,
    P_PROBE,
    N_X,
    N_Y,
    N_MASS,
    N_PX,
    N_PY,
    N_FX,
    N_FY,
    N_VX,
    N_VY,
    N_AX,
    N_AY,
    N_ACTIVE,
    N_FIXED,
    N_HELD_X,
    N_HELD_Y,
    FIELDS
};

#define PARTICLE(name, label, unit, meaning)                                                                 \
    FIELD_ROW(PLANE_PARTICLES, true, false, name, label, unit, meaning)
#define SHOWN(name, label, unit, meaning) FIELD_ROW(PLANE_PARTICLES, false, false, name, label, unit, meaning)
#define NODE(name, label, unit, meaning)  FIELD_ROW(PLANE_NODES, true, false, name, label, unit, meaning)
#define NODE_SHOWN(whole, name, label, unit, meaning)                                                        \
    FIELD_ROW(PLANE_NODES, false, whole, name, label, unit, meaning)

static const Field fields[FIELDS] = {
    [P_X0] = PARTICLE("x0", "x0", "m", "place along the beam at rest"),
    [P_Y0] = PARTICLE("y0", "y0", "m", "place across the beam at rest, 0 on its mid-plane"),
    [P_X] = PARTICLE("x", "x", "m", "place along the beam"),
    [P_Y] = PARTICLE("y", "y", "m", "place across the beam"),
    [P_UX] = PARTICLE("ux", "ux", "m", "displacement along the beam"),
    [P_UY] = PARTICLE("uy", "uy", "m", "displacement across the beam"),
    [P_VX] = PARTICLE("vx", "vx", "m/s", "velocity along the beam"),
    [P_VY] = PARTICLE("vy", "vy", "m/s", "velocity across the beam"),
    [P_SXX] = PARTICLE("sxx", "stress xx", "Pa", "stress along the beam, tension positive"),
    [P_SYY] = PARTICLE("syy", "stress yy", "Pa", "stress across the beam, tension positive"),
    [P_SXY] = PARTICLE("sxy", "stress xy", "Pa", "shear stress"),
    [P_DENSITY] = PARTICLE("density", "density", "kg/m^3", "density"),
    [P_MASS] = PARTICLE("mass", "mass", "kg/m", "mass of the particle for each metre of thickness"),
    [P_MISES] =
        SHOWN("mises", "von Mises", "Pa", "von Mises' stress, sqrt(sxx^2 + syy^2 - sxx syy + 3 sxy^2)"),
    [P_SPEED] = SHOWN("speed", "speed", "m/s", "magnitude of the velocity, without the beam's common speed"),
    [P_STRAIN_ENERGY] = SHOWN("strain_energy", "strain energy", "J", "strain energy of the particle"),
    [P_KINETIC_ENERGY] = SHOWN("kinetic_energy", "kinetic energy", "J",
                               "kinetic energy of the particle, without the common speed"),
    [P_EXX] =
        SHOWN("exx", "strain step xx", "1", "strain of this time step along the beam; 0 before its stage"),
    [P_EYY] =
        SHOWN("eyy", "strain step yy", "1", "strain of this time step across the beam; 0 before its stage"),
    [P_GXY] = SHOWN("gxy", "shear step", "1", "shear strain of this time step; 0 before its stage"),
    [P_PROBE] = FIELD_ROW(PLANE_PARTICLES, false, true, "probe", "probe", "1", "1: the probe is beside it"),
    [N_X] = NODE("x", "x", "m", "place of the node along the beam"),
    [N_Y] = NODE("y", "y", "m", "place of the node across the beam"),
    [N_MASS] = NODE("mass", "mass", "kg/m", "mass mapped from the particles"),
    [N_PX] = NODE("px", "momentum x", "kg/s", "momentum along the beam"),
    [N_PY] = NODE("py", "momentum y", "kg/s", "momentum across the beam"),
    [N_FX] = NODE("fx", "force x", "N/m", "force along the beam; 0 where it is held"),
    [N_FY] = NODE("fy", "force y", "N/m", "force across the beam; 0 where it is held"),
    [N_VX] = NODE_SHOWN(false, "vx", "vx", "m/s",
                        "momentum over mass; that of the beam where the node is inactive"),
    [N_VY] = NODE_SHOWN(false, "vy", "vy", "m/s", "momentum over mass; 0 where the node is inactive"),
    [N_AX] = NODE_SHOWN(false, "ax", "acceleration x", "m/s^2", "force over mass"),
    [N_AY] = NODE_SHOWN(false, "ay", "acceleration y", "m/s^2", "force over mass"),
    [N_ACTIVE] = NODE_SHOWN(true, "active", "active", "1", "1: the node has mass"),
    [N_FIXED] =
        NODE_SHOWN(true, "fixed", "fixed", "1", "1: a support or the channel holds it, one way or both"),
    [N_HELD_X] =
        NODE_SHOWN(true, "held_x", "held x", "1", "1: a support or the channel holds it along the beam"),
    [N_HELD_Y] = NODE_SHOWN(true, "held_y", "held y", "1", "1: a support or the channel holds it across"),
};

void plane_set_fields(Plane *plane)
{
    Simulation *sim = &plane->sim;
    sim->fields = fields;
    sim->n_fields = FIELDS;
    sim->has = HAS_PLANE | HAS_MESH | (plane->speed > 0 ? HAS_RELATIVE_ENERGY : 0);
    sim->common_speed = plane->speed;
    simulation_lay(sim, (size_t)plane->nxp, (size_t)plane->nyp, plane->spacing, 2,
                   (MotionFields[]){{P_X0, P_UX, P_VX}, {P_Y0, P_UY, P_VY}});
}

static double rest_x(const Plane *plane, int p)
{
    return plane->x_first + (p % plane->nxp + 0.5) * plane->spacing;
}

static double rest_y(const Plane *plane, int p)
{
    return (p / plane->nxp + 0.5) * plane->spacing - plane->def.height / 2;
}

/* dt sum of N' v_i: the strain of this step, from the velocities that made it. */
static double strain_step(const Plane *plane, int field, int p)
{
    if (!plane_has_done(plane, PLANE_STRAIN))
        return 0;
    const int at = plane_at(plane, p);
    const PlaneWeights w = plane_weights(plane, plane->sx[at], plane->sy[at]);
    double xx = 0, yy = 0, xy = 0;
    for (int b = 0; b < plane->support; b++)
        for (int a = 0; a < plane->support; a++) {
            const int node = plane->base[at] + b * plane->gx + a;
            const double bx = w.dnx[a] * w.ny[b], by = w.nx[a] * w.dny[b];
            double v[2];
            plane_strain_velocity(plane, node, v);
            xx += bx * v[0];
            yy += by * v[1];
            xy += by * v[0] + bx * v[1];
        }
    return plane->dt / plane->dx * (field == P_EXX ? xx : field == P_EYY ? yy : xy);
}

/* The value of one particle's field; m, m/s, Pa, J. */
static double particle_field(const Plane *plane, int field, int p)
{
    const int at = plane_at(plane, p);
    const double xx = plane->sxx[at], yy = plane->syy[at], xy = plane->sxy[at];
    const double vx = plane->vx[at] - plane->speed, vy = plane->vy[at];
    switch (field) {
    case P_X0:
        return rest_x(plane, p);
    case P_Y0:
        return rest_y(plane, p);
    case P_X:
        return plane->x[at];
    case P_Y:
        return plane->y[at];
    case P_UX:
        return plane->x[at] - rest_x(plane, p);
    case P_UY:
        return plane->y[at] - rest_y(plane, p);
    case P_VX:
        return plane->vx[at];
    case P_VY:
        return vy;
    case P_SXX:
        return xx;
    case P_SYY:
        return yy;
    case P_SXY:
        return xy;
    case P_DENSITY:
        return plane->mass / plane->volume[at];
    case P_MASS:
        return plane->mass;
    case P_MISES:
        return sqrt(fmax(xx * xx + yy * yy - xx * yy + 3 * (xy * xy), 0));
    case P_SPEED:
        return sqrt(vx * vx + vy * vy);
    case P_STRAIN_ENERGY:
        return plane_strain_at(plane, at);
    case P_KINETIC_ENERGY:
        return plane->mass / 2 * (vx * vx + vy * vy) * plane->def.thickness;
    case P_EXX:
    case P_EYY:
    case P_GXY:
        return strain_step(plane, field, p);
    case P_PROBE:
        return p == plane->probe[0] || p == plane->probe[1] || p == plane->probe[2] || p == plane->probe[3];
    default:
        return 0;
    }
}

/* The value of one node's field: 0 between steps, and before the stage that makes it. */
static double node_field(const Plane *plane, int field, int node)
{
    const int i = node % plane->gx, j = node / plane->gx;
    const bool mapped = plane->sim.stage > 0, moves = plane_has_done(plane, PLANE_HOLD);
    switch (field) {
    case N_X:
        return plane_xmin(plane, plane->sim.step) + i * plane->dx;
    case N_Y:
        return plane->ymin + j * plane->dx;
    case N_FIXED: {
        const PlaneHeld held = plane_held(plane, plane->sim.step, i, j);
        return held.x || held.y;
    }
    case N_HELD_X:
        return plane_held(plane, plane->sim.step, i, j).x;
    case N_HELD_Y:
        return plane_held(plane, plane->sim.step, i, j).y;
    default:
        break;
    }
    if (!mapped) /* the grid is forgotten between steps */
        return 0;
    const double *const arrays[] = {
        [N_MASS] = plane->node_mass, [N_PX] = plane->px,      [N_PY] = plane->py,      [N_FX] = plane->fx,
        [N_FY] = plane->fy,          [N_VX] = plane->node_vx, [N_VY] = plane->node_vy,
    };
    if (field == N_AX || field == N_AY)
        return plane_has_done(plane, PLANE_HOLD_FORCE) ? plane_acceleration(plane, field == N_AY, node) : 0;
    if (field == N_ACTIVE)
        return plane->node_mass[node] > plane->floor;
    if ((field == N_VX || field == N_VY) && !moves)
        return 0;
    return arrays[field][node];
}

void plane_field(const Simulation *sim, int field, size_t first, size_t count, double *out)
{
    const Plane *plane = plane_of_const(sim);
    ASSERT_INT(field, <, FIELDS);
    ASSERT_INT(first + count, <=, sim->counts[fields[field].set]);
    for (size_t k = 0; k < count; k++)
        out[k] = fields[field].set == PLANE_PARTICLES ? particle_field(plane, field, (int)(first + k))
                                                      : node_field(plane, field, (int)(first + k));
}

/* The nodes that a place shares in; those with neither weight nor slope are left out. */
static size_t links_at(const Plane *plane, int32_t base, double sx, double sy, Link *out, size_t max)
{
    const PlaneWeights w = plane_weights(plane, sx, sy);
    size_t count = 0;
    for (int b = 0; b < plane->support; b++)
        for (int a = 0; a < plane->support && count < max; a++) {
            Link link = {.set = PLANE_NODES,
                         .index = (size_t)(base + b * plane->gx + a),
                         .weight = w.nx[a] * w.ny[b],
                         .gradient = {w.dnx[a] * w.ny[b] / plane->dx, w.nx[a] * w.dny[b] / plane->dx}};
            if (link.weight != 0 || link.gradient[0] != 0 || link.gradient[1] != 0)
                out[count++] = link;
        }
    return count;
}

size_t plane_links(const Simulation *sim, int set, size_t index, Link *out, size_t max)
{
    const Plane *plane = plane_of_const(sim);
    int32_t base;
    double sx, sy;
    ASSERT_INT(index, <, sim->counts[set]);
    if (set == PLANE_PARTICLES)
        return plane_place_of(plane, (int)index, &base, &sx, &sy) ? links_at(plane, base, sx, sy, out, max)
                                                                  : 0;
    size_t count = 0;
    for (int p = 0; p < plane->n_particles && count < max; p++) {
        Link of_particle[PLANE_SUPPORT_MAX * PLANE_SUPPORT_MAX];
        if (!plane_place_of(plane, p, &base, &sx, &sy))
            continue;
        const int column = (int)index % plane->gx - base % plane->gx,
                  row = (int)index / plane->gx - base / plane->gx;
        if (column < 0 || column >= plane->support || row < 0 || row >= plane->support)
            continue;
        const size_t n = links_at(plane, base, sx, sy, of_particle, PLANE_SUPPORT_MAX * PLANE_SUPPORT_MAX);
        for (size_t k = 0; k < n; k++)
            if (of_particle[k].index == index) {
                out[count] = of_particle[k];
                out[count].set = PLANE_PARTICLES;
                out[count++].index = (size_t)p;
            }
    }
    return count;
}

size_t plane_shapes(const Simulation *sim, const double *place, Link *out, size_t max)
{
    const Plane *plane = plane_of_const(sim);
    int32_t base;
    double sx, sy;
    if (!plane_find(plane, plane_xmin(plane, sim->step), place[0], place[1], &base, &sx, &sy))
        return 0;
    return links_at(plane, base, sx, sy, out, max);
}
