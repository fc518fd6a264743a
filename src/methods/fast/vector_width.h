/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How many numbers the machine's vectors have, and what it does with one instruction: eight doubles with
 * AVX-512, four with AVX, else two. Part of vector.h. */
#ifdef __SSE2__
#include <immintrin.h>
#endif

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
