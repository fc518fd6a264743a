/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What commands that run for a while share: a bar on standard error, and an end by signal that takes back
 * temporary files. */
#ifndef CLI_COMMON_H
#define CLI_COMMON_H

#include "base/status.h"
#include "scenario/assignment.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

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

/* Whether the outputs of a command line are different files, found out before anything is calculated. */

/* Those that are NULL are not asked for; "-" is standard output, of which there is one. False: two are the
 * same file, and the status names it. */
bool cli_outputs_differ(const char *const *outputs, int count, Status *);

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
