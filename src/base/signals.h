/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Signals that would end the process: each is noted, and loops that compute or wait end in good order.
 *
 * Taken are all that end a process by default and are sent from outside (SIGHUP, SIGTERM, SIGUSR1, SIGXCPU,
 * the real-time ones, ...). Left alone are those that the process was started to ignore (nohup), those that
 * have a handler already (a profiler), and faults (SIGSEGV, ...), after which nothing can go on. SIGPIPE
 * and SIGXFSZ of an own write do not end the program: the write fails and is reported.
 *
 * No signal is ignored twice: one that comes half a second or more behind the first, which nothing has looked
 * at or which takes long to answer, ends the process. (Shell, terminal and kernel may each say once that it
 * ends; these come together.) */
#ifndef BASE_SIGNALS_H
#define BASE_SIGNALS_H

#include <signal.h>

void signals_catch(void);

/* What is done before a signal ends the process at once, by default or a fault: only what a handler may. */
void signals_before_end(void (*clean)(void));

/* Ends the process by a signal, in whose handler it is called, after what is done before. */
void signals_end_at_once(int number);

/* What is done before a second one ends the process, NULL: nothing. It may call only what a handler may. */
void signals_farewell(void (*)(void));

/* The first that came since signals_catch(); 0: none. */
int signals_ended_by(void);

/* As if none had come: it has ended what it was meant to end, and the program goes on. */
void signals_forget(void);

/* As if this one had come: the terminal is gone. */
void signals_end(int number);

/* From here on none of them comes but while `before` (the mask that was in force) is in force again, as
 * during wait_for(): so none is lost between looking and sleeping. */
void signals_block(sigset_t *before);

/* As it was before signals_catch(). After one came only SIGINT and SIGQUIT end the process at once: shell,
 * terminal and kernel each say that it ends, and the second must not cut off what is still to be written. */
void signals_release(void);

#endif
