/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The forces and energies of bonds, for rows of the lattice: the stage of a step in which all the time goes.
 * What is computed, and why without a root, is in bonds.h.
 *
 * Bonds of one direction xi whose owners stand side by side in a row are a segment: owner i at u[i], the
 * other end at v[i], coefficient c G w V at coefficient[i], no list of indices. A tile is a piece of a row
 * with all its directions to one row distance q; its forces go into two padded arrays first, a row for each
 * direction, and are then added to the owners and subtracted, p columns on, from the other ends (p the
 * direction's columns). On a bar, whose bonds reach farther than a block, the directions of a tile are taken
 * a block at a time.
 *
 * The file is compiled once for each CpuLevel. Blocks are always eight columns, and every sum keeps eight
 * partial sums, so that the width of the vectors leaves no trace. Units: m, N/m^3 for forces, J for energies.
 */
#include "methods/bonds/plane/lattice/bond_segment.h"

/* The segment of direction o that begins at column `from` of row j: the other ends lie q rows and p columns
 * on, at one fixed distance in memory, which is why no list of indices is needed. */
KERNEL_INLINE Segment segment_of(const BondSystem *system, int j, int o, size_t from, size_t count,
                                 double *coefficient)
{
    const Lattice *lattice = system->lattice;
    const Offset *direction = &lattice->offsets[o];
    size_t own = lattice_at(lattice, 0, j) + from;
    ptrdiff_t shift = (ptrdiff_t)lattice->stride * direction->q + direction->p;
    return (Segment){
        direction,
        system->series_limit[o],
        system->break_limit[o],
        system->ux + own,
        system->uy + own,
        system->ux + own + shift,
        system->uy + own + shift,
        coefficient,
        count,
        system->rooted +
            ((size_t)j * lattice->n_tiles + from / lattice->tile_columns) * (size_t)lattice->n_offsets + o,
        {(int)from, j, o}};
}

/* Where the forces of a row distance come together: two padded arrays with a row of BONDS_SPAN per direction,
 * of which `count` from LATTICE_BLOCK on hold forces and the rest zeros. */
typedef struct Parts {
    double *x, *y;
    int n; /* directions */
    const Offset *offsets;
    int beyond; /* columns from an owner to the one about which the other ends lie, a block to either side */
    size_t count;
} Parts;

/* Adds every bond's force to its owner. */
KERNEL_INLINE void add_own(const Parts *parts, double *restrict fx, double *restrict fy)
{
    const double *restrict px = parts->x + BONDS_MARGIN, *restrict py = parts->y + BONDS_MARGIN;
    for (size_t i = 0; i < parts->count; i += LANES) {
        Vector x = vector_load(fx + i), y = vector_load(fy + i);
        for (int o = 0; o < parts->n; o++) {
            x += vector_load(px + o * BONDS_SPAN + i);
            y += vector_load(py + o * BONDS_SPAN + i);
        }
        vector_store(fx + i, x);
        vector_store(fy + i, y);
    }
}

/* Subtracts it from the other end, p columns on. */
KERNEL_INLINE void subtract_other(const Parts *parts, double *restrict fx, double *restrict fy)
{
    const double *restrict px = parts->x, *restrict py = parts->y;
    ptrdiff_t shift[2 * LATTICE_REACH_MAX + 1];
    for (int o = 0; o < parts->n; o++)
        shift[o] = o * BONDS_SPAN + BONDS_MARGIN - LATTICE_BLOCK - (parts->offsets[o].p - parts->beyond);
    for (size_t i = 0; i < parts->count + 2 * LATTICE_BLOCK; i += LANES) {
        Vector x = vector_load(fx + i - LATTICE_BLOCK), y = vector_load(fy + i - LATTICE_BLOCK);
        for (int o = 0; o < parts->n; o++) {
            x -= vector_load(px + (ptrdiff_t)i + shift[o]);
            y -= vector_load(py + (ptrdiff_t)i + shift[o]);
        }
        vector_store(fx + i - LATTICE_BLOCK, x);
        vector_store(fy + i - LATTICE_BLOCK, y);
    }
}

/* Zeros behind the forces of `count` columns, which subtract_other() reads: once for tiles of one width.
 * Those before them are never written. */
static void clear_margins(double *scratch, int n, size_t count)
{
    for (int o = 0; o < n; o++)
        for (int i = 0; i < BONDS_MARGIN; i += LANES) {
            const size_t at = (size_t)(o * BONDS_SPAN + BONDS_MARGIN + i) + count;
            vector_store(scratch + at, (Vector){0});
            vector_store(scratch + BONDS_SCRATCH / 2 + at, (Vector){0});
        }
}

/* The directions from `first` on that are taken together: all of a row distance, on a bar a block at most. */
static int last_together(const Lattice *lattice, int q, int first)
{
    const int end = lattice->first[q + 1];
    return lattice->line && end - first > LATTICE_BLOCK ? first + LATTICE_BLOCK : end;
}

/* Bonds from columns [from, from + count) of row j to row j + q, of the directions [first, end). */
KERNEL_INLINE double tile(const BondSystem *system, int j, int q, int first, int end, size_t from,
                          size_t count, double *const *fx, double *const *fy, BondLog *log, bool with_energy)
{
    const Lattice *lattice = system->lattice;
    const int beyond = lattice->line ? lattice->offsets[first].p - 1 : 0;
    const Parts parts = {
        log->scratch, log->scratch + BONDS_SCRATCH / 2, end - first, lattice->offsets + first, beyond, count};
    double *coefficient = system->coefficient + lattice_slot(lattice, (BondPlace){(int)from, j, first});
    double energy = 0, sums[LATTICE_BLOCK];

    for (int o = 0; o < parts.n; o++, coefficient += count) {
        Segment segment = segment_of(system, j, first + o, from, count, coefficient);
        double *px = parts.x + o * BONDS_SPAN + BONDS_MARGIN, *py = parts.y + o * BONDS_SPAN + BONDS_MARGIN;
        segment_forces(system, &segment, with_energy, px, py, sums, log);
        if (with_energy)
            energy += sum_lanes(sums) * segment.direction->length * system->energy_scale;
    }
    add_own(&parts, fx[0] + from, fy[0] + from);
    subtract_other(&parts, fx[q] + from + beyond, fy[q] + from + beyond);
    return energy;
}

/* Rows that bonds of row j can reach; the topmost ones have fewer. */
static int rows_above(const Lattice *lattice, int j)
{
    int above = lattice->ny - 1 - j;
    return above < lattice->rise ? above : lattice->rise;
}

/* All bonds that row j owns, tile by tile, so that the rows which a tile reaches stay in the cache while all
 * its row distances are done. energy: J, the sum of their energies; NULL: not asked for. */
static void forces(const BondSystem *system, int j, double *const *fx, double *const *fy, BondLog *log,
                   double *energy)
{
    const Lattice *lattice = system->lattice;
    double sum = 0;
    for (size_t t = 0, before = 0; t < lattice->n_tiles; t++) {
        size_t from = lattice_tile(lattice, t), count = lattice_tile(lattice, t + 1) - from;
        if (count != before)
            clear_margins(log->scratch, 2 * lattice->rise + (lattice->line ? LATTICE_BLOCK : 1),
                          before = count);
        for (int q = 0; q <= rows_above(lattice, j); q++)
            for (int o = lattice->first[q], end; o < lattice->first[q + 1]; o = end) {
                end = last_together(lattice, q, o);
                if (energy)
                    sum += tile(system, j, q, o, end, from, count, fx, fy, log, true);
                else
                    tile(system, j, q, o, end, from, count, fx, fy, log, false);
            }
    }
    if (energy)
        *energy = sum;
}

/* The same sum in the same order without the forces: equal to the last bit to what forces() gives. */
static double energy_of_row(const BondSystem *system, int j)
{
    const Lattice *lattice = system->lattice;
    double sum = 0;
    for (size_t t = 0; t < lattice->n_tiles; t++) {
        size_t from = lattice_tile(lattice, t), count = lattice_tile(lattice, t + 1) - from;
        for (int q = 0; q <= rows_above(lattice, j); q++) {
            double part = 0, sums[LATTICE_BLOCK];
            double *coefficient =
                system->coefficient + lattice_slot(lattice, (BondPlace){(int)from, j, lattice->first[q]});
            for (int o = lattice->first[q], end = o; o < lattice->first[q + 1]; o++, coefficient += count) {
                if (o == end)
                    sum += part, part = 0, end = last_together(lattice, q, o);
                Segment segment = segment_of(system, j, o, from, count, coefficient);
                segment_energy(system, &segment, sums);
                part += sum_lanes(sums) * segment.direction->length * system->energy_scale;
            }
            sum += part;
        }
    }
    return sum;
}

/* y += factor x; count is a multiple of a block, padding included. */
static void add(double *y, const double *x, double factor, size_t count)
{
    for (size_t i = 0; i < count; i += LANES)
        vector_store(y + i, vector_load(y + i) + factor * vector_load(x + i));
}

/* x . y by eight partial sums, the same bits at every vector width. */
static double dot(const double *x, const double *y, size_t count)
{
    Vector sum[PARTS];
    double lanes[LATTICE_BLOCK];
    for (int part = 0; part < PARTS; part++)
        sum[part] = (Vector){0};
    for (size_t i = 0; i < count; i += LATTICE_BLOCK)
        for (int part = 0; part < PARTS; part++)
            sum[part] += vector_load(x + i + part * LANES) * vector_load(y + i + part * LANES);
    for (int part = 0; part < PARTS; part++)
        vector_store(lanes + part * LANES, sum[part]);
    return sum_lanes(lanes);
}

extern const BondKernels KERNELS(bond_kernels);

const BondKernels KERNELS(bond_kernels) = {
    .forces = forces,
    .energy = energy_of_row,
    .add = add,
    .dot = dot,
};
