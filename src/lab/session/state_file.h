/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is kept between two visits: files in $XDG_STATE_HOME/matvib or ~/.local/state/matvib. */
#ifndef TUI_STATE_FILE_H
#define TUI_STATE_FILE_H

/* The path of such a file. NULL: there is no home, or no memory; else free() it. */
char *state_file(const char *name);

#endif
