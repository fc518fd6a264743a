/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the files of the program's own are, by the rules of XDG. */
#include "lab/session/state_file.h"

#include "base/input.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>
#include <errno.h>
#include <string.h>

const char state_file_sheet[] = "sheet";

char *state_file(const char *name)
{
    const char *state = getenv("XDG_STATE_HOME"), *home = getenv("HOME");
    char *file;
    int length = -1;
    if (state && *state == '/')
        length = asprintf(&file, "%s/matvib/%s", state, name);
    else if (home && *home)
        length = asprintf(&file, "%s/.local/state/matvib/%s", home, name);
    return length < 0 ? NULL : file;
}

const char *state_file_word(const char *name, const char *const words[])
{
    char *path = state_file(name), line[64];
    FILE *file = path ? input_open(path, sizeof line, NULL) : NULL;
    InputLines lines = {.stream = file, .name = path};
    int at = -1;
    if (file && input_line(&lines, line, sizeof line, NULL) == INPUT_LINE)
        at = text_place_in(line, words);
    if (file)
        fclose(file);
    free(path);
    return at >= 0 ? words[at] : NULL;
}

/* A new file in the place of that of this name, with its folders; false: it cannot be kept. */
static bool open_state(OutputFile *file, Asker asker, const char *name)
{
    Status ignored = {0};
    char *path = state_file(name);
    if (path)
        output_make_own_folders(asker, path);
    const bool opened = path && output_open_own(file, asker, path, &ignored);
    free(path);
    return opened;
}

void state_file_put(Asker asker, const char *name, const char *word)
{
    Status ignored = {0};
    OutputFile file = {0};
    if (!open_state(&file, asker, name))
        return;
    fprintf(file.stream, "%s\n", word);
    output_end(&file, true, &ignored);
}

/* Reads and writes how far one has come; lines that do not name a page of a lesson are skipped. */

static const char *const progress_file = "lessons";

bool state_file_read_lessons(int reached[LESSONS_MAX])
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

void state_file_write_lessons(Asker asker, const int shown[LESSONS_MAX])
{
    Status ignored = {0};
    OutputFile file = {0};
    int reached[LESSONS_MAX];
    memcpy(reached, shown, sizeof reached);
    if (!state_file_read_lessons(reached) || !open_state(&file, asker, progress_file))
        return;
    for (int i = 0; i < LESSONS_MAX && builtin_lessons[i].name; i++)
        if (reached[i] > 0)
            fprintf(file.stream, "%s %d\n", builtin_lessons[i].name, reached[i]);
    output_end(&file, true, &ignored);
}
