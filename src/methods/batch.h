/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whole steps in batches, for all methods, and the energy that may stop a run of the material point methods.
 *
 * The energy is looked at behind steps that are multiples of BATCH_STEPS, so that the outcome does not depend
 * on how a run is cut; batches end there. A batch that fails is taken back and done again step by step, so
 * that the run stands before the step that failed. */
#ifndef METHODS_BATCH_H
#define METHODS_BATCH_H

#include "methods/method.h"

enum { BATCH_STEPS = 64 };

/* What is remembered of the energy; part of a method's state. */
typedef struct Growth {
    double peak_work; /* largest magnitude of the work seen */
    int level;        /* how many thresholds of growth were reported */
} Growth;

/* Of the step under way, J or the problem's unit. Energy and work are asked for only where they are looked
 * at. */
typedef struct GrowthNow {
    double start; /* energy at t = 0 */
    double (*energy)(const Simulation *);
    double work;
    const char *unit;   /* behind the time: " s", or "" */
    const char *advice; /* what else may help: "another algorithm" */
} GrowthNow;

/* Fails where energy > 1e4 (E_0 + max |work|), and reports growth on the way. */
bool batch_check_energy(Simulation *, Growth *, const GrowthNow *, Status *);

/* An event of the step under way, which is not counted yet; and its end by what became of a particle. */
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
