/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "methods/beam_case.h"
#include "suite.h"
#include "methods/default_defs.h"

#include <stdlib.h>
#include <string.h>

BeamDef small_beam(BeamProblem problem)
{
    BeamDef def = beam_default(problem);
    if (problem == BEAM_NOTCHED) {
        def.length = 0.1;
        def.height = 0.04;
        def.horizon = 4e-3;
        def.spacing = 1e-3;
        def.notch_position = 0.03;
        def.notch_depth = 0.01;
        def.load_position = 0.05;
        def.load_width = 0.004;
        def.support_left = 0.0055;
        def.support_right = 0.0945;
        def.pinned = true;
        def.protected_depth = 0.006;
        def.dt = 2e-7;
        return def;
    }
    def.length = 0.05;
    def.horizon = 2e-3;
    def.spacing = 0.5e-3;
    def.dt = 5e-8;
    if (problem == BEAM_MOVING_CANTILEVER) {
        def.speed = 50;
        def.channel = 0.01;
        def.end = 1e-4;
    }
    return def;
}

BeamDef struck_plate(void)
{
    BeamDef def = beam_default(BEAM_PLATE);
    def.spacing = 0.5e-3;
    def.horizon = 2e-3;
    def.critical_stretch = 0.006;
    def.dt = 5e-8;
    def.plate.n_loads = 1;
    def.plate.loads[0] = (PlateLoad){.name = "blow",
                                     .edge = PLATE_LEFT,
                                     .from = 0.01,
                                     .to = 0.03,
                                     .sx = 450e6,
                                     .ramp = 1e-6,
                                     .until = 3e-6};
    return def;
}

Simulation *beam_case_create(const BeamDef *def, const BeamOptions *options)
{
    Status status = {0};
    Simulation *sim = beam_create_with(def, options, &status);
    ck_assert_msg(sim != NULL, "%s", status.text);
    return sim;
}

static void expect_same_field(const Simulation *a, const Simulation *b, int set, const char *name,
                              const char *what)
{
    double *x = field_now(a, set, name), *y = field_now(b, set, name);
    for (size_t k = 0; k < a->counts[set]; k++)
        if (memcmp(&x[k], &y[k], sizeof x[k]) != 0)
            ck_abort_msg("%s: %s of %zu is %.17g and %.17g at step %ld stage %d", what, name, k, x[k], y[k],
                         a->step, a->stage);
    free(x);
    free(y);
}

void expect_same_state(const Simulation *a, const Simulation *b, const char *what)
{
    ck_assert_msg(a->step == b->step && a->stage == b->stage, "%s: step %ld stage %d and step %ld stage %d",
                  what, a->step, a->stage, b->step, b->stage);
    /* what a snapshot does not hold first: it tells more */
    expect_same_field(a, b, SET_PARTICLE, "damage", what);
    expect_same_field(a, b, SET_PARTICLE, "uy", what);
    expect_same_field(a, b, SET_BOND, "broken_at", what);
    size_t size = simulation_snapshot_size(a);
    ck_assert_uint_eq(size, simulation_snapshot_size(b));
    unsigned char *x = snapshot_now(a), *y = snapshot_now(b);
    for (size_t k = 0; k < size; k++)
        if (x[k] != y[k])
            ck_abort_msg("%s: byte %zu of %zu differs at step %ld stage %d", what, k, size, a->step,
                         a->stage);
    free(x);
    free(y);
}
