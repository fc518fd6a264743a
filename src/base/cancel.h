/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Long work that can be watched and stopped: it calls back every few milliseconds with the share that is
 * done, and stops when the answer is false. Behind the callback are a progress bar on standard error, a line
 * of the laboratory, ^C, Esc and signals. */
#ifndef BASE_CANCEL_H
#define BASE_CANCEL_H

#include <stdbool.h>

typedef struct Cancel {
    /* `share` of the work is done, from 0 to 1; false: stop. NULL: it always goes on. */
    bool (*go_on)(double share, void *context);
    void *context;
} Cancel;

static inline bool cancel_requested(const Cancel *cancel, double share)
{
    return cancel->go_on && !cancel->go_on(share, cancel->context);
}

#endif
