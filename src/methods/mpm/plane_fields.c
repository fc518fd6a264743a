/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What front ends read of a beam: fields, links, shapes. Computed when read, from the state as it is in
 * mid-step too; a node's field is 0 before its stage. */
#include "methods/mpm/mistakes.h"
#include "methods/mpm/plane_inner.h"

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

#define PARTICLE(name, label, unit, meaning) FIELD_ROW(MPM_PARTICLES, true, false, name, label, unit, meaning)
#define SHOWN(name, label, unit, meaning)    FIELD_ROW(MPM_PARTICLES, false, false, name, label, unit, meaning)
#define NODE(name, label, unit, meaning)     FIELD_ROW(MPM_NODES, true, false, name, label, unit, meaning)
#define NODE_SHOWN(whole, name, label, unit, meaning)                                                        \
    FIELD_ROW(MPM_NODES, false, whole, name, label, unit, meaning)

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
    [P_PROBE] = FIELD_ROW(MPM_PARTICLES, false, true, "probe", "probe", "1", "1: the probe is beside it"),
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

void plane_set_fields(Mpm *mpm)
{
    Simulation *sim = &mpm->sim;
    sim->fields = fields;
    sim->n_fields = FIELDS;
    sim->has = HAS_PLANE | HAS_MESH | (mpm->speed > 0 ? HAS_RELATIVE_ENERGY : 0);
    sim->common_speed = mpm->speed;
    simulation_lay(sim, (size_t)mpm->nxp, (size_t)mpm->nyp, mpm->spacing, 2,
                   (MotionFields[]){{P_X0, P_UX, P_VX}, {P_Y0, P_UY, P_VY}});
}

/* The value of one particle's field; m, m/s, Pa, J. */
static double particle_field(const Mpm *mpm, int field, int p)
{
    const double xx = mpm->stress[0][p], yy = mpm->stress[1][p], xy = mpm->stress[2][p];
    const double vx = mpm->v[0][p] - mpm->speed, vy = mpm->v[1][p];
    double e[MPM_STRESSES] = {0.0};
    switch (field) {
    case P_X0:
        return mpm_rest(mpm, 0, p);
    case P_Y0:
        return mpm_rest(mpm, 1, p);
    case P_X:
        return mpm_rest(mpm, 0, p) + mpm->u[0][p];
    case P_Y:
        return mpm_rest(mpm, 1, p) + mpm->u[1][p];
    case P_UX:
        return mpm->u[0][p];
    case P_UY:
        return mpm->u[1][p];
    case P_VX:
        return mpm->v[0][p];
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
    case P_MISES:
        return sqrt(fmax(xx * xx + yy * yy - xx * yy + 3 * (xy * xy), 0));
    case P_SPEED:
        return sqrt(vx * vx + vy * vy);
    case P_STRAIN_ENERGY:
        return plane_strain_at(mpm, p);
    case P_KINETIC_ENERGY:
        return mpm->mass[0] / 2 * (vx * vx + vy * vy) * mpm->plane.thickness;
    case P_EXX:
    case P_EYY:
    case P_GXY:
        if (mpm_has_done(mpm, OP_STRAIN))
            mpm_strain_step(mpm, p, e);
        return e[field - P_EXX];
    case P_PROBE:
        return p == mpm->probe[0] || p == mpm->probe[1] || p == mpm->probe[2] || p == mpm->probe[3];
    default:
        return 0;
    }
}

/* The value of one node's field: 0 between steps, and before the stage that makes it. */
static double node_field(const Mpm *mpm, int field, int node)
{
    const int i = node % mpm->gx, j = node / mpm->gx;
    const bool mapped = mpm->sim.stage > 0, moves = mpm_has_done(mpm, OP_FIX);
    switch (field) {
    case N_X:
        return mpm->xmin + (mpm_shift(mpm, mpm->sim.step) + i) * mpm->dx;
    case N_Y:
        return mpm->ymin + j * mpm->dx;
    case N_FIXED:
        return mpm_held(mpm, mpm->sim.step, node) != 0;
    case N_HELD_X:
        return (mpm_held(mpm, mpm->sim.step, node) & HELD_X) != 0;
    case N_HELD_Y:
        return (mpm_held(mpm, mpm->sim.step, node) & HELD_Y) != 0;
    default:
        break;
    }
    if (!mapped) /* the grid is forgotten between steps */
        return 0;
    const double *const arrays[] = {
        [N_MASS] = mpm->node_mass, [N_PX] = mpm->momentum[0], [N_PY] = mpm->momentum[1],
        [N_FX] = mpm->force[0],    [N_FY] = mpm->force[1],
    };
    if (field == N_AX || field == N_AY)
        return mpm_has_done(mpm, OP_FIX_FORCE) ? mpm_node_acceleration(mpm, field == N_AY, node) : 0;
    if (field == N_ACTIVE)
        return mpm->node_mass[node] > mpm->floor;
    if (field == N_VX || field == N_VY)
        return moves ? mpm_node_velocity(mpm, field == N_VY, node) : 0;
    return arrays[field][node];
}

void plane_field(const Simulation *sim, int field, size_t first, size_t count, double *out)
{
    const Mpm *mpm = mpm_of_const(sim);
    ASSERT_INT(field, <, FIELDS);
    ASSERT_INT(first + count, <=, sim->counts[fields[field].set]);
    for (size_t k = 0; k < count; k++)
        out[k] = fields[field].set == MPM_PARTICLES ? particle_field(mpm, field, (int)(first + k))
                                                    : node_field(mpm, field, (int)(first + k));
}
