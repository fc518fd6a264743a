/* SPDX-License-Identifier: GPL-3.0-or-later */
/* An experiment against fresh runs: whatever way led to a moment, it is the same to the last bit. */
#include "run/lab_case.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_loads.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "scenario/scenario.h"
#include "suite.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MEGABYTE = 1 << 20 };

/* A simulation that was simply run to a step and a stage. */
static Simulation *straight(const Settings *settings, long step, int stage)
{
    Status status = {0};
    Simulation *sim = problem_simulate(settings, 1, &status);
    ck_assert_msg(sim != NULL, "%s", status.text);
    ck_assert_msg(simulation_steps(sim, step, NULL, NULL, &status), "%s", status.text);
    for (int i = 0; i < stage; i++)
        ck_assert(simulation_stage(sim, &status));
    return sim;
}

static void expect_straight(Experiment *experiment, const char *what)
{
    const Settings *settings = experiment_settings(experiment);
    Simulation *fresh = straight(settings, experiment_step(experiment), experiment_stage(experiment));
    expect_same_states(experiment_simulation(experiment), fresh, what);
    simulation_destroy(fresh);
}

static Effort a_part(size_t items, size_t all)
{
    return (Effort){.share = (double)items / (double)all};
}

/* One step in slices of any size; sometimes it is given up on its way, then the present is where it began. */
static void step_in_parts(Experiment *experiment, unsigned long *state)
{
    bool whole = false, at_end = experiment_at_end(experiment);
    long step = experiment_step(experiment);
    int stage = experiment_stage(experiment);
    size_t all = experiment_simulation(experiment)->stage_items;
    experiment_go_on(experiment, stage == 0);
    while (!whole && draw(state, 40) > 0)
        ck_assert(experiment_work(experiment, a_part(1 + draw(state, all), all), &whole, NULL));
    experiment_drop_part(experiment);
    ck_assert(!experiment_pending(experiment, NULL)); /* whose run goes on asks again */
    ck_assert_int_eq(experiment_step(experiment), whole && !at_end ? step + 1 : step);
    ck_assert_int_eq(experiment_stage(experiment), whole ? 0 : stage);
}

static void seek_in_parts(Experiment *experiment, long step, int stage, unsigned long *state)
{
    bool whole;
    size_t all = experiment_simulation(experiment)->stage_items;
    experiment_seek(experiment, step, stage);
    while (experiment_pending(experiment, NULL)) {
        ck_assert(experiment_work(experiment, a_part(1 + draw(state, 2 * all), all), &whole, NULL));
        if (draw(state, 300) == 0)
            experiment_drop_part(experiment);
    }
}

/* The keys of the laboratory: . , < > s S g and Space. */
static void walk(Experiment *experiment, unsigned long *state)
{
    Status status = {0};
    long step = experiment_step(experiment), last = experiment_last_step(experiment);
    int stage = experiment_stage(experiment), stages = experiment_simulation(experiment)->n_stages, to;
    switch (draw(state, 12)) {
    case 0:
        ck_assert(experiment_advance(experiment, 1, &status));
        break;
    case 1:
        experiment_seek(experiment, stage > 0 ? step : step - 1, 0);
        break;
    case 2:
        experiment_seek(experiment, step - 10, 0);
        break;
    case 3:
        ck_assert(experiment_advance(experiment, 10, &status));
        break;
    case 4:
    case 5:
        ck_assert(experiment_next_stage(experiment, &status));
        break;
    case 6:
        if (stage > 0)
            experiment_seek(experiment, step, stage - 1);
        else if (step > 0)
            experiment_seek(experiment, step - 1, stages - 1);
        break;
    case 7:
        to = (int)draw(state, (unsigned long)stages); /* in this order, whichever the compiler's is */
        experiment_seek(experiment, (long)draw(state, (unsigned long)last + 1), to);
        break;
    case 8:
    case 9:
        step_in_parts(experiment, state);
        break;
    case 10:
        to = (int)draw(state, (unsigned long)stages);
        seek_in_parts(experiment, step + 3 - (long)draw(state, 7), to, state);
        break;
    default:
        ck_assert(experiment_advance(experiment, (long)draw(state, 80), &status));
    }
    finish_work(experiment);
}

static void walk_randomly(const Settings *settings, size_t history, int moves, unsigned long seed)
{
    Experiment *experiment = open_experiment(settings, history);
    for (int i = 0; i < (suite_sanitized() ? moves / 4 : moves); i++) {
        walk(experiment, &seed);
        expect_straight(experiment, "random walk");
        const double *row = experiment_row(experiment);
        ck_assert_double_eq(row[0], (double)experiment_step(experiment));
    }
    /* the record knows nothing of the detours */
    experiment_seek(experiment, experiment_newest(experiment), 0);
    finish_work(experiment);
    Experiment *fresh = open_experiment(settings, history);
    ck_assert(experiment_advance(fresh, experiment_newest(experiment), NULL));
    expect_same_records(experiment_record(experiment), experiment_record(fresh), "after the walk");
    experiment_destroy(fresh);
    experiment_destroy(experiment);
}

START_TEST(any_way_to_a_moment_of_a_bar_is_the_same)
{
    Settings settings = bar_settings(5, 5);
    walk_randomly(&settings, 16 * MEGABYTE, 200, 1);
    set(&settings, "mpm.algorithm", "musl");
    set(&settings, "initial.velocity", "1");
    walk_randomly(&settings, 16 * MEGABYTE, 200, 2);
    set(&settings, "mpm.transfer", "apic");
    set(&settings, "mpm.shape", "gimp");
    walk_randomly(&settings, 16 * MEGABYTE, 100, 3);
}
END_TEST

START_TEST(any_way_to_a_moment_of_a_bar_by_peridynamics_is_the_same)
{
    Settings settings = bar_settings(5, 5);
    set(&settings, "scenario.method", "pd");
    walk_randomly(&settings, 16 * MEGABYTE, 200, 11);
    set(&settings, "load.traction", "1e-3");
    walk_randomly(&settings, 20000, 100, 12);
}
END_TEST

START_TEST(keyframes_are_given_up_under_a_small_budget)
{
    Settings settings = bar_settings(1, 5);
    walk_randomly(&settings, 12000, 200, 4); /* two or three keyframes */
    Experiment *experiment = open_experiment(&settings, 12000);
    ck_assert(experiment_advance(experiment, 500, NULL));
    experiment_seek(experiment, 383, 0);
    long left;
    ck_assert(experiment_pending(experiment, &left));
    ck_assert_int_gt(left, 2 * 32); /* frames were given up: those left lie further apart than at first */
    experiment_destroy(experiment);
    walk_randomly(&settings, 0, 100, 5); /* none but that of t = 0 */
}
END_TEST

START_TEST(any_way_to_a_moment_of_a_beam_is_the_same)
{
    Settings settings = beam_settings(&problem_notched_beam, 6e-5);
    set(&settings, "load.stress", "2.4e8"); /* things break soon */
    const int most = suite_wide() ? 60 : 12;
    walk_randomly(&settings, 16 * MEGABYTE, most, 6);
    settings = beam_settings(&problem_moving_cantilever, 4e-5);
    walk_randomly(&settings, 16 * MEGABYTE, most * 2 / 3, 7);
    settings = beam_settings(&problem_supported_beam, 4e-5);
    walk_randomly(&settings, 1, most * 2 / 3, 8);
}
END_TEST

START_TEST(a_run_stops_at_its_end)
{
    Settings settings = bar_settings(1, 1);
    Experiment *experiment = open_experiment(&settings, MEGABYTE);
    ck_assert_int_eq(experiment_last_step(experiment), 100);
    ck_assert(experiment_advance(experiment, 1000, NULL));
    ck_assert(experiment_at_end(experiment));
    ck_assert_int_eq(experiment_step(experiment), 100);
    ck_assert(experiment_next_stage(experiment, NULL));
    ck_assert_int_eq(experiment_stage(experiment), 0);
    experiment_seek(experiment, 5000, 3);
    finish_work(experiment);
    ck_assert_int_eq(experiment_step(experiment), 100);
    ck_assert_uint_eq(experiment_record(experiment)->count, 101);
    experiment_destroy(experiment);
}
END_TEST

/* A run that is to end at rest ends there, is rewound and walked again, and goes on where it is changed. */
START_TEST(a_run_ends_at_rest)
{
    Settings settings;
    settings_default(&settings, &problem_supported_beam);
    set(&settings, "beam.length", "0.04");
    set(&settings, "pd.spacing", "1e-3");
    set(&settings, "pd.horizon", "3e-3");
    set(&settings, "initial.amplitude", "0");
    set(&settings, "load.body_force", "-9.81");
    set(&settings, "time.rest", "yes");
    set(&settings, "time.end", "1");
    Experiment *experiment = open_experiment(&settings, MEGABYTE);
    const long planned = experiment_last_step(experiment);
    experiment_seek(experiment, planned, 0);
    finish_work(experiment);
    const long rest = experiment_step(experiment);
    ck_assert_int_lt(rest, planned / 100);
    ck_assert(experiment_at_end(experiment));
    ck_assert_int_eq(experiment_last_step(experiment), rest);
    int count;
    const Event *events = experiment_events(experiment, &count);
    ck_assert_int_eq(events[count - 1].kind, EVENT_REST);
    ck_assert_int_eq(events[count - 1].step, rest);
    ck_assert(experiment_advance(experiment, 100, NULL));
    ck_assert_int_eq(experiment_step(experiment), rest);

    experiment_seek(experiment, rest / 2, 0);
    finish_work(experiment);
    ck_assert(!experiment_at_end(experiment));
    ck_assert(experiment_advance(experiment, planned, NULL));
    ck_assert_int_eq(experiment_step(experiment), rest);

    experiment_seek(experiment, rest / 2, 0);
    finish_work(experiment);
    Settings changed = *experiment_settings(experiment);
    set(&changed, "load.body_force", "-5");
    ck_assert(experiment_edit(experiment, &changed, NULL));
    ck_assert_int_eq(experiment_last_step(experiment), planned);
    ck_assert(experiment_advance(experiment, planned, NULL));
    ck_assert(experiment_at_end(experiment));
    ck_assert_int_gt(experiment_step(experiment), rest / 2 + 100);
    ck_assert_int_lt(experiment_step(experiment), planned / 100);
    experiment_destroy(experiment);
}
END_TEST

START_TEST(an_edit_recomputes_to_the_time_on_screen)
{
    static const char *const sizes[] = {"0.5", "0.25", "0.5", "1", "2.5", "1.25", "1", "5", "1", "0.5"};
    Settings settings = bar_settings(5, 100);
    Experiment *experiment = open_experiment(&settings, 16 * MEGABYTE);
    ck_assert(experiment_advance(experiment, 2000, NULL));
    double time = experiment_time(experiment);
    for (int i = 0; i < (suite_sanitized() ? 4 : 10); i++) {
        Settings wanted = *experiment_settings(experiment);
        Status status = {0};
        set(&wanted, "mesh.cell_size", sizes[i]);
        ck_assert_msg(experiment_edit(experiment, &wanted, &status), "%s", status.text);
        finish_work(experiment);
        ck_assert_double_le(fabs(experiment_time(experiment) - time),
                            0.51 * experiment_simulation(experiment)->dt);
        expect_straight(experiment, "after an edit");
        Experiment *fresh = open_experiment(&wanted, 16 * MEGABYTE);
        ck_assert(experiment_advance(fresh, experiment_step(experiment), NULL));
        expect_same_records(experiment_record(experiment), experiment_record(fresh), "after an edit");
        experiment_destroy(fresh);
        const Ghost *ghost = &experiment_ghosts(experiment)[0];
        ck_assert(ghost->used && !ghost->pinned);
        ck_assert_uint_gt(ghost->record.count, 10);
        char is[LEGEND_MAX];
        snprintf(is, sizeof is, "cell size %s", i > 0 ? sizes[i - 1] : "1");
        ck_assert_str_eq(ghost->legend, is);
        for (int g = 1; g < GHOSTS_MAX; g++)
            ck_assert(!experiment_ghosts(experiment)[g].used);
    }
    experiment_destroy(experiment);
}
END_TEST

START_TEST(a_refused_edit_changes_nothing)
{
    Settings settings = bar_settings(1, 10);
    Experiment *experiment = open_experiment(&settings, MEGABYTE);
    ck_assert(experiment_advance(experiment, 100, NULL));
    Settings wanted = *experiment_settings(experiment);
    Status status = {0};
    settings_edit_time(&wanted)->courant = 2.5;
    ck_assert(!experiment_edit(experiment, &wanted, &status));
    ck_assert_int_eq(status.code, STATUS_USAGE);
    ck_assert_msg(strstr(status.text, "2.5") && strstr(status.text, "1.732"), "%s", status.text);
    ck_assert_int_eq(experiment_step(experiment), 100);
    ck_assert_double_eq(settings_time(experiment_settings(experiment))->courant, 0.1);
    ck_assert(!experiment_ghosts(experiment)[0].used);
    expect_straight(experiment, "after a refusal");
    experiment_destroy(experiment);
}
END_TEST

/* Runs settings with their changes from the start. */
static void expect_repeats(Experiment *experiment, const char *what)
{
    Settings scenario;
    experiment_scenario(experiment, true, &scenario);
    Experiment *again = open_experiment(&scenario, MEGABYTE);
    ck_assert(experiment_advance(again, 1000000, NULL));
    expect_same_records(experiment_record(experiment), experiment_record(again), what);
    experiment_seek(experiment, experiment_newest(experiment), 0);
    finish_work(experiment);
    expect_same_states(experiment_simulation(experiment), experiment_simulation(again), what);
    experiment_destroy(again);
}

static void edit_one(Experiment *experiment, const char *key, const char *value)
{
    Settings wanted = *experiment_settings(experiment);
    Status status = {0};
    set(&wanted, key, value);
    ck_assert_msg(experiment_edit(experiment, &wanted, &status), "%s", status.text);
}

START_TEST(a_live_parameter_changes_in_mid_run)
{
    Settings settings = bar_settings(5, 20);
    Experiment *experiment = open_experiment(&settings, MEGABYTE);
    int n;
    experiment_columns(experiment, &n);
    ck_assert_int_eq(n, 15);
    ck_assert(experiment_advance(experiment, 300, NULL));
    edit_one(experiment, "mpm.algorithm", "usl");
    ck_assert_int_eq(experiment_step(experiment), 300);
    ck_assert(!experiment_ghosts(experiment)[0].used); /* nothing was cut off */
    experiment_columns(experiment, &n);
    ck_assert_int_eq(n, 14); /* no prediction any more */
    ck_assert_int_eq(experiment_record(experiment)->n_columns, 14);
    ck_assert(experiment_advance(experiment, 300, NULL));
    expect_repeats(experiment, "changed at the newest step");

    /* settings are those in force */
    experiment_seek(experiment, 299, 0);
    finish_work(experiment);
    ck_assert_int_eq(settings_transfer(experiment_settings(experiment))->algorithm, MPM_USF);
    experiment_seek(experiment, 300, 0);
    finish_work(experiment);
    ck_assert_int_eq(settings_transfer(experiment_settings(experiment))->algorithm, MPM_USL);

    /* in the past, in the middle of a step */
    experiment_seek(experiment, 450, 2);
    finish_work(experiment);
    edit_one(experiment, "mpm.flip_fraction", "0.9");
    ck_assert_int_eq(experiment_newest(experiment), 451);
    const Ghost *ghost = &experiment_ghosts(experiment)[0];
    ck_assert(ghost->used && ghost->record.count == 601);
    ck_assert(experiment_advance(experiment, 100, NULL));
    expect_repeats(experiment, "changed in the past");
    int events;
    const Event *event = experiment_events(experiment, &events);
    int changes = 0;
    for (int i = 0; i < events; i++)
        changes += event[i].kind == EVENT_CHANGE;
    ck_assert_int_eq(changes, 2);

    /* twice at one step, and back again */
    experiment_seek(experiment, 400, 0);
    finish_work(experiment);
    edit_one(experiment, "mpm.transfer", "apic");
    edit_one(experiment, "mpm.algorithm", "musl");
    edit_one(experiment, "mpm.transfer", "flip");
    ck_assert(experiment_advance(experiment, 200, NULL));
    expect_repeats(experiment, "changed twice");

    /* the restart keeps what is on screen */
    ck_assert(experiment_restart(experiment, false, NULL));
    ck_assert_int_eq(settings_transfer(experiment_settings(experiment))->algorithm, MPM_MUSL);
    ck_assert_int_eq(experiment_settings(experiment)->n_changes, 0);
    ck_assert(!experiment_ghosts(experiment)[0].used);
    ck_assert(experiment_advance(experiment, 100, NULL));
    expect_straight(experiment, "after a restart");
    experiment_destroy(experiment);
}
END_TEST

/* Columns, and rows with all that stands beside them, as in a run of the same scenario that was not edited.
 */
static void expect_columns_of_fresh_run(Experiment *experiment, const char *what)
{
    Settings scenario;
    int n, n_fresh;
    experiment_scenario(experiment, true, &scenario);
    settings_edit_time(&scenario)->end = settings_time(experiment_settings(experiment))->end;
    Experiment *fresh = open_experiment(&scenario, MEGABYTE);
    ck_assert(experiment_advance(fresh, experiment_newest(experiment), NULL));
    const Column *columns = experiment_columns(experiment, &n);
    const Column *expected = experiment_columns(fresh, &n_fresh);
    ck_assert_int_eq(n, n_fresh);
    for (int i = 0; i < n; i++) {
        ck_assert_str_eq(columns[i].quantity.name, expected[i].quantity.name);
        ck_assert_int_eq(columns[i].kind, expected[i].kind);
        ck_assert_int_eq(columns[i].of, expected[i].of);
    }
    expect_same_records(experiment_record(experiment), experiment_record(fresh), what);
    experiment_destroy(fresh);
}

/* A load that changes in mid-run leaves no exact answer; another future, in which it never changed, has it
 * again, from t = 0. */
START_TEST(a_column_that_went_comes_back)
{
    Settings settings = bar_settings(1, 5);
    Experiment *experiment = open_experiment(&settings, MEGABYTE);
    int with, n;
    experiment_columns(experiment, &with);
    ck_assert(experiment_advance(experiment, 5, NULL));
    edit_one(experiment, "load.traction", "1");
    expect_columns_of_fresh_run(experiment, "gone");
    experiment_columns(experiment, &n);
    ck_assert_int_lt(n, with);
    ck_assert(experiment_advance(experiment, 3, NULL));
    experiment_seek(experiment, 3, 0);
    finish_work(experiment);
    edit_one(experiment, "mpm.algorithm", "usl");
    const Column *columns = experiment_columns(experiment, &n);
    bool exact = false;
    for (int i = 0; i < n; i++)
        exact = exact || columns[i].kind == COLUMN_EXACT;
    ck_assert(exact);
    expect_columns_of_fresh_run(experiment, "back");
    ck_assert(experiment_advance(experiment, 100, NULL));
    expect_columns_of_fresh_run(experiment, "and on");
    experiment_destroy(experiment);
}
END_TEST

/* Against a run of the same scenario with its changes that never went back. */
static void expect_scenario(Experiment *experiment, const char *what)
{
    Settings scenario;
    experiment_scenario(experiment, true, &scenario);
    settings_edit_time(&scenario)->end = settings_time(experiment_settings(experiment))->end;
    Experiment *fresh = open_experiment(&scenario, MEGABYTE);
    ck_assert(experiment_advance(fresh, experiment_step(experiment), NULL));
    for (int stage = 0; stage < experiment_stage(experiment); stage++)
        ck_assert(experiment_next_stage(fresh, NULL));
    expect_same_states(experiment_simulation(experiment), experiment_simulation(fresh), what);
    experiment_destroy(fresh);
}

typedef struct LiveEdit {
    const char *key, *value;
} LiveEdit;

static void walk_with_changes(const Settings *settings, const LiveEdit *edits, unsigned long n_edits,
                              size_t history, int moves, unsigned long seed)
{
    Experiment *experiment = open_experiment(settings, history);
    int changed = 0, kept = 0;
    /* more moves where those drawn changed too little */
    for (int i = 0; i < moves || (i < 10 * moves && (changed <= 5 || kept <= 1)); i++) {
        walk(experiment, &seed);
        const LiveEdit *edit = &edits[draw(&seed, n_edits)];
        bool past = experiment_step(experiment) < experiment_newest(experiment) - 1;
        if (draw(&seed, 5) == 0 && experiment_step(experiment) > 0 && !experiment_at_end(experiment) &&
            experiment_settings(experiment)->n_changes < CHANGES_MAX / 2) {
            size_t rows = experiment_record(experiment)->count;
            int n_changes = experiment_settings(experiment)->n_changes;
            edit_one(experiment, edit->key, edit->value);
            finish_work(experiment);
            if (past && experiment_settings(experiment)->n_changes != n_changes) {
                /* the curve that was cut off stays, whole */
                const Ghost *ghost = NULL;
                for (int k = 0; k < GHOSTS_MAX; k++)
                    if (experiment_ghosts(experiment)[k].used)
                        ghost = &experiment_ghosts(experiment)[k];
                ck_assert(ghost && ghost->record.count == rows);
                kept++;
            }
            changed++;
        }
        expect_scenario(experiment, "walk with changes");
    }
    ck_assert_int_gt(changed, 5);
    ck_assert_int_gt(kept, 1);
    expect_repeats(experiment, "after a walk with changes");
    experiment_destroy(experiment);
}

START_TEST(changes_in_mid_run_hold_on_any_way)
{
    static const LiveEdit bar[] = {{"mpm.algorithm", "usf"},  {"mpm.algorithm", "usl"},
                                   {"mpm.algorithm", "musl"}, {"mpm.transfer", "apic"},
                                   {"mpm.transfer", "flip"},  {"mpm.flip_fraction", "0.9"}};
    static const LiveEdit beam[] = {{"load.stress", "1e8"},
                                    {"load.stress", "4e8"},
                                    {"pd.critical_stretch", "0.0005"},
                                    {"pd.critical_stretch", "0.0002"}};
    const int moves = suite_sanitized() ? 60 : 100;
    Settings settings = bar_settings(5, 5);
    walk_with_changes(&settings, bar, sizeof bar / sizeof *bar, 16 * MEGABYTE, moves, 11);
    set(&settings, "mpm.shape", "gimp");
    walk_with_changes(&settings, bar, sizeof bar / sizeof *bar, 12000, moves, 12);
    if (suite_sanitized()) /* each of its moves is done once more from the start */
        return;
    settings = beam_settings(&problem_notched_beam, 6e-5);
    set(&settings, "load.stress", "2.4e8");
    walk_with_changes(&settings, beam, sizeof beam / sizeof *beam, 4 * MEGABYTE, 30, 13);
}
END_TEST

START_TEST(undo_brings_back_what_was)
{
    Settings settings = bar_settings(5, 20);
    Experiment *experiment = open_experiment(&settings, MEGABYTE);
    ck_assert(experiment_advance(experiment, 300, NULL));
    Settings first = *experiment_base(experiment);
    edit_one(experiment, "mpm.algorithm", "usl");
    ck_assert(experiment_advance(experiment, 100, NULL));
    Settings second = *experiment_base(experiment);
    edit_one(experiment, "mpm.transfer", "apic");
    ck_assert(experiment_advance(experiment, 100, NULL));
    edit_one(experiment, "mesh.particles_per_cell", "3");
    finish_work(experiment);
    ck_assert_int_eq(experiment_step(experiment), 500);
    ck_assert_int_eq(experiment_settings(experiment)->n_changes, 2);

    /* one live change less, still in the middle of the run */
    ck_assert(experiment_replace(experiment, &second, NULL));
    finish_work(experiment);
    ck_assert_int_eq(experiment_step(experiment), 500);
    ck_assert_int_eq(experiment_settings(experiment)->n_changes, 1);
    ck_assert_int_eq(settings_transfer(experiment_settings(experiment))->algorithm, MPM_USL);
    ck_assert_int_eq(settings_mesh(experiment_settings(experiment))->particles_per_cell, 2);
    expect_repeats(experiment, "one change");

    /* none, and the prediction is back */
    ck_assert(experiment_replace(experiment, &first, NULL));
    finish_work(experiment);
    int n;
    experiment_columns(experiment, &n);
    ck_assert_int_eq(n, 15);
    expect_straight(experiment, "undone");

    /* the other algorithm from the start, and back: not as a change in mid-run */
    Settings other = *experiment_settings(experiment);
    set(&other, "mpm.algorithm", "musl");
    ck_assert(experiment_rerun(experiment, &other, NULL));
    finish_work(experiment);
    ck_assert_int_eq(experiment_settings(experiment)->n_changes, 0);
    expect_straight(experiment, "toggled");
    ck_assert(experiment_replace(experiment, &first, NULL));
    finish_work(experiment);
    ck_assert_int_eq(experiment_settings(experiment)->n_changes, 0);
    ck_assert_int_eq(experiment_step(experiment), 500);
    expect_straight(experiment, "toggled back");
    experiment_destroy(experiment);
}
END_TEST

/* Of live edits made at once one is refused: none is made, and no row of the run is lost. */
START_TEST(live_edits_are_made_together_or_not_at_all)
{
    Settings settings = bar_settings(5, 20);
    Status status = {0};
    Experiment *experiment = open_experiment(&settings, MEGABYTE);
    ck_assert(experiment_advance(experiment, 300, NULL));
    experiment_seek(experiment, 200, 0);
    finish_work(experiment);
    const Settings before = *experiment_settings(experiment);
    Settings wanted = before;
    set(&wanted, "mpm.algorithm", "usl");
    set(&wanted, "mpm.transfer", "apic");
    set(&wanted, "mpm.mass_blend", "0.5");
    ck_assert(!experiment_edit(experiment, &wanted, &status));
    ck_assert_msg(strstr(status.text, "mpm.mass_blend") != NULL, "%s", status.text);
    ck_assert(settings_same(experiment_settings(experiment), &before));
    ck_assert_int_eq(experiment_newest(experiment), 300);
    ck_assert(!experiment_ghosts(experiment)[0].used);
    ck_assert(experiment_advance(experiment, 200, NULL));
    expect_straight(experiment, "refused");

    /* and those that are allowed are made together */
    set(&wanted, "mpm.mass_blend", "1");
    ck_assert_msg(experiment_edit(experiment, &wanted, &status), "%s", status.text);
    ck_assert_int_eq(experiment_settings(experiment)->n_changes, 2);
    ck_assert(experiment_advance(experiment, 200, NULL));
    expect_repeats(experiment, "both");
    experiment_destroy(experiment);
}
END_TEST

START_TEST(a_live_edit_at_either_end_holds_from_the_start)
{
    Settings settings = bar_settings(5, 2);
    Experiment *experiment = open_experiment(&settings, MEGABYTE);
    edit_one(experiment, "mpm.algorithm", "usl");
    ck_assert_int_eq(experiment_settings(experiment)->n_changes, 0);
    ck_assert(experiment_advance(experiment, 1000, NULL));
    edit_one(experiment, "mpm.algorithm", "musl");
    /* once more while it is still on its way to the end */
    ck_assert(experiment_pending(experiment, NULL));
    edit_one(experiment, "mpm.flip_fraction", "0.5");
    finish_work(experiment);
    ck_assert(experiment_at_end(experiment));
    ck_assert_int_eq(experiment_settings(experiment)->n_changes, 0);
    ck_assert_int_eq(settings_transfer(experiment_settings(experiment))->algorithm, MPM_MUSL);
    expect_straight(experiment, "at the end");
    /* the ghost is the last curve that was whole */
    ck_assert_int_eq(settings_transfer(experiment_ghosts(experiment)[0].settings)->algorithm, MPM_USL);
    ck_assert_uint_eq(experiment_ghosts(experiment)[0].record.count, 201);
    experiment_destroy(experiment);
}
END_TEST

START_TEST(given_changes_stay_with_the_scenario)
{
    Settings settings = bar_settings(5, 5);
    settings.n_changes = 1;
    settings.changes[0] = (Change){100, {"mpm.algorithm", "usl"}};
    Experiment *experiment = open_experiment(&settings, MEGABYTE);
    ck_assert(experiment_advance(experiment, 200, NULL));
    ck_assert_int_eq(settings_transfer(experiment_settings(experiment))->algorithm, MPM_USL);
    ck_assert(experiment_restart(experiment, true, NULL));
    ck_assert_int_eq(settings_transfer(experiment_settings(experiment))->algorithm, MPM_USF);
    ck_assert_int_eq(experiment_settings(experiment)->n_changes, 1);
    ck_assert(experiment_advance(experiment, 200, NULL));
    /* with half the time step it keeps its time */
    edit_one(experiment, "time.courant", "0.05");
    finish_work(experiment);
    ck_assert_int_eq(experiment_step(experiment), 400);
    ck_assert_int_eq(experiment_settings(experiment)->changes[0].step, 200);
    expect_repeats(experiment, "given");
    /* a change to what is unstable is refused before the run */
    settings_edit_time(&settings)->courant = 1.2;
    Status status = {0};
    ck_assert_ptr_null(experiment_create(&settings, MEGABYTE, 1, &status));
    ck_assert_msg(strstr(status.text, "changes.100: time.courant: 1.2") != NULL, "%s", status.text);
    experiment_destroy(experiment);
}
END_TEST

START_TEST(a_filter_survives_a_change_in_the_past)
{
    Settings settings = beam_settings(&problem_moving_cantilever, 3e-4);
    Experiment *experiment = open_experiment(&settings, MEGABYTE);
    ck_assert(experiment_advance(experiment, 600, NULL));
    experiment_seek(experiment, 500, 0);
    finish_work(experiment);
    edit_one(experiment, "pd.critical_stretch", "0.1");
    ck_assert_int_eq(experiment_newest(experiment), 500);
    ck_assert(experiment_advance(experiment, 50, NULL));
    expect_repeats(experiment, "filtered");
    experiment_destroy(experiment);
}
END_TEST

START_TEST(another_end_does_not_recompute)
{
    Settings settings = bar_settings(1, 5);
    Experiment *experiment = open_experiment(&settings, MEGABYTE);
    ck_assert(experiment_advance(experiment, 500, NULL));
    const Simulation *sim = experiment_simulation(experiment);
    edit_one(experiment, "time.end", "6");
    edit_one(experiment, "output.every", "10");
    ck_assert_ptr_eq(experiment_simulation(experiment), sim);
    ck_assert(!experiment_at_end(experiment));
    ck_assert_uint_eq(experiment_record(experiment)->count, 501);
    ck_assert(experiment_advance(experiment, 500, NULL));
    ck_assert_int_eq(experiment_step(experiment), 600);
    edit_one(experiment, "time.end", "2");
    ck_assert_int_eq(experiment_step(experiment), 200);
    ck_assert_uint_eq(experiment_record(experiment)->count, 201);
    ck_assert(experiment_at_end(experiment));
    expect_straight(experiment, "shortened");
    experiment_destroy(experiment);
}
END_TEST

/* But where an answer is known up to one end and not to the other. */
START_TEST(an_end_beyond_an_answer_recomputes)
{
    Settings settings;
    Status status = {0};
    ck_assert(scenario_load("two-materials", &settings, &status));
    Experiment *experiment = open_experiment(&settings, MEGABYTE);
    edit_one(experiment, "time.end", "300");
    ck_assert_int_ge(column_of(experiment, "v_cm_exact"), 0);
    edit_one(experiment, "time.end", "3000");
    ck_assert_int_lt(column_of(experiment, "v_cm_exact"), 0);
    edit_one(experiment, "time.end", "8");
    ck_assert_int_ge(column_of(experiment, "v_cm_exact"), 0);
    experiment_destroy(experiment);
}
END_TEST

START_TEST(a_failed_run_keeps_its_rows)
{
    /* the bar leaves its mesh */
    Settings settings = bar_settings(0, 100);
    set(&settings, "bar.supports", "free-free");
    set(&settings, "initial.velocity", "1");
    set(&settings, "mesh.padding", "1");
    for (int by_stage = 0; by_stage < 2; by_stage++) {
        Experiment *experiment = open_experiment(&settings, 0);
        Status status = {0};
        bool sound = true;
        while (sound && !experiment_at_end(experiment))
            sound = by_stage ? experiment_next_stage(experiment, &status)
                             : experiment_advance(experiment, 1000, &status);
        ck_assert(!sound);
        ck_assert_msg(strstr(status.text, "particle") != NULL, "%s", status.text);
        Status again = {0};
        ck_assert(experiment_failed(experiment, &again));
        ck_assert_str_eq(again.text, status.text);
        long newest = experiment_newest(experiment);
        ck_assert_int_gt(newest, 50);
        ck_assert_int_eq(experiment_step(experiment), newest);
        ck_assert_int_eq(experiment_stage(experiment), 0);
        ck_assert_uint_eq(experiment_record(experiment)->count, (size_t)newest + 1);
        expect_straight(experiment, "after a failure");
        /* one can look back, walk up to it again, and it fails again */
        experiment_seek(experiment, newest - 20, 2);
        finish_work(experiment);
        expect_straight(experiment, "before the failure");
        ck_assert(!experiment_advance(experiment, 100, &again));
        ck_assert_str_eq(again.text, status.text);
        ck_assert_int_eq(experiment_step(experiment), newest);
        experiment_destroy(experiment);
    }
}
END_TEST

START_TEST(the_state_before_a_stage_is_known)
{
    Settings settings = bar_settings(1, 10);
    Experiment *experiment = open_experiment(&settings, MEGABYTE);
    ck_assert_ptr_null(experiment_before(experiment));
    ck_assert(experiment_advance(experiment, 10, NULL));
    ck_assert_ptr_null(experiment_before(experiment));
    const Simulation *sim = experiment_simulation(experiment);
    int stress = simulation_find_field(sim, 0, "stress");
    double old[50], now[50], told[50];
    ck_assert_uint_eq(sim->counts[0], 50);
    for (int stage = 0; stage < sim->n_stages; stage++) {
        sim->method->field(sim, stress, 0, 50, old);
        ck_assert(experiment_next_stage(experiment, NULL));
        sim->method->field(sim, stress, 0, 50, now);
        ck_assert(experiment_field_before(experiment, stress, 0, 50, told));
        ck_assert_mem_eq(told, old, sizeof old);
        sim->method->field(sim, stress, 0, 50, told);
        ck_assert_mem_eq(told, now, sizeof now);
        char text[2048];
        sim->method->explain(sim, stage, 0, 7, experiment_before(experiment), 0, text, sizeof text);
        ck_assert_uint_gt(strlen(text), 0);
    }
    expect_straight(experiment, "after looking back");
    experiment_destroy(experiment);
}
END_TEST

START_TEST(curves_are_pinned_and_unpinned)
{
    Settings settings = bar_settings(5, 10);
    Experiment *experiment = open_experiment(&settings, MEGABYTE);
    Status status = {0};
    static const char *const modes[] = {"1", "2", "3", "4"};
    for (int i = 0; i < GHOSTS_MAX - 1; i++) {
        edit_one(experiment, "initial.mode", modes[i]);
        ck_assert(experiment_advance(experiment, 200, NULL));
        ck_assert_msg(experiment_pin(experiment, &status), "%s", status.text);
    }
    edit_one(experiment, "initial.mode", "6");
    ck_assert(experiment_advance(experiment, 200, NULL));
    ck_assert(!experiment_pin(experiment, &status));
    edit_one(experiment, "initial.mode", "7");
    int pinned = 0, loose = 0;
    for (int i = 0; i < GHOSTS_MAX; i++) {
        const Ghost *ghost = &experiment_ghosts(experiment)[i];
        ck_assert(ghost->used);
        ck_assert_int_eq(ghost->letter, 'a' + i);
        pinned += ghost->pinned;
        loose += !ghost->pinned;
        if (!ghost->pinned)
            ck_assert_int_eq(settings_start(ghost->settings)->mode, 6);
    }
    ck_assert_int_eq(pinned, GHOSTS_MAX - 1);
    ck_assert_int_eq(loose, 1);
    /* back to one of them: it is unpinned */
    edit_one(experiment, "initial.mode", "2");
    ck_assert(experiment_pin(experiment, &status));
    pinned = 0;
    for (int i = 0; i < GHOSTS_MAX; i++)
        pinned += experiment_ghosts(experiment)[i].pinned;
    ck_assert_int_eq(pinned, GHOSTS_MAX - 2);
    experiment_destroy(experiment);
}
END_TEST

/* What a ghost shows along x is the field of its own run at the moment that was on screen, not of the run
 * that takes its place. */
START_TEST(a_ghost_keeps_what_was_on_screen)
{
    static const struct {
        const Problem *problem;
        const char *key, *value, *field;
        size_t count;
    } cases[] = {
        {&problem_bar, "mesh.cell_size", "0.5", "u", 50},
        {&problem_bar, "mpm.algorithm", "usl", "stress", 50},
        {&problem_supported_beam, "pd.surface_correction", "none", "vy", 0},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Settings settings =
            cases[i].problem == &problem_bar ? bar_settings(5, 10) : beam_settings(cases[i].problem, 1e-4);
        Experiment *experiment = open_experiment(&settings, MEGABYTE);
        ck_assert(experiment_advance(experiment, 60, NULL));
        experiment_seek(experiment, 40, 0);
        finish_work(experiment);
        const double time = experiment_time(experiment);
        Profile before;
        ck_assert(profile_take(&before, experiment_simulation(experiment), cases[i].field));
        ck_assert_int_eq(before.n_fields, 1);
        edit_one(experiment, cases[i].key, cases[i].value);
        const Ghost *ghost = &experiment_ghosts(experiment)[0];
        ck_assert(ghost->used);
        ck_assert_int_eq(ghost->profile.n_fields, PROFILE_FIELDS);
        ck_assert(ghost->profile.time == time);
        if (cases[i].count > 0)
            ck_assert_uint_eq(ghost->profile.count, cases[i].count);
        ck_assert_uint_eq(ghost->profile.count, before.count);
        const double *kept = profile_values(&ghost->profile, cases[i].field), *was = before.values[0];
        ck_assert_mem_eq(kept, was, before.count * sizeof *was);
        ck_assert_mem_eq(ghost->profile.x, before.x, before.count * sizeof *was);
        ck_assert_ptr_null(profile_values(&before, "density"));
        ck_assert(experiment_advance(experiment, 3, NULL));
        Profile after;
        ck_assert(profile_take(&after, experiment_simulation(experiment), cases[i].field));
        ck_assert(after.count != before.count || memcmp(after.values[0], was, before.count * sizeof *was));
        for (size_t k = 1; k < before.count; k++)
            ck_assert_msg(before.x[k] > before.x[k - 1], "case %zu: particle %zu is not in a row", i, k);
        profile_close(&before);
        profile_close(&after);
        experiment_destroy(experiment);
    }
}
END_TEST

START_TEST(a_million_steps_stay_within_bounds)
{
    Settings settings = bar_settings(1, 10000);
    set(&settings, "mesh.cell_size", "5");
    set(&settings, "time.courant", "0.02");
    Experiment *experiment = open_experiment(&settings, 8 * MEGABYTE);
    ck_assert_int_eq(experiment_last_step(experiment), 1000000);
    ck_assert(experiment_advance(experiment, 1000000, NULL));
    const Record *record = experiment_record(experiment);
    ck_assert(record->thinned);
    ck_assert_uint_le(record->room * (size_t)record->n_columns * sizeof(double), 32 * MEGABYTE);
    ck_assert_double_eq(record_row(record, record->count - 1)[0], 1e6);
    /* a row that is not kept is worked out */
    experiment_seek(experiment, 777777, 0);
    finish_work(experiment);
    ck_assert_ptr_null(record_of_step(record, 777777));
    const double *row = experiment_row(experiment);
    ck_assert_double_eq(row[0], 777777);
    ck_assert_double_eq_tol(row[1], 7777.77, 1e-9);
    ck_assert_double_eq_tol(row[6], row[11], 0.04); /* kinetic up to total */
    experiment_destroy(experiment);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("experiment");
    tcase_add_test(tcase, any_way_to_a_moment_of_a_bar_is_the_same);
    tcase_add_test(tcase, keyframes_are_given_up_under_a_small_budget);
    tcase_add_test(tcase, any_way_to_a_moment_of_a_bar_by_peridynamics_is_the_same);
    tcase_add_test(tcase, any_way_to_a_moment_of_a_beam_is_the_same);
    tcase_add_test(tcase, a_run_stops_at_its_end);
    tcase_add_test(tcase, a_run_ends_at_rest);
    tcase_add_test(tcase, an_edit_recomputes_to_the_time_on_screen);
    tcase_add_test(tcase, a_refused_edit_changes_nothing);
    tcase_add_test(tcase, a_live_parameter_changes_in_mid_run);
    tcase_add_test(tcase, a_column_that_went_comes_back);
    tcase_add_test(tcase, changes_in_mid_run_hold_on_any_way);
    tcase_add_test(tcase, undo_brings_back_what_was);
    tcase_add_test(tcase, live_edits_are_made_together_or_not_at_all);
    tcase_add_test(tcase, a_live_edit_at_either_end_holds_from_the_start);
    tcase_add_test(tcase, given_changes_stay_with_the_scenario);
    tcase_add_test(tcase, a_filter_survives_a_change_in_the_past);
    tcase_add_test(tcase, another_end_does_not_recompute);
    tcase_add_test(tcase, an_end_beyond_an_answer_recomputes);
    tcase_add_test(tcase, a_failed_run_keeps_its_rows);
    tcase_add_test(tcase, the_state_before_a_stage_is_known);
    tcase_add_test(tcase, curves_are_pinned_and_unpinned);
    tcase_add_test(tcase, a_ghost_keeps_what_was_on_screen);
    if (suite_wide()) /* seconds */
        tcase_add_test(tcase, a_million_steps_stay_within_bounds);
    suite_add_tcase(suite, tcase);
}
