/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any bytes as the lines of a plain session: the first names a scenario and whether the engine is slow there
 * ("late-cure slow"), each other is done to its end. That every line comes to one is held by counting: the
 * clock may not be read for ever while no step gets done. */
#include "fuzz/fuzz.h"

#include "base/input.h"
#include "scenario/scenario.h"
#include "plain/plain.h"

#include <stdio.h>
#include <string.h>

enum { READS_MOST = 20000, STEPS_MOST = 2000, SLOW_STEPS_MOST = 40, ASKED_MOST = 100, LINES_MOST = 20 };

static long reads, steps, asked; /* the clock since a step was done, steps, whether to go on */
static bool slow;                /* each step takes longer than a frame, and is done in parts */

static double now(void *context)
{
    static double later;
    FUZZ_ASSERT(++reads < READS_MOST);
    later = slow ? later + FRAME_SECONDS : 0;
    return ((const Plain *)context)->time + later;
}

static void worked(void *context, long done)
{
    reads = 0;
    steps += done;
    if (steps > (slow ? SLOW_STEPS_MOST : STEPS_MOST))
        ((Plain *)context)->lab.closed = true;
}

static bool go_on(void *context)
{
    (void)context;
    return ++asked < ASKED_MOST;
}

static void read_lines(Plain *plain, FILE *file)
{
    Status status = {STATUS_DONE, ""};
    InputLines lines = {.stream = file, .name = "input"};
    char line[400];
    steps = 0;
    for (int i = 0; i < LINES_MOST && !plain->lab.closed; i++) {
        reads = asked = 0;
        if (input_line(&lines, line, sizeof line, &status) != INPUT_LINE)
            return;
        FUZZ_ASSERT(plain_line(plain, line, &status));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static Plain plain;
    static Settings settings;
    Status status = {STATUS_DONE, ""};
    char head[64] = "", *said = NULL;
    size_t n_said = 0;
    /* nothing of the user's is read or written */
    unsetenv("XDG_STATE_HOME");
    unsetenv("HOME");
    if (size == 0)
        return 0;
    FILE *file = fmemopen((void *)(uintptr_t)data, size, "r"), *out = open_memstream(&said, &n_said);
    FUZZ_ASSERT(file && out && fgets(head, sizeof head, file));
    char *space = strpbrk(head, " \n");
    slow = space && strncmp(space, " slow", 5) == 0;
    head[strcspn(head, " \n")] = '\0';
    /* nobody's keyboard: it writes nothing */
    const LaboratoryOptions options = {
        .settings = &settings, .scenario = "input", .replay = "input", .plain = true, .history = 1 << 20};
    if (scenario_builtin(head) && scenario_load(head, &settings, &status) &&
        plain_open(&plain, &options, out, &status)) {
        plain.lab.host.now = now;
        plain.lab.host.worked = worked;
        plain.lab.host.go_on = go_on;
        read_lines(&plain, file);
        plain_close(&plain);
    }
    fclose(file);
    fclose(out);
    free(said);
    return 0;
}
