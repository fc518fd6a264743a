/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The square lattice of nodes and its families of bonds; nothing here changes during a run.
 *
 * Node (i, j) has the identifier j nx + i and lies at X = x0 + (i + 1/2) dx, Y = y0 + (j + 1/2) dx; it stands
 * for the area dx^2. A bar is one row, whose nodes stand for dx per unit cross-section; before and behind
 * them lie the mirrored nodes of its fixed ends, which have no identifier. Every bond is kept once, by the
 * end that comes first: by its owner (i, j) and an offset (p, q) with q > 0, or q = 0 and p > 0. A row of
 * owners is cut into tiles; the bonds of a tile have a place (slot) each, direction by direction and in a
 * direction column by column, so that a bond needs no index and the whole row is read from front to back.
 * Slots whose other end is not a node stay empty. Source: paper P, eqs. 4 and 8, and the text between them.
 */
#ifndef METHODS_BONDS_PLANE_LATTICE_LATTICE_H
#define METHODS_BONDS_PLANE_LATTICE_LATTICE_H

#include "base/status.h"
#include "methods/bonds/plane/bonds_plane.h"

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    LATTICE_TILE = 128,    /* columns of a tile at most: what a sweep needs stays in the first-level cache */
    LATTICE_BLOCK = 8,     /* columns are padded to whole blocks, whatever the vector width */
    LATTICE_REACH_MAX = 8, /* horizon / spacing at most */
    LATTICE_LINE_REACH_MAX = 24, /* likewise of a bar */
    LATTICE_OFFSETS_MAX = 112,   /* half a family of that reach and half a spacing */
    LATTICE_SERIES = 6,          /* terms of the force's series, see bonds.h */
    /* some milliseconds of building lie between two polls of its cancel */
    LATTICE_NODES_A_QUESTION = 4096,
    LATTICE_BONDS_A_QUESTION = 65536
};

/* A bond's direction, common to all bonds of that direction. */
typedef struct Offset {
    int p, q;                      /* other end minus owner, in columns and rows */
    double x, y;                   /* xi, m */
    double length, squared;        /* |xi| and |xi|^2 */
    double weight;                 /* w: what the other end's volume counts for, volume.h */
    double influence;              /* its micromodulus over that of |xi| = 0 */
    double series[LATTICE_SERIES]; /* C_k: (1 - |xi|/|xi + eta|)/|xi| = d (C_0 + C_1 d + ...) */
} Offset;

/* The stretch (eq. 3) from eta, robust where it is tiny. */
static inline double offset_stretch(const Offset *offset, double eta_x, double eta_y)
{
    double x = offset->x + eta_x, y = offset->y + eta_y;
    double d = eta_x * (offset->x + x) + eta_y * (offset->y + y);
    return d / (offset->length * (sqrt(x * x + y * y) + offset->length));
}

typedef struct Lattice {
    int nx, ny;      /* columns with those of mirrored nodes, rows */
    int images[2];   /* columns of mirrored nodes before and behind the others */
    int reach, rise; /* the largest offset in columns, in rows */
    bool line;       /* a bar */
    double spacing, x0, y0;
    double depth;        /* a node stands for spacing times this: dx, or 1 of a bar */
    double micromodulus; /* c, eq. 4, N/m^5, of a bar N/m^4; conical: of |xi| = 0 */
    double horizon, youngs_modulus;

    size_t columns;      /* nx padded to whole blocks */
    size_t n_tiles;      /* of a row */
    size_t tile_columns; /* whole blocks; the last tile may have fewer */
    size_t stride; /* doubles from one row of a node array to the next: a block, columns, as many as a bond
                      reaches beyond them */

    int n_offsets;
    int first[LATTICE_REACH_MAX + 2]; /* the offsets of row distance q are first[q] .. first[q + 1] - 1 */
    Offset offsets[LATTICE_OFFSETS_MAX];

    SurfaceCorrection correction;
    double *factor_x, *factor_y; /* per node: g_x, g_y (energy), pi delta^2 / V_i twice (volume), 1 (none) */
    uint32_t *first_bond;        /* per node, and one more: number of the first bond that the node owns */
} Lattice;

/* The shares at which its parts begin: the bonds after the factors of the nodes, then the critical step,
 * then the state at t = 0. */
#define BUILDING_BONDS    0.1
#define BUILDING_CRITICAL 0.35
#define BUILDING_START    0.98

/* The families alone; with the numbers of rows and columns. No memory is taken. False: the beam is too coarse
 * to be one, or too fine for memory. */
void lattice_find_families(Lattice *lattice, const BeamDef *definition);
bool lattice_measure(Lattice *lattice, const BeamDef *definition, Status *status);

/* All of it: with the padding, factors and bond numbers. False: as above, or memory is short. */
bool lattice_init(Lattice *lattice, const BeamDef *definition, Status *status);
void lattice_free(Lattice *lattice);

/* Nodes of a row, without the mirrored ones. */
static inline int lattice_wide(const Lattice *lattice)
{
    return lattice->nx - lattice->images[0] - lattice->images[1];
}

static inline size_t lattice_nodes(const Lattice *lattice)
{
    return (size_t)lattice_wide(lattice) * (size_t)lattice->ny;
}

/* The identifier of the node in column i of row j; of a mirrored one that of the node whose image it is. */
static inline size_t lattice_node(const Lattice *lattice, int i, int j)
{
    const int wide = lattice_wide(lattice), k = i - lattice->images[0];
    return (size_t)j * (size_t)wide + (size_t)(k < 0 ? -1 - k : k >= wide ? 2 * wide - 1 - k : k);
}

/* The column of a node, and its row. */
static inline int lattice_column(const Lattice *lattice, size_t node)
{
    return lattice->images[0] + (int)(node % (size_t)lattice_wide(lattice));
}

static inline int lattice_row(const Lattice *lattice, size_t node)
{
    return (int)(node / (size_t)lattice_wide(lattice));
}

static inline bool lattice_is_image(const Lattice *lattice, int i)
{
    return i < lattice->images[0] || i >= lattice->nx - lattice->images[1];
}

static inline double lattice_x(const Lattice *lattice, int i)
{
    return lattice->x0 + (i + 0.5) * lattice->spacing;
}

static inline double lattice_y(const Lattice *lattice, int j)
{
    return lattice->y0 + (j + 0.5) * lattice->spacing;
}

/* Where a node is in a padded array. */
static inline size_t lattice_at(const Lattice *lattice, int i, int j)
{
    return (size_t)j * lattice->stride + LATTICE_BLOCK + (size_t)i;
}

static inline size_t lattice_slots(const Lattice *lattice)
{
    return (size_t)lattice->ny * (size_t)lattice->n_offsets * lattice->columns;
}

static inline bool lattice_has(const Lattice *lattice, int i, int j)
{
    return i >= 0 && i < lattice->nx && j >= 0 && j < lattice->ny;
}

/* A bond by its owner and its direction. */
typedef struct BondPlace {
    int i, j, offset;
} BondPlace;

/* The nodes at its ends, the owner first. */
static inline void lattice_ends(const Lattice *lattice, BondPlace bond, size_t nodes[2])
{
    const Offset *offset = &lattice->offsets[bond.offset];
    nodes[0] = lattice_node(lattice, bond.i, bond.j);
    nodes[1] = lattice_node(lattice, bond.i + offset->p, bond.j + offset->q);
}

/* What a padded array has at the other end of a bond less what it has at the owner: of displacements eta. */
static inline double lattice_apart(const Lattice *lattice, BondPlace bond, const double *array)
{
    const Offset *offset = &lattice->offsets[bond.offset];
    const double *own = array + lattice_at(lattice, bond.i, bond.j);
    return own[(ptrdiff_t)lattice->stride * offset->q + offset->p] - own[0];
}

/* The first column of a tile; tile n_tiles starts at `columns`. */
static inline size_t lattice_tile(const Lattice *lattice, size_t tile)
{
    size_t from = tile * lattice->tile_columns;
    return from < lattice->columns ? from : lattice->columns;
}

static inline size_t lattice_slot(const Lattice *lattice, BondPlace bond)
{
    size_t tile = (size_t)bond.i / lattice->tile_columns, n_offsets = (size_t)lattice->n_offsets;
    size_t from = lattice_tile(lattice, tile), count = lattice_tile(lattice, tile + 1) - from;
    return (size_t)bond.j * n_offsets * lattice->columns + from * n_offsets + (size_t)bond.offset * count +
           ((size_t)bond.i - from);
}

BondPlace lattice_slot_place(const Lattice *lattice, size_t slot);

/* Numbers of bonds: by owner, then by offset; empty slots are not counted. */
BondPlace lattice_bond_place(const Lattice *lattice, size_t number);

/* The bond from which bond numbers go on: the next one by owner, then by offset. */
BondPlace lattice_next_bond(const Lattice *lattice, BondPlace bond);

static inline size_t lattice_bonds(const Lattice *lattice)
{
    return lattice->first_bond[lattice_nodes(lattice)];
}

/* G of a bond: its surface correction, made of those of its ends; 1 without. */
double lattice_correction(const Lattice *lattice, BondPlace bond);

/* Of a bar: the modulus of a whole family without surface correction over c, h^2 sum w m with the influence.
 */
double lattice_moment(const Lattice *lattice);

/* c G w V of a whole bond, N/m^3: its force density per unit stretch. */
double lattice_coefficient(const Lattice *lattice, BondPlace bond);

#endif
