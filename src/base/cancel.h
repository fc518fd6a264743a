/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Long work that can be watched and stopped: it calls back every few milliseconds with the share that is
 * done, and stops when the answer is false. Behind the callback are a progress bar on standard error, a line
 * of the laboratory, ^C, Esc and signals. */
#ifndef BASE_CANCEL_H
#define BASE_CANCEL_H

#include <stdbool.h>
#include <errno.h>

typedef struct Cancel {
    /* `share` of the work is done, from 0 to 1; false: stop. NULL: it always goes on. */
    bool (*go_on)(double share, void *context);
    void *context;
} Cancel;

static inline bool cancel_requested(const Cancel *cancel, double share)
{
    return cancel->go_on && !cancel->go_on(share, cancel->context);
}

/* Numbers that cannot be worked out are left out; where that is for want of memory, or because somebody
 * cancelled, errno is ENOMEM or ECANCELED at the end. Who wants to know begins with 0, and leaves what an
 * outer question has found:
 *
 *     const int before = shortage_begin();
 *     ...
 *     const bool short_of_memory = errno == ENOMEM;
 *     shortage_end(before);
 */

static inline int shortage_begin(void)
{
    const int before = errno;
    errno = 0;
    return before;
}

/* A shortage that was found stays, for the outer question too. */
static inline void shortage_end(int before)
{
    if (errno != ENOMEM && errno != ECANCELED)
        errno = before;
}

#endif
