/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a run stops at by itself: it stands at the very step, and nothing beyond has been computed. */
#include "suite.h"
#include "lab/tui_case.h"
#include "panes/panes.h"

#include <math.h>
#include <string.h>

static void run_until_paused(Bench *bench)
{
    for (int i = 0; i < 100000 && bench->lab.screen.playback->state != STATE_PAUSED; i++)
        frame(bench);
    ck_assert_int_eq(bench->lab.screen.playback->state, STATE_PAUSED);
}

static long step_of(const Bench *bench)
{
    return experiment_step(bench->lab.screen.experiment);
}

/* The steps of the first events of a kind, from a run of its own. */
static int steps_of(Bench *bench, EventKind kind, long steps[], int most)
{
    int count, found = 0;
    Status status = {STATUS_DONE, ""};
    for (int parts = 0; parts < 30 && found < most; parts++) {
        experiment_advance(laboratory_run(&bench->lab), 100, &status);
        const Event *events = experiment_events(bench->lab.screen.experiment, &count);
        for (int i = 0; i < count && found < most; i++)
            if (events[i].kind == kind && (found == 0 || events[i].step > steps[found - 1]))
                steps[found++] = events[i].step;
    }
    return found;
}

/* However fast it goes, whatever an engine's step takes, and with a run beside it or none. */
static const struct {
    const char *scenario, *line;
    EventKind kind;
    double pace, rate;
} hunts[] = {
    {"crossing", "until crossing", EVENT_CROSSING, 1, 0},
    {"crossing", "until next crossing", EVENT_CROSSING, 500, 0},
    {"crossing", "until crossing", EVENT_CROSSING, 500, 20}, /* a step takes longer than a frame */
    {"notched-beam-coarse", "until first break", EVENT_BREAK, 200, 0},
};

START_TEST(a_run_stops_at_the_step_of_its_event)
{
    if (!suite_wide() && hunts[_i].kind == EVENT_BREAK) /* seconds */
        return;
    long steps[3];
    Bench *plain = open_bench(hunts[_i].scenario, true);
    const int found = steps_of(plain, hunts[_i].kind, steps, 3);
    close_bench(plain);
    ck_assert_int_gt(found, 1);
    Bench *bench = open_bench(hunts[_i].scenario, true);
    bench->rate = hunts[_i].rate;
    for (int i = 0; i < (hunts[_i].rate > 0 ? 1 : 2); i++) {
        bench->lab.player.playback.pace = hunts[_i].pace;
        enter_line(bench, i == 0 ? hunts[_i].line : "until event");
        ck_assert_int_eq(bench->lab.screen.playback->state, STATE_RUNNING);
        run_until_paused(bench);
        ck_assert_int_eq(step_of(bench), steps[i]);
        ck_assert_int_eq(experiment_newest(bench->lab.screen.experiment), steps[i]);
        ck_assert_ptr_nonnull(strstr(bench->lab.screen.message->text, "stopped at t = "));
        ck_assert_str_eq(bench->lab.screen.playback->until, "");
    }
    close_bench(bench);
}
END_TEST

/* Bodies: the step of the touch, then that of the parting; on the way back both are there, as marks and for
 * keys. */
START_TEST(a_run_stops_where_bodies_touch)
{
    Bench *bench = open_bench("two-discs", true);
    bench->lab.player.playback.pace = 50;
    enter_line(bench, "until touch");
    run_until_paused(bench);
    const long touch = step_of(bench);
    ck_assert_double_eq_tol(experiment_time(bench->lab.screen.experiment), 1.5858, .04);
    ck_assert_ptr_nonnull(strstr(bench->lab.screen.message->text, "left touches right"));
    enter_line(bench, "until event");
    run_until_paused(bench);
    const long parting = step_of(bench);
    ck_assert_ptr_nonnull(strstr(bench->lab.screen.message->text, "left leaves right"));
    enter_line(bench, "goto 0");
    press(bench, "}");
    ck_assert_int_eq(step_of(bench), touch);
    press(bench, "}");
    ck_assert_int_eq(step_of(bench), parting);
    for (int i = 0; i < 4; i++) /* stage by stage over the touch, back and forth */
        press(bench, i == 0 ? "{" : ",");
    for (int i = 0; i < 40; i++)
        press(bench, i < 10 ? "[" : "]");
    int count;
    const Event *events = experiment_events(bench->lab.screen.experiment, &count);
    ck_assert_int_eq(count, 2);
    ck_assert(events[0].step == touch && events[1].step == parting);
    enter_line(bench, "open mode1");
    enter_line(bench, "until touch");
    ck_assert(shows(bench, "there are no bodies that can touch in this run"));
    enter_line(bench, "open two-discs");
    enter_line(bench, "until crossing");
    ck_assert(shows(bench, "cell crossings are not recorded in this run"));
    close_bench(bench);
}
END_TEST

/* Those of which the run keeps no more than their number. */
START_TEST(a_run_stops_at_an_event_that_is_not_kept)
{
    Bench *bench = open_bench("crossing", true);
    Status status = {STATUS_DONE, ""};
    enter_line(bench, "duel"); /* ends it */
    enter_line(bench, "mesh.cell_size=0.05");
    Experiment *experiment = laboratory_run(&bench->lab);
    const Simulation *sim = experiment_simulation(experiment);
    while (sim->events_beyond.of[EVENT_CROSSING] == 0)
        ck_assert(experiment_advance(experiment, 1, &status));
    const long known = sim->events_beyond.of[EVENT_CROSSING];
    bench->lab.player.playback.pace = 300;
    enter_line(bench, "until crossing");
    /* nor does another kind count for it */
    Stop other = {.kind = STOP_AT_EVENT, .events = 1u << EVENT_BREAK | 1u << EVENT_REST};
    stop_look(&other, experiment);
    run_until_paused(bench);
    ck_assert_int_gt(sim->events_beyond.of[EVENT_CROSSING], known);
    ck_assert(!stop_happened(&other, experiment));
    ck_assert_ptr_nonnull(strstr(bench->lab.screen.message->text, ": a crossing"));
    ck_assert_int_eq(experiment_newest(experiment), step_of(bench));
    close_bench(bench);
}
END_TEST

/* What did not come is told, and waited for no more. */
START_TEST(what_did_not_come_is_told)
{
    Bench *bench = open_bench("mode1", true);
    enter_line(bench, "time.end=0.5");
    enter_line(bench, "until crossing");
    for (int i = 0; i < 100000 && bench->lab.screen.playback->state != STATE_ENDED; i++)
        frame(bench);
    ck_assert_str_eq(bench->lab.screen.message->text, "the run has ended: a crossing did not come");
    ck_assert_str_eq(bench->lab.screen.playback->until, "");
    close_bench(bench);
}
END_TEST

START_TEST(a_run_stops_at_a_time_and_at_a_step)
{
    Bench *bench = open_bench("mode1", true);
    bench->lab.player.playback.pace = 70;
    enter_line(bench, "until t 2.505"); /* dt is 0.01 */
    run_until_paused(bench);
    ck_assert_int_eq(step_of(bench), 251);
    ck_assert_int_eq(experiment_newest(bench->lab.screen.experiment), 251);
    enter_line(bench, "until #400");
    press(bench, "Space"); /* who pauses on the way has not given up */
    ck_assert_int_lt(step_of(bench), 400);
    press(bench, "Space");
    run_until_paused(bench);
    ck_assert_int_eq(step_of(bench), 400);
    /* stepped up to by hand it is reached as well, and then forgotten */
    enter_line(bench, "until step 401");
    press(bench, "Space");
    press(bench, ".");
    press(bench, ".");
    press(bench, "Space");
    frame(bench);
    ck_assert_int_eq(bench->lab.screen.playback->state, STATE_RUNNING);
    ck_assert_str_eq(bench->lab.screen.playback->until, "");
    enter_line(bench, "open mode5");
    enter_line(bench, "until end");
    ck_assert_ptr_nonnull(strstr(bench->lab.screen.playback->until, "step"));
    enter_line(bench, "open mode1"); /* another run stops at nothing */
    ck_assert_str_eq(bench->lab.screen.playback->until, "");
    close_bench(bench);
}
END_TEST

START_TEST(a_stretch_comes_again)
{
    Bench *bench = open_bench("mode1", true);
    bench->lab.player.playback.pace = 7;
    enter_line(bench, "loop 1 1.5");
    int rounds = 0;
    for (long i = 0, before = 100; i < 400; i++) {
        frame(bench);
        ck_assert_int_ge(step_of(bench), i > 20 ? 100 : 0);
        ck_assert_int_le(step_of(bench), 150);
        rounds += step_of(bench) < before;
        before = step_of(bench);
    }
    ck_assert_int_ge(rounds, 5);
    ck_assert_int_eq(experiment_newest(bench->lab.screen.experiment), 150);
    /* one that ends with the run does not end it */
    enter_line(bench, "loop 99.5 100");
    for (int i = 0; i < 2000; i++) {
        frame(bench);
        ck_assert_int_ne(bench->lab.screen.playback->state, STATE_ENDED);
    }
    ck_assert_int_eq(experiment_newest(bench->lab.screen.experiment),
                     experiment_last_step(bench->lab.screen.experiment));
    enter_line(bench, "loop");
    for (int i = 0; i < 200; i++)
        frame(bench);
    ck_assert_int_eq(bench->lab.screen.playback->state, STATE_ENDED);
    close_bench(bench);
}
END_TEST

START_TEST(slow_motion_shows_every_stage)
{
    Bench *bench = open_bench("mode1", true);
    const int stages = experiment_simulation(bench->lab.screen.experiment)->n_stages;
    press(bench, "v");
    int seen = 0, before = 0;
    for (int i = 0; i < 20 * stages; i++) {
        ck_assert(laboratory_active(&bench->lab));
        frame(bench);
        const int stage = experiment_stage(bench->lab.screen.experiment);
        ck_assert_int_eq(stage, i % 20 == 0 ? (before + 1) % stages : before);
        seen += stage != before;
        before = stage;
    }
    ck_assert_int_eq(seen, stages);
    ck_assert_int_eq(step_of(bench), 1);
    enter_line(bench, "until step 2");
    ck_assert(!bench->lab.screen.playback->slow); /* it runs at its pace */
    run_until_paused(bench);
    press(bench, "v");
    press(bench, "v");
    ck_assert(!laboratory_active(&bench->lab));
    close_bench(bench);
}
END_TEST

/* Where the kinetic energy has gone and stays away: not at a turning point, and by whichever way it is
 * damped. */
static const struct {
    const char *line, *before; /* an edit, and what is done before the run is asked to find its rest */
    double from, to;
} rests[] = {{"time.rest=yes", NULL, 2.15e-3, 2.35e-3},
             {"time.rest=no", NULL, 2.4e-3, 2.55e-3},
             {"time.rest=no", "until t 0.001", 2.4e-3, 2.55e-3},
             {"damping.rate=7260", NULL, 3.0e-3, 3.8e-3}};

START_TEST(a_damped_run_stops_at_rest)
{
    Bench *bench = open_bench("hanging-beam", true);
    const Laboratory *lab = &bench->lab;
    enter_line(bench, "pd.horizon=4e-3");
    enter_line(bench, "pd.spacing=1e-3");
    if (_i > 0)
        enter_line(bench, "time.rest=no");
    enter_line(bench, rests[_i].line);
    enter_line(bench, "r");
    bench->lab.player.playback.pace = 500;
    if (rests[_i].before) {
        enter_line(bench, rests[_i].before);
        run_until_paused(bench);
    }
    enter_line(bench, "until rest");
    ck_assert_int_eq(lab->screen.playback->state, STATE_RUNNING);
    for (int i = 0; i < 100000 && lab->screen.playback->state == STATE_RUNNING; i++)
        frame(bench);
    const double time = experiment_time(lab->screen.experiment);
    ck_assert_msg(time >= rests[_i].from && time <= rests[_i].to, "%s: %g", rests[_i].line, time);
    const int kinetic = experiment_column(lab->screen.experiment, "kinetic");
    double most = 0;
    const Record *record = experiment_record(lab->screen.experiment);
    for (size_t i = 0; i < record->count; i++)
        most = fmax(most, record_row(record, i)[kinetic]);
    ck_assert_double_lt(experiment_row(lab->screen.experiment)[kinetic], 1e-10 * most);
    enter_line(bench, "time.rest=no");
    enter_line(bench, "damping.rate=0");
    enter_line(bench, "until rest");
    ck_assert(shows(bench, "nothing comes to rest without damping"));
    close_bench(bench);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("until");
    tcase_add_loop_test(tcase, a_run_stops_at_the_step_of_its_event, 0, sizeof hunts / sizeof *hunts);
    tcase_add_test(tcase, a_run_stops_where_bodies_touch);
    tcase_add_test(tcase, a_run_stops_at_an_event_that_is_not_kept);
    tcase_add_loop_test(tcase, a_damped_run_stops_at_rest, 0,
                        suite_wide() ? sizeof rests / sizeof *rests : 1);
    tcase_add_test(tcase, what_did_not_come_is_told);
    tcase_add_test(tcase, a_run_stops_at_a_time_and_at_a_step);
    tcase_add_test(tcase, a_stretch_comes_again);
    tcase_add_test(tcase, slow_motion_shows_every_stage);
    suite_add_tcase(suite, tcase);
}
