/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The words of the command line. A command is one row of the table in cli.c and one function in a file of its
 * own; its options are rows of the table in options.c. Help, manual pages and completion read both.
 *
 * A command prints its result on standard output and nothing else: what went wrong is the status, which main
 * prints as "matvib: ..." on standard error. */
#ifndef CLI_CLI_H
#define CLI_CLI_H

#include "base/status.h"
#include "cli/options.h"

typedef struct CliCommand {
    const char *name;     /* "show" */
    const char *synopsis; /* what follows the name, options left out: "SCENARIO" */
    const char *help;     /* one line */
    /* `arguments` are those behind the name. Returns the exit status; if that is not 0 the status says why.
     */
    int (*run)(int count, char **arguments, Status *);
} CliCommand;

extern const CliCommand cli_commands[]; /* ended by a NULL name */

const CliCommand *cli_find(const char *name); /* NULL: there is none */

/* The command or built-in scenario nearest to a word that is neither; NULL: none is near. */
const char *cli_nearest(const char *word);

/* --help: of the program, or of one command. */
void cli_print_help(const CliCommand *command);

int cli_open(int count, char **arguments, Status *); /* no command word: the laboratory */
int cli_lesson(int count, char **arguments, Status *);
int cli_run(int count, char **arguments, Status *);
int cli_sweep(int count, char **arguments, Status *);
int cli_export_lammps(int count, char **arguments, Status *);
int cli_figure(int count, char **arguments, Status *);
int cli_movie(int count, char **arguments, Status *);
int cli_grade(int count, char **arguments, Status *);
int cli_fit(int count, char **arguments, Status *);
int cli_diagnose(int count, char **arguments, Status *);
int cli_sound(int count, char **arguments, Status *);
int cli_list(int count, char **arguments, Status *);
int cli_list_lessons(void);                                             /* what `lesson --list` prints */
int cli_lesson_handout(const Options *, const char *student, Status *); /* what `lesson --handout` writes */
int cli_lesson_print(const char *name, Status *);                       /* what `lesson --print` prints */
int cli_grade_key(const Options *, Status *);                           /* what `grade --key` prints */
int cli_show(int count, char **arguments, Status *);
int cli_params(int count, char **arguments, Status *);

#endif
