/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The table of command words and what is done with it: finding the word, --help. One row for each command;
 * each is a function in a file of its own. */
#include "cli/cli.h"

#include "cli/options.h"
#include "cli/verify/verify.h"
#include "scenario/parameters.h"

#include <stdio.h>
#include <string.h>

static int verify(int count, char **arguments, Status *status)
{
    return verify_main(count, arguments, stdout, status);
}

static int help(int count, char **arguments, Status *status)
{
    const CliCommand *command = count > 0 ? cli_find(arguments[0]) : NULL;
    if (count > 1 || (count > 0 && !command)) {
        status_refuse(status, "%.60s: no such command (see: matvib help)", arguments[count - 1]);
        return (int)status->code;
    }
    cli_print_help(command);
    return STATUS_DONE;
}

const CliCommand cli_commands[] = {
    {"run", "SCENARIO", "runs a scenario to its end and writes tables of it", cli_run},
    {"sweep", "SCENARIO", "many runs that differ in some parameters, a row for each", cli_sweep},
    {"figure", "SCENARIO", "runs a scenario and draws a view of it for paper: SVG, PDF, PNG", cli_figure},
    {"movie", "SCENARIO|SESSION|SCRIPT", "films the laboratory: .cast, animated .svg, .gif", cli_movie},
    {"fit", "SCENARIO", "the parameters that a measured series asks for", cli_fit},
    {"diagnose", "SCENARIO FILE...", "tells from the numbers of your own code which mistake is in it",
     cli_diagnose},
    {"sound", "SCENARIO", "the error of a frequency, to be heard: .wav", cli_sound},
    {"verify", "[NAME]...", "the papers' numbers measured anew: reproduced, and agreeing?", verify},
    {"lesson", "[NAME]", "a lesson beside the live laboratory; without a name: all of them", cli_lesson},
    {"grade", "LESSON SESSION...", "marks recorded sessions of a lesson's exercises", cli_grade},
    {"export-lammps", "SCENARIO", "a beam or a plate as input for LAMMPS, for runs on many machines",
     cli_export_lammps},
    {"list", "", "the built-in scenarios", cli_list},
    {"show", "SCENARIO", "the resolved scenario as a file, derived values as comments", cli_show},
    {"params", "[PROBLEM]", "the parameters: default, unit, what is allowed, meaning", cli_params},
    {"help", "[COMMAND]", "the options of a command, as --help behind it", help},
    {NULL, NULL, NULL, NULL},
};

const CliCommand *cli_find(const char *name)
{
    for (const CliCommand *command = cli_commands; command->name; command++)
        if (strcmp(command->name, name) == 0)
            return command;
    return NULL;
}

const char *cli_nearest(const char *word)
{
    enum { MOST = 120 };
    const char *names[MOST + 1] = {NULL};
    int count = 0;
    for (const BuiltinScenario *builtin = builtin_scenarios; builtin->name && count < MOST; builtin++)
        names[count++] = builtin->name;
    for (const CliCommand *command = cli_commands; command->name && count < MOST; command++)
        names[count++] = command->name;
    return parameter_nearest_word(names, word);
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
        return;
    }
    printf("usage: matvib [SCENARIO] [OPTION]...\n"
           "       matvib COMMAND [ARGUMENT]... [OPTION]...\n\n"
           "A laboratory in a terminal: the material point method and peridynamics, on bar and beams.\n"
           "SCENARIO is a name from `matvib list`, the path of a file, or - for standard input; without one\n"
           "it is mode5.\n\n"
           "Commands:\n");
    print_command(&(CliCommand){"[SCENARIO]", "", "opens the laboratory", NULL});
    for (command = cli_commands; command->name; command++)
        print_command(command);
    printf("\nOptions of the laboratory:\n");
    options_print("open");
    printf("\n-h, --help prints these lines or a command's options, -V, --version the version. Exit status:\n"
           "0 done, 1 the run or a check failed, 2 bad usage or bad input. More: man matvib, man 5 matvib\n"
           "(scenario files).\n");
}
