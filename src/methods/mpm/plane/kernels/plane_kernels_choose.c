/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The kernels that were compiled, by level. plane_kernels.c is compiled once for each instruction set; all
 * give the same bits. */
#include "methods/mpm/plane/kernels/plane_kernels.h"

extern const PlaneKernels plane_kernels_plain;
#ifdef HAVE_X86_KERNELS
extern const PlaneKernels plane_kernels_avx2;
extern const PlaneKernels plane_kernels_avx512;
#endif

const PlaneKernels *plane_kernels(CpuLevel level)
{
#ifdef HAVE_X86_KERNELS
    static const PlaneKernels *const table[CPU_LEVELS] = {&plane_kernels_plain, &plane_kernels_avx2,
                                                          &plane_kernels_avx512};
    return table[level];
#else
    (void)level;
    return &plane_kernels_plain;
#endif
}

void plane_use_kernels(Simulation *sim, CpuLevel level)
{
    plane_of(sim)->kernels = plane_kernels(level);
}
