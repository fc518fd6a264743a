/* One computed run: a simulation with its references, its record and its keyframes. An experiment has one at
 * a time; see experiment.h, which adds ghosts and edits. */
#ifndef LAB_TRIAL_H
#define LAB_TRIAL_H

#include "lab/run/history.h"
#include "lab/problems/references.h"
#include "lab/run/record.h"

typedef struct Trial {
    Settings base; /* values at t = 0, and the changes in mid-run */
    Settings now;  /* what is in force at the present step */
    Simulation *sim;
    References *refs;
    Column columns[COLUMNS_MAX];
    int n_columns;
    Record record;
    History history;
    double *block; /* rows of the method, on their way into the record */
    long newest;   /* whole steps computed */
    long last;     /* the step at which the run ends */
    bool failed;   /* the run cannot go beyond the newest step */
    Status failure;
    Event events[SIMULATION_EVENTS_MAX]; /* up to the newest step, whatever is on screen */
    int n_events;
    char advice[160];
} Trial;

/* At t = 0, row 0 recorded. False: refused; there is nothing to close. */
bool trial_open(Trial *, const Settings *, size_t history, int threads, Status *);
void trial_close(Trial *);

/* The same around a simulation that is there already, which it takes over in any case: without references. */
bool trial_adopt(Trial *, const Settings *, Simulation *, size_t history, Status *);

/* Back to t = 0, as if nothing had been computed. The record so far is handed over. */
void trial_rewind(Trial *, Record *old);

/* Finishes the step that has begun, if one has; then at most `steps` whole steps, not beyond the last. Rows
 * that are recorded already are not worked out again. False: the run failed, and stands at its last sound
 * whole step; or memory was short. */
bool trial_steps(Trial *, long steps, Status *);

/* The next stage; nothing at the end of the run. */
bool trial_stage(Trial *, Status *);

/* At most so many items of the step's stages (Simulation.stage_items). *whole: the step came to its end, or
 * there is none to do. In the middle the state is no moment of the run. */
bool trial_slice(Trial *, size_t items, bool *whole, Status *);

/* Goes to the last keyframe at or before a step, if that is a way to get there from here: it is where the
 * present is beyond the step, or before the keyframe. */
void trial_approach(Trial *, long step, int stage);

/* A live parameter changes after `step` whole steps, which is the present one or, while a step goes on, the
 * next: what was computed beyond is forgotten. */
bool trial_change(Trial *, long step, const char *key, const char *value, Status *);

/* Another time.end (where the problem allows it without a new run); rows beyond it are forgotten. */
void trial_set_end(Trial *, double end);

#endif
