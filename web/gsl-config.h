/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What GSL's configure would find out about the C library of a web page. */
#define HAVE_DECL_ACOSH               1
#define HAVE_DECL_ASINH               1
#define HAVE_DECL_ATANH               1
#define HAVE_DECL_EXPM1               1
#define HAVE_DECL_FEENABLEEXCEPT      0
#define HAVE_DECL_FESETTRAPENABLE     0
#define HAVE_DECL_FINITE              1
#define HAVE_DECL_FREXP               1
#define HAVE_DECL_HYPOT               1
#define HAVE_DECL_ISFINITE            1
#define HAVE_DECL_ISINF               1
#define HAVE_DECL_ISNAN               1
#define HAVE_DECL_LDEXP               1
#define HAVE_DECL_LOG1P               1
#define HAVE_EXIT_SUCCESS_AND_FAILURE 1
#define HAVE_IEEE_COMPARISONS         1
#define HAVE_IEEE_DENORMALS           1
#define HAVE_INLINE                   1
#define HAVE_C99_INLINE               1
#define RELEASED
#define GSL_COERCE_DBL(x)  (x)
#define GSL_RANGE_CHECK    0
#define DISCARD_POINTER(p) ((void)(p))
#define RETURN_IF_NULL(x)                                                                                    \
    if (!x)                                                                                                  \
    return
