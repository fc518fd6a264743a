/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Any key at any time: each key of the table in each view and each prompt, and long sequences at random, with
 * a virtual clock and no terminal. */
#include "suite.h"
#include "lab/tui_case.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static const char *const scenarios[] = {"mode1", "gravity", "supported-beam-coarse", "notched-beam-coarse"};
enum { N_SCENARIOS = sizeof scenarios / sizeof *scenarios };

/* Under the sanitizers one bar and one beam: each frame of a crack takes a while. */
static int scenarios_tried(void)
{
    return suite_sanitized() ? 2 : N_SCENARIOS;
}

/* Each key of each command, every time after `before`; then out of whatever it opened. */
static void press_every_key_after(Bench *bench, const char *before)
{
    for (int i = 0; i < n_commands; i++) {
        char keys[64], *place;
        snprintf(keys, sizeof keys, "%s", commands[i].keys);
        for (char *key = strtok_r(keys, " ", &place); key; key = strtok_r(NULL, " ", &place)) {
            press_all(bench, before);
            press(bench, key);
            frame(bench);
            for (int most = 8;
                 most > 0 && (bench->lab.screen.prompt->open || bench->lab.parameters.edit.open ||
                              bench->lab.help.open || bench->lab.screen.panes.zoomed);
                 most--)
                press(bench, "Esc");
            ck_assert_msg(!bench->lab.screen.prompt->open && !bench->lab.parameters.edit.open, "%s %s",
                          before, key);
            bench->lab.closed = false;
        }
        if (bench->lab.screen.playback->state == STATE_RUNNING)
            press(bench, "Space");
    }
}

START_TEST(every_key_in_every_view)
{
    Bench *bench = open_bench(scenarios[_i * N_SCENARIOS / scenarios_tried()], true);
    bench->rate = 1000;
    press_all(bench, "> ]");
    for (char view = '1'; view <= '9'; view++)
        if (suite_long() || (view + _i) % (suite_wide() ? 2 : N_SCENARIOS) == 0)
            press_every_key_after(bench, (char[]){view, '\0'});
    close_bench(bench);
}
END_TEST

START_TEST(every_key_in_every_prompt)
{
    static const char *const openers[] = {"g", ":",   "o",     "w",         "/",        "?",
                                          "z", "> x", "> , x", "Esc Enter", ". Right q"};
    char folder[64];
    enter_folder(folder);
    Bench *bench = open_bench(scenarios[_i * N_SCENARIOS / scenarios_tried()], true);
    bench->rate = 1000;
    for (size_t i = 0; i < sizeof openers / sizeof *openers; i++) {
        bench->lab.screen.panes.focus = PANE_PARAMETERS;
        if (suite_long() || (i + (size_t)_i) % (suite_wide() ? 2 : N_SCENARIOS) == 0)
            press_every_key_after(bench, openers[i]);
    }
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

/* --- at random -------------------------------------------------------------------------------------- */

enum { QUEUE_MAX = 64 };

/* Fingers that press keys: now and then a whole word, so that prompts are answered too. */
typedef struct Fingers {
    uint64_t random;
    char queue[QUEUE_MAX];
    const char *last; /* the key after the queue; NULL: none */
    size_t at;
} Fingers;

static uint64_t draw_below(Fingers *fingers, uint64_t below)
{
    uint64_t *random = &fingers->random;
    *random ^= *random << 13, *random ^= *random >> 7, *random ^= *random << 17;
    return (*random >> 11) % below;
}

#define PICK(fingers, table) ((table)[draw_below(fingers, sizeof(table) / sizeof *(table))])

/* An opener and what is typed after it. */
static const char *const words[] = {
    ":initial.mode=3",
    ":initial.velocity=0",
    ":initial.velocity=1",
    ":initial.overtones=3:0.03,7:0.01",
    ":bar.supports=free-free",
    ":mpm.algorithm=usl",
    ":mpm.algorithm=musl",
    ":mpm.shape=gimp",
    ":mpm.shape=bspline3",
    ":mpm.transfer=apic",
    ":mpm.flip_fraction=0.9",
    ":mesh.cell_size=0.5",
    ":mesh.cell_size=5",
    ":mesh.particles_per_cell=4",
    ":load.traction=0.01",
    ":load.stress=2e8",
    ":pd.critical_stretch=1e-4",
    ":pd.surface_correction=none",
    ":pd.spacing=1e-3",
    ":notch.depth=0.01",
    ":time.end=1",
    ":time.end=1e-4",
    ":time.courant=0.5",
    ":time.courant=9",
    ":nonsense",
    ":=",
    ":time.end=",
    ":#30",
    ":2",
    "g1.5",
    "g#40",
    "g1e-5",
    "g-1",
    "gnan",
    "omode5",
    "ocrossing",
    "oenergy",
    "osupported-beam-coarse",
    "omoving-cantilever-coarse",
    "onotched-beam-coarse",
    "onowhere",
    "oa.ini",
    "oa-series.csv.ini",
    "wa.ini",
    "w/nowhere/a.ini",
    "xa",
    "xhere",
    "x/nowhere/b",
    "/velo",
    "/zzz",
};

static const char *const strange[] = {"Backspace", "Delete", "1",  "0",     "e",      "y",  "n",
                                      "Ω",         "^U",     "^W", "M-x",   "F7",     "^A", "^E",
                                      "C-Left",    "^K",     "é",  "S-F12", "Insert", "漢"};

/* The next key; its name is "" where the screen is resized instead. */
static Key next_key(Fingers *fingers, const Bench *bench)
{
    Key key = {.x = -1, .y = -1};
    char letter = fingers->queue[fingers->at];
    if (letter) {
        fingers->at++;
        snprintf(key.name, sizeof key.name, "%c", letter);
        return key;
    }
    if (fingers->last) {
        snprintf(key.name, sizeof key.name, "%s", fingers->last);
        fingers->last = NULL;
        return key;
    }
    static const char *const closers[] = {"Enter", "Enter", "Enter", "Enter", "Esc", "Tab"};
    static const char *const mouse[] = {"Click", "Click", "Drag", "WheelUp", "WheelDown"};
    uint64_t kind = draw_below(fingers, 100);
    const Command *command = &commands[draw_below(fingers, (uint64_t)n_commands)];
    if (kind < 12) {
        /* a word, or the name of a command */
        if (kind < 9)
            snprintf(fingers->queue, sizeof fingers->queue, "%s", PICK(fingers, words));
        else
            snprintf(fingers->queue, sizeof fingers->queue, ":%s", command->name);
        fingers->at = 0;
        fingers->last = PICK(fingers, closers);
        return next_key(fingers, bench);
    }
    if (kind < 22) {
        snprintf(key.name, sizeof key.name, "%s", PICK(fingers, mouse));
        key.x = (int)draw_below(fingers, (uint64_t)bench->width);
        key.y = (int)draw_below(fingers, (uint64_t)bench->height);
    } else if (kind < 34)
        snprintf(key.name, sizeof key.name, "%s", PICK(fingers, strange));
    else if (kind >= 36)
        sscanf(command->keys, "%15s", key.name);
    return key;
}

static Bench *random_bench(Fingers *fingers)
{
    /* beams take most of the time, so there are fewer of them */
    uint64_t beam = draw_below(fingers, 8) == 0;
    Bench *bench = open_bench(scenarios[2 * beam + draw_below(fingers, 2)], draw_below(fingers, 2));
    bench->rate = 500;
    return bench;
}

static void resize(Fingers *fingers, Bench *bench)
{
    bool small = draw_below(fingers, 6) == 0;
    bench->width = small ? 1 + (int)draw_below(fingers, 40) : 40 + (int)draw_below(fingers, 161);
    bench->height = small ? 1 + (int)draw_below(fingers, 12) : 12 + (int)draw_below(fingers, 49);
}

START_TEST(random_keys)
{
    char folder[64];
    const char *wanted = getenv("MATVIB_KEYS"), *tell = getenv("MATVIB_TELL");
    long count = wanted ? atol(wanted) : suite_wide() ? 4000 : 500;
    Fingers fingers = {.random = 0x9e3779b97f4a7c15u};
    enter_folder(folder);
    Bench *bench = random_bench(&fingers);
    for (long i = 0; i < count; i++) {
        Key key = next_key(&fingers, bench);
        /* what came before a crash is the last line that was told */
        if (tell)
            fprintf(stderr, "%ld %s %d %d in %dx%d\n", i, key.name, key.x, key.y, bench->width,
                    bench->height);
        if (key.name[0])
            press_key(bench, &key);
        else
            resize(&fingers, bench);
        frame(bench);
        ck_assert(laboratory_draw(&bench->lab, &bench->canvas, bench->width, bench->height));
        /* a new one now and then: some parameters make runs that no test can wait for */
        if (bench->lab.closed || i % 250 == 249) {
            close_bench(bench);
            bench = random_bench(&fingers);
        }
    }
    close_bench(bench);
    leave_folder(folder);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tables = tcase_create("every");
    tcase_add_loop_test(tables, every_key_in_every_view, 0, scenarios_tried());
    tcase_add_loop_test(tables, every_key_in_every_prompt, 0, scenarios_tried());
    suite_add_tcase(suite, tables);
    TCase *random = tcase_create("random");
    tcase_add_test(random, random_keys);
    suite_add_tcase(suite, random);
}
