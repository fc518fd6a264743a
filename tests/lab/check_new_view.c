/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A view that the program does not know: this file and its name in the list, as CONTRIBUTING says. The list
 * here takes the place of src/views/view_list.c when this program is linked; nothing else is replaced,
 * so whatever shows the view has found it there. */
#include "suite.h"
#include "scenario/concern_output.h"
#include "lab/tui_case.h"
#include "picture/paper/figure_file.h"
#include "scenario/scenario.h"
#include "help/command.h"
#include "panes/panes.h"
#include "views/view.h"
#include "panes/screen.h"

#include <stdio.h>
#include <string.h>

#define LACKING "nothing here can break"

/* --- the view ------------------------------------------------------------------------------------- */

static const char *word_of(const Screen *screen, int variant)
{
    static const char *const words[] = {"first", "second", NULL};
    (void)screen;
    return words[variant];
}

static void describe(const Screen *screen, int variant, Picture *picture)
{
    (void)screen;
    picture_axes(picture, axis_make(0, 1), "x", "", axis_make(0, 2),
                 variant == 1 ? "a new view, the second" : "a new view", "");
}

/* Five rows, which stand for particles; Enter goes to a step that is ten times the chosen one. */
static void describe_rows(const Screen *screen, int variant, Picture *picture)
{
    (void)variant;
    PictureList *list = picture_list(picture, 0, 5, screen->chosen.particle, 0);
    picture_heading(picture, "rows of its own");
    strcpy(list->what, "row");
    for (size_t i = 0; i < list->rows; i++)
        snprintf(list->names[i], sizeof list->names[i], "row%zu", list->first + i);
    picture->step = 10 * (long)screen->chosen.particle;
}

static const View view_new = {
    .word = "new-view",
    .brief = "new",
    .help = "a picture that only its own file and the list know",
    .digit = 9,
    .home = PANE_LOWER,
    .describe = describe,
    .variant_word = word_of,
};

static const View view_rows = {
    .word = "rows",
    .help = "a list that only its own file and the list know",
    .home = PANE_LOWER,
    .describe = describe_rows,
    .is_list = true,
    .no_figure = true,
};

/* It has no key, and wants what a bar has not. */
static const View view_needy = {
    .word = "needy",
    .help = "something about bonds that break",
    .home = PANE_UPPER,
    .describe = describe,
    .needs = HAS_BREAKING,
    .lacking = LACKING,
    .no_figure = true,
};

const View *const views[] = {&view_profile, &view_probe, &view_beam, &view_new, &view_needy, &view_rows};
const int n_views = sizeof views / sizeof *views;

/* --- what finds it ---------------------------------------------------------------------------------- */

START_TEST(it_is_shown_by_digit_and_word)
{
    Bench *bench = open_bench("mode1", true);
    const Screen *screen = &bench->lab.screen;
    ck_assert(!shows(bench, "a new view"));
    press(bench, "9");
    ck_assert_ptr_eq(screen->views.lower, &view_new);
    ck_assert(shows(bench, "a new view"));
    press(bench, "9"); /* again: the next variant */
    ck_assert(shows(bench, "a new view, the second"));
    press(bench, "2");
    ck_assert(!shows(bench, "a new view"));
    enter_line(bench, "show new-view");
    ck_assert(shows(bench, "a new view"));
    enter_line(bench, "show new-view 2");
    ck_assert(shows(bench, "a new view, the second"));
    enter_line(bench, "show needy");
    ck_assert(shows(bench, LACKING));
    press(bench, "Esc");
    press(bench, "3"); /* the digit of a view that is not in the list */
    ck_assert(shows(bench, "no view has the key 3"));
    close_bench(bench);
}
END_TEST

/* The view has no function for keys or the mouse: its picture tells what its rows stand for. */
START_TEST(keys_and_mouse_find_its_rows)
{
    Bench *bench = open_bench("mode1", true);
    Screen *screen = &bench->lab.screen;
    screen->chosen.particle = 1;
    enter_line(bench, "show rows");
    screen->panes.focus = PANE_LOWER;
    const Rect rect = screen_pane(screen, bench->width, bench->height, PANE_LOWER);
    press(bench, "Down");
    ck_assert_uint_eq(screen->chosen.particle, 2);
    press(bench, "PageDown");
    ck_assert_uint_eq(screen->chosen.particle, 4);
    ck_assert(shows(bench, "row4"));
    const int row = row_with(bench, "row4");
    click_at(bench, "Click", rect.x + 3, row - 1);
    ck_assert_uint_eq(screen->chosen.particle, 3);
    click_at(bench, "Click", rect.x + 3, rect.y); /* its heading */
    ck_assert_uint_eq(screen->chosen.particle, 3);
    press(bench, "Enter");
    while (experiment_pending(screen->experiment, &(long){0}))
        frame(bench);
    ck_assert_int_eq(experiment_step(screen->experiment), 30);
    close_bench(bench);
}
END_TEST

START_TEST(scenarios_help_and_figures_know_it)
{
    Status status = {STATUS_DONE, ""};
    Settings wanted;
    ck_assert(scenario_load("mode1", &wanted, &status) &&
              settings_set(&wanted, "view.upper", "profile", &status) &&
              settings_set(&wanted, "view.lower", "new-view", &status));
    ck_assert_msg(view_check(&wanted, NULL, &status), "%s", status.text);
    ck_assert(settings_set(&wanted, "view.lower", "log", &status)); /* of the program, not of this list */
    ck_assert(!view_check(&wanted, NULL, &status));
    ck_assert_str_eq(
        status.text,
        "view.lower: log is not allowed (profile, probe, beam, new-view, needy, rows, or 1 to 9)");
    ck_assert_str_eq(pane_command_help(command_find(command_of_digit(9))), view_new.help);
    ck_assert_str_eq(pane_command_brief(command_find(command_of_digit(9))), "new");
    ck_assert_ptr_null(pane_command_help(command_find(command_of_digit(3))));

    Bench *bench = open_bench("mode1", true);
    Screen *screen = &bench->lab.screen;
    const View *view = NULL;
    char names[512] = "";
    FILE *stream = fmemopen(names, sizeof names, "w");
    figure_names(screen, stream);
    fclose(stream);
    ck_assert_ptr_nonnull(strstr(names, "new-view:first\nnew-view:second\n"));
    ck_assert(figure_view(screen, "new-view:second", &view, &status));
    ck_assert_ptr_eq(view, &view_new);
    ck_assert_int_eq(view_variant(view, screen), 1);
    press(bench, ":");
    for (const char *at = "show ne"; *at; at++)
        press(bench, *at == ' ' ? "Space" : (const char[]){*at, '\0'});
    press(bench, "Tab"); /* needy has nothing to show here */
    ck_assert_str_eq(screen->prompt->text, "show new-view");
    close_bench(bench);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *found = tcase_create("found");
    tcase_add_test(found, it_is_shown_by_digit_and_word);
    tcase_add_test(found, keys_and_mouse_find_its_rows);
    tcase_add_test(found, scenarios_help_and_figures_know_it);
    suite_add_tcase(suite, found);
}
