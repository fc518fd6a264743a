/* SPDX-License-Identifier: GPL-3.0-or-later */
/* E*, the energy that a scheme keeps to round-off while kinetic + strain ripples (invariant.h): hands the
 * questions on to the solver; the sums are in bar_answers.c. With USF E* = sum m v^n
 * v^{n+1}/2 + strain(stress^{n+1}). */
#include "answers/invariant.h"
#include "base/assertion.h"
#include "scenario/settings.h"
#include "answers/known.h"

#include <math.h>

bool invariant_exists(const Settings *settings)
{
    const Solver *solver = problem_solver(settings->problem, settings->method);
    return solver && solver->invariant && solver->invariant_kept(settings) &&
           !known_unaccounted_now(settings, REFERENCE_ENERGY);
}

double invariant_now(Simulation *sim, const Settings *settings)
{
    ASSERT_INT(sim->stage, ==, 0);
    const Solver *solver = problem_solver(settings->problem, settings->method);
    return solver && solver->invariant ? solver->invariant(sim, settings) : NAN;
}
