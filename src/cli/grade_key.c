/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib grade --key LESSON`: the right answers of a lesson's exercises, for the teacher. */
#include "cli/cli.h"
#include "cli/options.h"
#include "cli/progress.h"

#include "lab/session/grading.h"
#include "help/command.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SECONDS 3600.0 /* that the right answer of an exercise may take */

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
        printf("   goal: %s\n   one way: ", page->exercise->expression.text);
        for (int i = 0; i < page->solution.n_actions; i++)
            printf("%s%s", i > 0 ? "; " : "", page->solution.actions[i]);
        printf("   (%s)\n", grade->mark.value);
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

/* What is about sessions and their tables. */
static bool is_for_key(const Options *options, Status *status)
{
    const struct {
        bool given;
        const char *name;
    } others[] = {{options->limit, "--limit"},   {options->output, "--output"}, {options->moodle, "--moodle"},
                  {options->roster, "--roster"}, {options->sheet, "--sheet"},   {options->bom, "--bom"}};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (others[i].given)
            return status_refuse(status, "%s: does not go with --key", others[i].name);
    return true;
}

int cli_grade_key(const Options *options, Status *status)
{
    const char *name = options->words[0];
    char student[STUDENT_MAX] = "";
    Lesson lesson;
    Progress progress;
    if (!is_for_key(options, status) || !options_words(options, 1, 1, "LESSON", status) ||
        (options->name && !variant_student(options->name, student, status) &&
         !status_prefix(status, "--name")) ||
        !lesson_load_for(name, student, command_line_for_lessons, &lesson, status))
        return (int)status->code;
    progress_begin(&progress, options->quiet);
    const GradingTask task = {.lesson = name,
                              .threads = progress_threads(options->threads),
                              .seconds = SECONDS,
                              .cancel = {go_on, &progress}};
    Grades *grades = malloc(sizeof *grades);
    const bool sound =
        grades ? grading_key(&task, student, grades, status) : status_fail(status, "out of memory");
    progress_end(&progress);
    if (sound) {
        printf("%s%s%s\n", lesson.title, *student ? "   for " : "", student);
        for (int i = 0; i < lesson.n_variants; i++) {
            const LessonVariant *variant = &lesson.variants[i];
            bool told = false;
            for (int k = 0; k < i; k++)
                told |= strcmp(lesson.variants[k].variant.key, variant->variant.key) == 0 &&
                        strcmp(lesson.variants[k].value, variant->value) == 0;
            if (!told)
                printf("  %s = %s\n", variant->variant.key, variant_word(variant->value));
        }
        for (int i = 0; i < grades->count; i++)
            print_answer(&lesson, &grades->grades[i]);
    }
    free(grades);
    lesson_free(&lesson);
    return progress_result(sound && !progress_signal(), status);
}
