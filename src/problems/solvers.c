/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Who solves a problem by which method, and in how many steps: the least number that reaches time.end, but
 * for 1e-9 of it. */
#include "problems/problem.h"
#include "scenario/settings.h"
#include "base/assertion.h"
#include "base/text.h"

#include <math.h>

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

/* A run of more would not end in a lifetime, and a double would no longer count its steps exactly. */
#define STEPS_MOST 1e12

bool problem_check_steps(double end, double dt, Status *status)
{
    ASSERT_REAL(dt, >, 0);
    char most[NUMBER_TEXT_MAX];
    if (end / dt <= STEPS_MOST)
        return true;
    text_shortest(most, STEPS_MOST);
    return status_refuse(status, "time.end: %g takes %.3g steps of %.3g (at most %s steps)", end, end / dt,
                         dt, most);
}

long problem_last_step(double dt, double end)
{
    ASSERT_REAL(dt, >, 0);
    double enough = end * (1 - 1e-9);
    if (!(dt > 0) || !(enough > 0))
        return 0;
    long last = (long)fmin(ceil(enough / dt), 2 * STEPS_MOST);
    /* the quotient may be off by a rounding; the product decides */
    while (last > 0 && (double)(last - 1) * dt >= enough)
        last--;
    while ((double)last * dt < enough && last < (long)STEPS_MOST)
        last++;
    return last;
}
