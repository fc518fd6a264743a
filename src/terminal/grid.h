/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A canvas as ncurses shows it, and the bytes that come of it.
 *
 * ncurses writes without asking whether the terminal takes anything, and tries again for ever when it does
 * not. So here it writes into a file in memory; the bytes are taken from there and sent by somebody who can
 * wait for a signal meanwhile (terminal.c), who sets the modes of the line too. One grid can be open at a
 * time. */
#ifndef TERMINAL_GRID_H
#define TERMINAL_GRID_H

#include "base/status.h"
#include "picture/canvas.h"

#include <stdbool.h>
#include <stddef.h>

/* --- colours -------------------------------------------------------------------------------------- */

/* Attributes beside colour; they alone carry the meaning where there is no colour. */
enum { LOOK_BOLD = 1, LOOK_UNDERLINE = 2, LOOK_REVERSE = 4, LOOK_DIM = 8 };

enum { LOOK_DEFAULT = -1 }; /* the terminal's own colour */

typedef struct Look {
    int foreground, background; /* colour numbers, or LOOK_DEFAULT */
    unsigned attributes;
} Look;

/* `colours` is 256, 8 or 0; `back` is a cell's: 0, or 1 + the style whose colour is its background. */
Look theme_look(int colours, bool light, unsigned style, unsigned back);

/* Whether the terminal has a light ground: "light", "dark", or "auto" (NULL) by COLORFGBG (may be NULL). */
bool theme_is_light(const char *theme, const char *colorfgbg);

/* --- the grid ------------------------------------------------------------------------------------- */

typedef struct Grid {
    struct screen *curses;
    int memory;   /* what curses writes to, a descriptor */
    Canvas shown; /* what curses was given last; width 0: nothing */
    int colours;  /* 256, 8 or 0; NO_COLOR is honoured */
    bool light, utf8, mouse;
    bool synchronised;    /* the terminal holds a picture back until it is whole */
    char *bytes;          /* what is to be sent */
    size_t first, length; /* sent already, in all */
    size_t room;
    int why_lost;       /* errno of what kept bytes of a picture away; 0: nothing did */
    char farewell[256]; /* gives the screen back, whatever state it is in; a handler of signals may send it */
    size_t farewell_length;
} Grid;

/* `*stand_in`: the known terminal that an unknown TERM is treated as; NULL: it is known itself. Nothing is to
 * be sent yet. False: TERM cannot be drawn on; there is nothing to close then. */
bool grid_open(Grid *, const char *term, bool mouse, const char **stand_in, Status *);
void grid_close(Grid *); /* sends nothing: see grid_leave() */

void grid_enter(Grid *);                         /* takes the screen over */
void grid_leave(Grid *);                         /* gives it back */
void grid_resize(Grid *, int width, int height); /* the next one is drawn again */
void grid_redraw(Grid *);                        /* likewise */
void grid_show(Grid *, const Canvas *);          /* what lies beyond the size is left out */
void grid_ask(Grid *);         /* for a status report, which comes once all before is drawn */
void grid_synchronise(Grid *); /* the terminal told that it can */
const char *grid_bytes(const Grid *, size_t *left); /* what is to be sent; 0: nothing */
void grid_sent(Grid *, size_t count);               /* of these */

/* The glyph set for a name, a locale's character set and a TERM; false: the name is unknown. */
bool grid_choose_glyphs(const char *name, const char *codeset, const char *term, Glyphs *);

#endif
