/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a sweep runs: keys with their values, and the combinations that they make.
 *
 * Every --vary is an axis of its own, and the combinations are the product of the axes; a --with changes
 * value by value together with the --vary before it. The last axis runs fastest, so the order of the
 * combinations, and of the rows, is that of nested loops read from left to right. */
#ifndef CLI_SWEEP_SWEEP_PLAN_H
#define CLI_SWEEP_SWEEP_PLAN_H

#include "base/status.h"
#include "cli/options.h"
#include "scenario/parameters.h"

#include <stdio.h>

enum { SWEEP_COMBINATIONS_MAX = 100000 };

typedef struct SweepKey {
    const char *origin; /* "--vary" or "--with" */
    char key[KEY_MAX];
    const Parameter *parameter; /* NULL: one value of a row of a plate */
    char (*values)[VALUE_MAX];  /* as a scenario file would have them */
    int count;
    int axis; /* the keys of one axis change together */
} SweepKey;

typedef struct SweepPlan {
    SweepKey keys[AXES_MAX];
    int n_keys, n_axes;
    int n_combinations;
} SweepPlan;

/* From --vary and --with. False: the status says which is wrong and what is allowed; nothing is kept. */
bool sweep_plan_read(SweepPlan *, const Options *, Status *);
void sweep_plan_free(SweepPlan *);

/* The settings of one combination, checked. With `with_steps` --steps is applied too, for which the time step
 * has to be found. */
bool sweep_plan_load(const SweepPlan *, const Options *, int combination, bool with_steps, Settings *,
                     Status *);

/* "mesh.cell_size=1 mpm.algorithm=usl" */
void sweep_plan_describe(const SweepPlan *, int combination, char *out, size_t size);

/* What one combination of a sweep comes to: a number for each column that its run has, NAN for the others. */

#define COLUMN(name, unit, number, meaning) RESULT_##name,
typedef enum ResultColumn {
#include "cli/sweep/sweep_columns.inc"
    RESULT_COLUMNS
} ResultColumn;
#undef COLUMN

extern const Quantity sweep_columns[RESULT_COLUMNS];

typedef struct SweepResult {
    bool done;      /* else `failure` is the reason why there is no row */
    Status failure; /* of a row without a frequency: the reason */
    double cells[RESULT_COLUMNS];
} SweepResult;

/* The row of a run that came to its end in `wall` seconds. */
void sweep_result_of(const RunSummary *, const Settings *, double wall, SweepResult *);

#endif
