/* `matvib params [PROBLEM]`: the parameter table for people. */
#include "cli/cli.h"
#include "cli/derived.h"
#include "cli/options.h"
#include "lab/settings/parameters.h"
#include "lab/answers/problem.h"

#include <stdio.h>
#include <string.h>

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
    static const char *const methods[] = {[OF_EVERY_METHOD] = "", [OF_MPM] = "  [mpm]", [OF_PD] = "  [pd]"};
    const bool choice = problem_allows(settings->problem, METHOD_MPM, NULL) &&
                        problem_allows(settings->problem, METHOD_PD, NULL);
    printf("  %-42s %s%s%s\n      %s\n", assignment, range, parameter->live ? "  [live]" : "",
           choice ? methods[parameter->only] : "", parameter_help(parameter, settings->problem));
}

static void print_indented(const char *text)
{
    while (*text) {
        size_t n = strcspn(text, "\n");
        printf("  %.*s\n", (int)n, text);
        text += n + (text[n] == '\n');
    }
}

static bool print_derived(Settings *settings, MethodKind method, Status *status)
{
    char derived[DERIVED_TEXT_MAX];
    settings->method = method;
    if (!derived_text(settings, derived, sizeof derived, status))
        return false;
    printf("\nFrom these (%s)\n", method_words[method]);
    print_indented(derived);
    return true;
}

static bool print_problem(Problem problem, Status *status)
{
    Settings settings;
    char methods[32] = "";
    settings_default(&settings, problem);
    for (int method = 0; method_words[method]; method++)
        if (problem_allows(problem, (MethodKind)method, NULL))
            snprintf(methods + strlen(methods), sizeof methods - strlen(methods), "%s%s",
                     *methods ? " | " : "", method_words[method]);
    printf("%s (%s): %s\n", problem_words[problem], methods, problem_facts[problem].title);
    const char *group = "";
    for (int i = 0; i < n_parameters; i++) {
        if (!parameter_applies(&parameters[i], problem))
            continue;
        if (strcmp(parameters[i].group, group) != 0)
            printf("\n%s\n", group = parameters[i].group);
        print_parameter(&settings, &parameters[i]);
    }
    for (int method = 0; method_words[method]; method++)
        if (problem_allows(problem, (MethodKind)method, NULL) &&
            !print_derived(&settings, (MethodKind)method, status))
            return false;
    putchar('\n');
    return true;
}

static bool find_problem(const char *word, int *problem, Status *status)
{
    for (*problem = 0; *problem < PROBLEM_COUNT; (*problem)++)
        if (strcmp(problem_words[*problem], word) == 0)
            return true;
    return status_fail(status, STATUS_USAGE, "params: %.60s is not a problem (%s | %s | %s | %s)", word,
                       problem_words[0], problem_words[1], problem_words[2], problem_words[3]);
}

int cli_params(int count, char **arguments, Status *status)
{
    Options options;
    if (!options_parse("params", count, arguments, &options, status) ||
        !options_words(&options, 0, 1, "[PROBLEM]", status))
        return STATUS_USAGE;
    int first = 0, last = PROBLEM_COUNT - 1;
    if (options.n_words == 1) {
        if (!find_problem(options.words[0], &first, status))
            return STATUS_USAGE;
        last = first;
    }
    for (int problem = first; problem <= last; problem++)
        if (!print_problem((Problem)problem, status))
            return (int)status->code;
    printf("[live] may change in mid-run; [mpm], [pd] only by that method.\nEach value is set by --set "
           "KEY=VALUE or in a scenario file.\n");
    return STATUS_DONE;
}
