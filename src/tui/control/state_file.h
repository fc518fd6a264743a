/* What is kept between two visits: files in $XDG_STATE_HOME/matvib or ~/.local/state/matvib. */
#ifndef TUI_STATE_FILE_H
#define TUI_STATE_FILE_H

#include <stdbool.h>

/* The path of such a file; with `make` its folders are made. NULL: there is no home, or no memory; else
 * free() it. */
char *state_file(const char *name, bool make);

#endif
