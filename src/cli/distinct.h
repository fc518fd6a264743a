/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whether the files of a command line are different ones, found out before anything is calculated. */
#ifndef CLI_DISTINCT_H
#define CLI_DISTINCT_H

#include "base/status.h"

#include <stdbool.h>

/* Outputs that are NULL are not asked for; "-" is standard output, of which there is one. False: two outputs
 * are the same file, or one of them is an input too; the status names it. */
bool distinct_files(const char *const *outputs, int n_outputs, const char *const *inputs, int n_inputs,
                    Status *);

#endif
