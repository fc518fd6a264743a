/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elastic bodies in a box, by the material point method: derived numbers, the row of the problem. */
#include "problems/bodies_answers.h"
#include "problems/solver.h"
#include "scenario/parameters.h"

static int derived(const Settings *settings, const Simulation *sim, Derived out[DERIVED_MAX])
{
    const MpmDef def = mpm_definition(settings, 1);
    int n = 0;
    derived_add(out, &n, "dt", "time step dt", "time", mpm_time_step(&def), false);
    derived_add(out, &n, "wave_speed", "wave speed c", "length/time",
                def.courant * def.cell_size / mpm_time_step(&def), false);
    if (sim) {
        derived_add(out, &n, "particles", "particles", "1", (double)sim->counts[0], true);
        derived_add(out, &n, "nodes", "nodes", "1", (double)sim->counts[1], true);
    }
    return n;
}

static bool prepare(References *refs, const Settings *settings, const Simulation *sim, Status *status)
{
    const MpmDef def = mpm_definition(settings, 1);
    return bodies_prepare(refs, &def, sim, status);
}

/* What the exact answers account for; rigid motion does not ask how a body is computed. */
static const char *const of_motion[] = {"domain.width",
                                        "domain.height",
                                        "domain.left",
                                        "domain.right",
                                        "domain.bottom",
                                        "domain.top",
                                        "domain.wall_friction",
                                        "material.youngs_modulus",
                                        "material.poisson",
                                        "material.density",
                                        "material.law",
                                        "material.plane",
                                        "mesh.cell_size",
                                        "mesh.particles_per_cell",
                                        "mpm.algorithm",
                                        "mpm.shape",
                                        "mpm.transfer",
                                        "mpm.flip_fraction",
                                        "mpm.rotation",
                                        "mpm.body_mistake",
                                        "contact.fields",
                                        "contact.friction",
                                        "contact.gap",
                                        "load.gravity",
                                        "load.incline",
                                        "time.courant",
                                        "time.end",
                                        NULL};
static const char *const changes[] = {"mpm.algorithm", "mpm.transfer", "mpm.flip_fraction", NULL};

static const Solver bodies_by_mpm = {
    .method = METHOD_MPM,
    .check = mpm_check_settings,
    .simulate = mpm_simulate,
    .derived = derived,
    .validity = {[REFERENCE_EXACT] = {of_motion, changes}},
    .prepare = prepare,
    .findings = bodies_findings,
};

static const ParameterUse uses[] = {
    {USE("domain.width", 1)},
    {USE("domain.height", 1)},
    {USE("material.youngs_modulus", 1000)},
    {USE("material.poisson", 0.3)},
    {USE("material.density", 1000)},
    {USE("mesh.cell_size", 0.05), .help = "size dx of a cell; the box is a whole number of cells each way"},
    {USE("mesh.particles_per_cell", 2), .help = "particles along each side of a cell at t = 0: P x P in all"},
    {USE("mpm.shape", MPM_GIMP), .choices = 3, .others = "is for bars"},
    {USE("mpm.transfer", MPM_FLIP), .choices = 2, .others = "is for bars"},
    {USE("damping.rate", 0), .methods = BY_MPM, .help = "rate at which the momentum of the nodes fades"},
    {USE("time.courant", 0.2)},
    {USE("time.end", 4)},
};

const Problem problem_bodies = {
    .word = "bodies",
    .title = "elastic bodies that move, turn, bend and meet",
    .body = "bodies",
    .about = "energy_change",
    .concerns = CONCERN_BODIES,
    USES(uses),
    SOLVED_BY(&bodies_by_mpm),
    IN_OWN_UNITS,
};
