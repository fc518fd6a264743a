/* SPDX-License-Identifier: GPL-3.0-or-later */
/* One run and all that is kept of it: settings, simulation, references, record, keyframes, ghosts.
 *
 * It has two times: the present (what is on screen, may be rewound) and the newest (what has been computed).
 * Work is done in pieces that the caller sizes, so that an event loop stays alive: there is no clock here.
 *
 * Settings are those in force at the present step: where a live parameter was changed in mid-run, what is on
 * screen before the change is the old value and after it the new one. Edits start from a copy of them. What a
 * file should hold (values at t = 0, and the changes) is experiment_scenario(). */
#ifndef RUN_EXPERIMENT_H
#define RUN_EXPERIMENT_H

#include "answers/references.h"
#include "answers/crack_growth.h"
#include "answers/profile.h"
#include "answers/spectrum.h"

enum { GHOSTS_MAX = 5, LEGEND_MAX = 60 };

/* The curves of an earlier run, kept behind those of the present one. */
typedef struct Ghost {
    bool used, pinned;       /* not pinned: the curve before the last edit, replaced by the next */
    char letter;             /* 'a', 'b', ... */
    char legend[LEGEND_MAX]; /* what it is as against the present run: "cell size 1", "USL" */
    Settings *settings;      /* its own */
    Record record;
    Column columns[COLUMNS_MAX];
    int n_columns;
    Readout readout;      /* of its whole record */
    Profile profile;      /* as it was last on screen, */
    CrackLine crack;      /* and so its cracks */
    Spectrum *spectra;    /* SPECTRUM_SPANS of them; NULL: no memory */
    struct Follow *names; /* of followed columns */
} Ghost;

typedef struct Experiment Experiment;

/* At t = 0, not yet advanced; row 0 is recorded. `history` is the memory for keyframes in bytes. NULL: the
 * status says why. */
Experiment *experiment_create(const Settings *, size_t history, int threads, Status *);
void experiment_destroy(Experiment *);

/* The state of affairs; read only, valid until the next call that changes the experiment. */
const Settings *experiment_settings(const Experiment *); /* in force at the present step */
const Settings *experiment_base(const Experiment *);     /* at t = 0, with the changes in mid-run */
const Simulation *experiment_simulation(const Experiment *);
References *experiment_references(const Experiment *);
const Record *experiment_record(const Experiment *);
const Column *experiment_columns(const Experiment *, int *count);
int experiment_column(const Experiment *, const char *name); /* -1: there is none */
const Ghost *experiment_ghosts(const Experiment *);          /* GHOSTS_MAX of them */
const char *experiment_advice(const Experiment *);           /* "" or a line to be shown */
const CrackFronts *experiment_fronts(const Experiment *); /* of a plate, up to the present step; NULL: none */
const Readout *experiment_readout(const Experiment *);    /* see experiment_rest() */
const Spectrum *experiment_spectrum(const Experiment *, int column, SpectrumSpan); /* NULL: too few rows */
const Spectrum *experiment_ghost_spectrum(const Experiment *, int ghost, int column, SpectrumSpan);
const double *experiment_row(const Experiment *); /* all columns at the present whole step */
/* The energy without the ripple of staggered velocities and stresses (E* of paper M's method: sum of m v^n
 * v^{n+1}/2 and the strain energy between), at the present step and at t = 0. False: not known; it is for
 * bars without load, FLIP alone, between steps. */
bool experiment_invariant(const Experiment *, double *now, double *start);

/* What happened, in plain words, up to the newest step even when rewound; ascending in step. */
const Event *experiment_events(const Experiment *, int *count);

/* The settings whose run from t = 0 gives what has been computed: to the newest step, or only to the present
 * one. For export_run() and scenario_write(): its time.end is the actual last time, its time.step the number
 * in use. */
void experiment_scenario(const Experiment *, bool to_newest, Settings *);
int experiment_derived(const Experiment *, Derived out[DERIVED_MAX]);

double experiment_time(const Experiment *);
long experiment_step(const Experiment *); /* present */
int experiment_stage(const Experiment *);
long experiment_newest(const Experiment *);    /* whole steps computed so far */
long experiment_last_step(const Experiment *); /* the step at which time.end is reached */
bool experiment_at_end(const Experiment *);
bool experiment_failed(const Experiment *, Status *);

/* How much is done at once: whole steps or, of steps that take longer than a frame, a part of one. */
typedef struct Effort {
    long steps;
    double share; /* of the items of a stage (Simulation.stage_items); 0: whole steps */
} Effort;

/* Sets a goal: so many whole steps more, at most the end; a step that has begun is finished first and not
 * counted (so 0 steps finish it, and do nothing else). Rows come. */
void experiment_go_on(Experiment *, long steps);

/* Sets a goal: step `step` with `stage` stages of the next done, forwards or backwards, at most the end. */
void experiment_seek(Experiment *, long step, int stage);

/* On the way to the goal, until nothing is pending. *whole: a step came to its end, or there was none to do.
 * Until then the state is not one of the run, not to be looked at: a caller that wants to, and whatever else
 * is done to the experiment, goes back to where the step began by experiment_drop_part(). False: the run
 * failed; then it stands at the last sound whole step, and nothing is pending. */
bool experiment_work(Experiment *, Effort, bool *whole, Status *);
bool experiment_pending(const Experiment *, long *steps_left);
void experiment_drop_part(Experiment *); /* a goal of experiment_go_on() goes with it */

/* experiment_go_on() and all of its work. */
bool experiment_advance(Experiment *, long steps, Status *);

/* Works until nothing is pending, in slices that keep a caller responsive. False: also where it was
 * cancelled, which is a failure "interrupted". */
bool experiment_work_off(Experiment *, Cancel, Status *);

/* Rows come, by experiment_work(), as by experiment_go_on(). */
void experiment_flow(Experiment *);

/* No rows come for the time being: what is worked out now and then only while the run goes on, the readout,
 * is worked out exactly. */
void experiment_rest(Experiment *);
bool experiment_is_flowing(const Experiment *);

/* The next stage only; nothing at the end of the run. */
bool experiment_next_stage(Experiment *, Status *);

/* The state before the last stage as simulation_save() wrote it, for Method.explain; NULL: not known. */
const void *experiment_before(const Experiment *);

/* Values of a field before the last stage, for highlighting what changed; false: not known. */
bool experiment_field_before(const Experiment *, int field, size_t first, size_t count, double *out);

/* What Method.explain says of a thing after the stage just done of another run, of the same stage here: this
 * run stands at the whole step that the other one is in, and stays there. False: it has no such stage or
 * thing, or is not there. */
bool experiment_explain_beside(const Experiment *, const Experiment *other, int stage, int set, size_t index,
                               int terms, char *out, size_t size);

void experiment_goal(const Experiment *, long *step, int *stage); /* of pending work, or the present */
void experiment_cancel(Experiment *);                             /* stay where the work has come to */

/* Back to t = 0, parameters kept as they are on screen (a live one that was changed in mid-run by hand holds
 * from the start); the curves so far are forgotten unless `keep_ghost`. */
bool experiment_restart(Experiment *, bool keep_ghost, Status *);

/* New settings, made from a copy of experiment_settings(). Where only live parameters differ they change at
 * the present step (the end of the step that has begun; at t = 0 and at the end of the run as a restart
 * parameter), and the future that was computed is cut off. A restart parameter begins again at t = 0 and
 * seeks the time that was on screen: call experiment_work() until nothing is pending. Either way the curves
 * that go stay as the unpinned ghost. time.end, output.*, texts and view alone do not recompute. False:
 * refused, nothing has changed. */
bool experiment_edit(Experiment *, const Settings *, Status *);

/* The same, but live parameters hold from t = 0 on as all others do: another run to compare with. */
bool experiment_rerun(Experiment *, const Settings *, Status *);

/* Whether these settings make a run that is another one from some step on. */
bool experiment_recomputes(const Experiment *, const Settings *);

/* An experiment_base() as it once was, with the changes in mid-run that it had then: for undo. */
bool experiment_replace(Experiment *, const Settings *, Status *);

/* Pins the present curves as a ghost (with the unpinned one's place at most GHOSTS_MAX - 1 of them), or
 * unpins the one of the same settings. False: all places are taken, or no memory. */
bool experiment_pin(Experiment *, Status *);

/* The run is over, its curves stay with `heir` as the unpinned ghost. */
void experiment_become_ghost(Experiment *, Experiment *heir);

/* Other memory for keyframes, in bytes: some are given up where it is less. */
void experiment_set_history(Experiment *, size_t history);

#endif
