/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Single bonds as they stand, families, and the links that front ends draw. One bond by eqs. 2 and 3:
 *
 *     s = (|xi + eta| - |xi|)/|xi|        written so that small strains keep their digits (offset_stretch)
 *     pull = c G w V s                    force density on its ends, N/m^3, along (xi + eta)/|xi + eta|
 *     energy = pull s |xi| V b/2          J, b the thickness
 *
 * A broken bond has the coefficient c G w V = 0, so its pull and energy are 0. */
#include "base/assertion.h"
#include "methods/bonds/plane/bonds_mistakes.h"

#include <math.h>

/* Eqs. 2, 3 for one bond as the state stands: what the inspector and the tables show. The kernels do not call
 * it. */
BondNow beam_bond(const Beam *beam, BondPlace place)
{
    ASSERT(lattice_has(&beam->lattice, place.i, place.j));
    ASSERT_INDEX(place.offset, beam->lattice.n_offsets);
    const Lattice *lattice = &beam->lattice;
    const Offset *offset = &lattice->offsets[place.offset];
    size_t slot = lattice_slot(lattice, place), ends[2];
    const double ex = lattice_apart(lattice, place, beam->nodes.ux),
                 ey = lattice_apart(lattice, place, beam->nodes.uy);
    lattice_ends(lattice, place, ends);
    double rx = offset->x + ex, ry = offset->y + ey, length = sqrt(rx * rx + ry * ry);
    BondNow bond = {
        .a = ends[0],
        .b = ends[1],
        .stretch = offset_stretch(offset, ex, ey),
        .direction = {length > 0 ? rx / length : 0, length > 0 ? ry / length : 0},
        .broken = beam_bit(beam->broken, slot),
        .notch = beam_bit(beam->notched, slot),
        .owned = true,
    };
    bond.pull = beam->coefficient[slot] * bond.stretch;
    bond.energy = bond.pull * bond.stretch * offset->length * beam->system.energy_scale;
    return bond;
}

BondNow bonds_seen_from(const Beam *beam, BondPlace place, size_t index)
{
    ASSERT_INDEX(place.offset, beam->lattice.n_offsets);
    BondNow bond = beam_bond(beam, place);
    const bool own = bond.a == index && !lattice_is_image(&beam->lattice, place.i);
    ASSERT(own || bond.b == index);
    if (bonds_mistake(beam)) {
        const BondsPull pull = bonds_pull(beam, place);
        bond.pull = own ? pull.own : pull.other;
        bond.direction[0] = pull.x;
        bond.direction[1] = pull.y;
    }
    if (own)
        return bond;
    bond.direction[0] = -bond.direction[0];
    bond.direction[1] = -bond.direction[1];
    bond.b = bond.a;
    bond.owned = false;
    return bond;
}

/* A node owns half of its bonds; those of the other half are owned by the nodes below it and to its left,
 * mirrored. */
size_t beam_family(const Beam *beam, int i, int j, BondPlace *out)
{
    ASSERT(lattice_has(&beam->lattice, i, j));
    const Lattice *lattice = &beam->lattice;
    size_t n = 0;
    /* the bonds that others own, then its own: so the other ends come row by row, column by column */
    for (int q = lattice->rise; q >= 0; q--)
        for (int o = lattice->first[q + 1] - 1; o >= lattice->first[q]; o--)
            if (lattice_has(lattice, i - lattice->offsets[o].p, j - q))
                out[n++] = (BondPlace){i - lattice->offsets[o].p, j - q, o};
    for (int o = 0; o < lattice->n_offsets; o++)
        if (lattice_has(lattice, i + lattice->offsets[o].p, j + lattice->offsets[o].q))
            out[n++] = (BondPlace){i, j, o};
    return n;
}

size_t beam_family_of(const Beam *beam, size_t node, BondPlace *out)
{
    const Lattice *lattice = &beam->lattice;
    return beam_family(beam, lattice_column(lattice, node), lattice_row(lattice, node), out);
}

/* A bond as one of its ends sees it. */
static Link link_from(const Beam *beam, BondPlace place, size_t end)
{
    const BondNow bond = bonds_seen_from(beam, place, end);
    const Lattice *lattice = &beam->lattice;
    const Offset *offset = &lattice->offsets[place.offset];
    return (Link){.set = SET_PARTICLE,
                  .index = bond.b,
                  .stretch = bond.stretch,
                  .pull = bond.pull * beam_volume(beam),
                  .broken = bond.broken,
                  .broken_at = bond.broken ? beam->broken_at[lattice_slot(lattice, place)] : 0,
                  .apart = {bond.owned ? offset->x : -offset->x, bond.owned ? offset->y : -offset->y},
                  .direction = {bond.direction[0], bond.direction[1]},
                  .factors = {lattice->micromodulus * offset->influence, lattice_correction(lattice, place),
                              offset->weight, beam_volume(beam)}};
}

/* Of a bond its two ends, each as the other sees it; of a node its family. Pull in N/m: force
 * density times V. */
size_t beam_links(const Simulation *sim, int set, size_t index, Link *out, size_t max)
{
    const Beam *beam = (const Beam *)sim;
    ASSERT_INT(index, <, sim->counts[set]);
    if (set == SET_BOND) {
        const BondPlace place = lattice_bond_place(&beam->lattice, index);
        const BondNow bond = beam_bond(beam, place);
        const size_t others[2] = {bond.b, bond.a}; /* of its ends a and b */
        size_t n = max < 2 ? max : 2;
        for (size_t k = 0; k < n; k++)
            out[k] = link_from(beam, place, others[k]);
        return n;
    }
    BondPlace family[FAMILY_MAX];
    size_t n = beam_family_of(beam, index, family);
    n = n < max ? n : max;
    for (size_t k = 0; k < n; k++)
        out[k] = link_from(beam, family[k], index);
    return n;
}
