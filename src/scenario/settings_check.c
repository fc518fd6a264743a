/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What no single value shows: does the whole make sense? Every refusal names the key to be changed. */
#include "scenario/parameters.h"
#include "scenario/concern_output.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "problems/problem.h"

/* --- question, duel, changes ---------------------------------------------------------------------- */

static bool check_question(const Settings *settings, Status *status)
{
    if (!*settings->question)
        return true;
    const Parameter *parameter = parameter_find(settings->question);
    if (!parameter || !parameter_can_be_asked(parameter, settings->problem))
        return status_refuse(
            status, "question.key: %s cannot be toggled (a key of problem %s that has choices, or a size)",
            settings->question, settings->problem->word);
    return true;
}

/* The settings of the other run must be as sound as those of the first. */
static bool check_duel(const Settings *settings, Status *status)
{
    Settings other = *settings;
    other.n_duel = other.n_changes = 0;
    if (!settings_set_method(&other, settings->duel, settings->n_duel, status))
        return status_prefix(status, "duel");
    for (int i = 0; i < settings->n_duel; i++) {
        const Parameter *parameter = parameter_find(settings->duel[i].key);
        /* a file whose method was set from outside may speak of the other one */
        if (parameter && parameter_applies(parameter, other.problem) &&
            !parameter_applies_to(&other, parameter))
            continue;
        if (!settings_set(&other, settings->duel[i].key, settings->duel[i].value, status))
            return status_prefix(status, "duel");
    }
    if (settings->n_duel > 0 && !settings_check(&other, status))
        return status_prefix(status, "duel");
    return true;
}

static bool check_changes(const Settings *settings, Status *status)
{
    Settings then = *settings;
    for (int i = 0; i < settings->n_changes; i++) {
        const Change *change = &settings->changes[i];
        const Parameter *parameter = parameter_find(change->to.key);
        const double before = parameter ? settings_number(&then, parameter) : 0;
        const bool concealed = then.concealed;
        if (!settings_set(&then, change->to.key, change->to.value, status))
            return status_prefix(status, "changes.%ld", change->step);
        if (parameter && parameter->live &&
            !parameter_is_live(parameter, before, settings_number(&then, parameter)))
            return status_refuse(
                status, "changes.%ld: %s: %s is made at the start and holds for the whole run", change->step,
                change->to.key,
                !parameter->of_start((int)before) ? parameter->choices[(int)settings_number(&then, parameter)]
                : concealed                       ? "?"
                                                  : parameter->choices[(int)before]);
        if (then.concealed && !concealed)
            return status_refuse(status, "changes.%ld: %s: %s is concealed from the start on, or not at all",
                                 change->step, change->to.key, change->to.value);
        if (!parameter || !parameter->live)
            return status_refuse(
                status, "changes.%ld: %s: cannot change in mid-run (see: matvib params %s, marked live)",
                change->step, change->to.key, settings->problem->word);
        if (change->step < 0 || (i > 0 && change->step < settings->changes[i - 1].step))
            return status_refuse(status, "changes.%ld: is out of order (steps >= 0, ascending)",
                                 change->step);
    }
    return true;
}

/* A part of the problem that the method knows nothing of must not be dropped in silence. */
static bool check_stated(const Settings *settings, Status *status)
{
    const Problem *problem = settings->problem;
    for (int i = 0; i < n_parameters; i++) {
        const Parameter *parameter = &parameters[i];
        char text[LIST_MAX];
        if (!parameter->stated || !parameter_applies(parameter, problem) ||
            parameter_applies_to(settings, parameter) || !settings_are_at_work(settings, parameter) ||
            (parameter->type != PARAMETER_TEXT &&
             settings_number(settings, parameter) == parameter_usual(parameter, problem)))
            continue;
        settings_get(settings, parameter, text);
        return status_refuse(
            status, "scenario.method: %s does not know %s, which is %s here (%s)",
            settings_method_words[settings->method], parameter->key, text,
            settings_method_words[parameter_methods(parameter, problem) & BY_MPM ? METHOD_MPM : METHOD_PD]);
    }
    return true;
}

bool settings_change(Settings *settings, const char *key, const char *text, Status *status)
{
    Settings wanted = *settings;
    if (!settings_set(&wanted, key, text, status) || !settings_check(&wanted, status))
        return false;
    *settings = wanted;
    return true;
}

bool settings_check(const Settings *settings, Status *status)
{
    if (!problem_allows(settings->problem, settings->method, status) || !check_stated(settings, status) ||
        !settings_rows_check(settings, status) ||
        !problem_solver(settings->problem, settings->method)->check(settings, status))
        return false;
    double times[TIMES_MAX];
    int n_times = settings_times_read(settings_output(settings)->at, times, status);
    if (n_times < 0)
        return false;
    if (n_times > 0 && times[n_times - 1] > settings_time(settings)->end * (1 + 1e-9))
        return status_refuse(status, "output.at: %g is after the end (at most time.end = %g)",
                             times[n_times - 1], settings_time(settings)->end);
    if (n_times > 0 && settings_output(settings)->frames > 0)
        return status_refuse(status, "output.at: output.frames is given too (one of them)");
    return check_question(settings, status) && settings_check_asked(settings, status) &&
           check_duel(settings, status) && check_changes(settings, status);
}
