/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A bar as it is computed by a code that is wrong in one place. For the files of this folder only.
 *
 * A mistake is a row of mistake_rows.inc: its id, one sentence, the stage that it is in with the equation as
 * it is wrongly written, and what it does instead. Nobody else knows one mistake from another: the stages
 * (stages.c) and the written sums ask for the numbers that this code takes. All of them are of lumped masses
 * on a bar of one material; those that need an algorithm, a shape or a transfer say so (ONLY_...). */
#ifndef METHODS_MPM_MISTAKES_H
#define METHODS_MPM_MISTAKES_H

#include "methods/mpm/engine.h"

/* When the momenta of held nodes are taken away. */
typedef enum BarHolds { HOLDS_BEFORE_STRAIN, HOLDS_AFTER_STRAIN, HOLDS_NEVER } BarHolds;

/* By which velocity particles move. */
typedef enum BarMoves {
    MOVES_WITH_NODES,
    MOVES_WITH_OLD_NODES,
    MOVES_WITH_MEAN,   /* of before and after the force */
    MOVES_WITH_MAPPED, /* MUSL's second map */
    MOVES_BY_ITSELF
} BarMoves;

/* What else such a code does. */
enum {
    WRONG_OF_START = 1 << 0,          /* it is in the start or in a factor: it cannot come in mid-run */
    WRONG_STARTS_AT_CENTRES = 1 << 1, /* velocities at t = 0 are those of the cells' centres */
    WRONG_STARTS_AS_HELD = 1 << 2,    /* they are modes of a bar whose right end is held as the left one is */
    WRONG_MASS_OF_CELL = 1 << 3,      /* a particle's mass is that of a cell */
    WRONG_KEEPS_GRID = 1 << 4,      /* the nodes' masses and momenta are added to those of the step before */
    WRONG_HOLDS_NEXT = 1 << 5,      /* the nodes one further in are held, and they alone */
    WRONG_HELD_YIELD = 1 << 6,      /* forces of held nodes are not taken away */
    WRONG_NO_SPAN = 1 << 7,         /* de = sum N' v, without dt */
    WRONG_ONLY_NEWEST = 1 << 8,     /* stress = E de */
    WRONG_STRESS_BEFORE = 1 << 9,   /* the force is of the stress before this step's strain */
    WRONG_PUSHES = 1 << 10,         /* f_int has the other sign */
    WRONG_NEW_WEIGHTS = 1 << 11,    /* velocities with N at the new places */
    WRONG_HELD_PULL = 1 << 12,      /* held nodes stay, but their acceleration is not taken away */
    WRONG_VOLUME_LATE = 1 << 13,    /* the force takes the volume from before the newest strain */
    WRONG_STRESS_OF_NEXT = 1 << 14, /* the force takes the stress of the next particle */
    WRONG_NO_SECOND_FIX = 1 << 15,
    WRONG_PLAIN_KINETIC = 1 << 16,    /* the kinetic energy is without that of C */
    WRONG_STAYS_IN_CELL = 1 << 17,    /* a particle's nodes are for ever those of its first cell */
    WRONG_KEEPS_INTEGRATED = 1 << 18, /* MUSL: what stays of momenta is from before the second map, */
    WRONG_KEEPS_TWICE = 1 << 19       /* or the second map adds to it */
};

/* What a mistake is defined for. */
enum {
    ONLY_USF = 1 << 0,
    ONLY_MUSL = 1 << 1,
    ONLY_HAT = 1 << 2,
    ONLY_GIMP = 1 << 3,
    ONLY_FLIP = 1 << 4, /* and shares of PIC */
    ONLY_APIC = 1 << 5,
    ONLY_LINE = 1 << 6 /* not in the plane */
};

typedef struct BarMistake {
    const char *id, *sentence;
    MpmOp stage;
    /* the lines of the stage as this code has it, what differs between marks (STAGE_WRONG in method.h) */
    const char *equation;
    MpmOp also; /* another stage that has it too, with its line; equation NULL: none */
    const char *also_equation;

    /* What this code does; what is not said it does as it should be done. */
    unsigned does, only; /* WRONG_..., ONLY_... */
    BarHolds holds;
    double (*thinned)(double volume,
                      double stretch); /* the volume m/rho that eq. 8 leaves; NULL: V (1 + de) */
    double (*volume)(const Mpm *, int particle, double); /* that the force takes, of m/rho; NULL: that */
    double first_kick; /* of the first step's force the share that is taken; 0: all */
    BarMoves moves;
    double slope_of_strain, slope_of_force; /* dN/dx is dN/ds times that; 0: times 1/dx */
    double box;                             /* a uGIMP box over the right one; 0: 1 */
    double (*affine)(const Mpm *, const MpmWeights *, int particle); /* C; NULL: that of APIC */
} BarMistake;

/* The row of a bar's mistake; NULL: it makes none. */
const BarMistake *mpm_mistake(const Mpm *);
const BarMistake *mpm_mistake_if(const Mpm *,
                                 int mistake); /* if that is its one; what it does besides is in it */
bool mpm_does(const Mpm *, unsigned wrong);    /* whether its code does that (WRONG_...) */

/* Whether there is room for what wrong codes keep from step to step: in the plane, where it would be a
 * seventh of the memory, only of a run that begins with a mistake. */
static inline bool mpm_can_keep(const Mpm *mpm)
{
    return mpm->dim == 1 || (!mpm->bodies && mpm->def.mistake != 0);
}

/* Whether these are what mistakes are defined for; else the status names the key. A beam's are reported as a
 * bar's.
 */
bool bar_mistake_check(const MpmDef *, Status *);

/* Takes up what the definition says that is made in two places. False: there is no memory. */
bool mpm_take_both(Mpm *, const MpmDef *, Status *);

/* Between steps: another mistake from here on. False: one of them is made at the start. */
bool mpm_change_mistake(Mpm *, int mistake, bool concealed, Status *);

/* What a wrong code does in a stage of the right one. */
void mpm_write_wrongly(const Mpm *, Stage *, MpmOp);

/* The numbers that the stages of such a code take, or of any. */
BarHolds mpm_holds(const Mpm *);
bool mpm_holds_momentum(const Mpm *, MpmOp stage, int node); /* takes it away at this stage */
static inline bool mpm_holds_force(const Mpm *mpm, int axis, int node)
{
    return mpm->free[axis][node] == 0.0 && !mpm_does(mpm, WRONG_HELD_YIELD | WRONG_HELD_PULL);
}
double mpm_strain_span(const Mpm *);        /* dt */
double mpm_slope_scale(const Mpm *, MpmOp); /* 1/dx: of dN/dx over dN/ds, in the strain or the force */
double mpm_force_volume(const Mpm *, int particle); /* m/rho */
void mpm_force_stress(const Mpm *, int particle, double stress[MPM_STRESSES]);
double mpm_force_share(const Mpm *); /* -1, by which f_int is N' stress volume; */
double mpm_load_share(const Mpm *);  /* and 1, by which f_ext is the load */
BarMoves mpm_moves_by(const Mpm *);
/* N of the nodes by which a particle takes its velocity, and the first of these; what it takes. */
void mpm_kick_weights(const Mpm *, int particle, int *base, double n[SHAPE_SUPPORT_MAX]);
double mpm_kick_at_new_place(const Mpm *, int particle);
/* The velocity of a node, or of the particle itself, by which it moves. */
double mpm_moving_velocity(const Mpm *, int axis, int particle, int node);
/* MUSL: x += dt sum N v of the nodes as the second map leaves them. */
void mpm_move_with_mapped(Mpm *);

#endif
