/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The points of the study of convergence that a view shows, worked out one after the other while nothing else
 * is to be done. */
#ifndef LAB_REFINING_H
#define LAB_REFINING_H

#include "answers/convergence.h"

typedef struct Laboratory Laboratory;

typedef struct Refining {
    Convergence convergence;         /* behind screen.convergence */
    const ConvergenceStudy *stopped; /* by hand, until a view is asked for again; NULL: none */
} Refining;

/* Whether a study on screen lacks points and nothing else goes on. */
bool refining_is_due(const Laboratory *);

/* The next point. A key that waits is let through, and the point begun again afterwards. */
void refining_work(Laboratory *);

/* False: there is nothing to stop. */
bool refining_stop(Laboratory *);

#endif
