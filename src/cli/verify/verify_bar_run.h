/* One mode of paper M's bar, by the engine and by theory. */
#ifndef CLI_VERIFY_BAR_RUN_H
#define CLI_VERIFY_BAR_RUN_H

#include "cli/verify/verify_trace.h"
#include "lab/settings/settings.h"
#include "theory/bar.h"

/* The paper's mesh, mode n, v0 = 0.1. */
Settings bar_run(int mode);

BarTheory bar_run_theory(const Settings *run);
BarMesh bar_run_mesh(const Settings *run);

/* omega of the continuum, Omega of the mesh (NAN: not known). */
double bar_run_exact(const Settings *run);
double bar_run_predicted(const Settings *run);

/* The series from 0 to `end`, every step; *sim must be destroyed and the trace freed by the caller, whatever
 * is returned. */
bool bar_run_trace(const Settings *run, double end, Simulation **sim, Trace *trace, Status *status);

#endif
