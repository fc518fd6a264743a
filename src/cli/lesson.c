/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib lesson NAME --key` and `--handout FILE.pdf`: a lesson's exercises for the teacher, and on paper. */
#include "cli/cli.h"
#include "cli/options.h"
#include "cli/progress.h"

#include "figure/leaflet.h"
#include "tui/control/session/grading.h"
#include "view/help/commands.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SECONDS 3600.0 /* that the right answer of an exercise may take */

static bool load(const char *name, const char *student, Lesson *lesson, Status *status)
{
    if (!lesson_load(name, command_line_for_lessons, lesson, status))
        return false;
    if (lesson_draw(lesson, student, status))
        return true;
    lesson_free(lesson);
    return false;
}

/* --- the key ---------------------------------------------------------------------------------------- */

static void print_variants(const Lesson *lesson)
{
    for (int i = 0; i < lesson->n_variants; i++) {
        const LessonVariant *variant = &lesson->variants[i];
        bool told = false;
        for (int k = 0; k < i; k++)
            told |= strcmp(lesson->variants[k].variant.key, variant->variant.key) == 0 &&
                    strcmp(lesson->variants[k].value, variant->value) == 0;
        if (!told)
            printf("  %s = %s\n", variant->variant.key, variant->value);
    }
}

static void print_solution(const LessonPage *page, const char *reached)
{
    printf("   goal: %s\n   one way: ", page->exercise->expression.text);
    for (int i = 0; i < page->solution.n_actions; i++)
        printf("%s%s", i > 0 ? "; " : "", page->solution.actions[i]);
    printf("   (%s)\n", reached);
}

static void print_answer(const Lesson *lesson, const Grade *grade)
{
    const LessonPage *page = &lesson->pages[grade->page];
    printf("%d %s\n", grade->page + 1, page->title);
    if (page->question)
        printf("   %s\n", page->question);
    switch (lesson_exercise(page)) {
    case EXERCISE_NUMBER:
        printf("   %s within %g%s   (%s)\n", grade->mark.right_answer, page->exercise->tolerance,
               page->exercise->relative ? " %" : "", page->exercise->expression.text);
        break;
    case EXERCISE_GOAL:
        print_solution(page, grade->mark.value);
        break;
    case EXERCISE_WORDS:
        printf("   to be read by the teacher\n");
        break;
    default:
        printf("   %s\n", grade->mark.right_answer);
    }
}

static bool go_on(double share, void *progress)
{
    return progress_show(share, progress);
}

static int print_key(const char *name, const char *student, long threads, Status *status)
{
    Lesson lesson;
    Progress progress;
    if (!load(name, student, &lesson, status))
        return (int)status->code;
    progress_begin(&progress, false);
    const GradingTask task = {.lesson = name,
                              .threads = progress_threads(threads),
                              .seconds = SECONDS,
                              .patience = {go_on, &progress}};
    Grades *grades = malloc(sizeof *grades);
    const bool sound = grades ? grading_key(&task, student, grades, status)
                              : status_fail(status, STATUS_FAILED, "out of memory");
    progress_end(&progress);
    if (sound) {
        printf("%s%s%s\n", lesson.title, *student ? "   for " : "", student);
        print_variants(&lesson);
        for (int i = 0; i < grades->count; i++)
            print_answer(&lesson, &grades->grades[i]);
    }
    free(grades);
    lesson_free(&lesson);
    if (progress_signal())
        return 128 + progress_signal();
    return sound ? STATUS_DONE : (int)status->code;
}

/* --- the handout ------------------------------------------------------------------------------------ */

static void write_paragraphs(Leaflet *leaflet, const char *text)
{
    while (text && *text) {
        const size_t length = strcspn(text, "\n");
        leaflet_line(leaflet, LEAFLET_TEXT, "%.*s", (int)length, text);
        text += length + (text[length] == '\n');
    }
}

static void write_exercise(Leaflet *leaflet, const LessonPage *page)
{
    if (page->question)
        leaflet_line(leaflet, LEAFLET_HEADING, "%s", page->question);
    switch (lesson_exercise(page)) {
    case EXERCISE_CHOICE:
        for (int i = 0; i < page->n_choices; i++)
            leaflet_line(leaflet, LEAFLET_TEXT, "%d   %s", i + 1, page->choices[i]);
        break;
    case EXERCISE_NUMBER:
        leaflet_lines(leaflet, 1);
        break;
    case EXERCISE_WORDS:
        leaflet_lines(leaflet, 4);
        break;
    case EXERCISE_GOAL:
        leaflet_line(leaflet, LEAFLET_SMALL, "What the run has to fulfil: %s",
                     page->exercise->expression.text);
        leaflet_lines(leaflet, 1);
        break;
    case EXERCISE_NONE:
        break;
    }
}

static void write_lesson(Leaflet *leaflet, const Lesson *lesson, const char *student)
{
    leaflet_line(leaflet, LEAFLET_TITLE, "%s", lesson->title);
    if (lesson->about)
        leaflet_line(leaflet, LEAFLET_TEXT, "%s", lesson->about);
    if (*student)
        leaflet_line(leaflet, LEAFLET_TEXT, "Name: %s", student);
    else
        leaflet_lines(leaflet, 1);
    for (int i = 0; i < lesson->n_pages; i++) {
        const LessonPage *page = &lesson->pages[i];
        leaflet_line(leaflet, LEAFLET_HEADING, "%d   %s", i + 1, page->title);
        write_paragraphs(leaflet, page->first.text);
        write_exercise(leaflet, page);
    }
}

static int write_handout(const Options *options, const char *student, Status *status)
{
    Lesson lesson;
    Leaflet leaflet = {.paper = NULL};
    if (!leaflet_allowed(options->handout, options->force, status) ||
        !load(options->words[0], student, &lesson, status))
        return (int)status->code;
    bool sound =
        leaflet_open(&leaflet, ASKER_COMMAND_LINE, options->handout, options->force, lesson.title, status);
    if (sound) {
        write_lesson(&leaflet, &lesson, student);
        sound = leaflet_finish(&leaflet, status);
    }
    leaflet_close(&leaflet);
    lesson_free(&lesson);
    if (sound)
        printf("wrote %s\n", options->handout);
    return sound ? STATUS_DONE : (int)status->code;
}

int cli_lesson_papers(const Options *options, const char *student, Status *status)
{
    if (options->n_words == 0) {
        status_fail(status, STATUS_USAGE, "%s: which lesson? (matvib lesson NAME %s)",
                    options->key ? "--key" : "--handout", options->key ? "--key" : "--handout FILE.pdf");
        return (int)status->code;
    }
    int result = STATUS_DONE;
    if (options->handout)
        result = write_handout(options, student, status);
    if (result == STATUS_DONE && options->key)
        result = print_key(options->words[0], student, options->threads, status);
    return result;
}
