/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What leaves the laboratory: the run as files, the focused view as a figure. */
#ifndef LAB_COMMANDS_EXPORTING_H
#define LAB_COMMANDS_EXPORTING_H

#include "base/status.h"

typedef struct Laboratory Laboratory;
typedef struct View View;

enum { NAME_MAX_BYTES = 256 };

/* The file or files that are being asked for. */
typedef struct Exporting {
    char name[2 * NAME_MAX_BYTES];           /* as long as an answer may be */
    bool newest;                             /* of the run: to its newest step, not to here */
    const View *view;                        /* of a figure */
    void (*write)(Laboratory *, bool force); /* what is asked about writes so */
} Exporting;

/* Asks how far and under which name, as far as that is not known; `name` "": it is asked for. False: refused.
 */
bool exporting_ask(Laboratory *, const char *name, Status *);

/* "[VIEW] FILE": a view, or else the focused one, as a figure. False: refused, as an answer to a prompt. */
bool exporting_figure(Laboratory *, const char *words, Status *);

/* Writing the scenario as a file. */
void exporting_scenario_ask(Laboratory *);
bool exporting_scenario(Laboratory *, const char *text, Status *);

#endif
