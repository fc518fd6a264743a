/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The words of the command line. A command is one row of the table in cli.c and one function in a file of its
 * own; its options are rows of the table in options.c. Help, manual pages and completion read both.
 *
 * A command prints its result on standard output and nothing else: what went wrong is the status, which main
 * prints as "matvib: ..." on standard error. */
#ifndef CLI_CLI_H
#define CLI_CLI_H

#include "base/cancel.h"
#include "base/status.h"
#include "cli/options.h"
#include "scenario/assignment.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

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
int cli_describe(const char *scenario, Status *); /* its title, and what it is about */
int cli_list_lessons(void);                       /* what `lesson --list` prints */
int cli_show(Options *, Status *);
int cli_params(Options *, Status *);

/* What commands that run for a while share: a bar on standard error, and an end by signal that takes back
 * temporary files. */

typedef struct Progress {
    bool visible; /* standard error is a terminal */
    double began, shown;
} Progress;

/* Also notes the signals that ask for an end from here on (signals_catch). */
void progress_begin(Progress *, bool quiet);
void progress_end(const Progress *); /* wipes the bar */
double progress_seconds(const Progress *);

/* A RunProgress: draws the bar; false once a signal came. */
bool progress_show(double share, void *progress);

/* The signal that came; 0: none. */
int progress_signal(void);

/* The exit status of a command: 0, 128 + n after signal n, or the status's code. */
int progress_result(bool done, const Status *);

/* The number given with --threads, else as many as this process may use. */
int progress_threads(long wanted);

/* Does each of 0 .. count - 1 on these threads, under one bar: one after the other as a thread comes free, so
 * that none waits behind a long one while a thread has nothing to do. Of fewer than threads, each has
 * several. False: there are no threads, or a signal came. */
typedef void CliWork(void *owner, int index, int threads, Cancel);
bool cli_each(int count, long threads, bool quiet, CliWork *, void *owner, Status *);

/* What follows from settings: derived numbers and advice as lines of text, for `show` and `params`. */

enum { DERIVED_TEXT_MAX = 4096 };

/* "dt = 0.01 time", a line each, then the advice if there is any. The simulation is built for it. */
bool cli_derived_text(const Settings *settings, char *out, size_t size, Status *status);

/* The summary of a command as one object of JSON (RFC 8259) on a stream:
 *
 *     {"command": "run", "scenario": "mode5", "quantities": [
 *       {"name": "frequency_measured", "value": 5.4140744171, "unit": "1/time"}, ...]}
 *
 * Members of the object come before its quantities, members of a quantity behind its unit. Numbers have 17
 * digits and read back to the same; what is not a number is null, and so is a unit that is not known (NULL).
 */

typedef struct Quantities {
    FILE *out;
    long count;
} Quantities;

Quantities quantities_open(FILE *out, const char *command);
void quantities_begin(Quantities *, const char *key); /* a list, behind the object's own members */
void quantities_add(Quantities *, const char *name, double value, const char *unit);
void quantities_end(Quantities *);   /* of a list that others follow */
void quantities_close(Quantities *); /* of the last list, and of the object */

/* A member of the object or, once the list has begun, of the last quantity. */
void quantities_text(Quantities *, const char *key, const char *text); /* NULL: null */
void quantities_number(Quantities *, const char *key, double value);

#endif
