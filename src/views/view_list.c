/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every view of the laboratory, in the order of help and manual. To add one: its file, and its name here. */
#include "views/view.h"

#define VIEWS(VIEW)                                                                                          \
    VIEW(profile)                                                                                            \
    VIEW(probe)                                                                                              \
    VIEW(energies)                                                                                           \
    VIEW(shapes)                                                                                             \
    VIEW(dispersion)                                                                                         \
    VIEW(convergence)                                                                                        \
    VIEW(spectrum)                                                                                           \
    VIEW(table)                                                                                              \
    VIEW(beam)                                                                                               \
    VIEW(section)                                                                                            \
    VIEW(fronts)                                                                                             \
    VIEW(cell)                                                                                               \
    VIEW(log)

#define DECLARED(name) extern const View view_##name;
VIEWS(DECLARED)

#define LISTED(name) &view_##name,
const View *const views[] = {VIEWS(LISTED)};

const int n_views = sizeof views / sizeof *views;
