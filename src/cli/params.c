/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib params [PROBLEM|SCENARIO]`: the parameter table as text. */
#include "cli/cli.h"
#include "base/text.h"
#include "scenario/scenario.h"
#include "scenario/settings.h"
#include "cli/derived.h"
#include "cli/options.h"
#include "scenario/parameters.h"
#include "answers/references.h"

#include <stdio.h>
#include <string.h>

enum { RANGE_WIDTH = 66 }; /* of 120 columns */

static void print_parameter(const Settings *settings, const Parameter *parameter)
{
    char value[LIST_MAX], assignment[96], range[160];
    const char *unit = parameter_unit(parameter, settings->problem);
    settings_show(settings, parameter, value);
    const char *automatic = parameter_automatic(parameter, settings->problem);
    parameter_range(parameter, settings->problem, range, sizeof range);
    /* neither a word nor nothing at all has a unit */
    if (!*value || (automatic && strcmp(value, automatic) == 0))
        unit = "";
    snprintf(assignment, sizeof assignment, "%s =%s%.60s%s%s", parameter->key, *value ? " " : "", value,
             *unit ? " " : "", unit);
    static const char *const methods[] = {[BY_EVERY_METHOD] = "", [BY_MPM] = "  [mpm]", [BY_PD] = "  [pd]"};
    const bool choice = settings->problem->concerns & CONCERN_METHODS;
    const bool wide = strlen(range) > RANGE_WIDTH; /* has a line of its own */
    printf("  %-*s%s%s%s%s\n      %s\n", wide ? 0 : 43, assignment, wide ? "\n      " : "", range,
           parameter->live ? "  [live]" : "",
           choice ? methods[parameter_methods(parameter, settings->problem)] : "",
           parameter_help(parameter, settings->problem));
    for (int i = 1; parameter->choice_help && i < parameter_choices(parameter, settings->problem); i++)
        printf("      %-22s %s\n", parameter->choices[i], parameter->choice_help(i));
}

static bool print_derived(Settings *settings, MethodKind method, Status *status)
{
    char derived[DERIVED_TEXT_MAX];
    settings->method = method;
    if (!derived_text(settings, derived, sizeof derived, status))
        return false;
    printf("\nFrom these (%s)\n", settings_method_words[method]);
    const char *text = derived;
    while (*text) {
        size_t n = strcspn(text, "\n");
        printf("  %.*s\n", (int)n, text);
        text += n + (text[n] == '\n');
    }
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

/* A problem with its defaults, or else a scenario with its values. */
static bool find_settings(const char *word, Settings *settings, Status *status)
{
    const Problem *problem = problem_find(word);
    char words[256] = "";
    for (int i = 0; problems[i]; i++)
        text_or(words, sizeof words, problems[i]->word);
    if (problem)
        settings_default(settings, problem);
    else if (scenario_builtin(word) || strpbrk(word, "./"))
        return scenario_load(word, settings, status);
    return problem || status_refuse(status, "params: %.60s is not a problem (%s) or a scenario", word, words);
}

int cli_params(Options *options, Status *status)
{
    Settings settings;
    if (options->n_words == 1 && (!find_settings(options->words[0], &settings, status) ||
                                  !print_problem(&settings, !problem_find(options->words[0]), status)))
        return (int)status->code;
    for (int i = 0; problems[i] && options->n_words == 0; i++) {
        settings_default(&settings, problems[i]);
        if (!print_problem(&settings, false, status))
            return (int)status->code;
    }
    printf("[live] may change in mid-run; [mpm], [pd] only by that method.\nEach value is set by --set "
           "KEY=VALUE or in a scenario file.\n");
    return STATUS_DONE;
}
