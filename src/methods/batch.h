/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whole steps in batches, for all methods. They end behind steps that are multiples of BATCH_STEPS, where a
 * method may look at its energy, so that the outcome does not depend on how a run is cut. A batch that fails
 * is taken back and done again step by step, so that the run stands before the step that failed. */
#ifndef METHODS_BATCH_H
#define METHODS_BATCH_H

#include "methods/method.h"

enum { BATCH_STEPS = 64 };

/* "in step 13, t = 1.3" for the step under way, which is not counted yet; `unit`: " s", or "". An event of
 * it, and its end by what became of a particle. */
enum { BATCH_WORDS_MAX = 80 };
void batch_step_words(const Simulation *, const char *unit, char out[BATCH_WORDS_MAX]);
void batch_report(Simulation *, EventKind, const char *text);
bool batch_fail_particle(Simulation *, Status *, int particle, const char *what, const char *unit);

typedef struct Batches {
    /* Copies what lasts from step to step aside, and puts it back. */
    void (*keep)(Simulation *);
    void (*put_back)(Simulation *);

    /* Does whole steps with rows or without (method.h), fewer where the run comes to rest; on failure the
     * state is anything. */
    bool (*steps)(Simulation *, long count, double *rows, Status *);
} Batches;

/* Method.steps. */
bool batch_steps(Simulation *, const Batches *, long count, double *rows, long *done, Status *);

#endif
