/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Waves in an endless body of bonds, on a line and in the plane (plane stress, nu = 1/3): what the horizon
 * and the shape of the micromodulus make of them, as integrals (the continuum of bonds) and as sums over a
 * lattice.
 *
 * z = k delta is the wave number times the horizon. What is returned is the square of the phase velocity over
 * that of long waves, which are those of elasticity: E k^2/rho on a line, in the plane 9E/8 k^2/rho
 * (longitudinal) and 3E/8 k^2/rho (transverse). */
#ifndef THEORY_PD_WAVES_H
#define THEORY_PD_WAVES_H

#include "base/kinds.h"

#include <stdbool.h>

/* Integrals; z >= 0. */
double pd_waves_line(Influence, double z);
double pd_waves_plane(Influence, bool transverse, double z);

typedef struct PdWaveLattice {
    Influence shape;
    double ratio; /* horizon over spacing */
    VolumeCorrection volumes;
    double factor; /* on every bond, as a surface correction has it far from surfaces; 1: none */
} PdWaveLattice;

/* The sum over a square lattice of a wave that runs at an angle (radians) to its rows, by its place between
 * rows and diagonals: along these (0, pi/4, ...) waves are purely longitudinal or transverse, and this is
 * exact. NAN: the wave is shorter than two spacings along a row. */
double pd_waves_lattice(const PdWaveLattice *, bool transverse, double angle, double z);

/* What such lattices are corrected by far from surfaces: by the energy of a uniform strain, by the area of a
 * family. */
double pd_waves_energy_factor(const PdWaveLattice *);
double pd_waves_area_factor(const PdWaveLattice *);

#endif
