/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sharp invariant of the bar by the material point method: answers/invariant.h says what it is. */
#include "answers/bar_answers.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"

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

/* E* of the state at which it is looked at. */
typedef struct Ahead {
    MpmAlgorithm algorithm;
    double value;
} Ahead;

/* Goes one step ahead. */
static void one_step_ahead(Simulation *sim, void *context)
{
    Ahead *ahead = context;
    const size_t count = sim->counts[0];
    double *numbers = malloc((3 * count + 1) * sizeof *numbers);
    double *before = numbers, *after = numbers + count, *mass = numbers + 2 * count, old, new;
    if (numbers && take_state(sim, before, mass, &old) && simulation_steps(sim, 1, NULL, NULL, NULL) &&
        take_state(sim, after, mass, &new)) {
        double sum = ahead->algorithm == MPM_USF ? new : old;
        for (size_t i = 0; i < count; i++)
            sum += mass[i] * before[i] * after[i] / 2;
        ahead->value = sum;
    }
    free(numbers);
}

bool bar_invariant_kept(const Settings *settings)
{
    return settings_transfer(settings)->transfer == MPM_FLIP &&
           settings_transfer(settings)->flip_fraction == 1 && settings_loads(settings)->body_force == 0 &&
           settings_loads(settings)->traction == 0;
}

double bar_invariant(Simulation *sim, const Settings *settings)
{
    Ahead ahead = {settings_transfer(settings)->algorithm, NAN};
    simulation_visit(sim, NULL, one_step_ahead, &ahead);
    return ahead.value;
}
