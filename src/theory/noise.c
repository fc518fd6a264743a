/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The noise in the data of a least-squares fit (noise.h).
 *
 *     J = Q U                                    slopes: Q orthonormal columns, U upper triangle, m x m
 *     R_kl = r^(|t_k - t_l|/step)                correlation of data; whitened by neighbours alone,
 *     w_k = (x_k - rho_k x_{k-1})/sqrt(1 - rho_k^2),  rho_k = R_{k,k-1},  w_0 = x_0
 *     -2 log L(r) = log|R| + log|Q' R^-1 Q| + (n - m) log S(r)    restricted likelihood of the residuals
 *     S(r) = min_b (e - Q b)' R^-1 (e - Q b),    s^2 = S(r)/(n - m)
 *     cov(p) = s^2 U^-1 (Q' R Q) U^-T            of the ordinary least squares that found p
 *     Q' R Q = sum_k (q_k a_k' + a_k q_k' - q_k q_k'),  a_k = q_k + rho_k a_{k-1}
 *
 * Intervals are p +- t(.975, n - m) sqrt(cov_ii). The test is Ljung and Box's on the first lags,
 *
 *     n (n + 2) sum_h c_h^2/(n - h)  ~  chi^2(lags),  c_h the correlation over h places
 *
 * of the residuals and of what whitening leaves of them. */
#include "theory/noise.h"

#include "base/assertion.h"
#include "base/math/functions.h"

#include <gsl/gsl_cdf.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { M = NOISE_PARAMETERS_MAX, LAGS_MAX = 10, HALVINGS = 32 };

#define TOGETHER 0.999999 /* two data at one time count nearly as one */
#define SLOWEST  7.0      /* -log(1 - r) up to which r is sought: .9991 */

typedef struct Judged {
    const double *times, *residuals;
    double *basis; /* Q, count rows of m */
    size_t count;
    int m;
    double step;
} Judged;

static double neighbours(const Judged *judged, double r, size_t k)
{
    const double apart = (judged->times[k] - judged->times[k - 1]) / judged->step;
    return r > 0 ? fmin(math_pow(r, apart), TOGETHER) : 0;
}

/* The determinant of a positive definite matrix and the answer of matrix x = right, by Cholesky in place. */
static double solve(double matrix[M][M], double right[M], int m)
{
    double determinant = 1;
    for (int i = 0; i < m; i++) {
        for (int j = 0; j <= i; j++) {
            double sum = matrix[i][j];
            for (int k = 0; k < j; k++)
                sum -= matrix[i][k] * matrix[j][k];
            matrix[i][j] = i > j ? sum / matrix[j][j] : sqrt(fmax(sum, 1e-300));
        }
        determinant *= matrix[i][i] * matrix[i][i];
    }
    for (int i = 0; i < m; i++) {
        for (int k = 0; k < i; k++)
            right[i] -= matrix[i][k] * right[k];
        right[i] /= matrix[i][i];
    }
    return determinant; /* right' right is right' matrix^-1 right of before */
}

/* -2 log L(r), and s^2. */
static double unlikely(const Judged *judged, double r, double *variance)
{
    const int m = judged->m;
    double matrix[M][M] = {{0}}, right[M] = {0}, squares = 0, log_r = 0;
    for (size_t k = 0; k < judged->count; k++) {
        const double rho = k > 0 ? neighbours(judged, r, k) : 0, scale = 1 / sqrt(1 - rho * rho);
        const double *own = judged->basis + k * (size_t)m, *before = k > 0 ? own - m : own;
        const double e = (judged->residuals[k] - (k > 0 ? rho * judged->residuals[k - 1] : 0)) * scale;
        double q[M];
        for (int i = 0; i < m; i++) {
            q[i] = (own[i] - rho * before[i]) * scale;
            right[i] += q[i] * e;
            for (int j = 0; j <= i; j++)
                matrix[i][j] += q[i] * q[j];
        }
        squares += e * e;
        log_r -= 2 * math_log(scale);
    }
    const double determinant = solve(matrix, right, m);
    for (int i = 0; i < m; i++)
        squares -= right[i] * right[i];
    const double freedom = (double)judged->count - m;
    *variance = fmax(squares, 1e-300) / freedom;
    return log_r + math_log(determinant) + freedom * math_log(*variance);
}

/* The most likely r: the best of a scan over -log(1 - r), then by the golden section around it. */
static double most_likely(const Judged *judged, double *variance)
{
    const double golden = (sqrt(5) - 1) / 2, width = 0.25;
    double best = 0, least = unlikely(judged, 0, variance);
    for (double x = width; x <= SLOWEST; x += width) {
        const double now = unlikely(judged, 1 - math_exp(-x), variance);
        if (now < least) {
            least = now;
            best = x;
        }
    }
    double low = fmax(best - width, 0), high = best + width;
    for (int i = 0; i < HALVINGS; i++) {
        const double left = high - golden * (high - low), right = low + golden * (high - low);
        if (unlikely(judged, 1 - math_exp(-left), variance) <
            unlikely(judged, 1 - math_exp(-right), variance))
            high = right;
        else
            low = left;
    }
    const double r = 1 - math_exp(-(low + high) / 2);
    if (unlikely(judged, r, variance) < unlikely(judged, 0, variance))
        return unlikely(judged, r, variance), r;
    return 0;
}

/* Q and U by the modified method of Gram and Schmidt, done twice for columns that are nearly parallel. */
static void orthogonalise(Judged *judged, const double *slopes, double upper[M][M])
{
    const int m = judged->m;
    const size_t n = judged->count;
    double *q = judged->basis;
    memcpy(q, slopes, n * (size_t)m * sizeof *q);
    for (int j = 0; j < m; j++) {
        for (int pass = 0; pass < 2; pass++)
            for (int i = 0; i < j; i++) {
                double product = 0;
                for (size_t k = 0; k < n * (size_t)m; k += (size_t)m)
                    product += q[k + (size_t)i] * q[k + (size_t)j];
                upper[i][j] += product;
                for (size_t k = 0; k < n * (size_t)m; k += (size_t)m)
                    q[k + (size_t)j] -= product * q[k + (size_t)i];
            }
        double squares = 0;
        for (size_t k = 0; k < n * (size_t)m; k += (size_t)m)
            squares += q[k + (size_t)j] * q[k + (size_t)j];
        upper[j][j] = sqrt(squares);
        for (size_t k = 0; k < n * (size_t)m; k += (size_t)m)
            q[k + (size_t)j] /= upper[j][j];
    }
}

/* Q' R Q into `out`, which is 0. */
static void correlate(const Judged *judged, double r, double out[M][M])
{
    const int m = judged->m;
    double sum[M] = {0};
    for (size_t k = 0; k < judged->count; k++) {
        const double rho = k > 0 ? neighbours(judged, r, k) : 0, *q = judged->basis + k * (size_t)m;
        for (int i = 0; i < m; i++)
            sum[i] = q[i] + rho * sum[i];
        for (int i = 0; i < m; i++)
            for (int j = 0; j < m; j++)
                out[i][j] += q[i] * sum[j] + sum[i] * q[j] - q[i] * q[j];
    }
}

/* U^-1 C U^-T in place of C: first its columns, then its rows. */
static void transform(double upper[M][M], double matrix[M][M], int m)
{
    for (int side = 0; side < 2; side++)
        for (int c = 0; c < m; c++)
            for (int i = m - 1; i >= 0; i--) {
                double *at = side == 0 ? &matrix[i][c] : &matrix[c][i];
                for (int k = i + 1; k < m; k++)
                    *at -= upper[i][k] * (side == 0 ? matrix[k][c] : matrix[c][k]);
                *at /= upper[i][i];
            }
}

/* The chance that noise that is white after whitening with r looks like this. */
static double chance_of(const Judged *judged, double r, double *white)
{
    const size_t n = judged->count, fifth = n / 5;
    const size_t lags = fifth < LAGS_MAX ? fifth : LAGS_MAX;
    double squares = 0, sum = 0;
    for (size_t k = 0; k < n; k++) {
        const double rho = k > 0 ? neighbours(judged, r, k) : 0;
        white[k] =
            (judged->residuals[k] - (k > 0 ? rho * judged->residuals[k - 1] : 0)) / sqrt(1 - rho * rho);
        squares += white[k] * white[k];
    }
    if (lags == 0 || squares == 0)
        return 1;
    for (size_t h = 1; h <= lags; h++) {
        double product = 0;
        for (size_t k = h; k < n; k++)
            product += white[k] * white[k - h];
        sum += product * product / squares / squares / (double)(n - h);
    }
    return gsl_cdf_chisq_Q((double)n * (double)(n + 2) * sum, (double)lags);
}

bool noise_judge(const double *times, const double *residuals, const double *slopes, size_t count, int m,
                 Noise *noise)
{
    ASSERT_INT(m, <=, M);
    ASSERT_INT(count, >, m);
    *noise = (Noise){.correlation = 0};
    Judged judged = {.times = times, .residuals = residuals, .count = count, .m = m};
    const double span = times[count - 1] - times[0];
    judged.step = span > 0 ? span / (double)(count - 1) : 1;
    judged.basis = malloc(count * (size_t)m * sizeof *judged.basis);
    double *white = malloc(count * sizeof *white);
    const bool sound = judged.basis && white;
    if (sound) {
        double upper[M][M] = {{0}}, covariance[M][M] = {{0}}, variance;
        orthogonalise(&judged, slopes, upper);
        const double r = noise->correlation = most_likely(&judged, &variance);
        correlate(&judged, r, covariance);
        transform(upper, covariance, m);
        const double t = gsl_cdf_tdist_Pinv(0.975, (double)count - m);
        for (int i = 0; i < m; i++) {
            const double own = covariance[i][i];
            noise->half_widths[i] = t * sqrt(variance * own);
            for (int j = 0; j < m; j++)
                noise->correlations[i][j] = covariance[i][j] / sqrt(own * covariance[j][j]);
        }
        noise->white = chance_of(&judged, 0, white);
        noise->chance = chance_of(&judged, r, white);
    }
    free(judged.basis);
    free(white);
    return sound;
}
