/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The family of a beam's chosen node, for its inspector. Private to src/view. */
#ifndef VIEW_FAMILY_H
#define VIEW_FAMILY_H

#include "picture/area.h"
#include "views/map/map.h"

enum { FAMILY_LINKS = 256, FAMILY_WORDS = 43 /* columns of the words beside the family's picture */ };

/* A bond seen from the chosen node. */
typedef struct Ray {
    size_t other;
    int p, q; /* columns and rows from the node to the other end */
    double stretch, pull;
    double direction[2]; /* as it is now */
    bool broken;
    long broken_at; /* as of a Link */
} Ray;

typedef struct Family {
    const Screen *screen;
    const Simulation *sim;
    const Settings *settings;
    Body body;
    size_t node;
    int i, j, reach;
    Ray rays[FAMILY_LINKS];
    int count, broken, cut; /* broken in the run; cut by the notch before it */
    int most;               /* the ray of the most stretched whole bond; -1: none */
    int last;               /* of the one that broke last, the notch's left out; -1: none */
} Family;

/* A field of a node by name; NAN: there is none. */
double family_field(const Family *, const char *name, size_t node);

/* What the node's force is made of, as far as the step has come; returns the rows used. */
int family_forces(const Family *, Area);

#endif
