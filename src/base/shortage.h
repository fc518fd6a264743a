/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers that cannot be worked out are left out; where that is for want of memory, or because somebody
 * cancelled, errno is ENOMEM or ECANCELED at the end. Who wants to know begins with 0, and leaves what an
 * outer question has found:
 *
 *     const int before = shortage_begin();
 *     ...
 *     const bool short_of_memory = errno == ENOMEM;
 *     shortage_end(before);
 */
#ifndef BASE_SHORTAGE_H
#define BASE_SHORTAGE_H

#include <errno.h>

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
