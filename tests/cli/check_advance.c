/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Time passes in one way, whoever asks for it: a run with changes in mid-run, one that comes to rest, one
 * that fails and one that is given up, by the laboratory (by steps, stages and items), the export, the fit
 * and the verification, against a loop of stages in this file that is none of theirs. The same bits. */
#include "answers/fit_internal.h"
#include "scenario/concern_output.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "base/text.h"
#include "cli/verify/verify.h"
#include "export/export.h"
#include "problems/problem.h"
#include "run/lab_case.h"
#include "scenario/scenario.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { ROWS_MAX = 16384 };

/* A scenario, what is set of it, the column that is compared, and how it is to end. */
static const struct {
    const char *scenario;
    const char *sets[6];
    const char *changes[4]; /* STEP KEY VALUE by hand, in the order of time */
    const char *column;
    bool rests, fails;
} cases[] = {
    {"mode1", {"time.end=3"}, {"40 load.body_force 0.01", "41 mpm.flip_fraction 0.9"}, "v_cm", false, false},
    {"mode1",
     {"time.end=3", "output.every=7"},
     {"0 mpm.algorithm usl", "139 mpm.flip_fraction 0.9",
      "210 mpm.algorithm usf"}, /* a row is due behind 139 */
     "v_cm",
     false,
     false},
    {"mode1", {"time.end=2", "scenario.method=pd"}, {"33 load.body_force 0.01"}, "v_cm", false, false},
    {"hanging-beam",
     {"pd.spacing=2.5e-3", "pd.horizon=8e-3", "time.step=auto", "output.every=1"},
     {NULL},
     "u_probe",
     true,
     false},
    {"mode5",
     {"time.end=40", "bar.supports=free-free", "initial.mode=0", "initial.velocity=1", "mesh.padding=1"},
     {NULL},
     "v_cm",
     false,
     true},
};
enum { CASES = sizeof cases / sizeof *cases };

/* What the loop here says: the column at each step, and the last one that is sound. */
static double expected[ROWS_MAX];
static long last;
static Settings settings;
static char folder[] = "/tmp/check_advance.XXXXXX", file[64];

static void change(Simulation *sim, const char *text)
{
    char key[64], value[64];
    long step;
    ck_assert_int_eq(sscanf(text, "%ld %63s %63s", &step, key, value), 3);
    if (step != sim->step)
        return;
    Settings then = settings;
    Status status = {0};
    then.n_changes = 0;
    ck_assert(settings_set(&then, key, value, &status));
    ck_assert_msg(sim->method->change(sim, key, settings_number(&then, parameter_find(key)), &status), "%s",
                  status.text);
}

static void expect_by_hand(int k)
{
    Status status = {0};
    double row[COLUMNS_MAX];
    Simulation *sim = problem_simulate(&settings, 1, &status);
    ck_assert_msg(sim != NULL, "%s", status.text);
    const int column = simulation_find_series(sim, cases[k].column);
    const long end = problem_last_step(sim->dt, settings_time(&settings)->end);
    ck_assert_int_lt(end, ROWS_MAX);
    bool sound = true;
    for (last = 0; sound; last++) {
        simulation_row(sim, row);
        expected[last] = row[column];
        for (int i = 0; i < 4 && cases[k].changes[i]; i++)
            change(sim, cases[k].changes[i]);
        if (sim->step >= end || sim->at_rest)
            break;
        do
            sound = simulation_stage(sim, &status);
        while (sound && sim->stage != 0);
        last -= !sound;
    }
    ck_assert(sim->at_rest == cases[k].rests && sound == !cases[k].fails);
    ck_assert(last > 20 && (last < end) == (cases[k].rests || cases[k].fails));
    simulation_destroy(sim);
}

static void open_case(int k)
{
    Status status = {0};
    strcpy(folder, "/tmp/check_advance.XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(file, sizeof file, "%s/case.ini", folder);
    ck_assert_msg(scenario_load(cases[k].scenario, &settings, &status), "%s", status.text);
    for (int i = 0; i < 6 && cases[k].sets[i]; i++) {
        char key[64];
        const char *value = strchr(cases[k].sets[i], '=') + 1;
        snprintf(key, sizeof key, "%.*s", (int)(value - 1 - cases[k].sets[i]), cases[k].sets[i]);
        set(&settings, key, value);
    }
    for (int i = 0; i < 4 && cases[k].changes[i]; i++) {
        Change *to = &settings.changes[settings.n_changes++];
        char key[64], value[64];
        ck_assert_int_eq(sscanf(cases[k].changes[i], "%ld %63s %63s", &to->step, key, value), 3);
        strcpy(to->to.key, key);
        strcpy(to->to.value, value);
    }
    FILE *stream = fopen(file, "w");
    ck_assert_msg(scenario_write(stream, &settings, NULL, &status), "%s", status.text);
    fclose(stream);
    expect_by_hand(k);
}

static void close_case(void)
{
    unlink(file);
    ck_assert_int_eq(rmdir(folder), 0); /* nothing else is left behind */
}

/* --- the laboratory --------------------------------------------------------------------------------- */

static void expect_record(const Experiment *experiment, const char *column)
{
    const Record *record = experiment_record(experiment);
    const int at = column_of(experiment, column);
    ck_assert_int_eq(experiment_newest(experiment), last);
    ck_assert_uint_eq(record->count, (size_t)last + 1);
    for (long step = 0; step <= last; step++)
        ck_assert_msg(record_row(record, (size_t)step)[at] == expected[step],
                      "step %ld: %.17g, by hand %.17g", step, record_row(record, (size_t)step)[at],
                      expected[step]);
}

/* By 7 steps, by stages, by a few items of them, and by all three in turn. */
START_TEST(the_laboratory_is_one_of_them)
{
    const int k = _i / 4;
    open_case(k);
    Experiment *experiment = open_experiment(&settings, 1 << 20);
    bool sound = true;
    for (long i = 0; sound && !experiment_at_end(experiment); i++) {
        bool whole = false;
        if (_i % 4 == 0 || (_i % 4 == 3 && i % 3 == 0))
            sound = experiment_advance(experiment, 7, NULL);
        else if (_i % 4 == 1 || (_i % 4 == 3 && i % 3 == 1))
            sound = experiment_next_stage(experiment, NULL);
        else {
            experiment_go_on(experiment, experiment_stage(experiment) == 0);
            while (sound && !whole)
                sound = experiment_work(experiment, (Effort){.share = 0.34}, &whole, NULL);
        }
    }
    ck_assert(sound == !cases[k].fails);
    expect_record(experiment, cases[k].column);
    experiment_destroy(experiment);
    close_case();
}
END_TEST

/* --- the others ------------------------------------------------------------------------------------- */

typedef struct Given {
    int asked, most;
} Given;

static bool ask(double share, void *context)
{
    Given *given = context;
    ck_assert(share >= 0 && share <= 1);
    return ++given->asked <= given->most;
}

static bool export(Cancel cancel, char *series, Status *status)
{
    RunSummary summary;
    snprintf(series, 96, "%s/s.csv", folder);
    const Outputs outputs = {.asker = ASKER_COMMAND_LINE, .series = series};
    return export_run(&settings, &outputs, 1, cancel.go_on, cancel.context, &summary, status);
}

START_TEST(the_export_is_one_of_them)
{
    char series[96], line[1 << 14];
    Status status = {0};
    long step = 0, rows = 0;
    open_case(_i);
    ck_assert_msg(export((Cancel){0}, series, &status) == !cases[_i].fails, "%s", status.text);
    FILE *stream = fopen(series, "r");
    ck_assert_ptr_nonnull(fgets(line, sizeof line, stream));
    int column = 0;
    const char *name = strstr(line, cases[_i].column);
    for (const char *at = line; at < name; at++)
        column += *at == ',';
    for (; fgets(line, sizeof line, stream); rows++) {
        char *at = line;
        step = strtol(at, NULL, 10);
        for (int i = 0; i < column; i++)
            at = strchr(at, ',') + 1;
        ck_assert_msg(strtod(at, NULL) == expected[step], "step %ld: %s", step, at);
    }
    fclose(stream);
    ck_assert_int_eq(step, last);
    ck_assert_int_eq(rows,
                     (last + settings_output(&settings)->every - 1) / settings_output(&settings)->every + 1);
    unlink(series);
    strcat(series, ".ini");
    unlink(series);
    close_case();
}
END_TEST

static bool fit(int k, Cancel cancel, double *values, Status *status)
{
    static double times[ROWS_MAX];
    FitResult result = {0};
    Status why = {0};
    Simulation *sim = problem_simulate(&settings, 1, &why);
    for (long step = 0; step <= last; step++)
        times[step] = (double)step * sim->dt;
    times[last + 1] = (double)(last + 2) * sim->dt; /* beyond the end, or where it came to rest */
    simulation_destroy(sim);
    const size_t count = (size_t)last + 1 + (cases[k].rests ? 1 : 0);
    const FitTask task = {.settings = &settings,
                          .column = cases[k].column,
                          .times = times,
                          .count = count,
                          .threads = 1,
                          .cancel = cancel};
    Search search = {.task = &task, .result = &result};
    const bool sound = fit_run(&search, &settings, times, values, count);
    *status = search.why;
    return sound;
}

START_TEST(the_fit_is_one_of_them)
{
    static double values[ROWS_MAX];
    Status status;
    open_case(_i);
    /* it ends at its last datum, and knows nothing of what would fail behind it */
    ck_assert_msg(fit(_i, (Cancel){0}, values, &status) || cases[_i].fails, "%s", status.text);
    for (long step = 0; step < last + !cases[_i].fails; step++)
        ck_assert_msg(values[step] == expected[step], "step %ld: %.17g, by hand %.17g", step, values[step],
                      expected[step]);
    if (cases[_i].rests)
        ck_assert(values[last + 1] == expected[last]);
    close_case();
}
END_TEST

START_TEST(the_verification_is_one_of_them)
{
    VerifyRun run;
    open_case(_i);
    ck_assert(verify_run_open(&run, file, 1, (Cancel){0}) == !cases[_i].fails);
    if (!cases[_i].fails) {
        const double *column = verify_column(&run, cases[_i].column);
        ck_assert_uint_eq(run.count, (size_t)(last / settings_output(&settings)->every) + 1);
        for (size_t row = 0; row < run.count; row++) {
            const long step = (long)row * settings_output(&settings)->every;
            ck_assert_msg(column[row * (size_t)run.n_columns] == expected[step], "step %ld", step);
        }
    }
    verify_run_close(&run);
    close_case();
}
END_TEST

/* Each of those that go to the end by themselves asks on the way, and leaves nothing behind. */
START_TEST(all_can_be_given_up)
{
    static double values[ROWS_MAX];
    open_case(0);
    for (int most = 0; most < 3; most++) {
        char series[96];
        Status status = {0};
        Given given = {0, most};
        ck_assert(!export((Cancel){ask, &given}, series, &status));
        ck_assert_str_eq(status.text, "interrupted");
        ck_assert_int_eq(given.asked, most + 1);
        given = (Given){0, most};
        ck_assert(!fit(0, (Cancel){ask, &given}, values, &status));
        ck_assert_str_eq(status.text, "interrupted");
        ck_assert_int_eq(given.asked, most + 1);
        VerifyRun run;
        given = (Given){0, most};
        ck_assert(!verify_run_open(&run, file, 1, (Cancel){ask, &given}));
        ck_assert_int_eq(given.asked, most + 1);
        verify_run_close(&run);
    }
    close_case();
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("time");
    tcase_add_loop_test(tcase, the_laboratory_is_one_of_them, 0, 4 * CASES);
    tcase_add_loop_test(tcase, the_export_is_one_of_them, 0, CASES);
    tcase_add_loop_test(tcase, the_fit_is_one_of_them, 0, CASES);
    tcase_add_loop_test(tcase, the_verification_is_one_of_them, 0, CASES);
    tcase_add_test(tcase, all_can_be_given_up);
    suite_add_tcase(suite, tcase);
}
