/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fills the frame of a manual page from the program's own tables: write_manual FRAME > PAGE.
 *
 * A line "@name argument" of the frame stands for a table; @VERSION@ for the version anywhere. What the
 * tables say is what the program does, so a page cannot fall behind it. */
#include "panes/panes.h"
#include "base/text.h"
#include "cli/cli.h"
#include "scenario/rows/rows.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"
#include "cli/options.h"
#include "cli/sweep/sweep_plan.h"
#include "answers/choices.h"
#include "lessons/lesson.h"
#include "answers/run_numbers.h"
#include "scenario/parameters.h"
#include "answers/references.h"
#include "lab/session/script.h"
#include "help/command.h"

#include <ctype.h>
#include <stdarg.h>
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

/* A heading begins a paragraph by itself. */
static bool after_heading;

static void begin_paragraph(void)
{
    if (!after_heading)
        puts(".PP");
    after_heading = false;
}

static void heading(const char *text)
{
    fputs(".SS ", stdout);
    say_line(text);
}

/* --- command line --------------------------------------------------------------------------------- */

static void write_option(const Option *option)
{
    if (option->letter) {
        const char letter[] = {'-', option->letter, '\0'};
        say_in("B", letter);
        fputs(", ", stdout);
    }
    say_in("B", option->name);
    if (option->argument) {
        putchar(' ');
        say_in("I", option->argument);
    }
}

/* Those that the laboratory has too are described once, with it, and named here. */
static bool write_options(const char *command)
{
    char word[32];
    const char *before = ".PP\nAlso ";
    snprintf(word, sizeof word, " %s ", command);
    for (int again = 0; again < 2; again++)
        for (const Option *option = options_table; option < options_table + n_options; option++) {
            const bool described = strcmp(command, "open") == 0 || !strstr(option->commands, " open ");
            if (!strstr(option->commands, word) || described == (again == 1))
                continue;
            fputs(described ? ".TP\n" : before, stdout);
            write_option(option);
            if (described) {
                putchar('\n');
                say_line(option->help);
            }
            before = described ? before : ", ";
        }
    if (*before == ',')
        puts(".");
    return true;
}

/* The command's name, words and help as a sentence: the frame goes on from there. */
static bool write_command(const char *name)
{
    const CliCommand *command = cli_find(name);
    if (!command)
        return false;
    fputs(".SS matvib ", stdout);
    say(command->name);
    if (*command->synopsis) {
        putchar(' ');
        say(command->synopsis);
    }
    putchar('\n');
    putchar(toupper((unsigned char)command->help[0]));
    say(command->help + 1);
    puts(strchr(".?", command->help[strlen(command->help) - 1]) ? "" : ".");
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
        if (!lesson_load(builtin->name, command_line_for_lessons, &lesson, NULL))
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
    for (int i = 0; i < n_parameters; i++) {
        if (parameters[i].concern != CONCERN_NONE)
            continue;
        puts(".TP");
        say_in("B", parameters[i].key);
        putchar('\n');
        say_line(parameters[i].help);
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
        say_line(pane_command_help(&commands[i]));
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

/* Whether the parameter is one of a problem of this part of the page. */
static bool is_of(const Parameter *parameter, const Problem *problem, int concern)
{
    return (problem->concerns & concern) && parameter_applies(parameter, problem);
}

/* The default in each problem of the part; once where it is the same for all. */
static void write_defaults(const Parameter *parameter, int concern)
{
    char values[PROBLEMS_MAX][LIST_MAX];
    const char *one = NULL;
    bool same = true;
    for (int p = 0; problems[p]; p++) {
        Settings settings;
        if (!is_of(parameter, problems[p], concern))
            continue;
        settings_default(&settings, problems[p]);
        settings_show(&settings, parameter, values[p]);
        same = same && (!one || strcmp(one, values[p]) == 0);
        one = values[p];
    }
    if (!one || (same && !*one))
        return;
    fputs(" Default ", stdout);
    const char *comma = "";
    for (int p = 0; problems[p]; p++) {
        if (!is_of(parameter, problems[p], concern))
            continue;
        fputs(comma, stdout);
        say_in("B", values[p]);
        if (same)
            break;
        printf(" (%s)", problems[p]->word);
        comma = ", ";
    }
    putchar('.');
}

static void write_of_problems(const Parameter *parameter, int concern)
{
    int all = 0, count = 0;
    for (int p = 0; problems[p]; p++) {
        all += (problems[p]->concerns & concern) != 0;
        count += is_of(parameter, problems[p], concern);
    }
    if (count == all)
        return;
    fputs(" Of ", stdout);
    for (int p = 0; problems[p]; p++)
        if (is_of(parameter, problems[p], concern)) {
            say(problems[p]->word);
            fputs(--count ? ", " : " only.", stdout);
        }
}

/* What the problems of this part say of it, each text once: with the problem's name where another came first.
 */
static void write_help(const Parameter *parameter, int concern)
{
    const char *said[PROBLEMS_MAX];
    int n = 0;
    for (int p = 0; problems[p]; p++) {
        const char *help = parameter_in(parameter, problems[p]).help;
        bool again = false;
        for (int k = 0; k < n; k++)
            again = again || strcmp(said[k], help) == 0;
        if (again || !is_of(parameter, problems[p], concern))
            continue;
        if (n > 0) {
            fputs("; of the ", stdout);
            for (const char *c = problems[p]->word; *c; c++)
                putchar(*c == '-' ? ' ' : *c);
            fputs(": ", stdout);
        }
        say(said[n++] = help);
    }
}

static void write_parameter(const Parameter *parameter, int concern)
{
    const Problem *first = NULL;
    for (int p = 0; problems[p] && !first; p++)
        first = is_of(parameter, problems[p], concern) ? problems[p] : NULL;

    char range[160];
    const char *unit = parameter_in(parameter, first).unit;
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
    write_help(parameter, concern);
    putchar('.');
    write_of_problems(parameter, concern);
    if (first->concerns & CONCERN_METHODS && parameter->methods != BY_EVERY_METHOD)
        printf(" Of method %s only.",
               settings_method_words[parameter->methods & BY_MPM ? METHOD_MPM : METHOD_PD]);
    write_defaults(parameter, concern);
    if (parameter->live)
        fputs(" May change in mid\\-run.", stdout);
    putchar('\n');
    if (parameter->wrong)
        puts("Each is described in\n.BR matvib-equations (7).");
    for (int i = 1;
         !parameter->wrong && parameter->choice_help && i < parameter_in(parameter, first).n_choices; i++) {
        puts(".br");
        say_in("B", parameter->choices[i]);
        fputs(": ", stdout);
        say(parameter->choice_help(i));
        putchar('\n');
    }
}

static bool write_parameters(const char *which)
{
    const int concern = strcmp(which, "bar") == 0      ? CONCERN_BAR
                        : strcmp(which, "plates") == 0 ? CONCERN_PLATE
                        : strcmp(which, "bodies") == 0 ? CONCERN_BODIES
                                                       : CONCERN_BEAM;
    for (int i = 0; i < n_parameters; i++) {
        bool of_any = false;
        for (int p = 0; problems[p]; p++)
            of_any = of_any || is_of(&parameters[i], problems[p], concern);
        if (of_any)
            write_parameter(&parameters[i], concern);
    }
    for (const FixedKey *fixed = fixed_keys; fixed->key; fixed++)
        if (fixed->concern & concern) {
            puts(".TP");
            say_in("B", fixed->key);
            fputs("  always ", stdout);
            say_line(fixed->value);
            fputs("No parameter: ", stdout);
            say_line(fixed->reason);
        }
    return true;
}

/* --- rows of a plate ------------------------------------------------------------------------------ */

static bool write_rows(const char *unused)
{
    (void)unused;
    for (const RowKind *kind = row_kinds; kind < row_kinds + ROW_KINDS; kind++) {
        puts(".TP");
        printf(".B [%s]\\ \n", kind->section);
        for (int i = 0; kind->usual && i < kind->n_columns; i++)
            printf("%s%s", i ? ", " : "", kind->columns[i].word);
        say(kind->usual ? "" : "NAME = ");
        say_line(kind->usual ? "" : kind->form);
        puts(".br");
        say(kind->help);
        puts(".");
        const char *comma = "";
        for (int i = 0; i < kind->n_columns; i++) {
            if (!*kind->columns[i].unit)
                continue;
            printf("%s%s ", *comma ? comma : "Units: ", kind->columns[i].word);
            say(kind->columns[i].unit);
            comma = ", ";
        }
        if (*comma)
            puts(".");
        if (kind->usual) {
            fputs("Default ", stdout);
            say_in("B", kind->usual);
            puts(".");
        }
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

/* All columns; those that cost more than the step say that they are to be asked for. */
static bool write_series(const char *scenario)
{
    Settings settings;
    Status status = {0};
    Column columns[COLUMNS_MAX];
    Simulation *simulation = NULL;
    References *references = NULL;
    Simulation *plain =
        scenario_load(scenario, &settings, &status) ? problem_simulate(&settings, 1, &status) : NULL;
    strcpy(settings_edit_output(&settings)->columns, "all");
    if (plain && (simulation = problem_simulate(&settings, 1, &status)))
        references = references_create(&settings, simulation, &status);
    int count = references ? references_columns(references, columns) : 0;
    for (int i = 0; i < count; i++) {
        const char *name = columns[i].quantity.name;
        write_quantity(&columns[i].quantity);
        if (simulation_find_series(simulation, name) >= 0 && simulation_find_series(plain, name) < 0)
            puts("(where\n.B \\-\\-columns\nasks for it)");
    }
    references_destroy(references);
    simulation_destroy(simulation);
    simulation_destroy(plain);
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
        begin_paragraph();
        fputs("A table of ", stdout);
        say(simulation->sets[set].plural);
        puts(" has the columns step, time, the index, and");
        for (int i = 0; i < simulation->n_fields; i++)
            if (simulation->fields[i].set == set && simulation->fields[i].in_table)
                write_quantity(&simulation->fields[i].quantity);
    }
    simulation_destroy(simulation);
    return simulation != NULL;
}

static bool write_results(const char *argument)
{
    (void)argument;
    for (int column = 0; column < RESULT_COLUMNS; column++)
        write_quantity(&sweep_columns[column]);
    return true;
}

/* --- where the papers are silent ------------------------------------------------------------------- */

/* By what they are about, so that each has one heading. */
static bool write_choices(const char *argument)
{
    (void)argument;
    for (const Choice *choice = choices; choice < choices + n_choices; choice++) {
        fputs(".TP\n.B ", stdout);
        say_line(choice->what);
        fputs("Paper: ", stdout);
        say_line(choice->paper);
        fputs("Here: ", stdout);
        say_line(choice->here);
    }
    return true;
}

/* The words of a run that a lesson's exercises may use. */
static bool write_run_numbers(const char *unused)
{
    (void)unused;
    for (const RunNumber *row = run_numbers; row->word; row++) {
        puts(".TP");
        say_in("B", row->word);
        putchar('\n');
        say_line(row->help);
    }
    return true;
}

/* Those that are shown in large digits, with their words. */
static bool write_about_numbers(const char *unused)
{
    (void)unused;
    for (const RunNumber *row = run_numbers; row->word; row++) {
        if (!row->label)
            continue;
        puts(".TP");
        say_in("B", row->word);
        putchar('\n');
        printf("%s%s%s%s%s\n", row->unit, row->unit[0] ? " " : "", row->label, row->opposite ? ", or " : "",
               row->opposite ? row->opposite : "");
    }
    return true;
}

/* What each value of a parameter of mistakes does. */
static bool write_mistakes(const char *key)
{
    const Parameter *parameter = parameter_find(key);
    for (int i = 1; parameter && parameter->choice_help && parameter->choices[i]; i++) {
        fputs(".TP\n.B ", stdout);
        say_line(parameter->choices[i]);
        say_line(parameter->choice_help(i));
    }
    return parameter && parameter->wrong;
}

/* --- stages ---------------------------------------------------------------------------------------- */

/* The simulation of "SCENARIO KEY=VALUE ...": the caller destroys it. */
static Simulation *simulation_of(const char *argument)
{
    char words[256];
    Settings settings;
    Status status = {0};
    snprintf(words, sizeof words, "%s", argument);
    char *rest, *word = strtok_r(words, " ", &rest);
    if (!word || !scenario_load(word, &settings, &status))
        return NULL;
    while ((word = strtok_r(NULL, " ", &rest))) {
        char *value = strchr(word, '=');
        if (!value)
            return NULL;
        *value++ = '\0';
        if (!settings_set(&settings, word, value, &status))
            return NULL;
    }
    return problem_simulate(&settings, 1, &status);
}

static void write_stage(const Stage *stage)
{
    enum { PAGE = 80, INDENT = 7 };
    size_t widest = 0;
    char equation[512];
    text_to_ascii(stage->equation, equation, sizeof equation);
    for (const char *line = equation; *line; line += strspn(line, "\n")) {
        const size_t length = strcspn(line, "\n");
        widest = length > widest ? length : widest;
        line += length;
    }
    begin_paragraph();
    say_in("B", stage->id);
    fputs(" (", stdout);
    say(stage->source);
    puts("):");
    say_line(stage->sentence);
    puts(".PP\n.nf");
    if (widest > PAGE - INDENT) /* it stands further out than the text */
        printf(".in %zun\n", widest < PAGE ? PAGE - widest : 0);
    for (const char *line = equation; *line; line += strspn(line, "\n")) {
        char one[128];
        const size_t length = strcspn(line, "\n");
        snprintf(one, sizeof one, "%.*s", (int)length, line);
        say_line(one);
        line += length;
    }
    puts(widest > PAGE - INDENT ? ".in\n.fi" : ".fi");
}

/* "SCENARIO KEY=VALUE ...": the stages of a step, in their order. */
static bool write_stages(const char *argument)
{
    Simulation *simulation = simulation_of(argument);
    for (int i = 0; simulation && i < simulation->n_stages; i++)
        write_stage(&simulation->stages[i]);
    simulation_destroy(simulation);
    return simulation != NULL;
}

/* "SCENARIO KEY=VALUE ... | KEY=VALUE ...": the stages that the values behind the bar change or add; or those
 * of
 * "| scenario NAME KEY=VALUE ...". */
static bool write_changed_stages(const char *argument)
{
    char base[128], whole[256];
    const char *bar = strstr(argument, " | ");
    if (!bar)
        return false;
    snprintf(base, sizeof base, "%.*s", (int)(bar - argument), argument);
    static const char other_scenario[] = " | scenario ";
    if (strncmp(bar, other_scenario, strlen(other_scenario)) == 0)
        snprintf(whole, sizeof whole, "%s", bar + strlen(other_scenario));
    else
        snprintf(whole, sizeof whole, "%.127s %.127s", base, bar + 3);
    Simulation *changed = simulation_of(whole), *usual = simulation_of(base);
    for (int i = 0; changed && usual && i < changed->n_stages; i++) {
        const Stage *stage = &changed->stages[i];
        const int other = simulation_find_stage(usual, stage->id);
        if (other < 0 || strcmp(usual->stages[other].equation, stage->equation) != 0 ||
            strcmp(usual->stages[other].sentence, stage->sentence) != 0)
            write_stage(stage);
    }
    const bool good = changed && usual;
    simulation_destroy(changed);
    simulation_destroy(usual);
    return good;
}

static void say_ascii(const char *format, ...)
{
    char line[256], ascii[256];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(line, sizeof line, format, arguments);
    va_end(arguments);
    text_to_ascii(line, ascii, sizeof ascii);
    say_line(ascii);
}

static void write_exchange(const Simulation *simulation, const Exchange *exchange)
{
    char ways[64] = "";
    if (exchange->from != exchange->to)
        snprintf(ways, sizeof ways, "%s to %s", simulation->sets[exchange->from].name,
                 simulation->sets[exchange->to].name);
    const int width = *ways ? 18 : 0;
    say_ascii("%-11s%-*s%s %s sum %s", exchange->stage, width, ways, exchange->field,
              exchange->adds ? "+=" : "=", exchange->factors);
    if (exchange->note)
        say_ascii("%*s%s", 11 + width + 4, "", exchange->note);
}

/* "SCENARIO KEY=VALUE ...": who gives what to whom, in the order of the step. */
static bool write_exchanges(const char *argument)
{
    Simulation *simulation = simulation_of(argument);
    puts(".PP\n.nf");
    for (int s = 0; simulation && s < simulation->n_stages; s++)
        for (int i = 0; i < simulation->n_exchanges; i++)
            if (strcmp(simulation->exchanges[i].stage, simulation->stages[s].id) == 0)
                write_exchange(simulation, &simulation->exchanges[i]);
    puts(".fi");
    simulation_destroy(simulation);
    return simulation != NULL;
}

/* The names of the stages alone. */
static bool write_order(const char *argument)
{
    Simulation *simulation = simulation_of(argument);
    for (int i = 0; simulation && i < simulation->n_stages; i++) {
        fputs(i ? ", " : "", stdout);
        say(simulation->stages[i].id);
    }
    puts(".");
    simulation_destroy(simulation);
    return simulation != NULL;
}

/* --- the frame ------------------------------------------------------------------------------------ */

static const struct {
    const char *name;
    bool (*write)(const char *argument);
} tables[] = {
    {"command", write_command},
    {"keys", write_keys},
    {"options", write_options},
    {"parameters", write_parameters},
    {"results", write_results},
    {"scenarios", write_scenarios},
    {"lessons", write_lessons},
    {"script", write_script},
    {"series", write_series},
    {"choices", write_choices},
    {"tables", write_tables},
    {"rows", write_rows},
    {"run-numbers", write_run_numbers},
    {"about-numbers", write_about_numbers},
    {"texts", write_texts},
    {"stages", write_stages},
    {"exchanges", write_exchanges},
    {"order", write_order},
    {"mistakes", write_mistakes},
    {"changed-stages", write_changed_stages},
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
            after_heading = strncmp(line, ".SH ", 4) == 0 || strncmp(line, ".SS ", 4) == 0;
        } else if (!fill(line)) {
            fprintf(stderr, "write_manual: %s: no such table, or it is empty\n", line);
            return 1;
        }
    }
    fclose(frame);
    return fflush(stdout) == 0 && !ferror(stdout) ? 0 : 1;
}
