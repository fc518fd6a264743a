/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The bond kernels of a level, and the critical stretch s0 as the limits that they compare with: a bond
 * breaks where d = |xi + eta|^2 - |xi|^2 reaches |xi|^2 (2 s0 + s0^2), eq. 6 without a root. */
#include "methods/bonds/plane/lattice/bonds.h"

#include "base/assertion.h"

#include <math.h>

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

/* Asks the processor for its vector instructions, once for each simulation that is made. The levels that
 * were compiled are those of HAVE_X86_KERNELS (configure.ac). */
bool bonds_cpu_has(CpuLevel level)
{
#ifdef HAVE_X86_KERNELS
    if (level == CPU_AVX2)
        return __builtin_cpu_supports("avx2");
    if (level == CPU_AVX512)
        return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
               __builtin_cpu_supports("avx512vl");
#endif
    return level == CPU_PLAIN;
}

CpuLevel bonds_cpu_best(void)
{
    for (int level = CPU_LEVELS - 1; level > CPU_PLAIN; level--)
        if (bonds_cpu_has((CpuLevel)level))
            return (CpuLevel)level;
    return CPU_PLAIN;
}

const char *bonds_cpu_name(CpuLevel level)
{
    static const char *const names[CPU_LEVELS] = {"plain", "avx2", "avx512"};
    return names[level];
}

const BondKernels *bond_kernels(CpuLevel level)
{
#ifdef HAVE_X86_KERNELS
    extern const BondKernels bond_kernels_plain, bond_kernels_avx2, bond_kernels_avx512;
    static const BondKernels *const tables[CPU_LEVELS] = {&bond_kernels_plain, &bond_kernels_avx2,
                                                          &bond_kernels_avx512};
    return bonds_cpu_has(level) ? tables[level] : NULL;
#else
    extern const BondKernels bond_kernels_plain;
    return bonds_cpu_has(level) ? &bond_kernels_plain : NULL;
#endif
}
