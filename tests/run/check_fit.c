/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fit finds what a series was made with: without noise to the last digits, with noise within the interval
 * that it states, as often as it states, be the noise white or not; on data of the continuum or of a finer
 * mesh it finds what its mesh makes of them, and says that what is left is no noise. Its runs are those of
 * everybody: with changes in mid-run, ended by rest, refused where they fail; and a minimum one oscillation
 * beside the data is not its answer. */
#include "suite.h"
#include "scenario/settings.h"
#include "answers/fit_search.h"
#include "run/experiment.h"
#include "scenario/changes.h"
#include "scenario/parameters.h"
#include "scenario/scenario.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { COUNT = 60, SEEDS = 30 };

#define END 4.0

static double times[COUNT], values[COUNT], noisy[COUNT];

static void load(Settings *settings)
{
    Status status = {0};
    ck_assert_msg(scenario_load("mode5", settings, &status), "%s", status.text);
    ck_assert(settings_set(settings, "time.end", "4", &status));
}

static FitTask task_of(const Settings *settings)
{
    return (FitTask){.settings = settings,
                     .keys = {"bar.youngs_modulus", "initial.velocity"},
                     .n_keys = 2,
                     .column = "v_cm",
                     .times = times,
                     .values = values,
                     .count = COUNT,
                     .threads = 1};
}

/* Times between the time steps, and a run's values there. */
static void make_data(const char *modulus)
{
    Settings settings;
    Status status = {0};
    load(&settings);
    for (int k = 0; k < COUNT; k++)
        times[k] = END * (k + 0.37) / COUNT;
    ck_assert(settings_set(&settings, "bar.youngs_modulus", modulus, &status));
    Simulation *simulation = problem_simulate(&settings, 1, &status);
    ck_assert_ptr_nonnull(simulation);
    const int column = simulation_find_series(simulation, "v_cm");
    double *row = malloc((size_t)simulation->n_series * sizeof *row);
    simulation_row(simulation, row);
    double before = row[column];
    for (int k = 0; k < COUNT;) {
        ck_assert(simulation_steps(simulation, 1, row, NULL, &status));
        const double now = simulation_time(simulation), dt = simulation->dt;
        for (; k < COUNT && times[k] <= now; k++)
            values[k] = row[column] + (before - row[column]) * (now - times[k]) / dt;
        before = row[column];
    }
    free(row);
    simulation_destroy(simulation);
}

START_TEST(what_a_run_was_made_with_is_found)
{
    Settings settings;
    Status status = {0};
    FitResult result;
    make_data("93");
    load(&settings);
    const FitTask task = task_of(&settings);
    ck_assert_msg(fit_solve(&task, &result, &status), "%s", status.text);
    ck_assert_double_eq_tol(result.values[0], 93, 1e-6);
    ck_assert_double_eq_tol(result.values[1], 0.1, 1e-9);
    ck_assert_double_lt(result.rms, 1e-9);
    ck_assert_double_gt(result.rms_before, 1e-3);
    for (int k = 0; k < COUNT; k++)
        ck_assert_double_eq_tol(result.model[k], values[k], 1e-9);
    fit_free(&result);
}
END_TEST

/* Even numbers in (-1, 1), of Steele, Lea and Flood's generator: neighbouring seeds have nothing in common.
 */
static double even(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9;
    z = (z ^ z >> 27) * 0x94d049bb133111eb;
    return (double)((z ^ z >> 31) >> 11) / 4503599627370496.0 - 1;
}

/* Normal deviates by the polar method: the same on every machine. */
static double normal(uint64_t *state)
{
    double u, v, s;
    do {
        u = even(state);
        v = even(state);
        s = u * u + v * v;
    } while (s >= 1 || s == 0);
    return u * sqrt(-2 * log(s) / s);
}

/* Of intervals of 95 % one or two in thirty miss; five would be one chance in fifty. */
START_TEST(the_interval_holds_as_often_as_it_says)
{
    static const double truth[2] = {93, 0.1};
    Settings settings;
    int held[2] = {0}, white = 0;
    make_data("93");
    load(&settings);
    for (unsigned seed = 1; seed <= SEEDS; seed++) {
        uint64_t state = seed;
        Status status = {0};
        FitResult result;
        for (int k = 0; k < COUNT; k++)
            noisy[k] = values[k] + 5e-4 * normal(&state);
        FitTask task = task_of(&settings);
        task.values = noisy;
        ck_assert_msg(fit_solve(&task, &result, &status), "seed %u: %s", seed, status.text);
        for (int i = 0; i < 2; i++)
            held[i] += fabs(result.values[i] - truth[i]) <= result.noise.half_widths[i];
        ck_assert_double_eq_tol(result.rms, 5e-4, 2e-4);
        white += result.left == FIT_WHITE;
        fit_free(&result);
    }
    ck_assert_int_ge(white, 26);
    for (int i = 0; i < 2; i++)
        ck_assert_msg(held[i] >= 26, "parameter %d within its interval for %d of %d", i, held[i], SEEDS);
}
END_TEST

/* How many of some hundred fits of a straight model, y = a cos(omega t) - b t sin(omega t), hold what they
 * were made with (0, 0) in their intervals; noise whose neighbours hang together by r. `sure` counts those
 * that call it noise, `white` those that find it white. */
typedef struct Coverage {
    int fits, held[2], sure, white;
} Coverage;

static Coverage cover(double r, unsigned seeds, size_t count)
{
    Coverage coverage = {.fits = (int)seeds};
    double *at = malloc(4 * count * sizeof *at), *e = at + count, *slopes = at + 2 * count;
    for (unsigned seed = 1; seed <= seeds; seed++) {
        uint64_t state = 1000 * seed;
        double a[2][2] = {{0}}, b[2] = {0}, x[2], before = normal(&state);
        Noise noise;
        for (size_t k = 0; k < count; k++) {
            at[k] = 6.0 * (double)k / (double)count;
            slopes[2 * k] = cos(5.4 * at[k]);
            slopes[2 * k + 1] = -at[k] * sin(5.4 * at[k]);
            e[k] = before;
            before = r * before + sqrt(1 - r * r) * normal(&state);
            for (int i = 0; i < 2; i++) {
                b[i] += slopes[2 * k + (size_t)i] * e[k];
                for (int j = 0; j < 2; j++)
                    a[i][j] += slopes[2 * k + (size_t)i] * slopes[2 * k + (size_t)j];
            }
        }
        const double determinant = a[0][0] * a[1][1] - a[0][1] * a[1][0];
        x[0] = (a[1][1] * b[0] - a[0][1] * b[1]) / determinant;
        x[1] = (a[0][0] * b[1] - a[1][0] * b[0]) / determinant;
        for (size_t k = 0; k < count; k++)
            e[k] -= x[0] * slopes[2 * k] + x[1] * slopes[2 * k + 1];
        ck_assert(noise_judge(at, e, slopes, count, 2, &noise));
        for (int i = 0; i < 2; i++)
            coverage.held[i] += fabs(x[i]) <= noise.half_widths[i];
        coverage.sure += noise.chance >= 1e-3;
        coverage.white += noise.white >= 0.05;
    }
    free(at);
    return coverage;
}

/* 300 intervals of 95 %: 285 +- 3.8 hold; 274 and 296 are some 3 of these away. */
START_TEST(intervals_hold_for_white_noise_and_for_noise_that_lasts)
{
    static const double lasting[] = {0, 0.5, 0.9};
    for (int i = 0; i < 3; i++) {
        const Coverage coverage = cover(lasting[i], 300, 120);
        for (int j = 0; j < 2; j++)
            ck_assert_msg(coverage.held[j] >= 274 && coverage.held[j] <= 296, "r %g: parameter %d in %d",
                          lasting[i], j, coverage.held[j]);
        ck_assert_int_ge(coverage.sure, 295);
        ck_assert_msg(i > 0 ? coverage.white <= 15 : coverage.white >= 275, "r %g: %d white", lasting[i],
                      coverage.white);
    }
    const Coverage few = cover(0.9, 300, 40);
    for (int j = 0; j < 2; j++)
        ck_assert_msg(few.held[j] >= 274, "of few: parameter %d in %d", j, few.held[j]);
}
END_TEST

/* In which order three parameters stand changes nothing, though noise that lasts hangs their columns
 * together. */
START_TEST(the_order_of_parameters_is_of_no_account)
{
    enum { ROWS = 60 };
    static const int turned[3] = {2, 0, 1};
    double at[ROWS], e[ROWS], slopes[3 * ROWS], others[3 * ROWS];
    uint64_t state = 7;
    double before = normal(&state);
    for (int k = 0; k < ROWS; k++) {
        double *row = slopes + 3 * k;
        at[k] = 0.1 * k;
        row[0] = cos(2 * at[k]);
        row[1] = at[k] * sin(2 * at[k]);
        row[2] = 1 + 0.3 * at[k];
        for (int i = 0; i < 3; i++)
            others[3 * k + i] = row[turned[i]];
        e[k] = before;
        before = 0.7 * before + sqrt(1 - 0.7 * 0.7) * normal(&state);
    }
    Noise as_given, in_turn;
    ck_assert(noise_judge(at, e, slopes, ROWS, 3, &as_given));
    ck_assert(noise_judge(at, e, others, ROWS, 3, &in_turn));
    ck_assert_double_gt(as_given.correlation, 0.4);
    ck_assert_double_eq_tol(in_turn.correlation, as_given.correlation, 1e-6);
    for (int i = 0; i < 3; i++) {
        const double width = as_given.half_widths[turned[i]];
        ck_assert_double_eq_tol(in_turn.half_widths[i], width, 1e-5 * width);
        for (int j = 0; j < 3; j++)
            ck_assert_double_eq_tol(in_turn.correlations[i][j], as_given.correlations[turned[i]][turned[j]],
                                    1e-5);
    }
}
END_TEST

/* The series of a run by the laboratory, of every so many steps. */
static FitTask record(const Settings *settings, const char *column, long every, double *at, double *value,
                      size_t room)
{
    Status status = {0};
    Experiment *experiment = experiment_create(settings, (size_t)1 << 20, 1, &status);
    ck_assert_msg(experiment != NULL, "%s", status.text);
    ck_assert(experiment_advance(experiment, experiment_last_step(experiment), &status));
    const Record *rows = experiment_record(experiment);
    int n = 0, y = -1;
    const Column *columns = experiment_columns(experiment, &n);
    for (int i = 0; i < n; i++)
        if (strcmp(columns[i].quantity.name, column) == 0)
            y = i;
    FitTask task = {.column = column, .times = at, .values = value, .n_keys = 1, .threads = 1};
    for (size_t k = 0; k < rows->count && task.count < room; k += (size_t)every) {
        at[task.count] = record_row(rows, k)[1];
        value[task.count++] = record_row(rows, k)[y];
    }
    experiment_destroy(experiment);
    return task;
}

static void open_run(Settings *settings, const char *scenario, const char *const (*keys)[2])
{
    Status status = {0};
    ck_assert_msg(scenario_load(scenario, settings, &status), "%s", status.text);
    for (int i = 0; keys[i][0]; i++)
        ck_assert_msg(settings_set(settings, keys[i][0], keys[i][1], &status), "%s", status.text);
}

static double at[400], value[400];

/* A load that comes in mid-run. */
START_TEST(changes_in_mid_run_are_those_of_the_run)
{
    Settings settings;
    Status status = {0};
    FitResult result;
    open_run(&settings, "mode1", (const char *const[][2]){{"time.end", "8"}, {NULL, NULL}});
    ck_assert(changes_add(&settings, 500, "load.body_force", "0.01", &status));
    FitTask task = record(&settings, "v_cm", 4, at, value, 400);
    ck_assert(settings_set(&settings, "bar.youngs_modulus", "110", &status));
    task.settings = &settings;
    task.keys[0] = "bar.youngs_modulus";
    ck_assert_msg(fit_solve(&task, &result, &status), "%s", status.text);
    ck_assert_double_eq_tol(result.values[0], 100, 1e-6);
    ck_assert_double_lt(result.rms, 1e-12);
    ck_assert_int_eq(result.left, FIT_NOTHING);
    fit_free(&result);
}
END_TEST

/* A beam hangs still before the data end: it stays as it hangs. */
START_TEST(a_run_that_comes_to_rest_ends_there)
{
    static const char *const coarse[][2] = {
        {"pd.spacing", "2.5e-3"}, {"pd.horizon", "8e-3"}, {"time.step", "auto"}, {NULL, NULL}};
    Settings settings;
    Status status = {0};
    FitResult result;
    open_run(&settings, "hanging-beam", coarse);
    FitTask task = record(&settings, "u_probe", 64, at, value, 390);
    const double last = at[task.count - 1];
    ck_assert_double_lt(last, 3e-3);
    for (int i = 0; i < 8; i++, task.count++) {
        at[task.count] = last * (1.2 + 0.02 * i);
        value[task.count] = value[task.count - 1];
    }
    ck_assert(settings_set(&settings, "load.body_force", "-9", &status));
    task.settings = &settings;
    task.keys[0] = "load.body_force";
    ck_assert_msg(fit_solve(&task, &result, &status), "%s", status.text);
    ck_assert_double_eq_tol(result.values[0], -9.81, 1e-5);
    ck_assert_double_eq_tol(result.model[task.count - 1], value[task.count - 1],
                            1e-5 * fabs(value[task.count - 1]));
    fit_free(&result);
}
END_TEST

/* What fails as a run is not a fit: it says where, and ends. */
START_TEST(a_run_that_fails_is_told)
{
    static const char *const wild[][2] = {
        {"time.end", "40"}, {"time.unstable", "yes"}, {"time.courant", "2"}, {NULL, NULL}};
    Settings settings;
    Status status = {0};
    FitResult result;
    make_data("100");
    open_run(&settings, "mode5", wild);
    FitTask task = task_of(&settings);
    times[COUNT - 1] = 40;
    ck_assert(!fit_solve(&task, &result, &status));
    ck_assert_int_eq(status.code, STATUS_FAILED);
    ck_assert_msg(strstr(status.text, "step") != NULL, "%s", status.text);
    fit_free(&result);
}
END_TEST

/* Between 90 and 100 the run oscillates once less: a search from 100 alone ends at 104.1, with residuals as
 * large as the data. */
START_TEST(a_minimum_one_oscillation_beside_is_not_the_answer)
{
    Settings settings;
    Status status = {0};
    FitResult result;
    open_run(&settings, "mode5",
             (const char *const[][2]){{"time.end", "20"}, {"bar.youngs_modulus", "90"}, {NULL, NULL}});
    FitTask task = record(&settings, "v_cm", 10, at, value, 400);
    ck_assert(settings_set(&settings, "bar.youngs_modulus", "100", &status));
    task.settings = &settings;
    task.keys[0] = "bar.youngs_modulus";
    ck_assert_msg(fit_solve(&task, &result, &status), "%s", status.text);
    ck_assert_double_eq_tol(result.values[0], 90, 1e-6);
    ck_assert_int_gt(result.beginnings, 4);
    fit_free(&result);

    /* farther away, where the data cannot tell the frequency from another: fewer than two in an oscillation
     */
    ck_assert(settings_set(&settings, "bar.youngs_modulus", "70", &status));
    task = record(&settings, "v_cm", 10, at, value, 400);
    ck_assert(settings_set(&settings, "bar.youngs_modulus", "100", &status));
    task.settings = &settings;
    task.keys[0] = "bar.youngs_modulus";
    for (size_t k = 0; k < task.count / 8; k++) {
        at[k] = at[8 * k];
        value[k] = value[8 * k];
    }
    task.count /= 8;
    ck_assert_msg(fit_solve(&task, &result, &status), "%s", status.text);
    ck_assert_double_eq_tol(result.values[0], 70, 1e-6);
    fit_free(&result);
}
END_TEST

/* A row every 37 steps: fewer than two in an oscillation of the run that the search begins with, so that its
 * frequency is an alias of the data's, which is the right one. Where noise hides what else differs the other
 * is told. */
START_TEST(an_alias_is_not_taken_for_the_answer)
{
    static const char *const moduli[] = {"12", "25", "37"};
    Settings settings;
    Status status = {0};
    FitResult result;
    for (int i = 0; i < 3; i++) {
        open_run(&settings, "mode5",
                 (const char *const[][2]){{"bar.youngs_modulus", moduli[i]}, {NULL, NULL}});
        FitTask task = record(&settings, "v_cm", 37, at, value, 400);
        ck_assert(settings_set(&settings, "bar.youngs_modulus", "100", &status));
        task.settings = &settings;
        task.keys[0] = "bar.youngs_modulus";
        ck_assert_msg(fit_solve(&task, &result, &status), "%s", status.text);
        ck_assert_double_eq_tol(result.values[0], atof(moduli[i]), 1e-6);
        ck_assert_int_eq(result.n_others, 0);
        fit_free(&result);
        if (i != 1)
            continue;
        uint64_t state = 5;
        char told[1024];
        task.count = 50;
        for (size_t k = 0; k < task.count; k++)
            value[k] += 2e-3 * normal(&state);
        ck_assert_msg(fit_solve(&task, &result, &status), "%s", status.text);
        bool mine = fabs(result.values[0] - 25) < 0.5, other = fabs(result.values[0] - 114) < 2;
        for (int k = 0; k < result.n_others; k++) {
            mine = mine || fabs(result.others[k].values[0] - 25) < 0.5;
            other = other || fabs(result.others[k].values[0] - 114) < 2;
        }
        fit_tell(&task, &result, told, sizeof told);
        ck_assert_msg(mine && other && strstr(told, "other minima are as deep"), "%s", told);
        fit_free(&result);
    }
}
END_TEST

/* Data of a mesh a quarter as fine ask for more than a tenth more than they were made with; what is left
 * tells that they are of something else. */
START_TEST(data_of_a_finer_mesh_leave_no_noise)
{
    Settings settings;
    Status status = {0};
    FitResult result;
    char told[1024];
    open_run(&settings, "mode5",
             (const char *const[][2]){
                 {"time.end", "5"}, {"bar.youngs_modulus", "93"}, {"mesh.cell_size", "0.5"}, {NULL, NULL}});
    FitTask task = record(&settings, "v_cm", 8, at, value, 400);
    ck_assert(settings_set(&settings, "mesh.cell_size", "1", &status));
    ck_assert(settings_set(&settings, "bar.youngs_modulus", "100", &status));
    task.settings = &settings;
    task.keys[0] = "bar.youngs_modulus";
    ck_assert_msg(fit_solve(&task, &result, &status), "%s", status.text);
    ck_assert_double_gt(result.values[0] - result.noise.half_widths[0], 98);
    ck_assert_int_eq(result.left, FIT_NO_NOISE);
    fit_tell(&task, &result, told, sizeof told);
    ck_assert_ptr_nonnull(strstr(told, "the intervals do not hold"));
    fit_free(&result);
}
END_TEST

/* On this mesh the fifth mode of a bar with E oscillates at .9576 of its frequency, and frequencies go with
 * the root of E: data of the continuum ask for E/.9576^2. */
START_TEST(data_of_the_continuum_ask_for_a_stiffer_bar)
{
    Settings settings;
    Status status = {0};
    FitResult result;
    const double exact = 5.654866776461628, predicted = 5.415168088;
    make_data("100");
    load(&settings);
    for (int k = 0; k < COUNT; k++)
        values[k] = 0.0070735530263064 * cos(exact * times[k]);
    const FitTask task = task_of(&settings);
    ck_assert_msg(fit_solve(&task, &result, &status), "%s", status.text);
    ck_assert_double_eq_tol(result.values[0] / 100, pow(exact / predicted, 2), 5e-3);
    ck_assert_double_lt(result.rms, 0.02 * 0.00707);
    fit_free(&result);
}
END_TEST

static void refused(FitTask task, const char *why)
{
    Status status = {0};
    FitResult result;
    ck_assert(!fit_solve(&task, &result, &status));
    ck_assert_ptr_nonnull(strstr(status.text, why));
    ck_assert_int_eq(status.code, STATUS_USAGE);
    fit_free(&result);
}

START_TEST(what_cannot_be_fitted_is_refused)
{
    Settings settings;
    make_data("100");
    load(&settings);
    FitTask task = task_of(&settings);
    task.keys[1] = "mpm.shape";
    refused(task, "mpm.shape: is not a real number");
    task.keys[1] = "beam.length";
    refused(task, "beam.length: this run has no such parameter");
    task.keys[1] = task.keys[0];
    refused(task, "bar.youngs_modulus: is named twice");
    task.keys[1] = "load.traction";
    refused(task, "load.traction: is 0 at the start");
    task.n_keys = 1;
    task.keys[0] = "time.end";
    refused(task, "time.end: changes nothing of v_cm in these data");
    task.count = 1;
    refused(task, "1 data are too few for 1 parameters");
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("fit");
    tcase_add_test(tcase, what_a_run_was_made_with_is_found);
    tcase_add_test(tcase, the_interval_holds_as_often_as_it_says);
    tcase_add_test(tcase, the_order_of_parameters_is_of_no_account);
    if (suite_wide()) /* 1,200 fits */
        tcase_add_test(tcase, intervals_hold_for_white_noise_and_for_noise_that_lasts);
    tcase_add_test(tcase, changes_in_mid_run_are_those_of_the_run);
    tcase_add_test(tcase, a_run_that_comes_to_rest_ends_there);
    tcase_add_test(tcase, a_run_that_fails_is_told);
    tcase_add_test(tcase, a_minimum_one_oscillation_beside_is_not_the_answer);
    tcase_add_test(tcase, an_alias_is_not_taken_for_the_answer);
    tcase_add_test(tcase, data_of_a_finer_mesh_leave_no_noise);
    tcase_add_test(tcase, data_of_the_continuum_ask_for_a_stiffer_bar);
    tcase_add_test(tcase, what_cannot_be_fitted_is_refused);
    suite_add_tcase(suite, tcase);
}
