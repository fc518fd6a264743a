/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib lesson NAME --handout FILE.pdf`: a lesson's exercises on paper; `--print`: its text. */
#include "cli/cli.h"
#include "cli/options.h"
#include "cli/common.h"

#include "picture/paper/leaflet.h"
#include "lessons/lesson.h"
#include "help/command.h"

#include <stdio.h>
#include <string.h>

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
    char goal[2 * EXPRESSION_MAX];
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
        exercise_tell_goal(page->exercise, NULL, goal, sizeof goal);
        leaflet_line(leaflet, LEAFLET_SMALL, "What the run has to fulfil: %s", goal);
        leaflet_lines(leaflet, 1);
        break;
    case EXERCISE_NONE:
        break;
    }
}

int cli_lesson_handout(const Options *options, const char *student, Status *status)
{
    if (options->n_words == 0)
        return progress_result(
            status_refuse(status, "--handout: which lesson? (matvib lesson NAME --handout FILE.pdf)"),
            status);
    Lesson lesson;
    Leaflet leaflet = {.paper = NULL};
    if (!leaflet_allowed(options->handout, ASKER_COMMAND_LINE, options->force, status) ||
        !lesson_load_for(options->words[0], student, command_line_for_lessons, &lesson, status))
        return (int)status->code;
    bool sound =
        leaflet_open(&leaflet, ASKER_COMMAND_LINE, options->handout, options->force, lesson.title, status);
    if (sound) {
        leaflet_line(&leaflet, LEAFLET_TITLE, "%s", lesson.title);
        if (lesson.about)
            leaflet_line(&leaflet, LEAFLET_TEXT, "%s", lesson.about);
        if (*student)
            leaflet_line(&leaflet, LEAFLET_TEXT, "Name: %s", student);
        else
            leaflet_lines(&leaflet, 1);
        for (int i = 0; i < lesson.n_pages; i++) {
            const LessonPage *page = &lesson.pages[i];
            leaflet_line(&leaflet, LEAFLET_HEADING, "%d   %s", i + 1, page->title);
            write_paragraphs(&leaflet, page->first.text);
            write_exercise(&leaflet, page);
        }
        sound = leaflet_finish(&leaflet, status);
    }
    leaflet_close(&leaflet);
    lesson_free(&lesson);
    if (sound)
        printf("wrote %s\n", options->handout);
    return progress_result(sound, status);
}

int cli_lesson_print(const char *name, Status *status)
{
    const BuiltinLesson *builtin = name ? lesson_builtin(name) : NULL;
    if (!name)
        status_refuse(status, "--print: which lesson? (matvib lesson NAME --print)");
    else if (!builtin)
        status_refuse(status, "--print: %.60s: is no lesson of the program (matvib lesson --list)", name);
    else
        fputs(builtin->text, stdout);
    return progress_result(builtin != NULL, status);
}
