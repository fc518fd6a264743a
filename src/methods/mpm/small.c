/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Small motion of particles that stay in their places: their state as a vector, of which |x|^2 is twice the
 * energy, sum m v^2 + V stress^2/E (method.h). With APIC also m (dx C/2)^2; its D is dx^2/4 or near it. */
#include "base/assertion.h"
#include "methods/mpm/engine.h"

size_t mpm_small(Simulation *sim, double *x, double unit, bool put)
{
    Mpm *mpm = mpm_of(sim);
    double *const arrays[] = {mpm->v[0], mpm->stress[0], mpm->affine};
    const int parts = mpm->head->transfer == MPM_APIC ? 3 : 2, count = mpm->n_particles;
    ASSERT_INT(mpm->dim, ==, 1);
    for (int k = 0; k < parts && x; k++)
        for (int p = 0; p < count; p++) {
            const double root = sqrt(mpm_mass(mpm, p));
            const double scale = k == 0   ? root
                                 : k == 1 ? unit * sqrt(mpm->volume[p] / mpm_modulus(mpm, p))
                                          : root * mpm->dx / 2.0;
            if (put)
                arrays[k][p] = x[k * count + p] / scale;
            else
                x[k * count + p] = arrays[k][p] * scale;
        }
    return (size_t)parts * (size_t)count;
}
