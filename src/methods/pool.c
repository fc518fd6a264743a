/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A job is a range of chunks in one word: who takes the first or the last of them does so by exchanging the
 * word, with no lock. One chunk is a few microseconds of work, and a lock that two threads want at once puts
 * one of them to sleep, which takes as long as a chunk.
 *
 * Two to four jobs make a time step; so a thread with nothing to do looks for a moment before going to sleep.
 * Without that look two threads are a fifth slower on a large beam, and slower than one on a small one. The
 * mutex and the two conditions are for sleepers alone: one who goes to sleep says so before looking a last
 * time, and one who has something to tell writes it before asking whether anybody sleeps (all in one order,
 * as sequentially consistent operations are), so one of the two sees the other. */
#include "methods/pool.h"

#include "base/assertion.h"
#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

enum { LOOKS = 2000 /* before sleeping: some ten microseconds */ };

typedef struct Worker {
    Pool *pool;
    pthread_t thread;
    int number;
} Worker;

struct Pool {
    /* of the present job: chunks that nobody has taken, and chunks that are not done. What to do is read by
     * those alone who hold a chunk, so it stays as it is while they read. */
    PoolWork *work;
    void *context;
    _Atomic uint64_t free; /* the first of them, and behind the last, in 32 bits each */
    _Atomic int to_do;

    _Atomic int asleep;         /* workers that wait for a job */
    _Atomic bool caller_asleep; /* waits for the last chunk */
    _Atomic bool ends;
    pthread_mutex_t lock;
    pthread_cond_t job, done;
    int threads, n_workers; /* with the caller; those that have been started */
    Worker workers[];
};

static uint64_t range(uint32_t first, uint32_t end)
{
    return (uint64_t)first << 32 | end;
}

static bool is_empty(uint64_t chunks)
{
    return (uint32_t)(chunks >> 32) >= (uint32_t)chunks;
}

static void rest_a_moment(void)
{
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

/* Takes and does chunks until there are none, and says so once: many at a time at first and one at a time at
 * last, so that all end together. The caller and every other worker take from the front, the rest from the
 * back: a core then meets the chunks again that its cache holds. */
static void take_chunks(Pool *pool, int worker)
{
    const uint32_t shares = 2 * (uint32_t)pool->threads;
    int done = 0;
    uint64_t chunks = atomic_load(&pool->free);
    while (!is_empty(chunks)) {
        uint32_t first = (uint32_t)(chunks >> 32), end = (uint32_t)chunks;
        const uint32_t count = 1 + (end - first - 1) / shares;
        uint64_t left;
        if (worker % 2 == 0) {
            left = range(first + count, end);
            end = first + count;
        } else {
            left = range(first, end - count);
            first = end - count;
        }
        if (!atomic_compare_exchange_weak(&pool->free, &chunks, left))
            continue;
        for (; first < end; first++, done++)
            pool->work(pool->context, (int)first, worker);
        chunks = atomic_load(&pool->free);
    }
    if (done > 0 && atomic_fetch_sub(&pool->to_do, done) == done && atomic_load(&pool->caller_asleep)) {
        pthread_mutex_lock(&pool->lock);
        pthread_cond_signal(&pool->done);
        pthread_mutex_unlock(&pool->lock);
    }
}

static bool has_nothing(Pool *pool)
{
    return is_empty(atomic_load(&pool->free)) && !atomic_load(&pool->ends);
}

static void *serve(void *argument)
{
    Worker *worker = argument;
    Pool *pool = worker->pool;
    while (!atomic_load(&pool->ends)) {
        take_chunks(pool, worker->number);
        /* A thread that is put aside with a chunk in hand stops everybody; so it offers its core now, while
         * it has none. */
        sched_yield();
        for (int i = 0; i < LOOKS && has_nothing(pool); i++)
            rest_a_moment();
        if (!has_nothing(pool))
            continue;
        pthread_mutex_lock(&pool->lock);
        atomic_fetch_add(&pool->asleep, 1);
        while (has_nothing(pool))
            pthread_cond_wait(&pool->job, &pool->lock);
        atomic_fetch_sub(&pool->asleep, 1);
        pthread_mutex_unlock(&pool->lock);
    }
    return NULL;
}

static void wake_workers(Pool *pool)
{
    if (atomic_load(&pool->asleep) == 0)
        return;
    pthread_mutex_lock(&pool->lock);
    pthread_cond_broadcast(&pool->job);
    pthread_mutex_unlock(&pool->lock);
}

void pool_run(Pool *pool, PoolWork *work, void *context, int chunks)
{
    ASSERT_INT(chunks, >=, 0);
    pool->work = work;
    pool->context = context;
    atomic_store(&pool->to_do, chunks);
    atomic_store(&pool->free, range(0, (uint32_t)chunks));
    wake_workers(pool);
    take_chunks(pool, 0);
    for (int i = 0; i < LOOKS && atomic_load(&pool->to_do) > 0; i++)
        rest_a_moment();
    if (atomic_load(&pool->to_do) == 0)
        return;
    pthread_mutex_lock(&pool->lock);
    atomic_store(&pool->caller_asleep, true);
    while (atomic_load(&pool->to_do) > 0)
        pthread_cond_wait(&pool->done, &pool->lock);
    atomic_store(&pool->caller_asleep, false);
    pthread_mutex_unlock(&pool->lock);
}

static const int faults[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

Pool *pool_create(int threads, Status *status)
{
    ASSERT_INT(threads, >=, 1);
    Pool *pool = malloc(sizeof *pool + (size_t)threads * sizeof *pool->workers);
    if (!pool) {
        status_fail(status, "not enough memory for %d threads", threads);
        return NULL;
    }
    *pool = (Pool){.threads = threads};
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
    return pool;
}

void pool_destroy(Pool *pool)
{
    if (!pool)
        return;
    atomic_store(&pool->ends, true);
    wake_workers(pool);
    for (int i = 0; i < pool->n_workers; i++)
        pthread_join(pool->workers[i].thread, NULL);
    pthread_mutex_destroy(&pool->lock);
    pthread_cond_destroy(&pool->job);
    pthread_cond_destroy(&pool->done);
    free(pool);
}
