/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A third method, of the tests alone: a membrane on a two-dimensional lattice by velocity Verlet. It proves
 * that front ends need nothing but method.h.
 *
 * Nodes (i, j), id = j columns + i, stand at (i, j) and move across the plate, uy; the rim is held. All
 * constants are 1: acceleration = sum over the four neighbours of (uy of the neighbour - own uy). The start
 * is the lowest mode, whose frequency in the lattice is known exactly. It has no `steps` and no fast path: it
 * runs through the driver of method.c stage by stage, in any slices of rows. */
#ifndef TESTS_PLATE_H
#define TESTS_PLATE_H

#include "methods/method.h"

enum { PLATE_COLUMNS = 420, PLATE_ROWS = 140 }; /* 58,800 nodes, as the notched beam has */

/* At least 3 x 3 nodes; the step at which it is to fail by itself, 0: never. NULL: no memory. */
Simulation *plate_create(int columns, int rows, long fails_at);

/* The frequency at which the lattice (with its time step) oscillates. */
double plate_frequency(int columns, int rows, double dt);

#endif
