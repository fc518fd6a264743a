/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every view of the laboratory, in the order of help and manual. To add one: its file, and its name here. */
#include "views/views.h"

const View *const views[] = {
    &view_profile,     &view_probe,    &view_energies, &view_shapes, &view_dispersion,
    &view_convergence, &view_spectrum, &view_table,    &view_beam,   &view_section,
    &view_fronts,      &view_cell,     &view_log,
};

const int n_views = sizeof views / sizeof *views;
