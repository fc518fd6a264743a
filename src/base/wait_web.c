/* SPDX-License-Identifier: GPL-3.0-or-later */
/* wait_for() in a web page: the program is put to sleep as a whole (Asyncify) until the page has keys, has
 * taken output or has changed its size; what would come as a signal elsewhere is raised when it wakes. The
 * only files that are waited for are the terminal's. */
#include "base/signals.h"
#include "base/wait.h"

#include <errno.h>
#include <stdbool.h>
#include <stddef.h>

/* web/library.js: less than no milliseconds are without an end */
int web_wait(double milliseconds, int reads, int writes);
enum { WEB_READABLE = 1, WEB_WRITABLE = 2, WEB_RESIZED = 4, WEB_GONE = 8, WEB_STOPPED = 16 };

int wait_for(struct pollfd *files, int count, const struct timespec *timeout, const sigset_t *mask)
{
    const double milliseconds =
        timeout ? 1e3 * (double)timeout->tv_sec + 1e-6 * (double)timeout->tv_nsec : -1;
    bool reads = false, writes = false;
    int ready = 0;
    for (int i = 0; i < count; i++) {
        reads |= files[i].fd >= 0 && files[i].events & POLLIN;
        writes |= files[i].fd >= 0 && files[i].events & POLLOUT;
    }
    const int what = web_wait(milliseconds, reads, writes);
    sigset_t ours;
    if (mask)
        sigprocmask(SIG_SETMASK, mask, &ours);
    if (what & WEB_RESIZED)
        raise(SIGWINCH);
    if (what & WEB_GONE)
        raise(SIGHUP);
    if (what & WEB_STOPPED)
        signals_end(SIGINT); /* however often it is asked for: a page has no second one that ends at once */
    if (mask)
        sigprocmask(SIG_SETMASK, &ours, NULL);
    if (what & (WEB_RESIZED | WEB_GONE | WEB_STOPPED)) {
        errno = EINTR;
        return -1;
    }
    for (int i = 0; i < count; i++) {
        const int can = (what & WEB_READABLE ? POLLIN : 0) | (what & WEB_WRITABLE ? POLLOUT : 0);
        files[i].revents = (short)(files[i].fd < 0 ? 0 : files[i].events & can);
        ready += files[i].revents != 0;
    }
    return ready;
}

void wait_look(void (*look)(int))
{
    (void)look;
}

/* Which the C library of the page has not: no handler runs on another stack there. */
int sigaltstack(const stack_t *restrict stack, stack_t *restrict before)
{
    (void)stack;
    (void)before;
    errno = ENOSYS;
    return -1;
}
