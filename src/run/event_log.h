/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What happened in a run, in plain words with their steps: what the method reported, the changes that were
 * made, and what follows from the record: drift of the energy, a lag behind the exact answer. */
#ifndef RUN_EVENT_LOG_H
#define RUN_EVENT_LOG_H

#include "run/experiment.h"

enum { EVENT_LOG_PLANNED_MAX = 2 * CHANGES_MAX + 2, EVENT_LOG_DRIFTS_MAX = 16, EVENT_LOG_LAGS_MAX = 6 };
enum {
    EVENT_LOG_MAX =
        SIMULATION_EVENTS_MAX + EVENT_LOG_PLANNED_MAX + EVENT_LOG_DRIFTS_MAX + EVENT_LOG_LAGS_MAX + 1
};

/* The mean energy of each period beside that of the first. */
typedef struct EnergyWatch {
    double period;    /* 0: there is none, nothing is watched */
    size_t rows;      /* of the record that are in */
    long spacing;     /* of these */
    long block;       /* the period that is being summed up */
    double sum;       /* of its rows */
    size_t count;     /* how many they are */
    double first;     /* mean of the first period */
    double before;    /* drift of the period before, a share of the first */
    long before_step; /* its last step */
    int level;        /* how many levels were reported */
    Event events[EVENT_LOG_DRIFTS_MAX];
    int n_events;
} EnergyWatch;

typedef struct EventLog {
    bool begun; /* false: all is forgotten, for the run is another one, or part of it was cut off */
    Event planned[EVENT_LOG_PLANNED_MAX]; /* advice and changes */
    int n_planned;
    EnergyWatch energy;
    Event events[EVENT_LOG_MAX]; /* all, ascending in step */
    int count;
    long newest; /* the step that it goes to */
    bool failed;
    int n_reported;
    double late; /* the lag per time with which its events were made */
} EventLog;

/* Brings it up to the newest step. */
void event_log_update(EventLog *, const Experiment *, const Readout *);

#endif
