#include "lab/answers/dispersion.h"
#include "lab/problems/problem.h"

int dispersion_modes(const Settings *settings)
{
    const Solver *solver = problem_solver(settings->problem, settings->method);
    return solver && solver->modes ? solver->modes(settings) : 0;
}

bool dispersion_mode(const Settings *settings, int number, ModeOnMesh *out)
{
    return number >= 1 && number <= dispersion_modes(settings) &&
           problem_solver(settings->problem, settings->method)->mode(settings, number, out);
}
