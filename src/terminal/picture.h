/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A canvas as ncurses shows it, and the bytes that come of it.
 *
 * ncurses writes without asking whether the terminal takes anything, and tries again for ever when it does
 * not. So here it writes into a file in memory; the bytes are taken from there and sent by somebody who can
 * wait for a signal meanwhile (terminal.c), who sets the modes of the line too. One picture can be open at a
 * time. */
#ifndef TUI_PICTURE_H
#define TUI_PICTURE_H

#include "base/status.h"
#include "picture/canvas.h"
#include "panes/screen.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct Picture {
    struct screen *curses;
    struct _win_st *keys; /* where keys are read from: a pad, for to read from a window draws it */
    int memory;           /* what curses writes to, a descriptor */
    Canvas shown;         /* what curses was given last; width 0: nothing */
    int colours;          /* 256, 8 or 0; NO_COLOR is honoured */
    bool light, utf8, mouse;
    bool synchronised;    /* the terminal holds a picture back until it is whole */
    char *bytes;          /* what is to be sent */
    size_t first, length; /* sent already, in all */
    size_t room;
    char farewell[256]; /* gives the screen back, whatever state it is in; a handler of signals may send it */
    size_t farewell_length;
} Picture;

enum { PICTURE_NO_KEYS = -1 };

/* Keys are read from the descriptor `input`; PICTURE_NO_KEYS: there are none. `*stand_in`: the known
 * terminal that an unknown TERM is treated as; NULL: it is known itself. Nothing is to be sent yet. False:
 * TERM cannot be drawn on; there is nothing to close then. */
bool picture_open(Picture *, const char *term, int input, bool mouse, const char **stand_in, Status *);
void picture_close(Picture *); /* sends nothing: see picture_leave() */

void picture_enter(Picture *);                            /* takes the screen over */
void picture_leave(Picture *);                            /* gives it back */
void picture_resize(Picture *, int width, int height);    /* the next one is drawn anew */
void picture_redraw(Picture *);                           /* likewise */
void picture_show(Picture *, const Canvas *);             /* what lies beyond the size is left out */
void picture_synchronise(Picture *);                      /* the terminal told that it can */
const char *picture_bytes(const Picture *, size_t *left); /* what is to be sent; 0: nothing */
void picture_sent(Picture *, size_t count);               /* of these */

/* The glyph set for a name, a locale's character set and a TERM; false: the name is unknown. */
bool picture_choose_glyphs(const char *name, const char *codeset, const char *term, Glyphs *);

#endif
