/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `:diagnose` names the mistake in the box and lays the curve over the plots; it leaves the run as it is, and
 * can be given up. */
#include "suite.h"
#include "scenario/concern_output.h"
#include "lab/tui_case.h"
#include "panes/screen.h"

#include "export/export.h"
#include "scenario/parameters.h"
#include "scenario/scenario.h"

#include <stdio.h>
#include <string.h>

/* Fifty steps of mode 1 by a code with a mistake, without its times. */
static void write_data(const char *name)
{
    Settings settings;
    Status status = {STATUS_DONE, ""};
    const Override overrides[] = {{"--set", "mpm.mistake", "volume_of_cell"}, {"--set", "time.end", "0.5"}};
    ck_assert_msg(scenario_load_with("mode1", overrides, 2, &settings, &status), "%s", status.text);
    strcpy(settings_edit_output(&settings)->columns, "v_cm");
    const Outputs outputs = {.series = name, .asker = ASKER_COMMAND_LINE};
    ck_assert_msg(export_run(&settings, &outputs, 1, NULL, NULL, NULL, &status), "%s", status.text);
}

/* The reason why it was refused; "": it was not. */
static const char *enter(Bench *bench, const char *text)
{
    press(bench, ":");
    for (const char *at = text; *at; at++)
        press(bench, *at == ' ' ? "Space" : (const char[]){*at, '\0'});
    press(bench, "Enter");
    return bench->lab.screen.prompt->problem;
}

START_TEST(the_mistake_is_named_and_their_curve_laid_over)
{
    char folder[64];
    enter_folder(folder);
    write_data("own.csv");
    Bench *bench = open_bench("mode1", true);
    const Screen *screen = &bench->lab.screen;
    press(bench, "]");
    const int stage = experiment_stage(screen->experiment);
    ck_assert_str_eq(enter(bench, "diagnose own.csv"), "");
    ck_assert_ptr_nonnull(
        strstr(screen->diagnosis, "own.csv, read as v_cm; dt 0.01. One of: volume_of_cell, "));
    ck_assert_ptr_nonnull(strstr(screen->diagnosis, "(USF). It departs at step 1 in v_cm: yours "));
    ck_assert_ptr_nonnull(strstr(screen->diagnosis, "One of: volume_of_cell, "));
    ck_assert_ptr_nonnull(strstr(screen->message->text, "One of: volume_of_cell, "));
    ck_assert_ptr_nonnull(strstr(bench->progress, "trying other codes"));
    ck_assert_ptr_nonnull(screen->overlay);
    ck_assert_uint_eq(screen->overlay->count, 51);
    ck_assert_double_eq(screen->overlay->columns[screen->overlay->x].largest, 0.5);
    ck_assert_str_eq(enter(bench, "diagnose own.csv pairs"), "");
    ck_assert_ptr_nonnull(strstr(screen->diagnosis, "One of: volume_of_cell, "));
    ck_assert_int_eq(experiment_stage(screen->experiment), stage);
    ck_assert_ptr_null(settings_mistake(experiment_settings(screen->experiment)));
    ck_assert_str_eq(enter(bench, "overlay"), "");
    ck_assert_ptr_null(screen->overlay);
    ck_assert_str_eq(screen->diagnosis, "");
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

/* The answer stays after the next key, on the sheet with few things too. */
START_TEST(the_plain_sheet_keeps_the_answer)
{
    char folder[64];
    enter_folder(folder);
    write_data("own.csv");
    Bench *bench = open_bench("mode1", true);
    enter(bench, "sheet plain");
    ck_assert_str_eq(enter(bench, "diagnose own.csv"), "");
    ck_assert(shows(bench, "read as v_cm") &&
              !strstr(bench->lab.screen.message->text, "read as v_cm")); /* once */
    press(bench, "Down");
    ck_assert(bench->lab.screen.message->kind == MESSAGE_NONE && screen_is_plain(&bench->lab.screen));
    ck_assert(shows(bench, "Your code beside the right one"));
    /* of another scenario nothing was said */
    ck_assert_str_eq(enter(bench, "open mode5"), "");
    ck_assert(!shows(bench, "Your code beside the right one"));
    ck_assert_str_eq(enter(bench, "open mode1"), "");
    ck_assert_str_eq(enter(bench, "diagnose own.csv"), "");
    ck_assert(shows(bench, "Your code beside the right one"));
    enter(bench, "overlay");
    ck_assert(!shows(bench, "Your code beside the right one"));
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

START_TEST(what_cannot_be_judged_is_refused)
{
    char folder[64];
    enter_folder(folder);
    write_data("own.csv");
    Bench *bench = open_bench("mode1", true);
    ck_assert_ptr_nonnull(strstr(enter(bench, "diagnose"), "a file is expected"));
    press(bench, "Esc");
    ck_assert_ptr_nonnull(strstr(enter(bench, "diagnose none.csv"), "none.csv"));
    press(bench, "Esc");
    bench->gives_up = true;
    ck_assert_ptr_nonnull(strstr(enter(bench, "diagnose own.csv"), "interrupted"));
    ck_assert_str_eq(bench->lab.screen.diagnosis, "");
    ck_assert_ptr_null(bench->lab.screen.overlay);
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("diagnosing");
    tcase_add_test(tcase, the_mistake_is_named_and_their_curve_laid_over);
    tcase_add_test(tcase, the_plain_sheet_keeps_the_answer);
    tcase_add_test(tcase, what_cannot_be_judged_is_refused);
    suite_add_tcase(suite, tcase);
}
