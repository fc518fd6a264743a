/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parameter table: nothing but its rows. */
#include "lab/settings/parameter_table.h"

const Parameter parameters[] = {
#include "lab/settings/parameter_rows.inc"
};

const int n_parameters = (int)(sizeof parameters / sizeof *parameters);
