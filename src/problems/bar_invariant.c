/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sharp invariant of the bar by the material point method: answers/invariant.h says what it is. */
#include "answers/bar_answers.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"

#include <math.h>
#include <stdlib.h>

bool bar_invariant_kept(const Settings *settings)
{
    return settings_transfer(settings)->transfer == MPM_FLIP &&
           settings_transfer(settings)->flip_fraction == 1 && settings_loads(settings)->body_force == 0 &&
           settings_loads(settings)->traction == 0;
}

double bar_invariant(Simulation *sim, const Settings *settings)
{
    const size_t count = sim->counts[0];
    double *before = malloc(3 * count * sizeof *before), *after = before + count, *mass = before + 2 * count;
    double strain[2], sum = NAN;
    if (before && simulation_step_ahead(sim, before, after, strain)) {
        sim->method->field(sim, simulation_find_field(sim, 0, "mass"), 0, count, mass);
        sum = strain[settings_transfer(settings)->algorithm == MPM_USF];
        for (size_t i = 0; i < count; i++)
            sum += mass[i] * before[i] * after[i] / 2;
    }
    free(before);
    return sum;
}
