/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The beams in the plane, supported, leaving a channel, notched and bent; and the plate. */
#include "problems/solver.h"
#include "scenario/parameters.h"

#define BEAM_CONCERNS (CONCERN_BEAM | CONCERN_LATTICE | CONCERN_BREAKING | CONCERN_STEP | CONCERN_DAMPING)
/* A beam of aluminium that the material point method solves too, in cells. */
#define PLANE_CONCERNS (CONCERN_METHODS | CONCERN_PLANE)
#define PLANE_USES                                                                                           \
    {USE("beam.height", 0.005)}, {USE("beam.thickness", 0.005)}, {USE("beam.youngs_modulus", 71e9)},         \
        {USE("beam.density", 2700)}, {USE("pd.spacing", 0.25e-3)}, {USE("pd.horizon", 1e-3)},                \
        {USE("scenario.method", METHOD_PD)},                                                                 \
        {USE("mesh.cell_size", 0.5e-3), .methods = BY_MPM,                                                   \
         .help = "size dx of a cell; whole numbers of cells in "                                             \
                 "length and channel, an even one in height"},                                               \
        {USE("mesh.particles_per_cell", 2), .methods = BY_MPM,                                               \
         .help = "particles along each side of a cell at t = 0: P x P in all"},                              \
        {USE("mesh.padding", 2), .help = "empty cells all around the beam"},                                 \
        {USE("mpm.shape", MPM_GIMP), .choices = 3, .others = "is for bars"},                                 \
        {USE("mpm.rotation", ROTATION_NONE)},                                                                \
    {                                                                                                        \
        USE("time.courant", 0.5), .methods = BY_MPM                                                          \
    }
#define BEAM_COMMON                                                                                          \
    .body = "beam", .answer = "beam theory", .si = true, .unit_of_time = "s", .shown_time = 1e-3,            \
    .shown_time_unit = " ms"

static const ParameterUse uses_supported[] = {
    {USE("beam.length", 0.1)},
    {USE("initial.amplitude", 3e-6)},
    {USE("time.end", 1.8e-3)},
    {USE("load.body_force", 0), .methods = BY_PD,
     .help = "force per unit mass on the whole beam, upwards; -9.81: its weight"},
    PLANE_USES,
};

const Problem problem_supported_beam = {
    .word = "simply-supported-beam",
    .title = "vibration of a simply supported beam",
    .about = "period_error",
    .concerns = BEAM_CONCERNS | CONCERN_DEFLECTION | PLANE_CONCERNS | CONCERN_SECTIONS | CONCERN_WEIGHT |
                CONCERN_REST,
    USES(uses_supported),
    SOLVED_BY(&beam_by_pd_supported, &beam_by_mpm_supported),
    BEAM_COMMON,
};

static const ParameterUse uses_moving[] = {
    {USE("beam.length", 0.1), .help = "length of the part outside the channel at t = 0"},
    {USE("motion.speed", 10)},
    {USE("motion.channel", 0.055)},
    {USE("initial.amplitude", 3e-6), .help = "U at t = 0; the tip's deflection is 2 U"},
    {USE("time.end", 5e-3)},
    {USE("mpm.flip_fraction", 0.999)},
    PLANE_USES,
};

const Problem problem_moving_cantilever = {
    .word = "moving-cantilever",
    .title = "vibration of an axially moving cantilever",
    .about = "period_error",
    .concerns = BEAM_CONCERNS | CONCERN_DEFLECTION | CONCERN_MOTION | PLANE_CONCERNS | CONCERN_RIDING,
    USES(uses_moving),
    SOLVED_BY(&beam_by_pd_moving, &beam_by_mpm_moving),
    BEAM_COMMON,
    .end_matters = true, /* its channel and its modal solution reach to the end */
};

static const ParameterUse uses_notched[] = {
    {USE("beam.length", 0.21)},      {USE("beam.height", 0.07)},
    {USE("beam.thickness", 0.0254)}, {USE("beam.youngs_modulus", 34.48e9)},
    {USE("beam.density", 2400)},     {USE("pd.spacing", 0.5e-3)},
    {USE("pd.horizon", 2e-3)},       {USE("pd.critical_stretch", 0.00085)},
    {USE("pd.protected", 0.003)},    {USE("notch.position", 0.065)},
    {USE("notch.depth", 0.0175)},    {USE("load.stress", 60e6)},
    {USE("load.ramp", 1e-6)},        {USE("load.position", 0.105)},
    {USE("load.width", 0.003)},      {USE("supports.left", 0.005)},
    {USE("supports.right", 0.205)},  {USE("time.step", 1e-7)},
    {USE("time.end", 3e-4)},
};

const Problem problem_notched_beam = {
    .word = "notched-beam",
    .title = "three-point bending of a beam with an offset notch",
    .about = "crack_length",
    .concerns = BEAM_CONCERNS | CONCERN_NOTCH | CONCERN_PRESSURE | CONCERN_SUPPORTS | CONCERN_REST,
    USES(uses_notched),
    SOLVED_BY(&beam_by_pd_notched),
    .alone = "by it nothing breaks",
    BEAM_COMMON,
};

/* Glass as the branching experiments have it (Duran 50). */
static const ParameterUse uses_plate[] = {
    {USE("plate.length", 0.1)},
    {USE("plate.height", 0.04)},
    {USE("plate.thickness", 0.001)},
    {USE("plate.youngs_modulus", 65e9)},
    {USE("plate.density", 2235)},
    {USE("pd.spacing", 0.5e-3)},
    {USE("pd.horizon", 2e-3)},
    {USE("pd.critical_energy", 204)},
    {USE("time.end", 5e-5)},
    {USE("load.body_force", 0), .methods = BY_PD,
     .help = "force per unit mass on the whole plate, upwards; -9.81: its weight"},
};

const Problem problem_plate = {
    .word = "plate",
    .title = "a plate with cuts, loads and supports of your own",
    .about = "broken_bonds",
    .concerns = CONCERN_PLATE | CONCERN_LATTICE | CONCERN_BREAKING | CONCERN_STEP | CONCERN_DAMPING |
                CONCERN_WEIGHT | CONCERN_REST,
    USES(uses_plate),
    SOLVED_BY(&beam_by_pd_plate),
    .alone = "by it nothing breaks",
    .body = "plate",
    .answer = "theory",
    .si = true,
    .unit_of_time = "s",
    .shown_time = 1e-6,
    .shown_time_unit = " us",
};
