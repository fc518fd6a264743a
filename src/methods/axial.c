/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which particles of a bar bear the traction: those whose middle lies in the layer h of paper M, eq. 11,
 * (k + 1/2) spacing < h, with a tolerance for a layer that ends on a middle. */
#include "methods/axial.h"

#include "base/assertion.h"
#include <math.h>

int axial_particles_in_layer(double layer, double spacing, int particles)
{
    ASSERT_REAL(spacing, >, 0);
    ASSERT_INT(particles, >=, 1);
    double within = ceil(layer / spacing - 0.5 - 1e-9);
    return within < particles ? (int)within : particles;
}

bool axial_check_layer(double layer, double spacing, double length, Status *status)
{
    ASSERT_REAL(spacing, >, 0);
    if (!(layer >= 0 && layer <= length))
        return status_refuse(status, "load.traction_layer: %g is out of range (0 to the length %g)", layer,
                             length);
    if (layer > 0 && layer <= 0.5 * spacing)
        return status_refuse(status, "load.traction_layer: %g holds no particle (more than %g, or 0 for %g)",
                             layer, 0.5 * spacing, spacing);
    return true;
}
