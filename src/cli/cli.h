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
    /* Returns the exit status; if that is not 0 the status says why. */
    int (*run)(Options *, Status *);
    int least, most;   /* words that it takes, options left out; most -1: it looks itself */
    const char *words; /* what they are called where they are missing; NULL: as in the synopsis */
    int (*raw)(int count, char **arguments, Status *); /* in place of run(): reads its arguments itself */
    const char *example;                               /* a line as one types it; NULL: none is shown */
} CliCommand;

extern const CliCommand cli_commands[]; /* ended by a NULL name */

const CliCommand *cli_find(const char *name); /* NULL: there is none */

/* The command or built-in scenario nearest to a word that is neither; NULL: none is near. */
const char *cli_nearest(const char *word);

/* --help: of the program, or of one command. */
void cli_print_help(const CliCommand *command);

/* Does it, with the arguments behind its name. Returns the exit status. */
int cli_do(const CliCommand *, int count, char **arguments, Status *);

extern const CliCommand cli_laboratory; /* no command word */

int cli_open(Options *, Status *);
int cli_lesson(Options *, Status *);
int cli_run(Options *, Status *);
int cli_sweep(Options *, Status *);
int cli_figure(Options *, Status *);
int cli_movie(Options *, Status *);
int cli_grade(Options *, Status *);
int cli_fit(Options *, Status *);
int cli_diagnose(Options *, Status *);
int cli_sound(Options *, Status *);
int cli_list(Options *, Status *);
int cli_describe(const char *scenario, Status *);                       /* its title, and what it is about */
int cli_list_lessons(void);                                             /* what `lesson --list` prints */
int cli_lesson_handout(const Options *, const char *student, Status *); /* what `lesson --handout` writes */
int cli_lesson_print(const char *name, Status *);                       /* what `lesson --print` prints */
int cli_show(Options *, Status *);
int cli_params(Options *, Status *);

#endif
