/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the residuals of a least-squares fit show of the noise in its data, and how well the parameters are
 * known if that is all that they hold.
 *
 * The noise is taken to be Gaussian, of one strength, and to hang together over time: two data tau apart by
 * r^(tau/step), `step` the mean distance of neighbours (an AR(1) process where the data are equally far
 * apart; white where r = 0). r is what restricted maximum likelihood finds, which the m parameters do not
 * bias as they do the correlation of the residuals themselves (Patterson and Thompson, Biometrika 58 (1971)
 * 545). */
#ifndef THEORY_NOISE_H
#define THEORY_NOISE_H

#include <stdbool.h>
#include <stddef.h>

enum { NOISE_PARAMETERS_MAX = 8 };

typedef struct Noise {
    double correlation; /* r, 0 to below 1 */
    double white;       /* the chance that white noise looks like the residuals (Ljung and Box); 0 to 1 */
    double chance;      /* and that noise with r does: below 1e-3 it is not such noise, and then ... */
    double half_widths[NOISE_PARAMETERS_MAX]; /* ... these 95 % intervals of Student's t do not hold */
    double correlations[NOISE_PARAMETERS_MAX][NOISE_PARAMETERS_MAX]; /* of the parameters, -1 to 1 */
} Noise;

/* residuals: `count`, at ascending times; slopes: count rows of the m derivatives by the parameters, none of
 * which is 0 in all rows; m < count. False: no memory. */
bool noise_judge(const double *times, const double *residuals, const double *slopes, size_t count, int m,
                 Noise *);

#endif
