#include "cli/verify_bar_run.h"

#include <math.h>

BarRun bar_run(int mode)
{
    return (BarRun){.def = bar_default(), .mode = mode, .velocity = 0.1};
}

BarTheory bar_run_theory(const BarRun *run)
{
    const BarDef *def = &run->def;
    return (BarTheory){.length = def->length,
                       .youngs_modulus = def->youngs_modulus,
                       .density = def->density,
                       .left_fixed = def->supports == BAR_FIXED_FREE || def->supports == BAR_FIXED_FIXED,
                       .right_fixed = def->supports == BAR_FREE_FIXED || def->supports == BAR_FIXED_FIXED,
                       .n_modes = 1,
                       .modes = {{run->mode, run->velocity}},
                       .body_force = def->body_force,
                       .traction = def->traction};
}

double bar_run_dt(const BarRun *run)
{
    return run->def.courant * run->def.cell_size / sqrt(run->def.youngs_modulus / run->def.density);
}

BarMesh bar_run_mesh(const BarRun *run)
{
    static const MeshAlgorithm algorithms[] = {
        [MPM_USF] = MESH_USF, [MPM_USL] = MESH_USL, [MPM_MUSL] = MESH_MUSL};
    static const MeshShape shapes[] = {[MPM_HAT] = MESH_HAT,
                                       [MPM_GIMP] = MESH_GIMP,
                                       [MPM_BSPLINE2] = MESH_BSPLINE2,
                                       [MPM_BSPLINE3] = MESH_BSPLINE3};
    return (BarMesh){.cell_size = run->def.cell_size,
                     .particles_per_cell = run->def.particles_per_cell,
                     .algorithm = algorithms[run->def.algorithm],
                     .shape = shapes[run->def.shape],
                     .apic = run->def.transfer == MPM_APIC,
                     .flip_fraction = run->def.flip_fraction,
                     .dt = bar_run_dt(run)};
}

double bar_run_exact(const BarRun *run)
{
    BarTheory bar = bar_run_theory(run);
    return bar_frequency(&bar, run->mode);
}

double bar_run_predicted(const BarRun *run)
{
    BarTheory bar = bar_run_theory(run);
    BarMesh mesh = bar_run_mesh(run);
    return bar_dispersion(&bar, &mesh, bar_wave_number(&bar, run->mode)).frequency;
}

static double initial_velocity(double x, const void *context)
{
    return bar_initial_velocity(context, x);
}

bool bar_run_trace(const BarRun *run, double end, Simulation **sim, Trace *trace, Status *status)
{
    *trace = (Trace){0};
    BarTheory bar = bar_run_theory(run);
    BarDef def = run->def;
    def.initial_velocity = initial_velocity, def.initial_context = &bar;
    *sim = bar_create(&def, status);
    return *sim && trace_take(trace, *sim, lround(end / (*sim)->dt), 1, status);
}
