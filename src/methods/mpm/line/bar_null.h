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
#ifndef METHODS_MPM_LINE_BAR_NULL_H
#define METHODS_MPM_LINE_BAR_NULL_H

#include "methods/mpm/line/bar_state.h"

/* All 0: nothing is done. */
struct BarNull {
    int next; /* the first cell that is not in it */
    /* rows of the triangle that are not yet complete, of the nodes of the next cell */
    double weight[BAR_SUPPORT_MAX];                 /* square of the row's diagonal; 0: an empty row */
    double above[BAR_SUPPORT_MAX][BAR_SUPPORT_MAX]; /* the row right of its diagonal, over the diagonal */
    double value[BAR_SUPPORT_MAX];                  /* its right-hand side, likewise */
    double sum;                                     /* of the squares that are left */
};

/* Goes on with the cells before `end`, as far as their nodes are mapped: nodes come with cells, so a few
 * cells wait unless `end` is the end of the mesh. */
void bar_null_add(const Bar *bar, BarNull *null, int end);

double bar_null_energy(const Bar *bar, const BarNull *null);

#endif
