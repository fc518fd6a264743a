/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The mode of a step that a sampled mode belongs to (step_spectrum.h).
 *
 * The step as a pencil (C - mu B) x = 0 of its eigenvalues lambda = 1 + mu. With nodal velocities v before it
 * and the accelerations a of the nodal forces before it, M a = f,
 *
 *     USF   mu (M v - dt M_c a) = (1 - alpha)(M_c - M) v + dt M_c a     mu M a = -dt K v
 *     USL   mu M v              = (1 - alpha)(M_c - M) v + dt M_c a     mu M a = -dt K v - dt^2 K a
 *     MUSL  mu M v              = (1 - alpha)(M_c - M) v + dt M_c a     mu (M a + dt K v) = -dt K v
 *
 * In USF the new force acts, in MUSL the new velocity strains: written so, no inverse is in it, and nothing
 * is wider than the band of M_c and K. FMPM's nodal velocities are T p with T = M_l^-1 sum E^j, j = 0 .. k -
 * 1, E = 1 - M_c M_l^-1. With p and f instead of v and a its step is the same, for
 *
 *     1 in place of M      M_c T = 1 - E^k in place of M_c      K T in place of K      alpha = 0
 *
 * and the bands are k times as wide. With both numbers of a node side by side the pencil is a band of
 * half-width 2 reach + 1 and is solved as such: inverse iteration (C - sigma B) y = B x from the endless
 * mesh's eigenvalue and the sampled mode, each time with a better sigma. Where this ends in a vector that is
 * but a part of the sampled mode, all of them are looked at if the bar is short. lambda - 1 is what is looked
 * for because small steps have lambda near 1. */
#include "theory/step_spectrum.h"

#include "base/shortage.h"
#include "base/assertion.h"
#include "base/math/functions.h"
#include "theory/bar_modes.h"
#include "theory/bar_rest.h"
#include "theory/quiet.h"

#include <complex.h>
#include <errno.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    CELLS_MOST = 2000,
    CELLS_MOST_LONG = 20000,
    CELLS_MOST_DENSE = 64,
    SOLVES_MOST = 40,
    WORK_MOST = 1000000
};

/* With this overlap no other eigenvector can be closer to the sampled mode. */
static const double nearly_pure = 0.99;

/* --- a complex band and its solution ---------------------------------------------------------------- */

/* Row i holds columns i - width to i + 2 width: rows change places, which widens the band to the right. */
typedef struct ComplexBand {
    int size, width;
    double complex *rows;
} ComplexBand;

static double complex *entry(const ComplexBand *band, int row, int column)
{
    return &band->rows[(size_t)row * (size_t)(3 * band->width + 1) + (size_t)(column - row + band->width)];
}

static int least(int a, int b)
{
    return a < b ? a : b;
}

/* The C library's cabs and the compiler's division of complex numbers differ from machine to machine. */
static double size_of(double complex a)
{
    return math_hypot(creal(a), cimag(a));
}

/* a/b = a b* / |b|^2 */
static double complex quotient(double complex a, double complex b)
{
    const double square = creal(b) * creal(b) + cimag(b) * cimag(b);
    return (creal(a) * creal(b) + cimag(a) * cimag(b)) / square +
           I * ((cimag(a) * creal(b) - creal(a) * cimag(b)) / square);
}

/* Gauss' elimination with row pivots, in place; x: right-hand side in, solution out. */
static void solve(ComplexBand *band, double complex *x)
{
    const int n = band->size, width = band->width;
    for (int k = 0; k < n; k++) {
        const int rows_end = least(n, k + width + 1), columns_end = least(n, k + 2 * width + 1);
        int pivot = k;
        for (int i = k + 1; i < rows_end; i++)
            if (size_of(*entry(band, i, k)) > size_of(*entry(band, pivot, k)))
                pivot = i;
        if (pivot != k) {
            for (int j = k; j < columns_end; j++) {
                const double complex kept = *entry(band, k, j);
                *entry(band, k, j) = *entry(band, pivot, j);
                *entry(band, pivot, j) = kept;
            }
            const double complex kept = x[k];
            x[k] = x[pivot], x[pivot] = kept;
        }
        /* sigma may be an eigenvalue to the last bit: the solution is then the eigenvector all the same */
        if (*entry(band, k, k) == 0)
            *entry(band, k, k) = 1e-300;
        for (int i = k + 1; i < rows_end; i++) {
            const double complex factor = quotient(*entry(band, i, k), *entry(band, k, k));
            if (factor == 0)
                continue;
            for (int j = k + 1; j < columns_end; j++)
                *entry(band, i, j) -= factor * *entry(band, k, j);
            x[i] -= factor * x[k];
        }
    }
    for (int k = n - 1; k >= 0; k--) {
        for (int j = k + 1; j < least(n, k + 2 * width + 1); j++)
            x[k] -= *entry(band, k, j) * x[j];
        x[k] = quotient(x[k], *entry(band, k, k));
    }
}

/* --- bands of real numbers -------------------------------------------------------------------------- */

/* Row i holds columns i - reach to i + reach; those that there are not are 0. */
typedef struct RealBand {
    int size, reach;
    double *at;
} RealBand;

static bool make_band(RealBand *band, int size, int reach)
{
    *band = (RealBand){size, reach, calloc((size_t)size * (size_t)(2 * reach + 1), sizeof(double))};
    return band->at != NULL;
}

static double *in_band(const RealBand *band, int i, int j)
{
    return &band->at[(size_t)i * (size_t)(2 * band->reach + 1) + (size_t)(j - i + band->reach)];
}

static double value(const RealBand *band, int i, int j)
{
    return abs(i - j) <= band->reach ? *in_band(band, i, j) : 0;
}

/* The columns in row i: first_of to before end_of. */
static int first_of(const RealBand *band, int i)
{
    return i < band->reach ? 0 : i - band->reach;
}

static int end_of(const RealBand *band, int i)
{
    return least(band->size, i + band->reach + 1);
}

/* out = a b; out reaches as far as both together. */
static void multiply(const RealBand *a, const RealBand *b, RealBand *out)
{
    memset(out->at, 0, (size_t)out->size * (size_t)(2 * out->reach + 1) * sizeof *out->at);
    for (int i = 0; i < a->size; i++)
        for (int k = first_of(a, i); k < end_of(a, i); k++)
            for (int j = first_of(b, k); j < end_of(b, k); j++)
                if (abs(i - j) <= out->reach)
                    *in_band(out, i, j) += *in_band(a, i, k) * *in_band(b, k, j);
}

/* --- the step ------------------------------------------------------------------------------------- */

/* `mass`, `consistent` and `stiffness` are M, M_c and K, or what is in their places. */
typedef struct Step {
    BarRest rest;
    RealBand mass, consistent, stiffness;
    double courant, alpha;
    double usf, usl, musl; /* 1 for the algorithm at hand */
    bool of_momenta;       /* unknowns are p and f, not v and a */
    Cancel cancel;
} Step;

static double symmetric(const BarRest *rest, const double *band, int i, int j)
{
    return i > j ? band[i * (rest->reach + 1) + i - j] : band[j * (rest->reach + 1) + j - i];
}

/* The matrices of a mass blend (lumped masses: a share of 0). False: not enough memory. */
static bool make_blended(Step *step, double share)
{
    const BarRest *rest = &step->rest;
    const int n = rest->nodes, reach = rest->reach;
    if (!make_band(&step->mass, n, reach) || !make_band(&step->consistent, n, reach) ||
        !make_band(&step->stiffness, n, reach))
        return false;
    for (int i = 0; i < n; i++)
        for (int j = first_of(&step->mass, i); j < end_of(&step->mass, i); j++) {
            const double consistent = symmetric(rest, rest->consistent, i, j);
            *in_band(&step->consistent, i, j) = consistent;
            *in_band(&step->stiffness, i, j) = symmetric(rest, rest->stiffness, i, j);
            *in_band(&step->mass, i, j) = share * consistent + (i == j ? (1 - share) * rest->mass[i] : 0);
        }
    return true;
}

/* 1, 1 - E^k and K M_l^-1 sum E^j in the places of the matrices of lumped masses. */
static bool make_series(Step *step, int order)
{
    const BarRest *rest = &step->rest;
    const int n = rest->nodes, reach = rest->reach, wide = order * reach;
    RealBand error = {0}, power = {0}, next = {0}, sum = {0}, whole = {0}, one = {0};
    bool good = make_band(&error, n, reach) && make_band(&power, n, wide) && make_band(&next, n, wide) &&
                make_band(&sum, n, wide) && make_band(&whole, n, wide) && make_band(&one, n, wide);
    for (int i = 0; good && i < n; i++) {
        for (int j = first_of(&error, i); j < end_of(&error, i); j++)
            *in_band(&error, i, j) =
                (i == j ? 1 : 0) - symmetric(rest, rest->consistent, i, j) / rest->mass[j];
        *in_band(&power, i, i) = *in_band(&one, i, i) = 1;
    }
    for (int k = 0; good && k < order; k++) {
        for (size_t at = 0; at < (size_t)n * (size_t)(2 * wide + 1); at++)
            sum.at[at] += power.at[at];
        multiply(&power, &error, &next);
        const RealBand kept = power;
        power = next, next = kept;
    }
    for (int i = 0; good && i < n; i++)
        for (int j = first_of(&sum, i); j < end_of(&sum, i); j++) {
            *in_band(&sum, i, j) /= rest->mass[i];
            *in_band(&power, i, j) = (i == j ? 1 : 0) - *in_band(&power, i, j);
        }
    if (good)
        multiply(&step->stiffness, &sum, &whole);
    free(error.at);
    free(next.at);
    free(sum.at);
    free(step->mass.at);
    free(step->consistent.at);
    free(step->stiffness.at);
    step->mass = one, step->consistent = power, step->stiffness = whole;
    return good;
}

static bool make_step(Step *step, const BarTheory *bar, const BarMesh *mesh, int cells)
{
    return bar_rest_make(&step->rest, bar, mesh, cells) && make_blended(step, mesh->consistent) &&
           (mesh->fmpm_order == 0 || make_series(step, mesh->fmpm_order));
}

static void free_step(Step *step)
{
    bar_rest_free(&step->rest);
    free(step->mass.at);
    free(step->consistent.at);
    free(step->stiffness.at);
}

/* What node j has to do with node i in C and in B: rows of both numbers of i, columns of both of j. */
typedef struct Coupling {
    double c[2][2], b[2][2];
} Coupling;

static Coupling coupling(const Step *step, int i, int j)
{
    const double dt = step->courant, mass = value(&step->mass, i, j);
    const double back = dt * value(&step->consistent, i, j), pull = dt * value(&step->stiffness, i, j);
    const double kept = value(&step->consistent, i, j) - mass;
    return (Coupling){.c = {{(1 - step->alpha) * kept, back}, {-pull, -step->usl * dt * pull}},
                      .b = {{mass, -step->usf * back}, {step->musl * pull, mass}}};
}

/* C - mu B */
static void write_pencil(const Step *step, double complex mu, ComplexBand *band)
{
    memset(band->rows, 0, (size_t)band->size * (size_t)(3 * band->width + 1) * sizeof *band->rows);
    for (int i = 0; i < step->rest.nodes; i++)
        for (int j = first_of(&step->stiffness, i); j < end_of(&step->stiffness, i); j++) {
            const Coupling of = coupling(step, i, j);
            for (int row = 0; row < 2; row++)
                for (int column = 0; column < 2; column++)
                    *entry(band, 2 * i + row, 2 * j + column) = of.c[row][column] - mu * of.b[row][column];
        }
}

/* B x */
static void weigh(const Step *step, const double complex *x, double complex *out)
{
    for (int i = 0; i < step->rest.nodes; i++) {
        out[2 * i] = out[2 * i + 1] = 0;
        for (int j = first_of(&step->stiffness, i); j < end_of(&step->stiffness, i); j++) {
            const Coupling of = coupling(step, i, j);
            for (int row = 0; row < 2; row++)
                out[2 * i + row] += of.b[row][0] * x[2 * j] + of.b[row][1] * x[2 * j + 1];
        }
    }
}

/* The sampled mode with the accelerations that an eigenvector with this velocity would have, more or less:
 * mu M a = -dt K v with the sum of M's row for it. */
static void begin(const Step *step, const double *sampled, double complex mu, double complex *x)
{
    for (int i = 0; i < step->rest.nodes; i++) {
        double pull = 0, mass = 0;
        for (int j = first_of(&step->stiffness, i); j < end_of(&step->stiffness, i); j++) {
            pull += step->courant * value(&step->stiffness, i, j) * sampled[j];
            mass += value(&step->mass, i, j);
        }
        x[2 * i] = sampled[i];
        x[2 * i + 1] = quotient(-pull, mu * mass);
    }
}

/* To length 1 in the plain product; the phase is left as it is. */
static void normalise(double complex *x, int n)
{
    double sum = 0;
    for (int i = 0; i < n; i++)
        sum += creal(x[i] * conj(x[i]));
    for (int i = 0; i < n; i++)
        x[i] /= sqrt(sum);
}

static bool go_on(const Step *step, double share)
{
    if (!cancel_requested(&step->cancel, share))
        return true;
    errno = ECANCELED;
    return false;
}

/* From near mu and x to the eigenvalue and its vector. False: it does not converge. */
static bool iterate(const Step *step, ComplexBand *band, double complex *mu, double complex *x,
                    double complex *y)
{
    const int n = band->size;
    /* a little beside an eigenvalue, two vectors that share it are enlarged alike and x stays their mixture
     */
    *mu *= 1 + 1e-4;
    normalise(x, n);
    for (int turn = 0; turn < SOLVES_MOST; turn++) {
        if (!go_on(step, (turn + 1.0) / SOLVES_MOST))
            return false;
        write_pencil(step, *mu, band);
        weigh(step, x, y);
        solve(band, y);
        /* of an eigenvector x = change y; else in the sense of least squares */
        double complex along = 0;
        double length = 0, error = 0;
        for (int i = 0; i < n; i++) {
            along += conj(y[i]) * x[i];
            length += creal(y[i] * conj(y[i]));
        }
        const double complex change = along / length;
        for (int i = 0; i < n; i++) {
            const double complex gap = x[i] - change * y[i];
            error += creal(gap * conj(gap));
        }
        if (!isfinite(size_of(change)))
            return false;
        memcpy(x, y, (size_t)n * sizeof *x);
        normalise(x, n);
        const bool settled = error <= 1e-18;
        /* the first solve turns what it is given into the nearest vector, more or less */
        if (turn > 0 || settled)
            *mu += change;
        if (settled)
            return go_on(step, 1);
    }
    return false;
}

/* |(x, s)| / (|x| |s|) with (a, b) = sum m_i conj(a_i) b_i over the nodes' velocities (of momenta 1/m_i): 1
 * where the eigenvector is the sampled mode s itself, 0 where it has nothing of it. Squared, it is the share
 * of the sampled mode's kinetic energy if the eigenvectors were orthogonal, which they nearly are. */
static double overlap(const Step *step, const double complex *x, const double *sampled)
{
    double complex both = 0;
    double own = 0, of_sample = 0;
    for (int i = 0; i < step->rest.nodes; i++) {
        const double weight = step->of_momenta ? 1 / step->rest.mass[i] : step->rest.mass[i];
        both += weight * conj(x[2 * i]) * sampled[i];
        own += weight * creal(x[2 * i] * conj(x[2 * i]));
        of_sample += weight * sampled[i] * sampled[i];
    }
    return size_of(both) / sqrt(own * of_sample);
}

/* With FLIP, USF and MUSL, v is a real shape u times a number, and with r = K u, a = M^-1 r
 *
 *     omega^2 = sum m (N a)^2 / sum V (N' u)^2 = (a, M_c a) / (u, K u)
 *
 * keeps more digits: its error is the square of the shape's. NAN: not enough memory. */
static double space_frequency(const Step *step, double share, const double complex *x, double *a)
{
    const int n = step->rest.nodes;
    double complex largest = 0;
    for (int i = 0; i < n; i++)
        if (size_of(x[2 * i]) > size_of(largest))
            largest = x[2 * i];
    double above = 0, below = 0;
    for (int i = 0; i < n; i++) {
        a[i] = 0;
        for (int j = first_of(&step->stiffness, i); j < end_of(&step->stiffness, i); j++)
            a[i] += *in_band(&step->stiffness, i, j) * creal(quotient(x[2 * j], largest));
        below += a[i] * creal(quotient(x[2 * i], largest));
    }
    if (!bar_rest_solve_mass(&step->rest, share, a))
        return NAN;
    for (int i = 0; i < n; i++)
        for (int j = first_of(&step->consistent, i); j < end_of(&step->consistent, i); j++)
            above += a[i] * *in_band(&step->consistent, i, j) * a[j];
    return sqrt(above / below);
}

/* What is at hand while modes are looked for. */
typedef struct Search {
    Step step;
    const BarTheory *bar;
    const BarMesh *mesh;
    double rate; /* c/dx */
    ComplexBand band;
    double complex *x, *y;   /* an eigenvector; room for the next */
    double *sampled, *scrap; /* the sampled mode */
} Search;

/* From lambda = 1 + mu to the caller's units: a step multiplies the vector by lambda, so
 *
 *     Omega = |arg lambda|/dt,   decay = -log|lambda|/dt,   |lambda|^2 = 1 + 2 Re mu + |mu|^2
 *
 * the last with log1p, for |lambda| - 1 is often below 1e-9. Where nothing decays space_frequency() has more
 * digits.
 */
static StepMode read_mode(const Search *search, double complex mu)
{
    const Step *step = &search->step;
    StepMode mode = {.known = true, .with_ends = true};
    mode.overlap = overlap(step, search->x, search->sampled);
    mode.frequency = fabs(math_atan2(cimag(mu), 1 + creal(mu))) / step->courant * search->rate;
    mode.decay = -math_log1p(2 * creal(mu) + creal(mu * conj(mu))) / (2 * step->courant) * search->rate;
    if (step->alpha == 1 && step->usl == 0) {
        const double omega = space_frequency(step, search->mesh->consistent, search->x, search->scrap);
        const double half = omega * step->courant / 2;
        if (half <= 1) {
            mode.frequency = 2 * math_asin(half) / step->courant * search->rate;
            mode.decay = 0;
        }
    }
    return mode;
}

/* B^-1 C, dense. False: not enough memory, or B is singular. */
static bool write_map(const Step *step, gsl_matrix *map)
{
    const size_t n = map->size1;
    gsl_matrix *weights = gsl_matrix_calloc(n, n);
    gsl_permutation *order = gsl_permutation_alloc(n);
    int sign;
    bool good = weights && order;
    for (int i = 0; good && i < step->rest.nodes; i++)
        for (int j = first_of(&step->stiffness, i); j < end_of(&step->stiffness, i); j++) {
            const Coupling of = coupling(step, i, j);
            for (int row = 0; row < 2; row++)
                for (int column = 0; column < 2; column++) {
                    const size_t at = (size_t)(2 * i + row), to = (size_t)(2 * j + column);
                    gsl_matrix_set(map, at, to, of.c[row][column]);
                    gsl_matrix_set(weights, at, to, of.b[row][column]);
                }
        }
    good = good && gsl_linalg_LU_decomp(weights, order, &sign) == GSL_SUCCESS;
    for (size_t k = 0; good && k < n; k++) {
        gsl_vector_view column = gsl_matrix_column(map, k);
        good = gsl_linalg_LU_svx(weights, order, &column.vector) == GSL_SUCCESS;
    }
    gsl_permutation_free(order);
    gsl_matrix_free(weights);
    return good;
}

/* Of a short bar all eigenvectors of the map 1 + B^-1 C at once, to see which one the sampled mode overlaps
 * most: leaves it and its eigenvalue in x and mu. False: not enough memory. */
static bool choose_among_all(Search *search, double complex *mu)
{
    const size_t n = (size_t)search->band.size;
    gsl_matrix *map = gsl_matrix_calloc(n, n);
    gsl_matrix_complex *vectors = gsl_matrix_complex_alloc(n, n);
    gsl_vector_complex *values = gsl_vector_complex_alloc(n);
    gsl_eigen_nonsymmv_workspace *work = gsl_eigen_nonsymmv_alloc(n);
    const bool good = map && vectors && values && work && write_map(&search->step, map) &&
                      gsl_eigen_nonsymmv(map, values, vectors, work) == GSL_SUCCESS;
    double best = 0;
    for (size_t k = 0; good && k < n; k++) {
        const gsl_complex value = gsl_vector_complex_get(values, k);
        if (GSL_IMAG(value) < 0)
            continue; /* the mirror of another */
        for (size_t i = 0; i < n; i++) {
            const gsl_complex number = gsl_matrix_complex_get(vectors, i, k);
            search->y[i] = GSL_REAL(number) + I * GSL_IMAG(number);
        }
        const double now = overlap(&search->step, search->y, search->sampled);
        if (now > best) {
            best = now;
            *mu = GSL_REAL(value) + I * GSL_IMAG(value);
            memcpy(search->x, search->y, n * sizeof *search->x);
        }
    }
    gsl_matrix_free(map);
    gsl_matrix_complex_free(vectors);
    gsl_vector_complex_free(values);
    gsl_eigen_nonsymmv_free(work);
    return good;
}

/* A shape as the step's unknowns: nodal velocities of M v = p, or momenta. False: not enough memory. */
static bool sample(Search *search, BarShape *shape, int number)
{
    const BarRest *rest = &search->step.rest;
    const double share = search->mesh->consistent;
    bar_rest_sample(rest, search->bar, shape, number, search->sampled);
    if (!search->step.of_momenta && share == 0)
        return true;
    for (int i = 0; i < rest->nodes; i++)
        search->sampled[i] *= rest->mass[i];
    return search->step.of_momenta || bar_rest_solve_mass(rest, share, search->sampled);
}

/* By inverse iteration from the wave's eigenvalue; of a short bar, where that ends in a vector that has
 * little of the sampled mode, from the best among all. known is false where neither converges. */
static StepMode find_mode(Search *search, int number, double complex mu)
{
    StepMode mode = {.frequency = NAN, .decay = NAN, .overlap = NAN, .with_ends = true};
    if (!sample(search, bar_mode_shape, number) || !go_on(&search->step, 0.5 / SOLVES_MOST))
        return mode;
    begin(&search->step, search->sampled, mu, search->x);
    const int before = shortage_begin();
    const bool found = iterate(&search->step, &search->band, &mu, search->x, search->y);
    const bool cancelled = errno == ECANCELED;
    shortage_end(before);
    if (cancelled)
        return mode;
    if (found)
        mode = read_mode(search, mu);
    if (mode.known && (mode.overlap >= nearly_pure || search->step.rest.cells > CELLS_MOST_DENSE))
        return mode;
    gsl_errors_off();
    if (search->step.rest.cells <= CELLS_MOST_DENSE && choose_among_all(search, &mu) &&
        iterate(&search->step, &search->band, &mu, search->x, search->y))
        mode = read_mode(search, mu);
    gsl_errors_on();
    return mode;
}

/* The same with the overlap of what the bar starts with. */
static StepMode find_start(Search *search, int number, double complex mu)
{
    StepMode mode = find_mode(search, number, mu);
    if (mode.known && search->bar->of_sines) {
        mode.known = sample(search, bar_start_shape, number);
        mode.overlap = overlap(&search->step, search->x, search->sampled);
    }
    return mode;
}

/* Of longer bars the endless mesh's answer will do (step_spectrum.h); of wide bands it has to, sooner. A
 * joint is not in it: then the mode is looked for as long as that can be waited for. */
static double cells_most(const BarTheory *bar, const BarMesh *mesh)
{
    const bool held_cubic = mesh->shape == MPM_BSPLINE3 && (bar->left_fixed || bar->right_fixed);
    const double width = 2 * bar_rest_degree(mesh->shape) * fmax(1, mesh->fmpm_order) + 1;
    return fmin(held_cubic || bar_is_layered(bar) ? CELLS_MOST_LONG : CELLS_MOST,
                WORK_MOST / (width * width));
}

/* Of two materials each turns its part of the wave faster or slower, and the mode as its energy is shared. */
static Dispersion wave_of_two(const BarTheory *bar, const BarMesh *mesh, int number)
{
    const BarMode mode = bar_modes_of_two(bar, bar_wave_number(bar, number) * bar->length);
    const double share = bar_modes_energy_beyond(bar, &mode);
    BarTheory beyond = *bar;
    beyond.youngs_modulus = bar->joint_modulus, beyond.density = bar->joint_density;
    const Dispersion one = dispersion_of_bar(bar, mesh, mode.part[0].wave_number);
    const Dispersion other = dispersion_of_bar(&beyond, mesh, mode.part[1].wave_number);
    return (Dispersion){.known = one.known && other.known,
                        .frequency = (1 - share) * one.frequency + share * other.frequency,
                        .decay = (1 - share) * one.decay + share * other.decay};
}

StepMode step_mode(const BarTheory *bar, const BarMesh *mesh, int number)
{
    ASSERT_INT(number, >=, 0);
    ASSERT_REAL(mesh->cell_size, >, 0);
    const Dispersion wave = bar_is_layered(bar) && number > 0
                                ? wave_of_two(bar, mesh, number)
                                : dispersion_of_bar(bar, mesh, bar_wave_number(bar, number));
    StepMode mode = {.known = wave.known, .frequency = wave.frequency, .decay = wave.decay, .overlap = 1};
    const double cells = round(bar->length / mesh->cell_size);
    const bool is_long = cells > cells_most(bar, mesh);
    mode.known = wave.known && !(is_long && bar_is_layered(bar));
    if (!mode.known || bar_wave_number(bar, number) == 0 || is_long)
        return mode;

    mode.known = false;
    Search search = {.bar = bar, .mesh = mesh, .rate = bar_wave_speed(bar) / mesh->cell_size};
    search.step = (Step){.courant = mesh->dt * search.rate,
                         .alpha = bar_mesh_flip(mesh),
                         .usf = mesh->algorithm == MPM_USF,
                         .usl = mesh->algorithm == MPM_USL,
                         .musl = mesh->algorithm == MPM_MUSL,
                         .of_momenta = mesh->fmpm_order > 0,
                         .cancel = mesh->cancel};
    if (make_step(&search.step, bar, mesh, (int)cells)) {
        const size_t n = 2 * (size_t)search.step.rest.nodes;
        ComplexBand *band = &search.band;
        *band = (ComplexBand){.size = (int)n, .width = 2 * search.step.stiffness.reach + 1};
        band->rows = malloc(n * (size_t)(3 * band->width + 1) * sizeof *band->rows);
        search.x = malloc(2 * n * sizeof *search.x);
        search.sampled = malloc(n * sizeof *search.sampled);
        if (band->rows && search.x && search.sampled) {
            search.y = search.x + n;
            search.scrap = search.sampled + n / 2;
            const double turn = wave.frequency * mesh->dt, kept = math_exp(-wave.decay * mesh->dt);
            mode = find_start(&search, number, kept * (math_cos(turn) + I * math_sin(turn)) - 1);
        }
        free(search.sampled);
        free(search.x);
        free(band->rows);
    }
    free_step(&search.step);
    return mode;
}
