/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Definitions to begin with, as the parameters' defaults make them (tests/run/check_parameters.c compares).
 */
#ifndef TESTS_DEFAULT_DEFS_H
#define TESTS_DEFAULT_DEFS_H

#include "methods/bonds/plane/bonds_plane.h"
#include "methods/mpm/mpm.h"

/* Paper M's first mode, at rest: L 25, E 100, rho 1, dx 1, two particles per cell, USF, hat, courant 0.1. */
MpmDef bar_default(void);

/* Aluminium beams of .1 x .005 m in cells of .625 mm, as the scenarios have them. */
MpmDef plane_default(bool leaves_channel);

/* Two discs that meet off their centres in an open box. */
MpmDef bodies_default(void);

BeamDef beam_default(BeamProblem problem);

#endif
