/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fields of a beam that front ends read (Simulation.fields). Everything is computed when it is read, from
 * the state as it stands, in mid-step too; nothing here is part of a step. SI units. */
#include "base/assertion.h"
#include "methods/bonds/plane/bonds_internal.h"
#include "base/math/functions.h"
#include "methods/axial.h"

#include <string.h>

static const Set sets[N_SETS] = {
    [SET_PARTICLE] = {"particle", "particles", 0},
    [SET_BOND] = {"bond", "bonds", 0},
};

/* --- what a field can be: its kind and its value ---------------------------------------------------- */

/* Bonds of a node at rest, broken ones included. */
static double family_size(const Beam *beam, int i, int j)
{
    const Lattice *lattice = &beam->lattice;
    const int reach = lattice->reach;
    /* far from the surface every family is whole: no need to count, as views read this in every frame */
    if (i >= reach && j >= lattice->rise && i < lattice->nx - reach && j < lattice->ny - lattice->rise)
        return 2 * lattice->n_offsets;
    BondPlace family[FAMILY_MAX];
    return (double)beam_family(beam, i, j, family);
}

/* At present: a column leaves the channel as time goes on. */
static bool is_held(const Beam *beam, int i, int j)
{
    bool held = i < beam_held_columns(beam, simulation_time(&beam->sim));
    for (const Support *s = beam->supports; s < beam->supports + beam->n_supports; s++)
        held = held || patch_has(&s->patch, i, j);
    return held;
}

static bool is_loaded(const Beam *beam, int i, int j)
{
    bool loaded = false;
    for (const Load *load = beam->loads; load < beam->loads + beam->n_loads; load++)
        loaded = loaded || patch_has(&load->patch, i, j);
    return loaded;
}

/* A padded array of the state. */
#define OF_STATE(KIND)                                                                                       \
    KIND(F_UX, beam->nodes.ux)                                                                               \
    KIND(F_UY, beam->nodes.uy)                                                                               \
    KIND(F_VX, beam->nodes.vx)                                                                               \
    KIND(F_VY, beam->nodes.vy)                                                                               \
    KIND(F_FX, beam->nodes.fx)                                                                               \
    KIND(F_FY, beam->nodes.fy)

/* Of a node, in column i of row j. */
#define OF_NODE(KIND)                                                                                        \
    KIND(F_X0, lattice_x(lattice, i))                                                                        \
    KIND(F_Y0, lattice_y(lattice, j))                                                                        \
    KIND(F_SURFACE, (lattice->factor_x[node] + lattice->factor_y[node]) / 2)                                 \
    KIND(F_SPEED, math_hypot(beam->nodes.vx[at], beam->nodes.vy[at]))                                        \
    KIND(F_FAMILY, family_size(beam, i, j))                                                                  \
    KIND(F_SURFACE_X, lattice->factor_x[node])                                                               \
    KIND(F_SURFACE_Y, lattice->factor_y[node])                                                               \
    KIND(F_HELD, is_held(beam, i, j))                                                                        \
    KIND(F_LOADED, is_loaded(beam, i, j))                                                                    \
    KIND(F_PROBE, (i == beam->probe_i[0] || i == beam->probe_i[1]) &&                                        \
                      (j == beam->probe_j[0] || j == beam->probe_j[1]))                                      \
    KIND(F_PROTECTED, beam->unbreakable[node])                                                               \
    KIND(F_X, lattice_x(lattice, i) + beam->nodes.ux[at])                                                    \
    KIND(F_STRESS, bonds_line_stress(beam, i))                                                               \
    KIND(F_STRAIN, bonds_line_strain(beam, i))                                                               \
    KIND(F_DENSITY, beam->def.density / (1 + bonds_line_strain(beam, i)))                                    \
    KIND(F_MASS, beam->def.density * lattice->spacing)                                                       \
    KIND(F_LOAD, beam_load_on(&beam->sim, node, 0))                                                          \
    KIND(F_ACCELERATION, beam->nodes.fx[at] / beam->def.density)

/* Of a bond; its ends are its owner and that at its offset. */
#define OF_BOND(KIND)                                                                                        \
    KIND(F_I, (double)ends[0])                                                                               \
    KIND(F_J, (double)ends[1])                                                                               \
    KIND(F_XI, lattice_x(lattice, place.i))                                                                  \
    KIND(F_YI, lattice_y(lattice, place.j))                                                                  \
    KIND(F_XJ, lattice_x(lattice, place.i + offset->p))                                                      \
    KIND(F_YJ, lattice_y(lattice, place.j + offset->q))                                                      \
    KIND(F_BOND_STRETCH, bond.stretch)                                                                       \
    KIND(F_BROKEN, beam_bit(beam->broken, slot))                                                             \
    KIND(F_BROKEN_AT, beam_bit(beam->broken, slot) ? (double)beam->broken_at[slot] : -1)                     \
    KIND(F_NOTCH, beam_bit(beam->notched, slot))                                                             \
    KIND(F_PULL, (bond.stiffness * bond.stretch))                                                            \
    KIND(F_BOND_ENERGY, bond.energy)                                                                         \
    KIND(F_MICROMODULUS, lattice->micromodulus * offset->influence)                                          \
    KIND(F_CORRECTION, lattice_correction(lattice, place))                                                   \
    KIND(F_WEIGHT, offset->weight)

#define NAME(kind, value) kind,
typedef enum FieldKind {
    F_DAMAGE,
    F_STRAIN_ENERGY, /* from here on a sum over a node's family, or its largest: family_field() */
    F_STRETCH,
    F_SXX,
    F_SYY,
    F_SXY, /* to here */
    OF_STATE(NAME) OF_NODE(NAME) OF_BOND(NAME)
} FieldKind;

/* --- the fields of beams and of a bar ---------------------------------------------------------------- */

#define PARTICLE(kind, name, label, unit, meaning, table, whole)                                             \
    FIELD_ROW(kind, 0, SET_PARTICLE, table, whole, name, label, unit, meaning)
#define BOND(kind, name, label, unit, meaning, table, whole)                                                 \
    FIELD_ROW(kind, 0, SET_BOND, table, whole, name, label, unit, meaning)

static const Field fields[] = {
    PARTICLE(F_X0, "x0", "x0", "m", "reference position along x", true, false),
    PARTICLE(F_Y0, "y0", "y0", "m", "reference position along y", true, false),
    PARTICLE(F_UX, "ux", "ux", "m", "displacement along x", true, false),
    PARTICLE(F_UY, "uy", "uy", "m", "displacement along y", true, false),
    PARTICLE(F_VX, "vx", "vx", "m/s", "velocity along x", true, false),
    PARTICLE(F_VY, "vy", "vy", "m/s", "velocity along y", true, false),
    PARTICLE(F_DAMAGE, "damage", "damage", "1",
             "broken share of the family, the notch's bonds included (eq. 5)", true, false),
    PARTICLE(F_SURFACE, "surface_factor", "surface factor", "1",
             "surface correction of the node: the mean of its two directions", true, false),
    PARTICLE(F_STRAIN_ENERGY, "strain_energy", "strain energy", "J", "half of the energy of the node's bonds",
             true, false),
    PARTICLE(F_FX, "fx", "force x", "N/m^3", "force density along x", false, false),
    PARTICLE(F_FY, "fy", "force y", "N/m^3", "force density along y", false, false),
    PARTICLE(F_SPEED, "speed", "speed", "m/s", "magnitude of the velocity", false, false),
    PARTICLE(F_STRETCH, "stretch", "stretch", "1", "largest stretch of the node's whole bonds", false, false),
    PARTICLE(F_FAMILY, "family", "family", "1", "number of bonds, broken ones included", false, true),
    PARTICLE(F_SURFACE_X, "surface_x", "g_x", "1", "surface factor along x", false, false),
    PARTICLE(F_SURFACE_Y, "surface_y", "g_y", "1", "surface factor along y", false, false),
    PARTICLE(F_HELD, "held", "held", "1", "1: a support or the channel holds the node", false, true),
    PARTICLE(F_LOADED, "loaded", "loaded", "1", "1: the load acts on the node", false, true),
    PARTICLE(F_PROBE, "probe", "probe", "1", "1: the probe is the mean of such nodes", false, true),
    PARTICLE(F_PROTECTED, "protected", "protected", "1", "1: bonds of the node never break", false, true),
    PARTICLE(F_SXX, "sxx", "stress xx", "Pa", "stress along x by the bonds' forces", false, false),
    PARTICLE(F_SYY, "syy", "stress yy", "Pa", "stress along y by the bonds' forces", false, false),
    PARTICLE(F_SXY, "sxy", "stress xy", "Pa", "shear stress by the bonds' forces", false, false),
    BOND(F_I, "i", "i", "1", "particle at one end", true, true),
    BOND(F_J, "j", "j", "1", "particle at the other end", true, true),
    BOND(F_XI, "x_i", "x_i", "m", "reference position of particle i along x", true, false),
    BOND(F_YI, "y_i", "y_i", "m", "reference position of particle i along y", true, false),
    BOND(F_XJ, "x_j", "x_j", "m", "reference position of particle j along x", true, false),
    BOND(F_YJ, "y_j", "y_j", "m", "reference position of particle j along y", true, false),
    BOND(F_BOND_STRETCH, "stretch", "stretch", "1", "stretch s between the two particles (eq. 3)", true,
         false),
    BOND(F_BROKEN, "broken", "broken", "1", "1: the bond is broken", true, true),
    BOND(F_BROKEN_AT, "broken_at", "broken at", "1",
         "step after which it was broken; 0: notch; -1: not broken", true, true),
    BOND(F_NOTCH, "notch", "notch", "1", "1: the notch cuts the bond", false, true),
    BOND(F_PULL, "pull", "pull", "N/m^3", "force density on its ends, positive in tension", false, false),
    BOND(F_BOND_ENERGY, "energy", "energy", "J", "strain energy of the bond", false, false),
    BOND(F_MICROMODULUS, "c", "c", "N/m^5", "stiffness c of the bond (eq. 4)", false, false),
    BOND(F_CORRECTION, "G", "G", "1", "surface correction G of the bond", false, false),
    BOND(F_WEIGHT, "w", "w", "1", "share w of the other end's volume that counts", false, false),
};

/* Of a bar, whose words for them are others. */
enum { F_U = F_UX, F_V = F_VX };
#define AXIAL(which, name, label, unit, meaning) PARTICLE(F_##which, name, label, unit, meaning, true, false)
static const Field line_fields[] = {
    AXIAL_FIELD_ROWS(AXIAL, "force of all bonds through a section, mean of the sections beside the node",
                     "mean stretch of the node's bonds, weighted with length"),
    PARTICLE(F_STRAIN_ENERGY, "strain_energy", "strain energy", "force/length",
             "half of the energy of the node's bonds", true, false),
    PARTICLE(F_SURFACE, "surface_factor", "surface factor", "1", "surface correction g of the node", true,
             false),
    PARTICLE(F_FX, "force", "force", "force/length^3", "force density: of the bonds, then with the loads",
             false, false),
    PARTICLE(F_LOAD, "load", "load", "force/length^3", "force density of all loads", false, false),
    PARTICLE(F_STRETCH, "stretch", "stretch", "1", "largest stretch of the node's bonds", false, false),
    PARTICLE(F_FAMILY, "family", "family", "1", "number of bonds, those to mirrored nodes included", false,
             true),
    PARTICLE(F_ACCELERATION, "acceleration", "acceleration", "length/time^2", "force density over density",
             false, false),
    BOND(F_I, "i", "i", "1", "particle at the left end", true, true),
    BOND(F_J, "j", "j", "1", "particle at the right end", true, true),
    BOND(F_XI, "x_i", "x_i", "length", "position of particle i at the start", true, false),
    BOND(F_XJ, "x_j", "x_j", "length", "position of particle j at the start", true, false),
    BOND(F_BOND_STRETCH, "stretch", "stretch", "1", "stretch s between the two particles", true, false),
    BOND(F_PULL, "pull", "pull", "force/length^3", "force density on its ends, positive in tension", false,
         false),
    BOND(F_BOND_ENERGY, "energy", "energy", "force/length", "strain energy of the bond", false, false),
    BOND(F_MICROMODULUS, "c", "c", "force/length^4", "stiffness c of the bond", false, false),
    BOND(F_CORRECTION, "G", "G", "1", "surface correction G of the bond", false, false),
    BOND(F_WEIGHT, "w", "w", "1", "share w of the other end's volume that counts", false, false),
};

/* --- what fills them ------------------------------------------------------------------------------ */

static const double no_stretch = -1; /* what no whole bond has */

/* What `count` bonds side by side give to each of their ends; c: c G w V, 0 of a broken one. */
static void bond_shares(const Beam *beam, FieldKind field, BondPlace first, int count, double *out)
{
    const Offset *offset = &beam->lattice.offsets[first.offset];
    const size_t own = lattice_at(&beam->lattice, first.i, first.j);
    const size_t other = lattice_at(&beam->lattice, first.i + offset->p, first.j + offset->q);
    const double *const ux = beam->nodes.ux, *const uy = beam->nodes.uy;
    const double *const c = beam->coefficient + lattice_slot(&beam->lattice, first);
#pragma omp simd
    for (int i = 0; i < count; i++)
        out[i] = offset_stretch(offset, ux[other + (size_t)i] - ux[own + (size_t)i],
                                uy[other + (size_t)i] - uy[own + (size_t)i]);
    for (int i = 0; field == F_STRETCH && i < count; i++)
        out[i] = c[i] != 0 ? out[i] : no_stretch;
    for (int i = 0; field == F_STRAIN_ENERGY && i < count; i++)
        out[i] = c[i] * out[i] * out[i] * offset->length * 0.5;
    for (int i = 0; field >= F_SXX && field <= F_SXY && i < count; i++) {
        const double x = offset->x + ux[other + (size_t)i] - ux[own + (size_t)i],
                     y = offset->y + uy[other + (size_t)i] - uy[own + (size_t)i];
        const double product = field == F_SXX ? x * x : field == F_SYY ? y * y : x * y;
        out[i] *= 0.5 * c[i] / (offset->length * (1 + out[i])) * product;
    }
}

static int smaller(int a, int b)
{
    return a < b ? a : b;
}

static int larger(int a, int b)
{
    return a > b ? a : b;
}

/* What nodes [first, first + count) have of their bonds, b the thickness, y = x + u:
 *
 *     strain energy      1/2 sum_j c G w s^2 |xi| V^2/2 b     half of each bond's energy
 *     largest stretch    max_j s over whole bonds             (eq. 3)
 *     stress             1/2 sum_j f_ij,a (y_j - y_i)_b V_j   their virial (Lehoucq, Silling 2008), near a
 *                                                             surface of the family that is left
 *
 * A view may colour by them in every frame, so a tile's bonds of one direction are taken at once, and each is
 * given to both ends. Tiles begin at the same columns whatever the range, so a node meets its bonds in one
 * order, and its sum has the same bits. */
static void family_field(const Beam *beam, FieldKind field, size_t first, size_t count, double *out)
{
    const Lattice *lattice = &beam->lattice;
    const int wide = lattice_wide(lattice), before = lattice->images[0];
    const int low = (int)(first / (size_t)wide), high = (int)((first + count - 1) / (size_t)wide);
    /* of a few nodes of a row only what reaches them */
    const int left = low == high ? lattice_column(lattice, first) - lattice->reach : 0;
    const int right = low == high ? lattice_column(lattice, first + count - 1) + lattice->reach : lattice->nx;
    for (size_t k = 0; k < count; k++)
        out[k] = field == F_STRETCH ? no_stretch : 0;
    for (int j = low > lattice->rise ? low - lattice->rise : 0; j <= high; j++)
        for (int o = 0; o < lattice->n_offsets; o++)
            for (size_t tile = 0; tile < lattice->n_tiles; tile++) {
                const Offset *offset = &lattice->offsets[o];
                const int p = offset->p, ends = lattice->nx - (p > 0 ? p : 0);
                const int from = larger((int)lattice_tile(lattice, tile), larger(left, p < 0 ? -p : 0));
                const int end = smaller((int)lattice_tile(lattice, tile + 1), smaller(right + 1, ends));
                double shares[LATTICE_TILE];
                if (from >= end || j + offset->q >= lattice->ny)
                    continue;
                bond_shares(beam, field, (BondPlace){from, j, o}, end - from, shares);
                for (int k = 0; k < 2; k++) {
                    /* of the ends in columns i + k p, whose nodes have numbers first + start + i */
                    const int start = (j + k * offset->q) * wide + k * p - before - (int)first;
                    const int lowest = larger(from, larger(-start, before - k * p));
                    const int most = smaller(end, smaller((int)count - start, before + wide - k * p));
                    for (int i = lowest; i < most; i++) {
                        const double share = shares[i - from];
                        double *value = &out[start + i];
                        *value = field != F_STRETCH ? *value + share : share > *value ? share : *value;
                    }
                }
            }
    for (size_t k = 0; k < count; k++)
        out[k] = field == F_STRAIN_ENERGY                     ? out[k] * beam->system.energy_scale
                 : field == F_STRETCH && out[k] == no_stretch ? 0
                                                              : out[k];
}

#define VALUE(kind, value)                                                                                   \
    case kind:                                                                                               \
        return value;

/* NULL: the field is none of these. */
static const double *array_of(const Beam *beam, FieldKind kind)
{
    switch (kind) {
        OF_STATE(VALUE)
    default:
        return NULL;
    }
}

static double node_field(const Beam *beam, FieldKind kind, size_t node)
{
    const Lattice *lattice = &beam->lattice;
    const int i = lattice_column(lattice, node), j = lattice_row(lattice, node);
    const size_t at = lattice_at(lattice, i, j);
    switch (kind) {
        OF_NODE(VALUE)
    default:
        return 0;
    }
}

static double bond_field(const Beam *beam, FieldKind kind, BondPlace place)
{
    const Lattice *lattice = &beam->lattice;
    const Offset *offset = &lattice->offsets[place.offset];
    const BondNow bond = beam_bond(beam, place);
    const size_t slot = lattice_slot(lattice, place);
    size_t ends[2];
    lattice_ends(lattice, place, ends);
    switch (kind) {
        OF_BOND(VALUE)
    default:
        return 0;
    }
}

void beam_field(const Simulation *sim, int field, size_t first, size_t count, double *out)
{
    const Beam *beam = (const Beam *)sim;
    ASSERT_INT(field, <, sim->n_fields);
    ASSERT_INT(first + count, <=, sim->counts[sim->fields[field].set]);
    const bool of_node = sim->fields[field].set == SET_PARTICLE;
    const FieldKind kind = (FieldKind)sim->fields[field].kind;
    if (count == 0)
        return;
    if (kind >= F_STRAIN_ENERGY && kind <= F_SXY) {
        family_field(beam, kind, first, count, out);
        return;
    }
    const double *array = array_of(beam, kind);
    const size_t wide = (size_t)lattice_wide(&beam->lattice);
    for (size_t node = first, part; array && node < first + count; node += part) {
        /* views read these of all nodes in every frame: row by row */
        const size_t beside = wide - node % wide, left = first + count - node;
        const int i = lattice_column(&beam->lattice, node);
        part = beside < left ? beside : left;
        memcpy(out + (node - first), array + lattice_at(&beam->lattice, i, (int)(node / wide)),
               part * sizeof *out);
    }
    if (array)
        return;
    if (kind == F_DAMAGE) {
        memcpy(out, beam->damage + first, count * sizeof *out);
        return;
    }
    if (of_node) {
        for (size_t k = 0; k < count; k++)
            out[k] = node_field(beam, kind, first + k);
        return;
    }
    BondPlace place = lattice_bond_place(&beam->lattice, first);
    for (size_t k = 0; k < count; k++) {
        out[k] = bond_field(beam, kind, place);
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
    if (beam->lattice.line) {
        sim->fields = line_fields;
        sim->n_fields = sizeof line_fields / sizeof *line_fields;
        sim->has = HAS_LINE | HAS_BONDS | HAS_STRETCH;
        simulation_lay(sim, sim->counts[SET_PARTICLE], 1, beam->lattice.spacing, 1);
        return;
    }
    sim->fields = fields;
    sim->n_fields = sizeof fields / sizeof *fields;
    sim->common_speed = beam->def.problem == BEAM_MOVING_CANTILEVER ? beam->def.speed : 0;
    sim->has = HAS_PLANE | HAS_BONDS | HAS_STRETCH | (beam->def.problem == BEAM_PLATE ? HAS_ROWS : 0u);
    if (beam->def.critical_stretch > 0)
        beam_set_breaking(beam);
    simulation_lay(sim, (size_t)beam->lattice.nx, (size_t)beam->lattice.ny, beam->lattice.spacing, 2);
}
