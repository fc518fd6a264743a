/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib verify`: the claims of the papers beside theory and measured numbers.
 *
 *     matvib verify [NAME]... [--full] [--list]
 *
 * Each name is a figure or a table of one of the two papers, or one more thing that is known of a method: a
 * table of rows (verify_row.h). The engine runs, and each row prints theory, the measured number,
 * what our reference allows and whether it is reproduced; and under it, with a verdict of its own, the
 * paper's claim. */
#ifndef CLI_VERIFY_VERIFY_H
#define CLI_VERIFY_VERIFY_H

#include "base/status.h"

#include <stdio.h>

/* The names, in the order of --list; NULL behind the last. */
const char *verify_name(int index);

/* `arguments` are those after the word "verify". Tables go to `out`. Returns the exit status: 0 our
 * reference and theory are reproduced; 1 a miss (the status says how many); 2 bad usage (the status says what
 * is allowed). */
int verify_main(int count, char **arguments, FILE *out, Status *status);

#endif
