/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Changes of live parameters in mid-run: how they are applied, and what is in force when.
 *
 * A change "STEP = KEY=VALUE" is applied between steps, when STEP whole steps have been done; the row of that
 * step is from before it. */
#ifndef SCENARIO_CHANGES_H
#define SCENARIO_CHANGES_H

#include "base/status.h"
#include "scenario/assignment.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct Simulation Simulation; /* methods/method.h */

/* What is asked of settings before a run is made of them that is shown or written: settings_check(), then
 * problem_advice() at the start and after each change. Nobody below asks again. */
bool changes_advice(const Settings *, char *advice, size_t size, Status *);

/* Applies those of the simulation's present step; they become events of the run. False: the method refuses;
 * the simulation is marked as failed. */
bool changes_apply(const Settings *, Simulation *, Status *);

/* Whether two settings have the same changes. */
bool settings_changes_same(const Settings *, const Settings *);

/* The next step later than this one at which something changes; LONG_MAX: none. */
long changes_next(const Settings *, long step);

/* The settings in force at a step: the values from the start and the changes up to and with this step. */
void changes_in_force(const Settings *, long step, Settings *out);

/* Adds a change, in the place of one of the same key and step; those of later steps are forgotten. False: the
 * whole makes no sense with it, and these settings are of no use. */
bool changes_add(Settings *, long step, const char *key, const char *value, Status *);

/* Changes are known by their step; with another time step they keep their time. */
void changes_move(Change *, int count, double from_dt, double to_dt);

/* The same of all that settings have; `dt` comes in as the step that they were made for, and goes out as that
 * of a run of these settings. False: there is no such run. */
bool changes_keep_time(Settings *, double *dt, Status *);

#endif
