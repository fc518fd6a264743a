/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Writing the scenario as a file, and what every answer that names a file is asked first. */
#ifndef LAB_WRITING_H
#define LAB_WRITING_H

#include <stdbool.h>

typedef struct Laboratory Laboratory;

/* Whether who asks may write a file; if not, that is said. */
bool writing_allowed(Laboratory *, const char *name);

/* An answer that is the name of a file: whether it can be one. If not, the prompt stays and says why. */
bool writing_name_fits(Laboratory *, const char *name);

void writing_ask(Laboratory *);
bool writing_answer(Laboratory *, const char *text);

#endif
