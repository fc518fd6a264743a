/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether a reference accounts for a run (known.h): every row of the parameter table whose value is not
 * neutral must be in the list that the solver gave for that reference, and so must every parameter that is
 * changed in mid-run. */
#include "answers/known.h"

#include "scenario/settings.h"
#include "base/text.h"
#include "scenario/parameters.h"

#include <stdio.h>
#include <string.h>

static bool is_among(const char *const *keys, const char *key)
{
    for (; keys && *keys; keys++)
        if (strcmp(*keys, key) == 0)
            return true;
    return false;
}

static bool is_at_work(const Settings *settings, const Parameter *parameter)
{
    return !parameter->output && parameter_applies_to(settings, parameter) &&
           settings_are_at_work(settings, parameter);
}

/* NULL: the reference does not exist. */
static const Validity *validity_of(const Settings *settings, Reference reference)
{
    const Solver *solver = problem_solver(settings->problem, settings->method);
    return solver && solver->validity[reference].keys ? &solver->validity[reference] : NULL;
}

const char *known_unlisted_now(const Settings *settings, Reference reference)
{
    const Validity *known = validity_of(settings, reference);
    for (int i = 0; known && i < n_parameters; i++)
        if (!is_among(known->keys, parameters[i].key) && is_at_work(settings, &parameters[i]))
            return parameters[i].key;
    return NULL;
}

const char *known_unaccounted_now(const Settings *settings, Reference reference)
{
    const Validity *known = validity_of(settings, reference);
    const char *key = known_unlisted_now(settings, reference);
    if (key)
        return key;
    const Solver *solver = known ? problem_solver(settings->problem, settings->method) : NULL;
    return solver && solver->unaccounted ? solver->unaccounted(settings, reference) : NULL;
}

const char *answer_invalid_because(const Settings *settings, Reference reference)
{
    const Validity *known = validity_of(settings, reference);
    for (int i = 0; known && i < settings->n_changes; i++)
        if (!is_among(known->changes, settings->changes[i].to.key)) {
            const Parameter *parameter = parameter_find(settings->changes[i].to.key);
            return parameter ? parameter->key : NULL;
        }
    return known_unaccounted_now(settings, reference);
}

bool known_text(const Settings *settings, char out[KNOWN_TEXT_MAX], long *step)
{
    const char *const names[REFERENCES] = {settings->problem->answer, "predicted", "frequency", "energy E*"};
    const char *unaccounted = NULL;
    out[0] = '\0';
    for (int i = 0; i < REFERENCES; i++) {
        const char *key = answer_invalid_because(settings, (Reference)i);
        unaccounted = unaccounted ? unaccounted : key;
        if (key && strcmp(key, unaccounted) == 0)
            text_list_add(out, KNOWN_TEXT_MAX, names[i]);
    }
    if (!unaccounted)
        return false;
    const size_t used = strlen(out);
    snprintf(out + used, KNOWN_TEXT_MAX - used, ": not known with %s", unaccounted);
    if (step)
        *step = 0;
    const Parameter *parameter = parameter_find(unaccounted);
    for (int i = settings->n_changes - 1; step && !is_at_work(settings, parameter) && i >= 0; i--)
        if (strcmp(settings->changes[i].to.key, unaccounted) == 0)
            *step = settings->changes[i].step;
    return true;
}
