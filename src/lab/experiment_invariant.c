/* The sharp invariant of the bar: its energy without the ripple.
 *
 * Velocities and stresses of the material point method are known half a step apart, so kinetic and strain
 * energy at the same step do not belong together and their sum ripples. What belongs together is
 *
 *     E* = sum of m v^n v^{n+1} / 2 + strain energy of the stress that turns v^n into v^{n+1}:
 *
 * the new one with USF, the old one with MUSL and USL. It is worked out by one step ahead on a copy of the
 * state. */
#include "lab/experiment_internal.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { RUNNING_MAX = 20000, PAUSED_MAX = 500000 }; /* particles; a picture must not wait for more */

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

static double invariant_at(Simulation *sim, const void *snapshot, MpmAlgorithm algorithm)
{
    void *present = malloc(simulation_snapshot_size(sim));
    if (!present)
        return NAN;
    simulation_snapshot(sim, present);
    if (snapshot)
        simulation_restore(sim, snapshot);
    const double value = one_step_ahead(sim, algorithm);
    simulation_restore(sim, present);
    free(present);
    return value;
}

/* Bars without a load, velocities by FLIP alone: else E* is not what is kept. */
static bool has_invariant(const Settings *settings)
{
    const BarDef *bar = &settings->bar;
    return settings->problem == PROBLEM_BAR && settings->method == METHOD_MPM && bar->transfer == MPM_FLIP &&
           bar->body_force == 0 && bar->traction == 0;
}

bool experiment_invariant(Experiment *experiment, double *now, double *start)
{
    Trial *trial = &experiment->trial;
    Simulation *sim = trial->sim;
    Invariant *known = &experiment->invariant;
    if (experiment->adopted || !has_invariant(&trial->now) || !has_invariant(&trial->base))
        return false;
    if (sim->counts[0] > PAUSED_MAX)
        return false;
    const bool busy = experiment->flowing && sim->counts[0] > RUNNING_MAX;
    if (!known->any) {
        *known = (Invariant){.any = true, .step = -1};
        const Keyframe *first = history_nearest(&trial->history, 0);
        known->start = first ? invariant_at(sim, first->bytes, trial->base.bar.algorithm) : NAN;
    }
    if (known->step != sim->step && sim->stage == 0 && sim->item == 0 && !busy && !sim->failed) {
        known->now = invariant_at(sim, NULL, trial->now.bar.algorithm);
        known->step = sim->step;
    }
    *now = known->now;
    *start = known->start;
    return known->step == sim->step && isfinite(*now) && isfinite(*start);
}
