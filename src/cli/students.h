/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The students of all sessions that are marked, each with the best of what those sessions came to: a table
 * with a row for each, in the words of Moodle's imports. */
#ifndef CLI_STUDENTS_H
#define CLI_STUDENTS_H

#include "export/csv.h"
#include "lab/session/grading.h"

typedef struct Student Student;

typedef struct Students {
    Student *list; /* in the order in which they came */
    int count;
} Students;

/* Who has the same name, and no other ID, is the same student. A number or a goal is right where one session
 * has it right; a choice where one has it right and none has it wrong, for its first answer counts. */
bool students_add(Students *, const Lesson *, const Grades *, Status *);

void students_write(const Students *, const Lesson *, FILE *, Dialect);
void students_free(Students *);

#endif
