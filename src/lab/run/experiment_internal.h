/* What the files behind experiment.h share. */
#ifndef LAB_EXPERIMENT_INTERNAL_H
#define LAB_EXPERIMENT_INTERNAL_H

#include "lab/run/experiment.h"
#include "lab/run/story.h"
#include "lab/run/trial.h"

/* The state before the last stage. */
typedef struct Before {
    unsigned char *bytes;
    size_t room, head; /* what simulation_snapshot() puts before the method's own bytes */
    bool known;
} Before;

/* The state before a step that is done in parts. */
typedef struct Part {
    unsigned char *bytes;
    size_t room;
    bool begun;
} Part;

/* What is known of E*: at t = 0, and at one step. */
typedef struct Invariant {
    bool any;
    double start, now;
    long step; /* that `now` belongs to; -1: none */
} Invariant;

struct Experiment {
    Trial trial;
    bool adopted; /* the simulation came from outside: no other can be made from the settings */
    size_t history;
    int threads;
    Change given[CHANGES_MAX]; /* the changes that came with the settings, not made by hand */
    int n_given;
    Ghost ghosts[GHOSTS_MAX];
    bool pending;
    long goal_step;
    int goal_stage;
    Before before;
    Part part;
    double row[COLUMNS_MAX];
    long row_step; /* the step that `row` belongs to; -1: none */
    Readout readout;
    size_t readout_rows; /* how many rows it was worked out from */
    bool flowing;        /* rows come in: it is worked out now and then only */
    Spectrum spectra[SPECTRUM_SPANS];
    Invariant invariant;
    Story story;
    Derived derived[DERIVED_MAX];
    int n_derived; /* 0: not known */
    Settings derived_for;
};

void experiment_drop_ghost(Ghost *);
void experiment_keep_given(Experiment *, const Settings *); /* its changes came with it */

#endif
