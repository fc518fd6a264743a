/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a plate has any number of: cuts, loads on its edges, regions that are moved, set in motion or
 * protected. Places in m from its lower left corner. Regions and stretches of edges include their ends to
 * 1e-6 dx, and may be given from either end. Each has a name, for messages: "cuts.NAME: ...". */
#ifndef METHODS_BONDS_PLANE_PLATE_PLATE_H
#define METHODS_BONDS_PLANE_PLATE_PLATE_H

#include <stdbool.h>

enum { PLATE_ROWS_MAX = 16, PLATE_NAME_MAX = 24 };

/* Of zero width, straight, in any direction. A node on its line hangs on its right, seen from its beginning;
 * so a cut along a row of nodes is one-sided, and another one when it is turned round. */
typedef struct PlateCut {
    char name[PLATE_NAME_MAX];
    double x0, y0, x1, y1;
} PlateCut;

typedef enum PlateEdge { PLATE_TOP, PLATE_BOTTOM, PLATE_LEFT, PLATE_RIGHT } PlateEdge;

/* The traction (sx, sy) on a stretch of an edge, Pa, from t = 0 on: times min(1, t/ramp), and nothing after
 * the step nearest to `until`, in which it counts half (both s; INFINITY: for ever). */
typedef struct PlateLoad {
    char name[PLATE_NAME_MAX];
    PlateEdge edge;
    double from, to;
    double sx, sy;
    double ramp, until;
} PlateLoad;

/* A rectangle, and the velocity that its nodes have, m/s: of a support in the directions that it gives, from
 * t = 0 on; of an impulse at t = 0. */
typedef struct PlateRegion {
    char name[PLATE_NAME_MAX];
    double x0, y0, x1, y1;
    bool gives_x, gives_y;
    double vx, vy;
} PlateRegion;

typedef struct PlateDef {
    PlateCut cuts[PLATE_ROWS_MAX];
    PlateLoad loads[PLATE_ROWS_MAX];
    PlateRegion supports[PLATE_ROWS_MAX], impulses[PLATE_ROWS_MAX], unbreakable[PLATE_ROWS_MAX];
    int n_cuts, n_loads, n_supports, n_impulses, n_unbreakable;
    double probe_x, probe_y;
} PlateDef;

/* --- the same as nodes of the lattice, of beams too ---------------------------------------------------- */

/* Columns i .. i + columns - 1 and rows j .. j + rows - 1. */
typedef struct Patch {
    int i, j, columns, rows;
} Patch;

/* Nodes of which components have a given velocity, m/s; 0 holds them. */
typedef struct Support {
    Patch patch;
    bool x, y;
    double vx, vy;
} Support;

/* Nodes along an edge that a traction (sx, sy), Pa, acts on, as PlateLoad says. */
typedef struct Load {
    Patch patch;
    double sx, sy, ramp, until;
} Load;

#endif
