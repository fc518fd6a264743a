/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads and checks a lesson (lesson.h): lines, commands by the table of keywords, then what a page must
 * and must not have. Every error names file and line. Nothing is executed here; the laboratory plays the
 * pages. */
#include "lab/lessons/lesson.h"

#include "base/input.h"
#include "base/text.h"
#include "base/visible.h"
#include "lab/run/stop.h"
#include "lab/settings/parameters.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { ACTIONS_MAX = 32, TEXT_BYTES_MAX = 4096, LINE_BYTES_MAX = 4096, LESSON_BYTES_MAX = 4000000 };

/* Where reading stands. */
typedef struct Reader {
    Lesson *lesson;
    LessonPage *page; /* NULL: before the first */
    LessonPart *part; /* of the page that is being read */
    bool paragraph;   /* the next line of text goes on with the last */
    LessonJudge may_do;
    Status *status;
} Reader;

static bool no_memory(Status *status)
{
    return status_fail(status, STATUS_FAILED, "not enough memory for a lesson");
}

static bool keep(Reader *reader, char **where, const char *text)
{
    free(*where);
    *where = strdup(text);
    return *where || no_memory(reader->status);
}

/* --- lines ------------------------------------------------------------------------------------------ */

static bool read_title(Reader *reader, const char *text)
{
    return keep(reader, &reader->lesson->title, text);
}

static bool read_about(Reader *reader, const char *text)
{
    return keep(reader, &reader->lesson->about, text);
}

static bool end_page(Reader *reader)
{
    const LessonPage *page = reader->page;
    if (page && page->question && (page->n_choices < 2 || page->right < 0))
        return status_fail(reader->status, STATUS_USAGE,
                           "the question of page \"%.40s\" wants two choices at least, one of them @right",
                           page->title);
    if (page && !page->question && reader->part == &page->revealed && page->until.kind == UNTIL_NOTHING)
        return status_fail(reader->status, STATUS_USAGE,
                           "page \"%.40s\" reveals, but neither asks (@ask) nor waits for anything (@until)",
                           page->title);
    if (page && !page->question && page->revealed.n_actions > 0)
        return status_fail(reader->status, STATUS_USAGE,
                           "page \"%.40s\" does something after its goal: only an "
                           "answer is followed by @do",
                           page->title);
    return true;
}

static bool read_page(Reader *reader, const char *text)
{
    Lesson *lesson = reader->lesson;
    if (!end_page(reader))
        return false;
    if (lesson->n_pages == LESSON_PAGES_MAX)
        return status_fail(reader->status, STATUS_USAGE, "too many pages (at most %d)", LESSON_PAGES_MAX);
    LessonPage *pages = realloc(lesson->pages, (size_t)(lesson->n_pages + 1) * sizeof *pages);
    if (!pages)
        return no_memory(reader->status);
    lesson->pages = pages;
    reader->page = &pages[lesson->n_pages++];
    *reader->page = (LessonPage){.right = -1};
    reader->part = &reader->page->first;
    return keep(reader, &reader->page->title, text);
}

static bool read_do(Reader *reader, const char *text)
{
    LessonPart *part = reader->part;
    if (!reader->may_do(text, reader->status))
        return status_prefix(reader->status, "@do");
    if (part->n_actions == ACTIONS_MAX)
        return status_fail(reader->status, STATUS_USAGE, "too many things to do (at most %d)", ACTIONS_MAX);
    char **actions = realloc(part->actions, (size_t)(part->n_actions + 1) * sizeof *actions);
    if (!actions)
        return no_memory(reader->status);
    part->actions = actions;
    actions[part->n_actions] = NULL;
    return keep(reader, &actions[part->n_actions++], text);
}

static bool read_field(Reader *reader, const char *text)
{
    LessonPage *page = reader->page;
    if (!parameter_find(text))
        return status_fail(reader->status, STATUS_USAGE, "%.40s is no parameter (see: matvib params)", text);
    if (page->n_fields == LESSON_FIELDS_MAX)
        return status_fail(reader->status, STATUS_USAGE, "too many fields (at most %d)", LESSON_FIELDS_MAX);
    snprintf(page->fields[page->n_fields++], KEY_MAX, "%.*s", KEY_MAX - 1, text);
    return true;
}

static bool read_ask(Reader *reader, const char *text)
{
    if (reader->page->question)
        return status_fail(reader->status, STATUS_USAGE, "a page asks one question only");
    return keep(reader, &reader->page->question, text);
}

static bool read_choice(Reader *reader, const char *text)
{
    LessonPage *page = reader->page;
    if (!page->question)
        return status_fail(reader->status, STATUS_USAGE, "a choice comes after its question (@ask)");
    if (page->n_choices == LESSON_CHOICES_MAX)
        return status_fail(reader->status, STATUS_USAGE, "too many choices (at most %d)", LESSON_CHOICES_MAX);
    return keep(reader, &page->choices[page->n_choices++], text);
}

static bool read_right(Reader *reader, const char *text)
{
    if (reader->page->right >= 0)
        return status_fail(reader->status, STATUS_USAGE, "one choice only is right");
    reader->page->right = reader->page->n_choices;
    return read_choice(reader, text);
}

static bool read_reveal(Reader *reader, const char *text)
{
    (void)text;
    reader->part = &reader->page->revealed;
    return true;
}

static bool read_until(Reader *reader, const char *text)
{
    static const struct {
        const char *word;
        UntilKind kind;
        int words; /* behind it */
    } kinds[] = {{"step", UNTIL_STEP, 1}, {"time", UNTIL_TIME, 1},       {"stage", UNTIL_STAGE, 1},
                 {"end", UNTIL_END, 0},   {"command", UNTIL_COMMAND, 1}, {"value", UNTIL_VALUE, 2}};
    for (int i = 0; stop_event_words[i]; i++)
        if (strcmp(text, stop_event_words[i]) == 0) {
            reader->page->until = (LessonUntil){.kind = UNTIL_EVENT};
            strcpy(reader->page->until.word, text);
            return true;
        }
    char word[16] = "", one[KEY_MAX] = "", two[VALUE_MAX] = "", more;
    int count = sscanf(text, "%15s %39s %63s %c", word, one, two, &more) - 1;
    LessonUntil *until = &reader->page->until;
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        if (strcmp(kinds[i].word, word) != 0 || kinds[i].words != count)
            continue;
        *until = (LessonUntil){.kind = kinds[i].kind};
        strcpy(until->word, one);
        strcpy(until->value, two);
        bool number = until->kind <= UNTIL_STAGE;
        if ((!number || (text_to_double(one, &until->number) && until->number >= 0)) &&
            (until->kind != UNTIL_VALUE || parameter_find(one)))
            return true;
    }
    return status_fail(reader->status, STATUS_USAGE,
                       "until what? (step N | time T | stage N | end | crossing | break | event | "
                       "command NAME | value KEY VALUE)");
}

typedef enum Wants { WANTS_NOTHING, WANTS_TEXT } Wants;

static const struct {
    const char *word;
    bool (*read)(Reader *, const char *text);
    bool of_page;
    Wants wants;
} words[] = {
    {"title", read_title, false, WANTS_TEXT},     {"about", read_about, false, WANTS_TEXT},
    {"page", read_page, false, WANTS_TEXT},       {"do", read_do, true, WANTS_TEXT},
    {"field", read_field, true, WANTS_TEXT},      {"ask", read_ask, true, WANTS_TEXT},
    {"choice", read_choice, true, WANTS_TEXT},    {"right", read_right, true, WANTS_TEXT},
    {"reveal", read_reveal, true, WANTS_NOTHING}, {"until", read_until, true, WANTS_TEXT},
};

static bool read_word(Reader *reader, char *line)
{
    size_t length = strcspn(line, " ");
    const char *text = line + length + strspn(line + length, " ");
    reader->paragraph = false;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        if (strlen(words[i].word) != length || strncmp(words[i].word, line, length) != 0)
            continue;
        if (words[i].of_page && !reader->page)
            return status_fail(reader->status, STATUS_USAGE, "@%s belongs to a page (@page TITLE)",
                               words[i].word);
        if (!words[i].of_page && reader->page && words[i].read != read_page)
            return status_fail(reader->status, STATUS_USAGE, "@%s belongs before the first page",
                               words[i].word);
        if ((words[i].wants == WANTS_TEXT) != (*text != '\0'))
            return status_fail(reader->status, STATUS_USAGE, "@%s: %s", words[i].word,
                               *text ? "takes nothing" : "something is missing behind it");
        return words[i].read(reader, text);
    }
    char known[160] = "";
    for (size_t i = 0, used = 0; i < sizeof words / sizeof *words && used < sizeof known; i++)
        used += (size_t)snprintf(known + used, sizeof known - used, "%s@%s", i ? " | " : "", words[i].word);
    return status_fail(reader->status, STATUS_USAGE, "@%.*s is not known (%s)",
                       length < 20 ? (int)length : 20, line, known);
}

static bool read_text(Reader *reader, const char *line)
{
    if (!*line) {
        reader->paragraph = false;
        return true;
    }
    if (!reader->page)
        return status_fail(reader->status, STATUS_USAGE, "text belongs to a page (@page TITLE)");
    if (reader->page->question && reader->part == &reader->page->first)
        return status_fail(reader->status, STATUS_USAGE,
                           "a question is one line (text comes before @ask, or after @reveal)");
    char **text = &reader->part->text, *longer;
    const char *between = !*text ? "" : reader->paragraph ? " " : "\n";
    if (asprintf(&longer, "%s%s%s", *text ? *text : "", between, line) < 0)
        return no_memory(reader->status);
    free(*text);
    *text = longer;
    reader->paragraph = true;
    return strlen(longer) <= TEXT_BYTES_MAX ||
           status_fail(reader->status, STATUS_USAGE, "too much text for a page (at most %d bytes)",
                       TEXT_BYTES_MAX);
}

static bool read_line(Reader *reader, char *line)
{
    for (size_t length = strlen(line); length > 0 && strchr(" \t\r\n", line[length - 1]);)
        line[--length] = '\0';
    if (!visible_is_clean(line))
        return status_fail(reader->status, STATUS_USAGE, "is not text in UTF-8");
    if (*line == '#')
        return true;
    return *line == '@' ? read_word(reader, line + 1) : read_text(reader, line);
}

bool lesson_read(FILE *stream, const char *name, LessonJudge may_do, Lesson *lesson, Status *status)
{
    Reader reader = {.lesson = lesson, .may_do = may_do, .status = status};
    InputLines lines = {.stream = stream, .name = name};
    char line[LINE_BYTES_MAX + 1];
    bool sound = true;
    InputGot got;
    *lesson = (Lesson){0};
    while (sound && (got = input_line(&lines, line, sizeof line, status)) != INPUT_END)
        if (got == INPUT_WRONG)
            sound = false;
        else if (!(sound = read_line(&reader, line)))
            status_prefix(status, "%s:%ld", name, lines.number);
    if (sound && (!lesson->title || lesson->n_pages == 0))
        sound = status_fail(status, STATUS_USAGE, "%s: is no lesson (@title and a @page are wanted)", name);
    else if (sound && !end_page(&reader)) {
        status_prefix(status, "%s", name);
        sound = false;
    }
    if (!sound)
        lesson_free(lesson);
    return sound;
}

const BuiltinLesson *lesson_builtin(const char *name)
{
    for (const BuiltinLesson *builtin = builtin_lessons; builtin->name; builtin++)
        if (strcmp(builtin->name, name) == 0)
            return builtin;
    return NULL;
}

static bool unknown(const char *name, Status *status)
{
    enum { MOST = 60 };
    const char *names[MOST + 1] = {NULL};
    int count = 0;
    for (const BuiltinLesson *builtin = builtin_lessons; builtin->name && count < MOST; builtin++)
        names[count++] = builtin->name;
    const char *nearest = parameter_nearest_word(names, name);
    if (!nearest)
        return status_fail(status, STATUS_USAGE, "%s: no such lesson or file (see: matvib lesson --list)",
                           name);
    return status_fail(status, STATUS_USAGE, "%s: no such lesson or file (did you mean %s?)", name, nearest);
}

bool lesson_load(const char *name, LessonJudge may_do, Lesson *lesson, Status *status)
{
    const BuiltinLesson *builtin = lesson_builtin(name);
    *lesson = (Lesson){0};
    FILE *stream =
        builtin ? input_text(builtin->text, name, status) : input_open(name, LESSON_BYTES_MAX, status);
    if (!stream)
        return !builtin && errno == ENOENT && unknown(name, status);
    bool sound = lesson_read(stream, name, may_do, lesson, status);
    fclose(stream);
    return sound;
}

static void free_part(LessonPart *part)
{
    free(part->text);
    for (int i = 0; i < part->n_actions; i++)
        free(part->actions[i]);
    free(part->actions);
}

void lesson_free(Lesson *lesson)
{
    for (int i = 0; i < lesson->n_pages; i++) {
        LessonPage *page = &lesson->pages[i];
        free(page->title);
        free(page->question);
        for (int k = 0; k < page->n_choices; k++)
            free(page->choices[k]);
        free_part(&page->first);
        free_part(&page->revealed);
    }
    free(lesson->pages);
    free(lesson->title);
    free(lesson->about);
    *lesson = (Lesson){0};
}
