/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A beam as its engine by peridynamics wants it. */
#include "lab/problems/beams/beam_answers.h"

static BeamProblem engine_problem(const Problem *problem)
{
    return problem->concerns & CONCERN_MOTION  ? BEAM_MOVING_CANTILEVER
           : problem->concerns & CONCERN_NOTCH ? BEAM_NOTCHED
                                               : BEAM_SIMPLY_SUPPORTED;
}

BeamDef beam_definition(const Settings *settings, int threads)
{
    return (BeamDef){
        .problem = engine_problem(settings->problem),
        .length = settings->geometry.length,
        .height = settings->geometry.height,
        .thickness = settings->geometry.thickness,
        .youngs_modulus = settings->material.youngs_modulus,
        .density = settings->material.density,
        .horizon = settings->lattice.horizon,
        .spacing = settings->lattice.spacing,
        .surface_correction = settings->lattice.surface_correction,
        .volume_correction = settings->lattice.volume_correction,
        .critical_stretch = settings->bonds.critical_stretch,
        .protected_depth = settings->bonds.protected_depth,
        .amplitude = settings->start.amplitude,
        .speed = settings->motion.speed,
        .channel = settings->motion.channel,
        .clamp = settings->motion.clamp,
        .notch_position = settings->notch.position,
        .notch_depth = settings->notch.depth,
        .load_stress = settings->loads.stress,
        .load_ramp = settings->loads.ramp,
        .load_position = settings->loads.position,
        .load_width = settings->loads.width,
        .support_left = settings->supports.left,
        .support_right = settings->supports.right,
        .pinned = settings->supports.pinned,
        .dt = settings->time.step,
        .end = settings->time.end,
        .threads = threads,
        .patience = settings->patience,
    };
}
