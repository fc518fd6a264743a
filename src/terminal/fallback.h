/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Terminals where the system has no descriptions of them: two that are compiled in. */
#ifndef TERMINAL_FALLBACK_H
#define TERMINAL_FALLBACK_H

#include <curses.h>
#include <stdio.h>

enum { FALLBACK_MANY_COLOURS, FALLBACK_FEW_COLOURS, FALLBACKS };

/* Opens curses on one of them; NULL: curses cannot take a description from the program. */
SCREEN *fallback_open(int which, FILE *output, FILE *input);

#endif
