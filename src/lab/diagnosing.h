/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `:diagnose FILE`: which code made the numbers of a file, as against the scenario on screen. */
#ifndef LAB_DIAGNOSING_H
#define LAB_DIAGNOSING_H

#include <stdbool.h>

typedef struct Laboratory Laboratory;

/* What is found is said in the box, and a series lies over the plots from then on. The run on screen stays as
 * it is. False: refused, prompt.problem says why. */
bool diagnosing_answer(Laboratory *, const char *words);

#endif
