/* Hands the questions of invariant.h on to the solver; the sums of E* are in problems/bar_invariant.c. */
#include "lab/answers/invariant.h"
#include "lab/problems/known.h"

#include <math.h>

bool invariant_exists(const Settings *settings)
{
    const Solver *solver = problem_solver(settings->problem, settings->method);
    return solver && solver->invariant && solver->invariant_kept(settings) &&
           !known_unaccounted_now(settings, REFERENCE_ENERGY);
}

double invariant_now(Simulation *sim, const Settings *settings)
{
    const Solver *solver = problem_solver(settings->problem, settings->method);
    return solver && solver->invariant ? solver->invariant(sim, settings) : NAN;
}
