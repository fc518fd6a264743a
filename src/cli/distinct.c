/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/distinct.h"

#include "base/output.h"

#include <stdlib.h>
#include <string.h>

static bool is_same(const char *real, const char *name)
{
    char *other = output_real_name(name, NULL);
    const bool same = other && strcmp(real, other) == 0;
    free(other);
    return same;
}

static bool is_alone(const char *const *outputs, int which, Status *status)
{
    const char *name = outputs[which];
    bool alone = true;
    if (output_is_standard(name)) {
        for (int i = 0; i < which && alone; i++)
            alone = !outputs[i] || !output_is_standard(outputs[i]) ||
                    status_refuse(status, "two outputs cannot both be standard output");
        return alone;
    }
    char *real = output_real_name(name, status);
    if (!real)
        return false;
    for (int i = 0; i < which && alone; i++)
        if (outputs[i] && !output_is_standard(outputs[i]) && is_same(real, outputs[i]))
            alone = status_refuse(status, "%s: two outputs cannot be the same file", name);
    free(real);
    return alone;
}

bool distinct_outputs(const char *const *outputs, int count, Status *status)
{
    for (int i = 0; i < count; i++)
        if (outputs[i] && !is_alone(outputs, i, status))
            return false;
    return true;
}
