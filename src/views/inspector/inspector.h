/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The inspector, which `i` opens over the plots: the chosen particle, node or family with all that it
 * exchanges with others. One for each kind of simulation, a file each: what it needs and what it does. */
#ifndef VIEWS_INSPECTOR_INSPECTOR_H
#define VIEWS_INSPECTOR_INSPECTOR_H

#include "panes/screen.h"
#include "picture/picture.h"

typedef struct Inspector {
    unsigned needs; /* what the simulation must have, all of it (HAS_...) */
    void (*describe)(const Screen *, Picture *);
    /* The arrows: to the next thing, `page` at a time; y downwards. */
    void (*move)(Screen *, int x, int y, int page);
} Inspector;

extern const Inspector inspector_mesh, inspector_bonds, inspector_family;

/* The one that fits the simulation; NULL: none does. */
const Inspector *inspector_find(const Screen *);

/* The arrows in it. False: they do what they do in the mesh strip. */
bool inspector_move(Screen *, int x, int y, int page);

/* A node's row of the mass matrix, shared with those beside it. False: masses are lumped, or not mapped. */
enum { MASSES_BESIDE_MAX = 3 };
typedef struct MassRow {
    size_t first, count; /* the nodes of the row */
    double masses[2 * MASSES_BESIDE_MAX + 1];
} MassRow;
bool inspector_mass_row(const Simulation *, int set, size_t node, MassRow *);

/* An end of the first bond, as the lattice counts them, that broke in a step; -1: none that is known. */
long inspector_broken_node(const Screen *, long step);

#endif
