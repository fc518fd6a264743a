/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The search of fit_search.h: runs of a simulation as the model of a least-squares fit by GSL.
 *
 *     chi^2(p) = sum_k f_k^2,  f_k(p) = s(t_k; p) - y_k              residuals, one run for each p
 *     d f_k/d p_i by central differences, two runs each; at the end of its range by one within it
 *     cov(p) from J and the noise that f looks like                  theory/noise.h
 *
 * The parameters are sought as multiples of their values at the start, so that a modulus of 1e11 and a
 * fraction of 1 weigh alike. A run must be smooth in them: a particle that crosses a cell in one run and not
 * in the other leaves a step in chi^2 that the search may stop at. Runs go one after the other; it is asked
 * between blocks of steps whether to go on. */
#include "answers/fit_internal.h"
#include "scenario/settings.h"
#include "scenario/rows/rows.h"
#include "base/math/functions.h"
#include "base/text.h"
#include "scenario/parameters.h"
#include "theory/gsl_errors.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ITERATIONS_MAX = 60, SEARCHES_MAX = 3 };

#define DIFFERENCE 1e-4 /* of a parameter, relative, for its derivative */
#define TOLERANCE  1e-8 /* relative change of the parameters at which the search has settled */
#define ROUND_OFF  1e-6 /* residuals of so little of the data are none */
#define NOT_WHITE  0.05 /* the chance below which residuals are not called so */
#define NO_NOISE   1e-3
#define NO_FIT     0.5  /* the share of the data that is left */
#define SAME       1e-3 /* relative distance of two searches that end in one minimum */
#define NEAR       0.02 /* of a beginning and the minimum that a search from there ends in */

const char fit_not_covered[] =
    "Intervals cover noise in the data. They do not cover the error of mesh and time step, for which the\n"
    "values make up (fit again on a finer mesh), what the model lacks, or a minimum that was not found.";

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
    const bool sound = place(search, scaled, &settings) && fit_run_at_data(search, &settings);
    if (search->interrupted || (!sound && !search->began))
        return GSL_EFAILED;
    search->began = true;
    for (size_t k = 0; k < task->count; k++)
        gsl_vector_set(out, k,
                       sound ? search->model[k] - task->values[k] : 1e3 * (1 + fabs(task->values[k])));
    return GSL_SUCCESS;
}

/* A run beside where the search is: into `model`. */
static bool run_beside(Search *search, const gsl_vector *scaled, size_t key, double x)
{
    gsl_vector *beside = gsl_vector_alloc(scaled->size);
    Settings settings;
    bool sound = beside != NULL;
    if (sound) {
        gsl_vector_memcpy(beside, scaled);
        gsl_vector_set(beside, key, x);
        sound = place(search, beside, &settings) && fit_run_at_data(search, &settings);
        gsl_vector_free(beside);
    }
    return sound;
}

/* J: a parameter beside which there is no run leaves zeros. */
static int slopes(const gsl_vector *scaled, void *context, gsl_matrix *jacobian)
{
    Search *search = context;
    const size_t count = search->task->count;
    for (size_t i = 0; i < scaled->size; i++) {
        const double x = gsl_vector_get(scaled, i), half = 0.5 * DIFFERENCE * (x != 0 ? fabs(x) : 1);
        double at[2] = {x - half, x + half};
        int runs = 0;
        for (size_t k = 0; k < count; k++)
            gsl_matrix_set(jacobian, k, i, 0);
        for (int side = 0; side < 2; side++) {
            if (!run_beside(search, scaled, i, at[side])) {
                search->why_fixed = search->why;
                at[side] = x;
                if (search->interrupted)
                    return GSL_EFAILED;
                if (!run_beside(search, scaled, i, x)) {
                    runs = 0;
                    break;
                }
            } else {
                runs++;
            }
            for (size_t k = 0; k < count; k++)
                gsl_matrix_set(jacobian, k, i,
                               side == 0
                                   ? search->model[k]
                                   : (search->model[k] - gsl_matrix_get(jacobian, k, i)) / (at[1] - at[0]));
        }
        search->fixed[i] = runs == 0;
        for (size_t k = 0; k < count && runs == 0; k++)
            gsl_matrix_set(jacobian, k, i, 0);
    }
    return search->interrupted ? GSL_EFAILED : GSL_SUCCESS;
}

/* --- the search ---------------------------------------------------------------------------------- */

/* rms of the data about their mean, or of a datum that never changes. */
static double spread_of(const FitTask *task)
{
    double mean = 0, squares = 0;
    for (size_t k = 0; k < task->count; k++)
        mean += task->values[k] / (double)task->count;
    for (size_t k = 0; k < task->count; k++)
        squares += math_pow(task->values[k] - mean, 2) / (double)task->count;
    return squares > 0 ? sqrt(squares) : fabs(mean);
}

/* What is sought must be there, real, not 0 and named once, and there must be more data than parameters: else
 * s^2 = chi^2/(n - m) has no meaning. */
static bool find_parameters(Search *search, Status *status)
{
    const FitTask *task = search->task;
    if (task->count <= (size_t)task->n_keys)
        return status_refuse(status, "%zu data are too few for %d parameters", task->count, task->n_keys);
    if (spread_of(task) == 0)
        return status_refuse(status, "the data are all 0");
    for (int i = 0; i < task->n_keys; i++) {
        const char *key = task->keys[i];
        const Parameter *parameter = parameter_find(key);
        const RowColumn *of_row = row_key_column(key);
        if (of_row ? !isfinite(settings_row_number(task->settings, key))
                   : !parameter || !parameter_applies_to(task->settings, parameter))
            return status_refuse(status, "%.80s: this run has no such parameter", key);
        if (of_row ? of_row->value == ROW_EDGE : parameter->type != PARAMETER_REAL)
            return status_refuse(status, "%s: is not a real number and cannot be fitted", key);
        for (int j = 0; j < i; j++)
            if (strcmp(task->keys[j], key) == 0)
                return status_refuse(status, "%s: is named twice", key);
        search->starts[i] = fit_value(task->settings, key);
        if (search->starts[i] == 0)
            return status_refuse(
                status, "%s: is 0 at the start, so a relative change does nothing (give it a value)", key);
    }
    return true;
}

/* What the search has for its work. */
typedef struct Space {
    gsl_multifit_nlinear_workspace *work;
    gsl_vector *start;
    double *slopes, *left; /* J and f row by row */
} Space;

/* J has no column of zeros. */
static bool all_matter(const Search *search, const gsl_matrix *jacobian, Status *status)
{
    const FitTask *task = search->task;
    for (int i = 0; i < task->n_keys; i++) {
        size_t k = 0;
        while (k < task->count && gsl_matrix_get(jacobian, k, (size_t)i) == 0)
            k++;
        if (k == task->count)
            return search->fixed[i]
                       ? status_refuse(status, "%s: there is no run with a little more or less: %s",
                                       task->keys[i], search->why_fixed.text)
                       : status_refuse(status, "%s: changes nothing of %s in these data", task->keys[i],
                                       task->column);
    }
    return true;
}

/* Takes over where a search has ended, if it is the best so far. */
static bool judge(const Search *search, Space *space, Status *status)
{
    const FitTask *task = search->task;
    FitResult *result = search->result;
    const int m = task->n_keys;
    const gsl_matrix *jacobian = gsl_multifit_nlinear_jac(space->work);
    const gsl_vector *f = gsl_multifit_nlinear_residual(space->work);
    const gsl_vector *position = gsl_multifit_nlinear_position(space->work);
    double values[FIT_KEYS_MAX], squares = 0;
    for (int i = 0; i < m; i++)
        values[i] = search->starts[i] * gsl_vector_get(position, (size_t)i);
    for (size_t k = 0; k < task->count; k++) {
        space->left[k] = gsl_vector_get(f, k);
        squares += space->left[k] * space->left[k];
        for (int i = 0; i < m; i++)
            space->slopes[k * (size_t)m + (size_t)i] =
                gsl_matrix_get(jacobian, k, (size_t)i) / search->starts[i];
    }
    if (!all_matter(search, jacobian, status))
        return false;
    const double rms = sqrt(squares / (double)task->count);
    if (result->n_others < FIT_MINIMA_MAX) {
        memcpy(result->others[result->n_others].values, values, sizeof values);
        result->others[result->n_others++].rms = rms;
    }
    if (result->searches++ > 0 && rms >= result->rms)
        return true;
    memcpy(result->values, values, sizeof values);
    result->rms = rms;
    result->share = rms > 0 ? rms / spread_of(task) : 0;
    if (!noise_judge(task->times, space->left, space->slopes, task->count, m, &result->noise))
        return status_fail(status, "not enough memory for a fit");
    const Noise *noise = &result->noise;
    result->left = result->share < ROUND_OFF                              ? FIT_NOTHING
                   : noise->white >= NOT_WHITE || noise->correlation == 0 ? FIT_WHITE
                                                                          : FIT_LASTING;
    if (result->left != FIT_NOTHING && fmax(noise->chance, noise->white) < NO_NOISE)
        result->left = FIT_NO_NOISE;
    return true;
}

/* Levenberg and Marquardt by trust regions until p changes by less than TOLERANCE. */
static bool search_from(Search *search, const Beginning *from, Space *space, Status *status)
{
    gsl_multifit_nlinear_fdf functions = {.f = residuals,
                                          .df = slopes,
                                          .n = search->task->count,
                                          .p = (size_t)search->task->n_keys,
                                          .params = search};
    int info = 0;
    gsl_vector_set_all(space->start, 1);
    gsl_vector_set(space->start, (size_t)from->key, from->factor);
    int outcome = gsl_multifit_nlinear_init(space->start, &functions, space->work);
    if (outcome == GSL_SUCCESS && !all_matter(search, gsl_multifit_nlinear_jac(space->work), status))
        return false;
    if (outcome == GSL_SUCCESS)
        outcome =
            gsl_multifit_nlinear_driver(ITERATIONS_MAX, TOLERANCE, 0, 0, NULL, NULL, &info, space->work);
    const int iterations = (int)gsl_multifit_nlinear_niter(space->work);
    search->result->iterations += iterations;
    if (search->interrupted)
        return status_take(status, &search->why);
    /* no step downhill from where it began, to the last digit: that is a minimum too */
    if (outcome != GSL_SUCCESS && info != GSL_ENOPROG)
        return status_fail(status, "the fit does not settle after %d iterations (%s)", iterations,
                           gsl_strerror(outcome));
    return judge(search, space, status);
}

/* Whether a minimum is another than one at some values, and not the same to what is known of it. */
static bool is_another(const Search *search, const FitMinimum *minimum, const double *values)
{
    const FitResult *result = search->result;
    for (int i = 0; i < search->task->n_keys; i++)
        if (fabs(minimum->values[i] - values[i]) > result->noise.half_widths[i] + SAME * fabs(values[i]))
            return true;
    return false;
}

/* Leaves of all minima those that the data cannot distinguish from the best:
 *
 *     chi^2 - chi_0^2 <= 3.84 chi_0^2/(n - m) (1 + r)/(1 - r)      95 % of chi^2 with one degree of freedom
 */
static void part_minima(Search *search)
{
    const FitTask *task = search->task;
    FitResult *result = search->result;
    const double r = result->noise.correlation;
    const double more = 3.84 / (double)(task->count - (size_t)task->n_keys) * (1 + r) / (1 - r);
    const double most =
        result->left == FIT_NOTHING ? ROUND_OFF * spread_of(task) : result->rms * sqrt(1 + more);
    int kept = 0;
    for (int i = 0; i < result->n_others; i++) {
        const FitMinimum minimum = result->others[i];
        bool another = minimum.rms <= most && is_another(search, &minimum, result->values);
        for (int j = 0; j < kept && another; j++)
            another = is_another(search, &minimum, result->others[j].values);
        if (another)
            result->others[kept++] = minimum;
    }
    result->n_others = kept;
}

/* From one beginning after the other, until what is left looks like noise, and from each alias of what the
 * data oscillate with; one more run at the best p. */
static bool search_best(Search *search, Space *space, Status *status)
{
    const FitTask *task = search->task;
    FitResult *result = search->result;
    Beginning list[BEGINNINGS_MAX];
    Status why = {0};
    result->beginnings = fit_beginnings(search, list);
    if (result->beginnings == 0)
        return status_take(status, &search->why);
    for (int i = 0; i < result->beginnings && isfinite(list[i].chi2) && !search->interrupted; i++) {
        const bool settled = result->searches > 0 && (i >= SEARCHES_MAX || result->left != FIT_NO_NOISE);
        const double value = list[i].factor * search->starts[list[i].key];
        bool searched = false; /* a search has ended near, where another one would end too */
        for (int k = 0; k < result->n_others; k++)
            searched |= fabs(result->others[k].values[list[i].key] - value) < NEAR * fabs(value);
        if ((!settled && i < SEARCHES_MAX) || (list[i].alias && !searched))
            search_from(search, &list[i], space, result->searches > 0 ? NULL : &why);
    }
    if (search->interrupted || result->searches == 0) {
        if (!search->interrupted && why.code == STATUS_DONE)
            return status_refuse(status,
                                 "the data are so far from any run that least squares have no number");
        return status_take(status, search->interrupted ? &search->why : &why);
    }
    part_minima(search);
    result->settings = *task->settings;
    for (int i = 0; i < task->n_keys; i++)
        fit_put(&result->settings, task->keys[i], result->values[i]);
    return fit_run_at_data(search, &result->settings) || status_take(status, &search->why);
}

/* Takes some 10 runs for each parameter to find where to begin, then 2 m + 1 in each iteration. */
bool fit_solve(const FitTask *task, FitResult *result, Status *status)
{
    *result = (FitResult){0};
    if (!settings_refuse_mistake(task->settings, "a fit is of the right code", status))
        return false;
    Search *search = calloc(1, sizeof *search);
    if (!search)
        return status_fail(status, "not enough memory for a fit");
    search->task = task;
    search->result = result;
    if (!find_parameters(search, status)) {
        free(search);
        return false;
    }
    const size_t m = (size_t)task->n_keys;
    gsl_multifit_nlinear_parameters options = gsl_multifit_nlinear_default_parameters();
    gsl_errors_off();
    Space space = {.work = gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &options, task->count, m),
                   .start = gsl_vector_alloc(m),
                   .slopes = malloc(task->count * m * sizeof(double)),
                   .left = malloc(task->count * sizeof(double))};
    result->model = search->model = calloc(task->count, sizeof *search->model);
    bool sound = search->model && space.work && space.start && space.slopes && space.left;
    if (!sound)
        status_fail(status, "not enough memory for a fit");
    sound = sound && search_best(search, &space, status);
    if (space.work)
        gsl_multifit_nlinear_free(space.work);
    if (space.start)
        gsl_vector_free(space.start);
    free(space.slopes);
    free(space.left);
    free(search);
    gsl_errors_on();
    return sound;
}

void fit_free(FitResult *result)
{
    free(result->model);
    result->model = NULL;
}

/* --- in words ------------------------------------------------------------------------------------ */

/* In a few words, and in a sentence. */
static const struct {
    const char *brief, *sentence;
} left_words[] = {
    [FIT_NOTHING] = {"the run goes through all data",
                     "that is round-off: the run goes through all data, and there is no noise to judge by"},
    [FIT_WHITE] = {"they look like noise", "they look like noise of which each datum has its own"},
    [FIT_LASTING] = {"they look like noise that lasts, the intervals allow for it",
                     "they look like noise that lasts from datum to datum; the intervals allow for it"},
    [FIT_NO_NOISE] =
        {"they are not noise: the intervals do not hold",
         "they are not noise: the data have something that the run has not, and the intervals do "
         "not hold"},
};

static bool is_fit(const FitResult *result)
{
    return result->share < NO_FIT;
}

const char *fit_verdict(const FitResult *result)
{
    return !is_fit(result)        ? "nearly as large as the data: that is not a fit"
           : result->n_others > 0 ? "as small at other values, which the data cannot tell from these"
                                  : left_words[result->left].brief;
}

void fit_tell(const FitTask *task, const FitResult *result, char *out, size_t size)
{
    *out = '\0';
    text_append(out, size, "residuals, root mean square: %.4g (began at %.4g), %.3g %% of the data\n",
                result->rms, result->rms_before, 100 * result->share);
    text_append(out, size, "%s\n", left_words[result->left].sentence);
    if (result->left == FIT_LASTING)
        text_append(out, size, "correlation of neighbours: %.3f\n", result->noise.correlation);
    if (!is_fit(result))
        text_append(out, size, "nearly as large as the data: that is a minimum, and no fit\n");
    if (result->n_others > 0)
        text_append(out, size, "other minima are as deep, the data cannot tell them apart:\n");
    for (int i = 0; i < result->n_others; i++) {
        for (int k = 0; k < task->n_keys; k++)
            text_append(out, size, "  %s %.8g", task->keys[k], result->others[i].values[k]);
        text_append(out, size, "  (residuals %.4g)\n", result->others[i].rms);
    }
}
