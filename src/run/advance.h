/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run as time passes in it: a simulation, the changes of its settings in mid-run, rest, failure, and where
 * it is. run_advance() is the only place above the methods where time passes; code that wants something of it
 * on the way, rows of the series or the state at some steps, says so by a sink.
 *
 * At a whole step, in this order: its row (the state before what changes there), changes come into force, the
 * state is looked at. */
#ifndef RUN_ADVANCE_H
#define RUN_ADVANCE_H

#include "methods/method.h"
#include "base/cancel.h"
#include "scenario/assignment.h"

#include <stdbool.h>

typedef struct Run {
    const Settings *settings; /* the values at t = 0 and the changes in mid-run, the caller's */
    Simulation *sim;          /* the run's own */
    Cancel cancel;            /* asked between blocks of steps, with the share done */
    long last;                /* the step at which it ends: that of time.end, or at which it came to rest */
    bool failed; /* run_advance() came to where the simulation goes no further; `failure` says why */
    Status failure;
    double *block; /* rows of the method, on their way to the sinks */
} Run;

/* What is done with a run on its way. All that is zero wants nothing, so that blocks of steps stay long. */
typedef struct Sink {
    /* Rows: of steps from `from` on that are multiples of `every` (0: none), and of the last step. */
    long every, from;
    bool (*row)(void *owner, Run *, long step, const double *row, Status *);

    /* The state: at the next such step later than this one; LONG_MAX: at none. NULL: never. */
    long (*next)(const void *owner, long step);
    bool (*state)(void *owner, Run *, Status *);

    /* Looks after each stage of the steps `first` to `last` (the first step of a run is 1): `stage` of them
     * are done, `step` is the one that they lead to. NULL: never. */
    bool (*stage)(void *owner, Run *, long step, int stage, Status *);
    long first, last;

    void *owner;
    const struct Sink *beside; /* one more sink of the run; NULL: there is none */
} Sink;

typedef enum RunUnit {
    RUN_STEPS,  /* whole steps; one that has begun is finished first, and not counted */
    RUN_STAGES, /* stages of a step */
    RUN_ITEMS   /* items of the step's stages (Simulation.stage_items), at most to the end of the step */
} RunUnit;

/* Of a simulation at t = 0, which is the run's from here on (NULL, with the status: there is none). False: no
 * memory, or no simulation; to be closed all the same. */
bool run_open(Run *, const Settings *, Simulation *, Status *);
void run_close(Run *);

/* At t = 0: row 0, the changes of step 0, the state. */
bool run_start(Run *, const Sink *, Status *);

/* Goes on, never beyond the last step. False: the run failed (then `failed` is set, its failure the status';
 * the simulation stands at its last sound whole step, or in the middle of one where run_is_sound() says so),
 * a sink failed, or it was given up. */
bool run_advance(Run *, RunUnit, long count, const Sink *, Status *);

/* To the end, or to rest. */
bool run_to_end(Run *, const Sink *, Status *);

/* The changes of the present whole step come into force. False: the run failed. */
bool run_change(Run *, Status *);

/* Whether a failed run stands at a whole step that is sound; then it can be looked at, and walked up to
 * again: its failure is forgotten by the simulation. False too where memory is short. */
bool run_is_sound(Run *);

#endif
