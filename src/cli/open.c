/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib [SCENARIO]` and `matvib lesson [NAME]`: the laboratory with the options of the command line. */
#include "base/input.h"
#include "base/threads.h"
#include "cli/cli.h"
#include "lab/session/laboratory_main.h"
#include "scenario/parameters.h"
#include "scenario/settings.h"
#include "cli/options.h"
#include "lessons/variant.h"
#include "base/output.h"
#include "base/visible.h"
#include "help/command.h"
#include "lessons/lesson.h"
#include "picture/paper/leaflet.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

/* Homework by itself: `matvib lesson homework-late` asks who does it, and keeps what is done in a file of the
 * student's own, homework-late-NAME.session in this folder, or -2, -3 ... where that is there already. */

enum { HOMEWORK_FILE_MAX = 512 };

typedef struct HomeworkFile {
    char student[STUDENT_MAX], id[STUDENT_MAX]; /* "": not given */
    char file[HOMEWORK_FILE_MAX];               /* "": nothing is kept */
} HomeworkFile;

enum { TRIES_MOST = 999, LESSON_WORD_MAX = 128, LINE_MAX_BYTES = 1024 };

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
        if (access(homework->file, F_OK) != 0)
            return output_may_begin(homework->file, ASKER_COMMAND_LINE, false, status);
    }
    return status_refuse(status, "%s: exists, and so do all before it", homework->file);
}

/* Reads --name and --id, or asks for them where a lesson that holds exercises is begun at a terminal, and
 * chooses the file, unless --record names one or keys come from a script. `lesson` may be NULL. False: the
 * status says why, and that is before a page is seen. */
static bool homework_begin(const Options *options, const char *lesson, HomeworkFile *homework, Status *status)
{
    *homework = (HomeworkFile){.student = ""};
    if (options->name && !variant_student(options->name, homework->student, status))
        return status_prefix(status, "--name");
    if (options->id && !options->name)
        return status_refuse(status, "--id: goes with --name");
    if (options->id && !variant_student(options->id, homework->id, status))
        return status_prefix(status, "--id");
    if (!lesson || options->handout || options->script)
        return true;
    Lesson opened;
    Status ignored = {STATUS_DONE, ""}; /* a lesson that cannot be read is told of where it is opened */
    if (!options->name && isatty(STDIN_FILENO) && isatty(STDOUT_FILENO) &&
        lesson_load(lesson, command_line_for_lessons, &opened, &ignored)) {
        /* Exercises beside choices: what somebody hands in. */
        bool is_homework = false;
        for (int i = 0; i < opened.n_pages; i++)
            is_homework |= opened.pages[i].exercise != NULL;
        if (is_homework) {
            visible_print(stdout, "%s\n", opened.title);
            visible_print(stdout, "What you do is kept in a file for your teacher.\n");
        }
        if (is_homework && ask("Your name (Enter alone: only look, nothing is kept):", homework->student))
            ask("Your ID number or address, where you have one (Enter alone: none):", homework->id);
        lesson_free(&opened);
    }
    return !*homework->student || options->record || choose_file(lesson, homework, status);
}

/* What cannot go together: standard input has one use, and a session brings its own run. */
static bool go_together(const Options *options, const char *word, Status *status)
{
    const bool again = options->replay || options->last;
    if (again && (options->n_words > 0 || options->n_overrides > 0 || options->steps > 0 || options->paused))
        return status_refuse(status, "%s: a session has its own scenario and parameters",
                             options->last ? "--last" : "--replay");
    if (options->plain && (again || options->script))
        return status_refuse(status, "--plain: lines come from standard input (leave %s out)",
                             again ? "the session" : "--script");
    const bool keys_elsewhere = options->script && strcmp(options->script, input_standard_name) != 0;
    return !word || strcmp(word, input_standard_name) != 0 || keys_elsewhere ||
           status_refuse(status, "-: keys come from standard input (matvib run - reads a scenario there)");
}

/* `lesson`: NULL where none is opened; `named`: what the scenario was called. */
static int enter(const Options *options, const char *named, const char *lesson, const HomeworkFile *homework,
                 Status *status)
{
    Settings settings, coarse;
    Status ignored = {0};
    const char *scenario = named, *form = scenario_on_screen(named);
    if (!options_load(options, named, &settings, status))
        return (int)status->code;
    /* of the coarse form, where the scenario has one for the screen and no option makes both the same by
     * choosing the size itself */
    if (form != named && options_load(options, form, &coarse, &ignored) &&
        !settings_same(&settings, &coarse)) {
        settings = coarse;
        scenario = form;
    }
    const int result = laboratory_main(
        &(LaboratoryOptions){
            .settings = &settings,
            .scenario = scenario,
            .is_coarse = scenario != named,
            .lesson = lesson,
            .student = *homework->student ? homework->student : NULL,
            .student_id = *homework->id ? homework->id : NULL,
            .paused = options->paused || lesson,
            .glyphs = options->glyphs,
            .theme = options->theme,
            .sheet = options->screen_sheet,
            .no_mouse = options->no_mouse,
            .history = options->history,
            .threads = options->threads > 0 ? (int)options->threads : threads_default(!options->script),
            .script = options->script,
            .plain = options->plain,
            .record = *homework->file ? homework->file : options->record,
            .replay = options->replay,
            .last = options->last,
            .fast = options->fast,
            .force = options->force,
            .width = options->size[0],
            .height = options->size[1],
        },
        status);
    if (result != STATUS_DONE && status)
        options_blame(options, scenario, status);
    return result;
}

int cli_open(Options *options, Status *status)
{
    const char *word = options->n_words > 0 ? options->words[0] : NULL;
    const char *scenario = word ? word : scenario_unnamed;
    if (!go_together(options, word, status) || !options_words(options, 0, 1, "[SCENARIO]", status))
        return (int)status->code;
    return enter(options, scenario, NULL, &(HomeworkFile){.file = ""}, status);
}

/* `matvib lesson NAME --handout FILE.pdf`: a lesson's exercises on paper; `--print`: its text. */

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

static int write_handout(const Options *options, const char *student, Status *status)
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
            for (const char *text = page->first.text; text && *text;) {
                const size_t length = strcspn(text, "\n");
                leaflet_line(&leaflet, LEAFLET_TEXT, "%.*s", (int)length, text);
                text += length + (text[length] == '\n');
            }
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

int cli_lesson(Options *options, Status *status)
{
    HomeworkFile homework;
    const char *word = options->n_words > 0 ? options->words[0] : NULL;
    if (options->list)
        return cli_list_lessons();
    if (options->print) {
        const BuiltinLesson *builtin = word ? lesson_builtin(word) : NULL;
        if (!word)
            status_refuse(status, "--print: which lesson? (matvib lesson NAME --print)");
        else if (!builtin)
            status_refuse(status, "--print: %.60s: is not a lesson of the program (matvib lesson --list)",
                          word);
        else
            fputs(builtin->text, stdout);
        return progress_result(builtin != NULL, status);
    }
    if (!homework_begin(options, word, &homework, status))
        return (int)status->code;
    if (options->handout)
        return write_handout(options, homework.student, status);
    if (!go_together(options, NULL, status))
        return (int)status->code;
    const int result =
        enter(options, scenario_unnamed, word ? word : laboratory_all_lessons, &homework, status);
    if (result == STATUS_DONE && *homework.file && access(homework.file, F_OK) == 0)
        printf("Hand in this file: %s\n", homework.file);
    return result;
}
