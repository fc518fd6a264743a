/* SPDX-License-Identifier: GPL-3.0-or-later */
/* ppoll() where the system has it; elsewhere the same by pselect(). */
#include "base/wait.h"

#include <stdbool.h>
#include <unistd.h>

void wait_look(void (*look)(int))
{
#if defined _POSIX_TIMERS && _POSIX_TIMERS > 0
    static timer_t timer;
    static bool made;
    struct sigevent event = {.sigev_notify = SIGEV_SIGNAL, .sigev_signo = SIGURG};
    const struct timespec half = {.tv_nsec = 500000000};
    const struct itimerspec each = {half, half}, never = {{0, 0}, {0, 0}};
    struct sigaction action = {.sa_handler = look, .sa_flags = SA_RESTART};
    made = made || timer_create(CLOCK_MONOTONIC, &event, &timer) == 0;
    if (look)
        sigaction(SIGURG, &action, NULL);
    if (made)
        timer_settime(timer, 0, look ? &each : &never, NULL);
#else
    (void)look;
#endif
}

#ifdef HAVE_PPOLL

int wait_for(struct pollfd *files, int count, const struct timespec *timeout, const sigset_t *mask)
{
    return ppoll(files, (nfds_t)count, timeout, mask);
}

#else

#include <errno.h>
#include <sys/select.h>

int wait_for(struct pollfd *files, int count, const struct timespec *timeout, const sigset_t *mask)
{
    fd_set readable, writable;
    int above = 0, ready = 0;
    FD_ZERO(&readable);
    FD_ZERO(&writable);
    for (int i = 0; i < count; i++) {
        files[i].revents = 0;
        if (files[i].fd < 0)
            continue;
        if (files[i].fd >= FD_SETSIZE) {
            errno = EINVAL;
            return -1;
        }
        if (files[i].events & POLLIN)
            FD_SET(files[i].fd, &readable);
        if (files[i].events & POLLOUT)
            FD_SET(files[i].fd, &writable);
        above = files[i].fd >= above ? files[i].fd + 1 : above;
    }
    const int result = pselect(above, &readable, &writable, NULL, timeout, mask);
    for (int i = 0; i < count && result > 0; i++) {
        if (files[i].fd < 0)
            continue;
        /* a hangup counts as readable: the next read reports it */
        files[i].revents = (short)((FD_ISSET(files[i].fd, &readable) ? POLLIN : 0) |
                                   (FD_ISSET(files[i].fd, &writable) ? POLLOUT : 0));
        ready += files[i].revents != 0;
    }
    return result > 0 ? ready : result;
}

#endif
