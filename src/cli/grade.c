/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib grade LESSON SESSION...`: sessions of homework are done again and marked, a row for each exercise
 * and, in another table, for each student. */
#include "cli/cli.h"
#include "cli/options.h"
#include "cli/students.h"

#include "base/output.h"
#include "base/text.h"
#include "base/visible.h"
#include "picture/paper/leaflet.h"
#include "export/export.h"
#include "lab/session/grading.h"
#include "help/command.h"
#include "base/input.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* The list of a class, as a course or a spreadsheet exports it. */

enum { ROSTER_BYTES_MAX = 10000000, LINE_BYTES = 4096, CELLS_MAX = 64 };

typedef enum Role { ROLE_NAME, ROLE_FIRST, ROLE_LAST, ROLE_ID, ROLE_ADDRESS, ROLES } Role;

/* What a column is called, the better words first. */
static const char *const role_heads[ROLES][5] = {{"Full name", "Name"},
                                                 {"First name", "Given name"},
                                                 {"Surname", "Last name", "Family name"},
                                                 {"ID number", "ID", "Email address", "Username"},
                                                 {"Email address"}};

typedef struct Roster {
    InputLines lines;
    char text[LINE_BYTES];
    char *cells[CELLS_MAX];
    int count;
    char separator;
    int at[ROLES]; /* columns; -1: none */
} Roster;

/* The cells of the next line that has any. */
static InputGot read_row(Roster *roster, Status *status)
{
    InputGot got;
    do
        got = input_line(&roster->lines, roster->text, sizeof roster->text, status);
    while (got == INPUT_LINE && (!roster->text[strspn(roster->text, " \t,;")] ||
                                 (roster->lines.number == 1 && text_tells_separator(roster->text))));
    if (got != INPUT_LINE)
        return got;
    if (!roster->separator)
        roster->separator = strchr(roster->text, ';') ? ';' : strchr(roster->text, '\t') ? '\t' : ',';
    const char *end = roster->text + strlen(roster->text);
    roster->count = 0;
    for (char *cell = roster->text; cell && cell < end && roster->count < CELLS_MAX;) {
        roster->cells[roster->count++] = cell;
        /* The cell without its quotes, in place; NULL behind it where a quote is not closed. */
        char *to = cell, *at = cell;
        bool quoted = *at == '"';
        for (at += quoted; *at && (quoted || *at != roster->separator); at++) {
            if (quoted && *at == '"' && at[1] != '"') {
                quoted = false;
                continue;
            }
            at += quoted && *at == '"';
            *to++ = *at;
        }
        char *next = *at ? at + 1 : at;
        *to = '\0';
        cell = quoted ? NULL : next;
        if (!cell) {
            status_refuse(status, "%s:%ld: a quote is not closed", roster->lines.name, roster->lines.number);
            return INPUT_WRONG;
        }
    }
    return INPUT_LINE;
}

static const char *cell_of(const Roster *roster, Role role)
{
    const int at = roster->at[role];
    return at >= 0 && at < roster->count ? roster->cells[at] : "";
}

static bool read_head(Roster *roster, Status *status)
{
    const InputGot got = read_row(roster, status);
    for (Role role = 0; role < ROLES; role++) {
        int *at = &roster->at[role];
        *at = -1;
        for (int word = 0; got == INPUT_LINE && role_heads[role][word]; word++)
            for (int i = 0; i < roster->count && *at < 0; i++)
                *at = strcasecmp(roster->cells[i], role_heads[role][word]) == 0 ? i : -1;
    }
    return got != INPUT_WRONG &&
           (roster->at[ROLE_NAME] >= 0 || (roster->at[ROLE_FIRST] >= 0 && roster->at[ROLE_LAST] >= 0) ||
            status_refuse(
                status,
                "%s:1: no column of names in the head (Full name, or First name and Surname; ID number "
                "where there is one)",
                roster->lines.name));
}

/* Reads names, ID numbers and addresses from a table with a head ("Full name", or "First name" and "Surname";
 * "ID number" or "Email address" where there is one), its cells separated by commas, semicolons or tabs.
 * False: "FILE:LINE: what is wrong (what is allowed)". */
static bool roster_read(const char *file, Students *students, Status *status)
{
    FILE *stream = input_open(file, ROSTER_BYTES_MAX, status);
    if (!stream)
        return false;
    Roster roster = {.lines = {.stream = stream, .name = file}};
    InputGot got = INPUT_LINE;
    bool sound = read_head(&roster, status);
    while (sound && (got = read_row(&roster, status)) == INPUT_LINE) {
        char whole[LINE_BYTES], name[STUDENT_MAX], id[STUDENT_MAX] = "", address[STUDENT_MAX] = "";
        snprintf(whole, sizeof whole, "%s %s %s", cell_of(&roster, ROLE_NAME),
                 roster.at[ROLE_NAME] < 0 ? cell_of(&roster, ROLE_FIRST) : "",
                 roster.at[ROLE_NAME] < 0 ? cell_of(&roster, ROLE_LAST) : "");
        sound = (variant_student(whole, name, status) &&
                 (!*cell_of(&roster, ROLE_ID) || variant_student(cell_of(&roster, ROLE_ID), id, status)) &&
                 (!*cell_of(&roster, ROLE_ADDRESS) ||
                  variant_student(cell_of(&roster, ROLE_ADDRESS), address, status)) &&
                 students_enrol(students, name, *id ? id : address, address, status)) ||
                status_prefix(status, "%s:%ld", roster.lines.name, roster.lines.number);
    }
    fclose(stream);
    return sound && got != INPUT_WRONG;
}

#define SECONDS 300.0 /* that a session may take to be done again */

enum { NAME_SHOWN_MAX = 1024 };

/* What goes through all sessions. */
typedef struct Marking {
    GradingTask task;
    Lesson lesson;
    Progress progress;
    int session, sessions;
    FILE *table;
    Dialect dialect;
    Leaflet *sheets; /* NULL: none are asked for */
    Students students;
    int refused; /* sessions without marks */
} Marking;

static bool go_on(double share, void *context)
{
    Marking *marking = context;
    return progress_show((marking->session + share) / marking->sessions, &marking->progress);
}

/* --- the table -------------------------------------------------------------------------------------- */

static const char *const columns[] = {"name",  "exercise", "value",   "right_answer", "mark",
                                      "tries", "time",     "session", "remark"};
enum { NAME, EXERCISE, VALUE, RIGHT_ANSWER, MARK, TRIES, TIME, SESSION, REMARK, CELLS };

/* What was not tried is not right; what the teacher reads has no mark as yet. */
static const char *mark_text(const Lesson *lesson, const Grade *grade)
{
    const bool is_words = lesson_exercise(&lesson->pages[grade->page]) == EXERCISE_WORDS;
    if (is_words || (grade->mark.tries > 0 && !grade->mark.judged))
        return "";
    return grade->mark.right ? "1" : "0";
}

static void write_rows(const Marking *marking, const char *file, const Grades *grades)
{
    const char *cells[CELLS] = {grades->student, "", "", "", "", "", "", file, grades->remark};
    if (grades->count == 0)
        csv_words(marking->table, marking->dialect, cells, CELLS);
    for (int i = 0; i < grades->count; i++) {
        const Grade *grade = &grades->grades[i];
        char name[ANSWER_MAX], tries[NUMBER_TEXT_MAX], seconds[NUMBER_TEXT_MAX] = "";
        snprintf(name, sizeof name, "%d %s", grade->page + 1, marking->lesson.pages[grade->page].title);
        snprintf(tries, sizeof tries, "%d", grade->mark.tries);
        if (grade->mark.tries > 0)
            snprintf(seconds, sizeof seconds, "%.0f", grade->seconds);
        cells[EXERCISE] = name;
        cells[VALUE] = grade->mark.value;
        cells[RIGHT_ANSWER] = grade->mark.right_answer;
        cells[MARK] = mark_text(&marking->lesson, grade);
        cells[TRIES] = tries;
        cells[TIME] = seconds;
        csv_words(marking->table, marking->dialect, cells, CELLS);
    }
}

/* --- sessions that are one ------------------------------------------------------------------------- */

/* Another session of the same lines, or of the same keys; it may stand before or behind. */
static void tell_twin(const Marking *marking, const Options *options, const GradingOrigin *origins, int own,
                      Grades *grades)
{
    int twin = -1;
    for (int i = 0; i < marking->sessions; i++) {
        const bool same = i != own && origins[i].known && origins[own].known;
        if (same && origins[i].check == origins[own].check)
            twin = i;
        else if (same && origins[i].keys == origins[own].keys && twin < 0)
            twin = i;
    }
    if (twin < 0 || grades->count == 0)
        return;
    char file[NAME_SHOWN_MAX];
    visible_text(file, sizeof file, options->words[twin + 1]);
    text_append(grades->remark, sizeof grades->remark, "%s%s %.100s", *grades->remark ? "; " : "",
                origins[twin].check == origins[own].check ? "the same recording as" : "the same keys as",
                file);
}

/* --- a page for each student ------------------------------------------------------------------------ */

static void write_sheet(const Marking *marking, const char *file, const Grades *grades)
{
    Leaflet *sheet = marking->sheets;
    int right = 0, marked = 0;
    leaflet_page(sheet);
    leaflet_line(sheet, LEAFLET_TITLE, "%s", *grades->student ? grades->student : file);
    leaflet_line(sheet, LEAFLET_SMALL, "%s   %s", marking->lesson.title, file);
    if (*grades->remark)
        leaflet_line(sheet, LEAFLET_TEXT, grades->count > 0 ? "Remark: %s." : "No marks: %s.",
                     grades->remark);
    for (int i = 0; i < grades->count; i++) {
        const Grade *grade = &grades->grades[i];
        const ExerciseMark *mark = &grade->mark;
        const char *text = mark_text(&marking->lesson, grade);
        marked += *text != '\0';
        right += *text == '1';
        leaflet_line(sheet, LEAFLET_HEADING, "%d %s   %s", grade->page + 1,
                     marking->lesson.pages[grade->page].title,
                     *text == '1'   ? "right"
                     : *text == '0' ? "not right"
                                    : "");
        leaflet_line(sheet, LEAFLET_TEXT, "%s", mark->tries > 0 ? mark->value : "no answer");
        if (*mark->right_answer && *text == '0')
            leaflet_line(sheet, LEAFLET_SMALL, "wanted: %s", mark->right_answer);
        if (mark->tries > 1)
            leaflet_line(sheet, LEAFLET_SMALL, "%d tries", mark->tries);
    }
    if (grades->count > 0)
        leaflet_line(sheet, LEAFLET_HEADING, "%d of %d right", right, marked);
}

/* --- all -------------------------------------------------------------------------------------------- */

static bool mark_all(Marking *marking, const Options *options, Status *status)
{
    Grades *grades = malloc(sizeof *grades);
    GradingOrigin *origins = calloc((size_t)marking->sessions, sizeof *origins);
    bool sound = (grades && origins) || status_fail(status, "out of memory");
    for (int i = 0; i < marking->sessions && sound; i++)
        grading_origin(&marking->lesson, options->words[i + 1], &origins[i]);
    csv_header(marking->table, marking->dialect, columns, CELLS);
    for (int i = 1; i < options->n_words && sound; i++) {
        marking->session = i - 1;
        sound = grading_session(&marking->task, options->words[i], grades, status);
        if (!sound)
            break;
        tell_twin(marking, options, origins, i - 1, grades);
        char file[NAME_SHOWN_MAX]; /* the table goes to a terminal too */
        visible_text(file, sizeof file, options->words[i]);
        marking->refused += grades->count == 0;
        write_rows(marking, file, grades);
        sound = students_add(&marking->students, &marking->lesson, grades, status);
        if (marking->sheets)
            write_sheet(marking, file, grades);
    }
    if (sound) {
        /* Of the list of the class, who handed in nothing. */
        const char *name;
        for (int at = 0; (name = students_missing(&marking->students, &at));)
            csv_words(marking->table, marking->dialect,
                      (const char *[CELLS]){name, "", "", "", "", "", "", "", "missing"}, CELLS);
    }
    free(grades);
    free(origins);
    return sound;
}

/* Two tables and the pages: all are there at the end, or none. */
static bool write_all(Marking *marking, const Options *options, Status *status)
{
    OutputFile file, moodle = {.stream = NULL};
    Leaflet sheets = {.paper = NULL};
    const char *name = options->output ? options->output : "-";
    if (!output_open(&file, ASKER_COMMAND_LINE, name, options->force, status))
        return false;
    marking->table = file.stream;
    marking->sheets = options->sheet ? &sheets : NULL;
    const char *mark = options->bom ? "\xef\xbb\xbf" : "";
    fputs(mark, file.stream);
    bool sound = (!options->moodle ||
                  output_open(&moodle, ASKER_COMMAND_LINE, options->moodle, options->force, status)) &&
                 (!options->sheet || leaflet_open(&sheets, ASKER_COMMAND_LINE, options->sheet, options->force,
                                                  marking->lesson.title, status)) &&
                 mark_all(marking, options, status);
    if (sound && options->moodle) {
        fputs(mark, moodle.stream);
        students_write(&marking->students, &marking->lesson, moodle.stream, marking->dialect);
    }
    sound = sound && output_finish(&file, status) && (!options->moodle || output_finish(&moodle, status)) &&
            (!options->sheet || leaflet_finish(&sheets, status)) && output_commit(&file, status) &&
            (!options->moodle || output_commit(&moodle, status));
    leaflet_close(&sheets);
    output_close(&file);
    output_close(&moodle);
    students_free(&marking->students);
    return sound;
}

/* `matvib grade --key LESSON`: the right answers of a lesson's exercises, for the teacher. */

#define KEY_SECONDS 3600.0 /* that the right answer of an exercise may take */

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

/* What `grade --key` prints. */
static int grade_key(const Options *options, Status *status)
{
    const char *name = options->words[0];
    char student[STUDENT_MAX] = "";
    Lesson lesson;
    Progress progress;
    /* what is about sessions and their tables */
    const char *other = options->limit > 0 ? "--limit"
                        : options->output  ? "--output"
                        : options->moodle  ? "--moodle"
                        : options->roster  ? "--roster"
                        : options->sheet   ? "--sheet"
                        : options->bom     ? "--bom"
                                           : NULL;
    if ((other && !status_refuse(status, "%s: does not go with --key", other)) ||
        !options_words(options, 1, 1, "LESSON", status) ||
        (options->name && !variant_student(options->name, student, status) &&
         !status_prefix(status, "--name")) ||
        !lesson_load_for(name, student, command_line_for_lessons, &lesson, status))
        return (int)status->code;
    progress_begin(&progress, options->quiet);
    const GradingTask task = {.lesson = name,
                              .threads = progress_threads(options->threads),
                              .seconds = KEY_SECONDS,
                              .cancel = {progress_show, &progress}};
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

int cli_grade(Options *options, Status *status)
{
    Marking marking = {.refused = 0};
    OutputNames names = {.asker = ASKER_COMMAND_LINE, .force = options->force};
    if (options->key)
        return grade_key(options, status);
    if ((options->name && !status_refuse(status, "--name: goes with --key")) ||
        !options_words(options, 2, WORDS_MAX, "LESSON SESSION...", status) ||
        !output_names_differ(
            &names,
            output_names_take(&names, options->output ? options->output : "-", status) &&
                output_names_take(&names, options->moodle, status) &&
                (!options->sheet || leaflet_allowed(options->sheet, names.asker, names.force, status)) &&
                output_names_take(&names, options->sheet, status),
            status) ||
        !lesson_load(options->words[0], command_line_for_lessons, &marking.lesson, status))
        return (int)status->code;
    if (options->roster && !roster_read(options->roster, &marking.students, status)) {
        lesson_free(&marking.lesson);
        students_free(&marking.students);
        return (int)status->code;
    }
    marking.dialect = options->outputs.dialect;
    marking.sessions = options->n_words - 1;
    progress_begin(&marking.progress, options->quiet);
    marking.task.lesson = options->words[0];
    marking.task.seconds = options->limit > 0 ? options->limit : SECONDS;
    marking.task.threads = progress_threads(options->threads);
    marking.task.cancel = (Cancel){go_on, &marking};
    bool sound = write_all(&marking, options, status);
    progress_end(&marking.progress);
    lesson_free(&marking.lesson);
    sound = sound && !progress_signal();
    if (sound && marking.refused > 0)
        sound = status_fail(status, "%d of %d sessions have no marks (see the remarks)", marking.refused,
                            marking.sessions);
    return progress_result(sound, status);
}
