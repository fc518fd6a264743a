/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which vector instructions this machine has.
 *
 * Kernels are compiled once for each level from the same source, with the same bits as result, and chosen
 * when a simulation is built. A level that was not compiled (another processor family) is never available. */
#ifndef METHODS_CPU_H
#define METHODS_CPU_H

#include <stdbool.h>
#include <stddef.h>

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

/* The function that finds the tables of kernels, which vector.h names by level; NULL: this machine has not
 * got that one. */
#ifdef HAVE_X86_KERNELS
#define CPU_KERNELS(Type, name)                                                                              \
    extern const Type name##_plain, name##_avx2, name##_avx512;                                              \
    const Type *name(CpuLevel level)                                                                         \
    {                                                                                                        \
        static const Type *const tables[CPU_LEVELS] = {&name##_plain, &name##_avx2, &name##_avx512};         \
        return cpu_has(level) ? tables[level] : NULL;                                                        \
    }
#else
#define CPU_KERNELS(Type, name)                                                                              \
    extern const Type name##_plain;                                                                          \
    const Type *name(CpuLevel level)                                                                         \
    {                                                                                                        \
        return cpu_has(level) ? &name##_plain : NULL;                                                        \
    }
#endif

#endif
