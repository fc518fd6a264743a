/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The search of fit.h: runs of a simulation as the model of a least-squares fit by GSL.
 *
 *     chi^2(p) = sum_k f_k^2,  f_k(p) = s(t_k; p) - y_k              residuals, one run for each p
 *     d f_k/d p_i by central differences, two runs each
 *     cov(p) = chi^2/(n - m) (J^T J)^-1                              n data, m parameters
 *
 * The parameters are sought as multiples of their values at the start, so that a modulus of 1e11 and a
 * fraction of 1 weigh alike. A run must be smooth in them: a change of dt in mid-series, or a particle that
 * crosses a cell in one run and not in the other, leaves a step in chi^2 that the search may stop at. Runs go
 * one after the other; it is asked between blocks of steps whether to go on. */
#include "lab/answers/fit.h"

#include "base/text.h"
#include "lab/settings/parameters.h"
#include "theory/quiet.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCK = 256, ITERATIONS_MAX = 60 };

#define DIFFERENCE 1e-4 /* of a parameter, relative, for its derivative */
#define TOLERANCE  1e-8 /* relative change of the parameters at which the search has settled */

typedef struct Search {
    const FitTask *task;
    FitResult *result;
    double starts[FIT_KEYS_MAX];
    double *rows;  /* BLOCK of the series */
    double *model; /* of the run that is made */
    bool began;    /* a run has been made: what fails from here on is a step too far */
    bool interrupted;
    Status why; /* the last run could not be made */
} Search;

/* --- a run --------------------------------------------------------------------------------------- */

/* Fills in the model between one row and the next: times of data up to `time`. Returns the data behind. */
static size_t take(const Search *search, size_t done, double before, double before_value, double time,
                   double value)
{
    const FitTask *task = search->task;
    for (; done < task->count && task->times[done] <= time; done++) {
        const double share = time > before ? (task->times[done] - before) / (time - before) : 1;
        search->model[done] = before_value + share * (value - before_value);
    }
    return done;
}

/* Runs the simulation over all times of the data, block by block; s(t_k) linearly between two steps. False:
 * it failed on the way, or was given up. */
static bool follow(Search *search, Simulation *simulation, int column)
{
    const FitTask *task = search->task;
    const double margin = 1e-9 * simulation->dt; /* the last time may be rounded up */
    simulation_row(simulation, search->rows);
    double before = 0, value = search->rows[column];
    size_t done = take(search, 0, 0, value, 0, value);
    while (done < task->count) {
        long count = simulation_steps_a_question(simulation), got = 0;
        count = count < BLOCK ? count : BLOCK;
        if (!simulation_steps(simulation, count, search->rows, &got, &search->why))
            return false;
        for (long k = 0; k < got; k++) {
            const double time = (double)(simulation->step - got + k + 1) * simulation->dt;
            const double next = search->rows[k * simulation->n_series + column];
            done = take(search, done, before, value, time + margin, next);
            before = time;
            value = next;
        }
        if (!patience_lasts(&task->patience, 0)) {
            search->interrupted = true;
            return status_fail(&search->why, STATUS_FAILED, "interrupted");
        }
    }
    return true;
}

/* s(t_k; p) into search->model, `count` numbers. False: the settings are unsound, the run failed or was given
 * up. */
static bool run(Search *search, const Settings *settings)
{
    search->why = (Status){0};
    search->result->runs++;
    if (!settings_check(settings, &search->why))
        return false;
    Simulation *simulation = problem_simulate(settings, search->task->threads, &search->why);
    if (!simulation)
        return false;
    const int column = simulation_find_series(simulation, search->task->column);
    double *rows = column >= 0 ? malloc(BLOCK * (size_t)simulation->n_series * sizeof *rows) : NULL;
    search->rows = rows;
    bool sound = rows != NULL;
    if (column < 0)
        status_fail(&search->why, STATUS_USAGE, "%s: the method's series has no such column",
                    search->task->column);
    else if (!rows)
        status_fail(&search->why, STATUS_FAILED, "out of memory");
    sound = sound && follow(search, simulation, column);
    free(rows);
    simulation_destroy(simulation);
    return sound;
}

double fit_value(const Settings *settings, const char *key)
{
    const Parameter *parameter = parameter_find(key);
    return parameter ? settings_number(settings, parameter) : settings_row_number(settings, key);
}

bool fit_put(Settings *settings, const char *key, double value)
{
    const Parameter *parameter = parameter_find(key);
    char text[NUMBER_TEXT_MAX];
    if (!parameter) {
        snprintf(text, sizeof text, "%.17g", value);
        return settings_row_key_set(settings, key, text, NULL);
    }
    if (!settings_in_range(parameter, settings->problem, value))
        return false;
    settings_put(settings, parameter, value);
    return true;
}

/* Parameters are sought as multiples of what they are to begin with. */
static bool place(const Search *search, const gsl_vector *scaled, Settings *settings)
{
    *settings = *search->task->settings;
    for (int i = 0; i < search->task->n_keys; i++) {
        const double value = search->starts[i] * gsl_vector_get(scaled, (size_t)i);
        if (!fit_put(settings, search->task->keys[i], value))
            return false;
    }
    return true;
}

/* f_k = s(t_k; p) - y_k. Where no run can be made the residuals are huge, so that the search turns back. */
static int residuals(const gsl_vector *scaled, void *context, gsl_vector *out)
{
    Search *search = context;
    const FitTask *task = search->task;
    Settings settings;
    const bool sound = place(search, scaled, &settings) && run(search, &settings);
    if (search->interrupted || (!sound && !search->began))
        return GSL_EFAILED;
    search->began = true;
    for (size_t k = 0; k < task->count; k++)
        gsl_vector_set(out, k,
                       sound ? search->model[k] - task->values[k] : 1e3 * (1 + fabs(task->values[k])));
    return GSL_SUCCESS;
}

/* --- the search ---------------------------------------------------------------------------------- */

/* What is sought must be there, real, not 0 and named once, and there must be more data than parameters: else
 * s^2 = chi^2/(n - m) has no meaning. */
static bool find_parameters(Search *search, Status *status)
{
    const FitTask *task = search->task;
    if (task->count <= (size_t)task->n_keys)
        return status_fail(status, STATUS_USAGE, "%zu data are too few for %d parameters", task->count,
                           task->n_keys);
    for (int i = 0; i < task->n_keys; i++) {
        const char *key = task->keys[i];
        const Parameter *parameter = parameter_find(key);
        const RowColumn *of_row = row_key_column(key);
        if (of_row ? !isfinite(settings_row_number(task->settings, key))
                   : !parameter || !settings_have(task->settings, parameter))
            return status_fail(status, STATUS_USAGE, "%.80s: this run has no such parameter", key);
        if (of_row ? of_row->value == ROW_EDGE : parameter->type != PARAMETER_REAL)
            return status_fail(status, STATUS_USAGE, "%s: is no real number and cannot be fitted", key);
        for (int j = 0; j < i; j++)
            if (strcmp(task->keys[j], key) == 0)
                return status_fail(status, STATUS_USAGE, "%s: is named twice", key);
        search->starts[i] = fit_value(task->settings, key);
        if (search->starts[i] == 0)
            return status_fail(status, STATUS_USAGE,
                               "%s: is 0 at the start, so a relative change does nothing (give it a value)",
                               key);
    }
    return true;
}

/* sqrt(chi^2/n), in the unit of the data. */
static double rms(const gsl_vector *f)
{
    double sum = 0;
    for (size_t k = 0; k < f->size; k++)
        sum += gsl_vector_get(f, k) * gsl_vector_get(f, k);
    return sqrt(sum / (double)f->size);
}

/* cov(p) = s^2 (J^T J)^-1 with s^2 = chi^2/(n - m), s^2 standing for the unknown error of the data; the
 * interval is p +- t(.975, n - m) sqrt(cov_ii), Student's t. It is right as far as residuals are independent
 * and the model linear over the interval: where the model itself is wrong (a mesh too coarse) it is too
 * narrow. */
static void judge(const Search *search, gsl_multifit_nlinear_workspace *work, gsl_matrix *covariance)
{
    FitResult *result = search->result;
    const int m = search->task->n_keys;
    const double freedom = (double)search->task->count - m;
    const gsl_vector *f = gsl_multifit_nlinear_residual(work);
    result->rms = rms(f);
    const double variance = result->rms * result->rms * (double)f->size / freedom;
    gsl_multifit_nlinear_covar(gsl_multifit_nlinear_jac(work), 0, covariance);
    const double t = gsl_cdf_tdist_Pinv(0.975, freedom);
    for (int i = 0; i < m; i++) {
        const double own = gsl_matrix_get(covariance, (size_t)i, (size_t)i);
        result->values[i] =
            search->starts[i] * gsl_vector_get(gsl_multifit_nlinear_position(work), (size_t)i);
        result->half_widths[i] = fabs(search->starts[i]) * t * sqrt(variance * own);
        for (int j = 0; j < m; j++) {
            const double other = gsl_matrix_get(covariance, (size_t)j, (size_t)j);
            result->correlation[i][j] = gsl_matrix_get(covariance, (size_t)i, (size_t)j) / sqrt(own * other);
        }
    }
}

/* Levenberg and Marquardt by trust regions until p changes by less than TOLERANCE, then one more run at the
 * best p. */
static bool search_best(Search *search, gsl_multifit_nlinear_workspace *work, gsl_vector *start,
                        gsl_matrix *covariance, Status *status)
{
    const FitTask *task = search->task;
    FitResult *result = search->result;
    gsl_multifit_nlinear_fdf functions = {
        .f = residuals, .n = task->count, .p = (size_t)task->n_keys, .params = search};
    int info = 0;
    gsl_vector_set_all(start, 1);
    if (gsl_multifit_nlinear_init(start, &functions, work) != GSL_SUCCESS) {
        if (status)
            *status = search->why;
        return false;
    }
    result->rms_before = rms(gsl_multifit_nlinear_residual(work));
    const int outcome = gsl_multifit_nlinear_driver(ITERATIONS_MAX, TOLERANCE, 0, 0, NULL, NULL, &info, work);
    result->iterations = (int)gsl_multifit_nlinear_niter(work);
    if (search->interrupted) {
        if (status)
            *status = search->why;
        return false;
    }
    /* no step downhill is left to the last digit: that is a minimum too */
    if (outcome != GSL_SUCCESS && outcome != GSL_ENOPROG)
        return status_fail(status, STATUS_FAILED, "the fit does not settle after %d iterations (%s)",
                           result->iterations, gsl_strerror(outcome));
    judge(search, work, covariance);
    const Settings *begun = task->settings;
    result->settings = *begun;
    for (int i = 0; i < task->n_keys; i++)
        fit_put(&result->settings, task->keys[i], result->values[i]);
    if (run(search, &result->settings))
        return true;
    if (status)
        *status = search->why;
    return false;
}

/* Takes some 2 m + 1 runs in each iteration. */
bool fit_solve(const FitTask *task, FitResult *result, Status *status)
{
    *result = (FitResult){0};
    Search search = {.task = task, .result = result};
    if (!find_parameters(&search, status))
        return false;
    result->model = search.model = calloc(task->count, sizeof *search.model);
    gsl_multifit_nlinear_parameters options = gsl_multifit_nlinear_default_parameters();
    options.fdtype = GSL_MULTIFIT_NLINEAR_CTRDIFF;
    options.h_df = DIFFERENCE;
    quiet_begin();
    const size_t m = (size_t)task->n_keys;
    gsl_multifit_nlinear_workspace *work =
        gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &options, task->count, m);
    gsl_vector *start = gsl_vector_alloc(m);
    gsl_matrix *covariance = gsl_matrix_alloc(m, m);
    bool sound = search.model && work && start && covariance;
    if (!sound)
        status_fail(status, STATUS_FAILED, "not enough memory for a fit");
    sound = sound && search_best(&search, work, start, covariance, status);
    if (work)
        gsl_multifit_nlinear_free(work);
    if (start)
        gsl_vector_free(start);
    if (covariance)
        gsl_matrix_free(covariance);
    quiet_end();
    return sound;
}

void fit_free(FitResult *result)
{
    free(result->model);
    result->model = NULL;
}
