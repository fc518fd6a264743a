#include "cli/verify/verify_bar_run.h"

#include "lab/problems/bar_theory.h"
#include "lab/settings/parameters.h"
#include "lab/problems/references.h"

#include <math.h>

Settings bar_run(int mode)
{
    Settings run;
    settings_default(&run, &bar_problem);
    run.start.mode = mode, run.start.velocity = 0.1;
    return run;
}

BarTheory bar_run_theory(const Settings *run)
{
    BarTheory theory;
    bar_theory_of(run, &theory, NULL); /* there are no overtones that could not be read */
    return theory;
}

BarMesh bar_run_mesh(const Settings *run)
{
    return bar_mesh_of(run, bar_time_step(run));
}

double bar_run_exact(const Settings *run)
{
    BarTheory bar = bar_run_theory(run);
    return bar_frequency(&bar, run->start.mode);
}

double bar_run_predicted(const Settings *run)
{
    BarTheory bar = bar_run_theory(run);
    BarMesh mesh = bar_run_mesh(run);
    return bar_dispersion(&bar, &mesh, bar_wave_number(&bar, run->start.mode)).frequency;
}

bool bar_run_trace(const Settings *run, double end, Simulation **sim, Trace *trace, Status *status)
{
    *trace = (Trace){0};
    *sim = problem_simulate(run, 1, status);
    return *sim && trace_take(trace, *sim, lround(end / (*sim)->dt), 1, status);
}
