/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What front ends read of bodies: fields, computed when read, from the state as it is in mid-step too; a
 * node's field is 0 before its stage. Set 1 has the nodes of all fields, one grid after the other. */
#include "base/assertion.h"
#include "base/math/functions.h"
#include "methods/mpm/bodies_inner.h"

enum FieldIndex {
    P_X,
    P_Y,
    P_X0,
    P_Y0,
    P_VX,
    P_VY,
    P_SXX,
    P_SYY,
    P_SXY,
    P_DENSITY,
    P_MASS,
    P_BODY,
    P_UX,
    P_UY,
    P_SPEED,
    P_MISES,
    P_PRESSURE,
    P_JACOBIAN,
    P_STRAIN_ENERGY,
    P_ENERGY_DENSITY,
    P_KINETIC_ENERGY,
    P_EXX,
    P_EYY,
    P_GXY,
    N_X,
    N_Y,
    N_MASS,
    N_PX,
    N_PY,
    N_FX,
    N_FY,
    N_BODY,
    N_VX,
    N_VY,
    N_AX,
    N_AY,
    N_NX,
    N_NY,
    N_ACTIVE,
    N_FIXED,
    FIELDS
};

#define PARTICLE(name, label, unit, meaning) FIELD_ROW(MPM_PARTICLES, true, false, name, label, unit, meaning)
#define SHOWN(name, label, unit, meaning)    FIELD_ROW(MPM_PARTICLES, false, false, name, label, unit, meaning)
#define NODE(name, label, unit, meaning)     FIELD_ROW(MPM_NODES, true, false, name, label, unit, meaning)
#define NODE_SHOWN(whole, name, label, unit, meaning)                                                        \
    FIELD_ROW(MPM_NODES, false, whole, name, label, unit, meaning)

static const Field fields[FIELDS] = {
    [P_X] = PARTICLE("x", "x", "length", "place along x"),
    [P_Y] = PARTICLE("y", "y", "length", "place along y"),
    [P_X0] = PARTICLE("x0", "x0", "length", "place along x at t = 0"),
    [P_Y0] = PARTICLE("y0", "y0", "length", "place along y at t = 0"),
    [P_VX] = PARTICLE("vx", "vx", "length/time", "velocity along x"),
    [P_VY] = PARTICLE("vy", "vy", "length/time", "velocity along y"),
    [P_SXX] = PARTICLE("sxx", "stress xx", "force/area", "stress along x, tension positive"),
    [P_SYY] = PARTICLE("syy", "stress yy", "force/area", "stress along y, tension positive"),
    [P_SXY] = PARTICLE("sxy", "stress xy", "force/area", "shear stress"),
    [P_DENSITY] = PARTICLE("density", "density", "mass/volume", "density"),
    [P_MASS] = PARTICLE("mass", "mass", "mass/length", "mass of the particle per unit thickness"),
    [P_BODY] = FIELD_ROW(MPM_PARTICLES, true, true, "body", "body", "1", "number of its body, from 0 on"),
    [P_UX] = SHOWN("ux", "ux", "length", "displacement along x"),
    [P_UY] = SHOWN("uy", "uy", "length", "displacement along y"),
    [P_SPEED] = SHOWN("speed", "speed", "length/time", "magnitude of the velocity"),
    [P_MISES] =
        SHOWN("mises", "von Mises", "force/area", "von Mises stress, with the stress across the plane"),
    [P_PRESSURE] = SHOWN("pressure", "pressure", "force/area", "minus the mean of the three normal stresses"),
    [P_JACOBIAN] = SHOWN("det_f", "det F", "1", "volume over that at t = 0"),
    [P_STRAIN_ENERGY] =
        SHOWN("strain_energy", "strain energy", "force*length", "strain energy of the particle"),
    [P_ENERGY_DENSITY] = SHOWN("energy_density", "energy density", "force/area", "strain energy over volume"),
    [P_KINETIC_ENERGY] =
        SHOWN("kinetic_energy", "kinetic energy", "force*length", "kinetic energy of the particle"),
    [P_EXX] = SHOWN("exx", "strain step xx", "1", "strain of this time step along x; 0 before its stage"),
    [P_EYY] = SHOWN("eyy", "strain step yy", "1", "strain of this time step along y; 0 before its stage"),
    [P_GXY] = SHOWN("gxy", "shear step", "1", "shear strain of this time step; 0 before its stage"),
    [N_X] = NODE("x", "x", "length", "place of the node along x"),
    [N_Y] = NODE("y", "y", "length", "place of the node along y"),
    [N_MASS] = NODE("mass", "mass", "mass/length", "mass mapped from the particles of its field"),
    [N_PX] = NODE("px", "momentum x", "mass*length/time", "momentum along x"),
    [N_PY] = NODE("py", "momentum y", "mass*length/time", "momentum along y"),
    [N_FX] = NODE("fx", "force x", "force", "force along x"),
    [N_FY] = NODE("fy", "force y", "force", "force along y"),
    [N_BODY] =
        FIELD_ROW(MPM_NODES, true, true, "body", "body", "1", "body of its field; 0 where all share one"),
    [N_VX] = NODE_SHOWN(false, "vx", "vx", "length/time", "momentum over mass; 0 where the node is light"),
    [N_VY] = NODE_SHOWN(false, "vy", "vy", "length/time", "momentum over mass; 0 where the node is light"),
    [N_AX] = NODE_SHOWN(false, "ax", "acceleration x", "length/time^2", "force over mass"),
    [N_AY] = NODE_SHOWN(false, "ay", "acceleration y", "length/time^2", "force over mass"),
    [N_NX] = NODE_SHOWN(false, "nx", "normal x", "mass/length", "sum m dN/dx, which points out of the body"),
    [N_NY] = NODE_SHOWN(false, "ny", "normal y", "mass/length", "sum m dN/dy"),
    [N_ACTIVE] = NODE_SHOWN(true, "active", "active", "1", "1: the node has mass"),
    [N_FIXED] = NODE_SHOWN(true, "fixed", "fixed", "1", "1: a wall of the box acts on it"),
};

void bodies_set_fields(Mpm *mpm)
{
    Simulation *sim = &mpm->sim;
    sim->fields = fields;
    sim->n_fields = FIELDS;
    sim->has = HAS_MESH | HAS_BODIES;
    simulation_lay(sim, sim->counts[0], 1, mpm->spacing, 2,
                   (MotionFields[]){{P_X0, P_UX, P_VX}, {P_Y0, P_UY, P_VY}});
}

/* Across the plane: nu (sxx + syy) in plane strain, lambda ln J/J of the neo-Hookean law, 0 in plane stress.
 */
static double stress_across(const Mpm *mpm, int p)
{
    const BodiesDef *def = &mpm->bodies->def;
    const double J = mpm->volume[p] / mpm->bodies->volume;
    return def->plane == PLANE_STRESS    ? 0.0
           : def->law == LAW_NEO_HOOKEAN ? mpm->bodies->lambda * math_log(J) / J
                                         : def->poisson * (mpm->stress[0][p] + mpm->stress[1][p]);
}

static double particle_field(const Mpm *mpm, int field, int p)
{
    const double xx = mpm->stress[0][p], yy = mpm->stress[1][p], xy = mpm->stress[2][p];
    const double vx = mpm->v[0][p], vy = mpm->v[1][p];
    double e[MPM_STRESSES] = {0.0};
    switch (field) {
    case P_X:
    case P_Y:
        return mpm->at[field == P_Y][p] + mpm->u[field == P_Y][p];
    case P_X0:
    case P_Y0:
        return mpm->at[field == P_Y0][p];
    case P_UX:
    case P_UY:
        return mpm->u[field == P_UY][p];
    case P_VX:
        return vx;
    case P_VY:
        return vy;
    case P_SXX:
        return xx;
    case P_SYY:
        return yy;
    case P_SXY:
        return xy;
    case P_DENSITY:
        return mpm->mass[0] / mpm->volume[p];
    case P_MASS:
        return mpm->mass[0];
    case P_BODY:
        return bodies_body_of(mpm, p);
    case P_SPEED:
        return sqrt(vx * vx + vy * vy);
    case P_MISES: {
        const double zz = stress_across(mpm, p), a = xx - yy, b = yy - zz, c = zz - xx;
        return sqrt(0.5 * (a * a + b * b + c * c) + 3.0 * (xy * xy));
    }
    case P_PRESSURE:
        return -(xx + yy + stress_across(mpm, p)) / 3.0;
    case P_JACOBIAN:
        return mpm->volume[p] / mpm->bodies->volume;
    case P_STRAIN_ENERGY:
        return bodies_strain_at(mpm, p);
    case P_ENERGY_DENSITY:
        return bodies_strain_at(mpm, p) / mpm->volume[p];
    case P_KINETIC_ENERGY:
        return 0.5 * mpm->mass[0] * (vx * vx + vy * vy);
    case P_EXX:
    case P_EYY:
    case P_GXY:
        if (mpm_has_done(mpm, OP_STRAIN))
            mpm_strain_step(mpm, p, e);
        return e[field - P_EXX];
    default:
        return 0.0;
    }
}

bool bodies_at_wall(const Mpm *mpm, int node)
{
    const Bodies *bodies = mpm->bodies;
    const int place = node % mpm->grid_nodes;
    const int i = place % mpm->gx - BODIES_PADDING, j = place / mpm->gx - BODIES_PADDING;
    const bool at[WALLS] = {i <= 0, i >= bodies->columns, j <= 0, j >= bodies->rows};
    for (int wall = 0; wall < WALLS; wall++)
        if (at[wall] && bodies->def.walls[wall] != WALL_OPEN)
            return true;
    return false;
}

static double node_field(const Mpm *mpm, int field, int node)
{
    const int at = node % mpm->grid_nodes, i = at % mpm->gx, j = at / mpm->gx;
    switch (field) {
    case N_X:
        return (i - BODIES_PADDING) * mpm->dx;
    case N_Y:
        return (j - BODIES_PADDING) * mpm->dx;
    case N_BODY:
        return node / mpm->grid_nodes;
    case N_FIXED:
        return bodies_at_wall(mpm, node);
    default:
        break;
    }
    if (mpm->sim.stage == 0) /* the grid is forgotten between steps */
        return 0.0;
    const double inverse = mpm_has_done(mpm, OP_FIX) ? mpm->inverse[node] : 0.0;
    switch (field) {
    case N_MASS:
        return mpm->node_mass[node];
    case N_PX:
    case N_PY:
        return mpm->momentum[field == N_PY][node];
    case N_FX:
    case N_FY:
        return mpm->force[field == N_FY][node];
    case N_VX:
    case N_VY:
        return mpm->momentum[field == N_VY][node] * inverse;
    case N_AX:
    case N_AY:
        return mpm_has_done(mpm, OP_FORCE) ? mpm->force[field == N_AY][node] * inverse : 0.0;
    case N_NX:
    case N_NY:
        return mpm->normal[field == N_NY][node];
    case N_ACTIVE:
        return mpm->node_mass[node] > mpm->floor;
    default:
        return 0.0;
    }
}

void bodies_field(const Simulation *sim, int field, size_t first, size_t count, double *out)
{
    const Mpm *mpm = mpm_of_const(sim);
    ASSERT_INDEX(field, FIELDS);
    ASSERT_INT(first + count, <=, sim->counts[fields[field].set]);
    for (size_t k = 0; k < count; k++)
        out[k] = fields[field].set == MPM_PARTICLES ? particle_field(mpm, field, (int)(first + k))
                                                    : node_field(mpm, field, (int)(first + k));
}
