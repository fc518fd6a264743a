/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the files of the program's own are, by the rules of XDG. */
#include "lab/session/state_file.h"

#include <stdio.h>
#include <stdlib.h>

char *state_file(const char *name)
{
    const char *state = getenv("XDG_STATE_HOME"), *home = getenv("HOME");
    char *file;
    int length = -1;
    if (state && *state == '/')
        length = asprintf(&file, "%s/matvib/%s", state, name);
    else if (home && *home)
        length = asprintf(&file, "%s/.local/state/matvib/%s", home, name);
    return length < 0 ? NULL : file;
}
