/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A code that is wrong in one place, or in two. For the files of this folder only.
 *
 * Only mistakes.c knows one mistake from another, by the rows of mistake_rows.inc and
 * bodies_mistake_rows.inc: the stages (stages.c) and the written sums ask for flags, or for the numbers that
 * such a code takes. */
#ifndef METHODS_MPM_MISTAKES_H
#define METHODS_MPM_MISTAKES_H

#include "methods/mpm/engine.h"

/* What such a code does. */
enum {
    WRONG_OF_START,          /* it is in the start or in a factor: it cannot come in mid-run */
    WRONG_STARTS_AT_CENTRES, /* velocities at t = 0 are those of the cells' centres */
    WRONG_STARTS_AS_HELD,    /* they are modes of a bar whose right end is held as the left one is */
    WRONG_MASS_OF_CELL,      /* a particle's mass is that of a cell */
    WRONG_BOX_WHOLE,         /* the half-width of a uGIMP box is its width, */
    WRONG_BOX_QUARTER,       /* or half of itself */
    WRONG_STAYS_IN_CELL,     /* a particle's nodes are for ever those of its first cell */
    WRONG_KEEPS_GRID,        /* the nodes' masses and momenta are added to those of the step before */
    WRONG_KEEPS_INTEGRATED,  /* MUSL: what stays of momenta is from before the second map, */
    WRONG_KEEPS_TWICE,       /* or the second map adds to it */
    WRONG_HOLDS_NEXT,        /* the nodes one further in are held, and they alone */
    WRONG_HOLDS_LATE,        /* the momenta of held nodes are taken away after the strain, */
    WRONG_HOLDS_NEVER,       /* or not at all */
    WRONG_NO_SECOND_FIX,     /* or not behind the second map */
    WRONG_HELD_YIELD,        /* forces of held nodes are not taken away */
    WRONG_HELD_PULL,         /* held nodes stay, but their acceleration is not taken away */
    WRONG_NO_SPAN,           /* de = sum N' v, without dt */
    WRONG_SLOPE_UNSCALED,    /* dN/dx is dN/ds, */
    WRONG_SLOPE_OF_STRAIN,   /* or half of it in the strain, */
    WRONG_SLOPE_OF_FORCE,    /* or in the force */
    WRONG_ONLY_NEWEST,       /* stress = E de */
    WRONG_VOLUME_STAYS,      /* the strain leaves the volume as it is, */
    WRONG_VOLUME_DIVIDED,    /* or it is V/(1 + de) */
    WRONG_VOLUME_OF_CELL,    /* the force takes the volume of a cell, */
    WRONG_VOLUME_IS_MASS,    /* or the mass, */
    WRONG_VOLUME_OF_START,   /* or the volume at t = 0, */
    WRONG_NO_VOLUME,         /* or 1, */
    WRONG_VOLUME_LATE,       /* or the volume from before the newest strain */
    WRONG_STRESS_BEFORE,     /* the force is of the stress before this step's strain, */
    WRONG_STRESS_OF_NEXT,    /* or of that of the next particle */
    WRONG_PUSHES,            /* f_int has the other sign */
    WRONG_HALF_FIRST_KICK,   /* half of the force in the first step */
    WRONG_NEW_WEIGHTS,       /* velocities with N at the new places */
    WRONG_MOVES_BY_ITSELF,   /* particles move with their own velocity, */
    WRONG_MOVES_WITH_OLD,    /* or with that of the nodes before the force, */
    WRONG_MOVES_WITH_MEAN,   /* or with the mean of before and after, */
    WRONG_MOVES_WITH_MAPPED, /* or with that of MUSL's second map */
    WRONG_AFFINE_OF_BSPLINE, /* C = 4/dx^2 sum N v d, */
    WRONG_AFFINE_UNDIVIDED,  /* or sum N v d */
    WRONG_PLAIN_KINETIC,     /* the kinetic energy is without that of C */
    WRONG_SPIN_SIGN,         /* bodies: the stress turns the other way, */
    WRONG_NO_ROTATION,       /* or not at all */
    WRONG_TENSOR_SHEAR,      /* G times half of the angle */
    WRONG_NORMAL_OF_ONE,     /* the normal of contact is that of one body */
    WRONG_START_LATE,        /* q0 is that after the first fix */
    WRONG_NO_FIRST_FIX       /* walls and contact act behind the force alone */
};
#define DOES(flag) (UINT64_C(1) << WRONG_##flag)

static inline bool mpm_does(const Mpm *mpm, int flag)
{
    return mpm->wrong >> flag & 1;
}

/* Whether the mistakes of a definition are defined for the rest of it, and together; else the status names
 * the key. A beam's are reported as a bar's. */
bool mpm_check_mistakes(const MpmDef *, Status *);

/* The flags of a code that makes this mistake, and what the definition says that it does besides. */
uint64_t mpm_wrong_with(const Mpm *, int mistake);

/* Whether there is room for what wrong codes keep from step to step: in the plane, where it would be a
 * seventh of the memory, only of a run that begins with a mistake. */
static inline bool mpm_can_keep(const Mpm *mpm)
{
    return mpm->dim == 1 || (!mpm->bodies && mpm->def.mistake != 0);
}

/* Between steps: another mistake from here on. False: one of them is made at the start. */
bool mpm_change_mistake(Mpm *, int mistake, Status *);

/* What a wrong code does in a stage of the right one. */
void mpm_write_wrongly(const Mpm *, Stage *, MpmOp);

/* The numbers that the stages of such a code take, or of any. */
static inline bool mpm_adds_to_grid(const Mpm *mpm, MpmOp map) /* to what the nodes had */
{
    return (map == OP_MAP && mpm_does(mpm, WRONG_KEEPS_GRID)) ||
           (map == OP_MAP_AGAIN && mpm_does(mpm, WRONG_KEEPS_TWICE));
}
bool mpm_holds_momentum(const Mpm *, MpmOp stage, int node); /* takes it away at this stage */
static inline bool mpm_holds_force(const Mpm *mpm, int axis, int node)
{
    return mpm->free[axis][node] == 0.0 && !mpm_does(mpm, WRONG_HELD_YIELD) &&
           !mpm_does(mpm, WRONG_HELD_PULL);
}
/* The volume behind a strain that makes it `stretch` times as large. */
static inline double mpm_volume_behind(const Mpm *mpm, double volume, double stretch)
{
    return mpm_does(mpm, WRONG_VOLUME_STAYS)     ? volume
           : mpm_does(mpm, WRONG_VOLUME_DIVIDED) ? volume / stretch
                                                 : volume * stretch;
}
double mpm_strain_span(const Mpm *);        /* dt */
double mpm_slope_scale(const Mpm *, MpmOp); /* 1/dx: of dN/dx over dN/ds, in the strain or the force */
double mpm_force_volume(const Mpm *, int particle); /* m/rho */
void mpm_force_stress(const Mpm *, int particle, double stress[MPM_STRESSES]);
double mpm_force_share(const Mpm *); /* -1, by which f_int is N' stress volume; */
double mpm_load_share(const Mpm *);  /* and 1, by which f_ext is the load */
/* N of the nodes at a particle's new place, by which it takes its velocity, and the first of these; what it
 * takes. */
void mpm_kick_weights(const Mpm *, int particle, int *base, double n[SHAPE_SUPPORT_MAX]);
double mpm_kick_at_new_place(const Mpm *, int particle);
/* The velocity of a node, or of the particle itself, by which it moves. */
double mpm_moving_velocity(const Mpm *, int axis, int particle, int node);
/* MUSL: x += dt sum N v of the nodes as the second map leaves them. */
void mpm_move_with_mapped(Mpm *);

#endif
