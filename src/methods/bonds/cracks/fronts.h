/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The cracks of a plate: what grows from the ends of its cuts, how far, how fast, and where it branches.
 *
 * Every end of a cut inside the plate is a front. A node is cracked as crack.h has it (damage above
 * CRACK_DAMAGE, not protected). It belongs to a front when it lies within a horizon of the front's end or of
 * a node of that front, to the nearest of these; what cracks by itself elsewhere is of none, until a crack
 * reaches it, and so is a node beside the cut, behind its end and within a horizon of its line, whose bonds
 * the cut itself has parted. The front grows along the axis, x or y, along which its cracked nodes reach
 * farther from its end, and to the side on which they do; along the axis nearer to the cut's it goes on as
 * the cut does. The lattice's lines across that axis are its lines. Its advance is the distance along the
 * axis from the end to its farthest line that has a cracked node; it never goes back.
 *
 * A line is split when its cracked nodes form two groups or more. The crack has branched at the first line
 * from which on all lines over a horizon are split, at the time at which the first and the last of these were
 * both split, looked at every CRACK_FRONT_LOOK steps. The speed is the slope of the least-squares line
 * through the advance over the time in which Rayleigh's wave goes four horizons (crack.h), about its
 * middle: behind a branch it is that of the leading branch along the axis.
 *
 * Everything follows from the steps at which bonds broke, so it is worked out afterwards for the state that
 * there is, at any place of a run. SI units. These definitions are ours; both papers have one crack only. */
#ifndef METHODS_BONDS_CRACKS_FRONTS_H
#define METHODS_BONDS_CRACKS_FRONTS_H

#include "methods/method.h"
#include "methods/bonds/cracks/crack_cost.h"

#include <stdbool.h>
#include <stddef.h>

enum {
    CRACK_FRONTS_MAX = 32,      /* two ends of each cut */
    CRACK_TIPS_MAX = 8,         /* of a front */
    CRACK_FRONT_LOOK = 5,       /* steps */
    CRACK_FRONT_WINDOW_MAX = 64 /* samples over which a speed is taken, at most */
};

enum { CRACK_PATHS_MAX = 3 };

typedef struct CrackFront {
    char cut[24];    /* its name */
    double end[2];   /* of the cut, where the front began */
    double along[2]; /* unit vector of the cut, out of that end */
    int axis, sign;  /* 0: grows along x, 1: along y; towards larger values (1) or smaller ones (-1) */
    bool begun;      /* there is a cracked node */
    double first;    /* time of the first, s; NAN */
    double advance;  /* m */
    int n_tips;      /* groups of cracked nodes that end, longer than two horizons, or the farthest of all */
    double tips[CRACK_TIPS_MAX][2];
    bool branched;
    double branch[2];   /* the middle of the branch's first line */
    double branch_time; /* s */
    double half_angle;  /* degrees between the branches, halved, over a quarter of the plate's height (width)
                         * from there; NAN: not so long, or they meet again */
    double beside;      /* m from the end: a horizon */
    double angle;       /* degrees between the cut and the line through the centres of the front's lines, from
                         * there on and as far as there is one crack; NAN: fewer than two lines */
    double fastest;     /* largest speed, m/s; NAN: too short a time */
    double fastest_at;  /* s */
    double *advances;   /* at CrackFronts.n_samples times */

    /* lines that have a cracked node: their distance from the end, and the damage-weighted centre of these
     * nodes, both m */
    size_t n_lines;
    double *away, *centre;

    /* from the end on: as far as there is one crack, then its outermost branches; a place for each horizon,
     * the damage-weighted centre of the line's cracked nodes, or of its outermost group */
    int n_paths;
    CrackPath paths[CRACK_PATHS_MAX];
} CrackFront;

typedef struct CrackFronts {
    CrackFront fronts[CRACK_FRONTS_MAX];
    int count;
    size_t n_samples;
    double every;   /* s between two samples, the first at t = 0 */
    size_t window;  /* samples over which a speed is taken */
    double length;  /* of all paths, m */
    double surface; /* broken bonds over the bonds that the cuts took for each metre of theirs, m */

    const Simulation *of; /* for which state this was worked out */
    long step, broken;
    double dissipated;
} CrackFronts;

/* Worked out again unless the state is the one that it was worked out for; begin with {0}, and free it.
 * False: the simulation is not a plate, no end of a cut lies in it, or memory is short; then there are no
 * fronts. */
bool crack_fronts_update(CrackFronts *, const Simulation *);
void crack_fronts_free(CrackFronts *);

/* The speed at a sample; NAN nearer to the first or last than half a window, or where the front jumped by
 * more than a horizon: it met what had cracked by itself. */
double crack_fronts_speed(const CrackFronts *, const CrackFront *, size_t sample);

/* The angle between the cut and the straight line through the centres of the front's lines, from `beside`
 * its end on over `reach` (m) as far as there is one crack, degrees; NAN: fewer than two lines. */
double crack_fronts_angle(const CrackFront *, double reach);

#endif
