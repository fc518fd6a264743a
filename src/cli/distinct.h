/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether the outputs of a command line are different files, found out before anything is calculated. */
#ifndef CLI_DISTINCT_H
#define CLI_DISTINCT_H

#include "base/status.h"

#include <stdbool.h>

/* Those that are NULL are not asked for; "-" is standard output, of which there is one. False: two are the
 * same file, and the status names it. */
bool distinct_outputs(const char *const *outputs, int count, Status *);

#endif
