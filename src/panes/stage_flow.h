/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Between which things a stage hands on, as its exchanges say. */
#ifndef PANES_STAGE_FLOW_H
#define PANES_STAGE_FLOW_H

#include "panes/screen.h"

typedef enum Flow { FLOW_NONE, FLOW_TO_NODES, FLOW_TO_PARTICLES, FLOW_FORGET } Flow;

/* What the stage just done has handed on, if it is to be seen: one is, and no run goes on (inside). */
Flow stage_flow(const Screen *, bool *inside);

/* The set that a stage writes to. A name that particles and nodes share (mass, x) counts as the one that the
 * other names of the stage tell. */
int stage_flow_target(const Simulation *, const Stage *);

#endif
