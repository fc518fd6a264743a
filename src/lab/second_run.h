/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A second run beside the first. */
#ifndef LAB_SECOND_RUN_H
#define LAB_SECOND_RUN_H

#include <stdbool.h>

typedef struct Laboratory Laboratory;

void second_run_open(Laboratory *); /* of a scenario that has keys for one */

/* Begins with the scenario's keys, or ends; asks where there are no keys. */
void second_run_toggle(Laboratory *);
bool second_run_answer(Laboratory *, const char *words); /* "KEY=VALUE ..." */

#endif
