/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers that are worked on together, for the kernels alone: as many as the machine's vectors hold.
 *
 * They are the compiler's own types (GCC and clang), on which + - * / and comparisons work number by number,
 * so that a loop over vectors reads like the loop over numbers and its speed does not hang on what an
 * optimiser recognises. A comparison gives all bits set where it holds, else 0; with something that is not a
 * number it never holds. A file that includes this is compiled once for each instruction set, and calls its
 * table of functions KERNELS(name). */
#ifndef METHODS_VECTOR_H
#define METHODS_VECTOR_H

#include <stdbool.h>
#include <stdint.h>

#ifdef __SSE2__
#include <immintrin.h>
#endif

/* Eight doubles at once with AVX-512, four with AVX, else two. */
#if defined __AVX512F__
enum { VECTOR_WIDTH = 8 };
#define VECTOR_ROOT(x)       _mm512_sqrt_pd((__m512d)(x))
#define VECTOR_IS_ZERO(bits) (_mm512_test_epi64_mask((__m512i)(bits), (__m512i)(bits)) == 0)
#elif defined __AVX__
enum { VECTOR_WIDTH = 4 };
#define VECTOR_ROOT(x)       _mm256_sqrt_pd((__m256d)(x))
#define VECTOR_IS_ZERO(bits) (_mm256_testz_si256((__m256i)(bits), (__m256i)(bits)) != 0)
#else
enum { VECTOR_WIDTH = 2 };
#ifdef __SSE2__
#define VECTOR_ROOT(x) _mm_sqrt_pd((__m128d)(x))
#endif
#endif

/* KERNEL_LEVEL is given where a file is compiled: plain, avx2 or avx512 (cpu.h). */
#define KERNELS_JOIN(name, level) name##_##level
#define KERNELS_OF(name, level)   KERNELS_JOIN(name, level)
#define KERNELS(name)             KERNELS_OF(name, KERNEL_LEVEL)

typedef double Vector __attribute__((vector_size(VECTOR_WIDTH * sizeof(double))));
typedef int64_t VectorMask __attribute__((vector_size(VECTOR_WIDTH * sizeof(double))));

/* The same anywhere in an array of doubles. */
typedef double VectorInArray __attribute__((vector_size(VECTOR_WIDTH * sizeof(double)), aligned(8)));

/* Kernels are built from functions whose arguments (a shape, a number of particles) are constants where they
 * are called: inlined, they leave nothing of their branches. */
#define KERNEL_INLINE static inline __attribute__((always_inline, unused))

KERNEL_INLINE Vector vector_load(const double *from)
{
    return *(const VectorInArray *)from;
}

KERNEL_INLINE void vector_store(double *to, Vector value)
{
    *(VectorInArray *)to = value;
}

KERNEL_INLINE Vector vector_root(Vector x)
{
#ifdef VECTOR_ROOT
    return (Vector)VECTOR_ROOT(x);
#else
    for (int lane = 0; lane < VECTOR_WIDTH; lane++)
        x[lane] = __builtin_sqrt(x[lane]);
    return x;
#endif
}

KERNEL_INLINE bool vector_is_zero(VectorMask bits)
{
#ifdef VECTOR_IS_ZERO
    return VECTOR_IS_ZERO(bits);
#else
    int64_t any = 0;
    for (int lane = 0; lane < VECTOR_WIDTH; lane++)
        any |= bits[lane];
    return any == 0;
#endif
}

KERNEL_INLINE Vector vector_absolute(Vector x)
{
    return (Vector)((VectorMask)x & INT64_MAX);
}

#endif
