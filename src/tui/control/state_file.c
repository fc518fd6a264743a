#include "tui/control/state_file.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static void make_folders(const char *file)
{
    char *path = strdup(file);
    for (char *slash = path ? strchr(path + 1, '/') : NULL; slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        mkdir(path, 0700); /* where that fails, so will the file */
        *slash = '/';
    }
    free(path);
}

char *state_file(const char *name, bool make)
{
    const char *state = getenv("XDG_STATE_HOME"), *home = getenv("HOME");
    char *file;
    int length = -1;
    if (state && *state == '/')
        length = asprintf(&file, "%s/matvib/%s", state, name);
    else if (home && *home)
        length = asprintf(&file, "%s/.local/state/matvib/%s", home, name);
    if (length < 0)
        return NULL;
    if (make)
        make_folders(file);
    return file;
}
