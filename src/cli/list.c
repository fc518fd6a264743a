/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib list [SCENARIO]`: the built-in scenarios with their titles, or what one is about; `matvib lesson
 * --list`: the lessons. */
#include "cli/cli.h"
#include "base/visible.h"
#include "scenario/settings.h"
#include "cli/options.h"
#include "lessons/lesson.h"

#include <stdio.h>
#include <string.h>

int cli_describe(const char *name, Status *status)
{
    Settings settings;
    if (!scenario_load(name, &settings, status))
        return (int)status->code;
    visible_print(stdout, "%s: %s\n", name, settings.title);
    visible_print(stdout, "%s\n", settings.about);
    return STATUS_DONE;
}

int cli_list(Options *options, Status *status)
{
    if (options->n_words == 1)
        return cli_describe(options->words[0], status);
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
