/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The students of all sessions that are marked, each with the best of what those sessions came to: a table
 * with a row for each, in the words of Moodle's imports. */
#ifndef CLI_STUDENTS_H
#define CLI_STUDENTS_H

#include "export/export.h"
#include "lab/session/grading.h"

typedef struct Student Student;

typedef struct Students {
    Student *list; /* in the order in which they came */
    int count;
    bool listed; /* a list of the class was read first */
} Students;

/* One of the list of the class, of whom there is a row even if no session comes; its address ("": none) is as
 * good as its ID. */
bool students_enrol(Students *, const char *name, const char *id, const char *address, Status *);

/* Who has the same name, and no other ID, is the same student; so is who has the ID of one of the list. A
 * number or a goal is right where one session has it right; a choice where one has it right and none has it
 * wrong, for its first answer counts. */
bool students_add(Students *, const Lesson *, const Grades *, Status *);

/* The name of the next of the list, from *at on, of whom no session came. NULL: there are no more. */
const char *students_missing(const Students *, int *at);

void students_write(const Students *, const Lesson *, FILE *, Dialect);
void students_free(Students *);

#endif
