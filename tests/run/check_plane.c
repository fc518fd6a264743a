/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beams by the material point method as the laboratory has them: their keys, answers beside, refinement, and
 * runs that are walked back. */
#include "answers/convergence.h"
#include "scenario/concern_cells.h"
#include "scenario/settings.h"
#include "base/kinds.h"
#include "answers/references.h"
#include "views/map/map.h"
#include "run/lab_case.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A short high beam in few cells, or a cantilever; both take little time. */
static Settings cells(const Problem *problem)
{
    Settings settings;
    settings_default(&settings, problem);
    set(&settings, "scenario.method", "mpm");
    set(&settings, "beam.length", "0.025");
    set(&settings, "mesh.cell_size", "1.25e-3");
    if (problem == &problem_moving_cantilever)
        set(&settings, "motion.channel", "5e-3");
    set(&settings, "time.end", "2e-4");
    return settings;
}

static Readout read_out(Experiment *experiment)
{
    const Record *record = experiment_record(experiment);
    Column columns[COLUMNS_MAX];
    Readout readout;
    const int n = references_columns(experiment_references(experiment), columns);
    double *rows = malloc(record->count * (size_t)n * sizeof *rows);
    for (size_t k = 0; k < record->count; k++)
        memcpy(rows + k * (size_t)n, record_row(record, k), (size_t)n * sizeof *rows);
    references_readout(experiment_references(experiment), rows, record->count, n, &readout);
    free(rows);
    return readout;
}

static void expect_columns(const Experiment *experiment, const char *const *names)
{
    Column columns[COLUMNS_MAX];
    const int n = references_columns(experiment_references(experiment), columns);
    for (int i = 0; i < n || names[i]; i++)
        ck_assert_str_eq(i < n ? columns[i].quantity.name : "", names[i] ? names[i] : "");
}

START_TEST(columns_of_the_supported_beam)
{
    static const char *const names[] = {
        "step",         "time",    "u_probe",    "v_probe",    "u_euler",      "v_euler",      "u_timoshenko",
        "v_timoshenko", "u_plane", "v_plane",    "kinetic",    "kinetic_grid", "kinetic_null", "strain",
        "work",         "total",   "momentum_x", "momentum_y", "reaction_x",   "reaction_y",   NULL};
    static const char *const at_points[] = {
        "step",         "time",       "u_probe",      "v_probe",      "u_euler", "v_euler", "u_timoshenko",
        "v_timoshenko", "kinetic",    "kinetic_grid", "kinetic_null", "strain",  "work",    "total",
        "momentum_x",   "momentum_y", "reaction_x",   "reaction_y",   NULL};
    Settings settings = cells(&problem_supported_beam);
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    expect_columns(experiment, names);
    experiment_destroy(experiment);
    set(&settings, "supports.ends", "point"); /* the plane problem's exact answer is that of held sections */
    experiment = open_experiment(&settings, 1 << 20);
    expect_columns(experiment, at_points);
    experiment_destroy(experiment);
}
END_TEST

START_TEST(columns_of_the_cantilever)
{
    static const char *const names[] = {"step",       "time",       "u_probe", "v_probe",      "length",
                                        "u_modal",    "v_modal",    "kinetic", "kinetic_grid", "kinetic_null",
                                        "strain",     "work",       "total",   "momentum_x",   "momentum_y",
                                        "reaction_x", "reaction_y", NULL};
    const Settings settings = cells(&problem_moving_cantilever);
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    expect_columns(experiment, names);
    /* the probe lies half a spacing before the tip, and so does what it is compared with */
    const double *row = record_row(experiment_record(experiment), 0);
    const double probe = row[column_of(experiment, "u_probe")], modal = row[column_of(experiment, "u_modal")];
    ck_assert_double_eq_tol(probe / modal, 1, 1e-6);
    ck_assert_double_lt(probe, 5.95e-6);
    experiment_destroy(experiment);
}
END_TEST

START_TEST(measured_predicted_and_theory)
{
    Settings settings = cells(&problem_supported_beam);
    set(&settings, "mpm.shape", "hat");
    set(&settings, "initial.amplitude", "3e-8");
    set(&settings, "beam.poisson", "0.1");
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    double now, start;
    ck_assert(experiment_advance(experiment, 1000000, NULL));
    const Readout readout = read_out(experiment);
    ck_assert(readout.measured_known && readout.predicted_known && readout.exact_known);
    ck_assert_double_eq_tol(readout.measured / readout.predicted, 1, 3e-6);
    /* what is kept is kept to many digits */
    ck_assert(experiment_invariant(experiment, &now, &start));
    ck_assert_double_eq_tol(now / start, 1, 1e-7);
    experiment_destroy(experiment);
}
END_TEST

/* E* leaves where velocities are damped or a channel works; the motion beside leaves where the start is
 * other. */
START_TEST(answers_leave)
{
    Settings settings = cells(&problem_supported_beam);
    ck_assert(references_have_invariant(&settings));
    set(&settings, "mpm.flip_fraction", "0.99");
    ck_assert(!references_have_invariant(&settings));
    const Settings moving = cells(&problem_moving_cantilever);
    ck_assert(!references_have_invariant(&moving));
    set(&settings, "initial.start", "velocity");
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    ck_assert_int_lt(column_of(experiment, "u_plane"), 0);
    ck_assert(experiment_advance(experiment, 1000000, NULL));
    ck_assert(read_out(experiment).predicted_known);
    experiment_destroy(experiment);
}
END_TEST

/* The error to the plane problem falls with the square of the cell; that of beam theory would not. */
START_TEST(cells_go_to_nothing)
{
    Settings settings;
    const ConvergenceStudy *studies[CONVERGENCE_STUDIES_MAX];
    ConvergencePoint points[4];
    settings_default(&settings, &problem_supported_beam);
    set(&settings, "scenario.method", "mpm");
    ck_assert_int_eq(convergence_studies(&settings, studies), 3);
    ck_assert_int_eq(studies[0]->points, 4);
    static const double errors[] = {-1.39, -.359, -.091, -.023};
    for (int k = 0; k < 4; k++) {
        Status status = {STATUS_DONE, ""};
        ck_assert_msg(convergence_point(studies[0], &settings, k, &points[k], &status), "%s", status.text);
        ck_assert(points[k].known);
        ck_assert_double_eq_tol(points[k].error, errors[k], k == 0 ? 6e-3 : 2e-3);
    }
    ck_assert_double_eq_tol(convergence_order(&points[1], &points[3]), 2, 0.03);
}
END_TEST

static void expect_refused(Settings settings, const char *key, const char *value, const char *words)
{
    Status status = {STATUS_DONE, ""};
    char advice[200];
    const bool taken = settings_set(&settings, key, value, &status) && settings_check(&settings, &status) &&
                       problem_advice(&settings, advice, sizeof advice, &status);
    ck_assert_msg(!taken, "%s = %s was taken", key, value);
    ck_assert_msg(strstr(status.text, words) != NULL, "%s", status.text);
}

/* More particles in a cell feel more of the shear that a cell cannot help when it bends; each line of points
 * falls with the square of the cell. */
START_TEST(more_particles_lock)
{
    Settings settings;
    const ConvergenceStudy *studies[CONVERGENCE_STUDIES_MAX];
    ConvergencePoint points[9];
    settings_default(&settings, &problem_supported_beam);
    set(&settings, "scenario.method", "mpm");
    convergence_studies(&settings, studies);
    ck_assert_str_eq(studies[1]->word, "particles");
    ck_assert_int_eq(studies[1]->points, 9);
    for (int k = 0; k < 9; k++)
        ck_assert(convergence_point(studies[1], &settings, k, &points[k], &(Status){STATUS_DONE, ""}));
    ck_assert_double_eq_tol(points[1].error, -.359, 2e-3);
    ck_assert_double_eq_tol(points[4].error, 100 * (.855087 / .863692 - 1), 1e-3);
    for (int k = 0; k < 9; k++)
        ck_assert(k < 3 || points[k].error < points[k - 3].error);
    for (int line = 0; line < 3; line++)
        ck_assert_double_eq_tol(convergence_order(&points[3 * line + 1], &points[3 * line + 2]), 2, 0.03);
}
END_TEST

/* Both methods in one study, whichever the scenario has; bonds have their own Poisson's ratio. */
START_TEST(both_methods_converge_side_by_side)
{
    static const char *const methods[] = {"mpm", "pd"};
    for (int i = 0; i < 2; i++) {
        Settings settings;
        const ConvergenceStudy *studies[CONVERGENCE_STUDIES_MAX];
        ConvergencePoint cells_point, horizon_point;
        settings_default(&settings, &problem_supported_beam);
        set(&settings, "scenario.method", methods[i]);
        if (i == 0)
            set(&settings, "beam.poisson", "0");
        const int last = convergence_studies(&settings, studies) - 1;
        ck_assert_str_eq(studies[last]->word, "methods");
        ck_assert_int_eq(studies[last]->points, 8);
        ck_assert(convergence_point(studies[last], &settings, 1, &cells_point, &(Status){STATUS_DONE, ""}));
        ck_assert(convergence_point(studies[last], &settings, 5, &horizon_point, &(Status){STATUS_DONE, ""}));
        ck_assert_double_eq_tol(cells_point.size, 1.25e-3, 1e-12);
        ck_assert_double_eq_tol(cells_point.error, -.36, 5e-3);
        ck_assert_double_eq_tol(horizon_point.size, 2e-3, 1e-12);
        ck_assert_double_eq_tol(horizon_point.prediction.predicted, .865502e-3, 1e-9);
    }
}
END_TEST

/* A pull and a push at right angles, seen from axes that are turned away from them. */
START_TEST(principal_stresses_do_not_turn)
{
    const double pull = 5e6, push = -2e6;
    for (int degrees = -89; degrees < 90; degrees += 11) {
        const double a = degrees * M_PI / 180, c = cos(a), s = sin(a);
        const Principal is = principal_stresses(pull * c * c + push * s * s, pull * s * s + push * c * c,
                                                (pull - push) * s * c);
        ck_assert_double_eq_tol(is.most, pull, 1e-9 * pull);
        ck_assert_double_eq_tol(is.least, push, 1e-9 * pull);
        ck_assert_double_eq_tol(is.angle, a, 1e-12);
    }
}
END_TEST

START_TEST(what_is_refused)
{
    const Settings beam = cells(&problem_supported_beam), moving = cells(&problem_moving_cantilever);
    Settings bonds, notched;
    settings_default(&bonds, &problem_supported_beam);
    settings_default(&notched, &problem_notched_beam);
    expect_refused(bonds, "beam.poisson", "0.2", "bonds pull along their own line alone");
    expect_refused(bonds, "mesh.cell_size", "1e-3", "not a parameter of method pd (only of mpm)");
    expect_refused(notched, "scenario.method", "mpm", "nothing breaks");
    expect_refused(beam, "mpm.transfer", "apic", "not a parameter of problem simply-supported-beam");
    expect_refused(beam, "mpm.shape", "bspline3", "is for bars");
    expect_refused(beam, "pd.spacing", "1e-3", "not a parameter of method mpm (only of pd)");
    expect_refused(beam, "time.step", "1e-8", "not a parameter of method mpm (only of pd)");
    expect_refused(beam, "mesh.cell_size", "1e-3", "must be an even number of cells");
    expect_refused(beam, "mesh.velocity", "1", "not a parameter of problem simply-supported-beam");
    expect_refused(beam, "time.courant", "1.8", "is unstable on this mesh (at most 1.7");
    expect_refused(beam, "beam.poisson", "0.5", "0.499");
    Settings last = beam; /* whose limit is lower, and is asked for from lower on */
    settings_edit_transfer(&last)->algorithm = MPM_USL;
    expect_refused(last, "time.courant", "0.9", "is unstable on this mesh (at most 0.");
    expect_refused(moving, "mesh.velocity", "11", "out of range (0 to motion.speed = 10)");
    expect_refused(moving, "supports.ends", "point", "not a parameter of problem moving-cantilever");
    expect_refused(moving, "motion.channel", "1.25e-3", "too short for time.end");
}
END_TEST

/* Walked back to a step and forward again: the same state, the same rows; so with a change on the way. */
START_TEST(rewind_and_changes)
{
    Settings settings = cells(_i ? &problem_moving_cantilever : &problem_supported_beam);
    settings.n_changes = 1;
    settings.changes[0] = (Change){40, {"mpm.algorithm", "musl"}};
    Experiment *walked = open_experiment(&settings, 1 << 20), *straight = open_experiment(&settings, 1 << 20);
    ck_assert(experiment_advance(walked, 90, NULL));
    experiment_seek(walked, 25, 3);
    finish_work(walked);
    ck_assert_int_eq(experiment_simulation(walked)->stage, 3);
    ck_assert(experiment_advance(walked, 74, NULL));
    ck_assert(experiment_advance(straight, 100, NULL));
    ck_assert_int_eq(experiment_simulation(walked)->step, 100);
    expect_same_states(experiment_simulation(walked), experiment_simulation(straight), "walked back");
    expect_same_records(experiment_record(walked), experiment_record(straight), "walked back");
    experiment_destroy(walked);
    experiment_destroy(straight);
}
END_TEST

/* What takes longer than a step is in every eighth row, the same as in a run that has it in all, by every way
 * there; in between the last one stands for it. */
START_TEST(rows_are_whole_now_and_then)
{
    Settings settings = cells(_i ? &problem_moving_cantilever : &problem_supported_beam);
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    set(&settings, "output.columns", "kinetic_null");
    Simulation *sim = problem_simulate(&settings, 1, NULL);
    double *rows = malloc(50 * (size_t)sim->n_series * sizeof *rows);
    ck_assert(simulation_steps(sim, 50, rows, NULL, NULL));
    ck_assert(experiment_advance(experiment, 43, NULL));
    experiment_seek(experiment, 45, 3);
    finish_work(experiment);
    ck_assert(experiment_advance(experiment, 4, NULL));
    const Record *record = experiment_record(experiment);
    const int null = simulation_find_series(sim, "kinetic_null"),
              column = column_of(experiment, "kinetic_null");
    for (size_t k = 1; k < record->count; k++) {
        const double value = record_row(record, k)[column];
        ck_assert_int_eq(isnan(value), k % 8 != 0);
        if (k % 8 == 0)
            ck_assert_double_eq(value, rows[(k - 1) * (size_t)sim->n_series + (size_t)null]);
        ck_assert_double_eq(record_known(record, k, column), record_row(record, k - k % 8)[column]);
    }
    ck_assert_uint_gt(record->count, 40);
    free(rows);
    simulation_destroy(sim);
    experiment_destroy(experiment);
}
END_TEST

/* Whatever number of threads is asked for. */
START_TEST(threads_leave_no_trace)
{
    const Settings settings = cells(&problem_moving_cantilever);
    Simulation *one = problem_simulate(&settings, 1, NULL), *three = problem_simulate(&settings, 3, NULL);
    ck_assert(one && three);
    ck_assert(simulation_steps(one, 100, NULL, NULL, NULL) && simulation_steps(three, 100, NULL, NULL, NULL));
    expect_same_states(one, three, "three threads");
    simulation_destroy(one);
    simulation_destroy(three);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *plane = tcase_create("plane");
    tcase_add_test(plane, columns_of_the_supported_beam);
    tcase_add_test(plane, columns_of_the_cantilever);
    tcase_add_test(plane, measured_predicted_and_theory);
    tcase_add_test(plane, answers_leave);
    tcase_add_test(plane, cells_go_to_nothing);
    tcase_add_test(plane, more_particles_lock);
    tcase_add_test(plane, both_methods_converge_side_by_side);
    tcase_add_test(plane, principal_stresses_do_not_turn);
    tcase_add_test(plane, what_is_refused);
    tcase_add_loop_test(plane, rewind_and_changes, 0, 2);
    tcase_add_loop_test(plane, rows_are_whole_now_and_then, 0, 2);
    tcase_add_test(plane, threads_leave_no_trace);
    suite_add_tcase(suite, plane);
}
