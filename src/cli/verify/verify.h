/* `matvib verify`: what the papers say, what theory predicts, what was measured.
 *
 *     matvib verify [NAME]... [--full] [--list]
 *
 * Each name is a figure or a table of one of the two papers, or one more thing that is known of a method. The
 * engine runs, and a table tells for each number what the paper says, what theory predicts, what was
 * measured, what is allowed, and whether it holds. */
#ifndef CLI_VERIFY_H
#define CLI_VERIFY_H

#include "base/status.h"

#include <stdio.h>

/* The names, in the order of --list; NULL behind the last. */
const char *verify_name(int index);

/* `arguments` are those after the word "verify". Tables go to `out`. Returns the exit status: 0 all holds;
 * 1 a miss (the status says how many); 2 bad usage (the status says what is allowed). */
int verify_main(int count, char **arguments, FILE *out, Status *status);

#endif
