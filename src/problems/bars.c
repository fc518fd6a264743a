/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bar: axial vibration in one dimension, by both methods. */
#include "problems/solver.h"

static const ParameterUse uses[] = {
    {USE("bar.length", 25)},
    {USE("bar.youngs_modulus", 100)},
    {USE("bar.density", 1)},
    {USE("bar.supports", BAR_FIXED_FREE)},
    {USE("initial.mode", 1)},
    {USE("initial.velocity", 0.1)},
    {USE("mesh.cell_size", 1)},
    {USE("mesh.particles_per_cell", 2)},
    {USE("mesh.padding", 4)},
    {USE("pd.spacing", 0), .automatic = "auto"},
    {USE("pd.horizon", 0), .automatic = "auto"},
    {USE("pd.surface_correction", SURFACE_ENERGY), .choices = 2, .others = "is for beams"},
    {USE("time.courant", 0.1)},
    {USE("time.end", 100)},
};

const Problem problem_bar = {
    .word = "bar",
    .body = "bar",
    .title = "axial vibration of a bar",
    .about = "late",
    .concerns = CONCERN_BAR | CONCERN_MODES | CONCERN_MESH | CONCERN_METHODS | CONCERN_LATTICE |
                CONCERN_PULL | CONCERN_WAVES,
    USES(uses),
    SOLVED_BY(&bar_by_mpm, &bar_by_pd),
    IN_OWN_UNITS,
};
