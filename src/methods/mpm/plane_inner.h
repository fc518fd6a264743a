/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the engine asks of a beam, and the words and numbers that front ends read of it: plane_*.c. */
#ifndef METHODS_MPM_PLANE_INNER_H
#define METHODS_MPM_PLANE_INNER_H

#include "methods/mpm/engine.h"

/* Columns of cells whose particles are worked on together: some chunks for threads to share, each with rows
 * long enough to be read ahead. */
static inline int plane_chunk_cells(int columns)
{
    const int cells = columns / 16;
    return cells < 8 ? 8 : cells > 64 ? 64 : cells;
}

void plane_derive(Mpm *); /* everything constant, from mpm->plane, which is sound */
unsigned plane_held(const Mpm *, long step, int column, int row);

double plane_energy(const Mpm *);
double plane_strain_at(const Mpm *, int particle); /* strain energy, J */
bool plane_row_needs_grid(const Mpm *);
/* A row that is not whole, or not due to be (Simulation.whole_rows), has no kinetic_null (NAN), which takes
 * several times as long as a step. */
void plane_write_row(Mpm *, double *row, bool whole);
void plane_set_series(Mpm *);

/* The kinetic energy that no velocities of the grid can give (J); the grid stands as after map and supports.
 * Its scratch, and whether it takes so long that it is left out. */
size_t plane_null_numbers(const Mpm *);
bool plane_null_pays(const Mpm *);
double plane_null_energy(const Mpm *, double kinetic);

#endif
