/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Symmetric positive definite band matrices: Cholesky's factors and solutions with them.
 *
 * K = L L^T keeps the band, so n rows of half-width b take n (b + 1) numbers, n b^2 / 2 products for the
 * factor and 2 n b for each solution. No pivoting: a positive definite matrix needs none. Source: G. H.
 * Golub, C. F. Van Loan, Matrix Computations (2013), section 4.3.5. */
#ifndef BASE_LINEAR_CHOLESKY_H
#define BASE_LINEAR_CHOLESKY_H

#include "base/cancel.h"

#include <stdbool.h>
#include <stddef.h>

/* rows[i * (width + 1) + d] = K(i, i - d), d = 0 .. width; after cholesky_factor() the same of L. What lies
 * left of the matrix (d > i) is not read. Laid out as Band of base/linear/band.h, of any width. */
typedef struct CholeskyBand {
    size_t size, width;
    double *rows;
} CholeskyBand;

typedef enum CholeskyEnd {
    CHOLESKY_DONE,
    CHOLESKY_SINGULAR, /* a pivot below 1e-14 of its diagonal: not positive definite to rounding */
    CHOLESKY_GIVEN_UP  /* by its Cancel */
} CholeskyEnd;

/* In place. `cancel` is called now and then. */
CholeskyEnd cholesky_factor(CholeskyBand *, const Cancel *);

/* x <- K^-1 x, after cholesky_factor(). False: given up, and x is of no use. */
bool cholesky_solve(const CholeskyBand *, double *x, const Cancel *);

#endif
