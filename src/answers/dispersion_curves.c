/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Hands the questions of dispersion_curves.h on to the solver, and leaves out what does not account for a
 * parameter that is at work (references.h). */
#include "answers/dispersion_curves.h"
#include "base/assertion.h"
#include "scenario/settings.h"
#include "answers/references.h"
#include "scenario/concern_bonds.h"
#include "theory/pd_waves.h"

#include <math.h>

int dispersion_modes(const Settings *settings)
{
    const Solver *solver = problem_solver(settings->problem, settings->method);
    if (!solver || !solver->modes || answer_unaccounted_now(settings, REFERENCE_FREQUENCY))
        return 0;
    return solver->modes(settings);
}

bool dispersion_mode(const Settings *settings, int number, ModeOnMesh *out)
{
    ASSERT_INT(number, >=, 0);
    if (number < 1 || number > dispersion_modes(settings) ||
        !problem_solver(settings->problem, settings->method)->mode(settings, number, out))
        return false;
    if (answer_unaccounted_now(settings, REFERENCE_PREDICTED)) {
        out->predicted = NAN;
        out->n_factors = 0;
    }
    return true;
}

const char *dispersion_other_way(const Settings *settings, int which, int number, double *frequency)
{
    const Solver *solver = problem_solver(settings->problem, settings->method);
    if (!solver || !solver->other_way || number < 1 || number > dispersion_modes(settings) ||
        answer_unaccounted_now(settings, REFERENCE_PREDICTED))
        return NULL;
    return solver->other_way(settings, which, number, frequency);
}

double dispersion_on_lattice(const Settings *settings, Influence influence, bool transverse, double angle,
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

double dispersion_of_bonds(const Settings *settings, Influence influence, bool transverse, double k)
{
    return sqrt(pd_waves_plane(influence, transverse, k * settings_lattice(settings)->horizon));
}
