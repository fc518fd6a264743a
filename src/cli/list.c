/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib list`: the built-in scenarios with their titles; `matvib lesson --list`: the lessons. */
#include "cli/cli.h"
#include "scenario/settings.h"
#include "cli/options.h"
#include "lessons/lesson.h"

#include <stdio.h>
#include <string.h>

int cli_list(Options *options, Status *status)
{
    (void)options;
    size_t width = 0;
    const BuiltinScenario *builtin;
    for (builtin = builtin_scenarios; builtin->name; builtin++)
        width = strlen(builtin->name) > width ? strlen(builtin->name) : width;
    for (builtin = builtin_scenarios; builtin->name; builtin++) {
        char title[TITLE_MAX];
        Settings settings;
        if (!scenario_load(builtin->name, &settings, status))
            return (int)status->code;
        strcpy(title, settings.title);
        printf("%-*s  %s\n", (int)width, builtin->name, title);
    }
    return STATUS_DONE;
}

int cli_list_lessons(void)
{
    size_t width = 0;
    const BuiltinLesson *builtin;
    for (builtin = builtin_lessons; builtin->name; builtin++)
        width = strlen(builtin->name) > width ? strlen(builtin->name) : width;
    for (builtin = builtin_lessons; builtin->name; builtin++)
        printf("%-*s  %s\n", (int)width, builtin->name, builtin->title);
    return STATUS_DONE;
}
