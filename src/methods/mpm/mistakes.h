/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A bar as it is computed by a code that is wrong in one place. For the files of this folder only.
 *
 * A mistake is a row of mistake_rows.inc: its id, one sentence, the stage that it is in with the equation as
 * it is wrongly written, and what it does instead. Nobody else knows one mistake from another: the stages
 * (stages.c) and the written sums ask for the numbers that this code takes. All of them are of USF, hats,
 * FLIP and lumped masses on a bar of one material. */
#ifndef METHODS_MPM_MISTAKES_H
#define METHODS_MPM_MISTAKES_H

#include "methods/mpm/engine.h"

/* When the momenta of held nodes are taken away. */
typedef enum BarHolds { HOLDS_BEFORE_STRAIN, HOLDS_AFTER_STRAIN, HOLDS_NEVER } BarHolds;

/* By which velocity particles move. */
typedef enum BarMoves { MOVES_WITH_NODES, MOVES_WITH_OLD_NODES, MOVES_BY_ITSELF } BarMoves;

/* What else such a code does. */
enum {
    WRONG_OF_START = 1 << 0,          /* it is in the start or in a factor: it cannot come in mid-run */
    WRONG_STARTS_AT_CENTRES = 1 << 1, /* velocities at t = 0 are those of the cells' centres */
    WRONG_STARTS_AS_HELD = 1 << 2,    /* they are modes of a bar whose right end is held as the left one is */
    WRONG_MASS_OF_CELL = 1 << 3,      /* a particle's mass is that of a cell */
    WRONG_KEEPS_GRID = 1 << 4,     /* the nodes' masses and momenta are added to those of the step before */
    WRONG_HOLDS_NEXT = 1 << 5,     /* the nodes one further in are held */
    WRONG_HELD_YIELD = 1 << 6,     /* forces of held nodes are not taken away */
    WRONG_NO_SPAN = 1 << 7,        /* de = sum N' v, without dt */
    WRONG_NO_SPACING = 1 << 8,     /* dN/ds in place of dN/dx */
    WRONG_ONLY_NEWEST = 1 << 9,    /* stress = E de */
    WRONG_STRESS_BEFORE = 1 << 10, /* the force is of the stress before this step's strain */
    WRONG_PUSHES = 1 << 11,        /* f_int has the other sign */
    WRONG_NEW_WEIGHTS = 1 << 12,   /* velocities with N at the new places */
    WRONG_OF_GRID = 1 << 13        /* v = sum N v_i */
};

typedef struct BarMistake {
    const char *id, *sentence;
    MpmOp stage;
    /* the lines of the stage as this code has it, what differs between marks (STAGE_WRONG in method.h) */
    const char *equation, *ascii;
    MpmOp also; /* another stage that has it too, with its line; equation NULL: none */
    const char *also_equation, *also_ascii;

    /* What this code does; what is not said it does as it should be done. */
    unsigned does; /* WRONG_... */
    BarHolds holds;
    double (*thinned)(double volume,
                      double stretch); /* the volume m/rho that eq. 8 leaves; NULL: V (1 + de) */
    double (*volume)(const Mpm *, int particle, double); /* that the force takes, of m/rho; NULL: that */
    double first_kick; /* of the first step's force the share that is taken; 0: all */
    BarMoves moves;
    MpmAlgorithm algorithm; /* USF where nothing is said */
} BarMistake;

/* The row of a bar's mistake; NULL: it makes none. */
const BarMistake *mpm_mistake(const Mpm *);
const BarMistake *mpm_mistake_if(const Mpm *,
                                 int mistake); /* if that is its one; what it does besides is in it */
bool mpm_does(const Mpm *, unsigned wrong);    /* whether its code does that (WRONG_...) */

/* What a code does that makes two of them. False: they are one and the same thing done otherwise. */
bool bar_mistakes_join(int one, int other, BarMistake *out);

/* Whether these are what mistakes are defined for; else the status names the key. */
bool bar_mistake_check(const BarDef *, Status *);

/* The numbers that the stages of such a code take, or of any. */
BarHolds mpm_holds(const Mpm *);
bool mpm_holds_momentum(const Mpm *, MpmOp stage, int node); /* takes it away at this stage */
static inline bool mpm_holds_force(const Mpm *mpm, int axis, int node)
{
    return mpm->free[axis][node] == 0.0 && !mpm_does(mpm, WRONG_HELD_YIELD);
}
double mpm_strain_span(const Mpm *);                /* dt */
double mpm_slope_scale(const Mpm *);                /* 1/dx: of dN/dx over dN/ds */
double mpm_force_volume(const Mpm *, int particle); /* m/rho */
double mpm_force_stress(const Mpm *, int particle);
double mpm_force_share(const Mpm *); /* -1, by which f_int is N' stress volume; */
double mpm_load_share(const Mpm *);  /* and 1, by which f_ext is the load */
BarMoves mpm_moves_by(const Mpm *);
/* N of the nodes by which a particle takes its velocity, and the first of these; what it takes. */
void mpm_kick_weights(const Mpm *, int particle, int *base, double n[2]);
double mpm_kick_at_new_place(const Mpm *, int particle);
/* The velocity of a node, or of the particle itself, by which it moves. */
double mpm_moving_velocity(const Mpm *, int particle, int node);

#endif
