/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Finds a lesson: one of the program's own by its name, else a file (lesson.h). */
#include "lessons/lesson.h"

#include "base/hash.h"
#include "base/input.h"
#include "scenario/parameters.h"
#include "scenario/scenario.h"
#include "scenario/scenario_lines.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

enum { LESSON_BYTES_MAX = 4000000 };

const BuiltinLesson *lesson_builtin(const char *name)
{
    for (const BuiltinLesson *builtin = builtin_lessons; builtin->name; builtin++)
        if (strcmp(builtin->name, name) == 0)
            return builtin;
    return NULL;
}

/* --- the scenario files that it opens ---------------------------------------------------------------- */

/* "open mine.ini" of "homework/my.lesson" is "open homework/mine.ini"; a lesson of the program opens what is
 * the program's. */
static bool find_scenario(Lesson *lesson, char **line, const char *name, Status *status)
{
    const char *file = lesson_opening(*line), *slash = strrchr(name, '/');
    char *path;
    if (!file || scenario_builtin(file))
        return true;
    const int folder = slash && *file != '/' ? (int)(slash + 1 - name) : 0;
    if (asprintf(&path, "%.*s%.*s%s", (int)(file - *line), *line, folder, name, file) < 0)
        return status_fail(status, "not enough memory for a lesson");
    free(*line);
    *line = path;
    /* its keys and values go into the version; comments are none */
    Entries entries = {.all = NULL};
    file = lesson_opening(path);
    FILE *stream = input_open(file, SCENARIO_BYTES_MAX, status);
    const bool sound = stream && entries_read(&entries, stream, file, status);
    for (int i = 0; sound && i < entries.count; i++) {
        const Entry *entry = &entries.all[i];
        const char *const parts[] = {entry->section, entry->name, entry->value};
        for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
            lesson->version = hash_bytes(lesson->version, parts[k], strlen(parts[k]) + 1);
    }
    entries_free(&entries);
    if (stream)
        fclose(stream);
    return sound || status_prefix(status, "%s", name);
}

static bool find_scenarios(Lesson *lesson, const char *name, Status *status)
{
    for (int i = 0; i < lesson->n_pages; i++) {
        LessonPage *page = &lesson->pages[i];
        LessonPart *const parts[] = {&page->first, &page->revealed, &page->solution};
        for (size_t part = 0; part < sizeof parts / sizeof *parts; part++)
            for (int k = 0; k < parts[part]->n_actions; k++)
                if (!find_scenario(lesson, &parts[part]->actions[k], name, status))
                    return false;
    }
    return true;
}

bool lesson_load(const char *name, LessonJudge may_do, Lesson *lesson, Status *status)
{
    const BuiltinLesson *builtin = lesson_builtin(name);
    *lesson = (Lesson){0};
    FILE *stream =
        builtin ? input_text(builtin->text, name, status) : input_open(name, LESSON_BYTES_MAX, status);
    if (!stream && !builtin && errno == ENOENT) {
        Nearest nearest = nearest_begin(name);
        for (builtin = builtin_lessons; builtin->name; builtin++)
            nearest_offer(&nearest, builtin->name);
        return status_refuse(status,
                             nearest.word ? "%s: no such lesson or file (did you mean %s?)"
                                          : "%s: no such lesson or file (see: matvib lesson --list)",
                             name, nearest.word);
    }
    if (!stream)
        return false;
    bool sound = lesson_read(stream, name, may_do, lesson, status);
    fclose(stream);
    if (sound && !builtin && !find_scenarios(lesson, name, status)) {
        lesson_free(lesson);
        sound = false;
    }
    return sound;
}

bool lesson_load_for(const char *name, const char *student, LessonJudge may_do, Lesson *lesson,
                     Status *status)
{
    if (!lesson_load(name, may_do, lesson, status))
        return false;
    if (lesson_draw(lesson, student, status))
        return true;
    lesson_free(lesson);
    return false;
}
