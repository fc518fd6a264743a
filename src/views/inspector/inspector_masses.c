/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A node's row of the mass matrix, where masses are not lumped: what it shares with the nodes beside it. */
#include "views/inspector/inspector.h"

/* M is symmetric: M(i, i - d) is told with node i - d. False: there is no such matrix, or not yet. */
bool inspector_mass_row(const Simulation *sim, int set, size_t node, MassRow *row)
{
    static const char *const names[MASSES_BESIDE_MAX + 1] = {"mass_0", "mass_1", "mass_2", "mass_3"};
    size_t reach = 0;
    while (reach < MASSES_BESIDE_MAX && simulation_find_field(sim, set, names[reach + 1]) >= 0)
        reach++;
    if (!(simulation_named(sim, set, names[0], node) > 0))
        return false;
    row->first = node > reach ? node - reach : 0;
    row->count = 0;
    for (size_t j = row->first; j <= node + reach && j < sim->counts[set]; j++) {
        const size_t apart = j > node ? j - node : node - j;
        row->masses[row->count++] = simulation_named(sim, set, names[apart], j < node ? j : node);
    }
    return true;
}
