/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Eigenvalues of a symmetric band matrix by counting (linear.h): A - x = L D L^T row by row without
 * pivoting,
 *
 *     D_i = A_ii - x - sum_{j<i} L_ij^2 D_j,   L_ij D_j = A_ij - sum_{k<j} L_ik D_k L_jk,
 *
 * and as many eigenvalues lie below x as D has negative entries (Sylvester). Only the last `width` + 1
 * rows of L are kept. Used for the critical step and the predicted frequencies of the bar by peridynamics. */
#include "base/linear.h"

#include "base/assertion.h"

#include <errno.h>
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static double entry(const Band *band, size_t i, size_t d)
{
    return d <= (size_t)band->width && d <= i ? band->rows[i * ((size_t)band->width + 1) + d] : 0;
}

/* max_i sum_j |A_ij|, a bound on the size of all eigenvalues (Gershgorin). */
static double reach_of(const Band *band)
{
    double most = 0;
    for (size_t i = 0; i < band->size; i++) {
        double sum = fabs(entry(band, i, 0));
        for (size_t d = 1; d <= (size_t)band->width; d++)
            sum += fabs(entry(band, i, d)) + (i + d < band->size ? fabs(entry(band, i + d, d)) : 0);
        most = fmax(most, sum);
    }
    return most;
}

/* A pivot smaller than `least` is replaced by it, which changes the matrix by no more than its rounding.
 * SIZE_MAX: given up. */
static size_t count_below(const Band *band, double x, double least, const Cancel *cancel, double share)
{
    enum { ROWS = BAND_WIDTH_MAX + 1, PRODUCTS_BETWEEN_QUESTIONS = 2000000 }; /* a few milliseconds */
    double lower[ROWS][ROWS]; /* the last rows of L, left of the diagonal: [d] is column i - d */
    double pivots[ROWS];
    double scaled[ROWS]; /* L_ij D_j of the row at hand */
    const size_t width = (size_t)band->width, kept = width + 1;
    const size_t rows_a_question = PRODUCTS_BETWEEN_QUESTIONS / (kept * kept);
    size_t count = 0, place = 0; /* i % kept */
    for (size_t i = 0; i < band->size; i++) {
        double *row = lower[place], pivot = entry(band, i, 0) - x;
        const size_t left = i < width ? i : width;
        if (i % rows_a_question == 0 && cancel_requested(cancel, share))
            return SIZE_MAX;
        for (size_t d = left; d >= 1; d--) {
            const size_t there = place >= d ? place - d : place + kept - d;
            const double *other = lower[there];
            double product = entry(band, i, d);
            for (size_t e = d + 1; e <= left; e++)
                product -= scaled[e] * other[e - d];
            row[d] = product / pivots[there];
            scaled[d] = row[d] * pivots[there];
            pivot -= row[d] * product;
        }
        if (fabs(pivot) < least)
            pivot = least;
        pivots[place] = pivot;
        count += pivot < 0;
        place = place + 1 < kept ? place + 1 : 0;
    }
    return count;
}

/* Bisection between the bounds; ends at a quarter of their rounding, or where no double lies between. */
double band_eigenvalue(const Band *band, size_t number, const Cancel *cancel)
{
    ASSERT_INDEX(number, band->size);
    ASSERT_INT(band->width, <=, BAND_WIDTH_MAX);
    enum { HALVINGS = 56 }; /* of 2 to eps/4, about */
    double high = reach_of(band), low = -high;
    const double rounding = DBL_EPSILON * high;
    for (int k = 0; high - low > rounding / 4; k++) {
        double middle = low + (high - low) / 2;
        if (!(middle > low && middle < high))
            break;
        const size_t below = count_below(band, middle, rounding, cancel, fmin((k + 1.0) / HALVINGS, 1));
        if (below == SIZE_MAX) {
            errno = ECANCELED;
            return NAN;
        }
        *(below > number ? &high : &low) = middle;
    }
    return low + (high - low) / 2;
}

/* The factor and the solution of a Cholesky band. Nearly all time goes into dot products of two rows of L.
 * Used for the lowest modes of the beams' lattice (bonds_modes.c). */

/* A question every ten milliseconds or so: a product of the solution waits for memory, where the factor has
 * its rows at hand. */
enum { LANES = 8, PRODUCTS_BETWEEN_QUESTIONS = 20000000, PRODUCTS_OF_SOLUTION = 2000000 };

double linear_dot(const double *a, const double *b, size_t count)
{
    double sums[LANES] = {0};
    size_t k = 0;
    for (; k + LANES <= count; k += LANES)
        for (size_t lane = 0; lane < LANES; lane++)
            sums[lane] += a[k + lane] * b[k + lane];
    for (size_t lane = 0; k + lane < count; lane++)
        sums[lane] += a[k + lane] * b[k + lane];
    return ((sums[0] + sums[1]) + (sums[2] + sums[3])) + ((sums[4] + sums[5]) + (sums[6] + sums[7]));
}

/* L(i,j) = (K(i,j) - sum_k<j L(i,k) L(j,k)) / L(j,j),  L(i,i)^2 = K(i,i) - sum_k<i L(i,k)^2,
 * row by row: with distances d = i - k from the diagonal both rows are read forwards. */
CholeskyEnd cholesky_factor(Cholesky *band, const Cancel *cancel)
{
    const size_t width = band->width, stride = width + 1;
    size_t products = 0;
    for (size_t i = 0; i < band->size; i++) {
        double *row = band->rows + i * stride;
        const size_t left = i < width ? i : width;
        for (size_t d = left; d >= 1; d--) {
            const size_t j = i - d;
            const double *other = band->rows + j * stride;
            row[d] = (row[d] - linear_dot(row + d + 1, other + 1, left - d)) / other[0];
        }
        const double pivot = row[0] - linear_dot(row + 1, row + 1, left);
        if (!(pivot > 1e-11 * row[0]))
            return CHOLESKY_SINGULAR;
        row[0] = sqrt(pivot);
        products += left * left / 2;
        if (products > PRODUCTS_BETWEEN_QUESTIONS) {
            products = 0;
            if (cancel_requested(cancel, (double)i / (double)band->size))
                return CHOLESKY_GIVEN_UP;
        }
    }
    return CHOLESKY_DONE;
}

/* L y = x forwards, L^T x = y backwards. */
bool cholesky_solve(const Cholesky *band, double *x, const Cancel *cancel)
{
    ASSERT(band->rows);
    const size_t width = band->width, stride = width + 1, rows_a_question = PRODUCTS_OF_SOLUTION / stride + 1;
    for (size_t i = 0; i < band->size; i++) {
        if (i % rows_a_question == 0 && cancel_requested(cancel, 1))
            return false;
        const double *row = band->rows + i * stride;
        const size_t left = i < width ? i : width;
        double sum = x[i];
        for (size_t d = 1; d <= left; d++)
            sum -= row[d] * x[i - d];
        x[i] = sum / row[0];
    }
    for (size_t i = band->size; i-- > 0;) {
        if (i % rows_a_question == 0 && cancel_requested(cancel, 1))
            return false;
        const double *row = band->rows + i * stride;
        const size_t left = i < width ? i : width;
        x[i] /= row[0];
        for (size_t d = 1; d <= left; d++)
            x[i - d] -= row[d] * x[i];
    }
    return true;
}

void cholesky_multiply(const Cholesky *band, const double *x, double *y)
{
    memset(y, 0, band->size * sizeof *y);
    for (size_t r = 0; r < band->size; r++) {
        const double *row = band->rows + r * (band->width + 1);
        const size_t most = band->width < r ? band->width : r;
        y[r] += row[0] * x[r];
        for (size_t d = 1; d <= most; d++) {
            y[r] += row[d] * x[r - d];
            y[r - d] += row[d] * x[r];
        }
    }
}

/* --- by products ---------------------------------------------------------------------------------- */

/* out = A x; without a map x. */
static bool product(const LinearMap *map, const double *x, double *out, size_t size)
{
    if (!map && out != x)
        memcpy(out, x, size * sizeof *out);
    if (!map || map->apply(map->context, x, out))
        return true;
    errno = ECANCELED;
    return false;
}

static void divide(double *x, double divisor, size_t size)
{
    for (size_t i = 0; i < size; i++)
        x[i] /= divisor;
}

/* Of the tridiagonal matrix that has been made so far. */
static double largest_of(const double *rows, size_t size)
{
    const Band band = {size, 1, rows};
    return band_eigenvalue(&band, size - 1, &(Cancel){0}); /* small */
}

/* v is q_k, u = B q_k, the same memory where B is 1; w becomes A u less its parts along q_k and q_{k-1}, so
 * that its length is beta_k. */
static double iterate(size_t n, LinearMap A, const LinearMap *B, double settled, double *v, double *work)
{
    enum { STEPS_MAX = 1000, STEPS_MIN = 20, CHECK_EVERY = 5 };
    double rows[2 * STEPS_MAX], beta = 0, value = 0; /* of the band: alpha_k, beta_{k-1} */
    double *before = work, *w = work + n, *u = B ? work + 2 * n : v;
    if (!product(B, v, u, n))
        return NAN;
    const double length = sqrt(linear_dot(v, u, n));
    divide(v, length, n);
    if (B)
        divide(u, length, n);
    for (size_t k = 0; k < STEPS_MAX; k++) {
        if (!product(&A, u, w, n))
            return NAN;
        for (size_t i = 0; i < n; i++)
            w[i] -= beta * before[i];
        rows[2 * k] = linear_dot(w, u, n);
        rows[2 * k + 1] = beta;
        for (size_t i = 0; i < n; i++) {
            before[i] = v[i];
            w[i] -= rows[2 * k] * v[i];
        }
        memcpy(v, w, n * sizeof *v);
        if (!product(B, v, u, n))
            return NAN;
        beta = sqrt(fmax(linear_dot(v, u, n), 0));
        if (beta == 0)
            return largest_of(rows, k + 1);
        divide(v, beta, n);
        if (B)
            divide(u, beta, n);
        if (k >= STEPS_MIN && k % CHECK_EVERY == 0) {
            const double was = value;
            value = largest_of(rows, k + 1);
            if (value - was < settled * value)
                return value;
        }
    }
    errno = 0;
    return NAN;
}

double linear_largest(size_t size, LinearMap A, const LinearMap *B, double settled, double *start)
{
    double *work = calloc(3 * size, sizeof *work);
    const double value = work ? iterate(size, A, B, settled, start, work) : NAN;
    if (!work)
        errno = ENOMEM;
    free(work);
    return value;
}

bool linear_lowest(const Cholesky *K, const LinearMap *B, double *work, double *eigenvalue,
                   const Cancel *cancel)
{
    enum { ITERATIONS_MAX = 300 };
    const size_t n = K->size;
    const double settled = 1e-8; /* where rounding keeps the last digits moving */
    double *x = work, *y = x + n, *z = y + n, lambda = 0, change = INFINITY;
    for (int k = 0; k < ITERATIONS_MAX && !(change < 1e-12); k++) {
        const double before = lambda;
        divide(x, sqrt(linear_dot(x, x, n)), n);
        if (!product(B, x, y, n))
            return false;
        memcpy(z, y, n * sizeof *z);
        if (!cholesky_solve(K, z, cancel))
            return false;
        lambda = linear_dot(x, y, n) / linear_dot(z, y, n);
        memcpy(x, z, n * sizeof *x);
        change = fabs(lambda - before) / lambda;
    }
    *eigenvalue = change < settled ? lambda : NAN;
    return true;
}
