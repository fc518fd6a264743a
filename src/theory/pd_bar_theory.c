/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Predicted frequencies of the bar by peridynamics; lattice.c in methods/bonds has the equations. First a
 * wave on an endless lattice, in closed form; then the lattice with its ends, as eigenvalues of the matrix
 * that its families make, A u = omega^2 u, a band (band_eigenvalue) for one frequency and dense where all
 * eigenvectors are needed for v_cm(t). */
#include "theory/pd_bar_theory.h"

#include "base/assertion.h"
#include "base/linear/band.h"
#include "base/math/functions.h"
#include "theory/gsl_errors.h"

#include <float.h>
#include <gsl/gsl_matrix.h>
#include <math.h>
#include <stdlib.h>

/* --- the endless lattice -------------------------------------------------------------------------- */

/* Neighbours at one side. A cone binds nothing beyond the horizon. */
static int reach_of(const PdBarTheory *lattice)
{
    return (int)pd_volumes_reach(lattice->conical ? VOLUME_PARTIAL : lattice->volumes,
                                 lattice->horizon / lattice->spacing);
}

static double weight(const PdBarTheory *lattice, int m)
{
    return pd_volumes_factor(lattice->volumes, lattice->horizon / lattice->spacing, m);
}

/* w_m times what the micromodulus is there, over 2E/delta^2. */
static double strength(const PdBarTheory *lattice, int m)
{
    const double ratio = lattice->horizon / lattice->spacing;
    double sum = 0;
    if (!lattice->conical)
        return weight(lattice, m);
    for (int n = 1; n <= reach_of(lattice); n++)
        sum += (1 - n / ratio) * weight(lattice, n) * n;
    return (1 - m / ratio) * weight(lattice, m) * ratio * ratio / (2 * sum);
}

/* A wave exp(i(beta x - omega t)) on the endless lattice, theta = beta h. The bonds to both sides at distance
 * m h pull with k_m (2 - 2 cos(m theta)) = 4 k_m sin^2(m theta/2), and with k_m = c G w_m V/(m h), c =
 * 2E/delta^2, V = h
 *
 *     omega^2 = 8 E G/(rho delta^2) sum_m w_m/m sin^2(m theta/2)
 *     G = 1, or with the energy correction (delta/h)^2/(2 sum_m w_m m), the same for all nodes
 *
 * wave_number in 1/length of the caller's unit, of either sign. space_only is omega, frequency what the time
 * step makes of it; known is false beyond theta = pi and beyond the stability limit. Waves of the lattice do
 * not decay. */
Dispersion pd_bar_dispersion(const BarTheory *bar, const PdBarTheory *lattice, double wave_number)
{
    ASSERT_REAL(lattice->spacing, >, 0);
    Dispersion wave = {.space_only = NAN, .frequency = NAN, .decay = 0, .filter = 1};
    double theta = fabs(wave_number) * lattice->spacing, ratio = lattice->horizon / lattice->spacing;
    double sum = 0, moment = 0;
    if (!(theta <= M_PI * (1 + 1e-12))) /* shorter than two spacings: to the nodes it is a longer one */
        return wave;
    for (int m = 1; m <= reach_of(lattice); m++) {
        double s = math_sin(m * theta / 2);
        sum += strength(lattice, m) / m * s * s;
        moment += strength(lattice, m) * m;
    }
    if (lattice->energy_correction)
        sum *= ratio * ratio / (2 * moment);
    wave.space_only = sqrt(8 * bar->youngs_modulus / bar->density * sum) / lattice->horizon;
    wave.frequency = bar_motion_frequency(wave.space_only, lattice->dt);
    wave.known = lattice->dt > 0 && isfinite(wave.frequency);
    return wave;
}

/* --- the lattice with its ends -------------------------------------------------------------------- */

/* The node at place k, or the one whose mirror image lies there; -1: nothing does. */
static int node_at(const BarTheory *bar, int n, int k, int *sign)
{
    *sign = k < 0 || k >= n ? -1 : 1;
    if (k < 0)
        return bar->left_fixed ? -1 - k : -1;
    if (k >= n)
        return bar->right_fixed ? 2 * n - 1 - k : -1;
    return k;
}

/* 1/g_i: the energy of node i's family at unit strain over E/2, (h/delta)^2 sum w_m m. */
static double family_share(const BarTheory *bar, const PdBarTheory *lattice, int n, int i)
{
    double ratio = lattice->horizon / lattice->spacing, sum = 0;
    int sign;
    for (int m = 1; m <= reach_of(lattice); m++)
        for (int side = -1; side <= 1; side += 2)
            if (node_at(bar, n, i + side * m, &sign) >= 0)
                sum += strength(lattice, m) * m;
    return sum / (ratio * ratio);
}

/* g of each node: 1 without correction. NULL: no memory. */
static double *node_factors(const BarTheory *bar, const PdBarTheory *lattice, int n)
{
    double *g = malloc((size_t)n * sizeof *g);
    for (int i = 0; g && i < n; i++)
        g[i] = lattice->energy_correction ? 1 / family_share(bar, lattice, n, i) : 1;
    return g;
}

typedef void PutEntry(void *into, int row, int column, double value);

/* A(i, j) of u_i'' = -sum A(i, j) u_j, A(i, i) = sum k, A(i, j) = -+k with k = 2E/(rho delta^2) G w_m/m; +
 * for a mirrored node, u = -u_j. Handed over entry by entry; entries of the same place are to be added. G of
 * a bond is the mean of g of its two ends. False: no memory. */
static bool write_matrix(const BarTheory *bar, const PdBarTheory *lattice, int n, PutEntry *put, void *into)
{
    const double scale = 2 * bar->youngs_modulus / (bar->density * lattice->horizon * lattice->horizon);
    double *g = node_factors(bar, lattice, n);
    for (int i = 0; g && i < n; i++)
        for (int m = 1; m <= reach_of(lattice); m++)
            for (int side = -1; side <= 1; side += 2) {
                int sign, j = node_at(bar, n, i + side * m, &sign);
                if (j < 0)
                    continue;
                double k = scale * (g[i] + g[j]) / 2 * strength(lattice, m) / m;
                put(into, i, i, k);
                put(into, i, j, -sign * k);
            }
    const bool written = g != NULL;
    free(g);
    return written;
}

typedef struct BandRows {
    double *rows;
    int width;
} BandRows;

/* The lower half of the matrix, row by row from the diagonal to the left, as band_eigenvalue() wants it. */
static void put_in_band(void *into, int row, int column, double value)
{
    BandRows *band = into;
    if (column <= row)
        band->rows[row * (band->width + 1) + row - column] += value;
}

/* Nodes at (i + 1/2) h, i from 0: half a spacing within either end. */
static int nodes_of(const BarTheory *bar, const PdBarTheory *lattice)
{
    return (int)round(bar->length / lattice->spacing);
}

/* Eigenvalues are found to eps times a bound on the largest (Gershgorin): whether that leaves 1e-8 of the one
 * wanted. */
static bool is_resolved(const BarTheory *bar, const PdBarTheory *lattice, int number)
{
    enum { LARGEST_FACTOR = 2 }; /* a bond at a free end may be so much stiffer */
    const double scale = 2 * bar->youngs_modulus / (bar->density * lattice->horizon * lattice->horizon);
    double row = 0;
    for (int m = 1; m <= reach_of(lattice); m++)
        row += 2 * scale * strength(lattice, m) / m;
    return DBL_EPSILON * 2 * LARGEST_FACTOR * row <= 1e-8 * math_pow(bar_frequency(bar, number), 2);
}

/* Frequency of mode `number` (from 1) of the lattice with its ends, in 1/time. Between two mirrors every sine
 * is an eigenvector and the wave's closed form is the answer; else it is the eigenvalue at its place in the
 * spectrum, for a free end changes the bonds near it. NAN: no such mode, not enough memory, given up, an
 * unstable step, or a mode so slow beside the fastest that rounding would hide it. */
double pd_bar_frequency(const BarTheory *bar, const PdBarTheory *lattice, int number)
{
    const int n = nodes_of(bar, lattice), width = reach_of(lattice);
    if (number < 1 || number > n || width > n || width > BAND_WIDTH_MAX)
        return NAN;
    if (bar->left_fixed && bar->right_fixed)
        return pd_bar_dispersion(bar, lattice, bar_wave_number(bar, number)).frequency;
    if (!is_resolved(bar, lattice, number))
        return NAN;
    /* the free-free bar has its rigid motion first */
    const int place = bar->left_fixed || bar->right_fixed ? number - 1 : number;
    BandRows band = {calloc((size_t)n * (size_t)(width + 1), sizeof(double)), width};
    if (!band.rows || place >= n || !write_matrix(bar, lattice, n, put_in_band, &band)) {
        free(band.rows);
        return NAN;
    }
    const Band matrix = {(size_t)n, width, band.rows};
    const double square = band_eigenvalue(&matrix, (size_t)place, &lattice->cancel);
    free(band.rows);
    return isnan(square) ? NAN : bar_motion_frequency(sqrt(fmax(0, square)), lattice->dt);
}

/* --- v_cm(t) -------------------------------------------------------------------------------------- */

/* Between two fixed ends each sine is a mode of the lattice: share A mean(phi), frequency Omega(beta_n). */
static bool take_sines(BarMotion *motion, const BarTheory *bar, const PdBarTheory *lattice, int n)
{
    for (int k = 0; k < bar->n_modes; k++) {
        const int number = bar->modes[k].number;
        double sum = 0;
        for (int i = 0; i < n; i++)
            sum += bar_mode_shape(bar, number, (i + 0.5) * lattice->spacing);
        const double frequency = number < 1 ? 0 : pd_bar_frequency(bar, lattice, number);
        if (!isfinite(frequency))
            return false;
        bar_motion_set(motion, k, bar->modes[k].velocity * sum / n, frequency);
    }
    return true;
}

static void put_in_matrix(void *into, int row, int column, double value)
{
    *gsl_matrix_ptr(into, (size_t)row, (size_t)column) += value;
}

/* All modes of the lattice. False: no memory, or a mode is unstable. */
static bool take_vectors(BarMotion *motion, const BarTheory *bar, const PdBarTheory *lattice, int n)
{
    const size_t size = (size_t)n;
    gsl_errors_off();
    gsl_matrix *matrix = gsl_matrix_calloc(size, size);
    gsl_errors_on();
    double *start = malloc(2 * size * sizeof *start);
    bool sound = matrix && start && write_matrix(bar, lattice, n, put_in_matrix, matrix);
    for (int i = 0; sound && i < n; i++) {
        start[i] = bar_initial_velocity(bar, (i + 0.5) * lattice->spacing);
        start[n + i] = 1.0 / n; /* their share in the mean */
    }
    sound = sound && bar_motion_resolve(motion, matrix, start, start + n);
    free(start);
    gsl_matrix_free(matrix);
    return sound;
}

BarMotion *pd_bar_motion(const BarTheory *bar, const PdBarTheory *lattice)
{
    const int n = nodes_of(bar, lattice);
    const bool sines = bar->left_fixed && bar->right_fixed;
    if (bar->body_force != 0 || bar->traction != 0 || n < 1 || reach_of(lattice) > n ||
        (!sines && n > PD_BAR_MOTION_MAX))
        return NULL;
    BarMotion *motion = bar_motion_create(sines ? bar->n_modes : n, lattice->dt);
    if (!motion || (sines ? take_sines : take_vectors)(motion, bar, lattice, n))
        return motion;
    bar_motion_free(motion);
    return NULL;
}
