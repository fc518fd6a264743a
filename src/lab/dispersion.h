/* Every mode of a bar on its mesh: what a dispersion plot shows, with the reasons for its error apart.
 *
 * Source: the discrete dispersion relation of theory/bar.h. Units: any consistent system. */
#ifndef LAB_DISPERSION_H
#define LAB_DISPERSION_H

#include "lab/settings.h"

#include <stdbool.h>

/* One mode. predicted/exact is the product of the three factors. */
typedef struct ModeOnMesh {
    double exact;     /* omega_n of the continuum, radians per unit time */
    double predicted; /* of this mesh and time step; NAN: no formula, or such a wave does not swing */
    double by_mesh;   /* the lumped mesh alone: sqrt(K)/theta */
    double by_filter; /* particle -> node -> particle: sqrt(F) */
    double by_time;   /* the time step */
} ModeOnMesh;

/* How many modes the mesh can carry, one for each cell; 0: there is no mesh. */
int dispersion_modes(const Settings *);

/* Mode number 1 to dispersion_modes(). False: no such mode. */
bool dispersion_mode(const Settings *, int number, ModeOnMesh *);

#endif
