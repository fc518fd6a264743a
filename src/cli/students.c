/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sums of marks for each student (students.h). */
#include "cli/students.h"

#include "base/text.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

struct Student {
    char name[STUDENT_MAX], id[STUDENT_MAX], address[STUDENT_MAX], remark[GRADING_REMARK_MAX];
    bool listed;  /* in the list of the class */
    int came;     /* sessions, */
    int sessions; /* and those that are marked */
    /* of each page, whether a session has it so */
    bool right[LESSON_PAGES_MAX], wrong[LESSON_PAGES_MAX], unread[LESSON_PAGES_MAX];
};

static Student *find(const Students *students, const char *name, const char *id)
{
    for (int i = 0; i < students->count; i++) {
        Student *student = &students->list[i];
        const bool same_name = strcmp(student->name, name) == 0, have_ids = *student->id && *id;
        const bool same_id = strcasecmp(student->id, id) == 0 || strcasecmp(student->address, id) == 0;
        if (have_ids ? same_id && (same_name || student->listed) : same_name)
            return student;
    }
    return NULL;
}

static Student *add(Students *students, const char *name, const char *id, Status *status)
{
    Student *list = realloc(students->list, (size_t)(students->count + 1) * sizeof *list);
    if (!list) {
        status_fail(status, "out of memory");
        return NULL;
    }
    students->list = list;
    Student *student = &list[students->count++];
    *student = (Student){.sessions = 0};
    snprintf(student->name, sizeof student->name, "%s", name);
    snprintf(student->id, sizeof student->id, "%s", id);
    return student;
}

bool students_enrol(Students *students, const char *name, const char *id, const char *address, Status *status)
{
    if (find(students, name, id))
        return status_refuse(status, "%s: listed twice (give each an ID number)", name);
    Student *student = add(students, name, id, status);
    students->listed = true;
    if (!student)
        return false;
    snprintf(student->address, sizeof student->address, "%s", address);
    return student->listed = true;
}

const char *students_missing(const Students *students, int *at)
{
    while (*at < students->count) {
        const Student *student = &students->list[(*at)++];
        if (student->came == 0)
            return student->name;
    }
    return NULL;
}

bool students_add(Students *students, const Lesson *lesson, const Grades *grades, Status *status)
{
    if (!*grades->student)
        return true;
    Student *student = find(students, grades->student, grades->id);
    if (!student)
        student = add(students, grades->student, grades->id, status);
    if (!student)
        return false;
    if (!*student->id)
        snprintf(student->id, sizeof student->id, "%s", grades->id);
    student->came++;
    if (*grades->remark && !strstr(student->remark, grades->remark))
        text_append(student->remark, sizeof student->remark, "%s%s", *student->remark ? "; " : "",
                    grades->remark);
    student->sessions += grades->count > 0;
    for (int i = 0; i < grades->count; i++) {
        const Grade *grade = &grades->grades[i];
        const bool judged = grade->mark.tries > 0 && grade->mark.judged;
        student->right[grade->page] |= judged && grade->mark.right;
        student->wrong[grade->page] |= judged && !grade->mark.right;
        student->unread[grade->page] |= grade->mark.tries > 0 && !judged &&
                                        lesson_exercise(&lesson->pages[grade->page]) == EXERCISE_WORDS;
    }
    return true;
}

enum { ID, NAME, GRADE, MAXIMUM, FEEDBACK, UNREAD, SESSIONS, REMARK, CELLS };
enum { FEEDBACK_MAX = 8192 };
static const char *const columns[CELLS] = {"ID number",         "Full name", "Grade",    "Maximum grade",
                                           "Feedback comments", "To read",   "Sessions", "Remark"};

void students_write(const Students *students, const Lesson *lesson, FILE *stream, Dialect dialect)
{
    csv_header(stream, dialect, columns, CELLS);
    for (int i = 0; i < students->count; i++) {
        const Student *student = &students->list[i];
        double sum = 0, most = 0, unread = 0;
        char remark[GRADING_REMARK_MAX + 32];
        char feedback[FEEDBACK_MAX] = "", grade[NUMBER_TEXT_MAX] = "", maximum[NUMBER_TEXT_MAX],
             to_read[NUMBER_TEXT_MAX], sessions[NUMBER_TEXT_MAX];
        for (int page = 0; page < lesson->n_pages; page++) {
            const double points = lesson_points(&lesson->pages[page]);
            const bool once = lesson_exercise(&lesson->pages[page]) == EXERCISE_CHOICE;
            const bool right = student->right[page] && !(once && student->wrong[page]);
            most += points;
            sum += right ? points : 0;
            unread += student->unread[page] ? points : 0;
            if (points > 0 && student->sessions > 0)
                text_append(feedback, sizeof feedback, "%s%d %s: %s", *feedback ? "; " : "", page + 1,
                            lesson->pages[page].title,
                            right                   ? "right"
                            : student->wrong[page]  ? "not right"
                            : student->unread[page] ? "to be read"
                                                    : "no answer");
        }
        if (student->sessions > 0)
            text_shortest(grade, sum);
        text_shortest(maximum, most);
        text_shortest(to_read, unread);
        snprintf(sessions, sizeof sessions, "%d", student->sessions);
        snprintf(remark, sizeof remark, "%s%s%s", student->remark,
                 *student->remark && students->listed && !student->listed ? "; " : "",
                 student->came == 0                     ? "missing"
                 : students->listed && !student->listed ? "not in the list of the class"
                                                        : "");
        csv_words(stream, dialect,
                  (const char *[CELLS]){student->id, student->name, grade, maximum, feedback, to_read,
                                        sessions, remark},
                  CELLS);
    }
}

void students_free(Students *students)
{
    free(students->list);
    *students = (Students){.count = 0};
}
