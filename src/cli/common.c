/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A progress bar with the time that is left, drawn ten times a second at most and only on a terminal; it
 * also stops a long command when a signal came (cli.h). */
#include "cli/cli.h"
#include "base/wait.h"

#include "base/signals.h"
#include "base/threads.h"
#include "base/visible.h"
#include "base/cancel.h"
#include "base/text.h"
#include "methods/pool.h"
#include "problems/problem.h"

#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <unistd.h>
#include <stdlib.h>
#include <string.h>
#include <errno.h>

void progress_begin(Progress *progress, bool quiet)
{
    signals_catch();
    *progress = (Progress){.visible = !quiet && isatty(STDERR_FILENO), .began = clock_seconds()};
}

bool progress_show(double share, void *context)
{
    Progress *progress = context;
    double now = progress->visible ? clock_seconds() : 0;
    /* a run that takes no time needs no bar */
    if (progress->visible && now - progress->began > 0.5 && now - progress->shown > 0.1) {
        enum { WIDTH = 40 };
        int full = (int)(share * WIDTH);
        char line[WIDTH + 1];
        for (int i = 0; i < WIDTH; i++)
            line[i] = i < full ? '#' : '.';
        line[WIDTH] = '\0';
        double left = share > 0 ? (now - progress->began) * (1 - share) / share : 0;
        visible_progress(stderr, "[%s] %3.0f %%  %.0f s left ", line, floor(100 * share), ceil(left));
        progress->shown = now;
    }
    return signals_ended_by() == 0;
}

void progress_end(const Progress *progress)
{
    if (progress->shown > 0)
        visible_progress(stderr, "%s", "");
}

double progress_seconds(const Progress *progress)
{
    return clock_seconds() - progress->began;
}

int progress_signal(void)
{
    return signals_ended_by();
}

int progress_result(bool done, const Status *status)
{
    return done ? STATUS_DONE : progress_signal() ? 128 + progress_signal() : (int)status->code;
}

int progress_threads(long wanted)
{
    return wanted > 0 ? (int)wanted : threads_default(false);
}

/* What cli_each() is doing. */
typedef struct Queue {
    int count, threads; /* of each */
    CliWork *work;
    void *owner;
    pthread_mutex_t lock; /* of what follows */
    int next;             /* that nobody has taken */
    double share;         /* sum of what is done of each */
    Progress progress;
} Queue;

typedef struct Turn {
    Queue *queue;
    double share;
} Turn;

static bool show_share(double share, void *context)
{
    Turn *turn = context;
    Queue *queue = turn->queue;
    pthread_mutex_lock(&queue->lock);
    queue->share += share - turn->share;
    turn->share = share;
    const bool goes_on = progress_show(queue->share / queue->count, &queue->progress);
    pthread_mutex_unlock(&queue->lock);
    return goes_on;
}

static void take_turns(void *context, int chunk, int worker)
{
    (void)chunk, (void)worker;
    Queue *queue = context;
    for (;;) {
        pthread_mutex_lock(&queue->lock);
        const int next = queue->next++;
        pthread_mutex_unlock(&queue->lock);
        Turn turn = {queue, 0};
        if (next >= queue->count || !show_share(0, &turn))
            return;
        queue->work(queue->owner, next, queue->threads, (Cancel){show_share, &turn});
        show_share(1, &turn);
    }
}

bool cli_each(int count, long threads, bool quiet, CliWork *work, void *owner, Status *status)
{
    const int all = progress_threads(threads), at_once = all < count ? all : count;
    Queue queue = {.count = count, .threads = all / at_once, .work = work, .owner = owner};
    Pool *pool = pool_create(at_once, status);
    if (!pool)
        return false;
    pthread_mutex_init(&queue.lock, NULL);
    progress_begin(&queue.progress, quiet);
    pool_run(pool, take_turns, &queue, at_once);
    progress_end(&queue.progress);
    pthread_mutex_destroy(&queue.lock);
    pool_destroy(pool);
    return !progress_signal() || status_fail(status, "interrupted");
}

bool cli_derived_text(const Settings *settings, char *out, size_t size, Status *status)
{
    char advice[240] = "";
    Derived derived[DERIVED_MAX];
    Simulation *simulation = problem_simulate(settings, 1, status);
    if (!simulation)
        return false;
    const int before = shortage_begin();
    int count = problem_derived(settings, simulation, derived);
    const bool complete = errno != ENOMEM;
    shortage_end(before);
    simulation_destroy(simulation);
    if (!complete)
        return status_fail(status, "not enough memory for the numbers that follow from these");
    out[0] = '\0';
    for (int i = 0; i < count; i++) {
        char value[NUMBER_TEXT_MAX];
        if (derived[i].integer)
            snprintf(value, sizeof value, "%.0f", derived[i].value);
        else
            text_shortest(value, derived[i].value);
        const char *unit = strcmp(derived[i].unit, "1") == 0 ? "" : derived[i].unit; /* a plain number */
        text_append(out, size, "%s = %s%s%s\n", derived[i].name, value, *unit ? " " : "", unit);
    }
    Status refusal = {0};
    bool allowed = problem_advice(settings, advice, sizeof advice, &refusal);
    if (!allowed || *advice)
        text_append(out, size, "%s%s\n",
                    allowed ? "" : "a run is refused: ", allowed ? advice : refusal.text);
    return true;
}

static void put_text(FILE *out, const char *text)
{
    if (text)
        text_put_json(out, text, strlen(text));
    else
        fputs("null", out);
}

static void put_key(Quantities *list, const char *key)
{
    fputs(", ", list->out);
    put_text(list->out, key);
    fputs(": ", list->out);
}

Quantities quantities_open(FILE *out, const char *command)
{
    fputs("{\"command\": ", out);
    put_text(out, command);
    return (Quantities){out, 0};
}

void quantities_begin(Quantities *list, const char *key)
{
    put_key(list, key);
    fputc('[', list->out);
    list->count = 0;
}

void quantities_add(Quantities *list, const char *name, double value, const char *unit)
{
    fputs(list->count++ > 0 ? "},\n  {\"name\": " : "\n  {\"name\": ", list->out);
    put_text(list->out, name);
    quantities_number(list, "value", value);
    quantities_text(list, "unit", unit);
}

void quantities_end(Quantities *list)
{
    fputs(list->count > 0 ? "}]" : "]", list->out);
}

void quantities_close(Quantities *list)
{
    quantities_end(list);
    fputs("}\n", list->out);
}

void quantities_text(Quantities *list, const char *key, const char *text)
{
    put_key(list, key);
    put_text(list->out, text);
}

void quantities_number(Quantities *list, const char *key, double value)
{
    put_key(list, key);
    if (isfinite(value))
        fprintf(list->out, "%.17g", value);
    else
        fputs("null", list->out);
}
