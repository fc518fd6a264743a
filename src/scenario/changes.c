/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Changes in mid-run (changes.h). */
#include "scenario/changes.h"
#include "base/assertion.h"
#include "scenario/settings.h"
#include "scenario/parameters.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

bool changes_advice(const Settings *settings, char *advice, size_t size, Status *status)
{
    if (!settings_check(settings, status) || !problem_advice(settings, advice, size, status))
        return false;
    for (int i = 0; i < settings->n_changes; i++) {
        Settings then;
        char later[160];
        changes_in_force(settings, settings->changes[i].step, &then);
        if (!problem_advice(&then, later, sizeof later, status))
            return status_prefix(status, "changes.%ld", settings->changes[i].step);
        if (*later && size > 0 && !*advice)
            snprintf(advice, size, "%s", later);
    }
    return true;
}

bool changes_apply(const Settings *settings, Simulation *sim, Status *status)
{
    for (int i = 0; i < settings->n_changes; i++) {
        const Change *change = &settings->changes[i];
        if (change->step != sim->step)
            continue;
        Settings now;
        Status why;
        changes_in_force(settings, change->step, &now);
        const Parameter *parameter = parameter_find(change->to.key);
        if (!sim->method->change(sim, change->to.key, settings_number(&now, parameter), &why))
            return simulation_fail(sim, status, "step %ld: %s", sim->step, why.text);
        char text[KEY_MAX + VALUE_MAX + 8];
        snprintf(text, sizeof text, "%s = %s", change->to.key, change->to.value);
        simulation_report(sim, EVENT_CHANGE, text);
    }
    return true;
}

long changes_next(const Settings *settings, long step)
{
    ASSERT_INT(step, >=, 0);
    for (int i = 0; i < settings->n_changes; i++)
        if (settings->changes[i].step > step)
            return settings->changes[i].step;
    return LONG_MAX;
}

void changes_in_force(const Settings *settings, long step, Settings *out)
{
    *out = *settings;
    for (int i = 0; i < settings->n_changes && settings->changes[i].step <= step; i++)
        settings_set(out, settings->changes[i].to.key, settings->changes[i].to.value, NULL);
}

bool changes_add(Settings *settings, long step, const char *key, const char *value, Status *status)
{
    ASSERT_INT(step, >=, 0);
    int n = settings->n_changes;
    while (n > 0 && settings->changes[n - 1].step > step)
        n--;
    for (int i = 0; i < n; i++)
        if (settings->changes[i].step == step && strcmp(settings->changes[i].to.key, key) == 0) {
            memmove(&settings->changes[i], &settings->changes[i + 1],
                    (size_t)(n - i - 1) * sizeof settings->changes[0]);
            n--;
            break;
        }
    if (n == CHANGES_MAX)
        return status_refuse(status, "%s: too many changes in one run (at most %d)", key, CHANGES_MAX);
    Change *change = &settings->changes[n];
    change->step = step;
    snprintf(change->to.key, sizeof change->to.key, "%s", key);
    snprintf(change->to.value, sizeof change->to.value, "%s", value);
    settings->n_changes = n + 1;
    return settings_check(settings, status);
}

void changes_move(Change *changes, int count, double from_dt, double to_dt)
{
    ASSERT(count == 0 || to_dt > 0);
    for (int i = 0; i < count; i++)
        changes[i].step = lround((double)changes[i].step * from_dt / to_dt);
}

bool changes_keep_time(Settings *settings, double *dt, Status *status)
{
    const double from_dt = *dt;
    if (settings->n_changes == 0)
        return true;
    if (!settings_check(settings, status) || !problem_time_step(settings, dt, status))
        return false;
    changes_move(settings->changes, settings->n_changes, from_dt, *dt);
    return true;
}
