/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A method that nobody knows, driven through method.h alone: slices, fields, snapshots, and by a row of its
 * own an experiment and tables, on 58,800 nodes. */
#include "export/export.h"
#include "scenario/concern_output.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "run/lab_case.h"
#include "problems/solver.h"
#include "plate.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static Simulation *large_plate(void)
{
    Simulation *sim = plate_create(PLATE_COLUMNS, PLATE_ROWS, 0);
    ck_assert_ptr_nonnull(sim);
    ck_assert_uint_eq(sim->counts[0], 58800);
    return sim;
}

START_TEST(slices_of_any_size_are_the_same)
{
    Simulation *whole = large_plate(), *sliced = large_plate();
    unsigned long seed = 1;
    ck_assert(simulation_steps(whole, 6, NULL, NULL, NULL));
    while (sliced->step < 6) {
        bool done;
        int stage = sliced->stage;
        size_t item = sliced->item;
        ck_assert(simulation_slice(sliced, 1 + draw(&seed, 60), &done, NULL));
        ck_assert(done ? sliced->item == 0 : sliced->stage == stage && sliced->item > item);
    }
    expect_same_states(whole, sliced, "in slices");
    simulation_destroy(whole);
    simulation_destroy(sliced);
}
END_TEST

START_TEST(the_lattice_oscillates_as_predicted)
{
    Simulation *sim = plate_create(42, 14, 0);
    double omega = plate_frequency(42, 14, sim->dt), row[4], start[4];
    simulation_row(sim, start);
    for (int k = 1; k <= 400; k++) {
        ck_assert(simulation_steps(sim, 1, row, NULL, NULL));
        ck_assert_double_eq_tol(row[0] / start[0], cos(omega * k * sim->dt), 1e-9);
        ck_assert_double_eq_tol(row[3] / start[3], 1, 0.02);
    }
    simulation_destroy(sim);
}
END_TEST

static void expect_experiment_at(Experiment *experiment, long step, int stage, const char *what)
{
    Simulation *fresh = large_plate();
    ck_assert(simulation_steps(fresh, step, NULL, NULL, NULL));
    for (int i = 0; i < stage; i++)
        ck_assert(simulation_stage(fresh, NULL));
    expect_same_states(experiment_simulation(experiment), fresh, what);
    simulation_destroy(fresh);
}

static bool check(const Settings *settings, Status *status)
{
    return problem_check_steps(settings_time(settings)->end, 0.5, status);
}

static Simulation *simulate_large(const Settings *settings, int threads, Status *status)
{
    (void)settings, (void)threads, (void)status;
    return large_plate();
}

static Simulation *simulate_torn(const Settings *settings, int threads, Status *status)
{
    (void)settings, (void)threads, (void)status;
    return plate_create(20, 10, 71);
}

static const Solver large = {.method = METHOD_PD, .check = check, .simulate = simulate_large};
static const Solver torn = {.method = METHOD_PD, .check = check, .simulate = simulate_torn};
static const Solver *const large_solvers[] = {&large, NULL}, *const torn_solvers[] = {&torn, NULL};
static const ParameterUse uses[] = {{.key = "time.end", .usual = 50}};

#define PLATE(name)                                                                                          \
    .word = name, .title = "a plate of springs", .body = "plate", .uses = uses, .n_uses = 1,                 \
    .unit_of_time = "time", .shown_time = 1, .shown_time_unit = ""

static const Problem large_problem = {PLATE("large"), .solvers = large_solvers},
                     torn_problem = {PLATE("torn"), .solvers = torn_solvers};

static Settings until(const Problem *problem, double end)
{
    Settings settings;
    settings_default(&settings, problem);
    settings_edit_time(&settings)->end = end;
    return settings;
}

START_TEST(an_experiment_takes_it_as_it_is)
{
    Settings settings = until(&large_problem, 50);
    Experiment *experiment = experiment_create(&settings, (size_t)8 << 20, 1, NULL);
    ck_assert_ptr_nonnull(experiment);
    int n;
    const Column *columns = experiment_columns(experiment, &n);
    ck_assert_int_eq(n, 6);
    ck_assert_str_eq(columns[2].quantity.name, "u_middle");
    ck_assert(experiment_advance(experiment, 1000, NULL));
    ck_assert_int_eq(experiment_step(experiment), 100);
    ck_assert_uint_eq(experiment_record(experiment)->count, 101);
    experiment_seek(experiment, 47, 2);
    finish_work(experiment);
    expect_experiment_at(experiment, 47, 2, "back");
    double now[3], before[3];
    const Simulation *sim = experiment_simulation(experiment);
    int uy = simulation_find_field(sim, 0, "uy");
    sim->method->field(sim, uy, 30000, 3, now);
    ck_assert(experiment_field_before(experiment, uy, 30000, 3, before));
    ck_assert(now[1] != before[1]);
    experiment_seek(experiment, 100, 0);
    finish_work(experiment);
    expect_experiment_at(experiment, 100, 0, "forwards again");
    ck_assert(!experiment_readout(experiment)->moving);
    ck_assert(experiment_restart(experiment, true, NULL));
    expect_experiment_at(experiment, 0, 0, "restarted");
    ck_assert(experiment_ghosts(experiment)[0].used);
    ck_assert_uint_eq(experiment_ghosts(experiment)[0].record.count, 101);
    Settings other = *experiment_settings(experiment);
    settings_edit_time(&other)->end = 25;
    ck_assert(experiment_edit(experiment, &other, NULL));
    ck_assert_int_eq(experiment_last_step(experiment), 50);
    experiment_destroy(experiment);
}
END_TEST

START_TEST(a_failure_in_mid_step_leads_back_to_a_whole_one)
{
    Settings settings = until(&torn_problem, 50);
    for (int by_stage = 0; by_stage < 2; by_stage++) {
        Experiment *experiment = experiment_create(&settings, 1 << 20, 1, NULL);
        Status status = {0};
        bool sound = true;
        while (sound && !experiment_at_end(experiment))
            sound = by_stage ? experiment_next_stage(experiment, &status)
                             : experiment_advance(experiment, 1000, &status);
        ck_assert(!sound);
        ck_assert_str_eq(status.text, "the plate tears in step 71, t = 35.5");
        ck_assert_int_eq(experiment_step(experiment), 70);
        ck_assert_int_eq(experiment_stage(experiment), 0);
        ck_assert_uint_eq(experiment_record(experiment)->count, 71);
        Simulation *fresh = plate_create(20, 10, 0);
        ck_assert(simulation_steps(fresh, 70, NULL, NULL, NULL));
        expect_same_states(experiment_simulation(experiment), fresh, "after the failure");
        simulation_destroy(fresh);
        experiment_destroy(experiment);
    }
}
END_TEST

START_TEST(tables_are_written_of_it)
{
    char folder[] = "/tmp/check_plate.XXXXXX", series[64], particles[64], line[256];
    ck_assert_ptr_nonnull(mkdtemp(folder));
    snprintf(series, sizeof series, "%s/s.csv", folder);
    snprintf(particles, sizeof particles, "%s/p.csv", folder);
    Settings settings = until(&large_problem, 5);
    settings_edit_output(&settings)->frames = 2;
    Outputs outputs = {.asker = ASKER_COMMAND_LINE, .series = series, .particles = particles};
    RunSummary summary;
    Status status = {0};
    ck_assert_msg(export_run(&settings, &outputs, 1, NULL, NULL, &summary, &status), "%s", status.text);
    ck_assert_int_eq(summary.rows, 11);
    long lines = 0;
    FILE *file = fopen(particles, "r");
    ck_assert_ptr_nonnull(file);
    ck_assert_ptr_nonnull(fgets(line, sizeof line, file));
    ck_assert_str_eq(line, "step,time,particle,x0,y0,ux,uy,vx,vy\n");
    while (fgets(line, sizeof line, file))
        lines++;
    fclose(file);
    ck_assert_int_eq(lines, 2 * 58800);
    ck_assert_str_eq(line, "10,5,58799,419,139,0,0,0,0\n");
    Outputs bonds = {.asker = ASKER_COMMAND_LINE, .bonds = series, .force = true};
    ck_assert(!export_run(&settings, &bonds, 1, NULL, NULL, NULL, &status));
    static const char *const names[] = {"s.csv", "p.csv", "s.csv.ini", "p.csv.ini"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char name[128];
        snprintf(name, sizeof name, "%s/%s", folder, names[i]);
        ck_assert_int_eq(unlink(name), 0);
    }
    ck_assert_int_eq(rmdir(folder), 0);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("plate");
    tcase_add_test(tcase, slices_of_any_size_are_the_same);
    tcase_add_test(tcase, the_lattice_oscillates_as_predicted);
    tcase_add_test(tcase, an_experiment_takes_it_as_it_is);
    tcase_add_test(tcase, a_failure_in_mid_step_leads_back_to_a_whole_one);
    tcase_add_test(tcase, tables_are_written_of_it);
    suite_add_tcase(suite, tcase);
}
