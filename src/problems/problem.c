/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The functions of problem.h for settings of any problem: finds row and solver, and hands over to them. */

#include "base/assertion.h"
#include "scenario/concern_output.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "answers/references.h"
#include "scenario/parameters.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

const Problem *problem_find(const char *word)
{
    for (int i = 0; problems[i]; i++)
        if (strcmp(problems[i]->word, word) == 0)
            return problems[i];
    return NULL;
}

Simulation *problem_simulate(const Settings *settings, int threads, Status *status)
{
    ASSERT_INT(threads, >=, 1);
    if (!settings_check(settings, status))
        return NULL;
    Simulation *sim =
        problem_solver(settings->problem, settings->method)->simulate(settings, threads, status);
    if (!sim)
        return NULL;
    simulation_ask_columns(sim, settings_output(settings)->columns);
    bool sound = problem_check_steps(settings_time(settings)->end, sim->dt, status);
    /* the series gets the columns of the things that are followed */
    const char *rest = settings_output(settings)->follow;
    for (rest += strspn(rest, " ,"); sound && *rest; rest += strspn(rest, " ,")) {
        char thing[FOLLOW_TEXT_MAX];
        size_t length = strcspn(rest, ",");
        snprintf(thing, sizeof thing, "%.*s", (int)length, rest);
        for (size_t end = strlen(thing); end > 0 && thing[end - 1] == ' ';)
            thing[--end] = '\0';
        rest += length;
        sound = simulation_follow(sim, thing, status) || status_prefix(status, "output.follow");
    }
    if (sound)
        return sim;
    simulation_destroy(sim);
    return NULL;
}

int problem_derived(const Settings *settings, const Simulation *sim, Derived out[DERIVED_MAX])
{
    const Solver *solver = problem_solver(settings->problem, settings->method);
    const int all = solver && solver->derived ? solver->derived(settings, sim, out) : 0;
    int count = 0;
    for (int i = 0; i < all; i++)
        if (!out[i].by_reference || !answer_invalid_because(settings, out[i].reference))
            out[count++] = out[i];
    return count;
}

bool problem_advice(const Settings *settings, char *advice, size_t size, Status *status)
{
    const Solver *solver = problem_solver(settings->problem, settings->method);
    if (size > 0)
        advice[0] = '\0';
    if (!problem_allows(settings->problem, settings->method, status) ||
        (solver->advice && !solver->advice(settings, advice, size, status)))
        return false;
    /* the limit is predicted: with a parameter that the prediction does not account for it is not known */
    return !solver->limit || answer_unlisted_now(settings, REFERENCE_PREDICTED) ||
           solver->limit(settings, advice, size, status);
}

bool problem_time_step(const Settings *settings, double *dt, Status *status)
{
    Simulation *sim = problem_simulate(settings, 1, status);
    if (!sim)
        return false;
    *dt = sim->dt;
    simulation_destroy(sim);
    return true;
}

void problem_end_at(Settings *settings, double dt, long step)
{
    ASSERT_REAL(dt, >, 0);
    ASSERT_INT(step, >=, 0);
    double times[TIMES_MAX];
    settings_edit_time(settings)->end = (double)step * dt;
    if (settings->problem->concerns & CONCERN_STEP)
        settings_edit_time(settings)->step = dt;
    while (settings->n_changes > 0 && settings->changes[settings->n_changes - 1].step > step)
        settings->n_changes--;
    int n = settings_times_read(settings_output(settings)->at, times, NULL), kept = n;
    while (kept > 0 && lround(times[kept - 1] / dt) > step)
        kept--;
    if (kept == n)
        return;
    size_t length = 0;
    settings_edit_output(settings)->at[0] = '\0';
    for (int i = 0; i < kept; i++) {
        char text[NUMBER_TEXT_MAX];
        text_shortest(text, times[i]);
        length +=
            (size_t)snprintf(settings_edit_output(settings)->at + length,
                             sizeof settings_output(settings)->at - length, "%s%s", i > 0 ? "," : "", text);
    }
}
