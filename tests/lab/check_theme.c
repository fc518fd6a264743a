/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What styles look like: told apart by every eye, on every ground, with few colours and with none. */
#include "suite.h"
#include "terminal/grid.h"

#include <math.h>

static double linear(double level)
{
    return level <= 0.04045 ? level / 12.92 : pow((level + 0.055) / 1.055, 2.4);
}

/* Relative luminance (sRGB) of a colour of xterm's 256: the greys, or the cube of six levels. */
static double luminance_of(int colour)
{
    if (colour >= 232)
        return linear((8 + 10 * (colour - 232)) / 255.0);
    static const double levels[] = {0, 95, 135, 175, 215, 255};
    static const double weights[] = {0.2126, 0.7152, 0.0722};
    const int places[3] = {(colour - 16) / 36, (colour - 16) / 6 % 6, (colour - 16) % 6};
    double luminance = 0;
    for (int i = 0; i < 3; i++)
        luminance += weights[i] * linear(levels[places[i]] / 255);
    return luminance;
}

/* What an eye that sees no hues goes by: CIE L*. */
static double lightness(int colour)
{
    return 116 * cbrt(luminance_of(colour)) - 16;
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

/* WCAG 2.1: (L1 + 0.05)/(L2 + 0.05) with the luminance of the brighter one first. */
static double contrast(double a, double b)
{
    return (fmax(a, b) + 0.05) / (fmin(a, b) + 0.05);
}

/* Greys that carry words or axes are read from the back row: 4.5 to 1, what WCAG asks of words, on grounds
 * that are not quite black (grey 234) or white (grey 254) too. */
START_TEST(greys_are_read)
{
    enum { NEARLY_BLACK = 234, NEARLY_WHITE = 254 };
    static const Style greys[] = {STYLE_FAINT, STYLE_FRAME, STYLE_GHOST_E};
    const Look dark = theme_look(256, false, greys[_i], 0), light = theme_look(256, true, greys[_i], 0);
    ck_assert_int_eq(dark.background, LOOK_DEFAULT);
    ck_assert_int_eq(light.background, LOOK_DEFAULT);
    ck_assert_double_ge(contrast(luminance_of(dark.foreground), luminance_of(NEARLY_BLACK)), 4.5);
    ck_assert_double_ge(contrast(luminance_of(light.foreground), luminance_of(NEARLY_WHITE)), 4.5);
    ck_assert_uint_eq((dark.attributes | light.attributes) & LOOK_DIM, 0);
}
END_TEST

/* The three curves have the hues of blue, orange and purple that all kinds of colour vision tell apart (Okabe
 * and Ito), with 256 colours and, as near as may be, with eight. */
START_TEST(curves_have_their_colours)
{
    static const struct {
        Style style;
        int dark, light, eight, eight_light;
    } curves[] = {
        {STYLE_MEASURED, 75, 25, 6, 4}, {STYLE_PREDICTED, 214, 130, 3, 1}, {STYLE_EXACT, 183, 90, 5, 5}};
    for (size_t i = 0; i < sizeof curves / sizeof *curves; i++) {
        ck_assert_int_eq(theme_look(256, false, curves[i].style, 0).foreground, curves[i].dark);
        ck_assert_int_eq(theme_look(256, true, curves[i].style, 0).foreground, curves[i].light);
        ck_assert_int_eq(theme_look(8, false, curves[i].style, 0).foreground, curves[i].eight);
        ck_assert_int_eq(theme_look(8, true, curves[i].style, 0).foreground, curves[i].eight_light);
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
    TCase *tcase = tcase_create("theme");
    tcase_add_test(tcase, curves_have_their_colours);
    tcase_add_test(tcase, the_ground_is_told);
    tcase_add_test(tcase, the_ramp_rises);
    tcase_add_test(tcase, everything_stands_out_from_the_ground);
    tcase_add_loop_test(tcase, greys_are_read, 0, 3);
    tcase_add_test(tcase, without_colours_attributes_remain);
    suite_add_tcase(suite, tcase);
}
