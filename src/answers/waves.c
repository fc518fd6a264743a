/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "answers/waves.h"
#include "scenario/concern_bonds.h"
#include "theory/pd_waves.h"

#include <math.h>

double waves_on_lattice(const Settings *settings, Influence influence, bool transverse, double angle,
                        double k)
{
    const Lattice *on = settings_lattice(settings);
    PdWaveLattice lattice = {.shape = influence,
                             .ratio = on->horizon / on->spacing,
                             .volumes = on->volume_correction,
                             .factor = 1};
    if (on->surface_correction == SURFACE_ENERGY)
        lattice.factor = pd_waves_energy_factor(&lattice);
    if (on->surface_correction == SURFACE_VOLUME)
        lattice.factor = pd_waves_area_factor(&lattice);
    return sqrt(pd_waves_lattice(&lattice, transverse, angle, k * on->horizon));
}

double waves_of_bonds(const Settings *settings, Influence influence, bool transverse, double k)
{
    return sqrt(pd_waves_plane(influence, transverse, k * settings_lattice(settings)->horizon));
}
