/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Derived numbers of the simulation that the settings make, one a line, then the advice or the refusal
 * that a run would get (derived.h). */
#include "cli/derived.h"

#include "base/shortage.h"
#include "base/text.h"
#include "problems/problem.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

static size_t add_line(char *out, size_t size, size_t used, const Derived *derived)
{
    char value[NUMBER_TEXT_MAX];
    if (used >= size)
        return used;
    if (derived->integer)
        snprintf(value, sizeof value, "%.0f", derived->value);
    else
        text_shortest(value, derived->value);
    const char *unit = strcmp(derived->unit, "1") == 0 ? "" : derived->unit; /* a plain number */
    int n = snprintf(out + used, size - used, "%s = %s%s%s\n", derived->name, value, *unit ? " " : "", unit);
    return used + (n > 0 ? (size_t)n : 0);
}

bool derived_text(const Settings *settings, char *out, size_t size, Status *status)
{
    char advice[240] = "";
    Derived derived[DERIVED_MAX];
    Simulation *simulation = problem_simulate(settings, 1, status);
    if (!simulation)
        return false;
    const int before = shortage_begin();
    int count = problem_derived(settings, simulation, derived);
    const bool complete = errno != ENOMEM;
    shortage_end(before);
    simulation_destroy(simulation);
    if (!complete)
        return status_fail(status, "not enough memory for the numbers that follow from these");
    size_t used = 0;
    out[0] = '\0';
    for (int i = 0; i < count; i++)
        used = add_line(out, size, used, &derived[i]);
    Status refusal = {0};
    bool allowed = problem_advice(settings, advice, sizeof advice, &refusal);
    if (used < size && (!allowed || *advice))
        snprintf(out + used, size - used, "%s%s\n",
                 allowed ? "" : "a run is refused: ", allowed ? advice : refusal.text);
    return true;
}
