/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Whose homework it is, and the file that it is kept in (homework.h). */
#include "cli/homework.h"

#include "base/output.h"
#include "base/visible.h"
#include "help/command.h"
#include "lessons/lesson.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { TRIES_MOST = 999, LESSON_WORD_MAX = 128, LINE_MAX_BYTES = 1024 };

/* Exercises beside choices: what somebody hands in. A lesson that cannot be read is told of where it is
 * opened. */
static bool is_homework(const char *name, char *title, size_t size)
{
    Lesson lesson;
    Status ignored = {STATUS_DONE, ""};
    bool found = false;
    if (!lesson_load(name, command_line_for_lessons, &lesson, &ignored))
        return false;
    for (int i = 0; i < lesson.n_pages; i++)
        found |= lesson.pages[i].exercise != NULL;
    snprintf(title, size, "%s", lesson.title);
    lesson_free(&lesson);
    return found;
}

/* A line of the terminal; false: it was left empty, or there are no more. */
static bool ask(const char *question, char out[STUDENT_MAX])
{
    char line[LINE_MAX_BYTES];
    for (;;) {
        Status why = {STATUS_DONE, ""};
        *out = '\0';
        printf("%s ", question);
        fflush(stdout);
        if (!fgets(line, sizeof line, stdin)) {
            clearerr(stdin);
            putchar('\n');
            return false;
        }
        line[strcspn(line, "\r\n")] = '\0';
        if (!line[strspn(line, " \t")])
            return false;
        if (variant_student(line, out, &why))
            return true;
        visible_print(stdout, "%s\n", why.text);
    }
}

static void ask_for_both(const char *title, HomeworkFile *homework)
{
    visible_print(stdout, "%s\n", title);
    visible_print(stdout, "What you do is kept in a file for your teacher.\n");
    if (ask("Your name (Enter alone: only look, nothing is kept):", homework->student))
        ask("Your ID number or address, where you have one (Enter alone: none):", homework->id);
}

static bool exists(const char *file)
{
    return access(file, F_OK) == 0;
}

/* "class/own.lesson" of Ada Lovelace: "own-Ada-Lovelace.session". */
static bool choose_file(const char *lesson, HomeworkFile *homework, Status *status)
{
    const char *slash = strrchr(lesson, '/'), *base = slash ? slash + 1 : lesson;
    const char *dot = strrchr(base, '.');
    char plain[LESSON_WORD_MAX], word[LESSON_WORD_MAX], name[STUDENT_MAX];
    snprintf(plain, sizeof plain, "%.*s", (int)(dot && dot > base ? (size_t)(dot - base) : strlen(base)),
             base);
    variant_file_word(plain, word, sizeof word);
    variant_file_word(homework->student, name, sizeof name);
    for (int attempt = 1; attempt <= TRIES_MOST; attempt++) {
        char number[16] = "";
        if (attempt > 1)
            snprintf(number, sizeof number, "-%d", attempt);
        snprintf(homework->file, sizeof homework->file, "%s%s%s%s.session", word, *word && *name ? "-" : "",
                 name, number);
        if (!exists(homework->file))
            return output_may_begin(homework->file, ASKER_COMMAND_LINE, false, status);
    }
    return status_refuse(status, "%s: exists, and so do all before it", homework->file);
}

bool homework_begin(const Options *options, const char *lesson, HomeworkFile *homework, Status *status)
{
    char title[LINE_MAX_BYTES];
    *homework = (HomeworkFile){.student = ""};
    if (options->name && !variant_student(options->name, homework->student, status))
        return status_prefix(status, "--name");
    if (options->id && !options->name)
        return status_refuse(status, "--id: goes with --name");
    if (options->id && !variant_student(options->id, homework->id, status))
        return status_prefix(status, "--id");
    if (!lesson || options->handout || options->script)
        return true;
    if (!options->name && isatty(STDIN_FILENO) && isatty(STDOUT_FILENO) &&
        is_homework(lesson, title, sizeof title))
        ask_for_both(title, homework);
    return !*homework->student || options->record || choose_file(lesson, homework, status);
}
