/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answers/waves.h"
#include "scenario/concern_bonds.h"
#include "base/kinds.h"
#include "theory/pd_waves.h"

#include <math.h>

_Static_assert((int)PD_WHOLE_VOLUMES == (int)VOLUME_NONE && (int)PD_HHB_VOLUMES == (int)VOLUME_HHB,
               "theory and method count volumes by the same numbers");

static PdShape shape_of(Influence influence)
{
    return influence == INFLUENCE_CONICAL ? PD_CONICAL : PD_CONSTANT;
}

double waves_on_lattice(const Settings *settings, Influence influence, bool transverse, double angle,
                        double k)
{
    const Lattice *on = settings_lattice(settings);
    PdWaveLattice lattice = {.shape = shape_of(influence),
                             .ratio = on->horizon / on->spacing,
                             .volumes = (PdVolumes)on->volume_correction,
                             .factor = 1};
    if (on->surface_correction == SURFACE_ENERGY)
        lattice.factor = pd_waves_energy_factor(&lattice);
    if (on->surface_correction == SURFACE_VOLUME)
        lattice.factor = pd_waves_area_factor(&lattice);
    return sqrt(pd_waves_lattice(&lattice, transverse, angle, k * on->horizon));
}

double waves_of_bonds(const Settings *settings, Influence influence, bool transverse, double k)
{
    return sqrt(pd_waves_plane(shape_of(influence), transverse, k * settings_lattice(settings)->horizon));
}
