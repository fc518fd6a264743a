/* One mode of paper M's bar, by the engine and by theory. */
#ifndef CLI_VERIFY_BAR_RUN_H
#define CLI_VERIFY_BAR_RUN_H

#include "cli/verify_trace.h"
#include "physics/mpm/bar.h"
#include "theory/bar.h"

typedef struct BarRun {
    BarDef def;
    int mode;
    double velocity; /* v0 */
} BarRun;

/* The paper's mesh, mode n, v0 = 0.1. */
BarRun bar_run(int mode);

BarTheory bar_run_theory(const BarRun *run);
BarMesh bar_run_mesh(const BarRun *run);
double bar_run_dt(const BarRun *run);

/* omega of the continuum, Omega of the mesh (NAN: not known). */
double bar_run_exact(const BarRun *run);
double bar_run_predicted(const BarRun *run);

/* The series from 0 to `end`, every step; *sim must be destroyed and the trace freed by the caller, whatever
 * is returned. */
bool bar_run_trace(const BarRun *run, double end, Simulation **sim, Trace *trace, Status *status);

#endif
