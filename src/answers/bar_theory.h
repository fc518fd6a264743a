/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bar between its settings and its theory: for what needs the theory directly (a
 * dispersion plot, a table of verification). */
#ifndef ANSWERS_BAR_THEORY_H
#define ANSWERS_BAR_THEORY_H

#include "methods/mpm/mpm_bar.h"
#include "scenario/assignment.h"
#include "methods/bonds/plane/bonds_plane.h"
#include "theory/elastic_bar.h"

/* The bar with its modes and loads. False: its overtones cannot be read. */
bool bar_theory_of(const Settings *, BarTheory *, Status *);

/* The bar as its engine by the material point method wants it, at rest. */
BarDef bar_mpm_definition(const Settings *);

/* The same bar on a lattice of bonded nodes. */
BeamDef bar_pd_definition(const Settings *);

/* dt = courant * dx / c, eq. 21. */
double bar_time_step(const Settings *);

#endif
