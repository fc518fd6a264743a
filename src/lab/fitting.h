/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `:fit KEY,...`: the parameters with which the run agrees best with the series that lies over it. */
#ifndef LAB_FITTING_H
#define LAB_FITTING_H

#include <stdbool.h>

typedef struct Laboratory Laboratory;

/* Searches, says how far it has come meanwhile, and has the run made again with what was found; one undo
 * takes it back. What was found, its intervals and the residuals are said. False: refused, prompt.problem
 * says why.
 */
bool fitting_answer(Laboratory *, const char *words);

/* `:diagnose FILE`: which code made the numbers of a file, as against the scenario on screen. */

/* What is found is said in the box, and a series lies over the plots from then on. The run on screen stays as
 * it is. False: refused, prompt.problem says why. */
bool fitting_diagnose(Laboratory *, const char *words);

#endif
