/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The arithmetic of the stages of a beam, compiled once for each instruction set and chosen when a beam is
 * made. The bits are the same for every instruction set: lanes never mix, each sum has its order
 * (plane_state.h), and nothing is contracted.
 *
 * Functions over particles do one block; those that give to nodes end with the block's patch. Functions over
 * nodes do a part of the grid. Masses, momenta and forces are per unit thickness. */
#ifndef METHODS_MPM_PLANE_KERNELS_PLANE_KERNELS_H
#define METHODS_MPM_PLANE_KERNELS_PLANE_KERNELS_H

#include "methods/cpu.h"
#include "methods/mpm/plane/plane_state.h"

/* Slots of one quantity in one row of nodes: each is eight lanes and eight zeros behind them, and there are
 * zeros before the first, so that a slot can be read shifted by up to seven lanes. All are zero but while a
 * block is at work. */
enum {
    PLANE_SLOT = 2 * PLANE_LANES,
    PLANE_SLOT_FIRST = PLANE_LANES,
    PLANE_SLOT_ROW = PLANE_SLOT_FIRST + PLANE_SLOTS * PLANE_SLOT
};

/* Numbers of one thread's slots: by row of nodes, quantity. */
static inline size_t plane_slot_numbers(const Plane *plane)
{
    return (size_t)plane_rows_reached(plane) * PLANE_GIVEN * PLANE_SLOT_ROW;
}

/* Columns and rows of the grid that particles touch. */
typedef struct PlaneBox {
    int i, j, columns, rows;
} PlaneBox;

/* What the search for K_0 works on (plane_null.c). A matrix is a band over the nodes of the box, numbered by
 * columns, of which so many columns are at hand as a particle touches: column i in place i % columns. */
typedef struct PlaneNull {
    PlaneBox box;
    int width;   /* from a node to the last of its neighbours in this numbering */
    int stride;  /* numbers of a row of the matrix: the diagonal, `width` others, zeros to fill vectors */
    int columns; /* at hand */
    double *bands[2]; /* of each component; the second NULL if supports hold both alike: then one is enough */
    double *z[2];     /* momenta, over the nodes of the box */
    bool *out[2];     /* nodes that take no part */
    int32_t *heads;   /* of each column of the grid: the first particle whose nodes begin there, a place */
    int32_t *nexts;   /* of each place: the next one; -1: there is none */
} PlaneNull;

/* The first of a column's rows, of a matrix. */
static inline double *plane_null_column(const PlaneNull *work, int which, int column)
{
    return work->bands[which] + column % work->columns * work->box.rows * work->stride;
}

struct PlaneKernels {
    /* Where the particles lie on the grid of a step: base, sx, sy, runs, and the block's nodes. They lie on
     * it. */
    void (*find)(Plane *, int block, long step);

    /* Eqs. 2, 3: m_i (with_mass) and p_i. False: there are far particles. */
    bool (*map)(Plane *, int block, double *slots, bool with_mass);

    /* Eqs. 4 to 9. Returns a place where 1 + exx + eyy <= 0, the first; -1: there is none. */
    int (*strain)(Plane *, int block);

    /* Eq. 10. False: there are far particles. */
    bool (*force)(Plane *, int block, double *slots);

    /* Both at once; *crushed as strain() returns it. */
    bool (*strain_and_force)(Plane *, int block, double *slots, int *crushed);

    /* Eqs. 14, 15. Returns the first place that lies outside of the next step's grid; -1: there is none. */
    int (*update)(Plane *, int block, long step);

    /* Nodes from the patches of all blocks; what a map gives (3: with mass, or 2), or forces. */
    void (*gather_map)(Plane *, PlaneNodes, bool with_mass);
    void (*gather_force)(Plane *, PlaneNodes);

    /* 1/m; v = p/m; p += dt f. */
    void (*invert)(Plane *, PlaneNodes);
    void (*velocities)(Plane *, PlaneNodes);
    void (*integrate)(Plane *, PlaneNodes);

    /* Adds M_C of the particles whose nodes begin in a column of the box. */
    void (*assemble)(const Plane *, const PlaneNull *, int column);

    /* Takes column `column` of nodes, at hand in `place`, out of a matrix; returns its part of p' M_C^-1 p.
     */
    double (*eliminate)(const PlaneNull *, int column, int place, int which);

    /* Adds the block's sum of |v - v0|^2 and of strain energy over its particles, lane by lane. */
    void (*energies)(const Plane *, int block, double *squares, double *strain);
};

/* Those of a level that this machine has. */
const PlaneKernels *plane_kernels(CpuLevel level);

/* Lets a simulation use these from now on: the bits stay. For tests and benchmarks. */
void plane_use_kernels(Simulation *sim, CpuLevel level);

#endif
