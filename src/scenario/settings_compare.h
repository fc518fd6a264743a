/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two sets of settings as against what somebody was to change; how they compare as a whole is in
 * parameters.h. */
#ifndef SCENARIO_SETTINGS_COMPARE_H
#define SCENARIO_SETTINGS_COMPARE_H

#include "scenario/assignment.h"

#include <stdbool.h>

/* Whether they differ in anything but the keys that are allowed; then `key` is the first of it. A key of a
 * row allows all rows. What a run writes does not count. */
bool settings_differ_beyond(const Settings *a, const Settings *b, const char (*allowed)[KEY_MAX],
                            int n_allowed, char key[KEY_MAX]);

#endif
