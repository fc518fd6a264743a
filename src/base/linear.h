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

#include <stdbool.h>
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
    CHOLESKY_SINGULAR, /* a pivot below 1e-11 of its diagonal: not positive definite but for rounding */
    CHOLESKY_GIVEN_UP  /* by its Cancel */
} CholeskyEnd;

/* In place. `cancel` is called now and then. */
CholeskyEnd cholesky_factor(Cholesky *, const Cancel *);

/* x <- K^-1 x, after cholesky_factor(). False: given up, and x is of no use. */
bool cholesky_solve(const Cholesky *, double *x, const Cancel *);

/* y = K x of a band that is not factored. */
void cholesky_multiply(const Cholesky *, const double *x, double *y);

/* Eigenvalues of matrices that are known by their products with vectors alone. */

/* out = A x; false: given up. */
typedef struct LinearMap {
    bool (*apply)(void *context, const double *x, double *out);
    void *context;
} LinearMap;

/* sum a_k b_k in eight partial sums, so that the compiler may keep them in vectors of any width with the same
 * bits. */
double linear_dot(const double *a, const double *b, size_t count);

/* The largest eigenvalue of A B, A and B symmetric, B not negative (NULL: 1), by Lanczos' method in the
 * product x'B y:
 *
 *     beta_k q_{k+1} = A B q_k - alpha_k q_k - beta_{k-1} q_{k-1},  alpha_k = q_k'B A B q_k,  q_k'B q_k = 1
 *
 * The largest eigenvalue of the tridiagonal matrix of alphas and betas converges to it from below, in far
 * fewer products than power iteration needs; the q are not made orthogonal again: that only repeats
 * eigenvalues that have converged. It stops when the value moves by less than a share of `settled` in five
 * products. `start` has a part of every mode, and is used up. NAN: given up by a map (errno ECANCELED), no
 * memory (ENOMEM), or not converged (0). Source: Parlett, chapter 13. */
double linear_largest(size_t size, LinearMap A, const LinearMap *B, double settled, double *start);

/* The lowest eigenvalue of K x = lambda B x by inverse iteration, x <- K^-1 B x, from Rayleigh quotients,
 * which have the square of the vector's error; K is factored. work[0 .. size - 1] is the start and, in the
 * end, the vector, of 3 size numbers. It never finds what the start has nothing of. NAN: not converged.
 * False: given up. Source: Parlett, chapter 4. */
bool linear_lowest(const Cholesky *K, const LinearMap *B, double *work, double *eigenvalue, const Cancel *);

#endif
