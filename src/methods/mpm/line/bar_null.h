/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kinetic energy that the grid cannot see at all: K_0.
 *
 * What particles have falls into K_l + (K_c - K_l) + K_0. K_l = sum p^2/(2 m_i) is what lumped masses make of
 * the grid's momenta, K_c what consistent masses would, and
 *
 *     K_0 = min over nodal velocities u of  sum over particles of m (v - sum N u)^2 / 2
 *
 * is the motion that no velocities of the grid can give to the particles. The minimum is over the nodes that
 * are free and active. Of APIC's particles it is that of v alone.
 *
 * The sums go from left to right, as far as the grid is mapped, so that they can follow the steps of
 * bar_tiles.c: the order, and with it every bit, is the same however the cells are cut. */
#ifndef PHYSICS_MPM_BAR_NULL_H
#define PHYSICS_MPM_BAR_NULL_H

#include "methods/mpm/line/bar_state.h"

/* Hats, in pairs of neighbouring cells (kernels_null.h): what is left of a range of cells when all unknowns
 * but those of its two outermost nodes have gone, NULL_X u_near + NULL_Y u_far = NULL_V and NULL_T u_far =
 * NULL_U. NULL_SUM: of the squares that are left, over the particles' mass. */
enum { NULL_X, NULL_Y, NULL_V, NULL_T, NULL_U, NULL_SUM, NULL_PARTS };

typedef struct BarTriangle {
    double part[NULL_PARTS];
} BarTriangle;

enum { NULL_WAITING = 64 }; /* eights of cells that are joined together */

typedef struct BarNullTree {
    int waiting;
    double part[NULL_PARTS][NULL_WAITING + 8]; /* 8: the largest vector may stand over */
    BarTriangle before; /* of all cells before those that wait; the right node is near */
} BarNullTree;

/* Wider shapes, particle by particle: rows of the triangle that are not yet complete, of the nodes of the
 * next cell. */
typedef struct BarNullBand {
    double weight[BAR_SUPPORT_MAX];                 /* square of the row's diagonal; 0: an empty row */
    double above[BAR_SUPPORT_MAX][BAR_SUPPORT_MAX]; /* the row right of its diagonal, over the diagonal */
    double value[BAR_SUPPORT_MAX];                  /* its right-hand side, likewise */
    double sum;                                     /* of the squares that are left */
} BarNullBand;

/* All 0: nothing is done. */
struct BarNull {
    int next; /* the first cell that is not in it */
    union {
        BarNullTree tree;
        BarNullBand band;
    };
};

/* Goes on with the cells before `end`, as far as their nodes are mapped: nodes come with cells, so a few
 * cells wait unless `end` is the end of the mesh. With hats eight at most, if `end` is a multiple of 8. */
void bar_null_add(const Bar *bar, BarNull *null, int end);

double bar_null_energy(const Bar *bar, const BarNull *null);

/* One cell, one pair, by plain rotations. The near node of the cell is the left one or the right one; that of
 * a pair is the first one's far node, the nodes which the two share having been the near ones. */
BarTriangle bar_null_cell(const Bar *bar, int cell, bool left);
BarTriangle bar_null_join(const BarTriangle *first, const BarTriangle *second);

#endif
