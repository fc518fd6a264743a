/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Where the files of the program's own are, by the rules of XDG. */
#include "lab/session/state_file.h"

#include "base/input.h"
#include "base/text.h"

#include <stdio.h>
#include <stdlib.h>

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

void state_file_put(Asker asker, const char *name, const char *word)
{
    Status ignored = {0};
    OutputFile file = {0};
    char *path = state_file(name);
    if (path)
        output_make_own_folders(asker, path);
    if (path && output_open_own(&file, asker, path, &ignored)) {
        fprintf(file.stream, "%s\n", word);
        output_end(&file, true, &ignored);
    }
    free(path);
}
