/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The worker processes of a sweep (sweep_jobs.h): each combination is computed in a child made by fork(),
 * which sends its progress and then its result through a pipe; the parent polls all pipes, starts the next
 * combination where a child has ended, and takes results in the order in which they come. A child that
 * ends without a result is a failed row, with its signal or exit status as the reason. */
#include "cli/sweep/sweep_jobs.h"

#include "base/signals.h"
#include "base/wait.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

/* What a worker sends to its parent. A message is smaller than PIPE_BUF, so it arrives whole. */
typedef struct Message {
    bool last;
    double share;
    SweepResult result; /* of the last one */
} Message;

_Static_assert(sizeof(Message) <= 4096, "a message must go through a pipe in one piece");

typedef struct Worker {
    pid_t process; /* 0: free */
    int from;      /* its end of the pipe */
    int combination;
    double share;
} Worker;

typedef struct Pool {
    const SweepWork *work;
    Worker *workers;
    struct pollfd *polls;
    sigset_t outside; /* the signals that were blocked before */
} Pool;

/* --- the worker ----------------------------------------------------------------------------------- */

typedef struct Sender {
    int to;
    struct timespec last;
} Sender;

/* At most ten times a second. False, so that the run stops, when the parent has gone: the pipe has no reader.
 */
static bool send_share(double share, void *context)
{
    Sender *sender = context;
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    double since =
        (double)(now.tv_sec - sender->last.tv_sec) + 1e-9 * (double)(now.tv_nsec - sender->last.tv_nsec);
    if (since < 0.1)
        return true;
    sender->last = now;
    Message message;
    memset(&message, 0, sizeof message);
    message.share = share;
    return write(sender->to, &message, sizeof message) == (ssize_t)sizeof message;
}

static _Noreturn void work_in_child(const Pool *pool, int combination, int to)
{
    signals_release();
    sigprocmask(SIG_SETMASK, &pool->outside, NULL);
    /* an open end of another's pipe would keep that one from noticing that the parent has gone */
    for (int i = 0; i < pool->work->jobs; i++)
        if (pool->workers[i].process > 0)
            close(pool->workers[i].from);
    Sender sender = {.to = to};
    Message message;
    memset(&message, 0, sizeof message);
    message.last = true;
    pool->work->run(pool->work->context, combination, send_share, &sender, &message.result);
    bool sent = write(to, &message, sizeof message) == (ssize_t)sizeof message;
    _exit(sent ? 0 : 1); /* what stdio holds is the parent's to write */
}

static bool start_worker(Pool *pool, Worker *worker, int combination, Status *status)
{
    int ends[2];
    if (pipe(ends) != 0)
        return status_fail(status, STATUS_FAILED, "a worker cannot be started: %s", strerror(errno));
    pid_t process = fork();
    if (process == 0) {
        close(ends[0]);
        work_in_child(pool, combination, ends[1]);
    }
    int why = errno;
    close(ends[1]);
    if (process < 0) {
        close(ends[0]);
        return status_fail(status, STATUS_FAILED, "a worker cannot be started: %s", strerror(why));
    }
    *worker = (Worker){.process = process, .from = ends[0], .combination = combination};
    return true;
}

/* --- the parent ----------------------------------------------------------------------------------- */

static int reap(Worker *worker)
{
    int how = 0;
    close(worker->from);
    while (waitpid(worker->process, &how, 0) < 0 && errno == EINTR)
        continue;
    worker->process = 0;
    return how;
}

static void stop_workers(Pool *pool)
{
    for (int i = 0; i < pool->work->jobs; i++)
        if (pool->workers[i].process > 0)
            kill(pool->workers[i].process, SIGTERM);
    for (int i = 0; i < pool->work->jobs; i++)
        if (pool->workers[i].process > 0)
            reap(&pool->workers[i]);
}

static bool finish(Pool *pool, Worker *worker, const SweepResult *result, Status *status)
{
    SweepResult lost = {0};
    int combination = worker->combination, how = reap(worker);
    if (!result) {
        if (WIFSIGNALED(how))
            status_fail(&lost.failure, STATUS_FAILED, "the run was ended: %s", strsignal(WTERMSIG(how)));
        else
            status_fail(&lost.failure, STATUS_FAILED, "the run ended without a result");
        result = &lost;
    }
    return pool->work->finished(pool->work->context, combination, result, status);
}

static bool receive(Pool *pool, Worker *worker, Status *status)
{
    Message message;
    ssize_t got = read(worker->from, &message, sizeof message);
    if (got < 0 && errno == EINTR)
        return true;
    if (got != (ssize_t)sizeof message)
        return finish(pool, worker, NULL, status);
    if (message.last)
        return finish(pool, worker, &message.result, status);
    worker->share = message.share;
    return true;
}

static void show_progress(const Pool *pool)
{
    double begun = 0;
    for (int i = 0; i < pool->work->jobs; i++)
        if (pool->workers[i].process > 0)
            begun += pool->workers[i].share;
    pool->work->progress(pool->work->context, begun);
}

static bool fill_places(Pool *pool, int *busy, Status *status)
{
    *busy = 0;
    for (int i = 0; i < pool->work->jobs; i++) {
        Worker *worker = &pool->workers[i];
        int combination = worker->process > 0 ? 0 : pool->work->next(pool->work->context);
        if (worker->process == 0 && combination >= 0 && !start_worker(pool, worker, combination, status))
            return false;
        *busy += worker->process > 0;
        pool->polls[i] = (struct pollfd){.fd = worker->process > 0 ? worker->from : -1, .events = POLLIN};
    }
    return true;
}

static bool work_through(Pool *pool, Status *status)
{
    for (;;) {
        int busy;
        if (signals_ended_by() || !fill_places(pool, &busy, status))
            return false;
        if (busy == 0)
            return true;
        show_progress(pool);
        if (wait_for(pool->polls, pool->work->jobs, NULL, &pool->outside) < 0)
            continue; /* a signal */
        for (int i = 0; i < pool->work->jobs; i++)
            if (pool->polls[i].revents && !receive(pool, &pool->workers[i], status))
                return false;
    }
}

int sweep_jobs(const SweepWork *work, Status *status)
{
    Pool pool = {.work = work,
                 .workers = calloc((size_t)work->jobs, sizeof(Worker)),
                 .polls = calloc((size_t)work->jobs, sizeof(struct pollfd))};
    int result = STATUS_FAILED;
    if (!pool.workers || !pool.polls) {
        status_fail(status, STATUS_FAILED, "not enough memory for %d jobs", work->jobs);
    } else {
        signals_catch();
        signals_block(&pool.outside);
        bool done = work_through(&pool, status);
        stop_workers(&pool);
        const int ended_by = signals_ended_by();
        signals_release();
        sigprocmask(SIG_SETMASK, &pool.outside, NULL);
        result = done ? STATUS_DONE : ended_by ? 128 + ended_by : (int)status->code;
    }
    free(pool.workers);
    free(pool.polls);
    return result;
}
