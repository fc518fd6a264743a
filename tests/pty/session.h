/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The real program on a real terminal: a pseudo terminal whose other end is libvterm. Nothing here sleeps:
 * the program tells through a pipe when it has drawn, and whether it now waits for a key. */
#ifndef TESTS_PTY_SESSION_H
#define TESTS_PTY_SESSION_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>
#include <termios.h>

#include <vterm.h>

typedef struct Session {
    pid_t child;
    int master, slave; /* the slave stays open, so that its modes can be read when the program is gone */
    int frames;        /* the pipe of "frame N [idle]" */
    int rows, columns;
    VTerm *vterm;
    VTermScreen *screen;
    bool ignored; /* see session_ignore() */
    bool mute;    /* the terminal answers nothing that it is asked */
    bool alternate, cursor_visible;
    int mouse;   /* what the mouse reports: VTERM_PROP_MOUSE_NONE, _DRAG, ... */
    char *bytes; /* all that the program wrote */
    size_t n_bytes, room;
    struct termios modes; /* at the start */
} Session;

/* Starts a command (NULL ends the list) in a terminal of this size. `environment` holds "NAME=VALUE" or
 * "NAME" (to take it away), ended by NULL; may be NULL itself. */
void session_open(Session *, int columns, int rows, const char *const *environment,
                  const char *const *command);

/* The same with the laboratory, opened paused on mode1, on the full sheet. */
void session_open_paused(Session *, int columns, int rows, const char *const *environment);

void session_close(Session *); /* kills what still runs */

void session_send(Session *, const char *bytes);
void session_resize(Session *, int columns, int rows);

/* Reads until the program has drawn and sleeps. Fails the test when nothing comes for a minute. */
void session_idle(Session *);

/* The same; false: the program is gone. */
bool session_idle_or_gone(Session *);

/* Reads until at least one more picture has been drawn. */
void session_frame(Session *);

/* Reads as a line of so many bytes a second does, until a text is on the screen (NULL: to the end of the
 * time). Returns how many bytes that took. */
size_t session_trickle(Session *, const char *text, double rate, double seconds);

/* Sends keys and waits until they have been answered. */
void session_keys(Session *, const char *bytes);

/* Reads until a text is on the screen; fails the test when nothing comes for a minute. */
void session_wait_for(Session *, const char *text);

void session_hang_up(Session *); /* the terminal goes away */
void session_ignore(Session *);  /* nothing that the program writes is read from now on */

/* Waits until the program is gone, and leaves what it wrote last to session_exit(). */
void session_gone(Session *);

/* Waits for the end; the exit status, or 128 + n after signal n as a shell would say. */
int session_exit(Session *);

/* Whether a text is on the screen, within a row. */
bool session_shows(Session *, const char *text);
const char *session_row(Session *, int row);

/* Whether the program wrote a text, and whether it wrote that behind what it wrote of the other one. */
bool session_wrote(const Session *, const char *text);
bool session_wrote_last(const Session *, const char *text, const char *other);

/* Fails the test unless modes, mouse, cursor and screen are as they were before the program came. */
void session_check_restored(Session *);

#endif
