/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The two sheets: what is on each, how one is turned, what is remembered of it, and that what a scenario says
 * of its screen is known. */
#include "suite.h"
#include "lab/tui_case.h"
#include "lab/session/state_file.h"
#include "answers/run_numbers.h"
#include "panes/panes.h"
#include "scenario/scenario.h"
#include "scenario/concern_output.h"
#include "scenario/settings.h"
#include "views/view.h"
#include "panes/screen.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void open_sheet(Bench *bench, const char *sheet)
{
    bench->lab.options.sheet = sheet;
    enter_line(bench, strcmp(sheet, "plain") == 0 ? "sheet plain" : "sheet full");
}

static bool is_plain(const Bench *bench)
{
    return screen_is_plain(&bench->lab.screen);
}

/* One picture, from 30 rows on the displacement along the bar above it, one number, what is asked: no table,
 * no box, no timeline. */
START_TEST(the_plain_sheet_has_one_of_each)
{
    static const int sizes[][2] = {{80, 24}, {132, 43}, {60, 18}, {200, 60}, {100, 20}, {80, 30}, {80, 29}};
    Bench *bench = open_bench("mode5", true);
    open_sheet(bench, "plain");
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const Layout layout = layout_make(&bench->lab.screen, sizes[i][0], sizes[i][1]);
        const int plots = (layout.panes[PANE_UPPER].width > 0) + (layout.panes[PANE_LOWER].width > 0);
        ck_assert_int_eq(plots, sizes[i][1] < 30 ? 1 : 2);
        ck_assert_int_eq(layout.panes[PANE_BOX].width, 0);
        ck_assert_int_eq(layout.timeline.width, 0);
        ck_assert_int_eq(layout.sides[0].width + layout.sides[1].width, 0);
        ck_assert_int_gt(layout.panes[PANE_MESH].width, 0);
        ck_assert_int_gt(layout.number.width, 0);
        ck_assert_int_gt(layout.panes[PANE_PARAMETERS].width, 0);
        ck_assert_int_ge(layout.panes[PANE_LOWER].height, 6);
    }
    press(bench, "]");
    ck_assert(shows(bench, "Stage 1 of 7")); /* within a step its numbers come */
    press(bench, ".");
    ck_assert(!shows(bench, " energy "));
    ck_assert(!shows(bench, " stage 0"));
    close_bench(bench);
}
END_TEST

/* By key and by word, from anywhere; what is undone, and what the arrows change, is the same after it. */
START_TEST(sheets_are_turned_without_touching_anything)
{
    Bench *bench = open_bench("mode5", true);
    Screen *screen = &bench->lab.screen;
    ck_assert(!is_plain(bench)); /* nothing was said of sheets */
    press(bench, "f");
    ck_assert(is_plain(bench));
    const Parameter *first = edit_selected(screen);
    ck_assert_str_eq(first->key, "time.courant");
    press_all(bench, "Down Down Left");
    const Parameter *second = edit_selected(screen);
    ck_assert_ptr_ne(second, first);
    const int undone = bench->lab.editing.n_undo;
    const Settings before = *experiment_settings(screen->experiment);
    ck_assert_int_eq(undone, 1);
    press(bench, "f");
    ck_assert(!is_plain(bench));
    ck_assert_ptr_eq(edit_selected(screen), second);
    press_all(bench, "f f f");
    ck_assert(is_plain(bench));
    ck_assert_ptr_eq(edit_selected(screen), second);
    ck_assert_int_eq(bench->lab.editing.n_undo, undone);
    ck_assert(settings_same(experiment_settings(screen->experiment), &before));
    enter_line(bench, "sheet full");
    ck_assert(!is_plain(bench));
    enter_line(bench, "sheet full");
    ck_assert(!is_plain(bench));
    enter_line(bench, "sheet");
    ck_assert(is_plain(bench));
    enter_line(bench, "sheet large");
    ck_assert(screen->prompt->open);
    ck_assert_str_eq(screen->prompt->problem, "which sheet? (plain | full)");
    press(bench, "Esc");
    /* from a pane that the plain sheet has not, from the inspector, from a field of the filter */
    press_all(bench, "f Tab Tab f");
    ck_assert_int_eq(screen->panes.focus, PANE_PARAMETERS);
    press_all(bench, "i f");
    ck_assert(!is_plain(bench));
    press_all(bench, "f L");
    ck_assert(is_plain(bench));
    press(bench, "f");
    ck_assert(!is_plain(bench) && !screen->panes.lecture);
    close_bench(bench);
}
END_TEST

/* A digit shows another picture in place of the one; the arrows stay with the parameters. */
START_TEST(the_picture_is_the_one_asked_for)
{
    Bench *bench = open_bench("mode5", true);
    open_sheet(bench, "plain");
    ck_assert(shows(bench, "v_cm"));
    press(bench, "1");
    ck_assert(!shows(bench, "v_cm"));
    ck_assert_int_gt(screen_pane(&bench->lab.screen, 80, 24, PANE_UPPER).width, 0);
    press(bench, "4");
    const Settings before = *experiment_settings(bench->lab.screen.experiment);
    press(bench, "Left");
    ck_assert(!settings_same(experiment_settings(bench->lab.screen.experiment), &before));
    close_bench(bench);
}
END_TEST

/* A lesson begins on the plain sheet; who turns to the full one has it to the end; it ends as it was. */
START_TEST(lessons_begin_on_the_plain_sheet)
{
    Status status = {STATUS_DONE, ""};
    Bench *bench = open_bench("mode5", true);
    open_sheet(bench, "full");
    ck_assert(lesson_play_open(&bench->lab, "late", &status));
    ck_assert(is_plain(bench));
    press_all(bench, "f n");
    ck_assert(!is_plain(bench));
    press_all(bench, "f n");
    ck_assert(is_plain(bench));
    press(bench, "T");
    ck_assert(!is_plain(bench));
    open_sheet(bench, "plain");
    press_all(bench, "T Enter");
    ck_assert(is_plain(bench));
    press_all(bench, "f T");
    ck_assert(is_plain(bench));
    /* what is older than the sheets */
    press(bench, "f");
    bench->lab.options.sheet = NULL;
    press_all(bench, "T Enter");
    ck_assert(bench->lab.screen.lesson->lesson && !is_plain(bench));
    close_bench(bench);
}
END_TEST

/* The user's own turning is known at the next start, a lesson's or a session's is not. */
START_TEST(the_sheet_is_remembered)
{
    char folder[64];
    Status status = {STATUS_DONE, ""};
    enter_folder(folder);
    setenv("XDG_STATE_HOME", folder, 1);
    ck_assert_ptr_null(state_file_word(state_file_sheet, parameter_sheet_words));
    Bench *bench = open_bench("mode5", true);
    bench->lab.options.sheet = "plain";
    press(bench, "f");
    ck_assert_ptr_null(state_file_word(state_file_sheet, parameter_sheet_words)); /* nobody sits there */
    bench->lab.options.keeps_sheet = true;
    press(bench, "f");
    ck_assert_str_eq(state_file_word(state_file_sheet, parameter_sheet_words), "full");
    press(bench, "f");
    ck_assert_str_eq(state_file_word(state_file_sheet, parameter_sheet_words), "plain");
    ck_assert(lesson_play_open(&bench->lab, "late", &status));
    press(bench, "f");
    ck_assert_str_eq(state_file_word(state_file_sheet, parameter_sheet_words), "plain");
    press(bench, "T");
    bench->lab.asker = ASKER_REPLAY;
    press(bench, "f");
    ck_assert_str_eq(state_file_word(state_file_sheet, parameter_sheet_words), "plain");
    close_bench(bench);
    char file[128];
    snprintf(file, sizeof file, "%s/matvib/%s", folder, state_file_sheet);
    FILE *broken = fopen(file, "w");
    ck_assert_ptr_nonnull(broken);
    fputs("plain and simple, but no word of a sheet that anybody knows, and much too long\n", broken);
    fclose(broken);
    ck_assert_ptr_null(state_file_word(state_file_sheet, parameter_sheet_words));
    leave_folder(folder);
}
END_TEST

static const struct {
    const char *text, *says;
} wrong[] = {
    {"sheet = large", "my.ini:6: screen.sheet: large is not allowed (full | plain)"},
    {"about = lateness", "screen.about: lateness is not allowed (error, period_error, late, "},
    {"about = dt", "screen.about: dt is not allowed (error, period_error, late, "},
    {"ask = mesh.size", "screen.ask: mesh.size is not a parameter of problem bar (see: matvib params bar)"},
    {"ask = bar.length, notch.depth", "screen.ask: notch.depth is not a parameter of problem bar"},
    {"ask = bar.length,mesh.cell_size,time.courant,bar.density,initial.mode",
     "screen.ask: names too many (at most 4)"},
};

static bool read_screen(const char *line, Settings *settings, Status *status)
{
    char text[256];
    snprintf(text, sizeof text, "[scenario]\nproblem = bar\nmethod = mpm\n\n[screen]\n%s\n", line);
    FILE *stream = fmemopen(text, strlen(text), "r");
    ck_assert_ptr_nonnull(stream);
    *status = (Status){STATUS_DONE, ""};
    const bool sound = scenario_read(stream, "my.ini", settings, status) &&
                       settings_check(settings, status) && view_check(settings, NULL, status);
    fclose(stream);
    return sound;
}

START_TEST(a_screen_that_is_not_known_is_refused)
{
    Settings settings;
    Status status;
    ck_assert(!read_screen(wrong[_i].text, &settings, &status));
    ck_assert_msg(strstr(status.text, wrong[_i].says) != NULL, "%s", status.text);
    ck_assert_int_eq(status.code, STATUS_USAGE);
}
END_TEST

/* In the order of the scenario; of those that the method has not the others stay. */
START_TEST(a_scenario_says_what_it_asks)
{
    Settings settings;
    Status status;
    Asked asked[ASKED_MAX];
    ck_assert_msg(read_screen("sheet = plain\nabout = error\nask = time.courant, pd.spacing,bar.length",
                              &settings, &status),
                  "%s", status.text);
    ck_assert_str_eq(run_number_about(&settings)->word, "error");
    ck_assert_int_eq(settings_asked(&settings, asked), 2);
    ck_assert_str_eq(asked[0].parameter->key, "time.courant");
    ck_assert_str_eq(asked[1].parameter->key, "bar.length");
    ck_assert(read_screen("", &settings, &status));
    ck_assert_str_eq(run_number_about(&settings)->word, "late");
    ck_assert_int_gt(settings_asked(&settings, asked), 2);
}
END_TEST

/* It opens on its own sheet, without making that the user's. */
START_TEST(a_scenario_opens_on_its_own_sheet)
{
    char folder[64];
    enter_folder(folder);
    FILE *file = fopen("mine.ini", "w");
    ck_assert_ptr_nonnull(file);
    fputs("[scenario]\nproblem = bar\nmethod = mpm\n\n[screen]\nsheet = plain\nask = initial.mode\n", file);
    fclose(file);
    Bench *bench = open_bench("mode5", true);
    enter_line(bench, "open mine.ini");
    ck_assert(is_plain(bench));
    ck_assert_str_eq(edit_selected(&bench->lab.screen)->key, "initial.mode");
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

static void finish_work(Bench *bench)
{
    for (int i = 0; i < 100000 && bench->lab.screen.playback->state == STATE_COMPUTING; i++)
        frame(bench);
}

/* What follows from rows is that of the moment on screen, not of the newest; a number that goes the other way
 * is called so. */
START_TEST(the_number_is_that_of_the_moment)
{
    char digits[2][NUMBER_DIGITS_MAX], words[NUMBER_WORDS_MAX];
    Bench *bench = open_bench("mode5", true);
    const Screen *screen = &bench->lab.screen;
    enter_line(bench, "set mpm.flip_fraction 0.99"); /* there is no E* then */
    enter_line(bench, "set screen.about energy_change");
    for (int i = 0; i < 2; i++) {
        enter_line(bench, "goto #1500");
        finish_work(bench);
        ck_assert(screen_number(screen, digits[i], words));
        ck_assert_str_eq(words, "% energy lost");
        ck_assert(digits[i][0] != '-');
        enter_line(bench, "goto #4000");
        finish_work(bench);
    }
    ck_assert_str_eq(digits[0], digits[1]);
    ck_assert(screen_number(screen, digits[1], words));
    ck_assert_str_ne(digits[0], digits[1]);
    enter_line(bench, "set screen.about error");
    enter_line(bench, "set mpm.flip_fraction 1");
    enter_line(bench, "set mpm.mass_blend 0.1");
    press(bench, "r");
    enter_line(bench, "goto #4000");
    finish_work(bench);
    ck_assert(screen_number(screen, digits[0], words));
    ck_assert_str_eq(words, "% frequency too high");
    enter_line(bench, "set mpm.mass_blend 1");
    press(bench, "r");
    enter_line(bench, "goto #1500");
    finish_work(bench);
    ck_assert(screen_number(screen, digits[0], words));
    ck_assert_str_eq(words, "% frequency too low");
    ck_assert(strncmp(digits[0], "4.2", 3) == 0);
    close_bench(bench);
}
END_TEST

/* A page that is far away is left before it is reached: on a bar none is. */
static bool arrives(Bench *bench)
{
    const bool plane = simulation_has(experiment_simulation(bench->lab.screen.experiment), HAS_PLANE);
    bench->rate = plane ? 10 / FRAME_SECONDS : 0;
    for (int i = 0; i < (plane ? 10 : 1000) && bench->lab.play.arriving; i++)
        frame(bench);
    ck_assert(plane || !bench->lab.play.arriving);
    return !bench->lab.play.arriving;
}

/* Who knows no keys but Enter, n, b, digits and arrows comes to the end of every lesson, on both sheets. */
START_TEST(a_student_comes_to_the_end)
{
    const char *name = builtin_lessons[_i / 2].name;
    const bool full = _i % 2;
    Status status = {STATUS_DONE, ""};
    if (!suite_wide()
            ? full ? strcmp(name, "late") != 0 : _i / 2 % 4 != 2 && strcmp(name, "homework-late") != 0
            : !suite_long() && _i % 3 != 0) /* two lessons of three, on either sheet */
        return;                             /* others go as these */
    Bench *bench = open_bench("mode1", true);
    const LessonShown *shown = bench->lab.screen.lesson;
    bench->lab.options.sheet = "plain";
    ck_assert_msg(lesson_play_open(&bench->lab, name, &status), "%s", status.text);
    if (full)
        press_all(bench, is_plain(bench) ? "f" : "f f"); /* by himself, where the page is on it already */
    const Lesson *lesson = shown->lesson;
    for (int page = 0; page < lesson->n_pages; page++) {
        const LessonPage *now = &lesson->pages[page];
        ck_assert_msg(shown->page == page, "%s: page %d in place of %d", name, shown->page + 1, page + 1);
        const bool there = arrives(bench);
        ck_assert(laboratory_draw(&bench->lab, &bench->canvas, bench->width, bench->height));
        ck_assert_msg(!there || !full || !is_plain(bench), "%s, page %d", name, page + 1);
        if (there && now->n_choices > 0)
            press_all(bench, page % 2 ? "Down Enter" : "1");
        if (there && now->n_fields > 0 && !bench->lab.play.arriving)
            press_all(bench, "Left Right");
        arrives(bench);
        ck_assert_msg(!bench->lab.play.refused[0], "%s", bench->lab.play.refused);
        if (page % 3 == 2) {
            press(bench, "b");
            ck_assert_int_eq(shown->page, page - 1);
            press(bench, "n");
        }
        if (page + 1 < lesson->n_pages)
            press(bench, "n");
    }
    press(bench, "T");
    ck_assert(!shown->open && !is_plain(bench));
    close_bench(bench);
}
END_TEST

/* Every scenario of the program names its number and its questions; the plain sheet has both, from 60x18 on,
 * and the arrows stand on the first. */
START_TEST(every_scenario_has_a_number_and_questions)
{
    const char *name = builtin_scenarios[_i].name;
    Status status = {STATUS_DONE, ""};
    Bench *bench = calloc(1, sizeof *bench);
    ck_assert_ptr_nonnull(bench);
    ck_assert_msg(bench_open(bench, name, true, &status), "%s", status.text);
    Screen *screen = &bench->lab.screen;
    const Settings *settings = experiment_settings(screen->experiment);
    ck_assert_msg(settings_view(settings)->about[0] && settings_view(settings)->ask[0], "%s has no [screen]",
                  name);
    const RunNumber *number = run_number_find(settings_view(settings)->about);
    ck_assert_ptr_eq(run_number_about(settings), number);
    Asked asked[ASKED_MAX];
    const int n = settings_asked(settings, asked);
    ck_assert_int_ge(n, 2);
    bench->width = 60;
    bench->height = 18;
    open_sheet(bench, "plain");
    ck_assert_ptr_eq(edit_selected(screen), asked[0].parameter);
    for (int i = 0; i < n; i++) {
        char row[64], value[ROW_TEXT_MAX];
        if (!asked[i].parameter)
            settings_row_place_show(settings, &asked[i].place, row, value);
        const char *seen = asked[i].parameter ? asked[i].parameter->label : row;
        ck_assert_msg(shows(bench, seen), "%s: %s is not seen", name, seen);
    }
    char digits[NUMBER_DIGITS_MAX], words[NUMBER_WORDS_MAX];
    screen_number(screen, digits, words);
    const char *seen = screen_second_run(screen) && strchr(words, ' ') ? strrchr(words, ' ') : words;
    ck_assert_msg(seen && shows(bench, seen), "%s: %s is not seen", name, words);
    close_bench(bench);
}
END_TEST

/* Bodies are added, moved by particles, copied and deleted by the keys of cuts; one that does not fit stays
 * in hand. */
START_TEST(bodies_are_edited_by_keys)
{
    Bench *bench = open_bench("two-discs", true);
    const RowList *rows;
    char text[ROW_TEXT_MAX];
    press_all(bench, "A Enter");
    rows = &experiment_settings(bench->lab.player.duel.a)->rows[ROWS_BODIES];
    ck_assert_int_eq(rows->count, 3);
    press_all(bench, "p Right Right Up WheelDown");
    ck_assert(shows(bench, "arrows move it")); /* the wheel chooses no parameter meanwhile */
    press(bench, "Enter");
    rows = &experiment_settings(bench->lab.player.duel.a)->rows[ROWS_BODIES];
    settings_row_show(experiment_settings(bench->lab.player.duel.a), ROWS_BODIES, 2, text);
    ck_assert_str_eq(text, "disc 55% 52.5% 0.1"); /* a particle is a fortieth of the box */
    press_all(bench, "C Enter");
    ck_assert(bench->lab.parameters.rows.placing && shows(bench, "overlaps"));
    press_all(bench, "PageDown Right Right Right Enter D");
    rows = &experiment_settings(bench->lab.player.duel.a)->rows[ROWS_BODIES];
    ck_assert(!bench->lab.parameters.rows.placing);
    ck_assert_int_eq(rows->count, 3);
    close_bench(bench);
    bench = open_bench("mode1", true);
    press(bench, "A");
    ck_assert(shows(bench, "only plates (cuts, loads, supports) and bodies have rows"));
    close_bench(bench);
}
END_TEST

/* Where one pane has room: bodies begin with their map, others with the plot. */
START_TEST(a_small_screen_begins_with_what_matters)
{
    static const struct {
        const char *scenario, *seen;
        PaneId pane;
    } cases[] = {{"two-discs", "body  to scale", PANE_UPPER}, {"mode5", "v_cm", PANE_LOWER}};
    Bench *bench = open_bench(cases[_i].scenario, true);
    bench->width = 60;
    bench->height = 18;
    press(bench, "^L");
    ck_assert_int_eq(bench->lab.screen.panes.focus, cases[_i].pane);
    ck_assert(shows(bench, cases[_i].seen));
    bench->width = 80;
    bench->height = 24;
    press(bench, "^L");
    ck_assert_int_eq(bench->lab.screen.panes.focus, PANE_PARAMETERS);
    close_bench(bench);
}
END_TEST

/* The arrows and the field change what a plate asks of its rows, and u brings it back. */
START_TEST(a_row_that_is_asked_about_is_changed)
{
    Bench *bench = open_bench("pulled-plate", true);
    const Screen *screen = &bench->lab.screen;
    open_sheet(bench, "plain");
    ck_assert(shows(bench, "sy of all loads"));
    press(bench, "Right");
    ck_assert_double_eq(settings_row_number(experiment_settings(screen->experiment), "loads.bottom.sy"),
                        -1e7);
    press_all(bench, "Enter 8 M P a Enter");
    ck_assert_double_eq(settings_row_number(experiment_settings(screen->experiment), "loads.bottom.sy"),
                        -8e6);
    press_all(bench, "Down Down Down Left");
    ck_assert_double_lt(settings_row_number(experiment_settings(screen->experiment), "cuts.edge.x1"), 0.05);
    press_all(bench, "u u u");
    ck_assert_double_eq(settings_row_number(experiment_settings(screen->experiment), "loads.bottom.sy"),
                        -6e6);
    close_bench(bench);
}
END_TEST

static bool has_coarse_form(const char *name)
{
    char coarse[80];
    snprintf(coarse, sizeof coarse, "%s-coarse", name);
    for (const BuiltinScenario *one = builtin_scenarios; one->name; one++)
        if (strcmp(one->name, coarse) == 0)
            return true;
    return false;
}

/* And its number comes to be known, where that does not take too long. */
START_TEST(the_number_of_a_scenario_is_known_at_its_end)
{
    const char *name = builtin_scenarios[_i].name;
    if (!suite_long() && has_coarse_form(name))
        return;
    Settings settings;
    Status status = {STATUS_DONE, ""};
    ck_assert(scenario_load(name, &settings, &status));
    ck_assert_msg(view_check(&settings, NULL, &status), "%s: %s", name, status.text); /* nobody else asks */
    Screen screen;
    screen_default(&screen);
    Experiment *experiment = experiment_create(&settings, 64 << 20, 1, &status);
    screen.experiment = experiment;
    ck_assert_msg(experiment != NULL, "%s", status.text);
    const Simulation *sim = experiment_simulation(screen.experiment);
    const double work = (double)sim->counts[0] * (double)experiment_last_step(screen.experiment);
    if (work < (suite_wide() ? 1e8 : 3e6)) {
        char digits[NUMBER_DIGITS_MAX], words[NUMBER_WORDS_MAX];
        experiment_advance(experiment, experiment_last_step(screen.experiment), &status);
        experiment_rest(experiment);
        ck_assert_msg(screen_number(&screen, digits, words), "%s: %s", name, words);
        printf("# %s: %s %s\n", name, digits, words);
    }
    experiment_destroy(experiment);
}
END_TEST

void add_cases(Suite *suite)
{
    int count = 0;
    while (builtin_scenarios[count].name)
        count++;
    int n_lessons = 0;
    while (builtin_lessons[n_lessons].name)
        n_lessons++;
    TCase *sheets = tcase_create("sheets"), *students = tcase_create("students");
    tcase_add_test(sheets, the_plain_sheet_has_one_of_each);
    tcase_add_test(sheets, sheets_are_turned_without_touching_anything);
    tcase_add_test(sheets, the_picture_is_the_one_asked_for);
    tcase_add_test(sheets, lessons_begin_on_the_plain_sheet);
    tcase_add_test(sheets, the_sheet_is_remembered);
    tcase_add_loop_test(sheets, a_screen_that_is_not_known_is_refused, 0,
                        (int)(sizeof wrong / sizeof *wrong));
    tcase_add_test(sheets, a_scenario_says_what_it_asks);
    tcase_add_test(sheets, the_number_is_that_of_the_moment);
    tcase_add_loop_test(students, a_student_comes_to_the_end, 0, 2 * n_lessons);
    tcase_add_test(sheets, a_scenario_opens_on_its_own_sheet);
    tcase_add_test(sheets, a_row_that_is_asked_about_is_changed);
    tcase_add_loop_test(sheets, a_small_screen_begins_with_what_matters, 0, 2);
    tcase_add_test(sheets, bodies_are_edited_by_keys);
    tcase_add_loop_test(sheets, every_scenario_has_a_number_and_questions, 0, count);
    tcase_add_loop_test(sheets, the_number_of_a_scenario_is_known_at_its_end, 0, count);
    suite_add_tcase(suite, sheets);
    suite_add_tcase(suite, students);
}
