/* What the files of the bar by peridynamics share: model and state. Not for front ends. */
#ifndef PHYSICS_PD_ROD_INTERNAL_H
#define PHYSICS_PD_ROD_INTERNAL_H

#include "physics/pd_bar/rod.h"

/* The stages of a step (velocity Verlet, paper P, eqs. 9 to 11). */
enum { ROD_HALF_KICK, ROD_DRIFT, ROD_MIRROR, ROD_BONDS, ROD_LOAD, ROD_SECOND_KICK, ROD_STAGES };

enum { ROD_PARTICLE, ROD_BOND, ROD_SETS };
enum { ROD_SERIES = 6 };

/* What does not change during a run: the lattice, and the stiffness of its bonds.
 *
 * Arrays of nodes are padded by `reach` mirrored nodes on either side: node i stands at [reach + i], i from
 * -reach to n + reach - 1. The bond between k and k + m has the stiffness stiffness[m - 1][reach + k] =
 * c G w V/|xi|, force density per unit of elongation; 0 where there is no such bond. */
typedef struct RodLattice {
    int n, reach;
    size_t padded; /* n + 2 reach */
    double h;
    double weight[ROD_REACH_MAX]; /* w at distance m = 1 .. reach */
    double *factor;               /* g, per padded node */
    double *stiffness[ROD_REACH_MAX];
    int layer_left, layer_right; /* nodes on which the traction acts */
    double layer;
} RodLattice;

/* The part of the state that is no array. */
typedef struct RodHead {
    double work;
    double body_force, traction;
} RodHead;

typedef struct Rod {
    Simulation sim; /* first: a simulation is cast to its rod */
    RodDef def;
    RodLattice lattice;
    double critical_step;
    void *memory;  /* factors and stiffnesses */
    RodHead *head; /* the state: head, then u (padded), v, f */
    double *u, *v, *f;
    size_t state_size;
    void *sound; /* the state at the last whole step that was sound */
} Rod;

/* rod_lattice.c; `lattice` is freed by free() of the returned memory. NULL: not enough. */
void *rod_lattice(const RodDef *def, RodLattice *lattice);

/* A partner of a node: itself or the node whose mirror image it is. */
static inline int rod_partner(const RodLattice *lattice, int k)
{
    return k < 0 ? -1 - k : k >= lattice->n ? 2 * lattice->n - 1 - k : k;
}

static inline size_t rod_at(const RodLattice *lattice, int k)
{
    return (size_t)(lattice->reach + k);
}

static inline double rod_position(const RodLattice *lattice, int k)
{
    return (k + 0.5) * lattice->h;
}

/* The bond from k to k + m, m > 0: its elongation, and its force density on k. */
static inline double rod_elongation(const Rod *rod, int k, int m)
{
    return rod->u[rod_at(&rod->lattice, k + m)] - rod->u[rod_at(&rod->lattice, k)];
}

static inline double rod_stiffness(const Rod *rod, int k, int m)
{
    return rod->lattice.stiffness[m - 1][rod_at(&rod->lattice, k)];
}

/* rod_step.c */
bool rod_stage(Simulation *sim, int stage, size_t first, size_t end, Status *status);
bool rod_steps(Simulation *sim, long count, double *rows, long *done, Status *status);
void rod_forces(Rod *rod);              /* mirrored nodes, bonds and loads of the present displacements */
double rod_load(const Rod *rod, int i); /* force density of the loads on node i */

/* rod_fields.c */
void rod_set_fields(Rod *rod);
void rod_field(const Simulation *sim, int field, size_t first, size_t count, double *out);
void rod_row(Simulation *sim, double *row);
size_t rod_links(const Simulation *sim, int set, size_t index, Link *out, size_t max);

/* rod_explain.c */
extern const Stage rod_stage_table[ROD_STAGES];
void rod_explain(const Simulation *sim, int stage, int set, size_t index, const void *before, int terms,
                 char *out, size_t size);

#endif
