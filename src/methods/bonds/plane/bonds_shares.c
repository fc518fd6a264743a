/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fields of nodes that come from their bonds, read by views and tables between stages:
 *
 *     strain energy of node i      1/2 sum_j c G w s^2 |xi| V^2/2 b     half of each bond's energy
 *     largest stretch of node i    max_j s over live bonds              (eq. 3 of paper P)
 *
 * with b the thickness of the beam. A view may colour by them in every frame, so bonds are not looked up node
 * by node but taken row by row, a direction at a time in a vector loop, and each value is added to both ends.
 * Which nodes are wanted is a range of indices, first to first + count, cut into a slice of each row. */
#include "base/assertion.h"
#include "methods/bonds/plane/bonds_internal.h"

#include <limits.h>

typedef enum FamilyValue { BOND_ENERGY, LARGEST_STRETCH } FamilyValue;

static const double no_stretch = -1; /* what no live bond has */

/* The wanted nodes of one row: columns from .. end - 1, and where their values go. */
typedef struct RowSlice {
    int from, end;
    double *out; /* of column `from`; NULL: none is wanted */
} RowSlice;

/* The part of row j that lies in [first, first + count). */
static RowSlice row_slice(const Beam *beam, int j, size_t first, size_t count, double *out)
{
    const size_t wide = (size_t)lattice_wide(&beam->lattice), start = (size_t)j * wide, stop = start + wide;
    size_t low = start > first ? start : first, high = stop < first + count ? stop : first + count;
    if (low >= high)
        return (RowSlice){0, 0, NULL};
    const int before = beam->lattice.images[0];
    return (RowSlice){before + (int)(low - start), before + (int)(high - start), out + (low - first)};
}

static int smaller(int a, int b)
{
    return a < b ? a : b;
}

static int larger(int a, int b)
{
    return a > b ? a : b;
}

/* Gives the values of `count` bonds to their ends, of which the first is in column `first`. */
static void share(FamilyValue what, const double *values, int first, int count, RowSlice slice)
{
    const int from = larger(first, slice.from), end = smaller(first + count, slice.end);
    if (from >= end) /* a slice may be empty, and have no values */
        return;
    double *out = slice.out + (from - slice.from);
    values += from - first;
    for (int i = 0; what == BOND_ENERGY && i < end - from; i++)
        out[i] += values[i];
    for (int i = 0; what == LARGEST_STRETCH && i < end - from; i++)
        out[i] = values[i] > out[i] ? values[i] : out[i];
}

/* s of `count` bonds side by side, no_stretch of a broken one; or c G w V s^2 |xi|/2, 0 of a broken one:
 * times V and the thickness it is in J. */
static void find_values(const Beam *beam, FamilyValue what, BondPlace first, int count, double *values)
{
    const Offset *offset = &beam->lattice.offsets[first.offset];
    const size_t own = lattice_at(&beam->lattice, first.i, first.j);
    const size_t other = lattice_at(&beam->lattice, first.i + offset->p, first.j + offset->q);
    const double *const ux = beam->nodes.ux, *const uy = beam->nodes.uy;
    const double *const k = beam->coefficient + lattice_slot(&beam->lattice, first);
#pragma omp simd
    for (int i = 0; i < count; i++)
        values[i] = offset_stretch(offset, ux[other + (size_t)i] - ux[own + (size_t)i],
                                   uy[other + (size_t)i] - uy[own + (size_t)i]);
    for (int i = 0; what == BOND_ENERGY && i < count; i++)
        values[i] = k[i] * values[i] * values[i] * offset->length * 0.5;
    for (int i = 0; what == LARGEST_STRETCH && i < count; i++)
        values[i] = k[i] != 0 ? values[i] : no_stretch;
}

/* The bonds from row j in direction o that end in a slice. */
static void share_direction(const Beam *beam, FamilyValue what, int j, int o, RowSlice owners,
                            RowSlice others)
{
    const Lattice *lattice = &beam->lattice;
    int p = lattice->offsets[o].p, tile_columns = (int)lattice->tile_columns;
    int from = INT_MAX, end = 0;
    if (owners.out)
        from = owners.from, end = owners.end;
    if (others.out)
        from = smaller(from, others.from - p), end = larger(end, others.end - p);
    /* bonds have both ends on the lattice */
    from = larger(from, larger(0, -p));
    end = smaller(end, smaller(lattice->nx, lattice->nx - p));
    while (from < end) {
        int stop = smaller(end, (from / tile_columns + 1) * tile_columns);
        double values[LATTICE_TILE];
        find_values(beam, what, (BondPlace){from, j, o}, stop - from, values);
        share(what, values, from, stop - from, owners);
        share(what, values, from + p, stop - from, others);
        from = stop;
    }
}

/* A node meets its bonds in the same order whatever the slice, so that its sum has the same bits. */
static void family_field(const Beam *beam, FamilyValue what, size_t first, size_t count, double *out)
{
    const Lattice *lattice = &beam->lattice;
    const RowSlice none = {0, 0, NULL};
    for (size_t k = 0; k < count; k++)
        out[k] = what == BOND_ENERGY ? 0 : no_stretch;
    const size_t wide = (size_t)lattice_wide(lattice);
    int last = (int)((first + count - 1) / wide);
    for (int j = larger(0, (int)(first / wide) - lattice->rise); j <= last; j++) {
        RowSlice owners = row_slice(beam, j, first, count, out);
        for (int q = 0; q <= lattice->rise && j + q < lattice->ny; q++) {
            RowSlice others = row_slice(beam, j + q, first, count, out);
            for (int o = lattice->first[q]; o < lattice->first[q + 1]; o++) {
                /* within a row one end after the other, or the order would depend on where tiles and slices
                 * begin */
                share_direction(beam, what, j, o, owners, q == 0 ? none : others);
                if (q == 0)
                    share_direction(beam, what, j, o, none, others);
            }
        }
    }
}

void beam_strain_energies(const Beam *beam, size_t first, size_t count, double *out)
{
    ASSERT_INT(count, >=, 1);
    ASSERT_INT(first + count, <=, lattice_nodes(&beam->lattice));
    family_field(beam, BOND_ENERGY, first, count, out);
    for (size_t k = 0; k < count; k++)
        out[k] *= beam->system.energy_scale;
}

void beam_largest_stretches(const Beam *beam, size_t first, size_t count, double *out)
{
    ASSERT_INT(count, >=, 1);
    ASSERT_INT(first + count, <=, lattice_nodes(&beam->lattice));
    family_field(beam, LARGEST_STRETCH, first, count, out);
    for (size_t k = 0; k < count; k++)
        if (out[k] <= no_stretch)
            out[k] = 0;
}
