/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a scenario says of peridynamics: its nodes, the reach of their bonds, and when a bond breaks. */
#ifndef SCENARIO_CONCERN_BONDS_H
#define SCENARIO_CONCERN_BONDS_H

#include "base/kinds.h"
#include "scenario/assignment.h"

#include <stdbool.h>

/* The nodes of peridynamics and the reach of their bonds. */
typedef struct Lattice {
    double spacing, horizon; /* 0 on the bar: see lattice_spacing(), lattice_horizon() */
    SurfaceCorrection surface_correction;
    VolumeCorrection volume_correction;
    Influence influence;
    Stepping stepping;
    int mistake, mistake_beside; /* as of Transfer (concern_cells.h) */
    bool step_is_known;          /* time.step has been run: of a code that is sought, no scenario has it */
} Lattice;

/* When a bond breaks. */
typedef struct Bonds {
    double critical_stretch; /* s0; 0: never */
    double critical_energy;  /* G0, J/m^2: equivalent to s0, kept in step with it */
    bool energy_given; /* G0 is the given value and the stretch follows from it; else the other way round */
    double protected_depth; /* bonds nearer than this to load or supports never break */
} Bonds;

/* Of some settings: to be read, and to be changed. */
const Lattice *settings_lattice(const Settings *);
const Bonds *settings_bonds(const Settings *);
Lattice *settings_edit_lattice(Settings *);
Bonds *settings_edit_bonds(Settings *);

/* Spacing and horizon of the lattice, with what stands for "auto" on the bar: one node where each particle
 * of the cells would be, and three spacings. */
double lattice_spacing(const Settings *);
double lattice_horizon(const Settings *);

/* The members of a family lie no farther than this. */
double lattice_reach(const Settings *);

#endif
