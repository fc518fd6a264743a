/* Who waits for long work may stop it: the work asks every few milliseconds whether it is to go on, and says
 * how far it has come. A bar on standard error, a line of the laboratory, ^C, Esc and signals answer. */
#ifndef BASE_PATIENCE_H
#define BASE_PATIENCE_H

#include <stdbool.h>

typedef struct Patience {
    /* `share` of the work is done, from 0 to 1; false: give up. NULL: nobody is asked. */
    bool (*go_on)(double share, void *context);
    void *context;
} Patience;

static inline bool patience_lasts(const Patience *patience, double share)
{
    return !patience->go_on || patience->go_on(share, patience->context);
}

#endif
