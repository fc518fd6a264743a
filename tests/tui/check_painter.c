/* What the painter writes makes a terminal show the canvas, whatever it showed before. */
#include "suite.h"
#include "tui/terminal/painter.h"
#include "tui/terminal/theme.h"

#include <math.h>
#include <stdint.h>
#include <string.h>

#include <vterm.h>

enum { WIDTH = 37, HEIGHT = 11 };

typedef struct Scene {
    Painter painter;
    Canvas canvas;
    VTerm *vterm;
    VTermScreen *screen;
} Scene;

static void open_scene(Scene *scene, int colours)
{
    *scene = (Scene){.painter = {.colours = colours, .utf8 = true}};
    Capabilities *can = &scene->painter.can;
    strcpy(can->move, "\033[%i%p1%d;%p2%dH");
    strcpy(can->clear, "\033[H\033[2J$<50>");
    strcpy(can->plain, "\033[m");
    strcpy(can->bold, "\033[1m");
    strcpy(can->underline, "\033[4m$<2>");
    strcpy(can->reverse, "\033[7m");
    strcpy(can->foreground, "\033[38;5;%p1%dm");
    strcpy(can->background, "\033[48;5;%p1%dm");
    strcpy(can->hide_cursor, "\033[?25l");
    strcpy(can->show_cursor, "\033[?25h");
    scene->vterm = vterm_new(HEIGHT, WIDTH);
    vterm_set_utf8(scene->vterm, 1);
    scene->screen = vterm_obtain_screen(scene->vterm);
    vterm_screen_reset(scene->screen, 1);
    ck_assert(canvas_open(&scene->canvas, WIDTH, HEIGHT, NULL));
}

static void close_scene(Scene *scene)
{
    painter_close(&scene->painter);
    canvas_close(&scene->canvas);
    vterm_free(scene->vterm);
}

static size_t paint(Scene *scene)
{
    size_t length;
    const char *bytes = painter_paint(&scene->painter, &scene->canvas, WIDTH, HEIGHT, &length);
    if (length > 0)
        vterm_input_write(scene->vterm, bytes, length);
    return length;
}

static void check_colour(VTermScreen *screen, VTermColor colour, bool is_default, int wanted)
{
    (void)screen;
    ck_assert_int_eq(is_default, wanted == LOOK_DEFAULT);
    if (wanted != LOOK_DEFAULT) {
        ck_assert(VTERM_COLOR_IS_INDEXED(&colour));
        ck_assert_int_eq(colour.indexed.idx, wanted);
    }
}

static void check_shown(const Scene *scene)
{
    for (int y = 0; y < HEIGHT; y++)
        for (int x = 0; x < WIDTH; x++) {
            const Cell *cell = &scene->canvas.cells[y * WIDTH + x];
            VTermScreenCell shown;
            ck_assert(vterm_screen_get_cell(scene->screen, (VTermPos){.row = y, .col = x}, &shown));
            uint32_t glyph = cell->glyph ? cell->glyph : ' ';
            uint32_t seen = shown.chars[0] ? shown.chars[0] : ' ';
            ck_assert_msg(seen == glyph, "%d, %d: U+%04X, not U+%04X", x, y, seen, glyph);
            Look look = theme_look(scene->painter.colours, false, cell->style, cell->back);
            check_colour(scene->screen, shown.fg, VTERM_COLOR_IS_DEFAULT_FG(&shown.fg), look.foreground);
            check_colour(scene->screen, shown.bg, VTERM_COLOR_IS_DEFAULT_BG(&shown.bg), look.background);
            ck_assert_int_eq(shown.attrs.bold, (look.attributes & LOOK_BOLD) != 0);
            ck_assert_int_eq(shown.attrs.reverse, (look.attributes & LOOK_REVERSE) != 0);
            ck_assert_int_eq(shown.attrs.underline != 0, (look.attributes & LOOK_UNDERLINE) != 0);
        }
}

static uint64_t next_random(uint64_t *random)
{
    *random ^= *random << 13, *random ^= *random >> 7, *random ^= *random << 17;
    return *random >> 11;
}

static const int depths[] = {256, 8, 0};

START_TEST(any_change_is_shown)
{
    static const uint32_t glyphs[] = {' ', 'a', '~', 0xe9, 0x3c9, 0x2500, 0x28ff, 0x2588, 0};
    uint64_t random = 88172645463325252u;
    Scene scene;
    open_scene(&scene, depths[_i]);
    for (int round = 0; round < 300; round++) {
        /* from one cell to all of them, in runs */
        long changes = 1L << (next_random(&random) % 9);
        for (long i = 0; i < changes; i++) {
            size_t at = next_random(&random) % (WIDTH * HEIGHT);
            unsigned style = (unsigned)(next_random(&random) % STYLE_COUNT);
            unsigned back =
                next_random(&random) % 4 ? 0 : (unsigned)(next_random(&random) % (STYLE_COUNT + 1));
            for (size_t run = next_random(&random) % 6; run > 0 && at < WIDTH * HEIGHT; run--, at++)
                scene.canvas.cells[at] =
                    (Cell){glyphs[next_random(&random) % 9], (uint16_t)style, (uint16_t)back};
        }
        if (next_random(&random) % 20 == 0)
            painter_forget(&scene.painter);
        paint(&scene);
        check_shown(&scene);
    }
    close_scene(&scene);
}
END_TEST

START_TEST(no_change_is_no_byte)
{
    Scene scene;
    open_scene(&scene, 256);
    canvas_text(&scene.canvas, 3, 2, 20, "measured", STYLE_MEASURED);
    ck_assert_uint_gt(paint(&scene), 0);
    ck_assert_uint_eq(paint(&scene), 0);
    canvas_text(&scene.canvas, 3, 2, 20, "Measured", STYLE_MEASURED);
    ck_assert_uint_le(paint(&scene), 32); /* one letter, its place and its style */
    ck_assert_uint_eq(paint(&scene), 0);
    close_scene(&scene);
}
END_TEST

START_TEST(the_cursor_stands_where_it_should)
{
    Scene scene;
    VTermPos place;
    open_scene(&scene, 256);
    scene.canvas.cursor_x = 5;
    scene.canvas.cursor_y = 7;
    paint(&scene);
    vterm_state_get_cursorpos(vterm_obtain_state(scene.vterm), &place);
    ck_assert_int_eq(place.col, 5);
    ck_assert_int_eq(place.row, 7);
    /* and comes back after something was written elsewhere */
    canvas_put(&scene.canvas, WIDTH - 1, 0, 'x', STYLE_NORMAL);
    paint(&scene);
    vterm_state_get_cursorpos(vterm_obtain_state(scene.vterm), &place);
    ck_assert_int_eq(place.col, 5);
    ck_assert_int_eq(place.row, 7);
    scene.canvas.cursor_x = scene.canvas.cursor_y = -1;
    ck_assert_uint_gt(paint(&scene), 0); /* hidden */
    ck_assert_uint_eq(paint(&scene), 0);
    close_scene(&scene);
}
END_TEST

/* A terminal that scrolls when its last cell is written must not be tempted. */
START_TEST(the_last_cell_does_not_scroll)
{
    Scene scene;
    open_scene(&scene, 0);
    scene.painter.can.margin_scrolls = true;
    canvas_put(&scene.canvas, WIDTH - 1, HEIGHT - 1, 'x', STYLE_NORMAL);
    canvas_put(&scene.canvas, WIDTH - 2, HEIGHT - 1, 'y', STYLE_NORMAL);
    paint(&scene);
    VTermScreenCell shown;
    vterm_screen_get_cell(scene.screen, (VTermPos){.row = HEIGHT - 1, .col = WIDTH - 2}, &shown);
    ck_assert_uint_eq(shown.chars[0], 'y');
    vterm_screen_get_cell(scene.screen, (VTermPos){.row = HEIGHT - 1, .col = WIDTH - 1}, &shown);
    ck_assert_uint_ne(shown.chars[0], 'x');
    close_scene(&scene);
}
END_TEST

START_TEST(ascii_alone_where_the_locale_has_no_more)
{
    size_t length;
    Scene scene;
    open_scene(&scene, 0);
    scene.painter.utf8 = false;
    canvas_text(&scene.canvas, 0, 0, 20, "σ → 2", STYLE_NORMAL);
    const char *bytes = painter_paint(&scene.painter, &scene.canvas, WIDTH, HEIGHT, &length);
    for (size_t i = 0; i < length; i++)
        ck_assert_uint_lt((unsigned char)bytes[i], 0x80);
    close_scene(&scene);
}
END_TEST

/* What an eye that sees no hues goes by: CIE L* of a colour of 256. */
static double lightness(int colour)
{
    if (colour >= 232) { /* the greys */
        const double level = (8 + 10 * (colour - 232)) / 255.0;
        return 116 * cbrt(pow((level + 0.055) / 1.055, 2.4)) - 16;
    }
    static const double levels[] = {0, 95, 135, 175, 215, 255};
    static const double weights[] = {0.2126, 0.7152, 0.0722};
    const int places[3] = {(colour - 16) / 36, (colour - 16) / 6 % 6, (colour - 16) % 6};
    double luminance = 0;
    for (int i = 0; i < 3; i++) {
        const double level = levels[places[i]] / 255;
        luminance += weights[i] * (level <= 0.04045 ? level / 12.92 : pow((level + 0.055) / 1.055, 2.4));
    }
    return 116 * cbrt(luminance) - 16;
}

/* More is brighter at every step, so that the ramp reads in grey; of eight colours none stands on both sides
 * of zero, and none is that of the ground. */
START_TEST(the_ramp_rises)
{
    for (int light = 0; light < 2; light++)
        for (int step = 1; step < RAMP_STEPS; step++) {
            const Look before = theme_look(256, light, STYLE_RAMP_0 + (unsigned)step - 1, 0);
            const Look here = theme_look(256, light, STYLE_RAMP_0 + (unsigned)step, 0);
            ck_assert_double_gt(lightness(here.foreground), lightness(before.foreground));
        }
    for (int light = 0; light < 2; light++)
        for (unsigned a = 0; a < RAMP_STEPS; a++) {
            const int below = theme_look(8, light, STYLE_RAMP_0 + a, 0).foreground;
            ck_assert_int_ne(below, light ? 7 : 0);
            for (unsigned b = RAMP_STEPS / 2; a < RAMP_STEPS / 2 && b < RAMP_STEPS; b++)
                ck_assert_int_ne(below, theme_look(8, light, STYLE_RAMP_0 + b, 0).foreground);
        }
}
END_TEST

/* Words and curves keep away from the ground: L* differs by 30 at least. Of eight colours the dark ones stand
 * on a light ground, for most terminals' yellow and cyan are near white. */
START_TEST(everything_stands_out_from_the_ground)
{
    for (unsigned style = 0; style < STYLE_COUNT; style++) {
        const Look dark = theme_look(256, false, style, 0), light = theme_look(256, true, style, 0);
        const Look eight = theme_look(8, true, style, 0), eight_dark = theme_look(8, false, style, 0);
        if (dark.background == LOOK_DEFAULT && dark.foreground != LOOK_DEFAULT && style < STYLE_RAMP_0)
            ck_assert_double_gt(lightness(dark.foreground), 30);
        if (light.background == LOOK_DEFAULT && light.foreground != LOOK_DEFAULT)
            ck_assert_double_lt(lightness(light.foreground), 75);
        if (eight.background == LOOK_DEFAULT && eight.foreground != LOOK_DEFAULT && style < STYLE_RAMP_0)
            ck_assert_msg(eight.foreground != 3 && eight.foreground != 6 && eight.foreground != 7, "style %u",
                          style);
        if (eight_dark.background == LOOK_DEFAULT && style < STYLE_RAMP_0)
            ck_assert(eight_dark.foreground != 0 && eight_dark.foreground != 4);
    }
}
END_TEST

START_TEST(the_ground_is_told)
{
    ck_assert(theme_is_light("light", NULL));
    ck_assert(!theme_is_light("dark", "0;15"));
    ck_assert(theme_is_light("auto", "0;15"));
    ck_assert(theme_is_light(NULL, "0;default;7"));
    ck_assert(!theme_is_light(NULL, "15;0"));
    ck_assert(!theme_is_light(NULL, NULL));
}
END_TEST

/* Meaning never by colour alone: what must be told apart differs without colours too. */
START_TEST(without_colours_attributes_remain)
{
    static const Style marked[] = {STYLE_TITLE,   STYLE_SELECTED, STYLE_EDIT,
                                   STYLE_CHANGED, STYLE_ERROR,    STYLE_FAINT};
    for (size_t i = 0; i < sizeof marked / sizeof *marked; i++) {
        Look look = theme_look(0, false, marked[i], 0);
        ck_assert_int_eq(look.foreground, LOOK_DEFAULT);
        ck_assert_int_eq(look.background, LOOK_DEFAULT);
        ck_assert_uint_ne(look.attributes, 0);
    }
    ck_assert_uint_ne(theme_look(0, false, STYLE_SELECTED, 0).attributes,
                      theme_look(0, false, STYLE_EDIT, 0).attributes);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("painter");
    tcase_add_loop_test(tcase, any_change_is_shown, 0, 3);
    tcase_add_test(tcase, no_change_is_no_byte);
    tcase_add_test(tcase, the_cursor_stands_where_it_should);
    tcase_add_test(tcase, the_last_cell_does_not_scroll);
    tcase_add_test(tcase, ascii_alone_where_the_locale_has_no_more);
    tcase_add_test(tcase, the_ground_is_told);
    tcase_add_test(tcase, the_ramp_rises);
    tcase_add_test(tcase, everything_stands_out_from_the_ground);
    tcase_add_test(tcase, without_colours_attributes_remain);
    suite_add_tcase(suite, tcase);
}
