/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any bytes as a lesson: refused in one line, or read, with at least a title and a page, and its variants
 * drawn. */
#include "fuzz/fuzz.h"

#include "lessons/lesson.h"
#include "help/command.h"

#include <stdio.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    Lesson lesson;
    Status status = {STATUS_DONE, ""};
    if (size == 0)
        return 0;
    FILE *file = fmemopen((void *)(uintptr_t)data, size, "r");
    FUZZ_ASSERT(file);
    if (lesson_read(file, "input", command_line_for_lessons, &lesson, &status)) {
        FUZZ_ASSERT(lesson.title && lesson.n_pages > 0);
        for (int i = 0; i < lesson.n_pages; i++)
            FUZZ_ASSERT(!lesson.pages[i].question || lesson.pages[i].exercise ||
                        lesson.pages[i].right < lesson.pages[i].n_choices);
        FUZZ_ASSERT(lesson_draw(&lesson, "Ada", &status));
        lesson_free(&lesson);
    } else {
        FUZZ_ASSERT(status.code != STATUS_DONE && status.text[0] && !strchr(status.text, '\n'));
        rewind(file);
        FUZZ_ASSERT(
            !lesson_read(file, "input", command_line_for_lessons, &lesson, NULL)); /* nobody asks why */
    }
    fclose(file);
    return 0;
}
