/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The command line behind `:`: its verbs, completion, history, and foreign series over the plots. */
#include "views/view.h"
#include "scenario/concern_time.h"
#include "scenario/settings.h"
#include "suite.h"
#include "lab/tui_case.h"
#include "views/plots/plots.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void type(Bench *bench, const char *text)
{
    for (; *text; text++)
        press(bench, *text == ' ' ? "Space" : (char[2]){*text, '\0'});
}

static void do_line(Bench *bench, const char *text)
{
    press(bench, ":");
    type(bench, text);
    press(bench, "Enter");
    while (bench->lab.screen.playback->state == STATE_COMPUTING)
        frame(bench);
    press(bench, "^L");
}

static void expect_line(Bench *bench, const char *text)
{
    ck_assert_str_eq(bench->lab.screen.prompt->text, text);
    ck_assert_int_eq(bench->lab.screen.prompt->cursor, (int)strlen(text));
}

static double parameter(const Bench *bench, const char *key)
{
    return settings_number(experiment_settings(bench->lab.screen.experiment), parameter_find(key));
}

static void write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    ck_assert_ptr_nonnull(file);
    fputs(text, file);
    fclose(file);
}

/* --- verbs ---------------------------------------------------------------------------------------- */

START_TEST(verbs_take_arguments)
{
    char folder[64];
    enter_folder(folder);
    Bench *bench = open_bench("mode1", true);
    do_line(bench, "set initial.mode 3");
    ck_assert_double_eq(parameter(bench, "initial.mode"), 3);
    do_line(bench, "set initial.mode = 4");
    ck_assert_double_eq(parameter(bench, "initial.mode"), 4);
    do_line(bench, " initial.mode= 5 ");
    ck_assert_double_eq(parameter(bench, "initial.mode"), 5);
    do_line(bench, "goto 2.5");
    ck_assert_int_eq(experiment_step(bench->lab.screen.experiment), 250);
    do_line(bench, "goto #40");
    ck_assert_int_eq(experiment_step(bench->lab.screen.experiment), 40);
    do_line(bench, "write mine.ini");
    ck_assert_int_eq(access("mine.ini", R_OK), 0);
    do_line(bench, "open mode10");
    ck_assert_double_eq(parameter(bench, "initial.mode"), 10);
    do_line(bench, "open mine.ini");
    ck_assert_double_eq(parameter(bench, "initial.mode"), 5);
    do_line(bench, "goto 1");
    do_line(bench, "export out");
    ck_assert_int_eq(access("out-series.csv", R_OK), 0);
    do_line(bench, "goto 0.5");
    do_line(bench, "export part"); /* rewound: how far is asked, the name is known */
    type(bench, "here");
    press(bench, "Enter");
    ck_assert_msg(shows(bench, "(51 rows)"), "%s", bench->lab.screen.message->text);
    ck_assert_int_eq(access("part-series.csv", R_OK), 0);
    press(bench, ":");
    press(bench, "Enter");
    ck_assert(!bench->lab.screen.prompt->open);
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

static const char *const bad_lines[][2] = {
    {"set", "a key and a value are expected"},
    {"set initial.mode", "a key and a value are expected"},
    {"set initial.mod 3", "initial.mode"},
    {"initial.mode=x", "not a number"},
    {"goto", "a time, as in 12.5"},
    {"goto 1e9", "the run goes from 0"},
    {"open nothing-like-it", "nothing-like-it"},
    {"overlay nothing.csv", "nothing.csv: cannot be read: No such file"},
    {"stepp", "Tab completes"},
    {"step 3", "step takes no argument"},
};

START_TEST(bad_lines_say_why)
{
    Bench *bench = open_bench("mode1", true);
    do_line(bench, bad_lines[_i][0]);
    ck_assert_msg(bench->lab.screen.prompt->open, "'%s' was taken", bad_lines[_i][0]);
    ck_assert_msg(strstr(bench->lab.screen.prompt->problem, bad_lines[_i][1]) != NULL, "%s",
                  bench->lab.screen.prompt->problem);
    close_bench(bench);
}
END_TEST

/* --- completion and history ------------------------------------------------------------------------ */

START_TEST(tab_completes_words_keys_values_and_files)
{
    static const char *const lines[][3] = {
        /* what is typed, what Tab makes of it, what it shows where it cannot go on */
        {"over", "overlay ", ""},
        {"ov", "overlay ", ""},
        {"bookm", "bookmark", ""},
        {"mesh.c", "mesh.cell_size=", ""},
        {"set mesh.c", "set mesh.cell_size ", ""},
        {"mesh.", "mesh.", "mesh.cell_size  mesh.particles_per_cell  mesh.padding"},
        {"set mesh.p", "set mesh.pa", ""},
        {"mpm.algorithm=", "mpm.algorithm=", "usf  usl  musl"},
        {"mpm.algorithm=m", "mpm.algorithm=musl", ""},
        {"set mpm.algorithm us", "set mpm.algorithm us", "usf  usl"},
        {"set bar.length ", "set bar.length ", "> 0"},
        {"open supp", "open supported-beam", ""},
        {"overlay da", "overlay data/", ""},
        {"overlay data/s", "overlay data/student.csv", ""},
        {"overlay data/.", "overlay data/.", ""},
        {"nonsense", "nonsense", ""},
        {"pd.", "pd.", ""}, /* no key of a bar */
        /* by the end of a key and by the words of its label */
        {"cell_s", "mesh.cell_size=", ""},
        {"cell s", "mesh.cell_size=", ""},
        {"Courant n", "time.courant=", ""},
        {"traction_", "load.traction_layer=", ""},
        {"number", "number", "no match"},
        {"tra", "tra", "mpm.transfer  load.traction  load.traction_layer"},
        {"cell_size=", "cell_size=", "> 0: size dx"},
        {"set algorithm us", "set algorithm us", "usf  usl"},
        {"until ", "until ", "crossing  break  touch  event  rest  t   end  first"},
        {"until first c", "until first crossing", ""},
        {"tell whe", "tell where", ""},
        {"tell prob", "tell probe", ""},
        {"fit mesh.ce", "fit mesh.cell_size", ""},
        {"fit bar.density,bar.y", "fit bar.density,bar.youngs_modulus", ""},
        {"figure pro", "figure pro", "profile  probe"},
        {"figure probe da", "figure probe data/", ""},
    };
    char folder[64];
    enter_folder(folder);
    ck_assert_int_eq(system("mkdir data"), 0);
    write_text("data/student.csv", "0,1\n");
    write_text("data/teacher.csv", "0,1\n");
    Bench *bench = open_bench("mode1", true);
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        press(bench, ":");
        type(bench, lines[i][0]);
        press(bench, "Tab");
        expect_line(bench, lines[i][1]);
        if (*lines[i][2])
            ck_assert_msg(strncmp(bench->lab.screen.prompt->hint, lines[i][2], strlen(lines[i][2])) == 0,
                          "%s: %s", lines[i][0], bench->lab.screen.prompt->hint);
        ck_assert(!*lines[i][2] || shows(bench, lines[i][2]));
        press(bench, "Esc");
    }
    press(bench, "o");
    type(bench, "mode5-f");
    press(bench, "Tab");
    expect_line(bench, "mode5-fine");
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

START_TEST(what_takes_no_argument_says_what_does)
{
    static const char *const lines[][2] = {{"go 10", "go takes no argument; :10 goes to t = 10"},
                                           {"step #5", "step takes no argument; :#5 goes to step 5"},
                                           {"step twice", "step takes no argument"},
                                           {"help pulse", "pulse: A pulse comes back"}};
    Bench *bench = open_bench("mode1", true);
    for (size_t i = 0; i < sizeof lines / sizeof *lines; i++) {
        press(bench, ":");
        type(bench, lines[i][0]);
        press(bench, "Enter");
        ck_assert_msg(shows(bench, lines[i][1]), "%s", lines[i][0]);
        press(bench, "Esc");
    }
    close_bench(bench);
}
END_TEST

START_TEST(a_scenario_is_chosen_from_a_list_with_titles)
{
    char folder[64];
    enter_folder(folder);
    Bench *bench = open_bench("mode1", true);
    write_text("mine.ini", "[scenario]\ntitle = Held by a thread\nproblem = bar\n");
    write_text("table.csv.ini", "[scenario]\ntitle = Beside a table\nproblem = bar\n");
    write_text("other.ini", "[desktop]\ncolour = blue\n"); /* no scenario */
    press(bench, "o");
    ck_assert(shows(bench, "Gravity is switched on"));
    ck_assert(!shows(bench, "Beside a table") && !shows(bench, "other.ini"));
    press(bench, "Up"); /* from the end of the list */
    expect_line(bench, "mine.ini");
    ck_assert(shows(bench, "Held by a thread"));
    press_all(bench, "PageUp PageUp PageUp PageUp PageUp PageUp");
    expect_line(bench, "mode1");
    press_all(bench, "Down Down");
    expect_line(bench, "mode10");
    /* typing begins a new search, in names and titles */
    type(bench, "CRACK FINDS");
    expect_line(bench, "CRACK FINDS");
    ck_assert(shows(bench, "notched-beam-coarse  A crack finds its way, coarse"));
    ck_assert(!shows(bench, "gravity "));
    press_all(bench, "Down Down Down");
    expect_line(bench, "notched-beam-coarse");
    /* what holds none of it is no reason to refuse a path */
    type(bench, "./mine.ini");
    ck_assert(!shows(bench, "notched-beam"));
    press(bench, "Enter");
    ck_assert_str_eq(experiment_settings(bench->lab.screen.experiment)->title, "Held by a thread");
    press(bench, "o");
    type(bench, "uGIMP"); /* the only one left */
    press(bench, "Enter");
    ck_assert_str_eq(bench->lab.scenario, "crossing");
    /* the list opens where one is */
    press(bench, "o");
    ck_assert(shows(bench, ">crossing"));
    press(bench, "Down");
    expect_line(bench, "gravity");
    press_all(bench, "Esc o Up");
    expect_line(bench, "energy");
    press(bench, "Esc");
    press(bench, "o");
    type(bench, "mode5-"); /* the first of several */
    press(bench, "Enter");
    ck_assert_str_eq(bench->lab.scenario, "mode5-fine");
    press_all(bench, ":");
    type(bench, "open cros");
    press(bench, "Tab");
    ck_assert(shows(bench, "Crossing cells: hat or uGIMP?"));
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

/* On a narrow screen the chosen one's title stands below the names. */
START_TEST(the_list_of_scenarios_fits_a_small_screen)
{
    Bench *bench = open_bench("mode1", true);
    bench->width = 40;
    bench->height = 12;
    press_all(bench, "o PageDown PageDown PageDown PageDown PageDown PageDown");
    expect_line(bench, "vibrating-block");
    ck_assert(shows(bench, "What does half the cell size gain"));
    press_all(bench, "PageUp PageUp PageUp PageUp PageUp PageUp");
    expect_line(bench, "mode1");
    ck_assert(shows(bench, "Where mesh and bar agree"));
    close_bench(bench);
}
END_TEST

START_TEST(up_and_down_fetch_earlier_lines)
{
    Bench *bench = open_bench("mode1", true);
    press_all(bench, ": Up");
    expect_line(bench, "");
    press(bench, "Esc");
    do_line(bench, "step");
    do_line(bench, "initial.mode=3");
    do_line(bench, "initial.mode=3"); /* the same line is kept once */
    press(bench, ":");
    type(bench, "goto");
    press(bench, "Up");
    expect_line(bench, "initial.mode=3");
    press(bench, "Up");
    expect_line(bench, "step");
    press(bench, "Up");
    expect_line(bench, "step");
    press_all(bench, "Down Down");
    expect_line(bench, "goto"); /* what was being typed */
    press(bench, "Down");
    expect_line(bench, "goto");
    press_all(bench, "Up Backspace 4 Enter");
    ck_assert_double_eq(parameter(bench, "initial.mode"), 4);
    for (int i = 0; i < 2 * LINE_HISTORY_MAX; i++) {
        char line[16];
        snprintf(line, sizeof line, "#%d", i + 1);
        do_line(bench, line);
    }
    press(bench, ":");
    for (int i = 0; i < 2 * LINE_HISTORY_MAX; i++)
        press(bench, "Up");
    expect_line(bench, "#33"); /* the last 32 are kept */
    close_bench(bench);
}
END_TEST

/* --- how a scenario opens, and the time window ------------------------------------------------------ */

START_TEST(a_scenario_opens_as_its_view_says)
{
    char folder[64];
    enter_folder(folder);
    write_text("seen.ini", "[scenario]\nproblem = bar\n[view]\nupper = 3\nlower = 6\nwindow = 7.5\npace = 3\n"
                           "references = exact\n");
    write_text("plain.ini", "[scenario]\nproblem = bar\n");
    write_text("beam.ini",
               "[scenario]\nproblem = simply-supported-beam\n[pd]\nspacing = 1e-3\nhorizon = 4e-3\n"
               "[view]\nlower = 9\n");
    Bench *bench = open_bench("seen.ini", true);
    const Screen *screen = &bench->lab.screen;
    double from, to;
    ck_assert_int_eq(screen->views.upper->digit, 3);
    ck_assert_int_eq(screen->views.lower->digit, 6);
    time_plot_window(screen, &from, &to);
    ck_assert_double_eq(to - from, 7.5);
    ck_assert_double_eq(screen->playback->pace, 3);
    ck_assert_int_eq(screen->views.references, SHOW_EXACT);
    ck_assert(shows(bench, "energy"));
    do_line(bench, "open plain.ini"); /* nothing of it stays */
    ck_assert_int_eq(screen->views.upper->digit, 1);
    ck_assert_int_eq(screen->views.lower->digit, 2);
    ck_assert_double_eq(screen->time.window, 0);
    ck_assert_double_ne(screen->playback->pace, 3);
    ck_assert_int_eq(screen->views.references, SHOW_ALL);
    do_line(bench, "open beam.ini"); /* of a beam the whole is seen */
    ck_assert_int_eq(screen->views.upper->digit, 8);
    ck_assert_int_eq(screen->views.lower->digit, 9);
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

START_TEST(the_time_window_narrows_widens_and_finds_itself)
{
    static const char *const names[] = {"mode1", "mode10", "supported-beam-coarse"};
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        Bench *bench = open_bench(names[i], true);
        Screen *screen = &bench->lab.screen;
        screen->panes.focus = PANE_LOWER;
        double from, to, length, end = settings_time(experiment_settings(screen->experiment))->end;
        const double dt = experiment_simulation(screen->experiment)->dt;
        time_plot_window(screen, &from, &to);
        const double automatic = length = to - from;
        for (int k = 0; k < 60; k++, length = to - from) {
            press(bench, "n");
            time_plot_window(screen, &from, &to);
            ck_assert_double_le(to - from, length * (1 + 1e-9));
            ck_assert_double_ge(to - from, 10 * dt * (1 - 1e-9));
        }
        ck_assert(shows(bench, "ten steps, no fewer"));
        ck_assert_double_lt(length, 25 * dt);
        for (int k = 0; k < 60; k++, length = to - from) {
            press(bench, "N");
            time_plot_window(screen, &from, &to);
            ck_assert_double_ge(to - from, length * (1 - 1e-9));
        }
        ck_assert(shows(bench, "holds the whole run"));
        ck_assert_double_ge(length, end);
        ck_assert_double_lt(length, 2.6 * end);
        press(bench, "a");
        time_plot_window(screen, &from, &to);
        ck_assert_double_eq_tol(to - from, automatic, 1e-9 * automatic);
        close_bench(bench);
    }
}
END_TEST

START_TEST(the_cursor_reads_and_enter_goes_there)
{
    Bench *bench = open_bench("mode5", true);
    Screen *screen = &bench->lab.screen;
    for (int left = 2; left < 9; left++) {
        do_line(bench, "goto 4");
        screen->panes.focus = PANE_LOWER;
        for (int i = 0; i < left; i++)
            press(bench, "Left");
        const double time = screen->time.cursor;
        ck_assert(isfinite(time) && time < 4);
        ck_assert(shows(bench, "measured") && shows(bench, "exact") && shows(bench, "predicted"));
        /* the row that was read, not the step that is nearest to the cursor */
        const Record *record = experiment_record(screen->experiment);
        const double *row = record_row(record, record_find(record, time));
        char text[32];
        snprintf(text, sizeof text, "t %.2f  meas", row[1]);
        ck_assert_msg(shows(bench, text), "%s", text);
        press(bench, "Enter");
        ck_assert_int_eq(experiment_step(screen->experiment), (long)row[0]);
        ck_assert(isnan(screen->time.cursor));
    }
    ck_assert_int_eq(experiment_newest(screen->experiment), 400); /* nothing is lost */
    close_bench(bench);
}
END_TEST

/* --- a foreign series ------------------------------------------------------------------------------ */

START_TEST(a_series_lies_over_the_plot_and_goes_again)
{
    char folder[64];
    enter_folder(folder);
    FILE *file = fopen("pupil.csv", "w");
    ck_assert_ptr_nonnull(file);
    fputs("time;v_cm;x_cm\r\n", file);
    for (int i = 0; i < 200; i++)
        fprintf(file, "%d,%02d;0,0%02d;0,1\r\n", i / 50, i % 50 * 2, 1 + i % 9);
    fclose(file);
    write_text("bad.csv", "time,v_cm\n0,1\n1,one\n");
    Bench *bench = open_bench("mode1", true);
    do_line(bench, "goto 2");
    do_line(bench, "overlay pupil.csv");
    ck_assert_ptr_nonnull(bench->lab.screen.overlay);
    ck_assert(shows(bench, "+ pupil.csv"));
    /* the cursor reads it, and a curve without a column of its name has none */
    press_all(bench, "Tab Tab Tab");
    ck_assert_int_eq(bench->lab.screen.panes.focus, PANE_LOWER);
    bench->lab.screen.time.cursor = 1;
    press(bench, "^L");
    ck_assert(shows(bench, "pupil.csv 0.006"));
    press(bench, "3");
    ck_assert(!shows(bench, "+ pupil.csv")); /* no column of the total energy */
    do_line(bench, "overlay pupil.csv 1 x_cm");
    ck_assert(shows(bench, "+ pupil.csv")); /* now x_cm is asked for, over the energies */
    /* a bad file changes nothing */
    do_line(bench, "overlay bad.csv");
    ck_assert_str_eq(bench->lab.screen.prompt->problem, "bad.csv:3: column 2, v_cm: 'one' is not a number");
    press(bench, "Esc");
    ck_assert(shows(bench, "+ pupil.csv"));
    do_line(bench, "overlay");
    ck_assert_ptr_null(bench->lab.screen.overlay);
    ck_assert(!shows(bench, "pupil"));
    do_line(bench, "overlay \"pupil.csv\" time v_cm");
    do_line(bench, "open mode5"); /* it stays for the next scenario */
    ck_assert_ptr_nonnull(bench->lab.screen.overlay);
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

/* --- exports ---------------------------------------------------------------------------------------- */

START_TEST(an_export_says_its_size_first_and_its_place_afterwards)
{
    char folder[64], path[160];
    enter_folder(folder);
    Bench *bench = open_bench("mode1", true);
    do_line(bench, "goto 50");
    press(bench, "x");
    double megabytes;
    long rows;
    ck_assert_int_eq(sscanf(bench->lab.screen.prompt->question, "export %ld rows, %lf MB", &rows, &megabytes),
                     2);
    ck_assert_int_eq(rows, 5001);
    press(bench, "Enter");
    snprintf(path, sizeof path, "%s/mode1-series.csv", folder);
    ck_assert_msg(strstr(bench->lab.screen.message->text, path) != NULL, "%s",
                  bench->lab.screen.message->text);
    FILE *file = fopen(path, "r");
    ck_assert_ptr_nonnull(file);
    fseek(file, 0, SEEK_END);
    ck_assert_double_eq_tol((double)ftell(file) / 1e6, megabytes, 0.06);
    fclose(file);
    do_line(bench, "output.every=7");
    press(bench, "x");
    ck_assert_int_eq(sscanf(bench->lab.screen.prompt->question, "export %ld rows", &rows), 1);
    ck_assert_int_eq(rows, 5000 / 7 + 2);
    ck_assert(!shows(bench, "spreadsheet"));
    press(bench, "Enter");
    ck_assert_msg(strstr(bench->lab.screen.message->text, "(716 rows)") != NULL, "%s",
                  bench->lab.screen.message->text);
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

START_TEST(more_rows_than_a_spreadsheet_takes_are_announced)
{
    char folder[64];
    enter_folder(folder);
    write_text("long.ini", "[bar]\nlength = 2\n[initial]\nvelocity = 0.01\n[time]\nend = 10486\n");
    Bench *bench = open_bench("long.ini", true);
    do_line(bench, "goto 10485.74");
    press(bench, "x");
    ck_assert(shows(bench, "export 1048575 rows"));
    ck_assert(!shows(bench, "spreadsheet"));
    press(bench, "Esc");
    do_line(bench, "goto 10485.75");
    press(bench, "x");
    ck_assert(shows(bench, "more rows than a spreadsheet takes (1048576 with the heading)"));
    ck_assert(shows(bench, "output.every=2"));
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("line");
    tcase_add_test(tcase, verbs_take_arguments);
    tcase_add_loop_test(tcase, bad_lines_say_why, 0, (int)(sizeof bad_lines / sizeof *bad_lines));
    tcase_add_test(tcase, tab_completes_words_keys_values_and_files);
    tcase_add_test(tcase, a_scenario_is_chosen_from_a_list_with_titles);
    tcase_add_test(tcase, what_takes_no_argument_says_what_does);
    tcase_add_test(tcase, the_list_of_scenarios_fits_a_small_screen);
    tcase_add_test(tcase, up_and_down_fetch_earlier_lines);
    tcase_add_test(tcase, a_scenario_opens_as_its_view_says);
    tcase_add_test(tcase, the_time_window_narrows_widens_and_finds_itself);
    tcase_add_test(tcase, the_cursor_reads_and_enter_goes_there);
    tcase_add_test(tcase, a_series_lies_over_the_plot_and_goes_again);
    tcase_add_test(tcase, an_export_says_its_size_first_and_its_place_afterwards);
    tcase_add_test(tcase, more_rows_than_a_spreadsheet_takes_are_announced);
    suite_add_tcase(suite, tcase);
}
