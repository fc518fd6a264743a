/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the tests of the laboratory's keys share: a laboratory with a virtual clock and no terminal. */
#ifndef TESTS_TUI_CASE_H
#define TESTS_TUI_CASE_H

#include "lab/laboratory.h"
#include "picture/canvas.h"

typedef struct Bench {
    Laboratory lab;
    Settings settings;
    Canvas canvas;
    double time, rate; /* rate: steps in a second, 0: without limit */
    double tick;       /* seconds that pass whenever the clock is read */
    bool gives_up;     /* ^C in the middle of long work */
    char progress[80]; /* what that work last said */
    int suspended;     /* so often */
    int width, height;
} Bench;

/* The laboratory in a bench that is zero but for the size and the clock. False: the status says why. */
bool bench_open(Bench *, const char *scenario, bool paused, Status *);

/* At 80x24, drawn once. */
Bench *open_bench(const char *scenario, bool paused);
void close_bench(Bench *);

/* One frame's work, not drawn. */
void frame(Bench *);

/* As the event loop does it: work that a key asks for begins in the same frame, and the screen is drawn. */
void press_key(Bench *, const Key *);
void press(Bench *, const char *name);
void press_all(Bench *, const char *names); /* parted by spaces */
/* On the command line. */
void enter_line(Bench *, const char *text);

bool shows(Bench *, const char *text);

void click_at(Bench *, const char *name, int x, int y); /* "Click", "WheelUp" */
int row_with(const Bench *, const char *words);         /* the row of the screen that has them; -1 */

/* A folder of its own, so that what is written harms nothing. */
void enter_folder(char path[64]);
void leave_folder(const char *path);

#endif
