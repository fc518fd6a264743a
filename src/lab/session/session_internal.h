/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a session is made of, for those that record, read and mark it. Private to this folder. */
#ifndef LAB_SESSION_SESSION_INTERNAL_H
#define LAB_SESSION_SESSION_INTERNAL_H

#include "scenario/settings.h"
#include "base/output.h"
#include "lessons/variant.h"
#include "lab/session/session.h"
#include "panes/screen.h"
#include "lessons/lesson_shown.h"

enum { SESSION_LINE_MAX = 1100, SESSION_PROGRAM_MAX = 64 };

#define SESSION_SECONDS_MOST 1e6 /* between two keys: eleven days */

struct Session {
    Settings settings;
    char scenario[SESSION_NAME_MAX], lesson[SESSION_NAME_MAX];
    int reached[LESSONS_MAX];
    char student[STUDENT_MAX], id[STUDENT_MAX], program[SESSION_PROGRAM_MAX];
    uint64_t version; /* of the lesson's text */
    uint64_t check;   /* of the lines so far */
    uint64_t keys;    /* of keys and their steps alone, where it was read */
    bool ended;       /* it goes on to its end */
    bool sound;       /* its check is that of its lines */
    bool paused, first;
    const char *sheet; /* one of parameter_sheet_words; NULL: none is named */
    SessionEvent *events;
    size_t count, room;
    bool full;
    const char *record; /* the file that lines go to as they come; NULL: none */
    bool replaces, begun;
    OutputFile file; /* behind `record`, once there is a key */
    Status trouble;  /* why not all of it could be written */
    bool told;       /* that is known to who sits there */
    double last;     /* when the last event came, by the host's clock */
};

#endif
