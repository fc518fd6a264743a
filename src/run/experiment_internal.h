/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files behind experiment.h share. */
#ifndef RUN_EXPERIMENT_INTERNAL_H
#define RUN_EXPERIMENT_INTERNAL_H

#include "scenario/settings.h"
#include "run/advance.h"
#include "run/event_log.h"

/* A state to which there is a way back. */
typedef struct Kept {
    unsigned char *bytes;
    size_t room, head; /* what simulation_snapshot() puts before the method's own bytes */
    bool known;
} Kept;

/* What is worked out of a run when somebody looks, and kept until it changes: looking changes no run, so that
 * readers take a const Experiment. */
typedef struct Worked {
    double row[COLUMNS_MAX];
    long row_step; /* the step that `row` belongs to; -1: none */
    Readout readout;
    size_t readout_rows; /* how many rows it was worked out from */
    Spectrum spectra[SPECTRUM_SPANS];
    struct { /* what is known of E*: at t = 0, and at one step */
        bool any;
        double start, now;
        long step; /* that `now` belongs to; -1: none */
    } invariant;
    CrackFronts fronts;
    EventLog log;
    Derived derived[DERIVED_MAX];
    int n_derived; /* 0: not known */
    Settings derived_for;
} Worked;

struct Experiment {
    /* the run */
    Settings base; /* values at t = 0, and the changes in mid-run */
    Settings now;  /* what is in force at the present step */
    Run run;       /* its `failed`: it cannot go beyond the newest step */
    References *refs;
    Column columns[COLUMNS_MAX];
    int n_columns;
    Record record;
    History history;
    long newest;                         /* whole steps computed */
    Event events[SIMULATION_EVENTS_MAX]; /* up to the newest step, whatever is on screen */
    int n_events;
    char advice[160];

    /* what is kept beside it */
    int threads;
    Change given[CHANGES_MAX]; /* the changes that came with the settings, not made by hand */
    int n_given;
    Ghost ghosts[GHOSTS_MAX];
    bool pending;
    bool goes_on; /* the goal is that of experiment_go_on() */
    long goal_step;
    int goal_stage;
    Kept before;  /* the last stage */
    Kept part;    /* or a step that is done in parts, while it is */
    bool flowing; /* rows come in: the readout is worked out now and then only */
    Worked *worked;
};

/* --- the run: experiment_run.c ---------------------------------------------------------------------- */

/* Works out the derived numbers of the settings as they are now; what is given up is asked for again. */
void experiment_derive(const Experiment *, Cancel);

/* Back to t = 0, as if nothing had been computed. The record so far is handed over. */
void experiment_rewind(Experiment *, Record *old);

/* Finishes the step that has begun, if one has; then at most `steps` whole steps, not beyond the last. Rows
 * that are recorded already are not worked out again. False: the run failed, and stands at its last sound
 * whole step; or memory was short. */
bool experiment_do_steps(Experiment *, long steps, Status *);

/* As run_advance(), beyond what is known of a failed run too; where it cannot go on it stands at its last
 * sound whole step. In the middle of a stage the state is not one of the run. */
bool experiment_go(Experiment *, RunUnit, long count, Status *);

/* Goes to the last keyframe at or before a step, if that is a way to get there from here: it is where the
 * present is beyond the step, or before the keyframe. */
void experiment_approach(Experiment *, long step, int stage);

/* The settings with more changes of live parameters after `step` whole steps, which is the present one or,
 * while a step goes on, the next: what was computed beyond is forgotten. */
bool experiment_change(Experiment *, long step, const Settings *changed, Status *);

/* Another time.end (where the problem allows it without a new run); rows beyond it are forgotten. */
void experiment_set_end(Experiment *, double end);

/* --- ghosts: ghosts.c --------------------------------------------------------------------------------- */

/* What a run leaves behind, with this record of it. */
Ghost experiment_leave(const Experiment *, Record);

/* It is handed over, or dropped where there are no rows, no memory or no place for another pinned one. The
 * unpinned ghost has its place for itself. */
void experiment_keep_ghost(Experiment *, bool pinned, Ghost *left);
void experiment_drop_ghost(Ghost *);
void experiment_drop_unpinned(Experiment *);

/* Whether there is a curve worth keeping: one that is still on its way to the time on screen is not. */
bool experiment_has_curve(const Experiment *);

/* Whether a pinned ghost shows all that this run would leave behind. */
bool experiment_is_pinned(Experiment *);

/* Legends show what differs from the run that is on screen now. */
void experiment_write_legends(Experiment *);

#endif
