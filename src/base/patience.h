/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Long work that can be watched and stopped: it calls back every few milliseconds with the share that is
 * done, and stops when the answer is false. Behind the callback are a progress bar on standard error, a line
 * of the laboratory, ^C, Esc and signals. */
#ifndef BASE_PATIENCE_H
#define BASE_PATIENCE_H

#include <stdbool.h>

typedef struct Patience {
    /* `share` of the work is done, from 0 to 1; false: give up. NULL: it always goes on. */
    bool (*go_on)(double share, void *context);
    void *context;
} Patience;

static inline bool patience_lasts(const Patience *patience, double share)
{
    return !patience->go_on || patience->go_on(share, patience->context);
}

#endif
