/* The mode of a step that a sampled mode belongs to (step_spectrum.h).
 *
 * The step on (v, f), nodal velocities before it and nodal forces -sum N' stress V, as a pencil
 * (C - mu B) x = 0 of its eigenvalues lambda = 1 + mu:
 *
 *     USF   mu (v - dt W f) = G v + dt W f     mu f = -dt K v
 *     USL   mu v            = G v + dt W f     mu f = -dt K v - dt^2 K T f
 *     MUSL  mu v            = G v + dt W f     mu (f + dt K v) = -dt K v
 *     T = M_l^-1,  W = T M T,  G = (1 - alpha)(T M - 1),  M: the consistent mass
 *
 * In USF the new force acts, in MUSL the new velocity strains: written so, nothing is wider than the band of
 * M and K. With v and f of a node side by side it is a band of half-width 2 reach + 1 and is solved as such:
 * inverse iteration (C - sigma B) y = B x from the endless mesh's eigenvalue and the sampled mode, each time
 * with a better sigma. Where this ends in a vector that is but a part of the sampled mode, all of them are
 * looked at if the bar is short. lambda - 1 is what is looked for because small steps have lambda near 1. */
#include "theory/step_spectrum.h"
#include "theory/bar_rest.h"
#include "theory/quiet.h"

#include <complex.h>
#include <gsl/gsl_eigen.h>
#include <gsl/gsl_errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CELLS_MOST = 2000, CELLS_MOST_HELD_CUBIC = 20000, CELLS_MOST_DENSE = 64, SOLVES_MOST = 40 };

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

/* Gauss' elimination with row pivots, in place; x: right-hand side in, solution out. */
static void solve(ComplexBand *band, double complex *x)
{
    const int n = band->size, width = band->width;
    for (int k = 0; k < n; k++) {
        const int rows_end = least(n, k + width + 1), columns_end = least(n, k + 2 * width + 1);
        int pivot = k;
        for (int i = k + 1; i < rows_end; i++)
            if (cabs(*entry(band, i, k)) > cabs(*entry(band, pivot, k)))
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
            const double complex factor = *entry(band, i, k) / *entry(band, k, k);
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
        x[k] /= *entry(band, k, k);
    }
}

/* --- the step ------------------------------------------------------------------------------------- */

typedef struct Step {
    BarRest rest;
    double courant, alpha;
    double usf, usl, musl; /* 1 for the algorithm at hand */
} Step;

/* What node j has to do with node i, dt included: dt W, dt K, and G without alpha. */
typedef struct Coupling {
    double w, k, g;
} Coupling;

static double symmetric(const BarRest *rest, const double *band, int i, int j)
{
    return i > j ? band[i * (rest->reach + 1) + i - j] : band[j * (rest->reach + 1) + j - i];
}

/* The entry (i, j) of the pencil in units of dx/c: W_ij = M_ij/(m_i m_j), K_ij, and T M - 1; what alpha, USF,
 * USL and MUSL make of it is in write_pencil(). */
static Coupling coupling(const Step *step, int i, int j)
{
    const BarRest *rest = &step->rest;
    const double back = symmetric(rest, rest->consistent, i, j) / rest->mass[i];
    return (Coupling){.w = step->courant * back / rest->mass[j],
                      .k = step->courant * symmetric(rest, rest->stiffness, i, j),
                      .g = back - (i == j ? 1 : 0)};
}

/* The nodes in node i's band: first_of to before end_of. */
static int first_of(const BarRest *rest, int i)
{
    return i < rest->reach ? 0 : i - rest->reach;
}

static int end_of(const BarRest *rest, int i)
{
    return least(rest->nodes, i + rest->reach + 1);
}

/* C - mu B */
static void write_pencil(const Step *step, double complex mu, ComplexBand *band)
{
    const BarRest *rest = &step->rest;
    memset(band->rows, 0, (size_t)band->size * (size_t)(3 * band->width + 1) * sizeof *band->rows);
    for (int i = 0; i < rest->nodes; i++)
        for (int j = first_of(rest, i); j < end_of(rest, i); j++) {
            const Coupling c = coupling(step, i, j);
            const double complex own = i == j ? mu : 0;
            *entry(band, 2 * i, 2 * j) = (1 - step->alpha) * c.g - own;
            *entry(band, 2 * i, 2 * j + 1) = c.w * (1 + mu * step->usf);
            *entry(band, 2 * i + 1, 2 * j) = -c.k * (1 + mu * step->musl);
            *entry(band, 2 * i + 1, 2 * j + 1) = -c.k * step->courant / rest->mass[j] * step->usl - own;
        }
}

/* B x */
static void weigh(const Step *step, const double complex *x, double complex *out)
{
    const BarRest *rest = &step->rest;
    for (int i = 0; i < rest->nodes; i++) {
        out[2 * i] = x[2 * i], out[2 * i + 1] = x[2 * i + 1];
        for (int j = first_of(rest, i); j < end_of(rest, i); j++) {
            const Coupling c = coupling(step, i, j);
            out[2 * i] -= step->usf * c.w * x[2 * j + 1];
            out[2 * i + 1] += step->musl * c.k * x[2 * j];
        }
    }
}

/* The sampled mode with the forces that an eigenvector with this velocity would have: mu f = -dt K v. */
static void begin(const Step *step, const double *sampled, double complex mu, double complex *x)
{
    const BarRest *rest = &step->rest;
    for (int i = 0; i < rest->nodes; i++) {
        double pull = 0;
        for (int j = first_of(rest, i); j < end_of(rest, i); j++)
            pull += coupling(step, i, j).k * sampled[j];
        x[2 * i] = sampled[i];
        x[2 * i + 1] = -pull / mu;
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
        if (!isfinite(cabs(change)))
            return false;
        memcpy(x, y, (size_t)n * sizeof *x);
        normalise(x, n);
        const bool settled = error <= 1e-18;
        /* the first solve turns what it is given into the nearest vector, more or less */
        if (turn > 0 || settled)
            *mu += change;
        if (settled)
            return true;
    }
    return false;
}

/* |(x, s)| / (|x| |s|) with (a, b) = sum m_i conj(a_i) b_i over the nodes' velocities: 1 where the
 * eigenvector is the sampled mode s itself, 0 where it has nothing of it. Squared, it is the share of the
 * sampled mode's kinetic energy if the eigenvectors were orthogonal, which they nearly are. */
static double overlap(const BarRest *rest, const double complex *x, const double *sampled)
{
    double complex both = 0;
    double own = 0, of_sample = 0;
    for (int i = 0; i < rest->nodes; i++) {
        both += rest->mass[i] * conj(x[2 * i]) * sampled[i];
        own += rest->mass[i] * creal(x[2 * i] * conj(x[2 * i]));
        of_sample += rest->mass[i] * sampled[i] * sampled[i];
    }
    return cabs(both) / sqrt(own * of_sample);
}

/* With FLIP, USF and MUSL, v is a real shape u times a number, and with r = K u, a = T r
 *
 *     omega^2 = sum m (N a)^2 / sum V (N' u)^2 = (a, M_c a) / (u, K u)
 *
 * keeps more digits: its error is the square of the shape's. */
static double space_frequency(const BarRest *rest, const double complex *x, double *a)
{
    double complex largest = 0;
    for (int i = 0; i < rest->nodes; i++)
        if (cabs(x[2 * i]) > cabs(largest))
            largest = x[2 * i];
    double above = 0, below = 0;
    for (int i = 0; i < rest->nodes; i++) {
        double pull = 0;
        for (int j = first_of(rest, i); j < end_of(rest, i); j++)
            pull += symmetric(rest, rest->stiffness, i, j) * creal(x[2 * j] / largest);
        a[i] = pull / rest->mass[i];
        below += pull * creal(x[2 * i] / largest);
    }
    for (int i = 0; i < rest->nodes; i++)
        for (int j = first_of(rest, i); j < end_of(rest, i); j++)
            above += a[i] * symmetric(rest, rest->consistent, i, j) * a[j];
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
    mode.overlap = overlap(&step->rest, search->x, search->sampled);
    mode.frequency = fabs(carg(1 + mu)) / step->courant * search->rate;
    mode.decay = -log1p(2 * creal(mu) + creal(mu * conj(mu))) / (2 * step->courant) * search->rate;
    if (step->alpha == 1 && step->usl == 0) {
        const double omega = space_frequency(&step->rest, search->x, search->scrap);
        const double half = omega * step->courant / 2;
        if (half <= 1) {
            mode.frequency = 2 * asin(half) / step->courant * search->rate;
            mode.decay = 0;
        }
    }
    return mode;
}

/* Of a short bar all eigenvectors of the map 1 + B^-1 C at once, to see which one the sampled mode overlaps
 * most: leaves it and its eigenvalue in x and mu. False: not enough memory. */
static bool choose_among_all(Search *search, double complex *mu)
{
    const BarRest *rest = &search->step.rest;
    const size_t n = (size_t)search->band.size;
    gsl_matrix *map = gsl_matrix_calloc(n, n);
    gsl_matrix_complex *vectors = gsl_matrix_complex_alloc(n, n);
    gsl_vector_complex *values = gsl_vector_complex_alloc(n);
    gsl_eigen_nonsymmv_workspace *work = gsl_eigen_nonsymmv_alloc(n);
    bool good = map && vectors && values && work;
    if (good) {
        write_pencil(&search->step, 0, &search->band);
        for (int i = 0; i < search->band.size; i++)
            for (int j = 0; j < search->band.size; j++)
                if (abs(i - j) <= search->band.width)
                    gsl_matrix_set(map, (size_t)i, (size_t)j, creal(*entry(&search->band, i, j)));
        /* B differs from 1 in the rows of v, or of f, alone: so B^-1 adds rows of the others to them */
        for (int i = 0; i < rest->nodes; i++)
            for (int j = first_of(rest, i); j < end_of(rest, i); j++) {
                const Coupling c = coupling(&search->step, i, j);
                for (size_t k = 0; k < n; k++) {
                    double *v = gsl_matrix_ptr(map, 2 * (size_t)i, k),
                           *f = gsl_matrix_ptr(map, 2 * (size_t)i + 1, k);
                    *v += search->step.usf * c.w * gsl_matrix_get(map, 2 * (size_t)j + 1, k);
                    *f -= search->step.musl * c.k * gsl_matrix_get(map, 2 * (size_t)j, k);
                }
            }
        good = gsl_eigen_nonsymmv(map, values, vectors, work) == GSL_SUCCESS;
    }
    double best = 0;
    for (size_t k = 0; good && k < n; k++) {
        const gsl_complex value = gsl_vector_complex_get(values, k);
        if (GSL_IMAG(value) < 0)
            continue; /* the mirror of another */
        for (size_t i = 0; i < n; i++) {
            const gsl_complex number = gsl_matrix_complex_get(vectors, i, k);
            search->y[i] = GSL_REAL(number) + I * GSL_IMAG(number);
        }
        const double now = overlap(rest, search->y, search->sampled);
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

/* By inverse iteration from the wave's eigenvalue; of a short bar, where that ends in a vector that has
 * little of the sampled mode, from the best among all. known is false where neither converges. */
static StepMode find_mode(Search *search, int number, double complex mu)
{
    StepMode mode = {.frequency = NAN, .decay = NAN, .overlap = NAN, .with_ends = true};
    bar_rest_sample(&search->step.rest, search->bar, number, search->sampled);
    begin(&search->step, search->sampled, mu, search->x);
    if (iterate(&search->step, &search->band, &mu, search->x, search->y))
        mode = read_mode(search, mu);
    if (mode.known && (mode.overlap >= nearly_pure || search->step.rest.cells > CELLS_MOST_DENSE))
        return mode;
    quiet_begin();
    if (search->step.rest.cells <= CELLS_MOST_DENSE && choose_among_all(search, &mu) &&
        iterate(&search->step, &search->band, &mu, search->x, search->y))
        mode = read_mode(search, mu);
    quiet_end();
    return mode;
}

StepMode step_mode(const BarTheory *bar, const BarMesh *mesh, int number)
{
    const double wave_number = bar_wave_number(bar, number);
    const Dispersion wave = dispersion_of_bar(bar, mesh, wave_number);
    StepMode mode = {.known = wave.known, .frequency = wave.frequency, .decay = wave.decay, .overlap = 1};
    const double cells = round(bar->length / mesh->cell_size);
    const bool held_cubic = mesh->shape == MESH_BSPLINE3 && (bar->left_fixed || bar->right_fixed);
    if (!wave.known || wave_number == 0 || cells > (held_cubic ? CELLS_MOST_HELD_CUBIC : CELLS_MOST))
        return mode;

    mode.known = false;
    Search search = {.bar = bar, .mesh = mesh, .rate = bar_wave_speed(bar) / mesh->cell_size};
    search.step = (Step){.courant = mesh->dt * search.rate,
                         .alpha = bar_mesh_flip(mesh),
                         .usf = mesh->algorithm == MESH_USF,
                         .usl = mesh->algorithm == MESH_USL,
                         .musl = mesh->algorithm == MESH_MUSL};
    BarRest *rest = &search.step.rest;
    if (bar_rest_make(rest, bar, mesh, (int)cells)) {
        const size_t n = 2 * (size_t)rest->nodes;
        ComplexBand *band = &search.band;
        *band = (ComplexBand){.size = (int)n, .width = 2 * rest->reach + 1};
        band->rows = malloc(n * (size_t)(3 * band->width + 1) * sizeof *band->rows);
        search.x = malloc(2 * n * sizeof *search.x);
        search.sampled = malloc(n * sizeof *search.sampled);
        if (band->rows && search.x && search.sampled) {
            search.y = search.x + n;
            search.scrap = search.sampled + n / 2;
            mode = find_mode(&search, number, cexp((I * wave.frequency - wave.decay) * mesh->dt) - 1);
        }
        free(search.sampled);
        free(search.x);
        free(band->rows);
    }
    bar_rest_free(rest);
    return mode;
}
