/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A session: the scenario that the laboratory was opened with and every key since, each with the step of the
 * run at which it came. Doing them again gives the same run to the last bit, however fast the machine is.
 *
 * The file is text. "scenario NAME" and lines "| ..." hold the resolved scenario; "paused" that it opened
 * paused; "first" that it was the first of its user; "lesson NAME" that it opened with a lesson, "reached
 * NAME PAGE" how far one had come in it, "student NAME" and "id ID" whose homework it is, "version HASH
 * PROGRAM" of the lesson's text (0: there is none) and the program; then one line a key,
 *
 *     at STEP[/STAGE] SECONDS WIDTHxHEIGHT NAME [X Y]
 *
 * with the seconds since the line before, for those who replay at the same pace, the size of the screen, and
 * the cell of a mouse key; "~" before the step says that the run was on its way elsewhere (the key did not
 * wait for it). "stop STEP[/STAGE] SECONDS WIDTHxHEIGHT" says that what the key before it began, and what is
 * not cut into frames (a fit, an export, an answer that is looked at), was given up. "end STEP[/STAGE]
 * SECONDS WIDTHxHEIGHT" says where the session was left, "check HASH" behind it is of all lines before: it
 * detects a file that was changed by mistake, and nothing against somebody who calculates it again - what
 * such a session does is judged by doing it again. */
#ifndef LAB_SESSION_SESSION_H
#define LAB_SESSION_SESSION_H

#include "base/status.h"
#include "scenario/assignment.h"
#include "terminal/keys.h"
#include "lab/session/laboratory_main.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

typedef struct Laboratory Laboratory;
typedef struct Session Session;

enum { SESSION_NAME_MAX = 256 };

/* One key, and where it came. */
typedef struct SessionEvent {
    bool is_end;  /* no key: the session was left here */
    bool is_stop; /* no key: what the one before began was given up */
    bool on_the_way;
    long step;
    int stage;
    double seconds; /* since the event before */
    int width, height;
    Key key;
} SessionEvent;

/* Begins to record. NULL: the scenario cannot be written, or no memory. */
Session *session_begin(const LaboratoryOptions *, Status *);

/* The laboratory is open: from now on time counts. */
void session_note_start(Session *, const Laboratory *);

/* Notes a key that comes now, that the work of the last one is given up (is_stop), or that the session is
 * left (is_end); where memory is short or the session very long, no more is noted. The session may be NULL.
 */
void session_note(Session *, const Laboratory *, SessionEvent);

/* From the first key on every line goes to this file as it comes, and outlives a crash. */
void session_record(Session *, const char *file, bool force);

/* Says once that no more lines go to that file, and why. */
bool session_is_lost(Session *, Status *);

/* That file is complete. False: something is missing in it, and the status says why. */
bool session_finish(Session *, Status *);

/* Writes what was noted to a file of the program's own, whole or not at all. */
bool session_keep(const Session *, const char *file, Status *);

bool session_has_keys(const Session *); /* something has been noted, or would have been with more memory */

/* Reads a session to do again. NULL: the status says where it is wrong, or of which other version it is. */
Session *session_read(const char *file, Status *);

/* Of one of another version this has what it says of itself before its version, and nothing to do again. */
Session *session_read_facts(const char *file, Status *);
Session *session_read_stream(FILE *, const char *name, Status *);

/* Makes the options those of the session: settings, scenario, paused, lesson, reached. */
void session_options(const Session *, LaboratoryOptions *);

/* What was noted, in order; NULL: there are no more. */
const SessionEvent *session_event(const Session *, size_t index);

void session_free(Session *); /* NULL is allowed */

/* Doing a session again: its keys, each when the run has come to the step at which it was pressed. A key that
 * did not wait for the run to arrive somewhere does not wait here either. */

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
