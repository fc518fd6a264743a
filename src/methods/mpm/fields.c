/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What front ends read of bars, beams and bodies: what fields there can be, and a table of those of each.
 * Computed when read, from the state as it is in mid-step too: which stages are done decides whether a place
 * is the old or the new one, and a node's field is 0 before its stage. Of bodies set 1 has the nodes of all
 * velocity fields, one grid after the other. */
#include "base/assertion.h"
#include "base/math/functions.h"
#include "methods/axial.h"
#include "methods/mpm/engine.h"
#include "methods/mpm/mistakes.h"

/* --- what a field can be: its kind and its value ---------------------------------------------------- */

/* Across the plane: nu (sxx + syy) in plane strain, lambda ln J/J of the neo-Hookean law, 0 in plane stress.
 */
static double stress_across(const Mpm *mpm, int p)
{
    if (!mpm->bodies || mpm->def.plane == PLANE_STRESS)
        return 0.0;
    const double J = mpm->volume[p] / mpm->volume_start;
    return bodies_are_neo(mpm) ? mpm->lambda * math_log(J) / J
                               : mpm->def.poisson * (mpm->stress[0][p] + mpm->stress[1][p]);
}

/* sum of the squares of the velocity, a beam's common speed left out */
static double speed_squared(const Mpm *mpm, int p)
{
    const double vx = mpm->v[0][p] - mpm->speed, vy = mpm->v[1][p];
    return vx * vx + vy * vy;
}

/* von Mises: sqrt((a^2 + b^2 + c^2)/2 + 3 sxy^2) of the differences of the three normal stresses */
static double mises(const Mpm *mpm, int p)
{
    const double xx = mpm->stress[0][p], yy = mpm->stress[1][p], xy = mpm->stress[2][p];
    const double zz = stress_across(mpm, p), a = xx - yy, b = yy - zz, c = zz - xx;
    return sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * (xy * xy));
}

static double strain_increment(const Mpm *mpm, int p, int component)
{
    double e[MPM_STRESSES] = {0.0};
    if (mpm_has_done(mpm, OP_STRAIN))
        mpm_strain_step(mpm, p, e);
    return e[component];
}

static int body_of(const Mpm *mpm, int p)
{
    int body = 0;
    while (mpm->first[body + 1] <= p)
        body++;
    return body;
}

static int cell_of(const Mpm *mpm, int p)
{
    return mpm_cell(mpm->base[p], mpm->s[0][p], mpm->edge);
}

static double node_place(const Mpm *mpm, int axis, int node)
{
    const int at = mpm->bodies ? node % mpm->grid_nodes : node;
    const int k = axis == 0 ? at % mpm->gx : at / mpm->gx;
    if (mpm->dim == 1) {
        const int cell = node < mpm->cells ? node : mpm->cells - 1;
        const double offset = shape_node_offset(mpm->shape, mpm->half, mpm->cells, cell, node - cell);
        return ((cell - mpm->origin) + (offset - mpm->edge)) * mpm->dx;
    }
    if (mpm->bodies)
        return (k - BODIES_PADDING) * mpm->dx;
    return axis == 0 ? mpm->xmin + (mpm_shift(mpm, mpm->sim.step) + k) * mpm->dx : mpm->ymin + k * mpm->dx;
}

/* Of particle p; axis is a direction, or a component of stress. The place in the cell of a moved particle
 * counts from its old cell until the last stage. */
#define OF_PARTICLE(KIND)                                                                                    \
    KIND(P_X0, mpm_rest(mpm, axis, p))                                                                       \
    KIND(P_X, mpm_rest(mpm, axis, p) + mpm->u[axis][p])                                                      \
    KIND(P_U, mpm->u[axis][p])                                                                               \
    KIND(P_V, mpm->v[axis][p])                                                                               \
    KIND(P_STRESS, mpm->stress[axis][p])                                                                     \
    KIND(P_STRAIN, mpm->stress[0][p] / mpm_modulus(mpm, p))                                                  \
    KIND(P_DENSITY, mpm_mass(mpm, p) / mpm->volume[p])                                                       \
    KIND(P_MASS, mpm_mass(mpm, p))                                                                           \
    KIND(P_CELL, cell_of(mpm, p))                                                                            \
    KIND(P_NATURAL, mpm->rest[0][p] - mpm->edge - cell_of(mpm, p) + mpm->u[0][p] / mpm->dx)                  \
    KIND(P_STRAIN_INCREMENT, strain_increment(mpm, p, axis))                                                 \
    KIND(P_MOMENTUM, mpm_mass(mpm, p) * mpm->v[0][p])                                                        \
    KIND(P_AFFINE, mpm->affine[p])                                                                           \
    KIND(P_STRETCH, mpm->volume[p] * mpm->def.particles_per_cell / mpm->dx)                                  \
    KIND(P_BODY, body_of(mpm, p))                                                                            \
    KIND(P_MISES, mises(mpm, p))                                                                             \
    KIND(P_PRESSURE, -(mpm->stress[0][p] + mpm->stress[1][p] + stress_across(mpm, p)) / 3.0)                 \
    KIND(P_JACOBIAN, mpm->volume[p] / mpm->volume_start)                                                     \
    KIND(P_SPEED, sqrt(speed_squared(mpm, p)))                                                               \
    KIND(P_STRAIN_ENERGY, mpm_strain_at(mpm, p))                                                             \
    KIND(P_ENERGY_DENSITY, mpm_strain_at(mpm, p) / mpm->volume[p])                                           \
    KIND(P_KINETIC_ENERGY, 0.5 * mpm->mass[0] * speed_squared(mpm, p) * mpm->def.thickness)                  \
    KIND(P_PROBE, p == mpm->probe[0] || p == mpm->probe[1] || p == mpm->probe[2] || p == mpm->probe[3])

/* Of node i at any time; axis is a direction. */
#define OF_NODE(KIND)                                                                                        \
    KIND(N_X, node_place(mpm, axis, i))                                                                      \
    KIND(N_BODY, i / mpm->grid_nodes)                                                                        \
    KIND(N_FIXED, mpm->bodies ? bodies_at_wall(mpm, i) : mpm_held(mpm, mpm->sim.step, i) != 0)               \
    KIND(N_HELD, (mpm_held(mpm, mpm->sim.step, i) & (unsigned)(HELD_X << axis)) != 0)

/* Of a node as the grid stands, which is forgotten between steps: each is 0 before its stage. Axis is also a
 * distance in the mass matrix. */
#define OF_GRID(KIND)                                                                                        \
    KIND(N_MASS, mpm->node_mass[i])                                                                          \
    KIND(N_MOMENTUM, mpm->momentum[axis][i])                                                                 \
    KIND(N_VELOCITY, !(is_line || fixed) ? 0.0                                                               \
                     : mpm->bodies       ? mpm->momentum[axis][i] * mpm->inverse[i]                          \
                                         : mpm_node_velocity(mpm, axis, i))                                        \
    KIND(N_F_INT, forced ? mpm->force[0][i] : 0.0)                                                           \
    KIND(N_F_EXT, mpm_is_loaded(mpm) && forced ? mpm->load[i] : 0.0)                                         \
    KIND(N_F, !forced ? 0.0 : is_line ? mpm_node_force(mpm, 0, i) : mpm->force[axis][i])                     \
    KIND(N_ACCELERATION, !held         ? 0.0                                                                 \
                         : mpm->bodies ? mpm->force[axis][i] * mpm->inverse[i]                               \
                                       : mpm_node_acceleration(mpm, axis, i))                                \
    KIND(N_MASS_BESIDE, mpm_mass_between(mpm, i, i + axis))                                                  \
    KIND(N_NORMAL, mpm->normal[axis][i])                                                                     \
    KIND(N_ACTIVE, mpm->node_mass[i] > mpm->floor)                                                           \
    KIND(N_VELOCITY_NEW, mpm_node_velocity(mpm, 0, i) + (forced && !mpm_has_done(mpm, OP_INTEGRATE)          \
                                                             ? mpm->dt * mpm_node_acceleration(mpm, 0, i)    \
                                                             : 0.0)) /* (p_i + dt f_i)/m_i */

#define NAME(kind, value) kind,
typedef enum FieldKind { OF_PARTICLE(NAME) OF_NODE(NAME) OF_GRID(NAME) } FieldKind;

/* --- the fields of bars, beams and bodies ------------------------------------------------------------ */

#define PARTICLE(kind, axis, name, label, unit, meaning)                                                     \
    FIELD_ROW(kind, axis, MPM_PARTICLES, true, false, name, label, unit, meaning)
#define SHOWN(kind, axis, name, label, unit, meaning)                                                        \
    FIELD_ROW(kind, axis, MPM_PARTICLES, false, false, name, label, unit, meaning)
#define NODE(kind, axis, name, label, unit, meaning)                                                         \
    FIELD_ROW(kind, axis, MPM_NODES, true, false, name, label, unit, meaning)
#define NODE_SHOWN(kind, axis, name, label, unit, meaning)                                                   \
    FIELD_ROW(kind, axis, MPM_NODES, false, false, name, label, unit, meaning)
#define NODE_FLAG(kind, axis, name, label, meaning)                                                          \
    FIELD_ROW(kind, axis, MPM_NODES, false, true, name, label, "1", meaning)
#define AXIAL(which, name, label, unit, meaning) PARTICLE(P_##which, 0, name, label, unit, meaning)
#define MASSES(beside, name, label, which)                                                                   \
    NODE(N_MASS_BESIDE, beside, name, label, "mass/length^2", "mass matrix: " which)

static const Field line[] = {
    AXIAL_FIELD_ROWS(AXIAL, "axial stress, tension positive", "sum of the strain increments"),
    FIELD_ROW(P_CELL, 0, MPM_PARTICLES, false, true, "cell", "cell", "1",
              "cell of the mesh that the particle is in"),
    SHOWN(P_NATURAL, 0, "natural", "place in cell", "1", "0 at the left edge of its cell, 1 at the right"),
    SHOWN(P_STRAIN_INCREMENT, 0, "strain_increment", "strain increment", "1",
          "strain of this time step; 0 before its stage"),
    SHOWN(P_MOMENTUM, 0, "momentum", "momentum", "mass/(length*time)", "mass times velocity"),
    SHOWN(P_AFFINE, 0, "affine", "slope C", "1/time", "slope of the velocity that APIC carries"),
    PARTICLE(P_STRETCH, 0, "stretch", "stretch", "1", "length of the particle's domain over that at rest"),
    NODE(N_X, 0, "x", "x", "length", "position of the node (Greville abscissa of a B-spline)"),
    NODE(N_MASS, 0, "mass", "mass", "mass/length^2", "mass mapped from the particles"),
    NODE(N_MOMENTUM, 0, "momentum", "momentum", "mass/(length*time)", "momentum"),
    NODE(N_VELOCITY, 0, "velocity", "velocity", "length/time",
         "momentum over mass; 0 where the node is inactive"),
    NODE(N_F_INT, 0, "f_int", "internal force", "force/length^2", "force of the particles' stress"),
    NODE(N_F_EXT, 0, "f_ext", "external force", "force/length^2", "force of the loads that act"),
    NODE(N_F, 0, "f", "force", "force/length^2", "whole force; 0 at fixed nodes"),
    NODE_SHOWN(N_ACCELERATION, 0, "acceleration", "acceleration", "length/time^2", "force over mass"),
    MASSES(0, "mass_0", "M(i,i)", "the node's own"),
    MASSES(1, "mass_1", "M(i,i+1)", "shared with the next node"),
    MASSES(2, "mass_2", "M(i,i+2)", "shared with the next node but one"),
    MASSES(3, "mass_3", "M(i,i+3)", "shared with the next node but two"),
    NODE_FLAG(N_ACTIVE, 0, "active", "active", "1: the node has mass"),
    NODE_FLAG(N_FIXED, 0, "fixed", "fixed", "1: a support holds the node"),
    NODE_SHOWN(N_VELOCITY_NEW, 0, "velocity_new", "new velocity", "length/time",
               "velocity after the force has acted: it moves the particles"),
    {.set = 0},
};

static const Field plane[] = {
    PARTICLE(P_X0, 0, "x0", "x0", "m", "place along the beam at rest"),
    PARTICLE(P_X0, 1, "y0", "y0", "m", "place across the beam at rest, 0 on its mid-plane"),
    PARTICLE(P_X, 0, "x", "x", "m", "place along the beam"),
    PARTICLE(P_X, 1, "y", "y", "m", "place across the beam"),
    PARTICLE(P_U, 0, "ux", "ux", "m", "displacement along the beam"),
    PARTICLE(P_U, 1, "uy", "uy", "m", "displacement across the beam"),
    PARTICLE(P_V, 0, "vx", "vx", "m/s", "velocity along the beam"),
    PARTICLE(P_V, 1, "vy", "vy", "m/s", "velocity across the beam"),
    PARTICLE(P_STRESS, 0, "sxx", "stress xx", "Pa", "stress along the beam, tension positive"),
    PARTICLE(P_STRESS, 1, "syy", "stress yy", "Pa", "stress across the beam, tension positive"),
    PARTICLE(P_STRESS, 2, "sxy", "stress xy", "Pa", "shear stress"),
    PARTICLE(P_DENSITY, 0, "density", "density", "kg/m^3", "density"),
    PARTICLE(P_MASS, 0, "mass", "mass", "kg/m", "mass of the particle for each metre of thickness"),
    SHOWN(P_MISES, 0, "mises", "von Mises", "Pa",
          "von Mises' stress, sqrt(sxx^2 + syy^2 - sxx syy + 3 sxy^2)"),
    SHOWN(P_SPEED, 0, "speed", "speed", "m/s", "magnitude of the velocity, without the beam's common speed"),
    SHOWN(P_STRAIN_ENERGY, 0, "strain_energy", "strain energy", "J", "strain energy of the particle"),
    SHOWN(P_KINETIC_ENERGY, 0, "kinetic_energy", "kinetic energy", "J",
          "kinetic energy of the particle, without the common speed"),
    SHOWN(P_STRAIN_INCREMENT, 0, "exx", "strain step xx", "1",
          "strain of this time step along the beam; 0 before its stage"),
    SHOWN(P_STRAIN_INCREMENT, 1, "eyy", "strain step yy", "1",
          "strain of this time step across the beam; 0 before its stage"),
    SHOWN(P_STRAIN_INCREMENT, 2, "gxy", "shear step", "1",
          "shear strain of this time step; 0 before its stage"),
    FIELD_ROW(P_PROBE, 0, MPM_PARTICLES, false, true, "probe", "probe", "1", "1: the probe is beside it"),
    NODE(N_X, 0, "x", "x", "m", "place of the node along the beam"),
    NODE(N_X, 1, "y", "y", "m", "place of the node across the beam"),
    NODE(N_MASS, 0, "mass", "mass", "kg/m", "mass mapped from the particles"),
    NODE(N_MOMENTUM, 0, "px", "momentum x", "kg/s", "momentum along the beam"),
    NODE(N_MOMENTUM, 1, "py", "momentum y", "kg/s", "momentum across the beam"),
    NODE(N_F, 0, "fx", "force x", "N/m", "force along the beam; 0 where it is held"),
    NODE(N_F, 1, "fy", "force y", "N/m", "force across the beam; 0 where it is held"),
    NODE_SHOWN(N_VELOCITY, 0, "vx", "vx", "m/s",
               "momentum over mass; that of the beam where the node is inactive"),
    NODE_SHOWN(N_VELOCITY, 1, "vy", "vy", "m/s", "momentum over mass; 0 where the node is inactive"),
    NODE_SHOWN(N_ACCELERATION, 0, "ax", "acceleration x", "m/s^2", "force over mass"),
    NODE_SHOWN(N_ACCELERATION, 1, "ay", "acceleration y", "m/s^2", "force over mass"),
    NODE_FLAG(N_ACTIVE, 0, "active", "active", "1: the node has mass"),
    NODE_FLAG(N_FIXED, 0, "fixed", "fixed", "1: a support or the channel holds it, one way or both"),
    NODE_FLAG(N_HELD, 0, "held_x", "held x", "1: a support or the channel holds it along the beam"),
    NODE_FLAG(N_HELD, 1, "held_y", "held y", "1: a support or the channel holds it across"),
    {.set = 0},
};

static const Field bodies[] = {
    PARTICLE(P_X, 0, "x", "x", "length", "place along x"),
    PARTICLE(P_X, 1, "y", "y", "length", "place along y"),
    PARTICLE(P_X0, 0, "x0", "x0", "length", "place along x at t = 0"),
    PARTICLE(P_X0, 1, "y0", "y0", "length", "place along y at t = 0"),
    PARTICLE(P_V, 0, "vx", "vx", "length/time", "velocity along x"),
    PARTICLE(P_V, 1, "vy", "vy", "length/time", "velocity along y"),
    PARTICLE(P_STRESS, 0, "sxx", "stress xx", "force/area", "stress along x, tension positive"),
    PARTICLE(P_STRESS, 1, "syy", "stress yy", "force/area", "stress along y, tension positive"),
    PARTICLE(P_STRESS, 2, "sxy", "stress xy", "force/area", "shear stress"),
    PARTICLE(P_DENSITY, 0, "density", "density", "mass/volume", "density"),
    PARTICLE(P_MASS, 0, "mass", "mass", "mass/length", "mass of the particle per unit thickness"),
    FIELD_ROW(P_BODY, 0, MPM_PARTICLES, true, true, "body", "body", "1", "number of its body, from 0 on"),
    SHOWN(P_U, 0, "ux", "ux", "length", "displacement along x"),
    SHOWN(P_U, 1, "uy", "uy", "length", "displacement along y"),
    SHOWN(P_SPEED, 0, "speed", "speed", "length/time", "magnitude of the velocity"),
    SHOWN(P_MISES, 0, "mises", "von Mises", "force/area",
          "von Mises stress, with the stress across the plane"),
    SHOWN(P_PRESSURE, 0, "pressure", "pressure", "force/area", "minus the mean of the three normal stresses"),
    SHOWN(P_JACOBIAN, 0, "det_f", "det F", "1", "volume over that at t = 0"),
    SHOWN(P_STRAIN_ENERGY, 0, "strain_energy", "strain energy", "force*length",
          "strain energy of the particle"),
    SHOWN(P_ENERGY_DENSITY, 0, "energy_density", "energy density", "force/area", "strain energy over volume"),
    SHOWN(P_KINETIC_ENERGY, 0, "kinetic_energy", "kinetic energy", "force*length",
          "kinetic energy of the particle"),
    SHOWN(P_STRAIN_INCREMENT, 0, "exx", "strain step xx", "1",
          "strain of this time step along x; 0 before its stage"),
    SHOWN(P_STRAIN_INCREMENT, 1, "eyy", "strain step yy", "1",
          "strain of this time step along y; 0 before its stage"),
    SHOWN(P_STRAIN_INCREMENT, 2, "gxy", "shear step", "1",
          "shear strain of this time step; 0 before its stage"),
    NODE(N_X, 0, "x", "x", "length", "place of the node along x"),
    NODE(N_X, 1, "y", "y", "length", "place of the node along y"),
    NODE(N_MASS, 0, "mass", "mass", "mass/length", "mass mapped from the particles of its field"),
    NODE(N_MOMENTUM, 0, "px", "momentum x", "mass*length/time", "momentum along x"),
    NODE(N_MOMENTUM, 1, "py", "momentum y", "mass*length/time", "momentum along y"),
    NODE(N_F, 0, "fx", "force x", "force", "force along x"),
    NODE(N_F, 1, "fy", "force y", "force", "force along y"),
    FIELD_ROW(N_BODY, 0, MPM_NODES, true, true, "body", "body", "1",
              "body of its field; 0 where all share one"),
    NODE_SHOWN(N_VELOCITY, 0, "vx", "vx", "length/time", "momentum over mass; 0 where the node is light"),
    NODE_SHOWN(N_VELOCITY, 1, "vy", "vy", "length/time", "momentum over mass; 0 where the node is light"),
    NODE_SHOWN(N_ACCELERATION, 0, "ax", "acceleration x", "length/time^2", "force over mass"),
    NODE_SHOWN(N_ACCELERATION, 1, "ay", "acceleration y", "length/time^2", "force over mass"),
    NODE_SHOWN(N_NORMAL, 0, "nx", "normal x", "mass/length", "sum m dN/dx, which points out of the body"),
    NODE_SHOWN(N_NORMAL, 1, "ny", "normal y", "mass/length", "sum m dN/dy"),
    NODE_FLAG(N_ACTIVE, 0, "active", "active", "1: the node has mass"),
    NODE_FLAG(N_FIXED, 0, "fixed", "fixed", "1: a wall of the box acts on it"),
    {.set = 0},
};

/* The slope C is a column of a bar's table with APIC, the acceleration where masses are not lumped; their
 * matrix is there only then, as far as it reaches. */
void mpm_list_fields(Mpm *mpm)
{
    static const Field *const tables[] = {[MPM_BAR] = line, [MPM_BEAM] = plane, [MPM_BODIES] = bodies};
    const bool lumped = mpm_is_lumped(mpm);
    int count = 0;
    for (const Field *row = tables[mpm->def.problem]; row->quantity.name; row++) {
        ASSERT_INT(count, <, MPM_FIELDS);
        if ((row->kind == N_MASS_BESIDE && (lumped || row->axis > mpm->support - 1)) ||
            (row->kind == P_STRETCH && mpm->shape != MPM_CPDI))
            continue;
        Field *field = &mpm->fields[count++];
        *field = *row;
        if (row->kind == N_F_EXT)
            field->quantity.meaning = mpm->force_words.meaning;
        field->in_table |= (row->kind == P_AFFINE && mpm->head->transfer == MPM_APIC) ||
                           (row->kind == N_ACCELERATION && !lumped);
    }
    mpm->sim.fields = mpm->fields;
    mpm->sim.n_fields = count;
}

#define VALUE(kind, value)                                                                                   \
    case kind:                                                                                               \
        return value;

static double particle_field(const Mpm *mpm, FieldKind kind, int axis, int p)
{
    switch (kind) {
        OF_PARTICLE(VALUE)
    default:
        return 0.0;
    }
}

static double node_field(const Mpm *mpm, FieldKind kind, int axis, int i)
{
    const bool is_line = mpm->dim == 1, fixed = mpm_has_done(mpm, OP_FIX),
               forced = mpm_has_done(mpm, OP_FORCE);
    const bool held = is_line || mpm->bodies ? forced : mpm_has_done(mpm, OP_FIX_FORCE);
    if (kind >= N_MASS && !mpm_has_done(mpm, OP_MAP)) /* the first of OF_GRID */
        return 0.0;
    switch (kind) {
        OF_NODE(VALUE)
        OF_GRID(VALUE)
    default:
        return 0.0;
    }
}

void mpm_field(const Simulation *sim, int field, size_t first, size_t count, double *out)
{
    const Mpm *mpm = mpm_of_const(sim);
    ASSERT_INDEX(field, sim->n_fields);
    ASSERT_INT(first + count, <=, sim->counts[sim->fields[field].set]);
    const Field *const row = &sim->fields[field];
    for (int i = (int)first; i < (int)(first + count); i++)
        *out++ = (row->set == MPM_PARTICLES ? particle_field : node_field)(mpm, (FieldKind)row->kind,
                                                                           row->axis, i);
}
