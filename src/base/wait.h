/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sleeping until a file is ready or a signal comes: ppoll() where there is one, pselect() elsewhere. */
#ifndef BASE_WAIT_H
#define BASE_WAIT_H

#include <poll.h>
#include <signal.h>
#include <time.h>

/* As ppoll(): `timeout` NULL is without an end; `mask` is in force while sleeping, NULL leaves the one that
 * is. Returns how many of the files have something in `revents`, 0 when the time is over, -1 with errno after
 * a signal or an error. A negative descriptor is passed over. Descriptors must be less than FD_SETSIZE. */
int wait_for(struct pollfd *files, int count, const struct timespec *timeout, const sigset_t *mask);

/* From half a second on, and each half second, `look` is called as a handler of SIGURG; NULL: no more. Where
 * there are no timers, as in a web page, never. */
void wait_look(void (*look)(int number));

/* The clock of those who wait for something, or say how long it took: seconds, only ever growing. */

static inline double clock_seconds(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

#endif
