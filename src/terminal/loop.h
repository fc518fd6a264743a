/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The laboratory on a real terminal: sleeps, reads keys, gives the engine its share of each frame, draws. */
#ifndef TERMINAL_LOOP_H
#define TERMINAL_LOOP_H

#include "lab/session/laboratory_main.h"
#include "lab/session/session.h"

/* Returns the exit status: 0, 128 + n after signal n, or the status's code.
 *
 * For tests: when the environment names a file descriptor in MATVIB_FRAME_FD, a line "frame N" is written to
 * it after each picture, with " idle" behind when the loop now sleeps until something comes. */
int loop_run(const LaboratoryOptions *, const Session *replay, Session *recording, Status *);

#endif
