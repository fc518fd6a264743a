/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What front ends read of a bar: fields, series, links. Computed when read, from the state as it stands in
 * mid-step too: which stages are done decides whether a place is the old or the new one, and a node's field
 * is 0 before its stage. */
#include "base/assertion.h"
#include "methods/axial.h"
#include "methods/mpm/line/bar_mistakes.h"
#include "methods/mpm/line/bar_state.h"
#include "methods/mpm/line/kernels/shape.h"

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
    FIELDS
};
_Static_assert((int)FIELDS == (int)BAR_FIELDS, "a bar has room for its fields");

#define SHOWN(name, label, unit, meaning) FIELD_ROW(BAR_PARTICLES, false, false, name, label, unit, meaning)
#define NODE(name, label, unit, meaning)  FIELD_ROW(BAR_NODES, true, false, name, label, unit, meaning)
#define ROW_OF_MASSES(name, label, which) NODE(name, label, "mass/length^2", "mass matrix: " which)

static const Field fields[FIELDS] = {
    AXIAL_FIELD_ROWS("axial stress, tension positive", "sum of the strain increments"),
    [P_CELL] = FIELD_ROW(BAR_PARTICLES, false, true, "cell", "cell", "1",
                         "cell of the mesh that the particle is in"),
    [P_NATURAL] = SHOWN("natural", "place in cell", "1", "0 at the left edge of its cell, 1 at the right"),
    [P_STRAIN_INCREMENT] =
        SHOWN("strain_increment", "strain increment", "1", "strain of this time step; 0 before its stage"),
    [P_MOMENTUM] = SHOWN("momentum", "momentum", "mass/(length*time)", "mass times velocity"),
    [P_AFFINE] = SHOWN("affine", "slope C", "1/time", "slope of the velocity that APIC carries"),
    [P_STRETCH] = FIELD_ROW(BAR_PARTICLES, true, false, "stretch", "stretch", "1",
                            "length of the particle's domain over that at rest"),
    [N_X] = NODE("x", "x", "length", "position of the node (Greville abscissa of a B-spline)"),
    [N_MASS] = NODE("mass", "mass", "mass/length^2", "mass mapped from the particles"),
    [N_MOMENTUM] = NODE("momentum", "momentum", "mass/(length*time)", "momentum"),
    [N_VELOCITY] =
        NODE("velocity", "velocity", "length/time", "momentum over mass; 0 where the node is inactive"),
    [N_F_INT] = NODE("f_int", "internal force", "force/length^2", "force of the particles' stress"),
    [N_F_EXT] = NODE("f_ext", "external force", "force/length^2", "force of the loads that act"),
    [N_F] = NODE("f", "force", "force/length^2", "whole force; 0 at fixed nodes"),
    [N_ACCELERATION] = FIELD_ROW(BAR_NODES, false, false, "acceleration", "acceleration", "length/time^2",
                                 "force over mass"),
    [N_MASS_0] = ROW_OF_MASSES("mass_0", "M(i,i)", "the node's own"),
    [N_MASS_1] = ROW_OF_MASSES("mass_1", "M(i,i+1)", "shared with the next node"),
    [N_MASS_2] = ROW_OF_MASSES("mass_2", "M(i,i+2)", "shared with the next node but one"),
    [N_MASS_3] = ROW_OF_MASSES("mass_3", "M(i,i+3)", "shared with the next node but two"),
    [N_ACTIVE] = FIELD_ROW(BAR_NODES, false, true, "active", "active", "1", "1: the node has mass"),
    [N_FIXED] = FIELD_ROW(BAR_NODES, false, true, "fixed", "fixed", "1", "1: a support holds the node"),
};

/* The slope C is a column of the table with APIC, the acceleration where masses are not lumped; their matrix
 * is there only then, as far as it reaches. */
void bar_list_fields(Bar *bar)
{
    const bool lumped = bar_is_lumped(bar);
    int count = 0;
    for (int kind = 0; kind < FIELDS; kind++) {
        if (kind >= N_MASS_0 && kind <= N_MASS_3 && (lumped || kind - N_MASS_0 > bar->reach))
            continue;
        if (kind == P_STRETCH && bar->def.shape != MPM_CPDI)
            continue;
        Field *field = &bar->fields[count];
        *field = fields[kind];
        if (kind == N_F_EXT)
            field->quantity.meaning = bar->force_words.meaning;
        if ((kind == P_AFFINE && bar->head->transfer == MPM_APIC) || (kind == N_ACCELERATION && !lumped))
            field->in_table = true;
        bar->field_kinds[count++] = kind;
    }
    bar->sim.fields = bar->fields;
    bar->sim.n_fields = count;
}

const Quantity bar_series[BAR_SERIES] = {
    AXIAL_SERIES_BEGIN,
    {"kinetic_grid", "seen by grid", "force/length",
     "the part of it that the grid sees: sum p^2/(2m) of the nodes, boundary applied"},
    {"kinetic_null", "null space", "force/length",
     "the part of it that no velocities of the grid can give: the rest is seen, or lost to lumped masses"},
    {"strain", "strain", "force/length", "strain energy of the particles"},
    AXIAL_SERIES_END,
};

/* Eq. 5: de = dt sum N'_i v_i / dx, N' by s. */
static double strain_increment(const Bar *bar, int particle, int cell, double s)
{
    double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX], v[BAR_SUPPORT_MAX], gradient = 0.0;
    shape_at(bar->def.shape, bar_half(bar, particle), bar->n_cells, cell, s, n, dn);
    bar_strain_velocities(bar, cell, v);
    for (int a = 0; a < bar->support; a++)
        gradient += dn[a] * v[a];
    return (bar_mistake(bar) ? bar_strain_span(bar) * bar_slope_scale(bar) : bar->dt / bar->dx) * gradient;
}

/* The value of one particle's field. x of a moved particle counts from its old cell until the last stage; u
 * as a difference of cells and of places within them keeps all digits of a small motion. */
static double particle_field(const Bar *bar, int field, int p, int cell)
{
    const int j = p % bar->slots, k = p / bar->slots;
    const double s = bar->s[j][k], place = bar_has_done(bar, OP_UPDATE) ? bar->moved[j][k] : s,
                 start = bar_place_at_start(bar, j);
    switch (field) {
    case AXIAL_X0:
        return (k + start) * bar->dx;
    case AXIAL_X:
        return ((cell - bar->origin) + place) * bar->dx;
    case AXIAL_U:
        return ((cell - bar->origin - k) + (place - start)) * bar->dx;
    case AXIAL_V:
        return bar->v[j][k];
    case AXIAL_STRESS:
        return bar->stress[j][k];
    case AXIAL_STRAIN:
        return bar->stress[j][k] / bar_modulus(bar, p);
    case AXIAL_DENSITY:
        return bar_particle_mass(bar, p) / bar->volume[j][k];
    case AXIAL_MASS:
        return bar_particle_mass(bar, p);
    case P_CELL:
        return cell;
    case P_NATURAL:
        return place;
    case P_STRAIN_INCREMENT:
        return bar_has_done(bar, OP_STRAIN) ? strain_increment(bar, p, cell, s) : 0.0;
    case P_MOMENTUM:
        return bar_particle_mass(bar, p) * bar->v[j][k];
    case P_AFFINE:
        return bar->affine[j][k];
    case P_STRETCH:
        return bar->volume[j][k] * bar->slots / bar->dx;
    default:
        return 0.0;
    }
}

/* The value of one node's field: the grid is forgotten between steps, and each is 0 before its stage. */
static double node_field(const Bar *bar, int field, int i)
{
    const bool mapped = bar->sim.stage > 0 && bar_has_done(bar, OP_MAP);
    const bool forced = bar_has_done(bar, OP_FORCE);
    switch (field) {
    case N_X:
        return bar_node_position(bar, i);
    case N_MASS:
        return mapped ? bar->node_mass[i] : 0.0;
    case N_MOMENTUM:
        return mapped ? bar->node_momentum[i] : 0.0;
    case N_VELOCITY:
        return mapped ? bar_node_velocity(bar, i) : 0.0;
    case N_F_INT:
        return forced ? bar->node_f_int[i] : 0.0;
    case N_F_EXT:
        return forced && bar_is_loaded(bar) ? bar->node_f_ext[i] : 0.0;
    case N_F:
        return forced ? bar_node_force(bar, i) : 0.0;
    case N_ACCELERATION:
        return mapped ? bar_node_acceleration(bar, i) : 0.0;
    case N_MASS_0:
    case N_MASS_1:
    case N_MASS_2:
    case N_MASS_3:
        return mapped ? bar_mass_between(bar, i, i + field - N_MASS_0) : 0.0;
    case N_ACTIVE:
        return mapped && bar->node_inverse[i] > 0.0;
    case N_FIXED:
        return bar_node_is_fixed(bar, i);
    default:
        return 0.0;
    }
}

void bar_field(const Simulation *sim, int field, size_t first, size_t count, double *out)
{
    const Bar *bar = bar_of_const(sim);
    ASSERT_INT(field, <, sim->n_fields);
    ASSERT_INT(first + count, <=, sim->counts[sim->fields[field].set]);
    const int kind = bar->field_kinds[field], end = (int)(first + count);
    const bool of_particles = sim->fields[field].set == BAR_PARTICLES;
    int cell = of_particles && count > 0 ? bar_cell_of(bar, (int)first) : 0;
    for (int i = (int)first; i < end; i++) {
        while (of_particles && bar->first[cell + 1] <= i)
            cell++;
        *out++ = of_particles ? particle_field(bar, kind, i, cell) : node_field(bar, kind, i);
    }
}

/* N and dN/dx of a particle and a node of its cell. */
static Link link_of(const Bar *bar, int set, int index, int particle, int cell, int node)
{
    double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
    double s = bar->s[particle % bar->slots][particle / bar->slots];
    shape_at(bar->def.shape, bar_half(bar, particle), bar->n_cells, cell, s, n, dn);
    return (Link){.set = set,
                  .index = (size_t)index,
                  .weight = n[node - cell],
                  .gradient = {dn[node - cell] / bar->dx}};
}

/* During a step shape functions are those of its beginning. A uGIMP particle far from a ghost node has no
 * part in it: such pairs are left out. */
size_t bar_links(const Simulation *sim, int set, size_t index, Link *out, size_t max)
{
    const Bar *bar = bar_of_const(sim);
    ASSERT_INT(index, <, sim->counts[set]);
    size_t count = 0;
    if (set == BAR_PARTICLES) {
        int cell = bar_cell_of(bar, (int)index);
        for (int node = cell; node < cell + bar->support && count < max; node++) {
            Link link = link_of(bar, BAR_NODES, node, (int)index, cell, node);
            if (link.weight != 0.0 || link.gradient[0] != 0.0)
                out[count++] = link;
        }
        return count;
    }
    int node = (int)index, low = node - bar->support + 1, high = node;
    low = low < 0 ? 0 : low;
    high = high < bar->n_cells ? high : bar->n_cells - 1;
    for (int cell = low; cell <= high; cell++)
        for (int p = bar->first[cell]; p < bar->first[cell + 1] && count < max; p++) {
            Link link = link_of(bar, BAR_PARTICLES, p, p, cell, node);
            if (link.weight != 0.0 || link.gradient[0] != 0.0)
                out[count++] = link;
        }
    return count;
}

/* CPDI's functions differ from particle to particle: those of the one that is nearest in the cell. */
static double half_near(const Bar *bar, int cell, double s)
{
    double half = bar->gimp_half, nearest = INFINITY;
    for (int p = bar->first[cell]; p < bar->first[cell + 1]; p++) {
        const double distance = fabs(bar->s[p % bar->slots][p / bar->slots] - s);
        if (distance < nearest) {
            nearest = distance;
            half = bar_half(bar, p);
        }
    }
    return half;
}

/* N and dN/dx of all functions that are not 0 at a place; a place on the right end of the mesh belongs to the
 * last cell. */
size_t bar_shapes(const Simulation *sim, const double *at, Link *out, size_t max)
{
    const Bar *bar = bar_of_const(sim);
    double place = at[0] / bar->dx + bar->origin;
    if (!(place >= 0.0 && place <= bar->n_cells))
        return 0;
    int cell = (int)place < bar->n_cells ? (int)place : bar->n_cells - 1;
    double n[BAR_SUPPORT_MAX], dn[BAR_SUPPORT_MAX];
    shape_at(bar->def.shape, half_near(bar, cell, place - cell), bar->n_cells, cell, place - cell, n, dn);
    size_t count = 0;
    for (int a = 0; a < bar->support && count < max; a++)
        if (n[a] != 0.0 || dn[a] != 0.0)
            out[count++] = (Link){
                .set = BAR_NODES, .index = (size_t)(cell + a), .weight = n[a], .gradient = {dn[a] / bar->dx}};
    return count;
}
