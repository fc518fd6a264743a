/* Fills the frame of a manual page from the program's own tables: write_manual FRAME > PAGE.
 *
 * A line "@name argument" of the frame stands for a table; @VERSION@ for the version anywhere. What the
 * tables say is what the program does, so a page cannot fall behind it. */
#include "cli/cli.h"
#include "cli/options.h"
#include "cli/sweep/sweep_result.h"
#include "lab/lessons/lesson.h"
#include "lab/settings/parameters.h"
#include "lab/answers/problem.h"
#include "tui/control/script.h"
#include "view/panes/commands.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- roff ----------------------------------------------------------------------------------------- */

/* Text as it is: no character may be taken for a request, a hyphen stays a minus that can be copied. */
static void say(const char *text)
{
    static const struct {
        char c;
        const char *roff;
    } escapes[] = {{'\\', "\\e"},  {'-', "\\-"},   {'^', "\\(ha"},
                   {'~', "\\(ti"}, {'`', "\\(ga"}, {'\'', "\\(aq"}};
    if (*text == '.')
        fputs("\\&", stdout);
    for (; *text; text++) {
        const char *roff = NULL;
        for (size_t i = 0; i < sizeof escapes / sizeof *escapes; i++)
            if (escapes[i].c == *text)
                roff = escapes[i].roff;
        if (roff)
            fputs(roff, stdout);
        else
            putchar(*text);
    }
}

static void say_in(const char *font, const char *text)
{
    printf("\\f%s", font);
    say(text);
    fputs("\\fR", stdout);
}

static void say_line(const char *text)
{
    say(text);
    putchar('\n');
}

static void heading(const char *text)
{
    fputs(".SS ", stdout);
    say_line(text);
}

/* --- command line --------------------------------------------------------------------------------- */

static bool write_options(const char *command)
{
    char word[32];
    snprintf(word, sizeof word, " %s ", command);
    for (int i = 0; i < n_options; i++) {
        const Option *option = &options_table[i];
        if (!strstr(option->commands, word))
            continue;
        puts(".TP");
        say_in("B", option->name);
        if (option->argument) {
            putchar(' ');
            say_in("I", option->argument);
        }
        putchar('\n');
        say_line(option->help);
    }
    return true;
}

static bool write_commands(const char *unused)
{
    (void)unused;
    for (const CliCommand *command = cli_commands; command->name; command++) {
        fputs(".SS matvib ", stdout);
        say(command->name);
        if (*command->synopsis) {
            putchar(' ');
            say(command->synopsis);
        }
        putchar('\n');
        say_line(command->help);
        write_options(command->name);
    }
    return true;
}

/* --- scenarios ------------------------------------------------------------------------------------ */

static bool write_scenarios(const char *unused)
{
    (void)unused;
    for (const BuiltinScenario *builtin = builtin_scenarios; builtin->name; builtin++) {
        char title[TITLE_MAX];
        if (!scenario_title(builtin, title))
            return false;
        puts(".TP");
        say_in("B", builtin->name);
        putchar('\n');
        say_line(title);
    }
    return true;
}

static bool write_lessons(const char *unused)
{
    (void)unused;
    for (const BuiltinLesson *builtin = builtin_lessons; builtin->name; builtin++) {
        Lesson lesson;
        if (!lesson_load(builtin->name, line_is_for_lessons, &lesson, NULL))
            return false;
        puts(".TP");
        say_in("B", builtin->name);
        putchar('\n');
        say(lesson.title);
        fputs(": ", stdout);
        say_line(lesson.about ? lesson.about : "");
        lesson_free(&lesson);
    }
    return true;
}

static bool write_texts(const char *unused)
{
    (void)unused;
    for (int i = 0; i < n_text_keys; i++) {
        puts(".TP");
        say_in("B", text_keys[i].key);
        putchar('\n');
        say_line(text_keys[i].help);
    }
    return true;
}

/* --- keys of the laboratory ----------------------------------------------------------------------- */

static bool write_keys(const char *unused)
{
    (void)unused;
    const char *group = "";
    for (int i = 0; i < n_commands; i++) {
        if (strcmp(group, commands[i].group) != 0)
            heading(group = commands[i].group);
        puts(".TP");
        say_in("B", commands[i].keys);
        printf(" (");
        say(commands[i].name);
        puts(")");
        say_line(commands[i].help);
    }
    heading("Behind :");
    for (int i = 0; i < n_line_verbs; i++) {
        puts(".TP");
        say_in("B", line_verbs[i].name);
        putchar(' ');
        say_in("I", line_verbs[i].arguments);
        putchar('\n');
        say_line(line_verbs[i].help);
    }
    return true;
}

static bool write_script(const char *unused)
{
    (void)unused;
    for (const ScriptInstruction *row = script_instructions; row->name; row++) {
        puts(".TP");
        say_in("B", row->name);
        if (*row->arguments) {
            putchar(' ');
            say_in("I", row->arguments);
        }
        putchar('\n');
        say_line(row->help);
    }
    return true;
}

/* --- parameters ----------------------------------------------------------------------------------- */

/* The default of each problem from `first` to `last`; once where it is the same for all. */
static void write_defaults(const Parameter *parameter, Problem first, Problem last)
{
    char values[PROBLEM_COUNT][LIST_MAX];
    const char *one = NULL;
    bool same = true;
    for (Problem p = first; p <= last; p++) {
        Settings settings;
        settings_default(&settings, p);
        settings_show(&settings, parameter, values[p]);
        if (parameter_applies(parameter, p)) {
            same = same && (!one || strcmp(one, values[p]) == 0);
            one = values[p];
        }
    }
    if (!one || (same && !*one))
        return;
    fputs(" Default ", stdout);
    const char *comma = "";
    for (Problem p = first; p <= last; p++) {
        if (!parameter_applies(parameter, p))
            continue;
        fputs(comma, stdout);
        say_in("B", values[p]);
        if (same)
            break;
        printf(" (%s)", problem_words[p]);
        comma = ", ";
    }
    putchar('.');
}

static void write_of_problems(const Parameter *parameter, Problem first, Problem last)
{
    int count = 0;
    for (Problem p = first; p <= last; p++)
        count += parameter_applies(parameter, p);
    if (count == (int)(last - first) + 1)
        return;
    fputs(" Of ", stdout);
    for (Problem p = first; p <= last; p++)
        if (parameter_applies(parameter, p)) {
            say(problem_words[p]);
            fputs(--count ? ", " : " only.", stdout);
        }
}

static void write_parameter(const Parameter *parameter, Problem first, Problem last)
{
    char range[160];
    const char *unit = parameter_unit(parameter, first);
    parameter_range(parameter, first, range, sizeof range);
    puts(".TP");
    say_in("B", parameter->key);
    fputs("  ", stdout);
    say(range);
    if (*unit) {
        fputs(" [", stdout);
        say(unit);
        putchar(']');
    }
    putchar('\n');
    say(parameter->help);
    if (parameter->help_moving) {
        fputs("; of the moving cantilever: ", stdout);
        say(parameter->help_moving);
    }
    putchar('.');
    write_of_problems(parameter, first, last);
    if (first == PROBLEM_BAR && parameter->only != OF_EVERY_METHOD)
        printf(" Of method %s only.", parameter->only == OF_MPM ? "mpm" : "pd");
    write_defaults(parameter, first, last);
    if (parameter->live)
        fputs(" May change in mid\\-run.", stdout);
    putchar('\n');
}

static bool write_parameters(const char *which)
{
    bool bar = strcmp(which, "bar") == 0;
    Problem first = bar ? PROBLEM_BAR : PROBLEM_SUPPORTED_BEAM;
    Problem last = bar ? PROBLEM_BAR : PROBLEM_NOTCHED_BEAM;
    for (int i = 0; i < n_parameters; i++) {
        bool of_any = false;
        for (Problem p = first; p <= last; p++)
            of_any = of_any || parameter_applies(&parameters[i], p);
        if (of_any)
            write_parameter(&parameters[i], first, last);
    }
    return true;
}

/* --- columns of the files ------------------------------------------------------------------------- */

static void write_quantity(const Quantity *quantity)
{
    puts(".TP");
    say_in("B", quantity->name);
    if (*quantity->unit && strcmp(quantity->unit, "1") != 0) {
        fputs(" [", stdout);
        say(quantity->unit);
        putchar(']');
    }
    putchar('\n');
    say_line(quantity->meaning);
}

static bool write_series(const char *scenario)
{
    Settings settings;
    Status status = {0};
    Column columns[COLUMNS_MAX];
    Simulation *simulation = NULL;
    References *references = NULL;
    if (scenario_load(scenario, &settings, &status) && (simulation = problem_simulate(&settings, 1, &status)))
        references = problem_references(&settings, simulation, &status);
    int count = references ? references_columns(references, columns) : 0;
    for (int i = 0; i < count; i++)
        write_quantity(&columns[i].quantity);
    references_destroy(references);
    simulation_destroy(simulation);
    return count > 0;
}

static bool write_tables(const char *scenario)
{
    Settings settings;
    Status status = {0};
    if (!scenario_load(scenario, &settings, &status))
        return false;
    Simulation *simulation = problem_simulate(&settings, 1, &status);
    for (int set = 0; simulation && set < simulation->n_sets; set++) {
        fputs(".PP\nA table of ", stdout);
        say(simulation->sets[set].plural);
        puts(" has the columns step, time, the index, and");
        for (int i = 0; i < simulation->n_fields; i++)
            if (simulation->fields[i].set == set && simulation->fields[i].in_table)
                write_quantity(&simulation->fields[i].quantity);
    }
    simulation_destroy(simulation);
    return simulation != NULL;
}

/* Units that depend on the problem are told by the meaning. */
static bool write_results(const char *argument)
{
    (void)argument;
    for (int column = 0; column < RESULT_COLUMNS; column++) {
        Quantity quantity = result_quantity((ResultColumn)column, PROBLEM_BAR);
        if (strcmp(quantity.unit, result_quantity((ResultColumn)column, PROBLEM_SUPPORTED_BEAM).unit) != 0)
            quantity.unit = "";
        write_quantity(&quantity);
    }
    return true;
}

/* --- the frame ------------------------------------------------------------------------------------ */

static const struct {
    const char *name;
    bool (*write)(const char *argument);
} tables[] = {
    {"commands", write_commands},     {"keys", write_keys},       {"options", write_options},
    {"parameters", write_parameters}, {"results", write_results}, {"scenarios", write_scenarios},
    {"lessons", write_lessons},       {"script", write_script},   {"series", write_series},
    {"tables", write_tables},         {"texts", write_texts},
};

static bool fill(char *line)
{
    char *argument = strchr(line, ' ');
    if (argument)
        *argument++ = '\0';
    for (size_t i = 0; i < sizeof tables / sizeof *tables; i++)
        if (strcmp(tables[i].name, line + 1) == 0)
            return tables[i].write(argument ? argument : "");
    return false;
}

static void copy(char *line)
{
    static const char mark[] = "@VERSION@";
    for (char *found; (found = strstr(line, mark)); line = found + strlen(mark))
        printf("%.*s%s", (int)(found - line), line, PACKAGE_VERSION);
    puts(line);
}

int main(int count, char **arguments)
{
    FILE *frame = count == 2 ? fopen(arguments[1], "r") : NULL;
    char line[1024];
    if (!frame) {
        fputs("usage: write_manual FRAME > PAGE\n", stderr);
        return 2;
    }
    puts(".\\\" Generated by tools/write_manual from a frame and the program's tables.");
    while (fgets(line, sizeof line, frame)) {
        line[strcspn(line, "\n")] = '\0';
        if (*line != '@') {
            copy(line);
        } else if (!fill(line)) {
            fprintf(stderr, "write_manual: %s: no such table, or it is empty\n", line);
            return 1;
        }
    }
    fclose(frame);
    return fflush(stdout) == 0 && !ferror(stdout) ? 0 : 1;
}
