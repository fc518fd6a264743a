/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A terminal whose keyboard is a pipe: bytes in, keys out, with curses in between and no terminal at all. */
#ifndef TESTS_TUI_KEYBOARD_H
#define TESTS_TUI_KEYBOARD_H

#include "terminal/keys.h"
#include "terminal/grid.h"

typedef struct Keyboard {
    Grid grid;
    KeyReader reader;
    int ends[2];
    double time; /* s; the test's own clock */
} Keyboard;

bool keyboard_open(Keyboard *, const char *term);
void keyboard_close(Keyboard *);
bool keyboard_type(const Keyboard *, const void *bytes, size_t count); /* a few kilobytes fit */
bool keyboard_next(Keyboard *, Key *);

#endif
