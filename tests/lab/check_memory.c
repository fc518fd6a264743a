/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Each allocation fails once in a session of the laboratory: nothing crashes, nothing leaks, and where the
 * session does not come out the same, a line has said that memory was short.
 *
 * The linker puts the functions below in the place of malloc and the others (--wrap) for all that is ours;
 * the libraries' own allocations do not fail. */
#include "suite.h"
#include "lab/tui_case.h"
#include "picture/canvas.h"

#include <errno.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* --- an allocator that fails once --- */

enum { LIVE_MAX = 1 << 16 };

static void *live[LIVE_MAX]; /* what is allocated and not yet freed, hashed by address */
static long n_live, n_calls, fails_at;

void *__real_malloc(size_t size);
void *__real_calloc(size_t count, size_t size);
void *__real_realloc(void *old, size_t size);
void *__real_aligned_alloc(size_t alignment, size_t size);
void __real_free(void *block);

void *__wrap_malloc(size_t size);
char *__wrap_strdup(const char *text);
int __wrap_asprintf(char **out, const char *format, ...);
void *__wrap_calloc(size_t count, size_t size);
void *__wrap_realloc(void *old, size_t size);
void *__wrap_aligned_alloc(size_t alignment, size_t size);
void __wrap_free(void *block);

static size_t place_of(uintptr_t address)
{
    return (size_t)((address >> 4) * 0x9e3779b97f4a7c15u >> 32) % LIVE_MAX;
}

static void *born(void *block)
{
    if (!block || n_live == LIVE_MAX / 2)
        return block;
    size_t at = place_of((uintptr_t)block);
    while (live[at])
        at = (at + 1) % LIVE_MAX;
    live[at] = block;
    n_live++;
    return block;
}

/* What a library has allocated is not known here. */
static void gone(uintptr_t address)
{
    size_t at = place_of(address);
    while (live[at] && (uintptr_t)live[at] != address)
        at = (at + 1) % LIVE_MAX;
    if (!live[at])
        return;
    n_live--;
    /* close the gap, so that what was put further on because of it is found */
    size_t gap = at;
    live[gap] = NULL;
    for (at = (at + 1) % LIVE_MAX; live[at]; at = (at + 1) % LIVE_MAX) {
        size_t wanted = place_of((uintptr_t)live[at]);
        bool may_move = gap <= at ? wanted <= gap || wanted > at : wanted <= gap && wanted > at;
        if (!may_move)
            continue;
        live[gap] = live[at];
        live[at] = NULL;
        gap = at;
    }
}

static bool fails(void)
{
    if (++n_calls != fails_at)
        return false;
    errno = ENOMEM; /* as the real ones do */
    return true;
}

void *__wrap_malloc(size_t size)
{
    return fails() ? NULL : born(__real_malloc(size));
}

void *__wrap_calloc(size_t count, size_t size)
{
    return fails() ? NULL : born(__real_calloc(count, size));
}

void *__wrap_realloc(void *old, size_t size)
{
    if (fails())
        return NULL;
    uintptr_t before = (uintptr_t)old;
    void *block = __real_realloc(old, size);
    if (!block)
        return NULL;
    gone(before);
    return born(block);
}

void *__wrap_aligned_alloc(size_t alignment, size_t size)
{
    return fails() ? NULL : born(__real_aligned_alloc(alignment, size));
}

void __wrap_free(void *block)
{
    if (block)
        gone((uintptr_t)block);
    __real_free(block);
}

char *__wrap_strdup(const char *text)
{
    size_t size = strlen(text) + 1;
    char *copy = __wrap_malloc(size);
    return copy ? memcpy(copy, text, size) : NULL;
}

int __wrap_asprintf(char **out, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    int length = fails() ? -1 : vasprintf(out, format, arguments);
    va_end(arguments);
    if (length >= 0)
        born(*out);
    return length;
}

/* --- a session that goes on whatever fails --- */

typedef struct Sitting {
    Bench bench;
    bool told; /* a line has said that memory is short */
} Sitting;

static bool speaks_of_memory(const char *text)
{
    return strstr(text, "memory") != NULL;
}

static void look(Sitting *sitting)
{
    Bench *bench = &sitting->bench;
    const Screen *screen = &bench->lab.screen;
    /* the host leaves the picture before where there is no memory for one */
    laboratory_draw(&bench->lab, &bench->canvas, bench->width, bench->height);
    sitting->told |= speaks_of_memory(screen->message->text) || speaks_of_memory(screen->prompt->problem) ||
                     speaks_of_memory(screen->parameters->edit.problem);
}

static void go(Sitting *sitting)
{
    Bench *bench = &sitting->bench;
    double begin = bench->time;
    laboratory_frame(&bench->lab, begin + FRAME_SECONDS);
    bench->time = begin + FRAME_SECONDS;
    look(sitting);
}

static void do_keys(Sitting *sitting, const char *names)
{
    char list[512], *place;
    snprintf(list, sizeof list, "%s", names);
    for (char *name = strtok_r(list, " ", &place); name; name = strtok_r(NULL, " ", &place)) {
        Key key = {.x = -1, .y = -1};
        snprintf(key.name, sizeof key.name, "%s", name);
        laboratory_key(&sitting->bench.lab, &key);
        look(sitting);
        for (int most = 1000; most > 0 && sitting->bench.lab.screen.playback->state == STATE_COMPUTING;
             most--)
            go(sitting);
    }
}

static const char *const bar_keys[] = {
    "Space",
    "> > ] ] S , < $",
    "g 2 Enter",
    "c",
    ": i n i t i a l . m o d e = 3 Enter",
    "u",
    "^R",
    ": m p m . a l g o r i t h m = u s l Enter",
    "< <",
    ": m p m . a l g o r i t h m = m u s l Enter",
    "1 1 2 2 3 4 5 5 6 6 7 7 9",
    "z z ? Esc",
    "t",
    "x Enter",
    "w a . i n i Enter",
    "r",
    "> m 0 '",
    "o a . i n i Enter",
    ">",
};
static const char *const beam_keys[] = {
    "Space",
    "> ] ] , <",
    "g # 4 0 Enter",
    "2 3 5 6 7 8 8 8 9",
    "< ,",
    ": p d . c r i t i c a l _ s t r e s s = 1 Enter Esc",
    ": p d . c r i t i c a l _ s t r e t c h = 1 e - 4 Enter",
    "> >",
    "x b Enter",
    "o m o d e 1 Enter",
};

typedef struct Visit {
    const char *scenario;
    const char *const *keys;
    size_t n_keys;
} Visit;

static const Visit visits[] = {
    {"mode1", bar_keys, sizeof bar_keys / sizeof *bar_keys},
    {"notched-beam-coarse", beam_keys, sizeof beam_keys / sizeof *beam_keys},
};

/* The session from opening to closing; returns the last picture, NULL: it could not be opened. */
static char *sit_through(const Visit *visit, Sitting *sitting)
{
    Status status = {STATUS_DONE, ""};
    Bench *bench = &sitting->bench;
    memset(sitting, 0, sizeof *sitting);
    bench->width = 100;
    bench->height = 30;
    bench->rate = 2000;
    bool open = bench_open(bench, visit->scenario, false, &status);
    sitting->told = speaks_of_memory(status.text);
    for (size_t i = 0; open && i < visit->n_keys; i++) {
        for (int k = 0; k < 3; k++)
            go(sitting);
        do_keys(sitting, visit->keys[i]);
    }
    char *picture = NULL;
    if (open) {
        long mark = fails_at;
        fails_at = 0;
        look(sitting);
        picture = canvas_dump(&bench->canvas);
        fails_at = mark;
        laboratory_close(&bench->lab);
    }
    canvas_close(&bench->canvas);
    return picture;
}

static void clear_folder(void)
{
    ck_assert_int_eq(system("rm -f ./*"), 0);
}

START_TEST(each_allocation_may_fail)
{
    const Visit *visit = &visits[_i];
    char folder[64];
    enter_folder(folder);
    Sitting *sitting = __real_calloc(1, sizeof *sitting);
    fails_at = n_calls = 0;
    char *whole = sit_through(visit, sitting);
    long all = n_calls, silent = 0, failed = 0;
    ck_assert_ptr_nonnull(whole);
    ck_assert(!sitting->told);
    /* the first ones each, then some spread over the rest; MATVIB_FAILURES says how many */
    const char *wanted = getenv("MATVIB_FAILURES");
    long most = wanted ? atol(wanted) : suite_wide() ? 16 : 8, dense = most / 2, stride = all / most + 1;
    for (long n = 1; n <= all; n += n < dense ? 1 : stride) {
        clear_folder();
        long before = n_live;
        n_calls = 0;
        fails_at = n;
        char *picture = sit_through(visit, sitting);
        fails_at = 0;
        bool same = picture && strcmp(picture, whole) == 0;
        free(picture);
        ck_assert_msg(n_live == before, "allocation %ld of %ld fails: %ld blocks are not freed", n, all,
                      n_live - before);
        failed += !same;
        if (!same && !sitting->told) {
            silent++;
            fprintf(stderr, "allocation %ld of %ld fails, and nothing is said\n", n, all);
        }
    }
    ck_assert_int_eq(silent, 0);
    ck_assert_int_gt(failed, 3);
    free(whole);
    __real_free(sitting);
    leave_folder(folder);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *tcase = tcase_create("memory");
    tcase_add_loop_test(tcase, each_allocation_may_fail, 0, 2);
    suite_add_tcase(suite, tcase);
}
