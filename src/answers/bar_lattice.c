/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Predictions of a bar's lattice (bar_lattice.h): the endless one in closed form; with its ends as
 * eigenvalues of its matrix, a band for one frequency and dense where all eigenvectors are needed for
 * v_cm(t). */
#include "answers/bar_lattice.h"

#include "base/assertion.h"
#include "theory/gsl_errors.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>

/* Shorter than two spacings: to the nodes it is a longer one. */
Dispersion bar_lattice_dispersion(const BeamDef *def, double wave_number)
{
    ASSERT_REAL(def->spacing, >, 0);
    Dispersion wave = {.space_only = NAN, .frequency = NAN, .decay = 0, .filter = 1};
    if (!(fabs(wave_number) * def->spacing <= M_PI * (1 + 1e-12)))
        return wave;
    wave.space_only = bonds_line_wave(def, wave_number);
    wave.frequency = bar_motion_frequency(wave.space_only, def->dt);
    wave.known = isfinite(wave.frequency);
    return wave;
}

static int nodes_of(const BeamDef *def)
{
    return (int)round(def->length / def->spacing);
}

/* Eigenvalues are found to eps times a bound on the largest, which is near that of the shortest wave: whether
 * that leaves 1e-8 of the one wanted. */
static bool is_resolved(const BarTheory *bar, const BeamDef *def, int number)
{
    enum { BOUND = 3 }; /* a bond at a free end may be stiffer */
    const double shortest = bonds_line_wave(def, M_PI / def->spacing), wanted = bar_frequency(bar, number);
    return DBL_EPSILON * BOUND * shortest * shortest <= 1e-8 * wanted * wanted;
}

/* Between two mirrors every sine is an eigenvector and the wave's closed form is the answer; else it is the
 * eigenvalue at its place in the spectrum, for a free end changes the bonds near it. */
double bar_lattice_frequency(const BarTheory *bar, const BeamDef *def, int number)
{
    const int n = nodes_of(def);
    if (number < 1 || number > n)
        return NAN;
    if (bar->left_fixed && bar->right_fixed)
        return bar_lattice_dispersion(def, bar_wave_number(bar, number)).frequency;
    /* the free-free bar has its rigid motion first */
    const int place = bar->left_fixed || bar->right_fixed ? number - 1 : number;
    if (place >= n || !is_resolved(bar, def, number))
        return NAN;
    const double square = bonds_line_eigenvalue(def, (size_t)place, NULL);
    return isnan(square) ? NAN : bar_motion_frequency(sqrt(fmax(0, square)), def->dt);
}

/* Between two fixed ends each sine is a mode of the lattice: share A mean(phi), frequency Omega(beta_n). */
static bool take_sines(BarMotion *motion, const BarTheory *bar, const BeamDef *def, int n)
{
    for (int k = 0; k < bar->n_modes; k++) {
        const int number = bar->modes[k].number;
        double sum = 0;
        for (int i = 0; i < n; i++)
            sum += bar_mode_shape(bar, number, (i + 0.5) * def->spacing);
        const double frequency = number < 1 ? 0 : bar_lattice_frequency(bar, def, number);
        if (!isfinite(frequency))
            return false;
        bar_motion_set(motion, k, bar->modes[k].velocity * sum / n, frequency);
    }
    return true;
}

static void put_in_matrix(void *into, size_t row, size_t column, double value)
{
    *gsl_matrix_ptr(into, row, column) += value;
}

/* All modes of the lattice. False: no memory, or a mode is unstable. */
static bool take_vectors(BarMotion *motion, const BarTheory *bar, const BeamDef *def, int n)
{
    const size_t size = (size_t)n;
    gsl_errors_off();
    gsl_matrix *matrix = gsl_matrix_calloc(size, size);
    gsl_errors_on();
    double *start = malloc(2 * size * sizeof *start);
    bool sound = matrix && start && bonds_line_matrix(def, put_in_matrix, matrix, NULL);
    for (int i = 0; sound && i < n; i++) {
        start[i] = bar_initial_velocity(bar, (i + 0.5) * def->spacing);
        start[n + i] = 1.0 / n; /* their share in the mean */
    }
    sound = sound && bar_motion_resolve(motion, matrix, start, start + n);
    free(start);
    gsl_matrix_free(matrix);
    return sound;
}

BarMotion *bar_lattice_motion(const BarTheory *bar, const BeamDef *def)
{
    const int n = nodes_of(def);
    const bool sines = bar->left_fixed && bar->right_fixed;
    if (bar->body_force != 0 || bar->traction != 0 || n < 1 || (!sines && n > BAR_LATTICE_MOTION_MAX))
        return NULL;
    BarMotion *motion = bar_motion_create(sines ? bar->n_modes : n, def->dt);
    if (!motion || (sines ? take_sines : take_vectors)(motion, bar, def, n))
        return motion;
    bar_motion_free(motion);
    return NULL;
}
