/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What keys do to the laboratory, with a virtual clock and no terminal. */
#include "suite.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"
#include "scenario/rows/rows.h"
#include "views/view.h"
#include "lab/laboratory.h"
#include "lab/tui_case.h"
#include "lab/prompt/prompt.h"
#include "panes/screen.h"

#include <dirent.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

static void select_parameter(Bench *bench, const char *key)
{
    ParameterRow rows[PARAMETER_ROWS_MAX];
    int count = screen_parameter_rows(&bench->lab.screen, rows);
    bench->lab.screen.panes.focus = PANE_PARAMETERS;
    for (int i = 0; i < count; i++)
        if (rows[i].parameter && strcmp(rows[i].parameter->key, key) == 0) {
            bench->lab.parameters.selected = i;
            return;
        }
    ck_abort_msg("%s is not on the screen", key);
}

static double value(const Bench *bench, const char *key)
{
    return settings_number(experiment_settings(bench->lab.screen.experiment), parameter_find(key));
}

static long step_of(const Bench *bench)
{
    return experiment_step(bench->lab.screen.experiment);
}

/* The whole record of what is on screen equals that of a run that never was anything else. */
static void check_like_fresh(const Bench *bench)
{
    Status status = {STATUS_DONE, ""};
    const Experiment *edited = bench->lab.screen.experiment;
    Experiment *fresh = experiment_create(experiment_settings(edited), 1 << 20, 1, &status);
    ck_assert_msg(fresh != NULL, "%s", status.text);
    ck_assert(experiment_advance(fresh, experiment_step(edited), &status));
    const Record *one = experiment_record(edited), *other = experiment_record(fresh);
    ck_assert_uint_eq(one->count, other->count);
    ck_assert_int_eq(one->n_columns, other->n_columns);
    ck_assert_int_eq(memcmp(one->rows, other->rows, one->count * (size_t)one->n_columns * sizeof(double)), 0);
    experiment_destroy(fresh);
}

/* --- the table -------------------------------------------------------------------------------------- */

START_TEST(every_row_of_the_table_is_carried_out)
{
    for (int i = 0; i < n_commands; i++)
        ck_assert_msg(laboratory_can(commands[i].id), "%s", commands[i].name);
}
END_TEST

/* --- time ------------------------------------------------------------------------------------------- */

/* The fifth mode is half a period late at t = 13.1: within ten seconds, but a period can be followed. Cells
 * of half the size make it late too seldom to go faster still. */
START_TEST(a_late_run_is_late_within_ten_seconds)
{
    Bench *bench = open_bench("mode5", false);
    ck_assert_double_eq(bench->lab.screen.playback->pace, 5); /* 111 steps in 0.76 s */
    while (bench->time < 10)
        frame(bench);
    const Readout *readout = experiment_readout(bench->lab.screen.experiment);
    ck_assert_double_gt(readout_late(readout, experiment_time(bench->lab.screen.experiment)), 0.5);
    select_parameter(bench, "mesh.cell_size");
    press(bench, "Left");
    ck_assert_double_eq(bench->lab.screen.playback->pace, 10);
    close_bench(bench);
    bench = open_bench("mode10", false); /* late after three periods already: they take their time */
    ck_assert_double_eq(bench->lab.screen.playback->pace, 0.5);
    close_bench(bench);
}
END_TEST

START_TEST(a_period_lasts_three_seconds)
{
    Bench *bench = open_bench("mode1", false);
    ck_assert_int_eq(bench->lab.screen.playback->state, STATE_RUNNING);
    while (bench->time < 3)
        frame(bench);
    /* the first mode of the bar has a period of 10 */
    ck_assert_double_eq_tol(experiment_time(bench->lab.screen.experiment), 10, 0.3);
    close_bench(bench);
}
END_TEST

START_TEST(a_slow_engine_is_the_limit)
{
    Bench *bench = open_bench("mode1", false);
    bench->rate = 100;
    for (int i = 0; i < 60; i++) {
        double begin = bench->time;
        frame(bench);
        ck_assert_double_le(bench->time - begin, FRAME_SECONDS + 1.01 / bench->rate);
    }
    ck_assert(bench->lab.screen.playback->at_limit);
    ck_assert_double_eq_tol((double)step_of(bench), bench->time * 100, 20);
    bench->rate = 1e6;
    for (int i = 0; i < 60; i++)
        frame(bench);
    ck_assert(!bench->lab.screen.playback->at_limit);
    close_bench(bench);
}
END_TEST

START_TEST(faster_and_slower_in_1_2_5)
{
    Bench *bench = open_bench("mode1", true);
    bench->lab.player.playback.pace = 1;
    static const double paces[] = {2, 5, 10, 20, 50, 100};
    for (size_t i = 0; i < sizeof paces / sizeof *paces; i++) {
        press(bench, "+");
        ck_assert_double_eq_tol(bench->lab.screen.playback->pace, paces[i], 1e-9);
    }
    press_all(bench, "- - - - - - -");
    ck_assert_double_eq_tol(bench->lab.screen.playback->pace, 0.5, 1e-9);
    press(bench, "Space");
    for (int i = 0; i < 20; i++)
        frame(bench);
    ck_assert_int_eq(step_of(bench), 10);
    close_bench(bench);
}
END_TEST

START_TEST(steps_and_stages_go_both_ways)
{
    Bench *bench = open_bench("mode1", true);
    const Experiment *experiment = bench->lab.screen.experiment;
    press_all(bench, ". . > ] ] s");
    ck_assert_int_eq(step_of(bench), 12);
    ck_assert_int_eq(experiment_stage(experiment), 3);
    press(bench, "[");
    ck_assert_int_eq(experiment_stage(experiment), 2);
    press(bench, ","); /* back to where this step began */
    ck_assert_int_eq(step_of(bench), 12);
    ck_assert_int_eq(experiment_stage(experiment), 0);
    press(bench, "S");
    ck_assert_int_eq(step_of(bench), 11);
    ck_assert_int_eq(experiment_stage(experiment), experiment_simulation(experiment)->n_stages - 1);
    press(bench, "."); /* finishes the step */
    ck_assert_int_eq(step_of(bench), 12);
    press(bench, "<");
    ck_assert_int_eq(step_of(bench), 2);
    ck_assert_int_eq(experiment_newest(experiment), 12);
    press_all(bench, "0 , <");
    ck_assert_int_eq(step_of(bench), 0);
    press(bench, "$");
    ck_assert_int_eq(step_of(bench), 12);
    press_all(bench, "Home End");
    ck_assert_int_eq(step_of(bench), 12);
    press_all(bench, "m g # 4 0 Enter");
    ck_assert_int_eq(step_of(bench), 40);
    press(bench, "'");
    ck_assert_int_eq(step_of(bench), 12);
    press_all(bench, "g 2 . 5 Enter");
    ck_assert_double_eq_tol(experiment_time(experiment), 2.5, 1e-9);
    press(bench, "r");
    ck_assert_int_eq(step_of(bench), 0);
    ck_assert_int_eq(bench->lab.screen.playback->state, STATE_PAUSED);
    close_bench(bench);
}
END_TEST

START_TEST(the_end_pauses_with_a_summary)
{
    Bench *bench = open_bench("mode1", true);
    press_all(bench, "g 1 0 0 Enter");
    ck_assert_int_eq(bench->lab.screen.playback->state, STATE_ENDED);
    ck_assert_ptr_nonnull(bench->lab.screen.summary);
    ck_assert_int_eq(bench->lab.summary.steps, 10000);
    ck_assert(!laboratory_active(&bench->lab));
    press_all(bench, ". ] > $");
    ck_assert_int_eq(step_of(bench), 10000);
    press(bench, "g");
    press_all(bench, "1 0 1 Enter"); /* beyond the end: refused, and the reason is on the screen */
    ck_assert(bench->lab.screen.prompt->open);
    ck_assert(bench->lab.screen.prompt->problem[0] != '\0');
    press_all(bench, "Esc Space");
    ck_assert_int_eq(bench->lab.screen.playback->state, STATE_RUNNING);
    ck_assert_int_eq(step_of(bench), 0);
    close_bench(bench);
}
END_TEST

/* Enter in a table does what `:plot` does with the chosen row and column. */
START_TEST(a_table_is_followed_over_time)
{
    static const struct {
        const char *keys, *column;
    } cases[] = {{"7 Right Right Down Enter", "particle 2 u"},
                 {"7 7 Right Right Down Down Enter", "node 2 momentum"}};
    Bench *bench = open_bench("mode1", true);
    const Screen *screen = &bench->lab.screen;
    press_all(bench, ": p a r t i c l e Space 1 Enter : n o d e Space 0 Enter");
    press_all(bench, cases[_i].keys);
    const Settings *settings = experiment_settings(screen->experiment);
    ck_assert_str_eq(settings_output(settings)->follow, cases[_i].column);
    ck_assert_str_eq(screen->views.lower->word, "probe");
    const Simulation *sim = experiment_simulation(screen->experiment);
    ck_assert_str_eq(
        view_variant_word(screen->views.lower, screen, view_variant(screen->views.lower, screen)),
        sim->series[sim->n_series - 1].name);
    press(bench, ".");
    ck_assert(!screen->prompt->open);
    close_bench(bench);
}
END_TEST

/* A refusal swallows no hotkey, whatever was asked; keys of an editor and pasted text mend the answer. */
START_TEST(a_refused_answer_gives_way_to_the_next_key)
{
    static const char *const refused[] = {"g 1 0 1 Enter", ": n o n s e n s e Enter", "o n o n e Enter",
                                          "/ n o n s e n s e Enter"};
    Bench *bench = open_bench("mode1", true);
    const Prompt *prompt = bench->lab.screen.prompt;
    press(bench, ".");
    press_all(bench, refused[_i]);
    ck_assert_msg(prompt->open && prompt->problem[0], "%s", refused[_i]);
    press(bench, "Backspace");
    ck_assert(prompt->open && !prompt->problem[0]);
    press(bench, "Esc");
    press_all(bench, refused[_i]);
    press(bench, "P-.");
    ck_assert(prompt->open && step_of(bench) == 1);
    press(bench, "Esc");
    press_all(bench, refused[_i]);
    press(bench, ".");
    ck_assert(!prompt->open);
    ck_assert_int_eq(step_of(bench), 2);
    close_bench(bench);
}
END_TEST

/* An answer to an exercise that is refused is typed anew, and is no keys: q would leave the homework. */
START_TEST(a_refused_number_is_typed_anew)
{
    Bench *bench = open_bench("mode1", true);
    const Prompt *prompt = bench->lab.screen.prompt;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(lesson_play_open(&bench->lab, "homework-late", &status), "%s", status.text);
    while (lesson_exercise(&bench->lab.screen.lesson->lesson->pages[bench->lab.screen.lesson->page]) !=
           EXERCISE_NUMBER)
        press(bench, "n");
    press_all(bench, "Enter o n e Enter");
    ck_assert(prompt->open && prompt->problem[0]);
    press_all(bench, "q - 1");
    ck_assert(prompt->open && !prompt->problem[0] && !bench->lab.closed);
    ck_assert_str_eq(prompt->text, "q-1");
    close_bench(bench);
}
END_TEST

/* A name that is refused is typed anew, and is no keys. */
START_TEST(a_refused_name_is_typed_anew)
{
    Bench *bench = open_bench("mode1", true);
    const Prompt *prompt = bench->lab.screen.prompt;
    press_all(bench, ". x ^U / n o n e / a Enter");
    ck_assert(prompt->open && prompt->problem[0]);
    press_all(bench, ". b");
    ck_assert(prompt->open && !prompt->problem[0]);
    ck_assert_str_eq(prompt->text, ".b");
    ck_assert_int_eq(step_of(bench), 1);
    close_bench(bench);
}
END_TEST

/* A long way takes many frames, says how far it has come and can be cancelled. */
START_TEST(a_long_seek_is_cut_into_frames)
{
    Bench *bench = open_bench("mode1", true);
    bench->rate = 10000;
    press_all(bench, "g 9 0 Enter");
    ck_assert_int_eq(bench->lab.screen.playback->state, STATE_COMPUTING);
    double share = 0;
    for (int i = 0; i < 10; i++) {
        double begin = bench->time;
        frame(bench);
        ck_assert_double_le(bench->time - begin, FRAME_SECONDS + 0.005);
        ck_assert_double_gt(bench->lab.screen.playback->work_share, share);
        share = bench->lab.screen.playback->work_share;
    }
    press(bench, "^C");
    ck_assert_int_eq(bench->lab.screen.playback->state, STATE_PAUSED);
    ck_assert(!bench->lab.closed);
    ck_assert_int_gt(step_of(bench), 1000);
    ck_assert_int_lt(step_of(bench), 9000);
    close_bench(bench);
}
END_TEST

/* A step that takes longer than a frame is done in parts: no frame waits for it, and whoever looks in the
 * middle sees the step before. */
START_TEST(a_long_step_is_cut_into_frames)
{
    Bench *bench = open_bench("notched-beam-coarse", false);
    const Experiment *experiment = bench->lab.screen.experiment;
    bench->tick = 0.002;
    long steps = 0, quiet = 0;
    for (int i = 0; i < 200; i++) {
        double begin = bench->time;
        bool news = laboratory_frame(&bench->lab, begin + FRAME_SECONDS);
        ck_assert_double_le(bench->time - begin, FRAME_SECONDS + 8 * bench->tick);
        quiet += !news;
        if (!news)
            continue;
        ck_assert(laboratory_draw(&bench->lab, &bench->canvas, 80, 24));
        ck_assert_int_eq(step_of(bench), ++steps);
    }
    ck_assert_int_gt(steps, 2);
    ck_assert_int_gt(quiet, 20 * steps);
    /* a key in the middle */
    ck_assert(bench->lab.player.in_parts);
    ck_assert_int_gt(experiment_stage(experiment) + (int)experiment_simulation(experiment)->item, 0);
    press(bench, "1");
    ck_assert_int_eq(step_of(bench), steps);
    ck_assert_int_eq(experiment_stage(experiment), 0);
    check_like_fresh(bench);
    /* and a seek */
    press_all(bench, "g # 5 0 0 Enter");
    for (int i = 0; i < 100; i++)
        laboratory_frame(&bench->lab, bench->time + FRAME_SECONDS);
    press(bench, "Esc");
    ck_assert_int_eq(bench->lab.screen.playback->state, STATE_PAUSED);
    ck_assert_int_gt(step_of(bench), steps);
    ck_assert_int_eq(experiment_stage(experiment), 0);
    bench->tick = 0;
    check_like_fresh(bench);
    close_bench(bench);
}
END_TEST

/* So can the exact motion of a slow beam, which has very many oscillations. */
START_TEST(a_motion_that_is_solved_can_be_given_up)
{
    Bench *bench = open_bench("moving-cantilever-coarse", true);
    press_all(bench, ": m o t i o n . s p e e d = 1 e - 6 Enter");
    ck_assert(!bench->lab.screen.prompt->open);
    const Simulation *before = experiment_simulation(bench->lab.screen.experiment);
    bench->tick = 0.01;
    bench->gives_up = true;
    press_all(bench, ": t i m e . e n d = 2 Enter");
    ck_assert(bench->lab.screen.prompt->open);
    ck_assert_msg(strstr(bench->lab.screen.prompt->problem, "cancelled") != NULL, "%s",
                  bench->lab.screen.prompt->problem);
    ck_assert_ptr_eq(experiment_simulation(bench->lab.screen.experiment), before);
    close_bench(bench);
}
END_TEST

/* The building of a large beam says how far it is and can be given up; what was there stays. */
START_TEST(a_beam_that_is_built_can_be_given_up)
{
    Bench *bench = open_bench("notched-beam-coarse", true);
    const Simulation *before = experiment_simulation(bench->lab.screen.experiment);
    press_all(bench, "> >");
    bench->tick = 0.01;
    bench->gives_up = true;
    press_all(bench, ": p d . s p a c i n g = 8 e - 4 Enter");
    ck_assert(bench->lab.screen.prompt->open);
    ck_assert_msg(strstr(bench->lab.screen.prompt->problem, "cancelled") != NULL, "%s",
                  bench->lab.screen.prompt->problem);
    ck_assert_msg(strncmp(bench->progress, "building the run: ", 18) == 0 &&
                      strstr(bench->progress, "Esc cancels") != NULL,
                  "%s", bench->progress);
    ck_assert_ptr_eq(experiment_simulation(bench->lab.screen.experiment), before);
    ck_assert_int_eq(step_of(bench), 20);
    press(bench, "Esc");
    ck_assert(!shows(bench, "building"));
    press_all(bench, "o n o t c h e d - b e a m - c o a r s e Enter");
    ck_assert(bench->lab.screen.prompt->open);
    ck_assert_ptr_eq(experiment_simulation(bench->lab.screen.experiment), before);
    bench->gives_up = false;
    press(bench, "Enter");
    ck_assert(!bench->lab.screen.prompt->open);
    ck_assert_int_eq(step_of(bench), 0);
    int share = atoi(bench->progress + strcspn(bench->progress, "0123456789"));
    ck_assert_msg(share > 60 && share < 100, "%s", bench->progress);
    ck_assert(!shows(bench, "building"));
    close_bench(bench);
}
END_TEST

START_TEST(a_run_that_took_long_is_not_given_up_unasked)
{
    Bench *bench = open_bench("mode1", true);
    bench->rate = 1000;
    press_all(bench, ": t i m e . e n d = 5 Enter g 5 Enter");
    while (bench->lab.screen.playback->state == STATE_COMPUTING)
        frame(bench);
    ck_assert_int_eq(bench->lab.screen.playback->state, STATE_ENDED);
    press(bench, "Space"); /* half a second: at once */
    ck_assert_int_eq(bench->lab.screen.playback->state, STATE_RUNNING);
    bench->rate = 100;
    while (bench->lab.screen.playback->state == STATE_RUNNING)
        frame(bench);
    press(bench, "Space");
    ck_assert(bench->lab.screen.prompt->open && bench->lab.screen.prompt->yes_no);
    ck_assert_msg(shows(bench, "takes about 5 s"), "%s", bench->lab.screen.prompt->question);
    press(bench, "n");
    ck_assert_int_eq(bench->lab.screen.playback->state, STATE_ENDED);
    ck_assert_int_eq(step_of(bench), 500);
    press_all(bench, "Space y");
    ck_assert_int_eq(bench->lab.screen.playback->state, STATE_RUNNING);
    ck_assert_int_lt(step_of(bench), 10);
    close_bench(bench);
}
END_TEST

/* --- parameters ------------------------------------------------------------------------------------- */

START_TEST(ten_nudges_redraw_ten_times)
{
    Bench *bench = open_bench("mode1", true);
    bench->width = 132;
    bench->height = 43;
    press_all(bench, "g 2 0 Enter");
    select_parameter(bench, "initial.mode");
    for (int i = 0; i < 10; i++) {
        char *before = canvas_dump(&bench->canvas);
        press(bench, i < 5 ? "Right" : "Left");
        ck_assert_double_eq(value(bench, "initial.mode"), i < 5 ? i + 2 : 10 - i);
        ck_assert_int_eq(bench->lab.screen.playback->state, STATE_PAUSED);
        ck_assert_int_eq(step_of(bench), 2000);
        check_like_fresh(bench);
        char *after = canvas_dump(&bench->canvas);
        ck_assert_str_ne(before, after);
        free(before);
        free(after);
    }
    close_bench(bench);
}
END_TEST

START_TEST(nudges_of_the_cell_keep_the_time)
{
    Bench *bench = open_bench("mode1", true);
    press_all(bench, "g 2 0 Enter");
    select_parameter(bench, "mesh.cell_size");
    for (int i = 0; i < 10; i++) {
        press(bench, i % 4 < 2 ? "Left" : "Right");
        double dt = experiment_simulation(bench->lab.screen.experiment)->dt;
        ck_assert_double_eq_tol(experiment_time(bench->lab.screen.experiment), 20, 0.51 * dt);
        check_like_fresh(bench);
    }
    close_bench(bench);
}
END_TEST

START_TEST(a_field_is_edited_in_place)
{
    Bench *bench = open_bench("mode1", true);
    select_parameter(bench, "initial.velocity");
    press_all(bench, "Enter");
    ck_assert(bench->lab.parameters.edit.open);
    press_all(bench, "0 . 2 5 Enter");
    ck_assert(!bench->lab.parameters.edit.open);
    ck_assert_double_eq(value(bench, "initial.velocity"), 0.25);
    press_all(bench, "Enter Backspace 7 Enter"); /* 0.2 and 7 */
    ck_assert_double_eq(value(bench, "initial.velocity"), 0.27);
    press_all(bench, "Enter 9 Esc");
    ck_assert(!bench->lab.parameters.edit.open);
    ck_assert_double_eq(value(bench, "initial.velocity"), 0.27);
    close_bench(bench);
}
END_TEST

START_TEST(a_bad_value_says_why_and_keeps_the_old)
{
    static const char *const bad[] = {"- 1", "a b c", "0", "1 e 9 9 9", "^U"};
    Bench *bench = open_bench("mode1", true);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        select_parameter(bench, "bar.length");
        press(bench, "Enter");
        press_all(bench, bad[i]);
        press(bench, "Enter");
        ck_assert_msg(bench->lab.parameters.edit.open, "'%s' was taken", bad[i]);
        ck_assert(bench->lab.parameters.edit.problem[0] != '\0');
        ck_assert_double_eq(value(bench, "bar.length"), 25);
        press(bench, "Esc");
        ck_assert_double_eq(value(bench, "bar.length"), 25);
    }
    close_bench(bench);
}
END_TEST

START_TEST(edits_are_undone_and_done_again)
{
    Bench *bench = open_bench("mode1", true);
    press(bench, ">");
    select_parameter(bench, "initial.mode");
    press_all(bench, "Right Right u");
    ck_assert_double_eq(value(bench, "initial.mode"), 2);
    press(bench, "u");
    ck_assert_double_eq(value(bench, "initial.mode"), 1);
    press_all(bench, "^R ^R");
    ck_assert_double_eq(value(bench, "initial.mode"), 3);
    press_all(bench, "u Right ^R"); /* a new edit takes the way forward away */
    ck_assert_double_eq(value(bench, "initial.mode"), 3);
    for (int i = 0; i < 100; i++)
        press(bench, "Right");
    for (int i = 0; i < 100; i++)
        press(bench, "u");
    ck_assert_double_lt(value(bench, "initial.mode"), 100);
    close_bench(bench);
}
END_TEST

START_TEST(the_question_makes_another_run)
{
    Bench *bench = open_bench("mode1", true);
    press_all(bench, "g 5 Enter t");
    ck_assert_double_eq(value(bench, "mpm.algorithm"), 1);
    ck_assert_int_eq(step_of(bench), 500);
    check_like_fresh(bench);
    const Ghost *ghosts = experiment_ghosts(bench->lab.screen.experiment);
    int used = 0;
    for (int i = 0; i < GHOSTS_MAX; i++)
        used += ghosts[i].used;
    ck_assert_int_eq(used, 1);
    close_bench(bench);
}
END_TEST

START_TEST(a_filter_shortens_the_list)
{
    Bench *bench = open_bench("mode1", true);
    press_all(bench, "/ v e l o Enter Right");
    ck_assert_double_eq(value(bench, "initial.velocity"), 0.2);
    press(bench, "/");
    press_all(bench, "z z z Enter");
    ck_assert(bench->lab.screen.prompt->open); /* nothing is called that */
    press_all(bench, "Esc");
    close_bench(bench);
}
END_TEST

/* --- places in the run ------------------------------------------------------------------------------ */

START_TEST(enter_in_the_log_goes_to_the_event)
{
    Bench *bench = open_bench("crossing", true);
    press(bench, "d"); /* a run alone */
    press_all(bench, "g # 2 0 0 0 Enter");
    while (bench->lab.screen.playback->state == STATE_COMPUTING)
        frame(bench);
    int count;
    bench->lab.screen.panes.focus = PANE_LOWER;
    press(bench, "9");
    const Event *events = experiment_events(bench->lab.screen.experiment, &count);
    const long newest = events[count - 1].step, before = events[count - 2].step, first = events[0].step;
    ck_assert_int_gt(count, 10);
    press(bench, "Enter");
    ck_assert_int_eq(step_of(bench), newest);
    press_all(bench, "Up Enter");
    ck_assert_int_eq(step_of(bench), before);
    for (int i = 0; i < 20; i++)
        press(bench, "PageUp");
    press(bench, "Enter");
    ck_assert_int_eq(step_of(bench), first);
    ck_assert(shows(bench, "crossed into cell"));
    ck_assert_int_eq(experiment_newest(bench->lab.screen.experiment), 2000);
    for (int i = 0; i < 20; i++)
        press(bench, "PageDown");
    ck_assert_int_eq(bench->lab.screen.log.event, -1); /* follows the newest again */
    close_bench(bench);
}
END_TEST

/* In both plots, whole screen or one pane, at two sizes: what is clicked is what Enter goes to. */
START_TEST(an_event_of_the_log_is_chosen_by_the_mouse)
{
    const PaneId pane = _i & 1 ? PANE_UPPER : PANE_LOWER;
    Bench *bench = open_bench("crossing", true);
    press(bench, "d"); /* a run alone */
    if (_i & 4)
        bench->width = 132, bench->height = 43;
    press_all(bench, "g # 2 0 0 0 Enter");
    while (bench->lab.screen.playback->state == STATE_COMPUTING)
        frame(bench);
    Screen *screen = &bench->lab.screen;
    screen->panes.focus = pane;
    press(bench, "9");
    if (_i & 2)
        press(bench, "z");
    int count;
    const Event *events = experiment_events(screen->experiment, &count);
    const Rect rect = screen_pane(screen, bench->width, bench->height, pane);
    ck_assert_int_gt(count, rect.height);
    ck_assert_int_ge(row_with(bench, events[count - 1].text), 0);
    ck_assert_int_lt(row_with(bench, events[0].text), 0);
    click_at(bench, "Click", rect.x + 5, rect.y + 1);
    const int chosen = screen->log.event < 0 ? count - 1 : screen->log.event;
    ck_assert_int_eq(chosen, count - (rect.height - 1));
    ck_assert_int_eq(row_with(bench, events[chosen].text), rect.y + 1); /* nothing has moved */
    press(bench, "Enter");
    ck_assert_int_eq(step_of(bench), events[chosen].step);
    press(bench, "Up"); /* beyond the first one that is seen */
    ck_assert_int_eq(screen->log.event, chosen - 1);
    ck_assert_int_eq(row_with(bench, events[chosen - 1].text), rect.y + 1);
    press(bench, "Down");
    ck_assert_int_eq(row_with(bench, events[chosen].text), rect.y + 2);
    for (int i = 0; i < count; i++)
        click_at(bench, "WheelUp", rect.x + 5, rect.y + 2);
    ck_assert_int_eq(row_with(bench, events[0].text), rect.y + 1);
    ck_assert_int_ge(screen->log.event, 0);
    ck_assert_int_lt(screen->log.event, rect.height - 1); /* kept in sight */
    for (int i = 0; i < count; i++)
        click_at(bench, "WheelDown", rect.x + 5, rect.y + 2);
    ck_assert_int_ge(row_with(bench, events[count - 1].text), 0);
    close_bench(bench);
}
END_TEST

START_TEST(the_log_of_a_duel_tells_of_both)
{
    Bench *bench = open_bench("crossing", true);
    ck_assert(line_run(&bench->lab, "duel mpm.algorithm=usl time.courant=0.07", NULL));
    ck_assert_ptr_nonnull(bench->lab.player.duel.b);
    press_all(bench, "g # 1 0 0 0 Enter");
    while (bench->lab.screen.playback->state == STATE_COMPUTING)
        frame(bench);
    Screen *screen = &bench->lab.screen;
    screen->panes.focus = PANE_LOWER;
    press(bench, "9");
    int first, second;
    experiment_events(bench->lab.player.duel.a, &first);
    const Event *events = experiment_events(bench->lab.player.duel.b, &second);
    ck_assert_int_gt(first, 2);
    ck_assert_int_gt(second, 2);
    char text[80];
    snprintf(text, sizeof text, "%d events of A, %d of B", first, second);
    ck_assert(shows(bench, text));
    /* all are there, in the order of time; Enter at one of B's brings B there */
    int seen = 0;
    long before = -1;
    for (int i = 0; i < first + second; i++) {
        screen->log.event = i;
        press(bench, "Enter");
        while (bench->lab.screen.playback->state == STATE_COMPUTING)
            frame(bench);
        ck_assert_int_ge(step_of(bench), before);
        before = step_of(bench);
        seen += seen < second && experiment_step(bench->lab.player.duel.b) >= events[seen].step &&
                experiment_step(bench->lab.player.duel.b) <= events[seen].step + 1;
    }
    ck_assert_int_eq(seen, second);
    close_bench(bench);
}
END_TEST

START_TEST(arrows_leave_a_node_that_a_coarser_mesh_lacks)
{
    Bench *bench = open_bench("mode5", true);
    Screen *screen = &bench->lab.screen;
    screen->chosen.is_node = true;
    screen->chosen.node = experiment_simulation(screen->experiment)->counts[1] - 1;
    ck_assert(line_run(&bench->lab, "mesh.cell_size=5", NULL));
    screen->panes.focus = _i ? PANE_INSPECTOR : PANE_MESH;
    press(bench, "Left");
    ck_assert_uint_eq(screen->chosen.node, experiment_simulation(screen->experiment)->counts[1] - 2);
    close_bench(bench);
}
END_TEST

START_TEST(a_click_into_the_strip_chooses)
{
    Bench *bench = open_bench(_i ? "mode5-peridynamics" : "mode5", true);
    Screen *screen = &bench->lab.screen;
    bench->width = 132; /* all of it is seen */
    press(bench, "Esc");
    const Rect rect = screen_pane(screen, bench->width, bench->height, PANE_MESH);
    const size_t particles = experiment_simulation(screen->experiment)->counts[0];
    size_t before = 0;
    for (int x = rect.x; x < rect.x + 112; x++) { /* from left to right, none is left out */
        click_at(bench, "Click", x, rect.y + rect.height - 1);
        ck_assert(!screen->chosen.is_node);
        ck_assert_uint_ge(screen->chosen.particle, before);
        ck_assert_uint_le(screen->chosen.particle, before + 1);
        before = screen->chosen.particle;
    }
    ck_assert_uint_eq(before, particles - 1);
    ck_assert_int_eq(screen->panes.focus, PANE_MESH);
    if (_i == 0) {
        for (int x = rect.x + 1; x < rect.x + 76;
             x++) { /* in the row of the grid a particle may lie nearer across */
            click_at(bench, "Click", x, rect.y);
            ck_assert_msg(screen->chosen.is_node, "column %d", x);
        }
        click_at(bench, "Click", rect.x + 2 + 3 * 7, rect.y);
        ck_assert(screen->chosen.is_node);
        double x;
        const Simulation *sim = experiment_simulation(screen->experiment);
        sim->method->field(sim, simulation_find_field(sim, 1, "x"), screen->chosen.node, 1, &x);
        ck_assert_double_eq(x, 7);
    }
    close_bench(bench);
}
END_TEST

START_TEST(bookmarks_are_kept_in_the_order_of_the_run)
{
    Bench *bench = open_bench("mode1", true);
    press(bench, "'");
    ck_assert(shows(bench, "no bookmark yet"));
    press_all(bench, "> > m 0 > ] ] m $ >");
    ck_assert_int_eq(bench->lab.screen.bookmarks->count, 2);
    press(bench, "'"); /* behind the last one: the first */
    ck_assert_int_eq(step_of(bench), 10);
    ck_assert_int_eq(experiment_stage(bench->lab.screen.experiment), 2);
    ck_assert(shows(bench, "bookmark 1 of 2"));
    press(bench, "'");
    ck_assert_int_eq(step_of(bench), 20);
    press(bench, "'");
    ck_assert_int_eq(step_of(bench), 10);
    press(bench, "m"); /* on one: away with it */
    ck_assert_int_eq(bench->lab.screen.bookmarks->count, 1);
    press_all(bench, "$ '");
    ck_assert_int_eq(step_of(bench), 20);
    /* with half the time step it stays at its time */
    select_parameter(bench, "mesh.cell_size");
    press_all(bench, "Left Left 0 '");
    const double dt = experiment_simulation(bench->lab.screen.experiment)->dt;
    ck_assert_double_eq_tol((double)step_of(bench) * dt, 0.2, 1e-9);
    for (int i = 0; i < 2 * BOOKMARKS_MAX; i++)
        press_all(bench, ". m");
    ck_assert_int_eq(bench->lab.screen.bookmarks->count, BOOKMARKS_MAX);
    press_all(bench, "o m o d e 5 Enter '");
    ck_assert_int_eq(bench->lab.screen.bookmarks->count, 0);
    close_bench(bench);
}
END_TEST

/* --- leaving ---------------------------------------------------------------------------------------- */

START_TEST(quitting_asks_once_after_a_change)
{
    Bench *bench = open_bench("mode1", true);
    press(bench, "q");
    ck_assert(bench->lab.closed);
    close_bench(bench);
    bench = open_bench("mode1", true);
    select_parameter(bench, "initial.mode");
    press_all(bench, "Right q");
    ck_assert(!bench->lab.closed);
    ck_assert(bench->lab.screen.prompt->open);
    press_all(bench, "n");
    ck_assert(!bench->lab.closed && !bench->lab.screen.prompt->open);
    press_all(bench, "q y");
    ck_assert(bench->lab.closed);
    close_bench(bench);
}
END_TEST

/* Through all pages and around, also over the end of a line; at 80x24. */
START_TEST(slash_searches_the_help)
{
    static const char *const words = "s p e c t r u m Enter";
    Bench *bench = open_bench("mode1", true);
    press_all(bench, "? /");
    press_all(bench, words);
    ck_assert_int_eq(bench->lab.help.page, 0); /* the key of a view tells it */
    const int first = bench->lab.help.found;
    press_all(bench, "/ Enter");
    ck_assert_int_eq(bench->lab.help.page, 1);
    ck_assert(shows(bench, "how large each sine in the record is"));
    press_all(bench, "/ Enter");
    ck_assert(bench->lab.help.page == 0 && bench->lab.help.found == first);
    press_all(bench, "/ w h i l e Space t h e Space r u n Space g Enter"); /* parted by the end of a line */
    ck_assert(!bench->lab.prompting.shown.open && shows(bench, "A number with ~"));
    press_all(bench, "/ z z z Enter");
    ck_assert(bench->lab.prompting.shown.open && shows(bench, "the help does not have these words"));
    press_all(bench, "f r a c t u r Enter");
    ck_assert(bench->lab.prompting.shown.open);
    press_all(bench, "Esc Up");
    ck_assert(bench->lab.help.open && bench->lab.help.found == 0);
    close_bench(bench);
}
END_TEST

START_TEST(quitting_closes_what_is_open_first)
{
    Bench *bench = open_bench("mode1", true);
    press_all(bench, "? q");
    ck_assert(!bench->lab.closed && !bench->lab.help.open);
    press_all(bench, "z q");
    ck_assert(!bench->lab.closed && !bench->lab.screen.panes.zoomed);
    press_all(bench, "Enter F10");
    ck_assert(!bench->lab.closed && !bench->lab.parameters.edit.open);
    press_all(bench, ": F10");
    ck_assert(!bench->lab.closed && !bench->lab.screen.prompt->open);
    press(bench, "F10");
    ck_assert(bench->lab.closed);
    close_bench(bench);
}
END_TEST

/* --- files ------------------------------------------------------------------------------------------ */

START_TEST(export_writes_and_does_not_overwrite)
{
    char folder[64];
    enter_folder(folder);
    Bench *bench = open_bench("mode1", true);
    press(bench, "x");
    ck_assert(shows(bench, "nothing has been computed yet"));
    press_all(bench, "q Enter"); /* a name, not a key */
    ck_assert(!bench->lab.closed && shows(bench, "nothing has been computed yet"));
    press_all(bench, "Esc > x");
    ck_assert_str_eq(bench->lab.screen.prompt->text, "mode1");
    press(bench, "Enter");
    ck_assert_msg(shows(bench, "mode1-series.csv (11 rows)"), "%s", bench->lab.screen.message->text);
    static const char *const files[] = {"mode1-series.csv",    "mode1-series.csv.ini",
                                        "mode1-particles.csv", "mode1-particles.csv.ini",
                                        "mode1-nodes.csv",     "mode1-nodes.csv.ini"};
    for (size_t i = 0; i < sizeof files / sizeof *files; i++)
        ck_assert_msg(access(files[i], R_OK) == 0, "%s", files[i]);
    press(bench, "x");
    ck_assert_str_eq(bench->lab.screen.prompt->text, "mode1-2"); /* what is there is not proposed again */
    press_all(bench, "m o d e 1 Enter");
    ck_assert(bench->lab.screen.prompt->open && bench->lab.screen.prompt->yes_no);
    press(bench, "n");
    ck_assert(!bench->lab.screen.prompt->open);
    press_all(bench, ", , x h e r e Enter");
    press_all(bench, "m o d e 1 . c s v Enter y");
    ck_assert(shows(bench, "mode1-series.csv (9 rows)"));
    press_all(bench, "$ x / n o / w h e r e Enter"); /* no such folder: another name is asked for */
    ck_assert(bench->lab.screen.prompt->open);
    ck_assert(shows(bench, "there is no folder /no"));
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

static int count_files(void)
{
    DIR *folder = opendir(".");
    int count = 0;
    ck_assert_ptr_nonnull(folder);
    for (struct dirent *entry; (entry = readdir(folder));)
        count += entry->d_name[0] != '.';
    closedir(folder);
    return count;
}

/* A disk that is full on the way, as the system tells it: a file must not grow. */
START_TEST(a_full_disk_costs_nothing_that_was_there)
{
    char folder[64];
    struct rlimit room, before;
    enter_folder(folder);
    Bench *bench = open_bench("mode1", true);
    press_all(bench, "> w a . i n i Enter");
    ck_assert_int_eq(count_files(), 1);
    signal(SIGXFSZ, SIG_IGN);
    ck_assert_int_eq(getrlimit(RLIMIT_FSIZE, &before), 0);
    room = (struct rlimit){300, before.rlim_max};
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &room), 0);
    press_all(bench, "x b Enter");
    ck_assert_int_eq(bench->lab.screen.message->kind, MESSAGE_ERROR);
    ck_assert_msg(shows(bench, "File too large"), "%s", bench->lab.screen.message->text);
    press_all(bench, "w a . i n i Enter y");
    ck_assert_int_eq(bench->lab.screen.message->kind, MESSAGE_ERROR);
    ck_assert_msg(shows(bench, "File too large"), "%s", bench->lab.screen.message->text);
    ck_assert_int_eq(setrlimit(RLIMIT_FSIZE, &before), 0);
    ck_assert_int_eq(count_files(), 1);
    /* what was there is still whole */
    press_all(bench, "o a . i n i Enter");
    ck_assert(!bench->lab.screen.prompt->open);
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

START_TEST(scenarios_are_written_and_opened)
{
    char folder[64];
    enter_folder(folder);
    Bench *bench = open_bench("mode1", true);
    select_parameter(bench, "initial.mode");
    press_all(bench, "Right Right > w t h r e e . i n i Enter");
    ck_assert_msg(access("three.ini", R_OK) == 0, "%s", bench->lab.screen.message->text);
    press_all(bench, "o m o d e 5 Enter");
    ck_assert_double_eq(value(bench, "initial.mode"), 5);
    press_all(bench, "Space o t h r e e . i n i Enter");
    ck_assert_double_eq(value(bench, "initial.mode"), 3);
    ck_assert_double_eq(value(bench, "time.end"), 100);
    press_all(bench, "o n o n e Enter");
    ck_assert(bench->lab.screen.prompt->open && bench->lab.screen.prompt->problem[0]);
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

START_TEST(who_does_a_session_again_is_not_suspended_again)
{
    Bench *bench = open_bench("mode1", true);
    press(bench, "^Z");
    ck_assert_int_eq(bench->suspended, 1);
    bench->lab.asker = ASKER_REPLAY;
    press(bench, "^Z");
    ck_assert_int_eq(bench->suspended, 1);
    close_bench(bench);
}
END_TEST

START_TEST(the_command_line_takes_commands_values_and_times)
{
    Bench *bench = open_bench("mode1", true);
    press_all(bench, ": i n i t i a l . m o d e = 4 Enter");
    ck_assert_double_eq(value(bench, "initial.mode"), 4);
    press_all(bench, ": s t e p Enter");
    ck_assert_int_eq(step_of(bench), 1);
    press_all(bench, ": 2 Enter");
    ck_assert_double_eq_tol(experiment_time(bench->lab.screen.experiment), 2, 1e-9);
    press_all(bench, ": m e s h . c e Tab 0 . 5 Enter");
    ck_assert_double_eq(value(bench, "mesh.cell_size"), 0.5);
    press_all(bench, ": n o n s e n s e Enter");
    ck_assert(bench->lab.screen.prompt->open && bench->lab.screen.prompt->problem[0]);
    close_bench(bench);
}
END_TEST

/* A row that gets another name keeps its place and all digits; one value that is edited is the only one. */
START_TEST(rows_keep_their_digits)
{
    Bench *bench = open_bench("two-cracks", true);
    char text[ROW_TEXT_MAX];
    press_all(bench, ": c u t Space l e f t Space 0 Space 2 6 m m Space 1 0 0 / 3 m m Space 2 6 m m Enter");
    press_all(bench, "/ c u t s Enter");
    press_all(bench, "Enter Backspace 7 Home Delete Delete Delete Delete n e w Enter");
    ck_assert_msg(!bench->lab.parameters.edit.open, "%s", bench->lab.parameters.edit.problem);
    const Settings *settings = experiment_settings(bench->lab.screen.experiment);
    ck_assert_str_eq(settings->rows[ROWS_CUTS].rows[0].name, "new");
    ck_assert_str_eq(settings->rows[ROWS_CUTS].rows[1].name, "right");
    settings_row_get(settings, ROWS_CUTS, 0, text);
    ck_assert_str_eq(text, "0 0.026 0.03333333333333333 0.027");
    close_bench(bench);
}
END_TEST

/* A clock by which whatever is asked has taken a second, and an interrupt that has come. */
static double a_second_later(void *context)
{
    static double time;
    (void)context;
    return time += 1;
}

static bool gives_up(void *context)
{
    (void)context;
    return false;
}

/* An interrupt that is not a key stops a study as the key does: the point that is worked on is the last one.
 */
START_TEST(an_interrupt_stops_a_study)
{
    Bench *bench = open_bench("supported-beam-coarse", true);
    enter_line(bench, "show convergence");
    ck_assert(refining_is_due(&bench->lab));
    bench->lab.host.now = a_second_later;
    bench->lab.host.go_on = gives_up;
    refining_work(&bench->lab);
    ck_assert(!refining_is_due(&bench->lab));
    ck_assert_ptr_nonnull(strstr(bench->lab.message.text, "stopped; show the view again"));
    close_bench(bench);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("laboratory");
    tcase_add_loop_test(tcase, a_table_is_followed_over_time, 0, 2);
    tcase_add_loop_test(tcase, a_refused_answer_gives_way_to_the_next_key, 0, 4);
    tcase_add_test(tcase, a_refused_number_is_typed_anew);
    tcase_add_test(tcase, a_refused_name_is_typed_anew);
    tcase_add_test(tcase, every_row_of_the_table_is_carried_out);
    tcase_add_test(tcase, a_late_run_is_late_within_ten_seconds);
    tcase_add_test(tcase, a_period_lasts_three_seconds);
    tcase_add_test(tcase, a_slow_engine_is_the_limit);
    tcase_add_test(tcase, faster_and_slower_in_1_2_5);
    tcase_add_test(tcase, steps_and_stages_go_both_ways);
    tcase_add_test(tcase, the_end_pauses_with_a_summary);
    tcase_add_test(tcase, a_long_seek_is_cut_into_frames);
    tcase_add_test(tcase, a_long_step_is_cut_into_frames);
    tcase_add_test(tcase, a_beam_that_is_built_can_be_given_up);
    tcase_add_test(tcase, a_motion_that_is_solved_can_be_given_up);
    tcase_add_test(tcase, a_run_that_took_long_is_not_given_up_unasked);
    tcase_add_test(tcase, ten_nudges_redraw_ten_times);
    tcase_add_test(tcase, nudges_of_the_cell_keep_the_time);
    tcase_add_test(tcase, a_field_is_edited_in_place);
    tcase_add_test(tcase, a_bad_value_says_why_and_keeps_the_old);
    tcase_add_test(tcase, edits_are_undone_and_done_again);
    tcase_add_test(tcase, the_question_makes_another_run);
    tcase_add_test(tcase, a_filter_shortens_the_list);
    tcase_add_test(tcase, enter_in_the_log_goes_to_the_event);
    tcase_add_loop_test(tcase, an_event_of_the_log_is_chosen_by_the_mouse, 0, 8);
    tcase_add_test(tcase, the_log_of_a_duel_tells_of_both);
    tcase_add_loop_test(tcase, arrows_leave_a_node_that_a_coarser_mesh_lacks, 0, 2);
    tcase_add_loop_test(tcase, a_click_into_the_strip_chooses, 0, 2);
    tcase_add_test(tcase, bookmarks_are_kept_in_the_order_of_the_run);
    tcase_add_test(tcase, quitting_asks_once_after_a_change);
    tcase_add_test(tcase, slash_searches_the_help);
    tcase_add_test(tcase, quitting_closes_what_is_open_first);
    tcase_add_test(tcase, export_writes_and_does_not_overwrite);
    tcase_add_test(tcase, a_full_disk_costs_nothing_that_was_there);
    tcase_add_test(tcase, scenarios_are_written_and_opened);
    tcase_add_test(tcase, rows_keep_their_digits);
    tcase_add_test(tcase, who_does_a_session_again_is_not_suspended_again);
    tcase_add_test(tcase, the_command_line_takes_commands_values_and_times);
    tcase_add_test(tcase, an_interrupt_stops_a_study);
    suite_add_tcase(suite, tcase);
}
