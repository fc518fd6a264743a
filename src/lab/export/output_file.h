/* A file that is written whole or not at all: everything goes to a temporary file in the same folder, which
 * takes the name at the end. What is no regular file (a terminal, a pipe, /dev/null) is written directly, and
 * so is standard output, "-". */
#ifndef LAB_OUTPUT_FILE_H
#define LAB_OUTPUT_FILE_H

#include "base/status.h"

#include <stdio.h>

typedef struct OutputFile {
    FILE *stream;    /* NULL once it is finished */
    char *name;      /* as the user wrote it, for messages */
    char *target;    /* the file that it will be; NULL: written directly */
    char *temporary; /* until it is committed */
    bool standard;
    bool replaces; /* what has the name by the time it is committed; else that is an error */
} OutputFile;

bool output_is_standard(const char *name); /* "-" */
bool output_is_direct(const char *name); /* "-", or a terminal, a pipe, a device: nothing stands beside it */

/* Whether the folder that a file or folder of this name would be in is there. */
bool output_has_folder(const char *name, Status *);

/* Whether a file may be begun: its folder takes files, it does not exist or may be replaced. Nothing is
 * touched. */
bool output_may_begin(const char *name, bool force, Status *);

/* The one name that stands for a file however it is written; free() it. NULL: no memory, or there is no such
 * folder (the status says which). */
char *output_real_name(const char *name, Status *);

bool output_open(OutputFile *, const char *name, bool force, Status *);

/* Whether all that was written so far has arrived. */
bool output_sound(const OutputFile *, Status *);

/* Brings it to the disk, still under its temporary name, and closes its stream. */
bool output_finish(OutputFile *, Status *);

/* Gives it its name; after output_finish(). False: it cannot be had, or another program was faster. */
bool output_commit(OutputFile *, Status *);

/* Removes temporary files of this name whose programs were killed, a minute ago or earlier. */
void output_remove_remains(const char *name);

/* Takes back what was not committed, and frees. */
void output_close(OutputFile *);

#endif
