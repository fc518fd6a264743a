/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams as tests want them. */
#ifndef TESTS_BEAM_CASE_H
#define TESTS_BEAM_CASE_H

#include "methods/bonds/plane/bonds_plane.h"
#include "methods/bonds/plane/bonds_internal.h"
#include "methods/run_case.h"

/* Small beams that are done quickly: 100 x 10 nodes that vibrate, 120 x 10 that move, and 100 x 40 with a
 * notch that cracks within 900 steps. */
BeamDef small_beam(BeamProblem problem);

/* 200 x 80 nodes, struck at its left edge for 60 steps: a wave of strains for which the series does not do,
 * before and behind which it does. Some bonds break when it comes back as tension. */
BeamDef struck_plate(void);

/* The simulation; stops the test if it cannot be made. `options` may be NULL. */
Simulation *beam_case_create(const BeamDef *def, const BeamOptions *options);

/* Stops the test unless both stand at the same state, bit by bit. */
void expect_same_state(const Simulation *a, const Simulation *b, const char *what);

#endif
