/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Two runs side by side: they stand at the same time whatever their steps are, and each is what it would be
 * alone. */
#include "run/duel.h"
#include "scenario/concern_cells.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "answers/comparison.h"
#include "answers/crack_growth.h"
#include "run/experiment_internal.h"
#include "run/lab_case.h"
#include "scenario/scenario.h"
#include "suite.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MEGABYTE = 1 << 20 };

static void finish(Duel *duel)
{
    for (long left; duel_pending(duel, &left);)
        duel_work(duel, (Effort){.steps = 7}, &(bool){false}, NULL);
}

static Duel begin(const Settings *settings, const char *keys, size_t history)
{
    Duel duel = {0};
    Assignment list[DUEL_MAX];
    Status status = {0};
    duel_open(&duel, open_experiment(settings, history), history, 1);
    const int count = duel_read_keys(keys, list, &status);
    ck_assert_msg(count > 0, "%s", status.text);
    ck_assert_msg(duel_start(&duel, list, count, &status), "%s", status.text);
    finish(&duel);
    return duel;
}

static void end(Duel *duel)
{
    Experiment *a = duel->a;
    duel_close(duel);
    experiment_destroy(a);
}

/* B stands at its whole step that is nearest to A's time and not beyond. */
static void expect_together(const Duel *duel)
{
    const double time = (double)experiment_step(duel->a) * experiment_simulation(duel->a)->dt;
    const double dt = experiment_simulation(duel->b)->dt, slack = 1e-9 * dt + 1e-12 * time;
    long last = experiment_last_step(duel->b);
    if (experiment_failed(duel->b, NULL))
        last = experiment_newest(duel->b);
    ck_assert_int_eq(experiment_stage(duel->b), 0);
    ck_assert_double_le(experiment_time(duel->b), time + slack);
    if (experiment_step(duel->b) < last)
        ck_assert_double_gt(experiment_time(duel->b) + dt, time + slack);
}

/* Each is the run that its settings give alone, to the last bit. */
static void expect_straight(Experiment *experiment)
{
    Settings settings;
    Status status = {0};
    experiment_scenario(experiment, false, &settings);
    Simulation *alone = problem_simulate(&settings, 1, &status);
    ck_assert_msg(alone != NULL, "%s", status.text);
    ck_assert(simulation_steps(alone, experiment_step(experiment), NULL, NULL, &status));
    for (int i = 0; i < experiment_stage(experiment); i++)
        ck_assert(simulation_stage(alone, &status));
    expect_same_states(experiment_simulation(experiment), alone, "a run of the duel");
    simulation_destroy(alone);
}

static void walk(Duel *duel, unsigned long *state)
{
    Experiment *a = duel->a;
    const long step = experiment_step(a), last = experiment_last_step(a);
    bool whole = false;
    int to;
    switch (draw(state, 8)) {
    case 0:
        ck_assert(duel_advance(duel, (Effort){.steps = 1}, &(bool){false}, NULL));
        break;
    case 1:
        ck_assert(duel_advance(duel, (Effort){.steps = 13}, &(bool){false}, NULL));
        break;
    case 2:
        ck_assert(duel_next_stage(duel, NULL));
        break;
    case 3:
        duel_seek(duel, step - 10, 0);
        break;
    case 4:
        to = (int)draw(state, 4); /* in this order, whichever the compiler's is */
        duel_seek(duel, (long)draw(state, (unsigned long)last), to);
        break;
    case 5:
        if (experiment_stage(a) == 0)
            while (!whole && !experiment_at_end(a) && draw(state, 20) > 0)
                ck_assert(duel_advance(duel, (Effort){.share = 0.3}, &whole, NULL));
        duel_drop_part(duel); /* B comes to where A is */
        ck_assert(!experiment_pending(a, NULL));
        break;
    case 6:
        duel_seek(duel, step + 25, 0);
        while (duel_pending(duel, NULL))
            ck_assert(duel_work(duel, (Effort){.share = 0.4}, &whole, NULL));
        break;
    default:
        duel_seek(duel, step, 0);
        break;
    }
    finish(duel);
}

START_TEST(both_stand_at_one_time)
{
    static const struct {
        const Problem *problem;
        double end;
        const char *keys;
    } cases[] = {
        {&problem_bar, 3, "mpm.algorithm=usl"},
        {&problem_bar, 3, "mesh.cell_size=0.5"},               /* two steps for one */
        {&problem_bar, 3, "time.courant=0.37 mpm.shape=gimp"}, /* no whole ratio, B is coarser */
        {&problem_bar, 3, "time.courant=0.03 mesh.particles_per_cell=3"},
        {&problem_bar, 3, "pd.horizon=2 scenario.method=pd"}, /* which keys there are depends on the method */
        {&problem_supported_beam, 4e-5, "pd.surface_correction=none"},
        {&problem_moving_cantilever, 4e-5, "motion.clamp=guide pd.horizon=0.0015"},
    };
    const Settings settings = cases[_i].problem == &problem_bar
                                  ? bar_settings(5, cases[_i].end)
                                  : beam_settings(cases[_i].problem, cases[_i].end);
    Duel duel = begin(&settings, cases[_i].keys, MEGABYTE);
    unsigned long state = 17;
    for (int i = 0; i < 40; i++) {
        walk(&duel, &state);
        expect_together(&duel);
        if (i % 8 == 0) {
            expect_straight(duel.a);
            expect_straight(duel.b);
        }
    }
    /* the end of A is the end of both */
    duel_seek(&duel, experiment_last_step(duel.a), 0);
    finish(&duel);
    expect_together(&duel);
    expect_straight(duel.a);
    expect_straight(duel.b);
    end(&duel);
}
END_TEST

START_TEST(it_can_begin_in_the_middle)
{
    const Settings settings = bar_settings(5, 10);
    Duel duel = {0};
    Assignment keys[DUEL_MAX];
    Status status = {0};
    duel_open(&duel, open_experiment(&settings, MEGABYTE), MEGABYTE, 1);
    ck_assert(duel_advance(&duel, (Effort){.steps = 333}, &(bool){false}, NULL));
    ck_assert_int_eq(duel_read_keys("  mpm.algorithm=usl   time.courant=0.07 ", keys, &status), 2);
    ck_assert_str_eq(keys[1].key, "time.courant");
    ck_assert_str_eq(keys[1].value, "0.07");
    ck_assert_msg(duel_start(&duel, keys, 2, &status), "%s", status.text);
    ck_assert(duel_pending(&duel, NULL));
    ck_assert_ptr_eq(duel_turn(&duel), duel.b);
    finish(&duel);
    ck_assert_int_eq(experiment_step(duel.a), 333);
    expect_together(&duel);
    ck_assert_str_eq(duel.names[0], "USF, 0.1");
    ck_assert_str_eq(duel.names[1], "USL, 0.07");
    ck_assert(duel.same_exact);
    /* given up while A waits: the duel is over */
    duel_seek(&duel, 900, 0);
    while (experiment_pending(duel.a, NULL))
        experiment_work(duel.a, (Effort){.steps = 100}, &(bool){false}, NULL);
    duel_cancel(&duel);
    ck_assert_ptr_null(duel.b);
    ck_assert(!duel_pending(&duel, NULL));
    ck_assert(!experiment_ghosts(duel.a)[0].used);
    end(&duel);
}
END_TEST

static const char *in_table(const Comparison *rows, int count, const char *label, int run)
{
    for (int i = 0; i < count; i++)
        if (strcmp(rows[i].label, label) == 0)
            return rows[i].values[run];
    return "";
}

/* Values of rows are keys like others: they have their names and their line in the table; and a plate is
 * told by its cracks. */
START_TEST(plates_differ_by_a_row)
{
    Settings settings;
    Status status = {0};
    ck_assert_msg(scenario_load("pulled-plate", &settings, &status), "%s", status.text);
    set(&settings, "pd.spacing", "2e-3");
    set(&settings, "pd.horizon", "6e-3");
    Duel duel = begin(&settings, "loads.top.sy=9e6 pd.critical_energy=50", 1 << 20);
    duel_seek(&duel, 400, 0);
    finish(&duel);
    ck_assert_str_eq(duel.names[0], "6e6, 204");
    ck_assert_str_eq(duel.names[1], "9e6, 50");
    Comparison rows[COMPARISONS_MAX];
    const int count = comparison_of_duel(&duel, rows);
    ck_assert_str_eq(in_table(rows, count, "loads.top.sy", 0), "6e6");
    ck_assert_str_eq(in_table(rows, count, "loads.top.sy", 1), "9e6");
    for (int run = 0; run < 2; run++) {
        const CrackFronts *fronts = experiment_fronts(run ? duel.b : duel.a);
        FrontsFacts facts;
        ck_assert_ptr_nonnull(fronts);
        crack_fronts_facts(fronts, &facts);
        ck_assert_int_eq(atol(in_table(rows, count, "broken bonds", run)), facts.broken);
        ck_assert_int_eq(atol(in_table(rows, count, "tips of cracks", run)), facts.n_tips);
        ck_assert_double_eq_tol(atof(in_table(rows, count, "fastest, m/s", run)), facts.fastest, 0.5);
    }
    end(&duel);
}
END_TEST

/* A silent mistake shows in digits, and two right codes need
 * no row of them. */
START_TEST(a_mistake_is_told_by_digits)
{
    const Settings settings = bar_settings(5, 10);
    Comparison rows[COMPARISONS_MAX];
    Duel duel = begin(&settings, "mpm.mistake=moved_weights", MEGABYTE);
    duel_seek(&duel, 2, 0);
    finish(&duel);
    int count = comparison_of_duel(&duel, rows);
    ck_assert_str_eq(in_table(rows, count, "v_cm", 0), "0.00703479151");
    ck_assert_str_eq(in_table(rows, count, "v_cm", 1), "0.00703477412");
    end(&duel);
    duel = begin(&settings, "mpm.algorithm=usl", MEGABYTE);
    count = comparison_of_duel(&duel, rows);
    ck_assert_str_eq(in_table(rows, count, "v_cm", 0), "");
    end(&duel);
}
END_TEST

START_TEST(wrong_keys_are_refused)
{
    static const struct {
        const char *keys, *why;
    } cases[] = {
        {"mpm.algorithm", "mpm.algorithm is not KEY=VALUE"},
        {"mpm.algorithm=usx", "mpm.algorithm: usx is not a choice (usf | usl | musl)"},
        {"mpm.algoritm=usl", "mpm.algoritm: unknown key (did you mean mpm.algorithm?)"},
        {"mpm.algorithm=usf", "both runs would be the same: a key must differ"},
        {"mesh.cell_size=0.7",
         "mesh.cell_size: the length 25 must be a whole number of cells, not 35.71428571"},
    };
    const Settings settings = bar_settings(5, 10);
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        Duel duel = {0};
        Assignment keys[DUEL_MAX];
        Status status = {0};
        duel_open(&duel, open_experiment(&settings, MEGABYTE), MEGABYTE, 1);
        const int count = duel_read_keys(cases[i].keys, keys, &status);
        ck_assert(count < 0 || !duel_start(&duel, keys, count, &status));
        ck_assert_str_eq(status.text, cases[i].why);
        ck_assert_ptr_null(duel.b);
        ck_assert(duel_advance(&duel, (Effort){.steps = 10}, &(bool){false}, NULL)); /* A alone goes on */
        end(&duel);
    }
}
END_TEST

START_TEST(the_question_suggests_the_next_choice)
{
    Settings settings = beam_settings(&problem_moving_cantilever, 1e-4);
    Assignment keys[DUEL_MAX];
    char text[100];
    strcpy(settings.question, "motion.clamp");
    ck_assert_int_eq(duel_suggest(&settings, 0, keys), 1);
    duel_write_keys(keys, 1, text, sizeof text);
    ck_assert_str_eq(text, "motion.clamp=guide");
    settings = bar_settings(1, 10);
    ck_assert_int_eq(duel_suggest(&settings, 0, keys), 1);
    duel_write_keys(keys, 1, text, sizeof text);
    ck_assert_str_eq(text, "mpm.algorithm=usl");
    /* what can be left out is left out, not replaced by another kind of it */
    settings = beam_settings(&problem_supported_beam, 1e-4);
    ck_assert_int_eq(duel_suggest(&settings, 0, keys), 1);
    duel_write_keys(keys, 1, text, sizeof text);
    ck_assert_str_eq(text, "pd.surface_correction=none");
}
END_TEST

START_TEST(further_suggestions_are_all_good_for_a_duel)
{
    Settings settings = bar_settings(5, 10);
    Assignment keys[DUEL_MAX];
    char text[100];
    strcpy(settings.question, "mesh.cell_size");
    static const char *const first[] = {"mesh.cell_size=0.5", "mpm.algorithm=usl", "mpm.shape=gimp"};
    for (int i = 0; i < 3; i++) {
        ck_assert_int_eq(duel_suggest(&settings, i, keys), 1);
        duel_write_keys(keys, 1, text, sizeof text);
        ck_assert_str_eq(text, first[i]);
    }
    int count = 0;
    for (; duel_suggest(&settings, count, keys); count++) {
        duel_write_keys(keys, 1, text, sizeof text);
        Duel duel = begin(&settings, text, MEGABYTE);
        end(&duel);
    }
    ck_assert_int_ge(count, 5);
}
END_TEST

START_TEST(a_failed_second_run_stays_behind)
{
    Settings settings = bar_settings(1, 60);
    set(&settings, "initial.velocity", "1");
    set(&settings, "mesh.padding", "16");
    Duel duel = begin(&settings, "mesh.padding=1", MEGABYTE);
    ck_assert(duel_advance(&duel, (Effort){.steps = 6000}, &(bool){false}, NULL));
    ck_assert(experiment_at_end(duel.a));
    Status why = {0};
    ck_assert(experiment_failed(duel.b, &why));
    const long stopped = experiment_step(duel.b);
    ck_assert_int_eq(stopped, experiment_newest(duel.b));
    ck_assert_int_gt(stopped, 10);
    ck_assert_int_lt(stopped, 3000);
    /* back before its end it is there again, and stops there again */
    duel_seek(&duel, stopped / 2, 0);
    finish(&duel);
    ck_assert_int_eq(experiment_step(duel.b), stopped / 2);
    duel_seek(&duel, stopped + 100, 0);
    finish(&duel);
    ck_assert_int_eq(experiment_step(duel.a), stopped + 100);
    ck_assert_int_eq(experiment_step(duel.b), stopped);
    expect_straight(duel.b);
    /* with more room it goes on */
    Settings wider = *experiment_settings(duel.a);
    set(&wider, "time.end", "50");
    ck_assert(duel_change(&duel, &wider, experiment_edit, NULL));
    ck_assert_int_eq(experiment_step(duel.b), stopped);
    end(&duel);
}
END_TEST

START_TEST(an_edit_restarts_both)
{
    const Settings settings = bar_settings(5, 10);
    Duel duel = begin(&settings, "mpm.algorithm=usl", MEGABYTE);
    ck_assert(duel_advance(&duel, (Effort){.steps = 400}, &(bool){false}, NULL));
    Settings edited = *experiment_settings(duel.a);
    set(&edited, "mesh.cell_size", "0.5");
    ck_assert(duel_change(&duel, &edited, experiment_edit, NULL));
    finish(&duel);
    ck_assert_int_eq(experiment_step(duel.a), 800); /* the time that was on screen */
    expect_together(&duel);
    ck_assert_double_eq(settings_mesh(experiment_settings(duel.b))->cell_size, 0.5);
    ck_assert_int_eq(settings_transfer(experiment_settings(duel.b))->algorithm, MPM_USL);
    expect_straight(duel.b);
    ck_assert(experiment_ghosts(duel.a)[0].used);
    /* a live parameter, too, holds from the start for both */
    edited = *experiment_settings(duel.a);
    set(&edited, "mpm.flip_fraction", "0.9");
    ck_assert(duel_change(&duel, &edited, experiment_edit, NULL));
    finish(&duel);
    ck_assert_int_eq(experiment_base(duel.a)->n_changes, 0);
    ck_assert_double_eq(settings_transfer(experiment_base(duel.b))->flip_fraction, 0.9);
    expect_together(&duel);
    expect_straight(duel.a);
    /* B's key is B's */
    edited = *experiment_settings(duel.a);
    set(&edited, "mpm.algorithm", "musl");
    ck_assert(duel_change(&duel, &edited, experiment_rerun, NULL));
    finish(&duel);
    ck_assert_int_eq(settings_transfer(experiment_settings(duel.b))->algorithm, MPM_USL);
    ck_assert_str_eq(duel.names[0], "MUSL");
    /* refused for A: nothing has changed for B */
    Experiment *before = duel.b;
    set(&edited, "mesh.cell_size", "0.7");
    ck_assert(!duel_change(&duel, &edited, experiment_edit, NULL));
    ck_assert_ptr_eq(duel.b, before);
    /* another end recomputes nothing */
    edited = *experiment_settings(duel.a);
    set(&edited, "time.end", "20");
    ck_assert(duel_change(&duel, &edited, experiment_edit, NULL));
    ck_assert_ptr_eq(duel.b, before);
    ck_assert(!duel_pending(&duel, NULL));
    ck_assert_double_eq(settings_time(experiment_base(duel.b))->end, 20);
    ck_assert(duel_restart(&duel, false, NULL));
    ck_assert_int_eq(experiment_step(duel.b), 0);
    ck_assert_int_eq(experiment_newest(duel.b), 0);
    ck_assert_ptr_eq(duel.b, before);
    end(&duel);
}
END_TEST

START_TEST(changes_in_mid_run_keep_their_time)
{
    Settings settings = bar_settings(5, 10);
    settings.n_changes = 2;
    settings.changes[0] = (Change){100, {"mpm.flip_fraction", "0.9"}};
    settings.changes[1] = (Change){200, {"mpm.algorithm", "musl"}};
    Duel duel = begin(&settings, "mesh.cell_size=0.5 mpm.algorithm=usl", MEGABYTE);
    const Settings *base = experiment_base(duel.b);
    ck_assert_int_eq(base->n_changes, 1); /* the algorithm is B's own */
    ck_assert_int_eq(base->changes[0].step, 200);
    ck_assert_int_eq(base->n_duel, 0);
    ck_assert(duel_advance(&duel, (Effort){.steps = 300}, &(bool){false}, NULL));
    ck_assert_double_eq(settings_transfer(experiment_settings(duel.b))->flip_fraction, 0.9);
    ck_assert_int_eq(settings_transfer(experiment_settings(duel.b))->algorithm, MPM_USL);
    expect_together(&duel);
    end(&duel);
}
END_TEST

START_TEST(the_memory_is_shared)
{
    const Settings settings = bar_settings(5, 40);
    Duel duel = {0};
    Assignment keys[DUEL_MAX];
    const size_t history = 64 << 10;
    duel_open(&duel, open_experiment(&settings, history), history, 1);
    ck_assert(duel_advance(&duel, (Effort){.steps = 2000}, &(bool){false}, NULL));
    ck_assert_uint_gt(duel.a->history.used, history / 2);
    ck_assert_int_eq(duel_read_keys("mpm.algorithm=usl", keys, NULL), 1);
    ck_assert(duel_start(&duel, keys, 1, NULL));
    finish(&duel);
    ck_assert(duel_advance(&duel, (Effort){.steps = 1000}, &(bool){false}, NULL));
    ck_assert_uint_le(duel.a->history.used, history / 2);
    ck_assert_uint_le(duel.b->history.used, history / 2);
    ck_assert_uint_gt(duel.b->history.count, 4);
    duel_seek(&duel, 77, 0);
    finish(&duel);
    expect_straight(duel.a);
    expect_straight(duel.b);
    duel_end(&duel);
    ck_assert_uint_eq(duel.a->history.budget, history);
    end(&duel);
}
END_TEST

START_TEST(its_curve_stays)
{
    const Settings settings = bar_settings(5, 10);
    Duel duel = begin(&settings, "mpm.algorithm=usl", MEGABYTE);
    ck_assert(duel_advance(&duel, (Effort){.steps = 500}, &(bool){false}, NULL));
    Record record;
    ck_assert(record_copy(&record, experiment_record(duel.b)));
    duel_end(&duel);
    ck_assert_ptr_null(duel.b);
    const Ghost *ghost = &experiment_ghosts(duel.a)[0];
    ck_assert(ghost->used && !ghost->pinned);
    expect_same_records(&record, &ghost->record, "the ghost of B");
    ck_assert_int_eq(settings_transfer(ghost->settings)->algorithm, MPM_USL);
    ck_assert_double_eq_tol(ghost->profile.time, 5, 1e-12);
    ck_assert_str_eq(ghost->legend, "USL");
    record_close(&record);
    end(&duel);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("duel");
    tcase_add_loop_test(tcase, both_stand_at_one_time, 0, 7);
    tcase_add_test(tcase, it_can_begin_in_the_middle);
    tcase_add_test(tcase, plates_differ_by_a_row);
    tcase_add_test(tcase, a_mistake_is_told_by_digits);
    tcase_add_test(tcase, wrong_keys_are_refused);
    tcase_add_test(tcase, the_question_suggests_the_next_choice);
    tcase_add_test(tcase, further_suggestions_are_all_good_for_a_duel);
    tcase_add_test(tcase, a_failed_second_run_stays_behind);
    tcase_add_test(tcase, an_edit_restarts_both);
    tcase_add_test(tcase, changes_in_mid_run_keep_their_time);
    tcase_add_test(tcase, the_memory_is_shared);
    tcase_add_test(tcase, its_curve_stays);
    suite_add_tcase(suite, tcase);
}
