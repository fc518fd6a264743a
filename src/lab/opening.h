/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Opening a scenario: its run is made, and put in the place of another. */
#ifndef LAB_OPENING_H
#define LAB_OPENING_H

#include "run/experiment.h"

typedef struct Laboratory Laboratory;

/* Settings whose simulation shows on the screen how far its building has come; copies of them do too. */
void opening_show_progress(Laboratory *, Settings *);

Experiment *opening_experiment(const Laboratory *, const Settings *, Status *);

/* This run takes the place of the one before, which goes; what belongs to a run and not to the way it is
 * looked at begins again. */
void opening_begin(Laboratory *, Experiment *);
void opening_name(Laboratory *, const char *name);

/* Another scenario in the place of this one, or its coarse form, which is then said. */
bool opening_answer(Laboratory *, const char *text);

/* The same at full size; "": that of which this is the coarse form. */
bool opening_whole(Laboratory *, const char *text);

/* Says that this is the coarse form of what was asked for. */
void opening_tell_coarse(Laboratory *);

/* Asks which scenario is opened, with a list to choose from. */

void opening_ask(Laboratory *);

#endif
