/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any bytes as what a terminal sends to the laboratory; a zero byte and the two after it resize it. */
#include "fuzz/fuzz.h"

#include "scenario/scenario.h"
#include "lab/laboratory.h"
#include "terminal/keys.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BYTES_MAX = 400, STEPS_A_SECOND = 500 };

static double time_now;

static double now(void *context)
{
    (void)context;
    return time_now;
}

static void worked(void *context, long steps)
{
    (void)context;
    time_now += (double)steps / STEPS_A_SECOND;
}

static bool go_on(void *context)
{
    (void)context;
    return true;
}

static void nothing(void *context)
{
    (void)context;
}

/* No file is written or opened: what bytes come to name is nobody's business here. */
static bool is_harmless(const Laboratory *lab, const Key *key)
{
    return !(lab->screen.prompt->open && strcmp(key->name, "Enter") == 0 &&
             (lab->prompting.answer == opening_answer || lab->prompting.answer == exporting_scenario ||
              strpbrk(lab->screen.prompt->text, "/.") || strstr(lab->screen.prompt->question, "export")));
}

/* All keys that these bytes are. */
static void press(KeyReader *reader, Laboratory *lab, const uint8_t *bytes, size_t count)
{
    Key key;
    keys_feed(reader, bytes, count, time_now);
    while (keys_next(reader, &key) || keys_silence(reader, time_now + 60, &key))
        if (!lab->closed && is_harmless(lab, &key)) {
            laboratory_key(lab, &key);
            laboratory_frame(lab, time_now + FRAME_SECONDS);
            time_now += FRAME_SECONDS;
        }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static Laboratory lab;
    Settings settings;
    Status status = {STATUS_DONE, ""};
    Canvas canvas = {0};
    KeyReader reader;
    int width = 80, height = 24;
    /* how far somebody came in the lessons is not a fuzzer's to write, and each fsync() takes its time */
    unsetenv("XDG_STATE_HOME");
    unsetenv("HOME");
    FUZZ_ASSERT(scenario_load("mode1", &settings, &status));
    LaboratoryOptions options = {
        .settings = &settings, .scenario = "mode1", .paused = true, .history = 1 << 20};
    Host host = {now, worked, go_on, nothing, nothing, NULL, NULL, NULL};
    time_now = 0;
    FUZZ_ASSERT(laboratory_open(&lab, &options, &host, &status));
    keys_open(&reader, NULL);
    for (size_t i = 0; i < size && i < BYTES_MAX && !lab.closed; i++) {
        if (data[i] == 0 && i + 2 < size) {
            width = 1 + data[i + 1] % 200;
            height = 1 + data[i + 2] % 60;
            i += 2;
        } else {
            /* up to the next change of size, but a few at a time, for a picture between them */
            size_t count = 1;
            while (count < 8 && i + count < size && i + count < BYTES_MAX && data[i + count] != 0)
                count++;
            press(&reader, &lab, data + i, count);
            i += count - 1;
        }
        FUZZ_ASSERT(laboratory_draw(&lab, &canvas, width, height));
    }
    laboratory_close(&lab);
    canvas_close(&canvas);
    return 0;
}
