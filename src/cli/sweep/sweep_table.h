/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of a sweep as a table: the varied keys, then the results. */
#ifndef CLI_SWEEP_SWEEP_TABLE_H
#define CLI_SWEEP_SWEEP_TABLE_H

#include "cli/sweep/sweep_plan.h"
#include "cli/sweep/sweep_result.h"

typedef struct SweepTable {
    const SweepPlan *plan;
    const Problem *problem;
    const double *keys; /* plan->n_keys for each combination: the value, or the index of a choice */
    const SweepResult *results;
    bool has[RESULT_COLUMNS]; /* columns that are written */
    int rows;                 /* combinations with a result */
} SweepTable;

/* A column is written if a row has a number in it; a row that has none leaves its cell empty. */
void sweep_table_choose_columns(SweepTable *);

void sweep_table_write_csv(const SweepTable *, Dialect, FILE *);

/* Aligned for reading: six digits, choices as words. */
void sweep_table_write_text(const SweepTable *, FILE *);

/* A line for each column: name, unit, meaning; what the indices of choices stand for. */
void sweep_table_describe(const SweepTable *, FILE *);

#endif
