/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What leaves the laboratory: the run as files, the focused view as a figure. */
#ifndef LAB_COMMANDS_EXPORTING_H
#define LAB_COMMANDS_EXPORTING_H

#include <stdbool.h>

typedef struct Laboratory Laboratory;
typedef struct View View;

enum { NAME_MAX_BYTES = 256 };

/* The file or files that are being asked for. */
typedef struct Exporting {
    char name[2 * NAME_MAX_BYTES];           /* as long as an answer may be */
    bool newest;                             /* of the run: to its newest step, not to here */
    const View *view;                        /* of a figure */
    bool (*write)(Laboratory *, bool force); /* what is asked about writes so */
} Exporting;

/* Asks how far and under which name, as far as that is not known; `name` "": it is asked for. False: refused.
 */
bool exporting_ask(Laboratory *, const char *name);

/* "[VIEW] FILE": a view, or else the focused one, as a figure. False: refused, as an answer to a prompt. */
bool exporting_figure(Laboratory *, const char *words);

/* Writing the scenario as a file, and what every answer that names a file is asked first. */

/* Whether who asks may write a file; if not, that is said. */
bool exporting_allowed(Laboratory *, const char *name);

/* An answer that is the name of a file: whether it can be one. If not, the prompt stays and says why. */
bool exporting_name_fits(Laboratory *, const char *name);

void exporting_scenario_ask(Laboratory *);
bool exporting_scenario(Laboratory *, const char *text);

#endif
