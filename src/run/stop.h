/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a run that goes on stops at: a step, a time, or something that happens to it.
 *
 * A step or time is known beforehand (stop_step()). Whether something happened is seen only while the run
 * goes on, so the caller does one step after the other and asks stop_happened() after each: then it
 * stands at the very step and nothing beyond has been computed.
 *
 * A run with time.rest reports that it is at rest, and ends. Of one that is damped only it is looked for
 * here: the kinetic energy is below 1e-10 of its largest, and has been for a tenth of the time, longer than
 * any turning point. */
#ifndef RUN_STOP_H
#define RUN_STOP_H

#include "run/experiment.h"

enum { STOP_WORDS_MAX = 32 };

typedef enum StopKind { STOP_NEVER, STOP_AT_STEP, STOP_AT_TIME, STOP_AT_EVENT } StopKind;

typedef struct Stop {
    StopKind kind;
    long step;       /* STOP_AT_STEP: whole steps done */
    double time;     /* STOP_AT_TIME: the first whole step that is not before it */
    unsigned events; /* STOP_AT_EVENT: any of these, 1 << EventKind */
    long seen;       /* how many of these there were when it was looked at last */
    bool rests;      /* at rest too, of a damped run that does not end there by itself */
    double most;     /* the largest kinetic energy so far */
    double since;    /* the kinetic energy has been next to nothing since that time */
} Stop;

/* The kinds of events that a run reports while it goes on, by their words; ended by NULL. */
extern const char *const stop_event_words[];

/* Reads "t 7.4e-5" or "time 7.4e-5", "step 1200" or "#1200", "end", or the word of an event with or without
 * "next" before it. False: none of these, beyond the run's end, or nothing of the kind can happen in this
 * run; the status says which. */
bool stop_read(Stop *, const char *text, const Experiment *, Status *);

/* A time as it is typed, with arithmetic and, where the run counts in seconds, units: "74 us". */
bool stop_read_time(const char *text, const Experiment *, double *time);

/* What it waits for: "t = 7.4e-05", "a break"; "" for STOP_NEVER. */
void stop_words(const Stop *, char out[STOP_WORDS_MAX]);

/* The whole step at which it is reached, at most the run's last; -1: known only by going on. */
long stop_step(const Stop *, const Experiment *);

/* The run begins to go on: what has happened so far does not count. */
void stop_look(Stop *, const Experiment *);

/* Whether one of its events has happened since stop_look() or the last call. */
bool stop_happened(Stop *, const Experiment *);

#endif
