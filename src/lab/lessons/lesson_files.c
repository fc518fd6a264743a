/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds a lesson: one of the program's own by its name, else a file (lesson.h). */
#include "lab/lessons/lesson.h"

#include "base/input.h"
#include "lab/settings/parameters.h"

#include <errno.h>
#include <string.h>

enum { LESSON_BYTES_MAX = 4000000 };

const BuiltinLesson *lesson_builtin(const char *name)
{
    for (const BuiltinLesson *builtin = builtin_lessons; builtin->name; builtin++)
        if (strcmp(builtin->name, name) == 0)
            return builtin;
    return NULL;
}

static bool unknown(const char *name, Status *status)
{
    enum { MOST = 60 };
    const char *names[MOST + 1] = {NULL};
    int count = 0;
    for (const BuiltinLesson *builtin = builtin_lessons; builtin->name && count < MOST; builtin++)
        names[count++] = builtin->name;
    const char *nearest = parameter_nearest_word(names, name);
    if (!nearest)
        return status_fail(status, STATUS_USAGE, "%s: no such lesson or file (see: matvib lesson --list)",
                           name);
    return status_fail(status, STATUS_USAGE, "%s: no such lesson or file (did you mean %s?)", name, nearest);
}

bool lesson_load(const char *name, LessonJudge may_do, Lesson *lesson, Status *status)
{
    const BuiltinLesson *builtin = lesson_builtin(name);
    *lesson = (Lesson){0};
    FILE *stream =
        builtin ? input_text(builtin->text, name, status) : input_open(name, LESSON_BYTES_MAX, status);
    if (!stream)
        return !builtin && errno == ENOENT && unknown(name, status);
    bool sound = lesson_read(stream, name, may_do, lesson, status);
    fclose(stream);
    return sound;
}
