/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "methods/default_defs.h"

MpmDef bar_default(void)
{
    return (MpmDef){
        .length = 25.0,
        .youngs_modulus = 100.0,
        .density = 1.0,
        .supports = BAR_FIXED_FREE,
        .cell_size = 1.0,
        .particles_per_cell = 2,
        .padding = 4,
        .algorithm = MPM_USF,
        .shape = MPM_HAT,
        .transfer = MPM_FLIP,
        .flip_fraction = 1.0,
        .fmpm_order = 2,
        .mass_blend = 1.0,
        .courant = 0.1,
    };
}

MpmDef plane_default(bool leaves_channel)
{
    MpmDef def = {
        .problem = MPM_BEAM,
        .leaves_channel = leaves_channel,
        .length = 0.1,
        .height = 0.005,
        .thickness = 0.005,
        .youngs_modulus = 71e9,
        .density = 2700,
        .poisson = 1.0 / 3,
        .cell_size = 0.625e-3,
        .particles_per_cell = 2,
        .padding = 2,
        .algorithm = MPM_USF,
        .shape = MPM_GIMP,
        .flip_fraction = 1,
        .rotation = ROTATION_NONE,
        .amplitude = 3e-6,
        .courant = 0.5,
        .end = 1.8e-3,
        .threads = 1,
    };
    if (leaves_channel) {
        def.flip_fraction = 0.999;
        def.speed = 10;
        def.channel = 0.055;
        def.end = 5e-3;
    }
    return def;
}

/* The three problems of paper P as it gives them; what it leaves open (size of the notched beam, width of its
 * load, protected zones) is chosen so that its results come out. */
MpmDef bodies_default(void)
{
    return (MpmDef){.problem = MPM_BODIES,
                    .length = 1,
                    .height = 0.8,
                    .bodies = {{"left", BODY_DISC, {.25, .3, .2}, {.2, 0}, 0, 0},
                               {"right", BODY_DISC, {.75, .45, .2}, {-.2, 0}, 0, 0}},
                    .n_bodies = 2,
                    .youngs_modulus = 1000,
                    .density = 1000,
                    .poisson = .3,
                    .cell_size = .1,
                    .particles_per_cell = 2,
                    .shape = MPM_GIMP,
                    .flip_fraction = 1,
                    .fields = FIELDS_EACH,
                    .gap = .4,
                    .courant = .1,
                    .threads = 1};
}

BeamDef beam_default(BeamProblem problem)
{
    BeamDef def = {
        .problem = problem,
        .length = 0.1,
        .height = 0.005,
        .thickness = 0.005,
        .youngs_modulus = 71e9,
        .density = 2700,
        .horizon = 1e-3,
        .spacing = 0.25e-3,
        .surface_correction = SURFACE_ENERGY,
        .volume_correction = VOLUME_PARTIAL,
        .amplitude = 3e-6,
        .end = 1.8e-3,
        .threads = 1,
    };
    if (problem == BEAM_MOVING_CANTILEVER) {
        def.speed = 10;
        def.channel = 0.055;
        def.clamp = CLAMP_FULL;
        def.end = 5e-3;
    }
    if (problem == BEAM_NOTCHED) {
        def.length = 0.21;
        def.height = 0.07;
        def.thickness = 0.0254;
        def.youngs_modulus = 34.48e9;
        def.density = 2400;
        def.horizon = 2e-3;
        def.spacing = 0.5e-3;
        def.critical_stretch = 0.00085;
        def.protected_depth = 0.003;
        def.amplitude = 0;
        def.notch_position = 0.065;
        def.notch_depth = 0.0175;
        def.load_stress = 60e6;
        def.load_ramp = 1e-6;
        def.load_position = 0.105;
        def.load_width = 0.003;
        def.support_left = 0.005;
        def.support_right = 0.205;
        def.dt = 1e-7;
        def.end = 3e-4;
    }
    if (problem == BEAM_PLATE) {
        def.height = 0.04;
        def.thickness = 0.001;
        def.youngs_modulus = 65e9;
        def.density = 2235;
        def.amplitude = 0;
        def.plate.probe_x = def.length / 2;
        def.plate.probe_y = def.height / 2;
        def.end = 5e-5;
    }
    return def;
}
