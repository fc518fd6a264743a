/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The steps at which tables of particles, nodes and bonds are written. */
#ifndef EXPORT_FRAMES_H
#define EXPORT_FRAMES_H

#include "base/status.h"
#include "scenario/assignment.h"

#include <stdbool.h>
#include <stddef.h>

typedef struct Frames {
    long *steps; /* ascending, none twice */
    size_t count;
} Frames;

/* By output.frames (evenly from 0 to the last step), or output.at, or the last step alone. */
bool frames_plan(Frames *, const Settings *, double dt, long last, Status *);
void frames_free(Frames *);

#endif
