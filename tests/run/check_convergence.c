/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Convergence of predicted answers against an independent eigenvalue solver's. */
#include "answers/convergence.h"
#include "scenario/concern_bonds.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/scenario.h"
#include "scenario/settings.h"
#include "base/kinds.h"
#include "scenario/parameters.h"
#include "suite.h"

#include <math.h>
#include <string.h>

static const ConvergenceStudy *study_of(const Settings *settings, const char *word)
{
    const ConvergenceStudy *studies[CONVERGENCE_STUDIES_MAX];
    const int count = convergence_studies(settings, studies);
    for (int i = 0; i < count; i++)
        if (strcmp(studies[i]->word, word) == 0)
            return studies[i];
    ck_abort_msg("there is no study %s", word);
    return NULL;
}

static ConvergencePoint point_of(const ConvergenceStudy *study, const Settings *settings, int k)
{
    ConvergencePoint point;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(convergence_point(study, settings, k, &point, &status), "%s", status.text);
    return point;
}

static Settings beam(double spacing, SurfaceCorrection correction)
{
    Settings settings;
    settings_default(&settings, &problem_supported_beam);
    settings_edit_lattice(&settings)->spacing = spacing;
    settings_edit_lattice(&settings)->horizon = 4 * spacing;
    settings_edit_lattice(&settings)->surface_correction = correction;
    return settings;
}

/* T over Timoshenko's at the real size, m = 4: the surface's defect is of first order in the horizon. */
START_TEST(horizon_goes_to_nothing)
{
    static const double none[] = {1.3799167620744666, 1.2174829805062173, 1.1417138344071445};
    static const double energy[] = {1.0888627499995562, 1.012011595698079, 0.9931990740292188};
    ConvergencePoint points[3];
    for (int corrected = 0; corrected < 2; corrected++) {
        const Settings settings = beam(0.25e-3, corrected ? SURFACE_ENERGY : SURFACE_NONE);
        const ConvergenceStudy *study = study_of(&settings, "delta");
        ck_assert_int_eq(study->points, 4);
        for (int k = 0; k < 3; k++) {
            points[k] = point_of(study, &settings, k);
            const Prediction *is = &points[k].prediction;
            ck_assert(points[k].known);
            ck_assert_double_eq_tol(points[k].nodes, 4, 1e-12);
            ck_assert_double_eq_tol(is->predicted / is->real_size / (corrected ? energy : none)[k], 1, 1e-8);
        }
        if (!corrected) {
            /* 38.0, 21.7, 14.2 %: to a limit that is not 0, so the order falls with the horizon */
            ck_assert_double_eq_tol(convergence_order(&points[0], &points[1]), 0.805, 1e-3);
            ck_assert_double_eq_tol(convergence_fitted_order(points, 3), 0.711, 1e-3);
            /* the moduli of the sums at m = 4 are .877364 and .887934 of the integrals', added up elsewhere
             */
            const double limit = convergence_limit(study, &settings);
            ck_assert_double_eq_tol(limit, 1.069224991, 1e-7);
            ck_assert_double_eq_tol(convergence_order_to(limit, &points[0], &points[1]), 1.0674, 1e-4);
            ck_assert_double_eq_tol(convergence_order_to(limit, &points[1], &points[2]), 1.0323, 1e-4);
        } else {
            ck_assert(isnan(convergence_order(&points[1], &points[2])));
            ck_assert(isnan(convergence_fitted_order(points, 3)));
            ck_assert(isnan(convergence_limit(study, &settings)));
        }
    }
}
END_TEST

/* A cone at m = 4, and the study of a lattice that is braked: its own period all the same. */
START_TEST(a_cone_converges_faster)
{
    static const double none[] = {0.95748677629, 0.9127696879}; /* ms */
    static const double energy[] = {0.85473345358, 0.84928103662};
    for (int corrected = 0; corrected < 2; corrected++)
        for (int braked = 0; braked < 2; braked++) {
            Settings settings = beam(0.25e-3, corrected ? SURFACE_ENERGY : SURFACE_NONE);
            settings_edit_lattice(&settings)->influence = INFLUENCE_CONICAL;
            settings_edit_damping(&settings)->rate = braked ? DAMPING_CRITICAL : 0;
            settings_edit_time(&settings)->rest = braked;
            const ConvergenceStudy *study = study_of(&settings, "delta");
            for (int k = 1; k < 3; k++) {
                const ConvergencePoint point = point_of(study, &settings, k);
                ck_assert(point.known);
                ck_assert_double_eq_tol(1e3 * point.prediction.predicted / (corrected ? energy : none)[k - 1],
                                        1, 1e-8);
            }
        }
}
END_TEST

START_TEST(more_nodes_in_the_horizon)
{
    static const double ratios[] = {0.9710222088639553, 0.9903040921705474, 0.9931990740292188,
                                    0.9996769105981892, 0.9980261132325362};
    const Settings settings = beam(0.25e-3, SURFACE_ENERGY);
    const ConvergenceStudy *study = study_of(&settings, "m");
    for (int k = 0; k < (suite_wide() ? 5 : 3); k++) {
        const ConvergencePoint point = point_of(study, &settings, k);
        ck_assert_double_eq_tol(point.prediction.predicted / point.prediction.real_size / ratios[k], 1, 1e-8);
        ck_assert_double_eq_tol(point.error, 100 * (ratios[k] - 1), 1e-5);
    }
}
END_TEST

/* Paper P's Table 1 and why it is not monotone: its layers make the beam up to 4 % thinner. */
START_TEST(table_1_and_its_layers)
{
    static const double predicted[] = {.992689, .914972, .865502, .874865, .882377, .853668};
    static const double real_size[] = {.871059, .892347, .855229, .876906, .892347, .859514};
    const Settings settings = beam(0.5e-3, SURFACE_ENERGY);
    const ConvergenceStudy *study = study_of(&settings, "table");
    ck_assert_int_eq(study->points, 6);
    for (int k = 0; k < 6; k++) {
        const Prediction is = point_of(study, &settings, k).prediction;
        ck_assert_double_eq_tol(is.predicted * 1e3, predicted[k], 6e-7);
        ck_assert_double_eq_tol(is.real_size * 1e3, real_size[k], 6e-7);
    }
}
END_TEST

START_TEST(cells_of_a_bar_are_of_second_order)
{
    Settings settings;
    settings_default(&settings, &problem_bar);
    settings_edit_start(&settings)->mode = 5;
    const ConvergenceStudy *study = study_of(&settings, "cells");
    ConvergencePoint points[CONVERGENCE_POINTS_MAX];
    const int count = study->points;
    ck_assert_int_eq(count, 5);
    for (int k = 0; k < count; k++)
        points[k] = point_of(study, &settings, k);
    ck_assert(!points[0].known); /* 12.5 cells are none */
    ck_assert_double_eq_tol(points[1].error, -4.2388, 1e-3);
    ck_assert_double_eq_tol(convergence_order(&points[3], &points[4]), 2, 0.01);
    ck_assert_double_eq_tol(convergence_fitted_order(points, count), 2, 0.02);
}
END_TEST

static bool never(double share, void *context)
{
    (void)share, (void)context;
    return false;
}

START_TEST(a_point_can_be_given_up)
{
    Settings settings = beam(0.25e-3, SURFACE_ENERGY);
    settings.cancel.go_on = never;
    ConvergencePoint point;
    Status status = {STATUS_DONE, ""};
    ck_assert(!convergence_point(study_of(&settings, "m"), &settings, 3, &point, &status));
    ck_assert_str_ne(status.text, "");
}
END_TEST

START_TEST(what_cannot_converge_has_no_study)
{
    const ConvergenceStudy *studies[CONVERGENCE_STUDIES_MAX];
    Settings settings;
    settings_default(&settings, &problem_notched_beam);
    ck_assert_int_eq(convergence_studies(&settings, studies), 0);
    settings_default(&settings, &problem_moving_cantilever);
    ck_assert_int_eq(convergence_studies(&settings, studies), 0);
}
END_TEST

static Settings scenario_of(const char *name)
{
    Settings settings;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scenario_load(name, &settings, &status), "%s", status.text);
    return settings;
}

/* L/L0 of FLIP after two turns on cells of 0.2, 0.1 and 0.05, by tests/independent/bodies.py. */
START_TEST(bodies_converge_by_runs)
{
    static const double kept[] = {0.4938747308256237, 0.6806062430296479, 0.9412420177802643};
    const Settings settings = scenario_of("spinning-disc");
    const ConvergenceStudy *study = study_of(&settings, "cells");
    ConvergencePoint points[3];
    ck_assert_int_eq(study->points, 4);
    for (int k = 0; k < 3; k++) {
        points[k] = point_of(study, &settings, k);
        ck_assert(points[k].known);
        ck_assert_double_eq(points[k].nodes, 5 << k);
        ck_assert_double_eq_tol(points[k].error, 100 * (kept[k] - 1), 1e-6);
    }
    ck_assert_double_eq_tol(convergence_order(&points[1], &points[2]), 2.442, 1e-3);
}
END_TEST

/* Of the number that it is about nothing is known there: the first that has a right answer. */
START_TEST(bodies_take_a_number_that_has_an_answer)
{
    static const struct {
        const char *scenario, *of;
        double end, error;
    } cases[] = {{"falling-beam", "error of the end", 0.05, 1.6}, /* (0.01275 - 0.01255)/0.01255 */
                 {"two-discs", "first touch", 1.8, -2.2},         /* 1.551/1.586 */
                 {"bouncing-disc", "first touch of a wall", 0.3, -0.1},
                 {"roll-or-slide", "mean acceleration", 0.5, 0.1},
                 {"vibrating-block", "error of u", 0.75, 1.21}}; /* 1.21e-2: bodies.claims */
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Settings settings = scenario_of(cases[i].scenario);
        settings_edit_time(&settings)->end = cases[i].end;
        const ConvergencePoint point = point_of(study_of(&settings, "cells"), &settings, 1);
        ck_assert_msg(point.known, "%s", cases[i].scenario);
        ck_assert_str_eq(point.of, cases[i].of);
        ck_assert_msg(fabs(point.error - cases[i].error) < 0.1, "%s: %g", cases[i].scenario, point.error);
    }
    Settings settings = scenario_of("roll-or-slide"); /* up to the end of the floor: no answer behind it */
    const ConvergencePoint point = point_of(study_of(&settings, "cells"), &settings, 0);
    ck_assert(!point.known);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *studies = tcase_create("studies");
    tcase_add_test(studies, horizon_goes_to_nothing);
    tcase_add_test(studies, a_cone_converges_faster);
    tcase_add_test(studies, more_nodes_in_the_horizon);
    tcase_add_test(studies, table_1_and_its_layers);
    tcase_add_test(studies, cells_of_a_bar_are_of_second_order);
    tcase_add_test(studies, bodies_converge_by_runs);
    tcase_add_test(studies, bodies_take_a_number_that_has_an_answer);
    tcase_add_test(studies, a_point_can_be_given_up);
    tcase_add_test(studies, what_cannot_converge_has_no_study);
    suite_add_tcase(suite, studies);
}
