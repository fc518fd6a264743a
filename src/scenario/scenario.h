/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Scenario files: INI text in, settings out, and back. Format: manual page matvib(5). */
#ifndef SCENARIO_SCENARIO_H
#define SCENARIO_SCENARIO_H

#include "base/status.h"
#include "scenario/assignment.h"

#include <stdio.h>

/* A scenario that is part of the program, from data/scenarios. */
typedef struct BuiltinScenario {
    const char *name; /* "mode1" */
    const char *text; /* the file's whole text */
} BuiltinScenario;

extern const char scenario_unnamed[]; /* the name of the one that is opened where none is named */

extern const BuiltinScenario builtin_scenarios[]; /* generated; ended by a NULL name */

/* A value that overrides the file's, as if it stood in its last line: from --set, --end, ... Nothing is
 * checked before it is in its place, but the file's own lines must be readable. */
typedef struct Override {
    const char *origin; /* stands for FILE:LINE in an error: "--set" */
    const char *key;
    const char *value;
} Override;

/* Reads a scenario by built-in name or, failing that, by path. Every error is one line,
 * "FILE:LINE: KEY: what is wrong (what is allowed)", with code STATUS_USAGE. */
bool scenario_load(const char *name_or_path, Settings *settings, Status *status);
bool scenario_load_with(const char *name_or_path, const Override *overrides, int count, Settings *settings,
                        Status *status);

/* A refusal that came after the file was read, when the run was made, gets its origin: the line that says the
 * key which it begins with, or another key that it names. One that begins with no key stays as it is. */
void scenario_blame(const char *name_or_path, const Override *overrides, int count, Status *status);

/* The same from a stream; `name` stands for FILE. */
bool scenario_read(FILE *stream, const char *name, Settings *settings, Status *status);

/* Writes settings so that scenario_read() gives them back to the last bit. `comment` (may be NULL) goes to
 * the head, each of its lines behind "# ". False: a text that would not read back, or a write error. */
bool scenario_write(FILE *stream, const Settings *settings, const char *comment, Status *status);

/* Hands on what makes these settings of a scenario, as --set takes it; what a run writes, its changes in
 * mid-run and a concealed mistake are left out. False: there is no such scenario. */
typedef void AssignmentTaker(void *context, const char *key, const char *value);
bool scenario_assignments(const char *name_or_path, const Settings *, AssignmentTaker *, void *context);

/* The built-in of that name; NULL: there is none. */
const BuiltinScenario *scenario_builtin(const char *name);

/* What the screen opens first for a scenario that takes long: its coarse form, another built-in. All others
 * and files are their own. Runs, sweeps, figures, films and lessons are always of what was named. */
const char *scenario_on_screen(const char *name_or_path);

/* The built-in that has this as its coarse form; NULL: there is none. */
const char *scenario_whole(const char *name);

/* The title of a built-in, for lists. */
bool scenario_title(const BuiltinScenario *builtin, char title[TITLE_MAX]);

#endif
