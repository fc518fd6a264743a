/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keyframes of a run: snapshots from which any earlier moment is reached by restoring and replaying.
 *
 * They are taken every `interval` steps. When the next one would not fit the budget, every second one is
 * given up and the interval doubles; the one at t = 0 always stays. */
#ifndef RUN_HISTORY_H
#define RUN_HISTORY_H

#include "methods/method.h"

typedef struct Keyframe {
    long step;
    size_t size;
    unsigned char *bytes; /* a simulation_snapshot() */
} Keyframe;

typedef struct History {
    Keyframe *frames; /* ascending in step */
    size_t count, room;
    size_t used, budget; /* bytes */
    long interval;
} History;

void history_open(History *, size_t budget);
void history_close(History *);

/* Another budget; where it is less, keyframes are given up as if there never had been more. */
void history_set_budget(History *, size_t budget);

/* Takes a keyframe if one is due at this whole step and not there. Where memory is short there is none, and
 * a seek takes longer. False only if there is none at all. */
bool history_keep(History *, const Simulation *);

/* The last keyframe at or before a step; NULL: there is none. */
const Keyframe *history_nearest(const History *, long step);

/* Forgets the keyframes from a step on, but for that at t = 0. */
void history_cut(History *, long step);

/* Forgets all but the keyframe at t = 0, and begins with the first interval again. */
void history_reset(History *);

/* Steps until the next keyframe is due. */
long history_next(const History *, long step);

#endif
