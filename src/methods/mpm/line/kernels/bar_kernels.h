/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The arithmetic of the stages, compiled once for each instruction set and chosen when a bar is made.
 *
 * Each function does a range of cells, or the nodes that come with it: node i goes with cell i, the last
 * nodes with the last cell. The bits are the same for every instruction set and for every way of cutting the
 * cells into ranges: each sum has its order, and nothing is contracted. */
#ifndef METHODS_MPM_LINE_KERNELS_BAR_KERNELS_H
#define METHODS_MPM_LINE_KERNELS_BAR_KERNELS_H

#include "methods/cpu.h"
#include "methods/mpm/line/bar_state.h"

struct BarKernels {
    /* CPDI: the particles' domains for this step, before map */
    void (*halve_domains)(Bar *bar, int first, int end);

    /* CPDI: a particle of these cells that would touch more nodes than a cell has; -1: none */
    int (*too_long)(const Bar *bar, int first, int end);

    /* eqs. 2, 3: mass and momentum of the nodes from the particles */
    void (*map)(Bar *bar, int first, int end);

    /* The consistent mass matrix's couplings of different nodes; after map */
    void (*couple)(Bar *bar, int first, int end);

    /* eq. 4 with lumped masses */
    void (*velocities)(Bar *bar, int first, int end);

    /* The factors of the blended mass matrix, of all nodes; after couple. x <- M^-1 x, over n_nodes */
    void (*factor)(Bar *bar);
    void (*solve)(const Bar *bar, double *x);

    /* FMPM's nodal velocities of momenta x, in their place; after couple */
    void (*series)(Bar *bar, double *x);

    /* eqs. 5, 7, 8, 9. Returns a particle for which 1 + de <= 0 (all others are done), or -1 */
    int (*strain)(Bar *bar, int first, int end);

    /* eqs. 10, 11 */
    void (*force)(Bar *bar, int first, int end);

    /* eqs. 12, 13 without supports, and what eqs. 14, 15 need of a node; adds to the work of the load */
    void (*integrate)(Bar *bar, int first, int end);

    /* eqs. 14, 15: velocities, and where particles go (moved) */
    void (*update)(Bar *bar, int first, int end);

    /* Lets the particles of a run of cells with P particles each, the first of which is `particle`, take
     * their new places; false: not all stay in order in their cells, and nothing was done. NULL without
     * fast/ */
    bool (*settle)(Bar *bar, int cells, int particle);

    /* Adds the places [first, end) of every slot to the sums, first being a multiple of BAR_LANES */
    void (*particle_sums)(const Bar *bar, int first, int end, BarSums *sums);

    /* The same of p^2 / m over nodes [first, end) */
    void (*node_sums)(const Bar *bar, int first, int end, double *lanes);
};

/* Those of a level that this machine has. */
const BarKernels *bar_kernels(CpuLevel level);

/* Lets a simulation use these from now on: the bits stay. For tests and benchmarks. */
void bar_use_kernels(Simulation *sim, CpuLevel level);

#endif
