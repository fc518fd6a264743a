/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A lesson: a page of text in place of the parameters, with the question it asks, the parameters it offers,
 * and in the last row what is to be done to go on. */
#include "panes/panes.h"
#include "lessons/lesson_shown.h"

#include <stdio.h>
#include <string.h>

/* Writes down the pane from a row on, which may lie above it. */
typedef struct Scribe {
    Area area;
    int y;
    int end;     /* of what is written: the row after it, without a gap */
    int gap;     /* rows between paragraphs */
    bool about;  /* of the list: each lesson has its sentence below it, not the chosen one alone */
    bool tall;   /* of the list: there is room for the objective of the chosen lesson */
    int *titles; /* of the list, LESSONS_MAX: the row of each lesson; NULL: nobody asks */
} Scribe;

static void write_paragraphs(Scribe *pen, const char *text, Style style)
{
    const int width = pen->area.rect.width - 2;
    while (text && *text) {
        char paragraph[1024];
        const size_t length = strcspn(text, "\n");
        snprintf(paragraph, sizeof paragraph, "%.*s", (int)length, text);
        const int lines = area_paragraph_lines(width, paragraph);
        area_paragraph(pen->area, 1, pen->y, width, lines, paragraph, style);
        pen->end = pen->y + lines;
        pen->y = pen->end + pen->gap;
        text += length + (text[length] == '\n');
    }
}

static void write_indented(Scribe *pen, const char *text)
{
    const int width = pen->area.rect.width - 5, lines = area_paragraph_lines(width, text);
    area_paragraph(pen->area, 4, pen->y, width, lines, text, STYLE_FAINT);
    pen->y += lines;
}

/* In groups, each under its name; of the chosen lesson its objective too. */
static void write_list(Scribe *pen, const Screen *screen)
{
    const char *group = "";
    for (int i = 0; i < LESSONS_MAX && builtin_lessons[i].name; i++) {
        const BuiltinLesson *lesson = &builtin_lessons[i];
        if (lesson->group && strcmp(group, lesson->group) != 0)
            area_text(pen->area, 1, pen->y++, group = lesson->group, STYLE_HEADING);
        if (pen->titles)
            pen->titles[i] = pen->y;
        const bool chosen = i == screen->lesson->chosen;
        const Style style = chosen ? STYLE_SELECTED : STYLE_NORMAL;
        const int width = pen->area.rect.width;
        char pages[24] = "";
        if (chosen)
            area_blank(pen->area, 1, width - 1, pen->y, style);
        if (screen->lesson->reached[i] > 0)
            snprintf(pages, sizeof pages, "%d/%d", screen->lesson->reached[i], lesson->n_pages);
        else if (chosen && lesson->minutes)
            snprintf(pages, sizeof pages, "%.8s min", lesson->minutes);
        area_print(pen->area, 1, pen->y, chosen ? style : STYLE_KEY, "%2d", i + 1);
        const int most = width - 5 - (*pages ? 1 + glyphs_columns(pages) : 0);
        area_text(area_part(pen->area, 4, pen->y, most, 1), 0, 0, lesson->title, style);
        area_text_right(pen->area, width - 1, pen->y++, pages, chosen ? style : STYLE_FAINT);
        if (lesson->about && (chosen || pen->about))
            write_indented(pen, lesson->about);
        if (chosen && pen->tall) {
            /* "After it a student can choose a mass matrix. 15 min. First: late." */
            char text[512] = "";
            if (lesson->objective)
                text_append(text, sizeof text, "After it a student can %s. ", lesson->objective);
            if (lesson->minutes)
                text_append(text, sizeof text, "%s min. ", lesson->minutes);
            if (lesson->prerequisites)
                text_append(text, sizeof text, "First: %s.", lesson->prerequisites);
            if (*text)
                write_indented(pen, text);
        }
        pen->end = pen->y;
    }
}

static void write_all(Scribe *pen, const Screen *screen)
{
    if (screen->lesson->lesson) {
        const LessonPage *page = &screen->lesson->lesson->pages[screen->lesson->page];
        write_paragraphs(pen, page->title, STYLE_HEADING);
        write_paragraphs(pen, page->first.text, STYLE_NORMAL);
        if (page->question) {
            const bool chooses = page->n_choices > 0;
            const int answer = screen->lesson->answer, width = pen->area.rect.width - 2;
            write_paragraphs(pen, page->question, STYLE_HEADING);
            if (answer < 0 && chooses)
                pen->y -= pen->gap; /* the choices stand close to it */
            for (int i = 0; i < page->n_choices && answer < 0; i++) {
                const int lines = area_paragraph_lines(width - 3, page->choices[i]);
                const bool marked = i == screen->lesson->marked;
                for (int y = 0; y < lines && marked; y++)
                    area_blank(pen->area, 1, width + 1, pen->y + y, STYLE_SELECTED);
                area_print(pen->area, 2, pen->y, marked ? STYLE_SELECTED : STYLE_KEY, "%d", i + 1);
                area_paragraph(pen->area, 4, pen->y, width - 3, lines, page->choices[i],
                               marked ? STYLE_SELECTED : STYLE_NORMAL);
                pen->end = pen->y += lines;
            }
            if (answer >= 0 && chooses) {
                char text[512];
                if (answer == page->right)
                    snprintf(text, sizeof text, "Right: %.400s.", page->choices[answer]);
                else
                    snprintf(text, sizeof text, "You said: %.200s. It is: %.200s.", page->choices[answer],
                             page->choices[page->right]);
                write_paragraphs(pen, text, answer == page->right ? STYLE_CHANGED : STYLE_WARNING);
            }
        }
        write_paragraphs(pen, screen->lesson->verdict,
                         screen->lesson->verdict_right ? STYLE_CHANGED : STYLE_WARNING);
        if (page->question ? screen->lesson->answer >= 0 : screen->lesson->met)
            write_paragraphs(pen, page->revealed.text, STYLE_NORMAL);
        ParameterRow row = {.parameter = NULL};
        if (page->n_fields > 0)
            screen_chosen_row(screen, &row);
        for (int i = 0; i < page->n_fields; i++) {
            const Parameter *parameter = parameter_find(page->fields[i]);
            pane_parameter(screen, pen->area, pen->y++, parameter, row.parameter == parameter);
            pen->end = pen->y;
        }
    } else
        write_list(pen, screen);
}

void pane_lesson_footer(const Screen *screen, char *out, size_t size)
{
    const LessonShown *shown = screen->lesson;
    const LessonPage *page = shown->lesson ? &shown->lesson->pages[shown->page] : NULL;
    if (!page) {
        snprintf(out, size, "1-%d, Enter   T closes", screen_lesson_count());
        return;
    }
    const LessonUntil *until = &page->until;
    const Command *command = until->kind == UNTIL_COMMAND ? command_by_name(until->word) : NULL;
    const Parameter *parameter = until->kind == UNTIL_VALUE ? parameter_find(until->word) : NULL;
    char key[COMMAND_KEY_MAX] = "";
    if (command)
        command_first_key(command, key);
    if (page->question && page->n_choices == 0 && shown->answer < 0)
        snprintf(out, size, "Enter: your %s   n goes on",
                 lesson_exercise(page) == EXERCISE_WORDS ? "words" : "answer");
    else if (page->question && shown->answer < 0 && shown->counts)
        snprintf(out, size, "1 %s %d: your first answer counts", page->n_choices == 2 ? "or" : "to",
                 page->n_choices);
    else if (page->question && shown->answer < 0)
        snprintf(out, size, "1 %s %d, or ↑ ↓ Enter: your answer", page->n_choices == 2 ? "or" : "to",
                 page->n_choices);
    else if (until->kind != UNTIL_NOTHING && !shown->met)
        switch (until->kind) {
        case UNTIL_STEP:
            snprintf(out, size, "] to the end of step %.0f", until->number);
            break;
        case UNTIL_TIME:
            snprintf(out, size, "Space runs to %s", screen_time_text(screen, until->number).text);
            break;
        case UNTIL_EVENT:
            snprintf(out, size, "Space runs to a%s %s", strchr("aeiou", until->word[0]) ? "n" : "",
                     until->word);
            break;
        case UNTIL_STAGE:
            snprintf(out, size, "] to stage %.0f", until->number);
            break;
        case UNTIL_COMMAND:
            snprintf(out, size, "press %s", key);
            break;
        case UNTIL_VALUE:
            snprintf(out, size, "set %s to %s", parameter ? parameter->label : until->word, until->value);
            break;
        default:
            snprintf(out, size, "Space runs to the end");
        }
    else if (shown->page + 1 == shown->lesson->n_pages)
        snprintf(out, size, "the end   n next lesson   T closes");
    else if (page->n_fields > 0 && until->kind == UNTIL_NOTHING)
        snprintf(out, size, "n goes on   b back");
    else
        snprintf(out, size, "%sEnter goes on   b back", until->kind != UNTIL_NOTHING ? "done   " : "");
}

/* Heading and footer; and from how many rows on the list has the objective of the chosen lesson. */
enum { MARGIN_ROWS = 2, TALL_ROWS = 30 };

static int lines_of(const Screen *screen, Area area, int gap)
{
    Scribe pen = {.area = area_part(area, 0, 0, area.rect.width, 0), .gap = gap};
    write_all(&pen, screen);
    return pen.end;
}

/* Where the lessons of the list stand, with all sentences if there is room for them: a line each, and in the
 * end that behind the last. True: with all. */
static bool list_lines(const Screen *screen, Area area, int titles[LESSONS_MAX + 1])
{
    const int count = screen_lesson_count(), rows = area.rect.height - MARGIN_ROWS;
    bool about = true;
    for (int turn = 0; turn < 2; turn++, about = false) {
        Scribe pen = {.area = area_part(area, 0, 0, area.rect.width, 0),
                      .about = about,
                      .tall = area.rect.height >= TALL_ROWS,
                      .titles = titles};
        write_list(&pen, screen);
        titles[count] = pen.end;
        if (pen.end <= rows)
            break;
    }
    return about;
}

/* Lines above what is shown: of the list, as many as the chosen one needs to be seen, its sentence too. */
static int lines_above(const Screen *screen, Area area)
{
    int titles[LESSONS_MAX + 1];
    if (screen->lesson->lesson)
        return screen->lesson->scroll;
    list_lines(screen, area, titles);
    const int to_chosen = titles[screen->lesson->chosen + 1], rows = area.rect.height - MARGIN_ROWS;
    return to_chosen > rows ? to_chosen - rows : 0;
}

int pane_lesson_at(const Screen *screen, Area area, int row)
{
    int titles[LESSONS_MAX + 1];
    const int line = row - 1 + lines_above(screen, area), count = screen_lesson_count();
    list_lines(screen, area, titles);
    for (int i = 0; i < count; i++)
        if (line == titles[i])
            return i;
    return -1;
}

void pane_lesson(const Screen *screen, Area area)
{
    const int rows = area.rect.height - MARGIN_ROWS, above = lines_above(screen, area);
    int titles[LESSONS_MAX + 1];
    char footer[192];
    /* "── A title  1/7 ──": of a long title the end gives way, not the page. */
    const LessonShown *shown = screen->lesson;
    const Style style = screen->panes.focus == PANE_PARAMETERS ? STYLE_FOCUS : STYLE_HEADING;
    char heading[160] = "Lessons", page[32] = "";
    if (shown->lesson) {
        snprintf(page, sizeof page, "  %d/%d", shown->page + 1, shown->lesson->n_pages);
        snprintf(heading, sizeof heading, "%.120s%s", shown->lesson->title, page);
    }
    area_rule(area, heading, style);
    if (shown->lesson && 4 + glyphs_columns(heading) > area.rect.width) {
        area_rule(area_part(area, 0, 0, area.rect.width - glyphs_columns(page), 1), shown->lesson->title,
                  style);
        area_text_right(area, area.rect.width, 0, page, style);
    }
    Scribe pen = {.area = area_part(area, 0, 1, area.rect.width, rows),
                  .y = -above,
                  .tall = area.rect.height >= TALL_ROWS,
                  .gap = lines_of(screen, area, 1) <= rows};
    pen.about = !screen->lesson->lesson && list_lines(screen, area, titles);
    write_all(&pen, screen);
    pane_lesson_footer(screen, footer, sizeof footer);
    const int used = area_text(area, 1, area.rect.height - 1, footer, STYLE_KEY) + 2;
    if (pen.end > rows) {
        /* What is below the last row: of the list so many lessons. */
        const int end = area.rect.width - 1;
        char more[3][32] = {"↓ more below", "↓ more", "↓"};
        if (!screen->lesson->lesson) {
            int below = 0;
            for (int i = 0; i < screen_lesson_count(); i++)
                below += titles[i] - above >= rows;
            snprintf(more[0], sizeof more[0], "↓ %d more lessons", below);
            snprintf(more[1], sizeof more[1], "↓ %d more", below);
        }
        for (size_t i = 0; i < sizeof more / sizeof *more; i++)
            if (used + glyphs_columns(more[i]) < end) {
                area_text_right(area, end, area.rect.height - 1, more[i], STYLE_FAINT);
                break;
            }
    }
}

int pane_lesson_rows(const Screen *screen, int width, int most)
{
    Canvas none = {.width = width};
    const Area area = {&none, {0, 0, width, 0}, screen->look.glyphs};
    const int rows = lines_of(screen, area, 1) + MARGIN_ROWS;
    return rows <= most ? rows : lines_of(screen, area, 0) + MARGIN_ROWS;
}

int screen_lesson_count(void)
{
    int count = 0;
    while (count < LESSONS_MAX && builtin_lessons[count].name)
        count++;
    return count;
}
