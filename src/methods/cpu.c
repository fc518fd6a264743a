/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Asks the processor for its vector instructions, once for each simulation that is made. The levels that
 * were compiled are those of HAVE_X86_KERNELS (configure.ac). */
#include "methods/cpu.h"

bool cpu_has(CpuLevel level)
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

CpuLevel cpu_best(void)
{
    for (int level = CPU_LEVELS - 1; level > CPU_PLAIN; level--)
        if (cpu_has((CpuLevel)level))
            return (CpuLevel)level;
    return CPU_PLAIN;
}

const char *cpu_name(CpuLevel level)
{
    static const char *const names[CPU_LEVELS] = {"plain", "avx2", "avx512"};
    return names[level];
}
