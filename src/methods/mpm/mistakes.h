/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A code that is wrong in one place, or in two. For the files of this folder only.
 *
 * Only mistakes.c knows one mistake from another, by the rows of mistake_rows.inc and
 * bodies_mistake_rows.inc: the stages (stages.c) and the written sums ask for flags, or for the numbers that
 * such a code takes. */
#ifndef METHODS_MPM_MISTAKES_H
#define METHODS_MPM_MISTAKES_H

#include "methods/mpm/engine.h"

/* What such a code does: the rows that have a flag say it in words. One of the start is in the start or in a
 * factor and cannot come in mid-run. */
#define WRONGS                                                                                               \
    WRONG_OF_START, WRONG_STARTS_AT_CENTRES, WRONG_STARTS_AS_HELD, WRONG_MASS_OF_CELL, WRONG_BOX_WHOLE,      \
        WRONG_BOX_QUARTER, WRONG_STAYS_IN_CELL, WRONG_KEEPS_GRID, WRONG_KEEPS_INTEGRATED, WRONG_KEEPS_TWICE, \
        WRONG_HOLDS_NEXT, WRONG_HOLDS_LATE, WRONG_HOLDS_NEVER, WRONG_NO_SECOND_FIX, WRONG_HELD_YIELD,        \
        WRONG_HELD_PULL, WRONG_NO_SPAN, WRONG_SLOPE_UNSCALED, WRONG_SLOPE_OF_STRAIN, WRONG_SLOPE_OF_FORCE,   \
        WRONG_ONLY_NEWEST, WRONG_VOLUME_STAYS, WRONG_VOLUME_DIVIDED, WRONG_VOLUME_OF_CELL,                   \
        WRONG_VOLUME_IS_MASS, WRONG_VOLUME_OF_START, WRONG_NO_VOLUME, WRONG_VOLUME_LATE,                     \
        WRONG_STRESS_BEFORE, WRONG_STRESS_OF_NEXT, WRONG_PUSHES, WRONG_HALF_FIRST_KICK, WRONG_NEW_WEIGHTS,   \
        WRONG_MOVES_BY_ITSELF, WRONG_MOVES_WITH_OLD, WRONG_MOVES_WITH_MEAN, WRONG_MOVES_WITH_MAPPED,         \
        WRONG_AFFINE_OF_BSPLINE, WRONG_AFFINE_UNDIVIDED, WRONG_PLAIN_KINETIC, WRONG_SPIN_SIGN,               \
        WRONG_NO_ROTATION, WRONG_TENSOR_SHEAR, WRONG_NORMAL_OF_ONE, WRONG_START_LATE, WRONG_NO_FIRST_FIX
enum { WRONGS };
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
