/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which vector instructions this machine has.
 *
 * Kernels are compiled once for each level from the same source, with the same bits as result, and chosen
 * when a simulation is built. A level that was not compiled (another processor family) is never available. */
#ifndef PHYSICS_CPU_H
#define PHYSICS_CPU_H

#include <stdbool.h>

typedef enum CpuLevel {
    CPU_PLAIN, /* what every machine of this family has: two doubles at once on x86-64 */
    CPU_AVX2,  /* four */
    CPU_AVX512 /* eight: the foundation with its DQ and VL extensions */
} CpuLevel;

enum { CPU_LEVELS = 3 };

/* Kernels of this level were compiled and run here. CPU_PLAIN always does. */
bool cpu_has(CpuLevel level);

/* The widest level that this machine has. */
CpuLevel cpu_best(void);

/* "plain", "avx2", "avx512". */
const char *cpu_name(CpuLevel level);

#endif
