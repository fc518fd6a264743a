/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A bar as it is computed by a code that is wrong in one place. For the files of this folder only.
 *
 * A mistake is a row of bar_mistake_rows.inc: its id, one sentence, the stage that it is in with the equation
 * as it is wrongly written, and what it does instead. Nobody else knows one mistake from another: the stages
 * below and the written sums ask the row for the numbers that this code takes. All of them are of USF, hats,
 * FLIP and lumped masses on a bar of one material.
 *
 * Bars with a mistake do the stages of bar_wrong_stages.c, one after the other over the whole bar. They are
 * written for reading; with a row that says nothing they give what the kernels give, but for rounding. */
#ifndef METHODS_MPM_LINE_BAR_MISTAKES_H
#define METHODS_MPM_LINE_BAR_MISTAKES_H

#include "methods/mpm/line/bar_state.h"

/* When the momenta of held nodes are taken away. */
typedef enum BarHolds { HOLDS_BEFORE_STRAIN, HOLDS_AFTER_STRAIN, HOLDS_NEVER } BarHolds;

/* By which velocity particles move. */
typedef enum BarMoves { MOVES_WITH_NODES, MOVES_WITH_OLD_NODES, MOVES_BY_ITSELF } BarMoves;

/* What else such a code does. */
enum {
    BAR_WRONG_OF_START = 1 << 0,          /* it is in the start or in a factor: it cannot come in mid-run */
    BAR_WRONG_STARTS_AT_CENTRES = 1 << 1, /* velocities at t = 0 are those of the cells' centres */
    BAR_WRONG_STARTS_AS_HELD =
        1 << 2,                      /* they are modes of a bar whose right end is held as the left one is */
    BAR_WRONG_MASS_OF_CELL = 1 << 3, /* a particle's mass is that of a cell */
    BAR_WRONG_KEEPS_GRID = 1 << 4,   /* the nodes' masses and momenta are added to those of the step before */
    BAR_WRONG_HOLDS_NEXT = 1 << 5,   /* the nodes one further in are held */
    BAR_WRONG_HELD_YIELD = 1 << 6,   /* forces of held nodes are not taken away */
    BAR_WRONG_NO_SPAN = 1 << 7,      /* de = sum N' v, without dt */
    BAR_WRONG_NO_SPACING = 1 << 8,   /* dN/ds in place of dN/dx */
    BAR_WRONG_ONLY_NEWEST = 1 << 9,  /* stress = E de */
    BAR_WRONG_STRESS_BEFORE = 1 << 10, /* the force is of the stress before this step's strain */
    BAR_WRONG_PUSHES = 1 << 11,        /* f_int has the other sign */
    BAR_WRONG_NEW_WEIGHTS = 1 << 12,   /* velocities with N at the new places */
    BAR_WRONG_OF_GRID = 1 << 13        /* v = sum N v_i */
};

typedef struct BarMistake {
    const char *id, *sentence;
    BarOp stage;
    /* the lines of the stage as this code has it, what differs between marks (STAGE_WRONG in method.h) */
    const char *equation, *ascii;
    BarOp also; /* another stage that has it too, with its line; equation NULL: none */
    const char *also_equation, *also_ascii;

    /* What this code does; what is not said it does as it should be done. */
    unsigned does; /* BAR_WRONG_... */
    BarHolds holds;
    double (*thinned)(double volume,
                      double stretch); /* the volume m/rho that eq. 8 leaves; NULL: V (1 + de) */
    double (*volume)(const Bar *, int particle, double); /* that the force takes, of m/rho; NULL: that */
    double first_kick; /* of the first step's force the share that is taken; 0: all */
    BarMoves moves;
    MpmAlgorithm algorithm; /* USF where nothing is said */
} BarMistake;

/* The row of a bar's mistake; NULL: it makes none. */
const BarMistake *bar_mistake(const Bar *);
const BarMistake *bar_mistake_if(const Bar *,
                                 int mistake); /* if that is its one; what it does besides is in it */
bool bar_does(const Bar *, unsigned wrong);    /* whether its code does that (BAR_WRONG_...) */

/* What a code does that makes two of them. False: they are one and the same thing done otherwise. */
bool bar_mistakes_join(int one, int other, BarMistake *out);

/* Whether these are what mistakes are defined for; else the status names the key. */
bool bar_check_mistake(const BarDef *, Status *);

/* The work of a stage on cells [first, end), as bar_do(). */
bool bar_do_wrongly(Bar *, BarOp, int first, int end, Status *);

/* The numbers that the stages of such a code take, or of any bar. */
bool bar_holds_momentum(const Bar *, BarOp stage, int node); /* takes it away at this stage */
bool bar_holds_force(const Bar *, int node);
double bar_strain_span(const Bar *);                /* dt */
double bar_slope_scale(const Bar *);                /* 1/dx: of dN/dx over dN/ds */
double bar_force_volume(const Bar *, int particle); /* m/rho */
double bar_force_stress(const Bar *, int particle);
double bar_force_share(const Bar *); /* -1, by which f_int is N' stress volume; */
double bar_load_share(const Bar *);  /* and 1, by which f_ext is the load */
/* N of the nodes by which a particle takes its velocity, and the cell that they belong to. */
void bar_kick_weights(const Bar *, int particle, int *cell, double n[2]);
/* The velocity of a node, or of the particle itself, by which it moves. */
double bar_moving_velocity(const Bar *, int particle, int node);

#endif
