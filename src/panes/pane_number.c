/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The plain sheet: the number that the scenario is about in large digits, and what it is called. */
#include "panes/panes.h"
#include "answers/run_numbers.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { WIDE = 3, HIGH = 5, GAP = 1, FULL_BLOCK = 0x2588, UPPER_HALF = 0x2580, LOWER_HALF = 0x2584 };

#define NUMBER_MOST 1e6 /* more than this has no room, and no meaning */

/* Letters of 3 x 5 dots: one octal digit a row, from the top. */
static const struct {
    uint32_t glyph;
    unsigned rows;
} letters[] = {
    {'0', 075557}, {'1', 026227},  {'2', 071747}, {'3', 071717}, {'4', 055711}, {'5', 074717}, {'6', 074757},
    {'7', 071111}, {'8', 075757},  {'9', 075717}, {'A', 025755}, {'C', 034443}, {'D', 065556}, {'E', 074647},
    {'G', 034553}, {'I', 072227},  {'M', 057755}, {'N', 075555}, {'O', 025552}, {'P', 065644}, {'R', 065655},
    {'S', 034216}, {'T', 072222},  {'U', 055557}, {'m', 000775}, {'s', 003616}, {'t', 027223}, {'u', 000557},
    {'w', 000577}, {0xb5, 055744}, {'.', 000002}, {'-', 000700}, {'+', 002720}, {'%', 051245}, {'?', 061202},
};

static bool is_set(unsigned rows, int x, int y)
{
    return y < HIGH && (rows >> 3 * (HIGH - 1 - y) >> (WIDE - 1 - x) & 1);
}

/* How large a dot is: half a row, or so many rows and columns. */
typedef struct Size {
    bool halves;
    int columns, rows;
} Size;

/* In a lecture twice as large as else, and so where there is much room. */
static Size size_of(const Screen *screen, int width, int height)
{
    const bool lecture = screen->panes.lecture, roomy = width >= ROOMY_WIDTH && height >= ROOMY_HEIGHT;
    const int scale = (lecture && height >= LECTURE_HEIGHT) + (roomy ? 1 : 0);
    if (scale == 0 && screen->look.glyphs != GLYPHS_ASCII)
        return (Size){.halves = true, .columns = 1, .rows = 1};
    return (Size){.columns = scale == 0 ? 1 : 2 * scale, .rows = scale == 0 ? 1 : scale};
}

static int digit_rows(Size size)
{
    return size.halves ? (HIGH + 1) / 2 : HIGH * size.rows;
}

int pane_number_rows(const Screen *screen, int width, int height)
{
    return digit_rows(size_of(screen, width, height)) + 1;
}

bool screen_number(const Screen *screen, char digits[NUMBER_DIGITS_MAX], char words[NUMBER_WORDS_MAX])
{
    const RunNumber *number = run_number_about(screen_settings(screen));
    RunSummary summary;
    summary_now(screen->experiment, number->part, &summary);
    const double value = number->value(&summary, number->word) * number->scale;
    const bool hidden = number->judged && !screen_shows_exact(screen);
    const char *gap = number->unit[0] ? " " : "";
    if (hidden || !isfinite(value)) {
        /* of what may turn out either way the words that both have: what is too long or short has an error */
        int same = (int)strlen(number->label);
        for (int i = 0; number->opposite && i < same; i++)
            same = number->label[i] == number->opposite[i] ? same : i;
        while (number->opposite && same > 0 && number->label[same - 1] != ' ') /* whole words */
            same--;
        strcpy(digits, hidden ? "?" : "...");
        snprintf(words, NUMBER_WORDS_MAX, "%s%s%.*s", number->unit, gap, same, number->label);
        char *end = strstr(words, " too ");
        if (end)
            strcpy(end, " error");
        for (end = words + strlen(words); end > words && end[-1] == ' ';)
            *--end = '\0';
        return false;
    }
    const bool turned = value < 0 && number->opposite;
    const double size = fabs(value);
    snprintf(digits, NUMBER_DIGITS_MAX, size < NUMBER_MOST ? "%.*f" : "%.*E",
             size >= 99.95 || (size == round(size) && number->part == SUMMARY_CRACK) ? 0
             : size >= 9.995                                                         ? 1
                                                                                     : 2,
             turned ? size : value);
    snprintf(words, NUMBER_WORDS_MAX, "%s%s%s", number->unit, gap, turned ? number->opposite : number->label);
    return true;
}

/* One run's number, its words below the digits. */
static void draw_number(const Screen *screen, Area area, Size size, char run)
{
    char digits[NUMBER_DIGITS_MAX], words[NUMBER_WORDS_MAX];
    const bool known = screen_number(screen, digits, words);
    const Style style = !known ? STYLE_FAINT : run == 'B' ? STYLE_SECOND : STYLE_CHANGED;
    while ((glyphs_columns(digits) * (WIDE + GAP) - GAP) * size.columns > area.rect.width - 2 &&
           size.columns > 1)
        size.columns--;
    int x = 2;
    const char *text = digits;
    for (uint32_t glyph; (glyph = glyph_next(&text)) != 0; x += (WIDE + GAP) * size.columns) {
        unsigned rows = 0;
        for (size_t i = 0; i < sizeof letters / sizeof *letters; i++)
            if (letters[i].glyph == glyph)
                rows = letters[i].rows;
        for (int y = 0; y < digit_rows(size); y++)
            for (int i = 0; i < WIDE * size.columns; i++) {
                const int column = i / size.columns;
                const bool upper = is_set(rows, column, size.halves ? 2 * y : y / size.rows);
                const bool lower = size.halves ? is_set(rows, column, 2 * y + 1) : upper;
                if (upper || lower)
                    area_put(area, x + i, y,
                             upper && lower ? FULL_BLOCK
                             : upper        ? UPPER_HALF
                                            : LOWER_HALF,
                             style);
            }
    }
    area = area_part(area, 2, area.rect.height - 1, area.rect.width - 2, 1);
    const int name = run ? area_print(area, 0, 0, style, "%c: ", run) : 0;
    const char *last = words; /* of two runs the last words say most: "A: late" */
    while (name + glyphs_columns(last) > area.rect.width && strchr(last, ' '))
        last = strchr(last, ' ') + 1;
    area_text(area, name, 0, last, known ? STYLE_HEADING : STYLE_FAINT);
}

void pane_number(const Screen *screen, Area area)
{
    const Size size = size_of(screen, area.canvas->width, area.canvas->height);
    const int rows = digit_rows(size) + 1, half = area.rect.width / 2;
    area = area_part(area, 0, area.rect.height - rows, area.rect.width, rows);
    if (!screen_is_shared(screen)) {
        draw_number(screen, area, size, '\0');
        return;
    }
    for (int i = 0; i < 2; i++) {
        const Screen one = screen_of_side(screen, i ? SIDE_B : SIDE_A);
        draw_number(&one, area_part(area, i * half, 0, half, rows), size, i ? 'B' : 'A');
    }
}
