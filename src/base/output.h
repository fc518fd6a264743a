/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The one gate for writing. Whatever makes, changes or removes a file does it here and names on whose behalf:
 * a lesson and a session that is done again are files from anybody, so they may write nothing.
 *
 * A file is written whole or not at all: everything goes to a temporary file in the same folder, which takes
 * the name at the end, and file and folder are brought to the disk. What is not a regular file (a terminal, a
 * pipe, /dev/null) is written directly, and so is standard output, "-". */
#ifndef BASE_OUTPUT_H
#define BASE_OUTPUT_H

#include "base/status.h"

#include <stdio.h>

/* On whose behalf something is done. */
typedef enum Asker {
    ASKER_NOBODY,       /* not named: refused */
    ASKER_KEYBOARD,     /* a person, now */
    ASKER_COMMAND_LINE, /* what the program was begun for, and what it keeps for the user */
    ASKER_SCRIPT,       /* --script: keys from a file that the user named */
    ASKER_REPLAY,       /* keys of a session: refused */
    ASKER_LESSON        /* what a page of a lesson does: refused */
} Asker;

typedef struct OutputFile {
    FILE *stream;                /* NULL once it is finished */
    char *name;                  /* as the user wrote it, for messages */
    char *target;                /* the file that it will be; NULL: written directly */
    struct Temporary *temporary; /* until it is committed */
    bool standard;
    bool replaces; /* what has the name by the time it is committed; else that is an error */
    bool spares;   /* a file that has been read by then: an error too */
} OutputFile;

/* Whether this asker may write at all; checked by every function below that makes or changes something. */
bool output_allowed(Asker, const char *name, Status *);

bool output_is_standard(const char *name); /* "-" */
bool output_is_direct(const char *name);   /* "-", or a terminal, a pipe, a device: nothing is beside it */

/* Whether a file may be begun: its folder takes files, it does not exist or may be replaced. Nothing is
 * touched. A command line replaces (--force) only what this program wrote, as the first line shows, and never
 * a file that is read; a person who was asked about the very name replaces any. */
bool output_may_begin(const char *name, Asker, bool force, Status *);

/* The one name that stands for a file however it is written; free() it. NULL: no memory, or there is no such
 * folder (the status says which). */
char *output_real_name(const char *name, Status *);

/* The names of all files of a command, of which no two may be one, known before anything is calculated. */
typedef struct OutputNames {
    Asker asker;
    bool force;
    char **real;
    size_t count, room;
    int standard;
} OutputNames;

/* Whether this one may be begun; NULL: it is not asked for. */
bool output_names_take(OutputNames *, const char *name, Status *);

/* Whether all of them, which were `sound` so far, are different files; frees them. */
bool output_names_differ(OutputNames *, bool sound, Status *);

bool output_open(OutputFile *, Asker, const char *name, bool force, Status *);

/* A file that the program keeps for itself: what has the name is replaced, and where that is a link it is the
 * link that goes, not what it points to. */
bool output_open_own(OutputFile *, Asker, const char *name, Status *);

/* Whether all that was written so far has arrived. */
bool output_sound(const OutputFile *, Status *);

/* Brings it to the disk, still under its temporary name, and closes its stream. */
bool output_finish(OutputFile *, Status *);

/* Gives it its name; after output_finish(). False: it cannot be had, or another program was faster. */
bool output_commit(OutputFile *, Status *);

/* Gives it its name before it is complete: what was written so far is there to stay, and more may follow
 * until output_finish(). */
bool output_publish(OutputFile *, Status *);

/* Makes the folders that a file of the program's own lies in, the last one for the user alone. */
void output_make_own_folders(Asker, const char *file);

/* Removes temporary files of this name whose programs were killed, a minute ago or earlier. */
void output_remove_remains(const char *name);

/* Takes back what was not committed, and frees. */
void output_close(OutputFile *);

/* The end of a file that stands alone: what is to be kept is finished, gets its name and is closed, else it
 * is taken back. Whether it is there. */
bool output_end(OutputFile *, bool wanted, Status *);

#endif
