/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The studies of convergence.h: each is a function that makes the settings of its point k from those of
 * the scenario. A point is computed by predicted answers alone (problem.h), no run is made; the observed
 * order is the slope of a straight line through log |error| over log size. */
#include "answers/convergence.h"
#include "base/assertion.h"
#include "answers/references.h"
#include "scenario/concern_body.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "base/kinds.h"
#include "answers/run_numbers.h"
#include "answers/dispersion_curves.h"
#include "scenario/parameters.h"
#include "base/math/functions.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

/* --- the studies ---------------------------------------------------------------------------------- */

static const double by_halves[] = {4, 2, 1, 0.5};
static const double cells_by_halves[] = {2, 1, 0.5, 0.25, 0.125};
static const int cells_in_height[] = {2, 4, 8, 16};
static const double nodes_in_horizon[] = {2, 3, 4, 5, 6, 8};
/* Paper P's Table 1: horizon and spacing, m, and the period that it prints, s. */
static const double table_1[][3] = {{5e-3, 1.2e-3, 0.98e-3},    {2.5e-3, 0.6e-3, 0.90e-3},
                                    {2e-3, 0.5e-3, 0.875e-3},   {1.5e-3, 0.35e-3, 0.87e-3},
                                    {1.25e-3, 0.3e-3, 0.88e-3}, {1e-3, 0.25e-3, 0.865e-3}};

#define LENGTH_OF(array) ((int)(sizeof(array) / sizeof *(array)))

/* delta -> 0 with m = delta/dx kept: converges to the local theory. */
static void refine_horizon(Settings *settings, int k)
{
    settings_edit_lattice(settings)->horizon *= by_halves[k];
    settings_edit_lattice(settings)->spacing *= by_halves[k];
}

/* m -> infinity with delta kept: converges to peridynamics of this horizon, not to the local theory. */
static void refine_spacing(Settings *settings, int k)
{
    settings_edit_lattice(settings)->spacing = settings_lattice(settings)->horizon / nodes_in_horizon[k];
}

/* Paper P's Table 1: horizon and spacing fall together, but not in one proportion, and floor(h/dx) rows make
 * some of the beams thinner; so its periods are not monotone. */
static void take_from_table(Settings *settings, int k)
{
    settings_edit_lattice(settings)->horizon = table_1[k][0];
    settings_edit_lattice(settings)->spacing = table_1[k][1];
}

static double printed_in_table(int k)
{
    return table_1[k][2];
}

/* The bar's cells halved again and again; courant is kept, so the step is halved too. */
static void refine_cells(Settings *settings, int k)
{
    settings_edit_mesh(settings)->cell_size *= cells_by_halves[k];
}

/* An even number of cells in the height: a row of nodes lies in the middle. */
static void refine_plane_cells(Settings *settings, int k)
{
    settings_edit_mesh(settings)->cell_size = settings_geometry(settings)->height / cells_in_height[k];
}

/* The same cells with two, three and four particles along each of their sides. */
enum { CELLS_IN_LINE = 3, PARTICLES_LEAST = 2 };
static const char *const particle_lines[] = {"2 x 2", "3 x 3", "4 x 4", NULL};

static void refine_particles(Settings *settings, int k)
{
    refine_plane_cells(settings, k % CELLS_IN_LINE);
    settings_edit_mesh(settings)->particles_per_cell = PARTICLES_LEAST + k / CELLS_IN_LINE;
}

/* Cells that grow smaller, then horizons with m kept. */
enum { SIZES_OF_METHOD = LENGTH_OF(cells_in_height) };
static const char *const method_lines[] = {"MPM", "bonds", NULL};

static void refine_methods(Settings *settings, int k)
{
    settings->method = k < SIZES_OF_METHOD ? METHOD_MPM : METHOD_PD;
    if (k < SIZES_OF_METHOD)
        refine_plane_cells(settings, k);
    else
        refine_horizon(settings, k - SIZES_OF_METHOD);
}

/* T over theory's as delta -> 0 with m kept and nothing corrected. The surface's defect vanishes then; what
 * stays is that the sum over so few nodes does not approximate the integral. Its moduli are those of long
 * waves along its rows,
 *
 *     C11 = 9E/8 (c_L/c_L0)^2,   C12 = C66 = 3E/8 (c_T/c_T0)^2,   T/T_0 = sqrt(E/(C11 - C12^2/C11))
 *
 * for bonds are central forces, and a beam bends freely across. At m = 4 it is 1.0692; it falls to 1 with
 * larger m. */
static double limit_of_horizon(const Settings *settings)
{
    const double long_wave = 1e-3 / settings_lattice(settings)->horizon;
    if (settings_lattice(settings)->surface_correction != SURFACE_NONE)
        return NAN;
    const double along = dispersion_on_lattice(settings, settings_lattice(settings)->influence, false, 0,
                                               long_wave),
                 across = dispersion_on_lattice(settings, settings_lattice(settings)->influence, true, 0,
                                                long_wave);
    const double c11 = 9.0 / 8 * along * along, c12 = 3.0 / 8 * across * across;
    return 1 / sqrt(c11 - c12 * c12 / c11);
}

static double spacing_of(const Settings *settings)
{
    return settings_lattice(settings)->spacing;
}

/* The horizon, or a cell. */
static double size_of(const Settings *settings)
{
    return settings->method == METHOD_PD ? settings_lattice(settings)->horizon
                                         : settings_mesh(settings)->cell_size;
}

enum { VIBRATING_LATTICE = CONCERN_LATTICE | CONCERN_DEFLECTION | CONCERN_BEAM };

enum { BEAM_OF_CELLS = CONCERN_BEAM | CONCERN_SECTIONS, BEAM_OF_BOTH = BEAM_OF_CELLS | CONCERN_LATTICE };

#define BOTH_METHODS(by)                                                                                     \
    {                                                                                                        \
        "methods", "cells or horizon smaller", "cell or horizon", BEAM_OF_BOTH, by, refine_methods,          \
            SIZES_OF_METHOD + LENGTH_OF(by_halves), NULL, size_of, method_lines, SIZES_OF_METHOD, NULL,      \
            false                                                                                            \
    }

static const ConvergenceStudy studies[] = {
    /* of bodies each point takes eight times as long as the one before */
    {"cells", "cells smaller", "cell size", CONCERN_BODIES, METHOD_MPM, refine_cells,
     LENGTH_OF(cells_by_halves) - 1, NULL, size_of, NULL, 0, NULL, true},
    {"cells", "cells smaller", "cell size", CONCERN_BAR | CONCERN_MESH, METHOD_MPM, refine_cells,
     LENGTH_OF(cells_by_halves), NULL, size_of, NULL, 0, NULL, false},
    {"cells", "cells smaller", "cell size", BEAM_OF_CELLS, METHOD_MPM, refine_plane_cells,
     LENGTH_OF(cells_in_height), NULL, size_of, NULL, 0, NULL, false},
    {"particles", "cells smaller, more particles", "cell size", BEAM_OF_CELLS, METHOD_MPM, refine_particles,
     CELLS_IN_LINE *CONVERGENCE_LINES_MAX, NULL, size_of, particle_lines, CELLS_IN_LINE, NULL, false},
    {"delta", "horizon smaller, m kept", "horizon", VIBRATING_LATTICE, METHOD_PD, refine_horizon,
     LENGTH_OF(by_halves), NULL, size_of, NULL, 0, limit_of_horizon, false},
    {"m", "m larger, horizon kept", "spacing", VIBRATING_LATTICE, METHOD_PD, refine_spacing,
     LENGTH_OF(nodes_in_horizon), NULL, spacing_of, NULL, 0, NULL, false},
    {"table", "Table 1 of paper P", "horizon", VIBRATING_LATTICE, METHOD_PD, take_from_table,
     LENGTH_OF(table_1), printed_in_table, size_of, NULL, 0, NULL, false},
    BOTH_METHODS(METHOD_MPM),
    BOTH_METHODS(METHOD_PD),
};

/* A study without runs needs a predicted answer that knows all parameters at work (references.h). */
int convergence_studies(const Settings *settings, const ConvergenceStudy *out[CONVERGENCE_STUDIES_MAX])
{
    const Problem *problem = settings->problem;
    const Solver *solver = problem_solver(problem, settings->method);
    int count = 0;
    const bool predicts = solver && solver->predict && !answer_unaccounted_now(settings, REFERENCE_PREDICTED);
    for (int i = 0; i < LENGTH_OF(studies); i++)
        if ((studies[i].by_run || predicts) &&
            (problem->concerns & studies[i].concerns) == studies[i].concerns &&
            settings->method == studies[i].method)
            out[count++] = &studies[i];
    return count;
}

/* --- points --------------------------------------------------------------------------------------- */

/* 100 (value/right - 1), or 100 value of what should be 0. False: no number of the run has a right answer
 * now; the value itself may come later. */
static bool compare(const Experiment *run, ConvergencePoint *out)
{
    static const char *const words[] = {NULL,         "tip_error",    "angular_kept", "first_touch",
                                        "wall_touch", "acceleration", "u_error"};
    double right = NAN;
    RunSummary summary;
    summary_now(run, SUMMARY_FINDINGS, &summary);
    for (int i = 0; i < LENGTH_OF(words) && !isfinite(right); i++) {
        const RunNumber *number =
            words[i] ? run_number_find(words[i]) : run_number_about(experiment_settings(run));
        const double value = number->value(&summary, number->word);
        right = number->judged && isfinite(value) ? 0 : NAN;
        out->of = number->label;
        for (int k = 0; k < summary.n_findings; k++)
            if (strcmp(summary.findings[k].name, number->word) == 0) {
                out->of = summary.findings[k].label;
                right = summary.findings[k].exact;
            }
        out->prediction.predicted = value;
        out->prediction.real_size = right;
        out->error = 100 * (right == 0 ? value : value / right - 1);
    }
    return isfinite(right);
}

/* A run that has nothing to compare, or does not come to its end, gives a point that is not known. */
static bool point_by_run(const Settings *settings, ConvergencePoint *out, Status *status)
{
    const size_t history = 0;
    Status why = {STATUS_DONE, ""};
    Experiment *run = experiment_create(settings, history, 1, &why);
    if (!run)
        return why.code == STATUS_USAGE || status_fail(status, "%s", why.text);
    bool going = experiment_advance(run, 1, &why) && compare(run, out);
    if (going) {
        experiment_seek(run, experiment_last_step(run), 0);
        going = experiment_work_off(run, settings->cancel, &why);
    }
    const bool kept = !experiment_pending(run, NULL); /* else it was cancelled */
    out->known = going && compare(run, out) && isfinite(out->error);
    experiment_destroy(run);
    return kept || status_fail(status, "%s", why.text);
}

bool convergence_point(const ConvergenceStudy *study, const Settings *settings, int k, ConvergencePoint *out,
                       Status *status)
{
    ASSERT_INT(k, >=, 0);
    Settings refined = *settings;
    Status why = {STATUS_DONE, ""};
    *out = (ConvergencePoint){.size = NAN, .nodes = NAN, .error = NAN, .paper = NAN};
    out->prediction.real_height = NAN;
    if (k >= study->points)
        return true;
    study->refine(&refined, k);
    const Solver *solver = problem_solver(refined.problem, refined.method);
    const bool lattice = refined.method == METHOD_PD;
    out->of_mesh = !lattice;
    out->size = study->size_of(&refined);
    if (study->by_run) {
        out->nodes = settings_geometry(&refined)->length / out->size;
        return point_by_run(&refined, out, status);
    }
    settings_edit_time(&refined)->step = 0;     /* each lattice has its own critical step */
    settings_edit_time(&refined)->rest = false; /* and its own period, however it is braked */
    settings_edit_damping(&refined)->rate = 0;
    if (study->paper)
        out->paper = study->paper(k);
    out->nodes = lattice ? settings_lattice(&refined)->horizon / settings_lattice(&refined)->spacing
                         : settings_geometry(&refined)->length / settings_mesh(&refined)->cell_size;
    if (!solver->check(&refined, &why))
        return true;
    if (!solver->predict(&refined, &out->prediction, &why)) {
        /* one that is refused is too coarse or too fine to be one */
        return why.code == STATUS_USAGE || status_fail(status, "%s", why.text);
    }
    const Prediction *is = &out->prediction;
    out->known = isfinite(is->predicted) && isfinite(is->real_size);
    out->error = 100 * (is->predicted / is->real_size - 1);
    return true;
}

double convergence_order(const ConvergencePoint *a, const ConvergencePoint *b)
{
    const double ratio = a->error / b->error;
    return a->known && b->known && ratio > 0 ? math_log(ratio) / math_log(a->size / b->size) : NAN;
}

double convergence_limit(const ConvergenceStudy *study, const Settings *settings)
{
    return study->limit ? study->limit(settings) : NAN;
}

double convergence_order_to(double limit, const ConvergencePoint *a, const ConvergencePoint *b)
{
    ConvergencePoint from = *a, to = *b;
    from.error -= 100 * (limit - 1);
    to.error -= 100 * (limit - 1);
    return convergence_order(&from, &to);
}

/* slope = (n sum xy - sum x sum y)/(n sum x^2 - (sum x)^2), x = log size, y = log |error|. Where the error
 * does not fall, points are not yet in the range where an order means anything. */
double convergence_fitted_order(const ConvergencePoint *points, int count)
{
    ASSERT_INT(count, >=, 0);
    double n = 0, sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0;
    const ConvergencePoint *before = NULL;
    for (int i = 0; i < count; i++) {
        const ConvergencePoint *point = &points[i];
        if (!point->known)
            continue;
        const bool falls =
            !before || (point->error * before->error > 0 && fabs(point->error) < fabs(before->error));
        if (!falls)
            return NAN;
        const double x = math_log(point->size), y = math_log(fabs(point->error));
        n += 1;
        sum_x += x;
        sum_y += y;
        sum_xx += x * x;
        sum_xy += x * y;
        before = point;
    }
    return n < 3 ? NAN : (n * sum_xy - sum_x * sum_y) / (n * sum_xx - sum_x * sum_x);
}

/* --- what is known -------------------------------------------------------------------------------- */

/* Of the same run, whatever it is called and however it is looked at. */
static bool is_of(const Convergence *convergence, const Settings *settings)
{
    return convergence->n_studies > 0 && convergence->base.problem == settings->problem &&
           convergence->base.method == settings->method && settings_same(&convergence->base, settings);
}

static int index_of(const Convergence *convergence, const ConvergenceStudy *study)
{
    for (int i = 0; i < convergence->n_studies; i++)
        if (convergence->studies[i] == study)
            return i;
    return -1;
}

void convergence_begin(Convergence *convergence, const Settings *settings)
{
    if (is_of(convergence, settings))
        return;
    convergence->base = *settings;
    convergence->n_studies = convergence_studies(settings, convergence->studies);
    for (int i = 0; i < convergence->n_studies; i++)
        convergence->known[i] = 0;
}

int convergence_known(const Convergence *convergence, const Settings *settings, const ConvergenceStudy *study,
                      const ConvergencePoint **points)
{
    const int i = is_of(convergence, settings) ? index_of(convergence, study) : -1;
    if (i < 0)
        return 0;
    *points = convergence->points[i];
    return convergence->known[i];
}

bool convergence_lacks(const Convergence *convergence, const Settings *settings,
                       const ConvergenceStudy *study)
{
    const ConvergencePoint *points;
    return convergence_known(convergence, settings, study, &points) < study->points;
}

bool convergence_next(Convergence *convergence, const ConvergenceStudy *study, Cancel cancel, Status *status)
{
    const int i = index_of(convergence, study);
    convergence->base.cancel = cancel;
    if (!convergence_point(study, &convergence->base, convergence->known[i],
                           &convergence->points[i][convergence->known[i]], status))
        return false;
    convergence->known[i]++;
    return true;
}
