/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Families, the links that front ends draw, and what bonds give their ends, by eqs. 2 and 3:
 *
 *     s = (|xi + eta| - |xi|)/|xi|        written so that small strains keep their digits (offset_stretch)
 *     f = sum p n,  p = K s               K = c G w V, n = (xi + eta)/|xi + eta| towards the other end
 *
 * A broken bond has K = 0. */
#include "base/assertion.h"
#include "methods/bonds/plane/bonds_mistakes.h"

#include <math.h>

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

/* The family of a node: each bond as its owner sees it, or its other end. */
size_t beam_links(const Simulation *sim, int set, size_t index, Link *out, size_t max)
{
    ASSERT_INT(set, ==, SET_PARTICLE);
    ASSERT_INDEX(index, sim->counts[set]);
    const Beam *beam = (const Beam *)sim;
    const Lattice *lattice = &beam->lattice;
    const int i = lattice_column(lattice, index), j = lattice_row(lattice, index);
    BondPlace family[FAMILY_MAX];
    size_t n = beam_family(beam, i, j, family);
    n = n < max ? n : max;
    for (size_t k = 0; k < n; k++) {
        const BondPlace place = family[k];
        const Offset *offset = &lattice->offsets[place.offset];
        const BondNow bond = beam_bond(beam, place);
        const size_t slot = lattice_slot(lattice, place);
        const bool own = place.i == i && place.j == j, broken = beam_bit(beam->broken, slot);
        const int other_i = own ? i + offset->p : place.i, other_j = own ? j + offset->q : place.j;
        const double way = own ? 1 : -1;
        out[k] = (Link){.set = SET_PARTICLE,
                        .index = lattice_node(lattice, other_i, other_j),
                        .mirrored = lattice_is_image(lattice, other_i),
                        .stretch = bond.stretch,
                        .stiffness = bond.stiffness * bond.share[own ? 0 : 1],
                        .broken = broken,
                        .broken_at = broken ? beam->broken_at[slot] : 0,
                        .apart = {way * offset->x, way * offset->y},
                        .direction = {way * bond.direction[0], way * bond.direction[1]},
                        .factors = {lattice->micromodulus * offset->influence,
                                    lattice_correction(lattice, place), offset->weight, beam_volume(beam)}};
    }
    return n;
}

int beam_exchange(const Simulation *sim, int exchange, size_t index, const Link *link,
                  double factors[EXCHANGE_FACTORS_MAX])
{
    (void)sim, (void)index;
    return exchange_two(factors, link_pull(link), link->direction[exchange]);
}
