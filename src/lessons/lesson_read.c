/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads and checks a lesson (lesson.h): lines, commands by the table of keywords, then what a page must
 * and must not have. Every error names file and line. Nothing is executed here; the laboratory plays the
 * pages. */
#include "lessons/lesson.h"

#include "base/hash.h"
#include "base/input.h"
#include "base/text.h"
#include "base/visible.h"
#include "run/stop.h"
#include "scenario/parameters.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ACTIONS_MAX = 32, TEXT_BYTES_MAX = 4096, LINE_BYTES_MAX = 4096 };

/* Where reading stands. */
typedef struct Reader {
    Lesson *lesson;
    LessonPage *page; /* NULL: before the first */
    LessonPart *part; /* of the page that is being read */
    bool paragraph;   /* the next line of text goes on with the last */
    bool opened;      /* up to the page's question a scenario has been opened, */
    bool opens;       /* or is behind it */
    LessonJudge may_do;
    Status *status;
} Reader;

static bool no_memory(Status *status)
{
    return status_fail(status, "not enough memory for a lesson");
}

static bool keep(Reader *reader, char **where, const char *text)
{
    free(*where);
    *where = strdup(text);
    return *where || no_memory(reader->status);
}

/* A word whose line is read by one expression. */
#define READS(name, value)                                                                                   \
    static bool name(Reader *reader, const char *text)                                                       \
    {                                                                                                        \
        return value;                                                                                        \
    }

/* --- lines ------------------------------------------------------------------------------------------ */

READS(read_title, keep(reader, &reader->lesson->title, text))
READS(read_about, keep(reader, &reader->lesson->about, text))
READS(read_group, keep(reader, &reader->lesson->group, text))
READS(read_objective, keep(reader, &reader->lesson->objective, text))
READS(read_prerequisites, keep(reader, &reader->lesson->prerequisites, text))

static bool read_minutes(Reader *reader, const char *text)
{
    enum { MINUTES_MOST = 600 };
    double minutes;
    if (!text_to_double(text, &minutes) || !(minutes >= 1 && minutes <= MINUTES_MOST) ||
        floor(minutes) != minutes)
        return status_refuse(reader->status, "@minutes %.40s: not a whole number from 1 to %d", text,
                             MINUTES_MOST);
    return keep(reader, &reader->lesson->minutes, text);
}

/* What must and must not stand on one page. */
static bool judge_page(const Reader *reader, const LessonPage *page, Status *status)
{
    const ExerciseKind exercise = page->exercise ? page->exercise->kind : EXERCISE_NONE;
    const bool asks = exercise == EXERCISE_NUMBER || exercise == EXERCISE_WORDS;
    const bool reveals = reader->part == &page->revealed;
    if (page->question && exercise == EXERCISE_GOAL)
        return status_refuse(status, "page \"%.40s\" asks (@ask) and has a @goal (one of them)", page->title);
    if (page->question && !asks && (page->n_choices < 2 || page->right < 0))
        return status_refuse(
            status,
            "the question of page \"%.40s\" needs two choices at least, one of them @right, or "
            "@answer or @words",
            page->title);
    if (page->question && asks && page->n_choices > 0)
        return status_refuse(status, "the question of page \"%.40s\" has choices and @%s (one of them)",
                             page->title, exercise == EXERCISE_NUMBER ? "answer" : "words");
    if (exercise == EXERCISE_GOAL && page->solution.n_actions == 0)
        return status_refuse(status, "the goal of page \"%.40s\" needs a way to it (@solve LINE)",
                             page->title);
    if (exercise != EXERCISE_GOAL && page->solution.n_actions > 0)
        return status_refuse(status, "page \"%.40s\" has @solve without @goal", page->title);
    if (page->points > 0 && lesson_exercise(page) == EXERCISE_NONE)
        return status_refuse(status, "page \"%.40s\" has points (@points), but no exercise", page->title);
    if (!page->question && reveals && page->until.kind == UNTIL_NOTHING)
        return status_refuse(
            status, "page \"%.40s\" reveals, but neither asks (@ask) nor waits for anything (@until)",
            page->title);
    if (!page->question && page->revealed.n_actions > 0)
        return status_refuse(status,
                             "page \"%.40s\" does something after its goal: only an "
                             "answer is followed by @do",
                             page->title);
    /* Whichever word a student has drawn, one choice is right. */
    const LessonVariant *drawn =
        *page->if_key ? lesson_variant(reader->lesson, page->if_key, reader->lesson->n_pages) : NULL;
    for (int i = 0; drawn && i < drawn->variant.n_words; i++) {
        int right = 0;
        for (int k = 0; k < page->n_choices; k++)
            right += page->if_words[k] && text_has_word(page->if_words[k], drawn->variant.words[i]);
        if (right != 1)
            return status_refuse(status, "page \"%.40s\" has %d right choices for %s = %s (one is expected)",
                                 page->title, right, page->if_key, drawn->variant.words[i]);
    }
    return !drawn || drawn->variant.n_words > 0 ||
           status_refuse(status, "page \"%.40s\": %s has no words to be asked for", page->title,
                         page->if_key);
}

const char *lesson_opening(const char *line)
{
    static const char *const words[] = {"open ", "full "};
    for (size_t i = 0; i < sizeof words / sizeof *words; i++) {
        const char *name = line + strlen(words[i]);
        if (strncmp(line, words[i], strlen(words[i])) == 0 && name[strspn(name, " ")])
            return name + strspn(name, " ");
    }
    return NULL;
}

static bool end_page(Reader *reader)
{
    const LessonPage *page = reader->page;
    if (!page)
        return true;
    const ExerciseKind kind = lesson_exercise(page);
    const bool of_run = kind == EXERCISE_NUMBER || kind == EXERCISE_GOAL;
    if (of_run && !reader->opened)
        return status_refuse(
            reader->status, "page \"%.40s\" asks about a run that no page up to it opens (@do open SCENARIO)",
            page->title);
    reader->opened |= reader->opens;
    return judge_page(reader, page, reader->status);
}

static bool read_page(Reader *reader, const char *text)
{
    Lesson *lesson = reader->lesson;
    if (!end_page(reader))
        return false;
    if (lesson->n_pages == LESSON_PAGES_MAX)
        return status_refuse(reader->status, "too many pages (at most %d)", LESSON_PAGES_MAX);
    LessonPage *pages = realloc(lesson->pages, (size_t)(lesson->n_pages + 1) * sizeof *pages);
    if (!pages)
        return no_memory(reader->status);
    lesson->pages = pages;
    reader->page = &pages[lesson->n_pages++];
    *reader->page = (LessonPage){.right = -1};
    reader->part = &reader->page->first;
    return keep(reader, &reader->page->title, text);
}

static bool add_action(Reader *reader, LessonPart *part, const char *word, const char *text)
{
    if (!reader->may_do(text, reader->status))
        return status_prefix(reader->status, "%s", word);
    if (part->n_actions == ACTIONS_MAX)
        return status_refuse(reader->status, "too many things to do (at most %d)", ACTIONS_MAX);
    char **actions = realloc(part->actions, (size_t)(part->n_actions + 1) * sizeof *actions);
    if (!actions)
        return no_memory(reader->status);
    part->actions = actions;
    actions[part->n_actions] = NULL;
    return keep(reader, &actions[part->n_actions++], text);
}

static bool read_do(Reader *reader, const char *text)
{
    bool *opens = reader->part == &reader->page->first ? &reader->opened : &reader->opens;
    *opens |= lesson_opening(text) != NULL;
    return add_action(reader, reader->part, "@do", text);
}

READS(read_solve, add_action(reader, &reader->page->solution, "@solve", text))

/* Until it is known who reads, the parameter stays as it is. */
static bool read_variant(Reader *reader, const char *text)
{
    Lesson *lesson = reader->lesson;
    LessonPart *part = reader->part;
    char line[KEY_MAX + 8];
    if (part != &reader->page->first)
        return status_refuse(reader->status, "@variant belongs before @reveal");
    if (lesson->n_variants == LESSON_VARIANTS_MAX)
        return status_refuse(reader->status, "too many variants (at most %d)", LESSON_VARIANTS_MAX);
    LessonVariant *variant = &lesson->variants[lesson->n_variants];
    *variant = (LessonVariant){.page = lesson->n_pages - 1, .action = part->n_actions};
    if (!variant_read(text, &variant->variant, reader->status))
        return status_prefix(reader->status, "@variant");
    lesson->n_variants++;
    snprintf(line, sizeof line, "set %s 1", variant->variant.key);
    return add_action(reader, part, "@variant", line);
}

static bool new_exercise(Reader *reader, bool (*read)(const char *, Exercise *, Status *), const char *word,
                         const char *text)
{
    LessonPage *page = reader->page;
    if (page->exercise)
        return status_refuse(reader->status, "a page has one exercise only");
    page->exercise = calloc(1, sizeof *page->exercise);
    if (!page->exercise)
        return no_memory(reader->status);
    if (!read)
        page->exercise->kind = EXERCISE_WORDS;
    return !read || read(text, page->exercise, reader->status) || status_prefix(reader->status, "@%s", word);
}

static bool has_asked(const Reader *reader)
{
    return reader->page->question ||
           status_refuse(reader->status, "an answer comes after its question (@ask)");
}

READS(read_answer, has_asked(reader) && new_exercise(reader, exercise_read_answer, "answer", text))
READS(read_words, has_asked(reader) && new_exercise(reader, NULL, "words", text))

static bool read_goal(Reader *reader, const char *text)
{
    if (reader->page->until.kind != UNTIL_NOTHING)
        return status_refuse(reader->status, "a page has one goal (@until or @goal)");
    reader->page->until = (LessonUntil){.kind = UNTIL_GOAL};
    return new_exercise(reader, exercise_read_goal, "goal", text);
}

static bool read_points(Reader *reader, const char *text)
{
    enum { POINTS_MOST = 1000 };
    double *points = &reader->page->points;
    if (*points > 0)
        return status_refuse(reader->status, "a page has its points once");
    return (text_to_double(text, points) && *points > 0 && *points <= POINTS_MOST) ||
           status_refuse(reader->status, "@points %.40s: not a number above 0, up to %d", text, POINTS_MOST);
}

static bool read_field(Reader *reader, const char *text)
{
    LessonPage *page = reader->page;
    if (!parameter_find(text))
        return status_refuse(reader->status, "%.40s is not a parameter (see: matvib params)", text);
    if (page->n_fields == LESSON_FIELDS_MAX)
        return status_refuse(reader->status, "too many fields (at most %d)", LESSON_FIELDS_MAX);
    snprintf(page->fields[page->n_fields++], KEY_MAX, "%.*s", KEY_MAX - 1, text);
    return true;
}

static bool read_ask(Reader *reader, const char *text)
{
    if (reader->page->question)
        return status_refuse(reader->status, "a page asks one question only");
    return keep(reader, &reader->page->question, text);
}

static bool read_choice(Reader *reader, const char *text)
{
    LessonPage *page = reader->page;
    if (!page->question)
        return status_refuse(reader->status, "a choice comes after its question (@ask)");
    if (page->n_choices == LESSON_CHOICES_MAX)
        return status_refuse(reader->status, "too many choices (at most %d)", LESSON_CHOICES_MAX);
    return keep(reader, &page->choices[page->n_choices++], text);
}

/* A choice that is right for those only who have drawn some words. */
static bool read_right_if(Reader *reader, const char *text, const char *key, size_t length, const char *words)
{
    LessonPage *page = reader->page;
    char *choice = strndup(text, length);
    const bool sound = choice && read_choice(reader, choice);
    free(choice);
    if (!choice)
        return no_memory(reader->status);
    if (!sound)
        return false;
    if (!lesson_variant(reader->lesson, key, reader->lesson->n_pages))
        return status_refuse(reader->status, "if %s: there is no @variant of it above", key);
    if (*page->if_key && strcmp(page->if_key, key) != 0)
        return status_refuse(reader->status, "if %s: the other choices ask for %s", key, page->if_key);
    strcpy(page->if_key, key);
    if (page->right < 0)
        page->right = page->n_choices - 1;
    return keep(reader, &page->if_words[page->n_choices - 1], words);
}

/* "TEXT", or "TEXT if KEY is WORD, WORD". */
static bool read_right(Reader *reader, const char *text)
{
    LessonPage *page = reader->page;
    char key[KEY_MAX];
    int words = 0;
    const char *condition = strstr(text, " if ");
    while (condition &&
           !(sscanf(condition, " if %39s is %n", key, &words) == 1 && words > 0 && parameter_find(key))) {
        words = 0;
        condition = strstr(condition + 1, " if ");
    }
    if (page->right >= 0 && !(condition && *page->if_key))
        return status_refuse(reader->status, "one choice only is right");
    if (condition)
        return read_right_if(reader, text, key, (size_t)(condition - text), condition + words);
    page->right = page->n_choices;
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
    if (reader->page->until.kind == UNTIL_GOAL)
        return status_refuse(reader->status, "a page has one goal (@until or @goal)");
    static const struct {
        const char *word;
        UntilKind kind;
        int words; /* behind it */
    } kinds[] = {{"step", UNTIL_STEP, 1}, {"time", UNTIL_TIME, 1},       {"stage", UNTIL_STAGE, 1},
                 {"end", UNTIL_END, 0},   {"command", UNTIL_COMMAND, 1}, {"value", UNTIL_VALUE, 2}};
    if (text_place_in(text, stop_event_words) >= 0) {
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
    return status_refuse(
        reader->status,
        "until what? (step N | time T | stage N | end | crossing | break | touch | event | rest | "
        "command NAME | value KEY VALUE)");
}

static const struct {
    const char *word;
    bool (*read)(Reader *, const char *text);
    bool of_page;
    bool wants_text;
} words[] = {
    {"title", read_title, false, true},
    {"about", read_about, false, true},
    {"group", read_group, false, true},
    {"objective", read_objective, false, true},
    {"prerequisites", read_prerequisites, false, true},
    {"minutes", read_minutes, false, true},
    {"page", read_page, false, true},
    {"do", read_do, true, true},
    {"field", read_field, true, true},
    {"ask", read_ask, true, true},
    {"choice", read_choice, true, true},
    {"right", read_right, true, true},
    {"reveal", read_reveal, true, false},
    {"until", read_until, true, true},
    {"variant", read_variant, true, true},
    {"answer", read_answer, true, true},
    {"words", read_words, true, false},
    {"goal", read_goal, true, true},
    {"solve", read_solve, true, true},
    {"points", read_points, true, true},
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
            return status_refuse(reader->status, "@%s belongs to a page (@page TITLE)", words[i].word);
        if (!words[i].of_page && reader->page && words[i].read != read_page)
            return status_refuse(reader->status, "@%s belongs before the first page", words[i].word);
        if (words[i].wants_text != (*text != '\0'))
            return status_refuse(reader->status, "@%s: %s", words[i].word,
                                 *text ? "takes nothing" : "something is missing after it");
        return words[i].read(reader, text);
    }
    char known[240] = "";
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        text_append(known, sizeof known, "%s@%s", i ? " | " : "", words[i].word);
    return status_refuse(reader->status, "@%.*s is not known (%s)", length < 20 ? (int)length : 20, line,
                         known);
}

static bool read_text(Reader *reader, const char *line)
{
    if (!*line) {
        reader->paragraph = false;
        return true;
    }
    if (!reader->page)
        return status_refuse(reader->status, "text belongs to a page (@page TITLE)");
    if (reader->page->question && reader->part == &reader->page->first)
        return status_refuse(reader->status,
                             "a question is one line (text comes before @ask, or after @reveal)");
    char **text = &reader->part->text, *longer;
    const char *between = !*text ? "" : reader->paragraph ? " " : "\n";
    if (asprintf(&longer, "%s%s%s", *text ? *text : "", between, line) < 0)
        return no_memory(reader->status);
    free(*text);
    *text = longer;
    reader->paragraph = true;
    return strlen(longer) <= TEXT_BYTES_MAX ||
           status_refuse(reader->status, "too much text for a page (at most %d bytes)", TEXT_BYTES_MAX);
}

static bool read_line(Reader *reader, char *line)
{
    for (size_t length = strlen(line); length > 0 && strchr(" \t\r\n", line[length - 1]);)
        line[--length] = '\0';
    if (!visible_is_clean(line))
        return status_refuse(reader->status, "is not text in UTF-8");
    Lesson *lesson = reader->lesson;
    /* what a list says of a lesson does not change what was read and recorded */
    static const char *const listed[] = {"@group ", "@objective ", "@prerequisites ", "@minutes "};
    for (size_t i = 0; i < sizeof listed / sizeof *listed; i++)
        if (strncmp(line, listed[i], strlen(listed[i])) == 0)
            return read_word(reader, line + 1);
    if (*line == '#')
        return true;
    lesson->version = hash_bytes(hash_bytes(lesson->version, line, strlen(line)), "\n", 1);
    if (!lesson_knows_braces(lesson, line, reader->status))
        return false;
    return *line == '@' ? read_word(reader, line + 1) : read_text(reader, line);
}

bool lesson_read(FILE *stream, const char *name, LessonJudge may_do, Lesson *lesson, Status *status)
{
    Reader reader = {.lesson = lesson, .may_do = may_do, .status = status};
    InputLines lines = {.stream = stream, .name = name};
    char line[LINE_BYTES_MAX + 1];
    bool sound = true;
    InputGot got;
    *lesson = (Lesson){.version = HASH_BEGIN};
    while (sound && (got = input_line(&lines, line, sizeof line, status)) != INPUT_END)
        if (got == INPUT_WRONG)
            sound = false;
        else if (!(sound = read_line(&reader, line)))
            status_prefix(status, "%s:%ld", name, lines.number);
    if (sound && (!lesson->title || lesson->n_pages == 0))
        sound = status_refuse(status, "%s: is not a lesson (@title and a @page are expected)", name);
    else if (sound && !end_page(&reader)) {
        status_prefix(status, "%s", name);
        sound = false;
    }
    if (!sound)
        lesson_free(lesson);
    return sound;
}

ExerciseKind lesson_exercise(const LessonPage *page)
{
    return page->exercise ? page->exercise->kind : page->question ? EXERCISE_CHOICE : EXERCISE_NONE;
}

double lesson_points(const LessonPage *page)
{
    return lesson_exercise(page) == EXERCISE_NONE ? 0 : page->points > 0 ? page->points : 1;
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
        for (int k = 0; k < page->n_choices; k++)
            free(page->if_words[k]);
        free_part(&page->first);
        free_part(&page->revealed);
        free_part(&page->solution);
        free(page->exercise);
    }
    free(lesson->pages);
    free(lesson->title);
    free(lesson->about);
    free(lesson->group);
    free(lesson->objective);
    free(lesson->prerequisites);
    free(lesson->minutes);
    *lesson = (Lesson){0};
}
