/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A beam or a bar as it is computed by a code that is wrong in one place, or in two. For the folders of bonds
 * only.
 *
 * A mistake is a row of bonds_mistake_rows.inc: its id, one sentence, the stage that it is in with the
 * equation as it is wrongly written, and what it does instead. Nobody else knows one mistake from another:
 * the lattice, the stages and the written sums ask the row for what this code takes. All of them are of
 * whole bonds of one stiffness, undamped; those of the half kicks of velocity Verlet alone.
 *
 * Beams with a mistake do their steps stage by stage, bond by bond. The time step, and its limit, are those
 * of the right code. */
#ifndef METHODS_BONDS_PLANE_BONDS_MISTAKES_H
#define METHODS_BONDS_PLANE_BONDS_MISTAKES_H

#include "methods/bonds/plane/bonds_internal.h"

enum { MISTAKE_LINES = 3 };

/* A line of a stage as a wrong code has it, what differs between marks (STAGE_WRONG in method.h). */
typedef struct MistakeLine {
    int stage;
    const char *equation; /* NULL: no further line */
} MistakeLine;

/* What else such a code does. */
enum {
    BONDS_WRONG_OF_START = 1 << 0, /* it is in the start, the family or a factor: it cannot come in mid-run */
    BONDS_WRONG_WITHIN_HORIZON = 1 << 1, /* the family lies nearer than delta, not as far as that */
    BONDS_WRONG_NO_VOLUME_FACTOR = 1 << 2,
    BONDS_WRONG_NO_SURFACE_FACTOR = 1 << 3,
    BONDS_WRONG_STARTS_BENT = 1 << 4, /* the shape at t = 0 is that without supports */
    BONDS_WRONG_ALONG_REST = 1 << 5,  /* a bond pulls along xi */
    BONDS_WRONG_KICKS_LATE =
        1 << 6, /* u += dt v, then v += dt a by the force of the old place; no half kicks */
    BONDS_WRONG_KICKS_BEFORE = 1 << 7,    /* the second half kick is missing */
    BONDS_WRONG_DRIFTS_TWICE = 1 << 8,    /* u += 2 dt v */
    BONDS_WRONG_HALF_HORIZON = 1 << 9,    /* the family lies within delta/2; c and w are those of delta */
    BONDS_WRONG_FORCE_STAYS = 1 << 10,    /* f is never set to zero */
    BONDS_WRONG_NO_FIRST_FORCE = 1 << 11, /* the first kick of the run is missing */
    BONDS_WRONG_IN_PLANE = 1 << 12,       /* on a line it is nothing, or the same as another one */
    BONDS_WRONG_BY_LIST = 1 << 13,        /* it asks for the place of a partner in its node's list */
    BONDS_WRONG_WEIGHT_BY_THICKNESS = 1 << 14, /* the body force is times the thickness */
    BONDS_WRONG_HOLDS_EDGES = 1 << 15,         /* supports hold all rows of an end */
    BONDS_WRONG_HOLDS_BOTH = 1 << 16           /* the right support holds ux too */
};

/* An end of a bond, as its share of the pull may depend on it. */
typedef struct BondEnd {
    bool left;              /* the left one, of upright bonds the lower */
    bool owner;             /* the earlier one, nodes numbered by rows from below */
    double rest, now;       /* the bond's lengths, m */
    bool to_first, to_last; /* the partner is the first, the last one of this end, nodes numbered by rows */
} BondEnd;

typedef struct BondsMistake {
    const char *id, *sentence;
    MistakeLine lines[MISTAKE_LINES];

    /* What this code does; what is not said it does as it should be done. */
    unsigned does;                           /* BONDS_WRONG_... */
    double (*micromodulus)(const BeamDef *); /* c */
    double (*share)(const BondEnd *);        /* of a bond's pull that an end gets */
} BondsMistake;

/* The one that is shown; NULL: none. Whether the code does that (BONDS_WRONG_...), there or besides. */
const BondsMistake *bonds_mistake(const Beam *);
bool bonds_does(const Beam *, unsigned wrong);
bool bonds_does_by(const BeamDef *, unsigned wrong);

/* c, which is `right` by the right code. */
double bonds_micromodulus(const BeamDef *, double right);

/* The share of dt of the first or second kick of a step, by the stepping and what such a code does. */
double bonds_kick_share(const Beam *, bool second, long step);

/* Whether these are what mistakes are defined for; else the status names the key. */
bool bonds_check_mistake(const BeamDef *, Status *);

/* Between steps: another mistake from here on. False: one of them is made at the start, or it is none. */
bool bonds_change_mistake(Beam *, double mistake, Status *);

/* Adds to fx[q], fy[q] what the bonds of row j give (beam_bonds_of_row()), and returns their energy, J.
 * Nothing breaks; what is not a number is logged as unstable. */
void bonds_forces_of_row(Beam *, int j, double *const *fx, double *const *fy, BondLog *, double *energy);

#endif
