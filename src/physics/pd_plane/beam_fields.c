/* The fields of a beam that front ends read (Simulation.fields): a function for the value of one node or one
 * bond, and a row for each with name, unit and meaning. Everything is computed when it is read, from the
 * state as it stands, in mid-step too; nothing here is part of a step. Strain energy and largest stretch of
 * nodes, which need all bonds, go through the vector loops of beam_shares.c. SI units. */
#include "base/assertion.h"
#include "physics/pd_plane/beam_internal.h"

#include <math.h>
#include <string.h>

static const Set sets[N_SETS] = {
    [SET_PARTICLE] = {"particle", "particles", 0},
    [SET_BOND] = {"bond", "bonds", 0},
};

/* --- fields: one row each; the value of one thing --- */

typedef double FieldValue(const Beam *beam, size_t index);

static int column(const Beam *beam, size_t node)
{
    return (int)(node % (size_t)beam->lattice.nx);
}

static int row(const Beam *beam, size_t node)
{
    return (int)(node / (size_t)beam->lattice.nx);
}

static size_t at(const Beam *beam, size_t node)
{
    return lattice_at(&beam->lattice, column(beam, node), row(beam, node));
}

static double rest_x(const Beam *beam, size_t node)
{
    return lattice_x(&beam->lattice, column(beam, node));
}

static double rest_y(const Beam *beam, size_t node)
{
    return lattice_y(&beam->lattice, row(beam, node));
}

static double ux(const Beam *beam, size_t node)
{
    return beam->nodes.ux[at(beam, node)];
}

static double uy(const Beam *beam, size_t node)
{
    return beam->nodes.uy[at(beam, node)];
}

static double vx(const Beam *beam, size_t node)
{
    return beam->nodes.vx[at(beam, node)];
}

static double vy(const Beam *beam, size_t node)
{
    return beam->nodes.vy[at(beam, node)];
}

static double fx(const Beam *beam, size_t node)
{
    return beam->nodes.fx[at(beam, node)];
}

static double fy(const Beam *beam, size_t node)
{
    return beam->nodes.fy[at(beam, node)];
}

static double damage(const Beam *beam, size_t node)
{
    return beam->damage[node];
}

static double surface_x(const Beam *beam, size_t node)
{
    return beam->lattice.factor_x[node];
}

static double surface_y(const Beam *beam, size_t node)
{
    return beam->lattice.factor_y[node];
}

static double surface_factor(const Beam *beam, size_t node)
{
    return (surface_x(beam, node) + surface_y(beam, node)) / 2;
}

static double family_size(const Beam *beam, size_t node)
{
    const Lattice *lattice = &beam->lattice;
    const int i = column(beam, node), j = row(beam, node), reach = lattice->reach;
    /* far from the surface every family is whole: no need to count, as views read this in every frame */
    if (i >= reach && j >= reach && i < lattice->nx - reach && j < lattice->ny - reach)
        return 2 * lattice->n_offsets;
    BondPlace family[FAMILY_MAX];
    return (double)beam_family(beam, i, j, family);
}

static double speed(const Beam *beam, size_t node)
{
    return hypot(vx(beam, node), vy(beam, node));
}

static double held(const Beam *beam, size_t node)
{
    int i = column(beam, node), j = row(beam, node);
    double flags = i < beam_held_columns(beam, simulation_time(&beam->sim)) ? 1 : 0;
    for (const Support *s = beam->supports; s < beam->supports + beam->n_supports; s++)
        if (s->i == i && s->j == j)
            flags = 1;
    return flags;
}

static double loaded(const Beam *beam, size_t node)
{
    int i = column(beam, node);
    return row(beam, node) == beam->lattice.ny - 1 && i >= beam->load_first && i < beam->load_end;
}

static double probe(const Beam *beam, size_t node)
{
    int i = column(beam, node), j = row(beam, node);
    return (i == beam->probe_i[0] || i == beam->probe_i[1]) &&
           (j == beam->probe_j[0] || j == beam->probe_j[1]);
}

static double protected_node(const Beam *beam, size_t node)
{
    return beam->unbreakable[node];
}

typedef double BondValue(const Beam *beam, BondPlace place, const BondNow *bond);

static double end_i(const Beam *beam, BondPlace place, const BondNow *bond)
{
    (void)beam, (void)place;
    return (double)bond->a;
}

static double end_j(const Beam *beam, BondPlace place, const BondNow *bond)
{
    (void)beam, (void)place;
    return (double)bond->b;
}

static double x_i(const Beam *beam, BondPlace place, const BondNow *bond)
{
    (void)place;
    return rest_x(beam, bond->a);
}

static double y_i(const Beam *beam, BondPlace place, const BondNow *bond)
{
    (void)place;
    return rest_y(beam, bond->a);
}

static double x_j(const Beam *beam, BondPlace place, const BondNow *bond)
{
    (void)place;
    return rest_x(beam, bond->b);
}

static double y_j(const Beam *beam, BondPlace place, const BondNow *bond)
{
    (void)place;
    return rest_y(beam, bond->b);
}

static double stretch(const Beam *beam, BondPlace place, const BondNow *bond)
{
    (void)beam, (void)place;
    return bond->stretch;
}

static double broken(const Beam *beam, BondPlace place, const BondNow *bond)
{
    (void)beam, (void)place;
    return bond->broken;
}

static double broken_at(const Beam *beam, BondPlace place, const BondNow *bond)
{
    return bond->broken ? (double)beam->broken_at[lattice_slot(&beam->lattice, place)] : -1;
}

static double is_notch(const Beam *beam, BondPlace place, const BondNow *bond)
{
    (void)beam, (void)place;
    return bond->notch;
}

static double pull(const Beam *beam, BondPlace place, const BondNow *bond)
{
    (void)beam, (void)place;
    return bond->pull;
}

static double energy(const Beam *beam, BondPlace place, const BondNow *bond)
{
    (void)beam, (void)place;
    return bond->energy;
}

typedef enum FieldIndex {
    F_X0,
    F_Y0,
    F_UX,
    F_UY,
    F_VX,
    F_VY,
    F_DAMAGE,
    F_SURFACE,
    F_STRAIN_ENERGY,
    F_FX,
    F_FY,
    F_SPEED,
    F_STRETCH,
    F_FAMILY,
    F_SURFACE_X,
    F_SURFACE_Y,
    F_HELD,
    F_LOADED,
    F_PROBE,
    F_PROTECTED,
    F_I,
    F_J,
    F_XI,
    F_YI,
    F_XJ,
    F_YJ,
    F_BOND_STRETCH,
    F_BROKEN,
    F_BROKEN_AT,
    F_NOTCH,
    F_PULL,
    F_BOND_ENERGY,
    N_FIELDS
} FieldIndex;

#define PARTICLE(name, label, unit, meaning, table, whole)                                                   \
    FIELD_ROW(SET_PARTICLE, table, whole, name, label, unit, meaning)
#define BOND(name, label, unit, meaning, table, whole)                                                       \
    FIELD_ROW(SET_BOND, table, whole, name, label, unit, meaning)

static const Field fields[N_FIELDS] = {
    [F_X0] = PARTICLE("x0", "x0", "m", "reference position along the beam", true, false),
    [F_Y0] = PARTICLE("y0", "y0", "m", "reference position across the beam", true, false),
    [F_UX] = PARTICLE("ux", "ux", "m", "displacement along the beam", true, false),
    [F_UY] = PARTICLE("uy", "uy", "m", "displacement across the beam", true, false),
    [F_VX] = PARTICLE("vx", "vx", "m/s", "velocity along the beam", true, false),
    [F_VY] = PARTICLE("vy", "vy", "m/s", "velocity across the beam", true, false),
    [F_DAMAGE] = PARTICLE("damage", "damage", "1",
                          "broken share of the family, the notch's bonds included (eq. 5)", true, false),
    [F_SURFACE] = PARTICLE("surface_factor", "surface factor", "1",
                           "surface correction of the node: the mean of its two directions", true, false),
    [F_STRAIN_ENERGY] = PARTICLE("strain_energy", "strain energy", "J",
                                 "half of the energy of the node's bonds", true, false),
    [F_FX] = PARTICLE("fx", "force x", "N/m^3", "force density along the beam", false, false),
    [F_FY] = PARTICLE("fy", "force y", "N/m^3", "force density across the beam", false, false),
    [F_SPEED] = PARTICLE("speed", "speed", "m/s", "magnitude of the velocity", false, false),
    [F_STRETCH] =
        PARTICLE("stretch", "stretch", "1", "largest stretch of the node's whole bonds", false, false),
    [F_FAMILY] = PARTICLE("family", "family", "1", "number of bonds, broken ones included", false, true),
    [F_SURFACE_X] = PARTICLE("surface_x", "g_x", "1", "surface factor along the beam", false, false),
    [F_SURFACE_Y] = PARTICLE("surface_y", "g_y", "1", "surface factor across the beam", false, false),
    [F_HELD] = PARTICLE("held", "held", "1", "1: a support or the channel holds the node", false, true),
    [F_LOADED] = PARTICLE("loaded", "loaded", "1", "1: the load acts on the node", false, true),
    [F_PROBE] = PARTICLE("probe", "probe", "1", "1: the probe is the mean of such nodes", false, true),
    [F_PROTECTED] = PARTICLE("protected", "protected", "1", "1: bonds of the node never break", false, true),
    [F_I] = BOND("i", "i", "1", "particle at one end", true, true),
    [F_J] = BOND("j", "j", "1", "particle at the other end", true, true),
    [F_XI] = BOND("x_i", "x_i", "m", "reference position of particle i along the beam", true, false),
    [F_YI] = BOND("y_i", "y_i", "m", "reference position of particle i across the beam", true, false),
    [F_XJ] = BOND("x_j", "x_j", "m", "reference position of particle j along the beam", true, false),
    [F_YJ] = BOND("y_j", "y_j", "m", "reference position of particle j across the beam", true, false),
    [F_BOND_STRETCH] =
        BOND("stretch", "stretch", "1", "stretch s between the two particles (eq. 3)", true, false),
    [F_BROKEN] = BOND("broken", "broken", "1", "1: the bond is broken", true, true),
    [F_BROKEN_AT] = BOND("broken_at", "broken at", "1",
                         "step after which it was broken; 0: notch; -1: not broken", true, true),
    [F_NOTCH] = BOND("notch", "notch", "1", "1: the notch cuts the bond", false, true),
    [F_PULL] = BOND("pull", "pull", "N/m^3", "force density on its ends, positive in tension", false, false),
    [F_BOND_ENERGY] = BOND("energy", "energy", "J", "strain energy of the bond", false, false),
};

static FieldValue *const particle_values[N_FIELDS] = {
    [F_X0] = rest_x,
    [F_Y0] = rest_y,
    [F_UX] = ux,
    [F_UY] = uy,
    [F_VX] = vx,
    [F_VY] = vy,
    [F_DAMAGE] = damage,
    [F_SURFACE] = surface_factor,
    [F_FX] = fx,
    [F_FY] = fy,
    [F_SPEED] = speed,
    [F_FAMILY] = family_size,
    [F_SURFACE_X] = surface_x,
    [F_SURFACE_Y] = surface_y,
    [F_HELD] = held,
    [F_LOADED] = loaded,
    [F_PROBE] = probe,
    [F_PROTECTED] = protected_node,
};

static BondValue *const bond_values[N_FIELDS] = {
    [F_I] = end_i,
    [F_J] = end_j,
    [F_XI] = x_i,
    [F_YI] = y_i,
    [F_XJ] = x_j,
    [F_YJ] = y_j,
    [F_BOND_STRETCH] = stretch,
    [F_BROKEN] = broken,
    [F_BROKEN_AT] = broken_at,
    [F_NOTCH] = is_notch,
    [F_PULL] = pull,
    [F_BOND_ENERGY] = energy,
};

void beam_field(const Simulation *sim, int field, size_t first, size_t count, double *out)
{
    const Beam *beam = (const Beam *)sim;
    ASSERT_INT(field, <, sim->n_fields);
    ASSERT_INT(first + count, <=, sim->counts[fields[field].set]);
    if (count == 0)
        return;
    if (field == F_STRAIN_ENERGY) {
        beam_strain_energies(beam, first, count, out);
        return;
    }
    if (field == F_STRETCH) {
        beam_largest_stretches(beam, first, count, out);
        return;
    }
    if (fields[field].set == SET_PARTICLE) {
        for (size_t k = 0; k < count; k++)
            out[k] = particle_values[field](beam, first + k);
        return;
    }
    BondPlace place = lattice_bond_place(&beam->lattice, first);
    for (size_t k = 0; k < count; k++) {
        BondNow bond = beam_bond(beam, place);
        out[k] = bond_values[field](beam, place, &bond);
        place = lattice_next_bond(&beam->lattice, place);
    }
}

void beam_set_fields(Beam *beam)
{
    Simulation *sim = &beam->sim;
    sim->sets = sets;
    sim->n_sets = N_SETS;
    sim->counts[SET_PARTICLE] = lattice_nodes(&beam->lattice);
    sim->counts[SET_BOND] = lattice_bonds(&beam->lattice);
    sim->fields = fields;
    sim->n_fields = N_FIELDS;
    sim->has = HAS_PLANE | HAS_BONDS | HAS_STRETCH | (beam->def.critical_stretch > 0.0 ? HAS_BREAKING : 0);
    sim->columns = (size_t)beam->lattice.nx;
    sim->rows = (size_t)beam->lattice.ny;
    sim->spacing = beam->lattice.spacing;
    sim->dimensions = 2;
    sim->position[0] = F_X0;
    sim->position[1] = F_Y0;
    sim->displacement[0] = F_UX;
    sim->displacement[1] = F_UY;
    sim->velocity[0] = F_VX;
    sim->velocity[1] = F_VY;
}
