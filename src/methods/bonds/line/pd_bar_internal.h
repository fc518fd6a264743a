/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files of the bar by peridynamics share: model and state. Not for front ends. */
#ifndef METHODS_BONDS_LINE_PD_BAR_INTERNAL_H
#define METHODS_BONDS_LINE_PD_BAR_INTERNAL_H

#include "methods/bonds/line/pd_bar.h"
#include "methods/bonds/plane/bonds_mistakes.h"

/* The stages of a step (velocity Verlet, paper P, eqs. 9 to 11). */
enum {
    PD_BAR_HALF_KICK,
    PD_BAR_DRIFT,
    PD_BAR_MIRROR,
    PD_BAR_BONDS,
    PD_BAR_LOAD,
    PD_BAR_SECOND_KICK,
    PD_BAR_STAGES
};

enum { PD_BAR_PARTICLE, PD_BAR_BOND, PD_BAR_SETS };
enum { PD_BAR_SERIES = 8 };

/* What does not change during a run: the lattice, and the stiffness of its bonds.
 *
 * Arrays of nodes are padded by `reach` mirrored nodes on either side: node i stands at [reach + i], i from
 * -reach to n + reach - 1. The bond between k and k + m has the stiffness stiffness[m - 1][reach + k] =
 * c G w V/|xi|, force density per unit of elongation; 0 where there is no such bond. */
typedef struct PdBarLattice {
    int n, reach;
    size_t padded; /* n + 2 reach */
    double h;
    double weight[PD_BAR_REACH_MAX];    /* w at distance m = 1 .. reach */
    double influence[PD_BAR_REACH_MAX]; /* of the same: c there over that of |xi| = 0 */
    double micromodulus;                /* c, conical: of |xi| = 0 */
    double *factor;                     /* g, per padded node */
    double *stiffness[PD_BAR_REACH_MAX];
    int layer_left, layer_right; /* nodes on which the traction acts */
    double layer;
} PdBarLattice;

/* The part of the state that is no array. */
typedef struct PdBarHead {
    double work;
    double body_force, traction;
    int mistake;
} PdBarHead;

typedef struct PdBar {
    Simulation sim; /* first: a simulation is cast to its bar */
    PdBarDef def;
    PdBarLattice lattice;
    double critical_step;
    Stage stages[PD_BAR_STAGES];
    ForceWords force_words;
    Quantity series[PD_BAR_SERIES]; /* those that are not left out, and which each of them is */
    int series_entry[PD_BAR_SERIES];
    const BondsMistake *mistake; /* NULL: none */
    BondsMistake both;           /* what is wrong in two places */
    void *memory;                /* factors and stiffnesses */
    PdBarHead *head;             /* the state: head, then u (padded), v, f */
    double *u, *v, *f;
    size_t state_size;
    void *backup; /* the state when a batch of steps began */
} PdBar;

/* pd_bar_lattice.c; `lattice` is freed by free() of the returned memory. NULL: not enough. */
void *pd_bar_lattice(const PdBarDef *def, PdBarLattice *lattice);

/* A partner of a node: itself or the node whose mirror image it is. */
static inline int pd_bar_partner(const PdBarLattice *lattice, int k)
{
    return k < 0 ? -1 - k : k >= lattice->n ? 2 * lattice->n - 1 - k : k;
}

static inline size_t pd_bar_at(const PdBarLattice *lattice, int k)
{
    return (size_t)(lattice->reach + k);
}

static inline double pd_bar_position(const PdBarLattice *lattice, int k)
{
    return (k + 0.5) * lattice->h;
}

/* The bond from k to k + m, m > 0: its elongation, and its force density on k. */
static inline double pd_bar_elongation(const PdBar *bar, int k, int m)
{
    return bar->u[pd_bar_at(&bar->lattice, k + m)] - bar->u[pd_bar_at(&bar->lattice, k)];
}

static inline double pd_bar_stiffness(const PdBar *bar, int k, int m)
{
    return bar->lattice.stiffness[m - 1][pd_bar_at(&bar->lattice, k)];
}

/* pd_bar_step.c; what the bond to node i + m, m of either sign, pulls at node i, as a force density. */
double pd_bar_pull(const PdBar *bar, int i, int m);
bool pd_bar_stage(Simulation *sim, int stage, size_t first, size_t end, Status *status);
bool pd_bar_steps(Simulation *sim, long count, double *rows, long *done, Status *status);
void pd_bar_forces(PdBar *bar); /* mirrored nodes, bonds and loads of the present displacements */
double pd_bar_load(const PdBar *bar, int i); /* force density on node i of the terms at work */
ForceTerms pd_bar_terms(const PdBar *bar);

/* pd_bar_fields.c */
void pd_bar_set_fields(PdBar *bar);
void pd_bar_field(const Simulation *sim, int field, size_t first, size_t count, double *out);
void pd_bar_row(Simulation *sim, double *row);
size_t pd_bar_links(const Simulation *sim, int set, size_t index, Link *out, size_t max);

/* pd_bar_explain.c */
void pd_bar_set_stages(PdBar *bar); /* as loads are */
void pd_bar_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, int terms,
                    char *out, size_t size);

#endif
