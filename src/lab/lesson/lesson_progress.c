/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads and writes how far one has come; lines that are no page of a lesson are skipped. */
#include "lab/lesson/lesson_progress.h"

#include "base/input.h"
#include "base/text.h"
#include "lab/session/state_file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const progress_file = "lessons";

bool lesson_progress_read(int reached[LESSONS_MAX])
{
    char *path = state_file(progress_file), line[128];
    FILE *file = path ? input_open(path, 1000000, NULL) : NULL;
    bool known = file || (path && errno == ENOENT);
    InputLines lines = {.stream = file, .name = path};
    InputGot got = INPUT_END;
    while (file && (got = input_line(&lines, line, sizeof line, NULL)) == INPUT_LINE) {
        char *space = strchr(line, ' ');
        long page;
        if (!space || !text_to_long(space, &page) || page > LESSON_PAGES_MAX)
            continue;
        *space = '\0';
        for (int i = 0; i < LESSONS_MAX && builtin_lessons[i].name; i++)
            if (strcmp(builtin_lessons[i].name, line) == 0 && page > reached[i])
                reached[i] = (int)page;
    }
    if (file)
        fclose(file);
    free(path);
    return known && got == INPUT_END;
}

void lesson_progress_write(Asker asker, const int shown[LESSONS_MAX])
{
    Status ignored = {0};
    OutputFile file = {0};
    int reached[LESSONS_MAX];
    memcpy(reached, shown, sizeof reached);
    char *path = lesson_progress_read(reached) ? state_file(progress_file) : NULL;
    if (path)
        output_make_own_folders(asker, path);
    if (path && output_open_own(&file, asker, path, &ignored)) {
        for (int i = 0; i < LESSONS_MAX && builtin_lessons[i].name; i++)
            if (reached[i] > 0)
                fprintf(file.stream, "%s %d\n", builtin_lessons[i].name, reached[i]);
        output_end(&file, true, &ignored);
    }
    free(path);
}
