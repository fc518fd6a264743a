/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a scenario says of a body: its sizes and what it is made of. */
#ifndef SCENARIO_CONCERN_BODY_H
#define SCENARIO_CONCERN_BODY_H

#include "scenario/assignment.h"

typedef struct Geometry {
    double length;            /* L > 0; of a moving beam the part outside the channel at t = 0 */
    double height, thickness; /* of what has more than a length */
} Geometry;

typedef struct Material {
    double youngs_modulus, density; /* E, rho > 0 */
    double poisson;                 /* of a beam in cells; with bonds it is 1/3 */
} Material;

/* From a place on a bar is of another material. */
typedef struct Joint {
    double place; /* 0: it is of one */
    Material beyond;
} Joint;

/* Of some settings: to be read, and to be changed. */
const Geometry *settings_geometry(const Settings *);
const Material *settings_material(const Settings *);
const Joint *settings_joint(const Settings *);
Geometry *settings_edit_geometry(Settings *);

#endif
