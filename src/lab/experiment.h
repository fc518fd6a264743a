/* One run and all that is kept of it: settings, simulation, references, record, keyframes, ghosts.
 *
 * It has two times: the present (what is on screen, may be rewound) and the newest (what has been computed).
 * Work is done in pieces that the caller sizes, so that an event loop stays alive: there is no clock here. */
#ifndef LAB_EXPERIMENT_H
#define LAB_EXPERIMENT_H

#include "lab/problem.h"
#include "lab/record.h"
#include "lab/settings.h"

enum { GHOSTS_MAX = 5, LEGEND_MAX = 120 };

/* The curves of an earlier run, kept behind those of the present one. */
typedef struct Ghost {
    bool used, pinned;       /* not pinned: the curve before the last edit, replaced by the next */
    char letter;             /* 'a', 'b', ... */
    char legend[LEGEND_MAX]; /* what differs: "cell size 1 -> 0.5" */
    Settings settings;
    Record record;
    Column columns[COLUMNS_MAX];
    int n_columns;
} Ghost;

typedef struct Experiment Experiment;

/* At t = 0, not yet advanced; row 0 is recorded. `history` is the memory for keyframes in bytes. NULL: the
 * status says why. */
Experiment *experiment_create(const Settings *, size_t history, int threads, Status *);
void experiment_destroy(Experiment *);

/* The state of affairs; read only, valid until the next call that changes the experiment. */
const Settings *experiment_settings(const Experiment *);
const Simulation *experiment_simulation(const Experiment *);
References *experiment_references(const Experiment *);
const Record *experiment_record(const Experiment *);
const Column *experiment_columns(const Experiment *, int *count);
const Ghost *experiment_ghosts(const Experiment *); /* GHOSTS_MAX of them */
const char *experiment_advice(const Experiment *);  /* "" or a line to be shown */
const Readout *experiment_readout(Experiment *);    /* worked out anew when rows have come */
const double *experiment_row(Experiment *);         /* all columns at the present whole step */
int experiment_derived(const Experiment *, Derived out[DERIVED_MAX]);

double experiment_time(const Experiment *);
long experiment_step(const Experiment *); /* present */
int experiment_stage(const Experiment *);
long experiment_newest(const Experiment *);    /* whole steps computed so far */
long experiment_last_step(const Experiment *); /* the step at which time.end is reached */
bool experiment_at_end(const Experiment *);
bool experiment_failed(const Experiment *, Status *);

/* Goes on by whole steps, at most to the end; a step that has begun is finished first. False: the run
 * failed; then it stands at the last sound whole step. */
bool experiment_advance(Experiment *, long steps, Status *);

/* The next stage only. */
bool experiment_next_stage(Experiment *, Status *);

/* The state before the last stage as Method.save wrote it, for Method.explain; NULL: not known. */
const void *experiment_before(const Experiment *);

/* Values of a field before the last stage, for highlighting what changed; false: not known. */
bool experiment_field_before(Experiment *, int field, size_t first, size_t count, double *out);

/* To step `step` with `stage` stages of the next one done, forwards or backwards: sets the goal. Then call
 * experiment_work() until nothing is pending. */
void experiment_seek(Experiment *, long step, int stage);
bool experiment_pending(const Experiment *, long *steps_left);
bool experiment_work(Experiment *, long steps, Status *);
void experiment_cancel(Experiment *); /* stay where the work has come to */

/* Back to t = 0, parameters kept; the curves so far are forgotten unless `keep_ghost`. */
bool experiment_restart(Experiment *, bool keep_ghost, Status *);

/* New settings. A restart parameter begins anew at t = 0 and seeks the time that was on screen; the curves
 * so far stay as the unpinned ghost. False: refused, nothing has changed. */
bool experiment_edit(Experiment *, const Settings *, Status *);

/* Pins the present curves as a ghost, or unpins the one that equals them. False: all places are taken. */
bool experiment_pin(Experiment *, Status *);

#endif
