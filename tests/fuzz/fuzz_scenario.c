/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any bytes as a scenario file: refused in one line, or read; what was read is written and read back the
 * same. */
#include "fuzz/fuzz.h"
#include "scenario/settings.h"
#include "scenario/parameters.h"
#include "scenario/scenario.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static bool read_text(const void *text, size_t size, Settings *settings, Status *status)
{
    FILE *file = fmemopen((void *)(uintptr_t)text, size, "r");
    FUZZ_ASSERT(file);
    bool sound = scenario_read(file, "input", settings, status);
    fclose(file);
    return sound;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static Settings first, again;
    Status status = {STATUS_DONE, ""};
    if (size == 0)
        return 0;
    if (!read_text(data, size, &first, &status)) {
        FUZZ_ASSERT(!read_text(data, size, &first, NULL)); /* nobody wants to know why */
        FUZZ_ASSERT(status.code != STATUS_DONE && status.text[0] && !strchr(status.text, '\n'));
        return 0;
    }
    if (!settings_check(&first, &status)) {
        FUZZ_ASSERT(status.text[0] && !strchr(status.text, '\n'));
        return 0;
    }
    char *text = NULL;
    size_t length = 0;
    FILE *file = open_memstream(&text, &length);
    FUZZ_ASSERT(file);
    bool written = scenario_write(file, &first, NULL, &status);
    fclose(file);
    if (written) {
        FUZZ_ASSERT(read_text(text, length, &again, &status));
        FUZZ_ASSERT(settings_same(&first, &again));
    }
    free(text);
    return 0;
}
