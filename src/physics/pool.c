/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A mutex, two conditions and the job at hand: chunks are taken under the mutex, done outside it. One chunk
 * is some ten microseconds of work, two jobs make a time step, and to wake a sleeping thread takes as long as
 * a chunk; so whoever has nothing to do looks for a moment before going to sleep. Without that look two
 * threads are a fifth slower on a large beam, and slower than one on a small one. */
#include "physics/pool.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdlib.h>

enum { LOOKS = 2000 /* before sleeping: some ten microseconds */ };

typedef struct Worker {
    Pool *pool;
    pthread_t thread;
    int number;
} Worker;

struct Pool {
    pthread_mutex_t lock;
    pthread_cond_t job, done;

    /* of the present job; changed under the lock, the two counters looked at without it too */
    PoolWork *work;
    void *context;
    int first, last;     /* the chunks that nobody has taken */
    _Atomic int to_take; /* how many these are */
    _Atomic int to_do;   /* chunks that are not done */

    bool ends;
    int n_workers;
    Worker workers[];
};

/* Looks for a moment whether the counter has become zero, or has not. */
static void look(const _Atomic int *counter, bool zero)
{
    for (int i = 0; i < LOOKS && (atomic_load(counter) == 0) != zero; i++) {
#if defined(__x86_64__) || defined(__i386__)
        __builtin_ia32_pause();
#endif
    }
}

/* Takes and does chunks until there are none; the lock is held at the start and at the end. The caller and
 * every other worker take from the front, the rest from the back: a core then meets the chunks again that its
 * cache holds. */
static void take_chunks(Pool *pool, int worker)
{
    while (pool->to_take > 0) {
        const int chunk = worker % 2 == 0 ? pool->first++ : pool->last--;
        pool->to_take--;
        pthread_mutex_unlock(&pool->lock);
        pool->work(pool->context, chunk, worker);
        pthread_mutex_lock(&pool->lock);
        if (--pool->to_do == 0)
            pthread_cond_signal(&pool->done);
    }
}

static void *serve(void *argument)
{
    Worker *worker = argument;
    Pool *pool = worker->pool;
    pthread_mutex_lock(&pool->lock);
    while (!pool->ends) {
        take_chunks(pool, worker->number);
        pthread_mutex_unlock(&pool->lock);
        /* A thread that is put aside with a chunk in hand stops everybody; so it offers its core now, while
         * it has none. */
        sched_yield();
        look(&pool->to_take, false);
        pthread_mutex_lock(&pool->lock);
        while (!pool->ends && pool->to_take == 0)
            pthread_cond_wait(&pool->job, &pool->lock);
    }
    pthread_mutex_unlock(&pool->lock);
    return NULL;
}

void pool_run(Pool *pool, PoolWork *work, void *context, int chunks)
{
    pthread_mutex_lock(&pool->lock);
    pool->work = work;
    pool->context = context;
    pool->first = 0;
    pool->last = chunks - 1;
    pool->to_take = pool->to_do = chunks;
    pthread_cond_broadcast(&pool->job);
    take_chunks(pool, 0);
    pthread_mutex_unlock(&pool->lock);
    look(&pool->to_do, true);
    pthread_mutex_lock(&pool->lock);
    while (pool->to_do > 0)
        pthread_cond_wait(&pool->done, &pool->lock);
    pthread_mutex_unlock(&pool->lock);
}

static const int faults[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

Pool *pool_create(int threads, Status *status)
{
    Pool *pool = malloc(sizeof *pool + (size_t)threads * sizeof *pool->workers);
    if (!pool) {
        status_fail(status, STATUS_FAILED, "not enough memory for %d threads", threads);
        return NULL;
    }
    *pool = (Pool){.first = 0};
    pthread_mutex_init(&pool->lock, NULL);
    pthread_cond_init(&pool->job, NULL);
    pthread_cond_init(&pool->done, NULL);
    /* Signals are for the caller, who may sleep until one comes; but a fault is its own thread's. */
    sigset_t others, before;
    sigfillset(&others);
    for (size_t i = 0; i < sizeof faults / sizeof *faults; i++)
        sigdelset(&others, faults[i]);
    pthread_sigmask(SIG_SETMASK, &others, &before);
    while (pool->n_workers < threads - 1) {
        Worker *worker = &pool->workers[pool->n_workers];
        *worker = (Worker){.pool = pool, .number = pool->n_workers + 1};
        if (pthread_create(&worker->thread, NULL, serve, worker) != 0)
            break;
        pool->n_workers++;
    }
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    if (pool->n_workers == threads - 1)
        return pool;
    pool_destroy(pool);
    status_fail(status, STATUS_FAILED, "--threads: cannot start %d threads", threads);
    return NULL;
}

void pool_destroy(Pool *pool)
{
    if (!pool)
        return;
    pthread_mutex_lock(&pool->lock);
    pool->ends = true;
    pthread_cond_broadcast(&pool->job);
    pthread_mutex_unlock(&pool->lock);
    for (int i = 0; i < pool->n_workers; i++)
        pthread_join(pool->workers[i].thread, NULL);
    pthread_mutex_destroy(&pool->lock);
    pthread_cond_destroy(&pool->job);
    pthread_cond_destroy(&pool->done);
    free(pool);
}
