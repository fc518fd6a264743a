/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a scenario says of a body: its sizes and what it is made of. */
#ifndef SCENARIO_CONCERN_BODY_H
#define SCENARIO_CONCERN_BODY_H

#include "base/kinds.h"
#include "scenario/assignment.h"

#include <stdbool.h>

typedef struct Geometry {
    double length;            /* L > 0; of a moving beam the part outside the channel at t = 0 */
    double height, thickness; /* of what has more than a length */
} Geometry;

typedef struct Material {
    double youngs_modulus, density; /* E, rho > 0 */
    double poisson;                 /* of a beam in cells; with bonds it is 1/3 */
    BodyLaw law;                    /* of bodies */
    BodyPlane plane;
} Material;

/* The box of bodies, of the size of the geometry. */
typedef struct Domain {
    BodyWall left, right, bottom, top;
    double friction; /* of walls that have it */
} Domain;

/* What bodies do to each other. */
typedef struct Contact {
    BodyFields fields;
    double friction;
    double gap;     /* cells; CONTACT_GAP_OFF: no criterion */
    bool gap_given; /* else it is the usual one of the shape functions */
} Contact;
#define CONTACT_GAP_OFF (-1)

/* From a place on a bar is of another material. */
typedef struct Joint {
    double place; /* 0: it is of one */
    Material beyond;
} Joint;

/* Of some settings: to be read, and to be changed. */
const Geometry *settings_geometry(const Settings *);
const Material *settings_material(const Settings *);
const Joint *settings_joint(const Settings *);
const Domain *settings_domain(const Settings *);
const Contact *settings_contact(const Settings *);
Contact *settings_edit_contact(Settings *);
Geometry *settings_edit_geometry(Settings *);

#endif
