/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Homework by itself: `matvib lesson homework-late` asks who does it, and keeps what is done in a file of the
 * student's own, homework-late-NAME.session in this folder, or -2, -3 ... where that is there already. */
#ifndef CLI_HOMEWORK_H
#define CLI_HOMEWORK_H

#include "cli/options.h"
#include "lessons/variant.h"

enum { HOMEWORK_FILE_MAX = 512 };

typedef struct HomeworkFile {
    char student[STUDENT_MAX], id[STUDENT_MAX]; /* "": not told */
    char file[HOMEWORK_FILE_MAX];               /* "": nothing is kept */
} HomeworkFile;

/* Reads --name and --id, or asks for them where a lesson that holds exercises is begun at a terminal, and
 * chooses the file, unless --record names one or keys come from a script. `lesson` may be NULL. False: the
 * status says why, and that is before a page is seen. */
bool homework_begin(const Options *, const char *lesson, HomeworkFile *, Status *);

#endif
