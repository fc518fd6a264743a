/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the player shows of itself, and the places in the run that are marked. */
#ifndef RUN_PLAYBACK_H
#define RUN_PLAYBACK_H

#include "run/stop.h"

enum { FRAMES_PER_SECOND = 30 };

typedef enum RunState {
    STATE_PAUSED,
    STATE_RUNNING,
    STATE_COMPUTING, /* on the way to a time that was asked for */
    STATE_ENDED,     /* at time.end, paused; the summary is shown */
    STATE_FAILED
} RunState;

typedef struct Playback {
    RunState state;
    double pace;                /* steps per frame; FRAMES_PER_SECOND frames */
    double rate;                /* steps per frame that the engine reaches; shown where it is the limit */
    bool at_limit;              /* the engine is slower than the pace asked for */
    bool slow;                  /* STATE_PAUSED, but stage follows stage by itself */
    bool looping;               /* running comes back at the end of a stretch of time */
    char until[STOP_WORDS_MAX]; /* what it stops at; "": nothing */
    long until_step;            /* where that is; -1: not known */
    double work_share;          /* STATE_COMPUTING: share done */
    bool goes_on;               /* STATE_COMPUTING: once that is done the run goes on */
} Playback;

/* A place in the run: by time, for another mesh has other steps. */
typedef struct Bookmark {
    double time; /* of the whole step before it */
    int stage;
} Bookmark;

enum { BOOKMARKS_MAX = 9 };

typedef struct Bookmarks {
    Bookmark places[BOOKMARKS_MAX]; /* ascending */
    int count;
} Bookmarks;

#endif
