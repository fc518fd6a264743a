/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers of pages and of screens (lesson_numbers.h). */
#include "lab/lesson_numbers.h"

#include "panes/panes.h"
#include "panes/screen.h"
#include "suite.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NUMBER_BYTES = 32, WIDTH = 80, HEIGHT = 24 };

/* The next number of a text without its sign, and behind it; NULL: there is none. A digit behind a letter is
 * part of a name (T2, c1). */
static const char *next_number(const char *text, char number[NUMBER_BYTES])
{
    const char *begin = text;
    for (; *text; text++) {
        const bool named = text > begin && (isalpha((unsigned char)text[-1]) || text[-1] == '_' ||
                                            text[-1] == '^' || text[-1] == '.');
        if (!isdigit((unsigned char)*text) && !(*text == '.' && isdigit((unsigned char)text[1])))
            continue;
        size_t length = strspn(text, "0123456789");
        if (text[length] == '.' && isdigit((unsigned char)text[length + 1]))
            length += 1 + strspn(text + length + 1, "0123456789");
        if (text[length] == 'e' && (isdigit((unsigned char)text[length + 1]) ||
                                    (text[length + 1] == '-' && isdigit((unsigned char)text[length + 2]))))
            length += 2 + strspn(text + length + 2, "0123456789");
        if (!named && length < NUMBER_BYTES) {
            snprintf(number, NUMBER_BYTES, "%.*s", (int)length, text);
            return text + length;
        }
        text += length - 1;
    }
    return NULL;
}

/* What stands in large digits, of each run that is shown. */
static void see_large(const Screen *screen, SeenNumbers *seen)
{
    char digits[NUMBER_DIGITS_MAX], words[NUMBER_WORDS_MAX];
    if (layout_make(screen, WIDTH, HEIGHT).number.width == 0)
        return;
    for (int side = 0; side < (screen_is_shared(screen) ? 2 : 1) && seen->count < SEEN_MAX; side++) {
        const Screen one = side ? screen_of_side(screen, SIDE_B) : *screen;
        if (screen_number(&one, digits, words))
            seen->values[seen->count++] = strtod(digits, NULL);
    }
}

void lesson_numbers_see(Bench *bench, SeenNumbers *seen)
{
    char number[NUMBER_BYTES];
    ck_assert(laboratory_draw(&bench->lab, &bench->canvas, WIDTH, HEIGHT));
    const Rect page = screen_pane(&bench->lab.screen, WIDTH, HEIGHT, PANE_PARAMETERS);
    const Area text = {&bench->canvas, page, bench->lab.screen.look.glyphs};
    for (int i = 0; i < page.width * page.height; i++)
        area_put(text, i % page.width, i / page.width, ' ', STYLE_NORMAL);
    char *dump = canvas_dump(&bench->canvas);
    ck_assert_ptr_nonnull(dump);
    for (const char *at = dump; (at = next_number(at, number)) && seen->count < SEEN_MAX;)
        seen->values[seen->count++] = strtod(number, NULL);
    free(dump);
    see_large(&bench->lab.screen, seen);
}

/* As many decimals as the text has are enough: 4 % of -4.23. */
static bool is_seen(const SeenNumbers *seen, const char *number)
{
    const char *point = strchr(number, '.'), *power = strchr(number, 'e');
    const double value = strtod(number, NULL);
    const double last = power ? 0.005 * value : point ? pow(10, -(double)strspn(point + 1, "0123456789")) : 1;
    for (int i = 0; i < seen->count; i++)
        if (fabs(seen->values[i] - value) <= 0.5 * last * (1 + 1e-9))
            return true;
    return false;
}

/* "LESSON PAGE NUMBER REASON". */
static bool has_reason(const char *lesson, int page, const char *number)
{
    const char *folder = getenv("MATVIB_SRCDIR");
    char name[1024], line[256], wanted[128];
    snprintf(name, sizeof name, "%s/tests/lab/lesson-numbers", folder ? folder : ".");
    const int length = snprintf(wanted, sizeof wanted, "%s %d %s ", lesson, page, number);
    FILE *list = fopen(name, "r");
    bool found = false;
    ck_assert_msg(list != NULL, "%s", name);
    while (!found && fgets(line, sizeof line, list))
        found = strncmp(line, wanted, (size_t)length) == 0 && line[length] > ' ';
    fclose(list);
    return found;
}

static void check_text(const char *text, const char *lesson, int page, const SeenNumbers *seen)
{
    char number[NUMBER_BYTES];
    while (text && (text = next_number(text, number))) {
        const bool shown = is_seen(seen, number), told = has_reason(lesson, page, number);
        if (getenv("MATVIB_TELL") && !shown && !told)
            printf("# %s %d %s ?\n", lesson, page, number);
        ck_assert_msg(
            getenv("MATVIB_TELL") || shown || told,
            "%s, page %d: %s is not on its screen (80x24), and has no reason in tests/lab/lesson-numbers",
            lesson, page, number);
        if (getenv("MATVIB_TELL") && shown && told)
            printf("# %s %d %s is seen\n", lesson, page, number);
        ck_assert_msg(getenv("MATVIB_TELL") || !shown || !told,
                      "%s, page %d: %s is on its screen: tests/lab/lesson-numbers need not tell why not",
                      lesson, page, number);
    }
}

void lesson_numbers_check(Bench *bench, const char *lesson, const SeenNumbers *seen)
{
    const LessonShown *shown = bench->lab.screen.lesson;
    const LessonPage *page = &shown->lesson->pages[shown->page];
    const char *const texts[] = {page->first.text, page->question, page->revealed.text,
                                 page->right >= 0 && page->n_choices > 0 ? page->choices[page->right] : NULL};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        check_text(texts[i], lesson, shown->page + 1, seen);
}
