/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Curses takes a whole description from the environment (term(7): TERMINFO, "b64:"); it stays there no longer
 * than it is read. */
#include "terminal/fallback.h"

#include <stdlib.h>
#include <string.h>

static const struct {
    const char *name, *description;
} terminals[FALLBACKS] = {
#include "terminal/fallback.inc"
};

SCREEN *fallback_open(int which, FILE *output, FILE *input)
{
    const char *given = getenv("TERMINFO");
    char *before = given ? strdup(given) : NULL;
    if ((given && !before) || setenv("TERMINFO", terminals[which].description, 1) != 0) {
        free(before);
        return NULL;
    }
    SCREEN *screen = newterm(terminals[which].name, output, input);
    if (before)
        setenv("TERMINFO", before, 1);
    else
        unsetenv("TERMINFO");
    free(before);
    return screen;
}
