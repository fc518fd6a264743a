/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The parameter table: nothing but its rows. */
#include "scenario/parameter_table.h"

const Parameter parameters[] = {
#include "scenario/parameter_rows.inc"
};

const int n_parameters = (int)(sizeof parameters / sizeof *parameters);
