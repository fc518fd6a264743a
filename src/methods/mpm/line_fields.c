/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What front ends read of a bar: fields, series, links. Computed when read, from the state as it is in
 * mid-step too: which stages are done decides whether a place is the old or the new one, and a node's field
 * is 0 before its stage. */
#include "base/assertion.h"
#include "methods/axial.h"
#include "methods/mpm/mistakes.h"

/* One list for the rows below and for the functions that fill them; it begins with those of axial.h. */
enum FieldIndex {
    P_CELL = AXIAL_FIELDS,
    P_NATURAL,
    P_STRAIN_INCREMENT,
    P_MOMENTUM,
    P_AFFINE,
    P_STRETCH,
    N_X,
    N_MASS,
    N_MOMENTUM,
    N_VELOCITY,
    N_F_INT,
    N_F_EXT,
    N_F,
    N_ACCELERATION,
    N_MASS_0,
    N_MASS_1,
    N_MASS_2,
    N_MASS_3,
    N_ACTIVE,
    N_FIXED,
    N_VELOCITY_NEW,
    FIELDS
};
_Static_assert((int)FIELDS <= (int)MPM_FIELDS, "there is room for the fields");

#define SHOWN(name, label, unit, meaning) FIELD_ROW(MPM_PARTICLES, false, false, name, label, unit, meaning)
#define NODE(name, label, unit, meaning)  FIELD_ROW(MPM_NODES, true, false, name, label, unit, meaning)
#define ROW_OF_MASSES(name, label, which) NODE(name, label, "mass/length^2", "mass matrix: " which)

static const Field fields[FIELDS] = {
    AXIAL_FIELD_ROWS("axial stress, tension positive", "sum of the strain increments"),
    [P_CELL] = FIELD_ROW(MPM_PARTICLES, false, true, "cell", "cell", "1",
                         "cell of the mesh that the particle is in"),
    [P_NATURAL] = SHOWN("natural", "place in cell", "1", "0 at the left edge of its cell, 1 at the right"),
    [P_STRAIN_INCREMENT] =
        SHOWN("strain_increment", "strain increment", "1", "strain of this time step; 0 before its stage"),
    [P_MOMENTUM] = SHOWN("momentum", "momentum", "mass/(length*time)", "mass times velocity"),
    [P_AFFINE] = SHOWN("affine", "slope C", "1/time", "slope of the velocity that APIC carries"),
    [P_STRETCH] = FIELD_ROW(MPM_PARTICLES, true, false, "stretch", "stretch", "1",
                            "length of the particle's domain over that at rest"),
    [N_X] = NODE("x", "x", "length", "position of the node (Greville abscissa of a B-spline)"),
    [N_MASS] = NODE("mass", "mass", "mass/length^2", "mass mapped from the particles"),
    [N_MOMENTUM] = NODE("momentum", "momentum", "mass/(length*time)", "momentum"),
    [N_VELOCITY] =
        NODE("velocity", "velocity", "length/time", "momentum over mass; 0 where the node is inactive"),
    [N_F_INT] = NODE("f_int", "internal force", "force/length^2", "force of the particles' stress"),
    [N_F_EXT] = NODE("f_ext", "external force", "force/length^2", "force of the loads that act"),
    [N_F] = NODE("f", "force", "force/length^2", "whole force; 0 at fixed nodes"),
    [N_ACCELERATION] = FIELD_ROW(MPM_NODES, false, false, "acceleration", "acceleration", "length/time^2",
                                 "force over mass"),
    [N_MASS_0] = ROW_OF_MASSES("mass_0", "M(i,i)", "the node's own"),
    [N_MASS_1] = ROW_OF_MASSES("mass_1", "M(i,i+1)", "shared with the next node"),
    [N_MASS_2] = ROW_OF_MASSES("mass_2", "M(i,i+2)", "shared with the next node but one"),
    [N_MASS_3] = ROW_OF_MASSES("mass_3", "M(i,i+3)", "shared with the next node but two"),
    [N_ACTIVE] = FIELD_ROW(MPM_NODES, false, true, "active", "active", "1", "1: the node has mass"),
    [N_FIXED] = FIELD_ROW(MPM_NODES, false, true, "fixed", "fixed", "1", "1: a support holds the node"),
    [N_VELOCITY_NEW] = FIELD_ROW(MPM_NODES, false, false, "velocity_new", "new velocity", "length/time",
                                 "velocity after the force has acted: it moves the particles"),
};

/* The slope C is a column of the table with APIC, the acceleration where masses are not lumped; their matrix
 * is there only then, as far as it reaches. */
void mpm_list_fields(Mpm *mpm)
{
    const bool lumped = mpm_is_lumped(mpm);
    int count = 0;
    for (int kind = 0; kind < FIELDS; kind++) {
        if (kind >= N_MASS_0 && kind <= N_MASS_3 && (lumped || kind - N_MASS_0 > (mpm->support - 1)))
            continue;
        if (kind == P_STRETCH && mpm->shape != MPM_CPDI)
            continue;
        Field *field = &mpm->fields[count];
        *field = fields[kind];
        if (kind == N_F_EXT)
            field->quantity.meaning = mpm->force_words.meaning;
        if ((kind == P_AFFINE && mpm->head->transfer == MPM_APIC) || (kind == N_ACCELERATION && !lumped))
            field->in_table = true;
        mpm->field_kinds[count++] = kind;
    }
    mpm->sim.fields = mpm->fields;
    mpm->sim.n_fields = count;
}

const Quantity mpm_line_series[] = {
    AXIAL_SERIES_BEGIN,
    {"x_cm_rate", "d(x_cm)/dt", "length/time",
     "rate of x_cm in the last step: particles move with the nodes, and not with their own velocities"},
    AXIAL_SERIES_KINETIC,
    {"kinetic_grid", "seen by grid", "force/length",
     "the part of it that the grid sees: sum p^2/(2m) of the nodes, boundary applied"},
    {"kinetic_null", "null space", "force/length",
     "the part of it that no velocities of the grid can give: the rest is seen, or lost to lumped masses"},
    {"strain", "strain", "force/length", "strain energy of the particles"},
    AXIAL_SERIES_END,
    AXIAL_SERIES_MOMENTUM(" in the last step"),
};

/* The value of one particle's field. The place in the cell of a moved particle counts from its old cell until
 * the last stage. */
static double particle_field(const Mpm *mpm, int field, int p)
{
    const int base = mpm->base[p];
    const double s = mpm->s[0][p];
    const int cell = mpm_cell(base, s, mpm->edge);
    double e[MPM_STRESSES] = {0.0};
    switch (field) {
    case AXIAL_X0:
        return mpm_rest(mpm, 0, p);
    case AXIAL_X:
        return mpm_rest(mpm, 0, p) + mpm->u[0][p];
    case AXIAL_U:
        return mpm->u[0][p];
    case AXIAL_V:
        return mpm->v[0][p];
    case AXIAL_STRESS:
        return mpm->stress[0][p];
    case AXIAL_STRAIN:
        return mpm->stress[0][p] / mpm_modulus(mpm, p);
    case AXIAL_DENSITY:
        return mpm_mass(mpm, p) / mpm->volume[p];
    case AXIAL_MASS:
        return mpm_mass(mpm, p);
    case P_CELL:
        return cell;
    case P_NATURAL:
        return mpm->rest[0][p] - mpm->edge - cell + mpm->u[0][p] / mpm->dx;
    case P_STRAIN_INCREMENT:
        if (mpm_has_done(mpm, OP_STRAIN))
            mpm_strain_step(mpm, p, e);
        return e[0];
    case P_MOMENTUM:
        return mpm_mass(mpm, p) * mpm->v[0][p];
    case P_AFFINE:
        return mpm->affine[p];
    case P_STRETCH:
        return mpm->volume[p] * mpm->bar.particles_per_cell / mpm->dx;
    default:
        return 0.0;
    }
}

/* The value of one node's field: the grid is forgotten between steps, and each is 0 before its stage. */
static double node_field(const Mpm *mpm, int field, int i)
{
    const bool mapped = mpm->sim.stage > 0 && mpm_has_done(mpm, OP_MAP);
    const bool forced = mpm_has_done(mpm, OP_FORCE);
    switch (field) {
    case N_X:
        return mpm_node_position(mpm, i);
    case N_MASS:
        return mapped ? mpm->node_mass[i] : 0.0;
    case N_MOMENTUM:
        return mapped ? mpm->momentum[0][i] : 0.0;
    case N_VELOCITY:
        return mapped ? mpm_node_velocity(mpm, 0, i) : 0.0;
    case N_VELOCITY_NEW: /* (p_i + dt f_i)/m_i */
        if (!mapped || !forced || mpm_has_done(mpm, OP_INTEGRATE))
            return mapped ? mpm_node_velocity(mpm, 0, i) : 0.0;
        return mpm_node_velocity(mpm, 0, i) + mpm->dt * mpm_node_acceleration(mpm, 0, i);
    case N_F_INT:
        return forced ? mpm->force[0][i] : 0.0;
    case N_F_EXT:
        return forced && mpm_is_loaded(mpm) ? mpm->load[i] : 0.0;
    case N_F:
        return forced ? mpm_node_force(mpm, 0, i) : 0.0;
    case N_ACCELERATION:
        return mapped ? mpm_node_acceleration(mpm, 0, i) : 0.0;
    case N_MASS_0:
    case N_MASS_1:
    case N_MASS_2:
    case N_MASS_3:
        return mapped ? mpm_mass_between(mpm, i, i + field - N_MASS_0) : 0.0;
    case N_ACTIVE:
        return mapped && mpm->inverse[i] > 0.0;
    case N_FIXED:
        return mpm_held(mpm, mpm->sim.step, i);
    default:
        return 0.0;
    }
}

void mpm_field(const Simulation *sim, int field, size_t first, size_t count, double *out)
{
    const Mpm *mpm = mpm_of_const(sim);
    ASSERT_INT(field, <, sim->n_fields);
    ASSERT_INT(first + count, <=, sim->counts[sim->fields[field].set]);
    const int kind = mpm->field_kinds[field], end = (int)(first + count);
    const bool of_particles = sim->fields[field].set == MPM_PARTICLES;
    for (int i = (int)first; i < end; i++)
        *out++ = of_particles ? particle_field(mpm, kind, i) : node_field(mpm, kind, i);
}
