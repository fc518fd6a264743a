/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Eigenvalues of a symmetric band matrix, one at a time, by counting.
 *
 * The number of negative pivots of A - x in L D L^T is the number of eigenvalues below x (Sylvester's law of
 * inertia); bisection does the rest. No vectors, no memory beyond a few rows, n (width + 1)^2 operations for
 * each halving, and the eigenvalue found is the one that was asked for. Source: B. N. Parlett, The Symmetric
 * Eigenvalue Problem (1998), sections 3.3 and 3.5. */
#ifndef BASE_LINEAR_BAND_H
#define BASE_LINEAR_BAND_H

#include "base/cancel.h"

#include <stddef.h>

enum { BAND_WIDTH_MAX = 32 };

/* rows[i * (width + 1) + d] = A(i, i - d), d = 0 .. width; what lies left of the matrix is not read. */
typedef struct Band {
    size_t size;
    int width; /* 1 to BAND_WIDTH_MAX */
    const double *rows;
} Band;

/* Eigenvalue number 0 (the least) to size - 1, to the rounding of the largest one's size. `cancel` is asked
 * every few milliseconds, with shares above 0. NAN: given up, errno is ECANCELED. */
double band_eigenvalue(const Band *band, size_t number, const Cancel *cancel);

#endif
