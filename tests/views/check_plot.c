/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Ticks are round, labels agree with them, and a curve's column shows all that its samples do. */
#include "picture/cells/cells.h"
#include "suite.h"
#include "picture/plot.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static uint64_t random_bits(uint64_t *state)
{
    *state ^= *state << 13, *state ^= *state >> 7, *state ^= *state << 17;
    return *state;
}

static double random_share(uint64_t *state)
{
    return (double)(random_bits(state) >> 11) * 0x1p-53;
}

START_TEST(ticks_are_1_2_5)
{
    uint64_t state = 12345;
    for (int i = 0; i < 20000; i++) {
        double scale = pow(10, random_share(&state) * 24 - 12), low = (random_share(&state) - 0.5) * scale;
        double high = low + scale * (0.01 + random_share(&state));
        int most = 2 + (int)(random_bits(&state) % 9);
        Axis axis = axis_with_ticks(axis_make(low, high), most);
        double ticks[TICKS_MAX];
        int count = axis_ticks(&axis, ticks);
        ck_assert_msg(count >= 1 && count <= most, "%d ticks in %g..%g", count, low, high);
        double digit = axis.step / pow(10, floor(log10(axis.step * (1 + 1e-9))));
        ck_assert_msg(fabs(digit - 1) < 1e-6 || fabs(digit - 2) < 1e-6 || fabs(digit - 5) < 1e-6, "step %g",
                      axis.step);
        ck_assert_int_eq(axis.exponent % 3, 0);
        for (int k = 0; k < count; k++) {
            char text[TICK_TEXT_MAX];
            axis_label(&axis, ticks[k], text);
            double shown = strtod(text, NULL) * pow(10, axis.exponent);
            ck_assert_msg(fabs(shown - ticks[k]) <= 1e-6 * axis.step + 1e-12 * fabs(ticks[k]),
                          "tick %.17g is labelled %s x10^%d", ticks[k], text, axis.exponent);
            ck_assert(ticks[k] >= low - 1e-6 * (high - low) && ticks[k] <= high + 1e-6 * (high - low));
        }
    }
}
END_TEST

START_TEST(rounded_up_is_above_and_near)
{
    uint64_t state = 99;
    for (int i = 0; i < 20000; i++) {
        double value = pow(10, random_share(&state) * 40 - 20), up = axis_round_up(value);
        ck_assert_msg(up >= value * (1 - 1e-9) && up <= 1.5 * value, "%g -> %g", value, up);
        double step = axis_step_up(value), down = axis_step_down(value);
        ck_assert_msg(step >= value * (1 - 1e-9) && step <= 2.51 * value, "%g -> %g", value, step);
        ck_assert_msg(down <= value * (1 + 1e-9) && down >= value / 2.51, "%g -> %g", value, down);
    }
}
END_TEST

/* Around 0 there is a tick on either side; things are counted in whole numbers. */
START_TEST(ticks_tell_a_scale)
{
    uint64_t state = 7;
    double ticks[TICKS_MAX];
    for (int i = 0; i < 5000; i++) {
        const int most = 3 + (int)(random_bits(&state) % 6);
        const double reach = pow(10, random_share(&state) * 12 - 6);
        Axis axis = axis_with_ticks(axis_symmetric(reach), most);
        ck_assert_msg(axis_ticks(&axis, ticks) >= 3 && axis.high >= reach, "+-%g, %d ticks", reach, most);
        axis = axis_with_ticks(axis_count(floor(reach)), most);
        const int count = axis_ticks(&axis, ticks);
        ck_assert(count >= 2 && axis.high >= floor(reach));
        for (int k = 0; k < count; k++)
            ck_assert_msg(ticks[k] == floor(ticks[k]), "%g of %g things", ticks[k], reach);
    }
}
END_TEST

START_TEST(an_axis_says_its_power_of_ten)
{
    char text[TICK_TEXT_MAX];
    Axis axis = axis_with_ticks(axis_make(-0.0071, 0.0071), 3);
    axis_label(&axis, axis.step, text);
    ck_assert_str_eq(text, "5");
    axis_scale_text(&axis, "length/time", text);
    ck_assert_str_eq(text, "x10^-3");
    axis = axis_with_ticks(axis_make(0, 1.8e-3), 5);
    axis_scale_text(&axis, "s", text);
    ck_assert_str_eq(text, "ms");
    axis = axis_with_ticks(axis_make(-3e-6, 3e-6), 5);
    axis_scale_text(&axis, "m", text);
    ck_assert_str_eq(text, "µm");
    axis = axis_with_ticks(axis_make(0, 25), 6);
    axis_scale_text(&axis, "length", text);
    ck_assert_str_eq(text, "");
    axis = axis_with_ticks(axis_make(NAN, 4), 6);
    ck_assert(axis.low == 0 && axis.high == 1);
    axis = axis_with_ticks(axis_make(2, 2), 6);
    ck_assert(axis.low == 0 && axis.high == 1);
}
END_TEST

/* --- curves --- */

typedef struct Samples {
    double x[4000], y[4000];
} Samples;

static double sample(const void *context, size_t index, double *x)
{
    const Samples *samples = context;
    *x = samples->x[index];
    return samples->y[index];
}

static bool is_lit(const Canvas *canvas, Glyphs glyphs, int x, int y)
{
    static const int bits[4][2] = {{0x01, 0x08}, {0x02, 0x10}, {0x04, 0x20}, {0x40, 0x80}};
    int across = plot_dots_across(glyphs), down = plot_dots_down(glyphs);
    uint32_t glyph = canvas->cells[y / down * canvas->width + x / across].glyph;
    if (glyphs == GLYPHS_BRAILLE)
        return glyph >= 0x2800 && glyph <= 0x28ff && (glyph - 0x2800) & (uint32_t)bits[y % 4][x % 2];
    if (glyphs == GLYPHS_BLOCK)
        return glyph == 0x2588 || glyph == (y % 2 ? 0x2584 : 0x2580);
    return glyph == '*';
}

START_TEST(each_column_shows_least_and_largest)
{
    enum { COLUMNS = 20, ROWS = 6, COUNT = 4000 };
    static Samples samples;
    uint64_t state = 7 + (uint64_t)_i;
    for (int i = 0; i < COUNT; i++) {
        samples.x[i] = (double)i / COUNT;
        /* rare spikes: what a sample per column would miss */
        double spike = random_bits(&state) % 97 == 0 ? random_share(&state) - 0.5 : 0;
        samples.y[i] = 0.3 * sin(40 * samples.x[i]) + spike;
    }
    const Glyphs glyphs = (Glyphs)_i;
    Canvas canvas = {0};
    ck_assert(canvas_open(&canvas, COLUMNS, ROWS, NULL));
    Plot plot = {.x = axis_with_ticks(axis_make(0, 1), 5), .y = axis_with_ticks(axis_make(-1, 1), 5)};
    plot_begin(&plot, STROKE_LINE, pen_measured);
    int dots = COLUMNS * plot_dots_across(glyphs), rows = ROWS * plot_dots_down(glyphs);
    plot_curve(&plot, sample, &samples, 0, COUNT, dots);
    ck_assert_uint_le(plot.n_points, 4 * (size_t)dots);
    plot_draw(&plot, (Area){&canvas, {0, 0, COLUMNS, ROWS}, glyphs});
    for (int column = 0; column < dots; column++) {
        double least = 1, largest = -1;
        for (int i = 0; i < COUNT; i++)
            if ((int)floor(samples.x[i] * dots) == column)
                least = fmin(least, samples.y[i]), largest = fmax(largest, samples.y[i]);
        int top = (int)floor((1 - largest) / 2 * (rows - 1) + 0.5);
        int bottom = (int)floor((1 - least) / 2 * (rows - 1) + 0.5);
        for (int row = top; row <= bottom; row++)
            ck_assert_msg(is_lit(&canvas, glyphs, column, row), "column %d: dot %d of %d..%d is dark", column,
                          row, top, bottom);
    }
    plot_close(&plot);
    canvas_close(&canvas);
}
END_TEST

START_TEST(what_is_measured_wins_a_cell)
{
    Canvas canvas = {0};
    ck_assert(canvas_open(&canvas, 10, 3, NULL));
    Plot plot = {.x = axis_with_ticks(axis_make(0, 1), 5), .y = axis_with_ticks(axis_make(-1, 1), 5)};
    plot_begin(&plot, STROKE_LINE, pen_measured);
    plot_point(&plot, 0, 0), plot_point(&plot, 1, 0);
    plot_begin(&plot, STROKE_LINE, pen_exact);
    plot_point(&plot, 0, 0.1), plot_point(&plot, 1, 0.1);
    plot_begin(&plot, STROKE_LINE, (Pen){LINE_DOTTED, ',', STYLE_FAINT, RANK_GHOST, 0});
    plot_point(&plot, 0.5, 5), plot_point(&plot, 0.5, -5);
    plot_draw(&plot, (Area){&canvas, {0, 0, 10, 3}, GLYPHS_BRAILLE});
    char *styles = canvas_dump_styles(&canvas);
    ck_assert_str_eq(styles, ".....f....\nmmmmmmmmmm\n.....f....\n");
    free(styles);
    plot_close(&plot);
    canvas_close(&canvas);
}
END_TEST

START_TEST(broken_and_wild_curves_do_no_harm)
{
    uint64_t state = 4711;
    for (int i = 0; i < 3000; i++) {
        Canvas canvas = {0};
        int width = 1 + (int)(random_bits(&state) % 30), height = 1 + (int)(random_bits(&state) % 9);
        ck_assert(canvas_open(&canvas, width, height, NULL));
        Area whole = {&canvas, {0, 0, width, height}, (Glyphs)(i % GLYPHS_COUNT)};
        Plot plot = {.x = axis_with_ticks(axis_make(0, 1), 5),
                     .y = axis_with_ticks(axis_around(-1, random_share(&state)), 4)};
        Area inner = axes_draw(whole, &plot.x, &plot.y, "t", 4);
        plot_begin(&plot, (StrokeKind)(i % 3), (Pen){(LineStyle)(i % 3), '.', STYLE_EXACT, RANK_EXACT, 0});
        for (int k = 0; k < 40; k++) {
            static const double odd[] = {NAN, INFINITY, -INFINITY, 1e300, -1e300, 0, 1e-300};
            uint64_t pick = random_bits(&state) % 20;
            double y = pick < 7 ? odd[pick] : random_share(&state) * 4 - 2;
            plot_point(&plot, k % 5 ? k / 40.0 : random_share(&state) * 3 - 1, y);
        }
        plot_draw(&plot, inner);
        plot_close(&plot);
        canvas_close(&canvas);
    }
}
END_TEST

START_TEST(axes_keep_their_gutter)
{
    Canvas canvas = {0};
    ck_assert(canvas_open(&canvas, 30, 6, NULL));
    Axis x = axis_with_ticks(axis_make(0, 25), 6), y = axis_with_ticks(axis_symmetric(0.0071), 3);
    Area inner = axes_draw((Area){&canvas, {0, 0, 30, 6}, GLYPHS_BRAILLE}, &x, &y, "x", 4);
    ck_assert_int_eq(inner.rect.x, 5);
    ck_assert_int_eq(inner.rect.height, 5);
    char *dump = canvas_dump(&canvas);
    ck_assert_str_eq(
        dump, "    │\n   5┤\n   0┤─────────────────────────\n  -5┤\n    │\n     0    5   10   15   20   x\n");
    free(dump);
    canvas_close(&canvas);
}
END_TEST

/* Ticks stand at equal distances: or are left out.
 * A cell more is rounding where ticks are two apart, and not where they are one. */
START_TEST(ticks_lie_evenly)
{
    enum { GUTTER_ROOM = 8 };
    Canvas canvas = {0};
    ck_assert(canvas_open(&canvas, 30, 24, NULL));
    uint64_t state = 5;
    for (int trial = 0; trial < 4000; trial++) {
        const double low = trial % 3 ? 0 : -random_share(&state), high = 0.01 + random_share(&state);
        const int height = 6 + trial % 20;
        const Axis x = axis_with_ticks(axis_make(0, 25), 3),
                   y = axis_with_ticks(axis_make(low, high), 1 + height / 2);
        canvas_clear(&canvas);
        axes_draw((Area){&canvas, {0, 0, 30, height}, GLYPHS_BRAILLE}, &x, &y, "x", GUTTER_ROOM);
        int before = -1, least = 100, most = 0, count = 0;
        for (int row = 0; row < height - 1; row++)
            if (canvas.cells[row * canvas.width + GUTTER_ROOM].glyph == 0x2524) {
                const int distance = row - before;
                least = count > 0 && distance < least ? distance : least;
                most = count > 0 && distance > most ? distance : most;
                before = row;
                count++;
            }
        double ticks[TICKS_MAX];
        ck_assert_msg(count >= 2 || axis_ticks(&y, ticks) < 2, "%d ticks of %g..%g in %d rows", count, low,
                      high, height);
        ck_assert_msg(count < 3 || most == least || (least >= 2 && most == least + 1),
                      "distances %d to %d of %g..%g in %d rows", least, most, low, high, height);
    }
    canvas_close(&canvas);
}
END_TEST

/* A curve of before is named by more than its letter wherever that is possible. */
START_TEST(legends_go_on_with_names)
{
    static const Legend legend[] = {{LINE_SOLID, '*', STYLE_MEASURED, "measured", NULL, 0},
                                    {LINE_DOTTED, '.', STYLE_EXACT, "exact", NULL, 0},
                                    {LINE_SOLID, 'a', STYLE_FAINT, "FLIP 1, Courant number 0.1", "a:", 0},
                                    {LINE_SOLID, 'b', STYLE_FAINT, "Courant number 0.1", "b:", 0}};
    for (int width = 36; width < 70; width++) {
        Canvas canvas = {0};
        ck_assert(canvas_open(&canvas, width, 3, NULL));
        const Area area = {&canvas, {0, 0, width, 3}, GLYPHS_ASCII};
        int named = cells_heading_draw(area, STYLE_HEADING, "v_cm", "x10^-3", legend, 4, true);
        for (int y = 1; y < 3 && named < 4; y++)
            named += legend_draw_short(area, 2, y, legend + named, 4 - named);
        char *dump = canvas_dump(&canvas);
        ck_assert_int_eq(named, 4);
        ck_assert_msg(strstr(dump, "Courant number 0.1") && strstr(dump, "b: "), "%s", dump);
        ck_assert_msg(!strstr(dump, "a: b") && !strstr(dump, "a:  "), "%s", dump);
        free(dump);
        canvas_close(&canvas);
    }
}
END_TEST

/* The solid curve has its name first, whatever the room is. */
START_TEST(legends_keep_the_solid_curve)
{
    static const Legend legend[] = {{LINE_SOLID, '*', STYLE_MEASURED, "measured", NULL, 0},
                                    {LINE_DOTTED, '.', STYLE_EXACT, "exact", NULL, 0},
                                    {LINE_DASHED, '-', STYLE_PREDICTED, "predicted", NULL, 0}};
    for (int width = 26; width < 70; width++) {
        Canvas canvas = {0};
        ck_assert(canvas_open(&canvas, width, 1, NULL));
        const int named = cells_heading_draw((Area){&canvas, {0, 0, width, 1}, GLYPHS_ASCII}, STYLE_HEADING,
                                             "v_cm", "x10^-3", legend, 3, false);
        char *dump = canvas_dump(&canvas);
        ck_assert_msg(strstr(dump, " meas"), "%s", dump);
        ck_assert_msg(named == 3 || !strstr(dump, " pred"), "%s", dump);
        ck_assert_msg(width < 43 || named == 3, "%d columns: %s", width, dump);
        free(dump);
        canvas_close(&canvas);
    }
}
END_TEST

/* A terminal that draws finer than cells is told the strokes, in 16ths of a cell; others nothing. */
START_TEST(strokes_are_described)
{
    static const double points[][2] = {{0, 0}, {2, 1}, {NAN, NAN}, {4, 1}};
    Plot plot = {.x = axis_make(0, 4), .y = axis_make(0, 1)};
    plot_begin(&plot, STROKE_LINE, pen_exact);
    for (int i = 0; i < 4; i++)
        plot_point(&plot, points[i][0], points[i][1]);
    for (int wanted = 0; wanted < 2; wanted++) {
        Canvas canvas = {.vectored = wanted};
        ck_assert(canvas_open(&canvas, 10, 4, NULL));
        plot_draw(&plot, (Area){&canvas, {1, 2, 8, 2}, GLYPHS_BRAILLE});
        char expected[80];
        snprintf(expected, sizeof expected, ";A1,2,8,2;L%d,%d,%d 0,30 64,2 - 124,2", STYLE_EXACT, LINE_DOTTED,
                 RANK_EXACT);
        if (wanted)
            ck_assert_str_eq(canvas.vectors, expected);
        else
            ck_assert_ptr_null(canvas.vectors);
        canvas_clear(&canvas);
        ck_assert(!canvas.vectors || !*canvas.vectors);
        canvas_close(&canvas);
    }
    plot_close(&plot);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *axes = tcase_create("axes");
    tcase_add_test(axes, ticks_are_1_2_5);
    tcase_add_test(axes, rounded_up_is_above_and_near);
    tcase_add_test(axes, ticks_tell_a_scale);
    tcase_add_test(axes, an_axis_says_its_power_of_ten);
    tcase_add_test(axes, axes_keep_their_gutter);
    tcase_add_test(axes, ticks_lie_evenly);
    tcase_add_test(axes, legends_keep_the_solid_curve);
    tcase_add_test(axes, legends_go_on_with_names);
    suite_add_tcase(suite, axes);
    TCase *curves = tcase_create("curves");
    tcase_add_loop_test(curves, each_column_shows_least_and_largest, 0, GLYPHS_COUNT);
    tcase_add_test(curves, strokes_are_described);
    tcase_add_test(curves, what_is_measured_wins_a_cell);
    tcase_add_test(curves, broken_and_wild_curves_do_no_harm);
    suite_add_tcase(suite, curves);
}
