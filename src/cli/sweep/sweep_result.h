/* What one combination of a sweep comes to: a number for each column that its run has, NAN for the others. */
#ifndef CLI_SWEEP_RESULT_H
#define CLI_SWEEP_RESULT_H

#include "lab/export/export.h"

typedef enum ResultColumn {
    RESULT_MEASURED,
    RESULT_PREDICTED,
    RESULT_EXACT,
    RESULT_ERROR,
    RESULT_EXACT_EULER,
    RESULT_ERROR_EULER,
    RESULT_REAL_HEIGHT,
    RESULT_REAL_SPAN,
    RESULT_BROKEN_BONDS,
    RESULT_CRACK_LENGTH,
    RESULT_ENERGY_LEFT,
    RESULT_STEPS,
    RESULT_WALL,
    RESULT_COLUMNS
} ResultColumn;

typedef struct SweepResult {
    bool done;      /* else the failure says why there is no row */
    Status failure; /* of a row without a frequency its text says why */
    double cells[RESULT_COLUMNS];
} SweepResult;

const char *result_name(ResultColumn);

/* The column as a problem's table has it. */
Quantity result_quantity(ResultColumn, const Problem *);

/* The row of a run that came to its end in `wall` seconds. */
void result_of(const RunSummary *, const Settings *, double wall, SweepResult *);

#endif
