/* The bar by the material point method: settings to simulation, exact and predicted answers beside. */
#include "lab/answers/bar_answers.h"

#include <math.h>
#include <stdio.h>

BarMesh bar_mesh_of(const Settings *settings, double dt)
{
    static const MeshAlgorithm algorithms[] = {
        [MPM_USF] = MESH_USF, [MPM_USL] = MESH_USL, [MPM_MUSL] = MESH_MUSL};
    static const MeshShape shapes[] = {[MPM_HAT] = MESH_HAT,
                                       [MPM_GIMP] = MESH_GIMP,
                                       [MPM_BSPLINE2] = MESH_BSPLINE2,
                                       [MPM_BSPLINE3] = MESH_BSPLINE3};
    const Transfer *mpm = &settings->mpm;
    return (BarMesh){.cell_size = settings->mesh.cell_size,
                     .particles_per_cell = settings->mesh.particles_per_cell,
                     .algorithm = algorithms[mpm->algorithm],
                     .shape = shapes[mpm->shape],
                     .apic = mpm->transfer == MPM_APIC,
                     .flip_fraction = mpm->flip_fraction,
                     .dt = dt};
}

BarDef bar_definition(const Settings *settings)
{
    return (BarDef){
        .length = settings->geometry.length,
        .youngs_modulus = settings->material.youngs_modulus,
        .density = settings->material.density,
        .supports = settings->supports.ends,
        .cell_size = settings->mesh.cell_size,
        .particles_per_cell = settings->mesh.particles_per_cell,
        .padding = settings->mesh.padding,
        .body_force = settings->loads.body_force,
        .traction = settings->loads.traction,
        .traction_layer = settings->loads.traction_layer,
        .algorithm = settings->mpm.algorithm,
        .shape = settings->mpm.shape,
        .transfer = settings->mpm.transfer,
        .flip_fraction = settings->mpm.flip_fraction,
        .courant = settings->time.courant,
    };
}

static Simulation *simulate(const Settings *settings, int threads, Status *status)
{
    (void)threads; /* a bar is too small to be shared */
    BarTheory theory;
    if (!bar_theory_of(settings, &theory, status))
        return NULL;
    BarDef def = bar_definition(settings);
    def.initial_velocity = bar_start;
    def.initial_context = &theory;
    return bar_create(&def, status);
}

static double predicted_frequency(const Settings *settings, const BarTheory *theory, double dt, int mode)
{
    const BarMesh mesh = bar_mesh_of(settings, dt);
    const Dispersion wave = bar_dispersion(theory, &mesh, bar_wave_number(theory, mode));
    return wave.known ? wave.frequency : NAN;
}

static double predicted_v_cm(References *refs, long step, double time, const double *row)
{
    (void)time, (void)row;
    return bar_predicted_centre_velocity(&refs->bar.theory, &refs->bar.mesh, step);
}

static bool prepare(References *refs, const Settings *settings, const Simulation *sim, Status *status)
{
    BarTheory theory;
    if (!bar_theory_of(settings, &theory, status))
        return false;
    refs->bar.mesh = bar_mesh_of(settings, sim->dt);
    const bool whole = bar_centre_velocity_is_predicted(&theory, &refs->bar.mesh);
    return bar_prepare(refs, settings, sim, predicted_frequency, whole ? predicted_v_cm : NULL,
                       "velocity of the centre of mass predicted for this mesh", status);
}

/* --- derived numbers and advice ------------------------------------------------------------------- */

static int derived(const Settings *settings, const Simulation *sim, Derived out[DERIVED_MAX])
{
    int n = 0;
    BarTheory theory;
    double dt = sim ? sim->dt : bar_time_step(settings);
    double cells = round(settings->geometry.length / settings->mesh.cell_size);
    if (!bar_theory_of(settings, &theory, NULL))
        return 0;
    BarMesh mesh = bar_mesh_of(settings, dt);
    derived_add(out, &n, "wave_speed", "wave speed c", "length/time", bar_wave_speed(&theory), false);
    derived_add(out, &n, "dt", "time step dt", "time", dt, false);
    bar_derived_wave(out, &n, settings, &theory, predicted_frequency, dt);
    int mode = bar_watched_mode(&theory);
    if (bar_watch(&theory).moving)
        derived_add(out, &n, "cells_per_wave", "cells/wave", "1",
                    2 * M_PI / bar_wave_number(&theory, mode > 0 ? mode : 1) / settings->mesh.cell_size,
                    false);
    derived_add(out, &n, "cells", "cells", "1", cells, true);
    derived_add(out, &n, "particles", "particles", "1", cells * settings->mesh.particles_per_cell, true);
    double largest = bar_endless_courant(&mesh);
    if (isfinite(largest))
        derived_add(out, &n, "largest_courant", "courant limit", "1", largest, false);
    return n;
}

static bool advice(const Settings *settings, char *text, size_t size, Status *status)
{
    BarTheory theory;
    if (!bar_theory_of(settings, &theory, status))
        return false;
    BarMesh mesh = bar_mesh_of(settings, bar_time_step(settings));
    double courant = settings->time.courant, largest = bar_endless_courant(&mesh);
    double warn = settings->mpm.algorithm == MPM_USL ? 0.7 : 1;
    if (courant > largest)
        return status_fail(status, STATUS_USAGE, "time.courant: %.6g is unstable on this mesh (at most %.5g)",
                           courant, largest);
    if (courant >= warn && isfinite(largest))
        snprintf(text, size, "courant %.4g is near the largest stable one, %.5g", courant, largest);
    else if (courant >= warn)
        snprintf(text, size, "courant %.4g may be unstable (no limit is known for this shape)", courant);
    return true;
}

const ProblemRow bar_mpm_row = {
    .problem = PROBLEM_BAR,
    .method = METHOD_MPM,
    .simulate = simulate,
    .prepare = prepare,
    .profile = bar_profile,
    .readout = bar_read_out,
    .derived = derived,
    .advice = advice,
};
