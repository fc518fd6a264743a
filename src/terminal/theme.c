/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "terminal/grid.h"

#include <stdlib.h>
#include <string.h>

/* The hues are those that Okabe and Ito found to be distinguishable in all kinds of colour vision: blue for
 * what is measured, orange for what is predicted, purple for what is exact; brightness differs too, and the
 * curves have their own strokes. */
typedef struct Row {
    short dark, light, eight, eight_light; /* foreground of 256 colours and of eight, by ground */
    short dark_back, light_back, eight_back;
    unsigned char coloured, plain; /* attributes with and without colours */
} Row;

#define D LOOK_DEFAULT

static const Row rows[STYLE_RAMP_0] = {
    [STYLE_NORMAL] = {D, D, D, D, D, D, D, 0, 0},
    [STYLE_TITLE] = {231, 231, 7, 7, 24, 25, 4, 0, LOOK_REVERSE},
    [STYLE_FRAME] = {245, 241, D, D, D, D, D, 0, 0},
    [STYLE_FOCUS] = {81, 25, 6, 4, D, D, D, LOOK_BOLD, LOOK_BOLD},
    [STYLE_HEADING] = {D, D, D, D, D, D, D, LOOK_BOLD, LOOK_BOLD},
    [STYLE_FAINT] = {250, 239, D, D, D, D, D, 0, LOOK_DIM},
    [STYLE_SELECTED] = {D, D, D, D, D, D, D, LOOK_REVERSE, LOOK_REVERSE},
    [STYLE_EDIT] = {D, D, D, D, D, D, D, LOOK_BOLD | LOOK_UNDERLINE, LOOK_BOLD | LOOK_UNDERLINE},
    [STYLE_CHANGED] = {227, 130, 3, 1, D, D, D, LOOK_BOLD, LOOK_BOLD},
    [STYLE_WARNING] = {214, 130, 3, 1, D, D, D, LOOK_BOLD, LOOK_BOLD},
    [STYLE_ERROR] = {231, 231, 7, 7, 160, 160, 1, LOOK_BOLD, LOOK_BOLD | LOOK_REVERSE},
    [STYLE_KEY] = {222, 228, 3, 3, 24, 25, 4, LOOK_BOLD, LOOK_BOLD | LOOK_REVERSE},
    [STYLE_MEASURED] = {75, 25, 6, 4, D, D, D, LOOK_BOLD, LOOK_BOLD},
    [STYLE_PREDICTED] = {214, 130, 3, 1, D, D, D, 0, 0},
    [STYLE_EXACT] = {183, 90, 5, 5, D, D, D, 0, 0},
    [STYLE_SECOND] = {79, 29, 2, 2, D, D, D, 0, 0},
    [STYLE_THIRD] = {229, 94, 7, 0, D, D, D, 0, 0},
    [STYLE_GHOST_A] = {168, 125, 1, 1, D, D, D, 0, 0},
    [STYLE_GHOST_B] = {143, 100, 2, 2, D, D, D, 0, 0},
    [STYLE_GHOST_C] = {109, 66, 6, 4, D, D, D, 0, 0},
    [STYLE_GHOST_D] = {180, 94, 5, 5, D, D, D, 0, 0},
    [STYLE_GHOST_E] = {250, 240, 7, 0, D, D, D, 0, 0},
};

/* From dark purple over green to yellow, brightness rising all the way, so that it reads in grey too. On a
 * light ground it ends in a darker yellow, which still differs from white. */
static const short ramp_256[2][RAMP_STEPS] = {
    {53, 54, 55, 24, 25, 61, 31, 67, 36, 72, 77, 113, 149, 185, 220, 226},
    {53, 54, 55, 24, 25, 61, 30, 31, 67, 36, 72, 106, 107, 142, 143, 178},
};

/* Four of the eight colours, four steps each, by brightness: away from that of the ground. On a dark one
 * blue, cyan, yellow, white, on a light one cyan, magenta, blue, black; below zero and above never share one.
 */
static const short ramp_8[2][4] = {{4, 6, 3, 7}, {6, 5, 4, 0}};

static int colour_of(int colours, bool light, unsigned style)
{
    if (style >= STYLE_RAMP_0)
        return colours == 256 ? ramp_256[light][style - STYLE_RAMP_0]
                              : ramp_8[light][(style - STYLE_RAMP_0) / 4];
    const Row *row = &rows[style];
    if (colours == 256)
        return light ? row->light : row->dark;
    return light ? row->eight_light : row->eight;
}

Look theme_look(int colours, bool light, unsigned style, unsigned back)
{
    if (style >= STYLE_COUNT)
        style = STYLE_NORMAL;
    if (back > STYLE_COUNT)
        back = 0;
    Look look = {LOOK_DEFAULT, LOOK_DEFAULT, 0};
    const Row *row = style < STYLE_RAMP_0 ? &rows[style] : &rows[STYLE_NORMAL];
    look.attributes = colours ? row->coloured : row->plain;
    if (!colours)
        return look;
    look.foreground = colour_of(colours, light, style);
    look.background = colours == 256 ? (light ? row->light_back : row->dark_back) : row->eight_back;
    if (back)
        look.background = colour_of(colours, light, back - 1);
    /* eight colours have no grey: what is faint is dim, what is bright is bold */
    if (colours == 8 && style == STYLE_FAINT)
        look.attributes |= LOOK_DIM;
    return look;
}

bool theme_is_light(const char *theme, const char *colorfgbg)
{
    if (theme && strcmp(theme, "auto") != 0)
        return strcmp(theme, "light") == 0;
    /* "foreground;background" or "foreground;other;background" in the eight colours and their bright twins */
    const char *last = colorfgbg ? strrchr(colorfgbg, ';') : NULL;
    if (!last)
        return false;
    long ground = strtol(last + 1, NULL, 10);
    return ground == 7 || ground == 15;
}
