/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Lecture mode: the time and the state in large letters. */
#include "panes/panes.h"

#include <ctype.h>
#include <stdio.h>
#include <string.h>

enum { WIDE = 3, HIGH = 5, GAP = 1, FULL_BLOCK = 0x2588, UPPER_HALF = 0x2580, LOWER_HALF = 0x2584 };

/* Letters of 3 x 5 dots: one octal digit a row, from the top. */
static const struct {
    uint32_t glyph;
    unsigned rows;
} letters[] = {
    {'0', 075557}, {'1', 026227},  {'2', 071747}, {'3', 071717}, {'4', 055711}, {'5', 074717}, {'6', 074757},
    {'7', 071111}, {'8', 075757},  {'9', 075717}, {'A', 025755}, {'C', 034443}, {'D', 065556}, {'E', 074647},
    {'G', 034553}, {'I', 072227},  {'M', 057755}, {'N', 075555}, {'O', 025552}, {'P', 065644}, {'R', 065655},
    {'S', 034216}, {'T', 072222},  {'U', 055557}, {'m', 000775}, {'s', 003616}, {'t', 027223}, {'u', 000557},
    {'w', 000577}, {0xb5, 055744}, {'.', 000002}, {'-', 000700}, {'+', 002720}, {'%', 051245},
};

static unsigned rows_of(uint32_t glyph)
{
    for (size_t i = 0; i < sizeof letters / sizeof *letters; i++)
        if (letters[i].glyph == glyph)
            return letters[i].rows;
    return 0;
}

static bool is_set(unsigned rows, int x, int y)
{
    return y < HIGH && (rows >> 3 * (HIGH - 1 - y) >> (WIDE - 1 - x) & 1);
}

/* How large a dot is: half a row, or a row and so many columns. */
typedef struct Size {
    bool halves;
    int columns;
} Size;

static Size size_of(const ScreenLook *look, int width, int height)
{
    const bool large = width >= LECTURE_LARGE_WIDTH && height >= LECTURE_LARGE_HEIGHT;
    return (Size){.halves = !large && look->glyphs != GLYPHS_ASCII, .columns = large ? 2 : 1};
}

int banner_rows(const Screen *screen, int width, int height)
{
    return size_of(&screen->look, width, height).halves ? (HIGH + 1) / 2 : HIGH;
}

static int columns_of(const char *text, Size size)
{
    return (glyphs_columns(text) * (WIDE + GAP) - GAP) * size.columns;
}

static void draw_text(Area area, int x, const char *text, Size size, Style style)
{
    for (uint32_t glyph; (glyph = glyph_next(&text)) != 0; x += (WIDE + GAP) * size.columns) {
        const unsigned rows = rows_of(glyph);
        for (int y = 0; y < (size.halves ? (HIGH + 1) / 2 : HIGH); y++)
            for (int i = 0; i < WIDE * size.columns; i++) {
                const int column = i / size.columns;
                const bool upper = is_set(rows, column, size.halves ? 2 * y : y);
                const bool lower = size.halves ? is_set(rows, column, 2 * y + 1) : upper;
                if (upper || lower)
                    area_put(area, x + i, y,
                             upper && lower ? FULL_BLOCK
                             : upper        ? UPPER_HALF
                                            : LOWER_HALF,
                             style);
            }
    }
}

static void state_word(const Playback *playback, char *out, size_t size)
{
    static const char *const words[] = {[STATE_PAUSED] = "PAUSED",
                                        [STATE_RUNNING] = "RUNNING",
                                        [STATE_ENDED] = "END",
                                        [STATE_FAILED] = "STOPPED"};
    if (playback->state == STATE_COMPUTING)
        snprintf(out, size, "%.0f %%", 100 * playback->work_share);
    else
        snprintf(out, size, "%s", words[playback->state]);
}

/* The number that the lecture is about: how far the frequency, or the period, is off. "" where it is not
 * known, or is not to be told. */
static void error_word(const Screen *screen, char *out, size_t size)
{
    const Readout *readout = experiment_readout(screen->experiment);
    out[0] = '\0';
    if (!readout->moving || !readout->measured_known || !readout->exact_known || !screen_shows_exact(screen))
        return;
    snprintf(out, size, "%c%+.*f%%", readout->is_period ? 'T' : 'w',
             screen->playback.state == STATE_RUNNING ? 1 : 2,
             readout->is_period ? readout->error_period : readout->error_frequency);
}

/* Time, error, state; where they have no room beside each other the state is left to the title line. */
void pane_banner(const Screen *screen, Area area)
{
    const Size size = size_of(&screen->look, area.canvas->width, area.canvas->height);
    const int gap = 2 * WIDE * size.columns, width = area.rect.width - 2;
    char time[48], state[32], error[32];
    state_word(&screen->playback, state, sizeof state);
    error_word(screen, error, sizeof error);
    const bool calm = screen->playback.state == STATE_RUNNING || screen->playback.state == STATE_PAUSED;
    const int middle = error[0] ? columns_of(error, size) + gap : 0;
    int right = columns_of(state, size), fewer = 0;
    screen_shorter_time(screen, 8, time, sizeof time);
    if (middle && calm && columns_of(time, size) + middle + gap + right > width)
        snprintf(state, sizeof state, "%s", error), right = columns_of(state, size);
    else if (middle && columns_of(time, size) + middle + gap + right <= width)
        draw_text(area, area.rect.width - 1 - right - middle, error, size, STYLE_CHANGED);
    const int taken = right + (strcmp(state, error) != 0 ? middle : 0);
    do
        screen_shorter_time(screen, fewer, time, sizeof time);
    while (columns_of(time, size) + taken + gap > width && ++fewer < 8);
    draw_text(area, 1, time, size, STYLE_HEADING);
    draw_text(area, area.rect.width - 1 - right, state, size,
              screen->playback.state == STATE_FAILED ? STYLE_ERROR
              : middle && strcmp(state, error) == 0  ? STYLE_CHANGED
                                                     : STYLE_HEADING);
}
