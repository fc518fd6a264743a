/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kernels that were compiled, by level. kernels.c is compiled once for each instruction set; all give the
 * same bits. */
#include "methods/mpm/line/kernels/bar_kernels.h"

extern const BarKernels bar_kernels_plain;
#ifdef HAVE_X86_KERNELS
extern const BarKernels bar_kernels_avx2;
extern const BarKernels bar_kernels_avx512;
#endif

const BarKernels *bar_kernels(CpuLevel level)
{
#ifdef HAVE_X86_KERNELS
    static const BarKernels *const table[CPU_LEVELS] = {&bar_kernels_plain, &bar_kernels_avx2,
                                                        &bar_kernels_avx512};
    return table[level];
#else
    (void)level;
    return &bar_kernels_plain;
#endif
}

void bar_use_kernels(Simulation *sim, CpuLevel level)
{
    bar_of(sim)->kernels = bar_kernels(level);
}
