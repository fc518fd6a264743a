/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of command words and what is done with it: finding the word, --help. One row for each command;
 * each is a function in a file of its own. */
#include "cli/cli.h"

#include "cli/options.h"
#include "cli/verify/verify.h"
#include "scenario/parameters.h"
#include "scenario/scenario.h"

#include <stdio.h>
#include <string.h>

static int verify(int count, char **arguments, Status *status)
{
    return verify_main(count, arguments, stdout, status);
}

static int help(int count, char **arguments, Status *status)
{
    const CliCommand *command = count > 0 ? cli_find(arguments[0]) : NULL;
    if (count == 1 && !command && scenario_builtin(arguments[0]))
        return cli_describe(arguments[0], status);
    if (count > 1 || (count > 0 && !command))
        return progress_result(status_refuse(status, "%.60s: no such command or scenario (see: matvib help)",
                                             arguments[count - 1]),
                               status);
    cli_print_help(command);
    return STATUS_DONE;
}

const CliCommand cli_commands[] = {
    {"run", "SCENARIO", "runs a scenario to its end and writes tables of it", cli_run, 1, 1, NULL, NULL,
     NULL},
    {"sweep", "SCENARIO", "many runs that differ in some parameters, a row for each", cli_sweep, 1, 1, NULL,
     NULL, NULL},
    {"figure", "SCENARIO", "runs a scenario and draws a view: SVG, PDF, PNG, LaTeX, gnuplot", cli_figure, 1,
     1, NULL, NULL, NULL},
    {"movie", "SCENARIO|SESSION|SCRIPT", "films the laboratory: .cast, animated .svg, .gif", cli_movie, 1, 1,
     "SCENARIO, SESSION or SCRIPT", NULL, NULL},
    {"fit", "SCENARIO", "the parameters that a measured series asks for", cli_fit, 1, 1, NULL, NULL, NULL},
    {"diagnose", "SCENARIO FILE...", "finds the mistake in your own code from its numbers", cli_diagnose, 0,
     WORDS_MAX, "SCENARIO FILE", NULL, "matvib diagnose mode5 own.csv --set time.courant=0.2"},
    {"sound", "SCENARIO", "the error of a frequency, to be heard: .wav", cli_sound, 1, 1, NULL, NULL, NULL},
    {"verify", "[NAME]...", "the papers' numbers measured: reproduced, and agreeing?", NULL, 0, -1, NULL,
     verify, NULL},
    {"lesson", "[NAME]", "a lesson beside the live laboratory; without a name: all of them", cli_lesson, 0, 1,
     NULL, NULL, NULL},
    {"grade", "LESSON SESSION...", "marks recorded sessions of a lesson's exercises", cli_grade, 0, -1, NULL,
     NULL, NULL},
    {"list", "[SCENARIO]", "the built-in scenarios; of one its title and what it is about", cli_list, 0, 1,
     NULL, NULL, NULL},
    {"describe", "SCENARIO", "a scenario's title and what it is about", cli_list, 1, 1, NULL, NULL, NULL},
    {"show", "SCENARIO", "the resolved scenario as a file, derived values as comments", cli_show, 1, 1, NULL,
     NULL, NULL},
    {"params", "[PROBLEM|SCENARIO]", "the parameters: value, unit, what is allowed, meaning", cli_params, 0,
     1, NULL, NULL, NULL},
    {"help", "[COMMAND|SCENARIO]", "the options of a command, or what a scenario is about", NULL, 0, -1, NULL,
     help, NULL},
    {NULL, NULL, NULL, NULL, 0, 0, NULL, NULL, NULL},
};

const CliCommand cli_laboratory = {"open", "", "opens the laboratory", cli_open, 0, -1, NULL, NULL, NULL};

int cli_do(const CliCommand *command, int count, char **arguments, Status *status)
{
    Options options;
    if (command->raw)
        return command->raw(count, arguments, status);
    if (!options_parse(command->name, count, arguments, &options, status) ||
        (command->most >= 0 && !options_words(&options, command->least, command->most,
                                              command->words ? command->words : command->synopsis, status)))
        return (int)status->code;
    return command->run(&options, status);
}

const CliCommand *cli_find(const char *name)
{
    for (const CliCommand *command = cli_commands; command->name; command++)
        if (strcmp(command->name, name) == 0)
            return command;
    return NULL;
}

const char *cli_nearest(const char *word)
{
    Nearest nearest = nearest_begin(word);
    for (const BuiltinScenario *builtin = builtin_scenarios; builtin->name; builtin++)
        nearest_offer(&nearest, builtin->name);
    for (const CliCommand *command = cli_commands; command->name; command++)
        nearest_offer(&nearest, command->name);
    return nearest.word;
}

static void print_command(const CliCommand *command)
{
    char usage[64];
    snprintf(usage, sizeof usage, "matvib %s %s", command->name, command->synopsis);
    printf("  %-32s %s\n", usage, command->help);
}

void cli_print_help(const CliCommand *command)
{
    if (command) {
        printf("usage: matvib %s%s%s [OPTION]...\n\n%s\n", command->name, *command->synopsis ? " " : "",
               command->synopsis, command->help);
        if (options_count(command->name) > 0)
            printf("\nOptions:\n");
        options_print(command->name);
        if (command->example)
            printf("\nExample:\n  %s\n", command->example);
        return;
    }
    printf("usage: matvib [SCENARIO] [OPTION]...\n"
           "       matvib COMMAND [ARGUMENT]... [OPTION]...\n\n"
           "A laboratory in a terminal for the material point method and bond-based peridynamics.\n"
           "SCENARIO is a name from `matvib list`, the path of a file, or - for standard input; without one\n"
           "it is mode5.\n\n"
           "Commands:\n");
    print_command(&(CliCommand){.name = "[SCENARIO]", .synopsis = "", .help = cli_laboratory.help});
    for (command = cli_commands; command->name; command++)
        print_command(command);
    printf("\nOptions of the laboratory:\n");
    options_print("open");
    printf("\n-h, --help prints these lines or a command's options, -V, --version the version. Exit status:\n"
           "0 done, 1 the run or a check failed, 2 bad usage or bad input. More: man matvib, man 5 matvib\n"
           "(scenario files).\n");
}
