/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every mode of a bar on its mesh or lattice: what a dispersion plot shows, with the reasons for its error
 * apart.
 *
 * Source: the discrete dispersion relations of theory/elastic_bar.h and
 * methods/bonds/plane/bonds_plane.h. Units: any
 * consistent system.
 */
#ifndef ANSWERS_DISPERSION_CURVES_H
#define ANSWERS_DISPERSION_CURVES_H

#include "problems/problem.h"
#include "base/kinds.h"
#include "scenario/assignment.h"

#include <stdbool.h>

enum { MODE_FACTORS_MAX = 4 };

/* One of the reasons for which predicted/exact is not 1. */
typedef struct ModeFactor {
    const char *name;    /* "mesh K" */
    const char *meaning; /* NULL: the name is enough */
    double value;
} ModeFactor;

/* One mode. predicted/exact is the product of the factors. */
struct ModeOnMesh {
    double exact;     /* omega_n of the continuum, radians per unit time */
    double predicted; /* of this mesh and time step, away from the ends; NAN: such a wave does
                       * not oscillate */
    int n_factors;
    ModeFactor factors[MODE_FACTORS_MAX];
};

/* How many modes the mesh can represent, one for each cell or for each node of a lattice; 0: there is
 * neither, or a parameter is at work that they do not know. */
int dispersion_modes(const Settings *);

/* Mode number 1 to dispersion_modes(), without what is predicted where that does not know a parameter. False:
 * no such mode. */
bool dispersion_mode(const Settings *, int number, ModeOnMesh *);

/* The same mode by other ways of the method on this very mesh, to be compared: the name of the way (which =
 * 0, 1, ...) and its predicted frequency, NAN where such a wave does not oscillate. NULL: there is none more.
 */
const char *dispersion_other_way(const Settings *, int which, int number, double *frequency);

/* Waves in the plane of bonds far from surfaces: how fast they run by their length, their direction to the
 * lattice's rows, and the shape of the micromodulus. Source: theory/pd_waves.h. */

/* Phase speed over that of long waves in elasticity, at the wave number k: on this lattice with its volume
 * and surface correction (NAN: shorter than two spacings), and in the continuum of bonds with this horizon.
 * `angle` in radians, 0 along the rows. */
double dispersion_on_lattice(const Settings *, Influence, bool transverse, double angle, double k);
double dispersion_of_bonds(const Settings *, Influence, bool transverse, double k);

#endif
