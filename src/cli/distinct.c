/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cli/distinct.h"

#include "base/output.h"

#include <stdlib.h>
#include <string.h>

/* What is not there yet, or has no folder, is no input that could be overwritten. */
static bool is_same(const char *real, const char *name)
{
    Status status = {STATUS_DONE, ""};
    char *other = output_real_name(name, &status);
    const bool same = other && strcmp(real, other) == 0;
    free(other);
    return same;
}

static bool is_alone(const char *const *outputs, int which, const char *const *inputs, int n_inputs,
                     Status *status)
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
    for (int i = 0; i < n_inputs && alone; i++)
        if (is_same(real, inputs[i]))
            alone = status_refuse(status, "%s: it is read, so it cannot be written too", name);
    free(real);
    return alone;
}

bool distinct_files(const char *const *outputs, int n_outputs, const char *const *inputs, int n_inputs,
                    Status *status)
{
    for (int i = 0; i < n_outputs; i++)
        if (outputs[i] && !is_alone(outputs, i, inputs, n_inputs, status))
            return false;
    return true;
}
