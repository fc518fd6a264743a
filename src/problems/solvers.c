/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Who solves a problem by which method. */
#include "problems/problem.h"
#include "scenario/settings.h"

const Solver *problem_solver(const Problem *problem, MethodKind method)
{
    for (int i = 0; problem->solvers[i]; i++)
        if (problem->solvers[i]->method == method)
            return problem->solvers[i];
    return NULL;
}

bool problem_allows(const Problem *problem, MethodKind method, Status *status)
{
    return problem_solver(problem, method) ||
           status_refuse(status, "scenario.method: %s cannot solve problem %s%s%s (%s)",
                         settings_method_words[method], problem->word, problem->alone ? ": " : "",
                         problem->alone ? problem->alone : "",
                         settings_method_words[problem->solvers[0]->method]);
}
