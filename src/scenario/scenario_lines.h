/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The lines of a scenario file, before anything is known of their meaning. What a reader of INI files would
 * silently take for something else (indented keys, long lines, NUL bytes, unknown sections) is refused. */
#ifndef SCENARIO_SCENARIO_LINES_H
#define SCENARIO_SCENARIO_LINES_H

#include "base/status.h"
#include "scenario/assignment.h"

#include <stdio.h>

enum {
    SCENARIO_LINE_MAX = 190, /* bytes of a line without its comment */
    SCENARIO_LINES_MAX =
        5000, /* no scenario needs more; a wrong file is refused before it fills the memory */
    SCENARIO_BYTES_MAX = 5000000
};

typedef struct Entry {
    int line;
    char section[16];
    char name[KEY_MAX];
    char value[ABOUT_MAX];
} Entry;

typedef struct Entries {
    Entry *all;
    int count, room;
    int lines; /* of the file */
} Entries;

/* The sections there are, in the order in which they are written; ended by NULL. */
extern const char *const scenario_sections[];

/* Whether a value may go on in indented lines below: scenario.about, initial.overtones, output.at. */
bool scenario_may_continue(const char *section, const char *name);

/* Whether a text begins with the name of a key and '='. Such a line may not be a continuation. */
bool scenario_looks_like_key(const char *text);

/* Reads a whole stream. False: the status says "FILE:LINE: ..."; entries are to be freed in any case. */
bool entries_read(Entries *, FILE *stream, const char *file, Status *);
void entries_free(Entries *);

#endif
