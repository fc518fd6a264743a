/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parameter table: nothing but its rows. */
#include "scenario/parameter_table.h"
#include "methods/bonds/plane/bonds_plane.h"
#include "methods/mpm/bodies.h"
#include "methods/mpm/mpm_bar.h"

const Parameter parameters[] = {
#include "scenario/parameter_rows.inc"
};

const int n_parameters = (int)(sizeof parameters / sizeof *parameters);
