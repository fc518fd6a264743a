/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a scenario says of time: how long a step is, and when the run ends. */
#ifndef SCENARIO_CONCERN_TIME_H
#define SCENARIO_CONCERN_TIME_H

#include "scenario/assignment.h"

#include <stdbool.h>

typedef struct TimeSettings {
    double courant; /* of a mesh: the step as a share of the time in which a wave crosses a cell */
    bool unstable;  /* a larger step than the mesh stands is run all the same */
    double step;    /* 0: half the critical one */
    double end;
    bool rest; /* the run ends earlier where it comes to rest */
} TimeSettings;

/* Of some settings: to be read, and to be changed. */
const TimeSettings *settings_time(const Settings *);
TimeSettings *settings_edit_time(Settings *);

#endif
