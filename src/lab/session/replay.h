/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Doing a session again: its keys, each when the run has come to the step at which it was pressed. A key that
 * did not wait for the run to arrive somewhere does not wait here either. */
#ifndef LAB_SESSION_REPLAY_H
#define LAB_SESSION_REPLAY_H

#include "lab/session/session.h"

typedef struct Replay {
    const Session *session; /* NULL: none is done again */
    size_t next;            /* event */
    bool sought;            /* its place has been gone to */
} Replay;

/* The next event; NULL: all has been done. */
const SessionEvent *replay_next(const Replay *);

/* Goes on towards the next event, of which there is one, as fast as it can until `deadline` by the host's
 * clock, and carries it out when the run is there. True: it was carried out. */
bool replay_go_on(Replay *, Laboratory *, double deadline);

/* All has been done, or the rest is left out: what is open is closed, and keys are the user's from now on.
 * Until then nothing is written. */
void replay_end(Replay *, Laboratory *);

#endif
