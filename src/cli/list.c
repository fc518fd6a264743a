/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib list [SCENARIO]`: the built-in scenarios with their titles, or what one is about; `matvib lesson
 * --list`: the lessons with their minutes. */
#include "cli/cli.h"
#include "base/visible.h"
#include "scenario/settings.h"
#include "cli/options.h"
#include "lessons/lesson.h"
#include "base/text.h"
#include "scenario/scenario.h"
#include "scenario/parameters.h"

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
        printf("%-*s  %3s min  %s\n", (int)width, builtin->name, builtin->minutes ? builtin->minutes : "",
               builtin->title);
    return STATUS_DONE;
}

/* `matvib show SCENARIO`: what a scenario comes to, as a scenario file. */

int cli_show(Options *options, Status *status)
{
    Settings settings;
    char comment[DERIVED_TEXT_MAX];
    if (!options_load(options, options->words[0], &settings, status))
        return (int)status->code;
    if (!cli_derived_text(&settings, comment, sizeof comment, status)) {
        options_blame(options, options->words[0], status);
        return (int)status->code;
    }
    return progress_result(scenario_write(stdout, &settings, comment, status), status);
}

/* `matvib params [PROBLEM|SCENARIO]`: the parameter table as text. */

enum { RANGE_WIDTH = 66 }; /* of 120 columns */

enum { LINE_WIDTH = 120, CHOICE_INDENT = 29 };

static void print_parameter(const Settings *settings, const Parameter *parameter)
{
    char value[LIST_MAX], assignment[96], range[160];
    const Parameter row = parameter_in(parameter, settings->problem);
    const char *unit = row.unit;
    settings_show(settings, parameter, value);
    parameter_range(parameter, settings->problem, range, sizeof range);
    /* neither a word nor nothing at all has a unit */
    if (!*value || (row.automatic && strcmp(value, row.automatic) == 0))
        unit = "";
    snprintf(assignment, sizeof assignment, "%s =%s%.60s%s%s", parameter->key, *value ? " " : "", value,
             *unit ? " " : "", unit);
    static const char *const methods[] = {[BY_EVERY_METHOD] = "", [BY_MPM] = "  [mpm]", [BY_PD] = "  [pd]"};
    const bool choice = settings->problem->concerns & CONCERN_METHODS;
    const bool wide = strlen(range) > RANGE_WIDTH; /* has a line of its own */
    printf("  %-*s%s%s%s%s\n      %s\n", wide ? 0 : 43, assignment, wide ? "\n      " : "", range,
           parameter->live ? "  [live]" : "", choice ? methods[row.methods] : "", row.help);
    for (int i = 1; row.choice_help && i < row.n_choices; i++) {
        /* A choice that this problem refuses whatever else is set is marked with what it is defined for. */
        static const char defined[] = " is defined for ";
        Settings other = *settings;
        Status why = {STATUS_DONE, ""};
        const char *word = parameter->choices[i], *sentence = parameter->choice_help(i), *mark = NULL;
        while (row.methods != BY_EVERY_METHOD && !(row.methods >> other.method & 1))
            other.method = (MethodKind)((other.method + 1) % METHODS);
        if (settings_set(&other, parameter->key, word, &why) && !settings_check(&other, &why))
            mark = strstr(why.text, defined);
        printf("      %-22s %s", word, sentence);
        if (mark && !strchr(mark, '=')) {
            mark += strlen(defined);
            const bool folded = CHOICE_INDENT + strlen(sentence) + strlen(mark) + 4 > LINE_WIDTH;
            printf("%s%*s[%s]", folded ? "\n" : "", folded ? CHOICE_INDENT : 2, "", mark);
        }
        putchar('\n');
    }
}

static bool print_derived(Settings *settings, MethodKind method, Status *status)
{
    char derived[DERIVED_TEXT_MAX], *place = NULL;
    settings->method = method;
    if (!cli_derived_text(settings, derived, sizeof derived, status))
        return false;
    printf("\nFrom these (%s)\n", settings_method_words[method]);
    for (char *line = strtok_r(derived, "\n", &place); line; line = strtok_r(NULL, "\n", &place))
        printf("  %s\n", line);
    return true;
}

/* What follows from the settings is that of the method of a scenario, and of a problem that of each. */
static bool print_problem(Settings *settings, bool scenario, Status *status)
{
    const Problem *problem = settings->problem;
    char methods[32] = "";
    for (int method = 0; settings_method_words[method]; method++)
        if (problem_allows(problem, (MethodKind)method, NULL))
            text_or(methods, sizeof methods, settings_method_words[method]);
    printf("%s (%s): %s\n", problem->word, methods, problem->title);
    const char *group = "";
    for (int i = 0; i < n_parameters; i++) {
        if (!parameter_applies(&parameters[i], problem))
            continue;
        if (strcmp(parameters[i].group, group) != 0)
            printf("\n%s\n", group = parameters[i].group);
        print_parameter(settings, &parameters[i]);
    }
    for (const FixedKey *fixed = fixed_keys; fixed->key; fixed++)
        if (fixed == fixed_key_find(settings, fixed->key))
            printf("\nFixed\n  %s = %s\n      %s\n", fixed->key, fixed->value, fixed->reason);
    const MethodKind own = settings->method;
    Status incomplete;
    if (!settings_check(settings, &incomplete)) /* bodies, of which each scenario has its own */
        printf("\nA scenario needs more than these: %s\n", incomplete.text);
    else
        for (int method = 0; settings_method_words[method]; method++)
            if (problem_allows(problem, (MethodKind)method, NULL) &&
                (!scenario || (MethodKind)method == own) &&
                !print_derived(settings, (MethodKind)method, status))
                return false;
    putchar('\n');
    return true;
}

int cli_params(Options *options, Status *status)
{
    Settings settings;
    if (options->n_words == 1) {
        /* A problem with its defaults, or else a scenario with its values. */
        const char *word = options->words[0];
        const Problem *problem = problem_find(word);
        char words[256] = "";
        for (int i = 0; problems[i]; i++)
            text_or(words, sizeof words, problems[i]->word);
        bool found = problem != NULL;
        if (problem)
            settings_default(&settings, problem);
        else if (scenario_builtin(word) || strpbrk(word, "./"))
            found = scenario_load(word, &settings, status);
        else
            status_refuse(status, "params: %.60s is not a problem (%s) or a scenario", word, words);
        if (!found || !print_problem(&settings, !problem, status))
            return (int)status->code;
    }
    for (int i = 0; problems[i] && options->n_words == 0; i++) {
        settings_default(&settings, problems[i]);
        if (!print_problem(&settings, false, status))
            return (int)status->code;
    }
    printf("[live] may change in mid-run; [mpm], [pd] only by that method.\nEach value is set by --set "
           "KEY=VALUE or in a scenario file.\n");
    return STATUS_DONE;
}
