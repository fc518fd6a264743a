/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the engine asks of bodies, and what front ends read of them: bodies_*.c. */
#ifndef METHODS_MPM_BODIES_INNER_H
#define METHODS_MPM_BODIES_INNER_H

#include "methods/mpm/bodies.h"
#include "methods/mpm/engine.h"

enum {
    BODIES_PADDING = 4,     /* empty cells all around the box */
    BODIES_CHUNK_CELLS = 4, /* rows of cells whose particles are worked on together */
    BODY_COLUMNS = 5,       /* of the series, for each body; then, to ask for: */
    BODY_TOUCHING = BODY_COLUMNS
};

/* The constants of some bodies. */
typedef struct Bodies {
    BodiesDef def;
    int n_fields;      /* 1, or one for each body */
    int columns, rows; /* cells of the box */
    double shear;      /* G */
    double lambda;     /* of Lame */
    double volume;     /* of a particle at t = 0 */
    int first[BODIES_MAX + 1];
    char column_names[BODIES_MAX][BODY_TOUCHING + 1][BODY_NAME_MAX + 8];
    char column_meanings[BODIES_MAX][BODY_TOUCHING + 1][BODY_NAME_MAX + 64];
} Bodies;

static inline bool bodies_are_neo(const Mpm *mpm)
{
    return mpm->bodies && mpm->bodies->def.law == LAW_NEO_HOOKEAN;
}

/* Whether the code makes a mistake of bodies_mistakes.c. */
static inline bool bodies_does(const Bodies *bodies, int mistake)
{
    return bodies->def.mistake == mistake || bodies->def.mistake_beside == mistake;
}
bool bodies_mistake_check(const BodiesDef *, Status *);
void bodies_write_wrongly(const Mpm *, MpmOp, Stage *);

/* The velocity of a node by which a particle is strained: its own where the node is light. */
static inline double bodies_velocity_for(const Mpm *mpm, int axis, int node, int p)
{
    return mpm->inverse[node] > 0.0 ? mpm->velocity[axis][node] : mpm->v[axis][p];
}

/* The body that a particle belongs to. */
int bodies_body_of(const Mpm *, int particle);

/* Whether the place lies in the body: an open set. */
bool bodies_hold(const BodyDef *, double x, double y);

/* What both `fix` of a step did, behind the second one; and whether neighbours have parted, behind the step.
 */
void bodies_note_contact(Mpm *);
void bodies_note_tear(Mpm *);
void bodies_note_spin(Mpm *); /* and the sums over steps of a disc that spins alone */
/* Walls and contact on nodes [first, end) of the grid. */
void bodies_fix(Mpm *, MpmOp, int first, int end);

/* What contact does at a node of the grid between the fields a and b, whose momenta there are q. */
typedef struct Meeting {
    double normal[2];  /* common, from a to b; 0 0: there is none */
    double distance;   /* of the mean places along it, cells */
    double approach;   /* vn: relative to the common velocity, before; > 0: a pushes */
    double impulse[2]; /* taken from a, given to b */
    double lost;       /* energy that friction takes */
} Meeting;
Meeting bodies_meet(const Mpm *, int node, int a, int b, const double q[2][2]);

/* Whether a wall of the box acts on a node. */
bool bodies_at_wall(const Mpm *, int node);

void bodies_set_series(Mpm *);
void bodies_write_row(const Mpm *, double *row);
double bodies_energy(const Mpm *); /* kinetic + strain */
double bodies_strain_at(const Mpm *, int particle);

#endif
