/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is said in words is shown whole: captions, summaries, stages, the title line, the key line and every
 * page of the help, of every scenario, at the sizes that people have. */
#include "suite.h"
#include "scenario/scenario.h"
#include "panes/panes.h"
#include "views/scene.h"
#include "run/playback.h"
#include "panes/screen.h"

#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ELLIPSIS = 0x2026 };

static const int sizes[][2] = {{60, 18}, {80, 24}, {132, 43}, {200, 60}};

/* Nothing in a part of the picture ends in an ellipsis. */
static void check_whole(const Scene *scene, Rect part, const char *what)
{
    const Canvas *canvas = &scene->canvas;
    for (int y = part.y; y < part.y + part.height; y++)
        for (int x = part.x; x < part.x + part.width; x++)
            if (canvas->cells[y * canvas->width + x].glyph == ELLIPSIS) {
                char *text = canvas_dump(canvas);
                ck_abort_msg("%s, %s at %dx%d, row %d is cut:\n%s", scene->scenario, what, canvas->width,
                             canvas->height, y, text);
            }
}

static void draw_at(Scene *scene, int width, int height)
{
    ck_assert(canvas_open(&scene->canvas, width, height, NULL));
    screen_draw(&scene->screen, &scene->canvas);
}

/* The box, the title and the keys in one state of the run. */
static void check_box(Scene *scene, RunState state, const char *what)
{
    scene->playback.state = state;
    scene->screen.panes.focus = PANE_BOX;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const int width = sizes[i][0], height = sizes[i][1];
        draw_at(scene, width, height);
        check_whole(scene, screen_pane(&scene->screen, width, height, PANE_BOX), what);
        check_whole(scene, (Rect){0, 0, width, 1}, what);
        check_whole(scene, (Rect){0, height - 1, width, 1}, what);
    }
}

START_TEST(captions_are_shown_whole)
{
    char words[128];
    Scene scene;
    Status status = {STATUS_DONE, ""};
    snprintf(words, sizeof words, "%s 80x24 3", builtin_scenarios[_i].name);
    ck_assert_msg(scene_open(&scene, words, &status), "%s", status.text);
    check_box(&scene, STATE_RUNNING, "the caption");
    check_box(&scene, STATE_PAUSED, "the next stage");
    check_box(&scene, STATE_ENDED, "the summary");
    scene_close(&scene);
}
END_TEST

START_TEST(help_is_shown_whole)
{
    static const char *const scenarios[] = {"mode5", "mode5-peridynamics", "supported-beam-coarse",
                                            "notched-beam-coarse", "two-discs"};
    char words[128];
    Scene scene;
    Status status = {STATUS_DONE, ""};
    snprintf(words, sizeof words, "%s 80x24 3", scenarios[_i]);
    ck_assert_msg(scene_open(&scene, words, &status), "%s", status.text);
    scene.help.open = true;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        for (int page = 0; page < help_pages(&scene.screen); page++) {
            const int width = sizes[i][0], height = sizes[i][1];
            scene.help.page = page;
            const int most = help_most(&scene.screen, width, height);
            for (int scroll = 0; scroll <= most + height; scroll += height - 4) {
                scene.help.scroll = scroll < most ? scroll : most;
                draw_at(&scene, width, height);
                check_whole(&scene, (Rect){0, 0, width, height}, "the help");
            }
        }
    scene_close(&scene);
}
END_TEST

/* The help explains the method that runs, and has no page without content. */
START_TEST(help_is_of_the_method)
{
    static const struct {
        unsigned has;
        const char *said, *other; /* on the page of what is solved, and what belongs to others */
    } rows[] = {
        {HAS_BODIES, "Walls and contact", "horizon"},
        {HAS_BODIES, "momentum balance", "velocity Verlet"},
        {HAS_BODIES, "turns with the particle (eq. 6", "Euler-Bernoulli"},
        {HAS_LINE | HAS_MESH, "axial vibration of a bar", "horizon"},
        {HAS_LINE | HAS_BONDS, "by bonds", "uGIMP"},
        {HAS_PLANE | HAS_MESH, "a beam in plane stress", "horizon"},
        {HAS_PLANE | HAS_BONDS, "nodes joined by bonds", "uGIMP"},
    };
    char words[128];
    Scene scene;
    Status status = {STATUS_DONE, ""};
    snprintf(words, sizeof words, "%s 132x120 1", builtin_scenarios[_i].name);
    ck_assert_msg(scene_open(&scene, words, &status), "%s", status.text);
    scene.help.open = true;
    for (scene.help.page = 0; scene.help.page < help_pages(&scene.screen); scene.help.page++) {
        draw_at(&scene, 132, 120);
        char *text = canvas_dump(&scene.canvas);
        const char *content = strstr(text, "\n── Help");
        ck_assert_ptr_nonnull(content);
        content = strchr(content + 1, '\n');
        int lines = 0;
        for (const char *line = content; *line; line++)
            lines += line[0] == '\n' && line[1] != '\n' && line[1] != '\0';
        ck_assert_msg(lines > 4, "%s, page %d is empty:\n%s", words, scene.help.page, text);
        for (size_t i = 0; i < sizeof rows / sizeof *rows && scene.help.page == 2; i++)
            if (simulation_has(experiment_simulation(scene.screen.experiment), rows[i].has))
                ck_assert_msg(strstr(content, rows[i].said) && !strstr(content, rows[i].other), "%s:\n%s",
                              words, text);
        free(text);
    }
    scene_close(&scene);
}
END_TEST

/* The displacement has six rows at 80x24 while a run goes on, and the first page of the help begins with the
 * keys that matter. */
START_TEST(what_matters_has_room)
{
    Scene scene;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(&scene, "mode5 80x24 3 running", &status), "%s", status.text);
    ck_assert_int_eq(screen_pane(&scene.screen, 80, 24, PANE_UPPER).height,
                     8); /* heading and axis with them */
    char *text = canvas_dump(&scene.canvas);
    ck_assert(strncmp(text, " Why is mode 5 late?", 20) == 0);
    ck_assert_ptr_nonnull(strstr(text, "v_cm: velocity of the centre of mass"));
    ck_assert_ptr_nonnull(strstr(text, "New here?  T lessons  o scenarios"));
    free(text);
    scene.help.open = true;
    draw_at(&scene, 80, 24);
    text = canvas_dump(&scene.canvas);
    ck_assert_ptr_nonnull(strstr(text, "Keys of this screen\n   Space"));
    free(text);
    scene_close(&scene);
}
END_TEST

/* Rows of a pane in which nothing stands. */
static int empty_rows(const Scene *scene, Rect part)
{
    const Canvas *canvas = &scene->canvas;
    int count = 0;
    for (int y = part.y; y < part.y + part.height; y++) {
        int x = part.x;
        while (x < part.x + part.width && canvas->cells[y * canvas->width + x].glyph == ' ')
            x++;
        count += x == part.x + part.width;
    }
    return count;
}

/* On a large screen the map of a beam lies along all that the fields leave, higher than half of the rows
 * where the beam is high; no more than two rows of the box below it are empty, and nothing leaves the screen.
 */
START_TEST(the_map_grows_with_the_screen)
{
    static const struct {
        const char *words;
        int width, least; /* of the map */
    } cases[] = {{"supported-beam-coarse 132x43 100 upper 8", 103, 14},
                 {"supported-beam-coarse 132x43 100 upper 8 running", 103, 15},
                 {"supported-beam-coarse 200x60 100 upper 8", 171, 23},
                 {"notched-beam-coarse 132x43 100 upper 8", 103, 17},
                 {"notched-beam-coarse 200x60 100 upper 8 running", 171, 27}};
    Scene scene;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(&scene, cases[_i].words, &status), "%s", status.text);
    const int width = scene.canvas.width, height = scene.canvas.height;
    const Rect map = screen_pane(&scene.screen, width, height, PANE_UPPER);
    const Rect below = screen_pane(&scene.screen, width, height, PANE_LOWER);
    const Rect box = screen_pane(&scene.screen, width, height, PANE_BOX);
    ck_assert_int_eq(map.width, cases[_i].width);
    ck_assert_int_ge(map.height, cases[_i].least);
    ck_assert_int_ge(below.y, map.y + map.height);
    ck_assert_int_le(empty_rows(&scene, box), scene.screen.playback->state == STATE_RUNNING ? 1 : 2);
    char *text = canvas_dump(&scene.canvas);
    ck_assert_ptr_nonnull(strstr(text, "── energy"));
    ck_assert_ptr_nonnull(strstr(text, "── particles"));
    free(text);
    scene_close(&scene);
}
END_TEST

/* What the scenario is about stands in large digits, of a lecture in larger ones, as soon as it is known; a
 * class that is to guess sees it as little as the exact answer. */
static const struct {
    const char *words;
    int rows; /* of the digits; 0: there are none */
} numbers[] = {
    {"mode5 80x24 1310 running bare", 3},    {"mode5 60x18 1310 bare", 3},
    {"mode5 80x24 1310 bare ascii", 5},      {"mode5 132x43 1310 bare", 5},
    {"mode5 80x24 1310 running lecture", 5}, {"mode5 132x43 1310 lecture", 10},
    {"mode5 200x60 1310 lecture", 10},       {"mode5 80x24 20 bare", 0},
    {"mode5 80x24 1310 lecture none", 0},
};

START_TEST(the_number_stands_in_large_digits)
{
    Scene scene;
    Status status = {STATUS_DONE, ""};
    ck_assert_msg(scene_open(&scene, numbers[_i].words, &status), "%s", status.text);
    const Canvas *canvas = &scene.canvas;
    const Rect rect = layout_make(&scene.screen, canvas->width, canvas->height).number;
    int first = -1, last = -1;
    for (int y = rect.y; y < rect.y + rect.height; y++)
        for (int x = rect.x; x < rect.x + rect.width; x++) {
            const Cell *cell = &canvas->cells[y * canvas->width + x];
            const bool ink = (cell->glyph >= 0x2580 && cell->glyph <= 0x2588) || cell->glyph == '#';
            if (cell->style != STYLE_CHANGED || !ink)
                continue;
            first = first < 0 ? y : first;
            last = y;
        }
    ck_assert_int_gt(rect.width, 0);
    ck_assert_msg((first < 0 ? 0 : last - first + 1) == numbers[_i].rows, "%s: rows %d to %d",
                  numbers[_i].words, first, last);
    char *text = canvas_dump(canvas);
    ck_assert_ptr_nonnull(strstr(text, "periods"));
    ck_assert((strstr(text, "periods behind") != NULL) == (numbers[_i].rows > 0));
    free(text);
    scene_close(&scene);
}
END_TEST

void add_cases(Suite *suite)
{
    int count = 0;
    setlocale(LC_CTYPE, "C.UTF-8");
    while (builtin_scenarios[count].name)
        count++;
    TCase *texts = tcase_create("texts");
    tcase_add_loop_test(texts, captions_are_shown_whole, 0, count);
    tcase_add_loop_test(texts, help_is_shown_whole, 0, 5);
    tcase_add_loop_test(texts, help_is_of_the_method, 0, count);
    tcase_add_test(texts, what_matters_has_room);
    tcase_add_loop_test(texts, the_number_stands_in_large_digits, 0, (int)(sizeof numbers / sizeof *numbers));
    tcase_add_loop_test(texts, the_map_grows_with_the_screen, 0, 5);
    suite_add_tcase(suite, texts);
}
