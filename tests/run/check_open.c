/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The house is open: a parameter, a scenario, a problem and its method are each added from here, through the
 * public tables alone. The tables of this program stand in the place of the program's own: they hold what
 * those hold, and a row more. What is in no table knows nothing of it.
 *
 * The parameter is a damping that the engines ignore. No reference accounts for it, so each of them has to
 * leave by itself where it is at work: column, curve, profile, verdict, invariant, limit. */
#include "answers/dispersion_curves.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "answers/references.h"
#include "answers/summary.h"
#include "run/lab_case.h"
#include "scenario/changes.h"
#include "scenario/parameter_table.h"
#include "scenario/scenario.h"
#include "picture/canvas.h"
#include "plate.h"
#include "suite.h"
#include "views/scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- a parameter: one row ------------------------------------------------------------------------- */

#define DAMPING                                                                                              \
    "damping", "1/time", "1/s", PARAMETER_REAL, FROM_ZERO,                                                   \
        .nudge = NUDGE_1_2_5, .live = true, .help = "share of the velocity lost in a unit of time"

const Parameter parameters[] = {
#include "scenario/parameter_rows.inc"
    {"mpm.damping", CONCERN_MESH, "Method", DAMPING, .methods = BY_MPM, AT(motion.speed)},
    {"pd.damping", CONCERN_LATTICE, "Lattice", DAMPING, .methods = BY_PD, AT(notch.position)},
};
const int n_parameters = (int)(sizeof parameters / sizeof *parameters);

/* --- a method and a problem: a solver and a row ----------------------------------------------------- */

enum { COLUMNS = 21, ROWS = 11 };

static bool check(const Settings *settings, Status *status)
{
    return problem_check_steps(settings_time(settings)->end, 0.01, status);
}

static Simulation *simulate(const Settings *settings, int threads, Status *status)
{
    (void)settings, (void)threads, (void)status;
    return plate_create(COLUMNS, ROWS, 0);
}

static const Solver membrane_by_springs = {.method = METHOD_PD, .check = check, .simulate = simulate};
static const Solver *const solvers[] = {&membrane_by_springs, NULL};
static const ParameterUse uses[] = {{.key = "time.end", .usual = 2}};
static const Problem membrane_problem = {
    .word = "membrane",
    .title = "vibration of a membrane",
    .uses = uses,
    .n_uses = 1,
    .solvers = solvers,
    .unit_of_time = "time",
    .shown_time = 1,
    .shown_time_unit = "",
};

const Problem *const problems[] = {
    &problem_bar,          &problem_supported_beam, &problem_moving_cantilever,
    &problem_notched_beam, &membrane_problem,       NULL,
};

/* --- a scenario: one text --------------------------------------------------------------------------- */

const BuiltinScenario builtin_scenarios[] = {
    {"planted", "[scenario]\ntitle = A bar and a parameter more\nproblem = bar\n[initial]\nmode = 5\n"},
    {"membrane", "[scenario]\ntitle = A problem more\nproblem = membrane\n[time]\nend = 1\n"},
    {NULL, NULL},
};

/* --- what comes of them ------------------------------------------------------------------------------ */

static Settings load(const char *name, const char *key, const char *value)
{
    Settings settings;
    Status status = {0};
    ck_assert_msg(scenario_load(name, &settings, &status), "%s", status.text);
    if (key)
        set(&settings, key, value);
    return settings;
}

static bool has_column(const Experiment *experiment, const char *name)
{
    int n;
    const Column *columns = experiment_columns(experiment, &n);
    for (int i = 0; i < n; i++)
        if (strcmp(columns[i].quantity.name, name) == 0)
            return true;
    return false;
}

static bool has_derived(Experiment *experiment, const char *name)
{
    Derived derived[DERIVED_MAX];
    const int n = experiment_derived(experiment, derived);
    for (int i = 0; i < n; i++)
        if (strcmp(derived[i].name, name) == 0)
            return true;
    return false;
}

static bool log_tells(Experiment *experiment, const char *text)
{
    int n;
    const Event *events = experiment_events(experiment, &n);
    for (int i = 0; i < n; i++)
        if (strstr(events[i].text, text))
            return true;
    return false;
}

static bool summary_tells(Experiment *experiment, const char *text)
{
    RunSummary summary;
    char out[SUMMARY_MAX];
    summary_of(experiment, &summary);
    summary_text(&summary, experiment_settings(experiment), out);
    return strstr(out, text) != NULL;
}

/* All that a bar's run knows, or all that it does not. */
static void expect_known(Experiment *experiment, bool known)
{
    double now, start, frequency = experiment_readout(experiment)->exact;
    const Readout *readout = experiment_readout(experiment);
    const References *refs = experiment_references(experiment);
    ModeOnMesh mode;
    ck_assert(has_column(experiment, "v_cm"));
    ck_assert(has_column(experiment, "v_cm_exact") == known);
    ck_assert(has_column(experiment, "v_cm_predicted") == known);
    ck_assert(isfinite(references_profile(refs, "u", 10, 1)) == known);
    ck_assert(readout->measured_known == known && readout->exact_known == known);
    ck_assert(readout->predicted_known == known && isfinite(readout->late) == known);
    ck_assert(isfinite(frequency) == known && isfinite(readout->error_frequency) == known);
    ck_assert(experiment_invariant(experiment, &now, &start) == known);
    ck_assert(dispersion_mode(experiment_settings(experiment), 5, &mode) == known);
    ck_assert(has_derived(experiment, "omega") == known &&
              has_derived(experiment, "omega_predicted") == known);
    ck_assert(has_derived(experiment, "largest_courant") == known && has_derived(experiment, "dt"));
    ck_assert(log_tells(experiment, "behind exact") == known);
    ck_assert(log_tells(experiment, "not known with") == !known);
    ck_assert(summary_tells(experiment, "not known with") == !known);
}

START_TEST(answers_leave_where_a_stranger_is_at_work)
{
    Settings settings = load("planted", NULL, NULL);
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    ck_assert(experiment_advance(experiment, 5000, NULL));
    expect_known(experiment, true);

    /* a live parameter at its neutral value is not there; at another it takes all answers along */
    Settings wanted = *experiment_settings(experiment);
    set(&wanted, "mpm.damping", "0.5");
    ck_assert(experiment_rerun(experiment, &wanted, NULL));
    finish_work(experiment);
    ck_assert_int_eq(experiment_newest(experiment), 5000);
    expect_known(experiment, false);
    static const char all[] = "exact, predicted, frequency, energy E*: not known with mpm.damping";
    ck_assert(log_tells(experiment, all) && summary_tells(experiment, all));
    ck_assert(summary_tells(experiment, "frequency  not known with mpm.damping"));
    ck_assert_str_eq(experiment_readout(experiment)->unaccounted, "mpm.damping");

    wanted = *experiment_settings(experiment);
    set(&wanted, "mpm.damping", "0");
    ck_assert(experiment_rerun(experiment, &wanted, NULL));
    finish_work(experiment);
    expect_known(experiment, true);
    experiment_destroy(experiment);
}
END_TEST

START_TEST(answers_leave_where_a_stranger_comes_on_the_way)
{
    Settings settings = load("planted", NULL, NULL);
    ck_assert(changes_add(&settings, 1000, "mpm.damping", "0.5", NULL));
    ck_assert_str_eq(answer_invalid_because(&settings, REFERENCE_EXACT), "mpm.damping");
    ck_assert_ptr_null(answer_unaccounted_now(&settings, REFERENCE_EXACT));
    long step;
    char text[KNOWN_TEXT_MAX];
    ck_assert(answers_known_text(&settings, text, &step));
    ck_assert_int_eq(step, 1000);
    /* what is known to leave the continuum alone takes only the prediction along */
    Settings usl = load("planted", NULL, NULL);
    ck_assert(changes_add(&usl, 1000, "mpm.algorithm", "usl", NULL));
    ck_assert(answers_known_text(&usl, text, NULL));
    ck_assert_str_eq(text, "predicted: not known with mpm.algorithm");
}
END_TEST

/* A key that is written wrong would be understood by nobody. */
START_TEST(keys_are_those_of_parameters)
{
    for (int p = 0; problems[p]; p++)
        for (int s = 0; problems[p]->solvers[s]; s++)
            for (int r = 0; r < REFERENCES; r++) {
                const Validity *known = &problems[p]->solvers[s]->validity[r];
                for (int i = 0; known->keys && known->keys[i]; i++)
                    ck_assert_msg(parameter_find(known->keys[i]) != NULL, "%s", known->keys[i]);
                for (int i = 0; known->changes && known->changes[i]; i++) {
                    const Parameter *parameter = parameter_find(known->changes[i]);
                    ck_assert_msg(parameter && parameter->live, "%s", known->changes[i]);
                }
            }
    for (int p = 0; problems[p]; p++)
        for (int i = 0; i < problems[p]->n_uses; i++) {
            const Parameter *parameter = parameter_find(problems[p]->uses[i].key);
            ck_assert_msg(parameter && parameter_applies(parameter, problems[p]), "%s",
                          problems[p]->uses[i].key);
        }
}
END_TEST

/* No limit is known either: what would be refused without it is left to the run. */
START_TEST(a_limit_leaves_too)
{
    Settings settings = load("planted", "time.courant", "2.5");
    char advice[160];
    ck_assert(!problem_advice(&settings, advice, sizeof advice, NULL));
    set(&settings, "mpm.damping", "0.5");
    ck_assert(problem_advice(&settings, advice, sizeof advice, NULL));
}
END_TEST

START_TEST(beam_theory_leaves_too)
{
    static const struct {
        const Problem *problem;
        const char *column;
    } beams[] = {{&problem_supported_beam, "u_timoshenko"}, {&problem_moving_cantilever, "u_modal"}};
    static const char *const keys[] = {"pd.damping", "pd.critical_stretch"};
    for (int i = 0; i < 4; i++) {
        const Problem *problem = beams[i / 2].problem;
        const char *key = keys[i % 2];
        Settings settings = beam_settings(problem, 2e-5);
        Experiment *experiment = open_experiment(&settings, 1 << 22);
        ck_assert(has_column(experiment, beams[i / 2].column));
        experiment_destroy(experiment);
        set(&settings, key, "0.4");
        experiment = open_experiment(&settings, 1 << 22);
        ck_assert(experiment_advance(experiment, 5, NULL));
        ck_assert(!has_column(experiment, beams[i / 2].column));
        ck_assert(!experiment_readout(experiment)->exact_known);
        ck_assert(isnan(references_envelope(experiment_references(experiment), "u_probe", 0)));
        ck_assert(log_tells(experiment, key) && summary_tells(experiment, key));
        experiment_destroy(experiment);
    }
}
END_TEST

/* A filter looks back over rows; those of the run so far stay as they were when theory leaves beside it. */
START_TEST(theory_leaves_a_filter_alone)
{
    Settings settings = beam_settings(&problem_moving_cantilever, 2e-4);
    Experiment *experiment = open_experiment(&settings, 1 << 22),
               *whole = open_experiment(&settings, 1 << 22);
    const long half = experiment_last_step(experiment) / 2;
    ck_assert(experiment_advance(experiment, half, NULL) && experiment_advance(whole, 2 * half, NULL));
    Settings wanted = *experiment_settings(experiment);
    set(&wanted, "pd.critical_stretch", "0.4"); /* nothing breaks */
    ck_assert(experiment_edit(experiment, &wanted, NULL));
    ck_assert(!has_column(experiment, "u_modal") && has_column(experiment, "v_filtered"));
    ck_assert(experiment_advance(experiment, half, NULL));
    int n, all, filtered = -1, filtered_whole = -1;
    const Column *columns = experiment_columns(experiment, &n),
                 *columns_whole = experiment_columns(whole, &all);
    for (int i = 0; i < n; i++)
        filtered = strcmp(columns[i].quantity.name, "v_filtered") == 0 ? i : filtered;
    for (int i = 0; i < all; i++)
        filtered_whole = strcmp(columns_whole[i].quantity.name, "v_filtered") == 0 ? i : filtered_whole;
    for (long step = 0; step <= 2 * half; step++)
        ck_assert(record_of_step(experiment_record(experiment), step)[filtered] ==
                  record_of_step(experiment_record(whole), step)[filtered_whole]);
    experiment_destroy(experiment);
    experiment_destroy(whole);
}
END_TEST

START_TEST(a_parameter_is_written_and_read)
{
    Settings settings = load("planted", "mpm.damping", "0.25"), back;
    FILE *file = tmpfile();
    ck_assert(scenario_write(file, &settings, NULL, NULL));
    rewind(file);
    ck_assert(scenario_read(file, "f", &back, NULL));
    fclose(file);
    ck_assert(settings_same(&settings, &back));
    ck_assert_double_eq(settings_number(&back, parameter_find("mpm.damping")), 0.25);
    Status status;
    set(&settings, "scenario.method", "pd");
    ck_assert(!settings_set(&settings, "mpm.damping", "1", &status));
    ck_assert_str_eq(status.text, "mpm.damping: is not a parameter of method pd (only of mpm)");
}
END_TEST

START_TEST(the_screen_says_so)
{
    Scene scene = {0};
    Status status = {0};
    ck_assert_msg(scene_open(&scene, "planted 80x24 2000 lower 2 mpm.damping=0.5", &status), "%s",
                  status.text);
    char *text = canvas_dump(&scene.canvas);
    ck_assert_msg(strstr(text, "not known with mpm.damping") != NULL, "%s", text);
    free(text);
    scene_close(&scene);
}
END_TEST

START_TEST(a_problem_is_solved)
{
    Settings settings = load("membrane", NULL, NULL);
    ck_assert_ptr_eq(settings.problem, problem_find("membrane"));
    ck_assert_double_eq(settings_time(&settings)->end, 1);
    Status status;
    ck_assert(!settings_set(&settings, "bar.length", "1", &status));
    ck_assert_str_eq(status.text, "bar.length: is not a parameter of problem membrane (only of bar)");
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    ck_assert(experiment_advance(experiment, 1000000, NULL));
    ck_assert(experiment_at_end(experiment) && experiment_record(experiment)->count > 2);
    ck_assert(!log_tells(experiment, "not known") && !summary_tells(experiment, "not known"));
    ck_assert(summary_tells(experiment, "nothing vibrates"));
    experiment_destroy(experiment);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *open = tcase_create("open");
    tcase_add_test(open, answers_leave_where_a_stranger_is_at_work);
    tcase_add_test(open, answers_leave_where_a_stranger_comes_on_the_way);
    tcase_add_test(open, keys_are_those_of_parameters);
    tcase_add_test(open, a_limit_leaves_too);
    tcase_add_test(open, beam_theory_leaves_too);
    tcase_add_test(open, theory_leaves_a_filter_alone);
    tcase_add_test(open, a_parameter_is_written_and_read);
    tcase_add_test(open, the_screen_says_so);
    tcase_add_test(open, a_problem_is_solved);
    suite_add_tcase(suite, open);
}
