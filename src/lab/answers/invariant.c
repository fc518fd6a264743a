#include "lab/answers/invariant.h"
#include "lab/problems/problem.h"

#include <math.h>

bool invariant_exists(const Settings *settings)
{
    const Solver *solver = problem_solver(settings->problem, settings->method);
    return solver && solver->invariant && solver->invariant_kept(settings);
}

double invariant_now(Simulation *sim, const Settings *settings)
{
    const Solver *solver = problem_solver(settings->problem, settings->method);
    return solver && solver->invariant ? solver->invariant(sim, settings) : NAN;
}
