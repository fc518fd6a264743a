/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command line behind `:`: commands by name, KEY=VALUE, a time, and verbs that take arguments. */
#ifndef LAB_PROMPT_LINE_H
#define LAB_PROMPT_LINE_H

#include <stdbool.h>

typedef struct Laboratory Laboratory;

void line_ask(Laboratory *);

/* Does what a line says, without remembering it. False: screen.prompt->problem says why not. */
bool line_run(Laboratory *, const char *line);

#endif
