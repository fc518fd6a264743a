/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Eigenvalues of a symmetric band matrix, one at a time, by counting.
 *
 * The number of negative pivots of A - x in L D L^T is the number of eigenvalues below x (Sylvester's law of
 * inertia); bisection does the rest. No vectors, no memory beyond a few rows, n (width + 1)^2 operations for
 * each halving, and the eigenvalue found is the one that was asked for. Source: B. N. Parlett, The Symmetric
 * Eigenvalue Problem (1998), sections 3.3 and 3.5. */
#ifndef BASE_LINEAR_H
#define BASE_LINEAR_H

#include "base/cancel.h"

#include <stddef.h>
#include <stdbool.h>

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

/* Symmetric positive definite band matrices: Cholesky's factors and solutions with them.
 *
 * K = L L^T keeps the band, so n rows of half-width b take n (b + 1) numbers, n b^2 / 2 products for the
 * factor and 2 n b for each solution. No pivoting: a positive definite matrix needs none. Source: G. H.
 * Golub, C. F. Van Loan, Matrix Computations (2013), section 4.3.5. */

/* rows[i * (width + 1) + d] = K(i, i - d), d = 0 .. width; after cholesky_factor() the same of L. What lies
 * left of the matrix (d > i) is not read. Laid out as Band of base/linear.h, of any width. */
typedef struct Cholesky {
    size_t size, width;
    double *rows;
} Cholesky;

typedef enum CholeskyEnd {
    CHOLESKY_DONE,
    CHOLESKY_SINGULAR, /* a pivot below 1e-14 of its diagonal: not positive definite to rounding */
    CHOLESKY_GIVEN_UP  /* by its Cancel */
} CholeskyEnd;

/* In place. `cancel` is called now and then. */
CholeskyEnd cholesky_factor(Cholesky *, const Cancel *);

/* x <- K^-1 x, after cholesky_factor(). False: given up, and x is of no use. */
bool cholesky_solve(const Cholesky *, double *x, const Cancel *);

#endif
