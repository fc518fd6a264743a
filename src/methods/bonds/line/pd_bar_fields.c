/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What front ends read of the bar by peridynamics: fields, series, links. Computed when read, no part of a
 * step. With k = c G w V/|xi| the stiffness of a bond and e its elongation, per unit cross-section:
 *
 *     energy of a bond    k e^2 h/2;  of a node half of that of its bonds, so sum_j k e^2 h/4
 *     strain of a node    sum_j w e / sum_j w |xi|
 *     stress of a node    mean over the two sections beside it of h sum k e, all bonds through the section */
#include "base/assertion.h"
#include "methods/axial.h"
#include "methods/bonds/line/pd_bar_internal.h"

#include <math.h>
#include <stdlib.h>

static const Set sets[PD_BAR_SETS] = {
    [PD_BAR_PARTICLE] = {"particle", "particles", 0},
    [PD_BAR_BOND] = {"bond", "bonds", 0},
};

/* --- a node and its family ------------------------------------------------------------------------ */

static double displacement(const PdBar *bar, int i)
{
    return bar->u[pd_bar_at(&bar->lattice, i)];
}

/* The bond from node i to the right (m > 0) or to the left (m < 0), seen from its left end. */
typedef struct BondAt {
    int k, m; /* left end, distance */
    double elongation, stiffness;
} BondAt;

static BondAt bond_at(const PdBar *bar, int i, int m)
{
    const int k = m < 0 ? i + m : i, distance = abs(m);
    return (BondAt){k, distance, pd_bar_elongation(bar, k, distance), pd_bar_stiffness(bar, k, distance)};
}

/* sum_j k e^2 h/4: half of the energy k e^2 h/2 of each of its bonds; of a bond to a mirrored node too, whose
 * other half belongs to the image. */
static double strain_energy(const PdBar *bar, int i)
{
    double sum = 0;
    for (int m = -bar->lattice.reach; m <= bar->lattice.reach; m++)
        if (m != 0) {
            BondAt bond = bond_at(bar, i, m);
            sum += bond.stiffness * bond.elongation * bond.elongation;
        }
    return sum * bar->lattice.h / 4;
}

/* Mean stretch, weighted with |xi| and volume: sum w e / sum w |xi|. For a uniform strain it is that strain,
 * also at a free end where half of the family is missing. */
static double strain(const PdBar *bar, int i)
{
    double stretched = 0, length = 0;
    for (int m = -bar->lattice.reach; m <= bar->lattice.reach; m++) {
        if (m == 0)
            continue;
        BondAt bond = bond_at(bar, i, m);
        double weight = bond.stiffness > 0 ? bar->lattice.weight[bond.m - 1] : 0;
        stretched += weight * bond.elongation;
        length += weight * bond.m;
    }
    return length > 0 ? stretched / (length * bar->lattice.h) : 0;
}

/* The force of all bonds through the section between nodes i - 1 and i, per unit area: each carries k e on a
 * volume h. */
static double section_force(const PdBar *bar, int i)
{
    double sum = 0;
    for (int m = 1; m <= bar->lattice.reach; m++)
        for (int k = i - m; k < i; k++)
            sum += pd_bar_stiffness(bar, k, m) * pd_bar_elongation(bar, k, m);
    return sum * bar->lattice.h;
}

/* max s over the node's bonds; 0 where it has none. */
static double largest_stretch(const PdBar *bar, int i)
{
    double most = -HUGE_VAL;
    for (int m = -bar->lattice.reach; m <= bar->lattice.reach; m++) {
        if (m == 0)
            continue;
        BondAt bond = bond_at(bar, i, m);
        if (bond.stiffness > 0)
            most = fmax(most, bond.elongation / (bond.m * bar->lattice.h));
    }
    return most > -HUGE_VAL ? most : 0;
}

static double family_size(const PdBar *bar, int i)
{
    int count = 0;
    for (int m = -bar->lattice.reach; m <= bar->lattice.reach; m++)
        count += m != 0 && bond_at(bar, i, m).stiffness > 0;
    return count;
}

/* --- bonds: numbered by their left end, then by distance ------------------------------------------ */

/* Bonds of the left ends below i. Each of the last `reach` nodes has as many as there are nodes behind it. */
static size_t bonds_before(const PdBarLattice *lattice, int i)
{
    const int whole = lattice->n - lattice->reach; /* from there on the families are cut */
    if (i <= whole)
        return (size_t)i * (size_t)lattice->reach;
    const size_t beyond = (size_t)(i - whole), reach = (size_t)lattice->reach;
    return (size_t)whole * reach + beyond * reach - beyond * (beyond + 1) / 2;
}

/* The bond of a number: its left end is at number/reach or, where families are cut, a little further. */
static BondAt bond_number(const PdBar *bar, size_t number)
{
    const PdBarLattice *lattice = &bar->lattice;
    int i = (int)(number / (size_t)lattice->reach);
    while (bonds_before(lattice, i + 1) <= number)
        i++;
    return bond_at(bar, i, (int)(number - bonds_before(lattice, i)) + 1);
}

/* --- fields: one row each, and what fills them ----------------------------------------------------- */

/* Those of axial.h come first. */
enum FieldIndex {
    P_STRAIN_ENERGY = AXIAL_FIELDS,
    P_FACTOR,
    P_FORCE,
    P_LOAD,
    P_STRETCH,
    P_FAMILY,
    P_ACCELERATION,
    B_I,
    B_J,
    B_X_I,
    B_X_J,
    B_STRETCH,
    B_PULL,
    B_ENERGY,
    B_MICROMODULUS,
    B_CORRECTION,
    B_WEIGHT,
    N_FIELDS
};

#define PARTICLE(name, label, unit, meaning, table, whole)                                                   \
    FIELD_ROW(PD_BAR_PARTICLE, table, whole, name, label, unit, meaning)
#define BOND(name, label, unit, meaning, table, whole)                                                       \
    FIELD_ROW(PD_BAR_BOND, table, whole, name, label, unit, meaning)

static const Field fields[N_FIELDS] = {
    AXIAL_FIELD_ROWS("force of all bonds through a section, mean of the sections beside the node",
                     "mean stretch of the node's bonds, weighted with length"),
    [P_STRAIN_ENERGY] = PARTICLE("strain_energy", "strain energy", "force/length",
                                 "half of the energy of the node's bonds", true, false),
    [P_FACTOR] =
        PARTICLE("surface_factor", "surface factor", "1", "surface correction g of the node", true, false),
    [P_FORCE] = PARTICLE("force", "force", "force/length^3",
                         "force density: of the bonds, then with the loads", false, false),
    [P_LOAD] = PARTICLE("load", "load", "force/length^3", "force density of all loads", false, false),
    [P_STRETCH] = PARTICLE("stretch", "stretch", "1", "largest stretch of the node's bonds", false, false),
    [P_FAMILY] =
        PARTICLE("family", "family", "1", "number of bonds, those to mirrored nodes included", false, true),
    [P_ACCELERATION] =
        PARTICLE("acceleration", "acceleration", "length/time^2", "force density over density", false, false),
    [B_I] = BOND("i", "i", "1", "particle at the left end", true, true),
    [B_J] = BOND("j", "j", "1", "particle at the right end", true, true),
    [B_X_I] = BOND("x_i", "x_i", "length", "position of particle i at the start", true, false),
    [B_X_J] = BOND("x_j", "x_j", "length", "position of particle j at the start", true, false),
    [B_STRETCH] = BOND("stretch", "stretch", "1", "stretch s between the two particles", true, false),
    [B_PULL] = BOND("pull", "pull", "force/length^3", "force density on its ends, positive in tension", false,
                    false),
    [B_ENERGY] = BOND("energy", "energy", "force/length", "strain energy of the bond", false, false),
    [B_MICROMODULUS] = BOND("c", "c", "force/length^4", "stiffness c of the bond", false, false),
    [B_CORRECTION] = BOND("G", "G", "1", "surface correction G of the bond", false, false),
    [B_WEIGHT] = BOND("w", "w", "1", "share w of the other end's volume that counts", false, false),
};

static double bond_modulus(const PdBar *bar, const BondAt *bond)
{
    return bar->lattice.micromodulus * bar->lattice.influence[bond->m - 1];
}

static double bond_correction(const PdBar *bar, const BondAt *bond)
{
    const PdBarLattice *lattice = &bar->lattice;
    return (lattice->factor[pd_bar_at(lattice, bond->k)] +
            lattice->factor[pd_bar_at(lattice, bond->k + bond->m)]) /
           2;
}

static double bond_stretch(const PdBar *bar, const BondAt *bond)
{
    return bond->elongation / (bond->m * bar->lattice.h);
}

/* The value of one node's field. */
static double node_field(const PdBar *bar, int field, int i)
{
    switch (field) {
    case AXIAL_X0:
        return pd_bar_position(&bar->lattice, i);
    case AXIAL_X:
        return pd_bar_position(&bar->lattice, i) + displacement(bar, i);
    case AXIAL_U:
        return displacement(bar, i);
    case AXIAL_V:
        return bar->v[i];
    case AXIAL_STRESS:
        return (section_force(bar, i) + section_force(bar, i + 1)) / 2;
    case AXIAL_STRAIN:
        return strain(bar, i);
    case AXIAL_DENSITY:
        return bar->def.density / (1 + strain(bar, i));
    case AXIAL_MASS:
        return bar->def.density * bar->lattice.h;
    case P_STRAIN_ENERGY:
        return strain_energy(bar, i);
    case P_FACTOR:
        return bar->lattice.factor[pd_bar_at(&bar->lattice, i)];
    case P_FORCE:
        return bar->f[i];
    case P_LOAD:
        return pd_bar_load(bar, i);
    case P_STRETCH:
        return largest_stretch(bar, i);
    case P_FAMILY:
        return family_size(bar, i);
    case P_ACCELERATION:
        return bar->f[i] / bar->def.density;
    default:
        return 0;
    }
}

/* The value of one bond's field. */
static double bond_field(const PdBar *bar, int field, BondAt bond)
{
    switch (field) {
    case B_I:
        return bond.k;
    case B_J:
        return bond.k + bond.m;
    case B_X_I:
        return pd_bar_position(&bar->lattice, bond.k);
    case B_X_J:
        return pd_bar_position(&bar->lattice, bond.k + bond.m);
    case B_STRETCH:
        return bond_stretch(bar, &bond);
    case B_PULL:
        return bond.stiffness * bond.elongation;
    case B_ENERGY:
        return bond.stiffness * bond.elongation * bond.elongation * bar->lattice.h / 2;
    case B_MICROMODULUS:
        return bond_modulus(bar, &bond);
    case B_CORRECTION:
        return bond_correction(bar, &bond);
    case B_WEIGHT:
        return bar->lattice.weight[bond.m - 1];
    default:
        return 0;
    }
}

void pd_bar_field(const Simulation *sim, int field, size_t first, size_t count, double *out)
{
    const PdBar *bar = (const PdBar *)sim;
    ASSERT_INT(field, <, sim->n_fields);
    ASSERT_INT(first + count, <=, sim->counts[fields[field].set]);
    for (size_t k = 0; k < count; k++)
        out[k] = fields[field].set == PD_BAR_PARTICLE ? node_field(bar, field, (int)(first + k))
                                                      : bond_field(bar, field, bond_number(bar, first + k));
}

/* Of a bond its two ends, of a node its family, mirrored partners by the node whose image they are. Pull is
 * the force density times the other end's volume h. */
size_t pd_bar_links(const Simulation *sim, int set, size_t index, Link *out, size_t max)
{
    const PdBar *bar = (const PdBar *)sim;
    const double h = bar->lattice.h;
    ASSERT_INT(index, <, sim->counts[set]);
    size_t count = 0;
    if (set == PD_BAR_BOND) {
        BondAt bond = bond_number(bar, index);
        double stretch = bond_stretch(bar, &bond), pull = bond.stiffness * bond.elongation * h;
        const int ends[2] = {bond.k, bond.k + bond.m};
        for (; count < 2 && count < max; count++)
            out[count] = (Link){
                .set = PD_BAR_PARTICLE, .index = (size_t)ends[count], .stretch = stretch, .pull = pull};
        return count;
    }
    for (int m = -bar->lattice.reach; m <= bar->lattice.reach && count < max; m++) {
        if (m == 0)
            continue;
        const int i = (int)index;
        BondAt bond = bond_at(bar, i, m);
        if (!(bond.stiffness > 0))
            continue;
        const PdBarLattice *lattice = &bar->lattice;
        out[count++] = (Link){.set = PD_BAR_PARTICLE,
                              .index = (size_t)pd_bar_partner(&bar->lattice, i + m),
                              .stretch = bond_stretch(bar, &bond),
                              .pull = bond.stiffness * bond.elongation * h,
                              .length = m * h,
                              .stiffness = bond.stiffness * bond.m * h,
                              .factors = {bond_modulus(bar, &bond), bond_correction(bar, &bond),
                                          lattice->weight[bond.m - 1], h}};
    }
    return count;
}

/* --- series --------------------------------------------------------------------------------------- */

static const Quantity series[PD_BAR_SERIES] = {
    AXIAL_SERIES_BEGIN,
    AXIAL_SERIES_KINETIC,
    {"strain", "strain", "force/length", "strain energy of the bonds"},
    AXIAL_SERIES_END,
    AXIAL_SERIES_MOMENTUM(""),
};

/* The row of a step, between steps: v_cm = sum v/n, x_cm = L/2 + sum u/n, kinetic = rho h sum v^2/2, strain =
 * sum over nodes as above, the load's work so far, and kinetic + strain; momentum rho h sum v, and what the
 * bonds to mirrored nodes pull: h sum (f - load), as those between nodes add up to 0. All nodes have the same
 * mass rho h. */
void pd_bar_row(Simulation *sim, double *row)
{
    ASSERT_INT(sim->stage, ==, 0);
    const PdBar *bar = (const PdBar *)sim;
    const int n = bar->lattice.n;
    const ForceTerms forces = pd_bar_terms(bar);
    double momentum = 0, moved = 0, square = 0, stored = 0, pull = 0;
    for (int i = 0; i < n; i++) {
        momentum += bar->v[i];
        moved += displacement(bar, i);
        square += bar->v[i] * bar->v[i];
        stored += strain_energy(bar, i);
        pull += bar->f[i] - forces_on(&forces, sim, (size_t)i, 0);
    }
    const double kinetic = square * bar->def.density * bar->lattice.h / 2;
    const double values[PD_BAR_SERIES] = {momentum / n,
                                          bar->def.length / 2 + moved / n,
                                          kinetic,
                                          stored,
                                          bar->head->work,
                                          kinetic + stored,
                                          momentum * bar->def.density * bar->lattice.h,
                                          pull * bar->lattice.h};
    for (int k = 0; k < sim->n_series; k++)
        row[k] = values[bar->series_entry[k]];
}

void pd_bar_set_fields(PdBar *bar)
{
    Simulation *sim = &bar->sim;
    sim->sets = sets;
    sim->n_sets = PD_BAR_SETS;
    sim->counts[PD_BAR_PARTICLE] = (size_t)bar->lattice.n;
    sim->counts[PD_BAR_BOND] = bonds_before(&bar->lattice, bar->lattice.n);
    sim->fields = fields;
    sim->n_fields = N_FIELDS;
    for (int k = 0; k < PD_BAR_SERIES; k++) {
        bar->series[k] = series[k];
        bar->series_entry[k] = k;
    }
    sim->series = sim->series_asked = bar->series;
    sim->series_entry = bar->series_entry;
    sim->n_series = PD_BAR_SERIES - (bar->def.left_fixed || bar->def.right_fixed ? 0 : 1);
    axial_set_motion(sim, HAS_BONDS | HAS_STRETCH, bar->lattice.h);
}
