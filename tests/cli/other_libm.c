/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A C library whose elementary functions err by one bit, to be loaded before the real one: what depends on
 * them is seen by what changes. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <math.h>

#define OTHER(name)                                                                                          \
    double name(double x)                                                                                    \
    {                                                                                                        \
        double (*real)(double);                                                                              \
        *(void **)&real = dlsym(RTLD_NEXT, #name);                                                           \
        return nextafter(real(x), INFINITY);                                                                 \
    }
#define OTHER_OF_TWO(name)                                                                                   \
    double name(double x, double y)                                                                          \
    {                                                                                                        \
        double (*real)(double, double);                                                                      \
        *(void **)&real = dlsym(RTLD_NEXT, #name);                                                           \
        return nextafter(real(x, y), INFINITY);                                                              \
    }
OTHER(sin)
OTHER(cos)
OTHER(tan)
OTHER(asin)
OTHER(acos)
OTHER(atan)
OTHER(sinh)
OTHER(cosh)
OTHER(tanh)
OTHER(exp)
OTHER(exp2)
OTHER(expm1)
OTHER(log)
OTHER(log2)
OTHER(log10)
OTHER(log1p)
OTHER(cbrt)
OTHER(erf)
OTHER_OF_TWO(atan2)
OTHER_OF_TWO(pow)
OTHER_OF_TWO(hypot)

void sincos(double x, double *sine, double *cosine)
{
    *sine = sin(x);
    *cosine = cos(x);
}
