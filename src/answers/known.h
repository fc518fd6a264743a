/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which references account for a run: each names the parameters that it understands, and leaves where another
 * one is at work. */
#ifndef ANSWERS_KNOWN_H
#define ANSWERS_KNOWN_H

#include "problems/problem.h"

/* The key of a parameter that is at work in these settings (not at its neutral value, or changed in mid-run)
 * and that the reference does not account for; NULL: it knows the run, or there is no such reference. */
const char *answer_invalid_because(const Settings *, Reference);

/* The same of the values alone, whatever changes on the way. */
const char *known_unaccounted_now(const Settings *, Reference);

/* And of the lists of keys alone: a solver may say more of what a reference does not know, though what is
 * predicted of the largest step still holds. */
const char *known_unlisted_now(const Settings *, Reference);

enum { KNOWN_TEXT_MAX = 120 };

/* "exact, frequency: not known with mpm.damping": the references that are left out because of the first such
 * key that any of them has. *step (may be NULL): from where on it is at work. False: all are known. */
bool known_text(const Settings *, char out[KNOWN_TEXT_MAX], long *step);

#endif
