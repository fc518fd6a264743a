/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Vibration through the thickness of a beam: rows u_j with rho u_j'' = -sum K_jk u_k (methods/bonds/plane,
 * bonds_thickness.c). The eigenvalues of K/rho are omega^2; velocity Verlet raises every frequency to
 * sin(Omega dt/2) = omega dt/2. Only modes that are even about the middle show in the probe, the mean of the
 * rows beside it. */
#include "theory/elastic_beam.h"

#include "base/assertion.h"
#include "theory/quiet.h"
#include "base/math/functions.h"

#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <math.h>

/* Whether u_j = u_{n-1-j} rather than its opposite. */
static bool is_even(const gsl_matrix *modes, size_t mode)
{
    double product = 0;
    for (size_t j = 0; j < modes->size1; j++)
        product += gsl_matrix_get(modes, j, mode) * gsl_matrix_get(modes, modes->size1 - 1 - j, mode);
    return product > 0;
}

/* Omega of each even mode in ascending order, at most `most`; the first mode is rigid motion, and one that
 * the step cannot follow (omega dt >= 2) is left out. Returns how many. */
static int take_modes(const gsl_vector *squares, const gsl_matrix *modes, double density, double dt,
                      double *frequencies, int most)
{
    int count = 0;
    /* the first is rigid motion */
    for (size_t mode = 1; mode < squares->size && count < most; mode++) {
        const double omega = sqrt(fmax(0, gsl_vector_get(squares, mode)) / density);
        if (is_even(modes, mode) && omega * dt / 2 < 1)
            frequencies[count++] = 2 / dt * math_asin(omega * dt / 2);
    }
    return count;
}

/* stiffness: rows x rows, N/m^4 (force density over displacement); its halves are made equal first, for
 * rounding has parted them. frequencies in 1/s. Returns how many even modes there are, 0 also where memory is
 * short. */
int thickness_modes(const double *stiffness, int rows, double density, double dt, double *frequencies,
                    int most)
{
    ASSERT(stiffness && frequencies);
    ASSERT_INT(most, >=, 0);
    if (rows < 3 || !(density > 0) || !(dt > 0))
        return 0;
    const size_t n = (size_t)rows;
    quiet_begin();
    gsl_matrix *matrix = gsl_matrix_alloc(n, n), *modes = gsl_matrix_alloc(n, n);
    gsl_vector *squares = gsl_vector_alloc(n);
    gsl_eigen_symmv_workspace *work = gsl_eigen_symmv_alloc(n);
    int count = 0;
    if (matrix && modes && squares && work) {
        for (size_t j = 0; j < n; j++)
            for (size_t k = 0; k < n; k++)
                gsl_matrix_set(matrix, j, k, (stiffness[j * n + k] + stiffness[k * n + j]) / 2);
        if (quiet_converges(matrix) && gsl_eigen_symmv(matrix, squares, modes, work) == GSL_SUCCESS) {
            gsl_eigen_symmv_sort(squares, modes, GSL_EIGEN_SORT_VAL_ASC);
            count = take_modes(squares, modes, density, dt, frequencies, most);
        }
    }
    gsl_eigen_symmv_free(work);
    gsl_vector_free(squares);
    gsl_matrix_free(modes);
    gsl_matrix_free(matrix);
    quiet_end();
    return count;
}
