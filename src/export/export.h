/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run as files: CSV tables with their .csv.ini beside. Column contract: manual page matvib(1).
 *
 * Files are written whole or not at all: a temporary file in the same folder, fsync, rename. */
#ifndef EXPORT_EXPORT_H
#define EXPORT_EXPORT_H

#include "export/vtk.h"
#include "base/output.h"
#include "base/status.h"
#include "answers/run_summary.h"
#include "scenario/assignment.h"

typedef enum Dialect { DIALECT_COMMA, DIALECT_SEMICOLON } Dialect;

/* What a run writes; a NULL name is not written, "-" is standard output. */
typedef struct Outputs {
    const char *series, *particles, *nodes, *bonds, *vtk;
    long stages[2]; /* of these steps, the first one of a run is 1: tables after each stage; 0: at frames */
    int stage;      /* after so many stages of them alone; 0: after each */
    Dialect dialect;
    VtkData vtk_data;
    Asker asker; /* on whose behalf */
    bool force;  /* existing files are replaced; else they are refused before the run starts */
} Outputs;

/* Whether the series has a column, the i-th of the references', by output.columns: step and time always. */
bool export_writes(const Settings *, const Simulation *, int i, const char *column);

/* Called now and then with the share done in [0, 1]; returns false to stop the run (^C). May be NULL. */
typedef bool (*RunProgress)(double share, void *context);

/* Runs settings from 0 to the end without keeping more than it must and writes the outputs as it goes; the
 * laboratory's export and `matvib run` are this function, so they write the same bytes. A run that fails on
 * its way still writes everything up to there, then returns false with the failure. */
bool export_run(const Settings *, const Outputs *, int threads, RunProgress, void *context, RunSummary *,
                Status *);

#endif
