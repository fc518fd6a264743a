/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The factor and the solution of cholesky.h. Nearly all time goes into dot products of two rows of L. Used
 * for the lowest modes of the beams' lattice (bonds_modes.c). */
#include "base/linear/cholesky.h"

#include "base/assertion.h"

#include <math.h>

/* A question every ten milliseconds or so: a product of the solution waits for memory, where the factor has
 * its rows at hand. */
enum { LANES = 8, PRODUCTS_BETWEEN_QUESTIONS = 20000000, PRODUCTS_OF_SOLUTION = 2000000 };

/* sum a_k b_k in LANES partial sums, so that the compiler may keep them in vectors of any width with the same
 * bits. */
static double dot(const double *a, const double *b, size_t count)
{
    double sums[LANES] = {0}, sum = 0;
    size_t k = 0;
    for (; k + LANES <= count; k += LANES)
        for (size_t lane = 0; lane < LANES; lane++)
            sums[lane] += a[k + lane] * b[k + lane];
    for (; k < count; k++)
        sum += a[k] * b[k];
    for (size_t lane = 0; lane < LANES; lane++)
        sum += sums[lane];
    return sum;
}

/* L(i,j) = (K(i,j) - sum_k<j L(i,k) L(j,k)) / L(j,j),  L(i,i)^2 = K(i,i) - sum_k<i L(i,k)^2,
 * row by row: with distances d = i - k from the diagonal both rows are read forwards. */
CholeskyEnd cholesky_factor(CholeskyBand *band, const Cancel *cancel)
{
    const size_t width = band->width, stride = width + 1;
    size_t products = 0;
    for (size_t i = 0; i < band->size; i++) {
        double *row = band->rows + i * stride;
        const size_t left = i < width ? i : width;
        for (size_t d = left; d >= 1; d--) {
            const size_t j = i - d;
            const double *other = band->rows + j * stride;
            row[d] = (row[d] - dot(row + d + 1, other + 1, left - d)) / other[0];
        }
        const double pivot = row[0] - dot(row + 1, row + 1, left);
        if (!(pivot > 1e-14 * row[0]))
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
bool cholesky_solve(const CholeskyBand *band, double *x, const Cancel *cancel)
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
