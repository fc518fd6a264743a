/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The laboratory without a terminal: keys from a file, screens to standard output, a clock that only frames
 * and steps move (but for the instruction `cancel`). The same script gives the same screens, always.
 *
 * One instruction a line, as the table below has them; empty lines and lines that begin with # are skipped.
 * The first instruction that misses ends the script: "FILE:LINE: ..." and exit status 1. */
#ifndef LAB_SESSION_SCRIPT_H
#define LAB_SESSION_SCRIPT_H

#include "lab/session/laboratory_main.h"
#include "lab/session/session.h"

#include <stdio.h>

enum { SCRIPT_CELLS_MAX = 1000 }; /* of a screen, each way */

typedef struct Script Script; /* a script that is being played */

/* A row of the table of instructions, ended by a NULL name; the manual page is made from it. */
typedef struct ScriptInstruction {
    const char *name, *arguments, *help;
    bool (*run)(Script *, char *arguments, Status *);
    bool by; /* which of the two that its function does */
} ScriptInstruction;

extern const ScriptInstruction script_instructions[];

/* Plays what the options name, before their camera; without keys the run alone. Returns the exit status. */
int script_run(const LaboratoryOptions *, const Session *replay, Session *recording, Status *);

/* The same from a stream, NULL for none; `name` stands for FILE. */
int script_play(FILE *, const char *name, const LaboratoryOptions *, const Session *replay,
                Session *recording, Status *);

#endif
