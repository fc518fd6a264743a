/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bond kernels of a level, and the critical stretch s0 as the limits that they compare with: a bond
 * breaks where d = |xi + eta|^2 - |xi|^2 reaches |xi|^2 (2 s0 + s0^2), eq. 6 without a root. */
#include "methods/bonds/plane/lattice/bonds.h"

#include "base/assertion.h"

#include <math.h>

CPU_KERNELS(BondKernels, bond_kernels)

/* Per direction: d at which a bond breaks, (1 + s0)^2 |xi|^2 - |xi|^2; and |d| up to which the series may be
 * used, e = 2^-8 or the former if that comes first, since only the root's form asks whether a bond breaks. */
void bonds_set_limits(BondSystem *system, double critical_stretch)
{
    ASSERT_REAL(critical_stretch, >=, 0);
    for (int o = 0; o < system->lattice->n_offsets; o++) {
        double squared = system->lattice->offsets[o].squared;
        double breaks = squared * (2 * critical_stretch + critical_stretch * critical_stretch);
        system->break_limit[o] = critical_stretch > 0 ? breaks : INFINITY;
        system->series_limit[o] = fmin(squared / 256, system->break_limit[o]);
    }
}
