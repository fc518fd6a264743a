/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sharp invariant of the bar by the material point method: answers/invariant.h says what it is. */
#include "answers/bar_answers.h"

#include <math.h>
#include <stdlib.h>

/* The particles' velocities and masses, and the strain energy, where the simulation stands. */
static bool take_state(Simulation *sim, double *velocity, double *mass, double *strain)
{
    const int v = simulation_find_field(sim, 0, "v"), m = simulation_find_field(sim, 0, "mass");
    const int energy = simulation_find_series(sim, "strain");
    double *row = malloc((size_t)sim->n_series * sizeof *row);
    if (!row || v < 0 || m < 0 || energy < 0) {
        free(row);
        return false;
    }
    simulation_row(sim, row);
    *strain = row[energy];
    free(row);
    sim->method->field(sim, v, 0, sim->counts[0], velocity);
    sim->method->field(sim, m, 0, sim->counts[0], mass);
    return true;
}

/* One step ahead; the simulation stands somewhere else afterwards. */
static double one_step_ahead(Simulation *sim, MpmAlgorithm algorithm)
{
    const size_t count = sim->counts[0];
    double *numbers = malloc((3 * count + 1) * sizeof *numbers), sum = NAN;
    double *before = numbers, *after = numbers + count, *mass = numbers + 2 * count, old, new;
    if (numbers && take_state(sim, before, mass, &old) && simulation_steps(sim, 1, NULL, NULL, NULL) &&
        take_state(sim, after, mass, &new)) {
        sum = algorithm == MPM_USF ? new : old;
        for (size_t i = 0; i < count; i++)
            sum += mass[i] * before[i] * after[i] / 2;
    }
    free(numbers);
    return sum;
}

bool bar_invariant_kept(const Settings *settings)
{
    return settings->mpm.transfer == MPM_FLIP && settings->mpm.flip_fraction == 1 &&
           settings->loads.body_force == 0 && settings->loads.traction == 0;
}

double bar_invariant(Simulation *sim, const Settings *settings)
{
    void *present = malloc(simulation_snapshot_size(sim));
    if (!present)
        return NAN;
    simulation_snapshot(sim, present);
    const double value = one_step_ahead(sim, settings->mpm.algorithm);
    simulation_restore(sim, present);
    free(present);
    return value;
}
