/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a scenario says is done to a body: how it starts, is held, loaded, cut, moved and braked. */
#ifndef SCENARIO_CONCERN_LOADS_H
#define SCENARIO_CONCERN_LOADS_H

#include "base/kinds.h"
#include "base/status.h"
#include "scenario/assignment.h"

#include <stdbool.h>

/* What a mode starts with on a bar of two materials: the sine of a bar of one, or the mode as it is. */
typedef enum StartShape { SHAPE_SINE, SHAPE_EXACT } StartShape;

/* Where a pulse goes: with the strain of a wave one way, or without any, half of it each way. */
typedef enum PulseWay { PULSE_RIGHT, PULSE_LEFT, PULSE_BOTH } PulseWay;

/* What moves at t = 0, and how. */
typedef struct Start {
    int mode; /* of a bar */
    double velocity;
    char overtones[LIST_MAX]; /* "3:0.03,7:0.01" */
    char pulse[LIST_MAX];     /* "50,3,1e-4": centre, width, velocity; "": none */
    PulseWay pulse_way;
    double offset;      /* of particles from the middle of their share of a cell, in such shares */
    StartShape shape;   /* of a mode of a bar of two materials */
    double amplitude;   /* deflection U of a beam's mode */
    PlaneStart start;   /* of a beam in cells: which fields of the mode are given at t = 0 */
    PlaneStress stress; /* that its deflection comes with */
} Start;

/* A beam that leaves its channel. */
typedef struct Motion {
    double speed, channel; /* channel: length of beam inside at t = 0 */
    Clamp clamp;
} Motion;

typedef struct Cut {
    double position, depth; /* from below, at a distance from the left end */
} Cut;

typedef struct Loads {
    double body_force;                    /* per unit mass */
    double gravity, incline;              /* of bodies; degrees by which the box is tilted */
    double traction, traction_layer;      /* at each free end of a bar; 0: the last particle */
    double stress, ramp, position, width; /* pressure on the top of a beam */
} Loads;

typedef struct Supports {
    BarSupports ends;   /* of a bar */
    PlaneEnds sections; /* of a beam in cells */
    double left, right; /* places under a beam */
    bool pinned;        /* the left one holds the beam lengthwise too */
} Supports;

/* Damping by the velocity of things itself. */
typedef struct Damping {
    double rate; /* alpha; DAMPING_CRITICAL: twice the lowest frequency */
} Damping;
#define DAMPING_CRITICAL (-1)

/* Of some settings: to be read, and to be changed. */
const Start *settings_start(const Settings *);
const Motion *settings_motion(const Settings *);
const Cut *settings_notch(const Settings *);
const Loads *settings_loads(const Settings *);
const Supports *settings_supports(const Settings *);
const Damping *settings_damping(const Settings *);
Start *settings_edit_start(Settings *);
Supports *settings_edit_supports(Settings *);
Damping *settings_edit_damping(Settings *);

/* The lists inside its texts. */
enum { OVERTONES_MAX = 15 };

typedef struct Overtone {
    int mode;
    double velocity;
} Overtone;

/* "3:0.03,7:0.01": how many there are, -1 if the text cannot be read (the status says why). */
int overtones_read(const char *text, Overtone out[OVERTONES_MAX], Status *);

typedef struct Pulse {
    double centre, width, velocity;
} Pulse;

/* "50,3,1e-4", centre, width > 0 and velocity; "" is a pulse of velocity 0. False: it cannot be read. */
bool pulse_read(const char *text, Pulse *out, Status *);

#endif
