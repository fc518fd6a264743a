/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What one combination of a sweep comes to: a number for each column that its run has, NAN for the others. */
#ifndef CLI_SWEEP_SWEEP_RESULT_H
#define CLI_SWEEP_SWEEP_RESULT_H

#include "export/export.h"

typedef enum ResultColumn {
    RESULT_FREQUENCY_MEASURED,
    RESULT_FREQUENCY_UNCERTAINTY,
    RESULT_FREQUENCY_R2,
    RESULT_FREQUENCY_PREDICTED,
    RESULT_FREQUENCY_EXACT,
    RESULT_FREQUENCY_ERROR,
    RESULT_PERIOD_MEASURED,
    RESULT_PERIOD_UNCERTAINTY,
    RESULT_PERIOD_R2,
    RESULT_PERIOD_PREDICTED,
    RESULT_PERIOD_THEORY,
    RESULT_PERIOD_ERROR,
    RESULT_PERIOD_EULER,
    RESULT_PERIOD_ERROR_EULER,
    RESULT_REAL_HEIGHT,
    RESULT_REAL_SPAN,
    RESULT_FIRST_BREAK,
    RESULT_CRACK_ANGLE,
    RESULT_CRACK_LENGTH,
    RESULT_TIP_SPEED,
    RESULT_TIPS,
    RESULT_BRANCHED,
    RESULT_BRANCH_X,
    RESULT_BRANCH_TIME,
    RESULT_HALF_ANGLE,
    RESULT_CRACK_COST,
    RESULT_BROKEN_BONDS,
    RESULT_ENERGY_LEFT,
    RESULT_STEPS,
    RESULT_WALL,
    RESULT_KEPT_MEASURED,
    RESULT_KEPT_PREDICTED,
    RESULT_MISTAKE,
    RESULT_COLUMNS
} ResultColumn;

typedef struct SweepResult {
    bool done;      /* else `failure` is the reason why there is no row */
    Status failure; /* of a row without a frequency: the reason */
    double cells[RESULT_COLUMNS];
} SweepResult;

const char *sweep_result_name(ResultColumn);

Quantity sweep_result_quantity(ResultColumn);

/* The row of a run that came to its end in `wall` seconds. */
void sweep_result_of(const RunSummary *, const Settings *, double wall, SweepResult *);

#endif
