/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of a run as far as they are kept: one row per recorded step, all columns.
 *
 * Rows are kept whole up to a budget. Beyond it every second row is dropped and from then on only every
 * second step is kept (again and again): the spacing doubles, first and last row stay. */
#ifndef RUN_RECORD_H
#define RUN_RECORD_H

#include "methods/method.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct Record {
    double *rows; /* count x n_columns; column 0 is the step, column 1 the time */
    size_t count, room, most;
    int n_columns;
    long spacing; /* steps between rows: `every` of record_open(), twice, four times it, ... */
    bool thinned;
    bool loose_last; /* the last row is not a multiple of the spacing; the next one takes its place */
} Record;

/* `budget` in bytes; every: steps between rows to begin with. */
void record_open(Record *, int n_columns, long every, size_t budget);
void record_close(Record *);

/* Appends a row if its step is due, else puts it last until the next comes. False: no memory. */
bool record_append(Record *, const double *row);

/* Forgets all rows after a step. */
void record_cut(Record *, long step);

/* A copy with memory of its own. False: no memory; `to` is empty then. */
bool record_copy(Record *to, const Record *from);

const double *record_row(const Record *, size_t i);

/* A column in row i, or in the last of some rows before it that has it: what takes long to find is NAN in
 * most. NAN: none has it. */
double record_known(const Record *, size_t i, int column);

/* The row of a step; NULL: it is not kept. */
const double *record_of_step(const Record *, long step);

/* The index of the last row with time <= t; 0 if there is none. */
size_t record_find(const Record *, double t);

/* Keyframes of a run: snapshots from which any earlier moment is reached by restoring and replaying.
 *
 * They are taken every `interval` steps. When the next one would not fit the budget, every second one is
 * given up and the interval doubles; the one at t = 0 always stays. */

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
