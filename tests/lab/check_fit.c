/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The fit finds what a series was made with: without noise to the last digits, with noise within the interval
 * that it states, as often as it states; on data of the continuum it finds what the mesh makes of them. */
#include "tests/suite.h"

#include "lab/answers/fit.h"
#include "lab/settings/parameters.h"
#include "lab/settings/scenario.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { COUNT = 60, SEEDS = 100 };

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

/* Of intervals of 95 % some five in a hundred miss; twelve would be two chances in a thousand. */
START_TEST(the_interval_holds_as_often_as_it_says)
{
    static const double truth[2] = {93, 0.1};
    Settings settings;
    int held[2] = {0};
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
            held[i] += fabs(result.values[i] - truth[i]) <= result.half_widths[i];
        ck_assert_double_eq_tol(result.rms, 5e-4, 2e-4);
        fit_free(&result);
    }
    for (int i = 0; i < 2; i++)
        ck_assert_msg(held[i] >= 89 && held[i] < SEEDS, "parameter %d within its interval for %d of %d", i,
                      held[i], SEEDS);
}
END_TEST

/* On this mesh the fifth mode of a bar with E swings at .9576 of its frequency, and frequencies go with the
 * root of E: data of the continuum ask for E/.9576^2. */
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
    refused(task, "mpm.shape: is no real number");
    task.keys[1] = "beam.length";
    refused(task, "beam.length: this run has no such parameter");
    task.keys[1] = task.keys[0];
    refused(task, "bar.youngs_modulus: is named twice");
    task.keys[1] = "load.traction";
    refused(task, "load.traction: is 0 at the start");
    task.n_keys = 1;
    task.count = 1;
    refused(task, "1 data are too few for 1 parameters");
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("fit");
    tcase_add_test(tcase, what_a_run_was_made_with_is_found);
    tcase_add_test(tcase, the_interval_holds_as_often_as_it_says);
    tcase_add_test(tcase, data_of_the_continuum_ask_for_a_stiffer_bar);
    tcase_add_test(tcase, what_cannot_be_fitted_is_refused);
    suite_add_tcase(suite, tcase);
}
