/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The real terminal: signals, modes, bytes in and out; picture.h draws, keys.h reads.
 *
 * One can be open at a time. While it is open, SIGWINCH, SIGCONT, SIGTSTP and the signals that ask for an end
 * (base/signals.h) are blocked and come through only in terminal_wait() and terminal_signal(); so none is
 * lost between looking and sleeping. Nothing here waits for a terminal that does not read: what it does not
 * take is sent later, and on leaving given up after a third of a second without a byte. On a crash, and when
 * a library calls exit(), the terminal is restored too. */
#ifndef TERMINAL_TERMINAL_H
#define TERMINAL_TERMINAL_H

#include "base/status.h"
#include "lab/session/laboratory_main.h"
#include "lab/session/session.h"
#include "picture/canvas.h"
#include "terminal/keys.h"

typedef struct Terminal Terminal;

/* Takes over standard input and output. NULL: they are not a terminal, or one that
 * cannot place its cursor. */
Terminal *terminal_open(const LaboratoryOptions *, Status *);
void terminal_close(Terminal *); /* as it was before; NULL is allowed */

void terminal_size(const Terminal *, int *width, int *height);

typedef struct TerminalLook {
    Glyphs glyphs;
    int colours; /* 256, 8 or 0 */
    bool light, utf8;
    const char *stand_in; /* the known terminal as which one with an unknown TERM is treated; NULL: none */
} TerminalLook;
TerminalLook terminal_look(const Terminal *);

/* Shows a canvas: what differs from what was shown last is written; nothing, if nothing does. */
void terminal_show(Terminal *, const Canvas *);

/* Whether the terminal has not yet taken all of what was shown, or not yet answered that it has drawn it: the
 * next picture has to wait, or pictures queue in a slow line and a key is seen after all of them. A terminal
 * that answers no status report is waited for once, for a second. */
bool terminal_is_behind(const Terminal *);

/* The next show draws everything again. */
void terminal_redraw(Terminal *);

/* Sleeps until a key or a signal comes, the terminal takes output again, or the time is over; seconds < 0:
 * without limit, 0: not at all. Once a signal asked for an end it does not sleep. */
void terminal_wait(Terminal *, double seconds);

/* Whether there is something to read at once. */
bool terminal_has_input(const Terminal *);

/* The next key that has come in; false: none. */
bool terminal_key(Terminal *, Key *);

/* Whether the size has changed since the last call (the new one is in force then). */
bool terminal_resized(Terminal *);

/* The signal that asks for an end, one that came just now too; 0: none. */
int terminal_signal(const Terminal *);

/* Stops the program as the shell's job control wants it, and comes back on fg. */
void terminal_suspend(Terminal *);

/* --- the loop ------------------------------------------------------------------------------------- */

/* Returns the exit status: 0, 128 + n after signal n, or the status's code.
 *
 * For tests: when the environment names a file descriptor in MATVIB_FRAME_FD, a line "frame N" is written to
 * it after each picture, with " idle" behind when the loop now sleeps until something comes. */
int loop_run(const LaboratoryOptions *, const Session *replay, Session *recording, Status *);

#endif
