/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "lab/tui_case.h"

#include "scenario/scenario.h"
#include "suite.h"
#include "picture/canvas.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static double now(void *context)
{
    Bench *bench = context;
    bench->time += bench->tick;
    return bench->time;
}

static void worked(void *context, long steps)
{
    Bench *bench = context;
    if (bench->rate > 0)
        bench->time += (double)steps / bench->rate;
}

static bool go_on(void *context)
{
    Bench *bench = context;
    snprintf(bench->progress, sizeof bench->progress, "%.79s", bench->lab.screen.message->text);
    return !bench->gives_up;
}

static void nothing(void *context)
{
    (void)context;
}

static void suspend(void *context)
{
    ((Bench *)context)->suspended++;
}

bool bench_open(Bench *bench, const char *scenario, bool paused, Status *status)
{
    LaboratoryOptions options = {.settings = &bench->settings, .scenario = scenario, .paused = paused};
    Host host = {now, worked, go_on, nothing, suspend, bench, NULL, NULL};
    return scenario_load(scenario, &bench->settings, status) &&
           laboratory_open(&bench->lab, &options, &host, status);
}

Bench *open_bench(const char *scenario, bool paused)
{
    Status status = {STATUS_DONE, ""};
    Bench *bench = calloc(1, sizeof *bench);
    ck_assert_ptr_nonnull(bench);
    bench->width = 80;
    bench->height = 24;
    ck_assert_msg(bench_open(bench, scenario, paused, &status), "%s", status.text);
    ck_assert(laboratory_draw(&bench->lab, &bench->canvas, bench->width, bench->height));
    return bench;
}

void close_bench(Bench *bench)
{
    laboratory_close(&bench->lab);
    canvas_close(&bench->canvas);
    free(bench);
}

void frame(Bench *bench)
{
    double begin = bench->time;
    laboratory_frame(&bench->lab, begin + FRAME_SECONDS);
    if (bench->time < begin + FRAME_SECONDS)
        bench->time = begin + FRAME_SECONDS;
}

void press_key(Bench *bench, const Key *key)
{
    laboratory_key(&bench->lab, key);
    if (bench->lab.screen.playback->state == STATE_COMPUTING)
        frame(bench);
    ck_assert(laboratory_draw(&bench->lab, &bench->canvas, bench->width, bench->height));
}

void press(Bench *bench, const char *name)
{
    Key key = {.x = -1, .y = -1};
    snprintf(key.name, sizeof key.name, "%s", name);
    press_key(bench, &key);
}

void press_all(Bench *bench, const char *names)
{
    char list[256];
    snprintf(list, sizeof list, "%s", names);
    char *place;
    for (char *name = strtok_r(list, " ", &place); name; name = strtok_r(NULL, " ", &place))
        press(bench, name);
}

void enter_line(Bench *bench, const char *text)
{
    press(bench, ":");
    for (; *text; text++)
        press(bench, *text == ' ' ? "Space" : (char[2]){*text, '\0'});
    press(bench, "Enter");
}

bool shows(Bench *bench, const char *text)
{
    char *dump = canvas_dump(&bench->canvas);
    ck_assert_ptr_nonnull(dump);
    bool found = strstr(dump, text) != NULL;
    free(dump);
    return found;
}

void enter_folder(char path[64])
{
    strcpy(path, "/tmp/matvib-check-XXXXXX");
    ck_assert_ptr_nonnull(mkdtemp(path));
    ck_assert_int_eq(chdir(path), 0);
}

void leave_folder(const char *path)
{
    char command[128];
    snprintf(command, sizeof command, "rm -rf '%s'", path);
    ck_assert_int_eq(chdir("/"), 0);
    ck_assert_int_eq(system(command), 0);
}

void click_at(Bench *bench, const char *name, int x, int y)
{
    Key key = {.x = x, .y = y};
    snprintf(key.name, sizeof key.name, "%s", name);
    press_key(bench, &key);
}

/* The row of the screen that begins with these words at a column; -1: none. */
int row_with(const Bench *bench, const char *words)
{
    static char line[512];
    for (int y = 0; y < bench->canvas.height; y++) {
        int used = 0;
        for (int x = 0; x < bench->canvas.width && used < 500; x++) {
            const uint32_t glyph = bench->canvas.cells[y * bench->canvas.width + x].glyph;
            line[used++] = glyph < 128 ? (char)glyph : '?';
        }
        line[used] = '\0';
        if (strstr(line, words))
            return y;
    }
    return -1;
}
