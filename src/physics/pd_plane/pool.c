/* One word says it all: the number of the job in its upper half, how many chunks were taken from the front
 * and how many from the back in the quarters of its lower. A thread takes a chunk by adding one to its
 * quarter of the word it read; if the job has ended meanwhile the word has changed and the attempt fails, so
 * that nobody works for a job that is gone. Two ends, since a core then meets the chunks again that its cache
 * holds. */
#include "physics/pd_plane/pool.h"

#include <pthread.h>
#include <sched.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdlib.h>

enum {
    SPIN_WORK = 2000, /* looks for a new job before sleeping: some ten microseconds */
    SPIN_DONE = 2000  /* looks for the last chunk's end before sleeping */
};

typedef struct Worker {
    Pool *pool;
    pthread_t thread;
    int number;
} Worker;

struct Pool {
    _Alignas(64) _Atomic uint64_t ticket;
    _Alignas(64) _Atomic int left;     /* chunks of this job not yet done */
    _Alignas(64) _Atomic int sleepers; /* workers that wait for a job */
    _Atomic bool caller_sleeps;
    _Atomic bool ends;

    /* of the present job; written before the ticket */
    PoolWork *work;
    void *context;
    _Atomic int chunks;

    pthread_mutex_t lock;
    pthread_cond_t job, done;
    int n_workers;
    Worker workers[];
};

static void rest(void)
{
#if defined(__x86_64__) || defined(__i386__)
    __builtin_ia32_pause();
#endif
}

static void chunk_done(Pool *pool)
{
    if (atomic_fetch_sub(&pool->left, 1) == 1 && atomic_load(&pool->caller_sleeps)) {
        pthread_mutex_lock(&pool->lock);
        pthread_cond_signal(&pool->done);
        pthread_mutex_unlock(&pool->lock);
    }
}

static int from_front(uint64_t ticket)
{
    return (int)(ticket & UINT16_MAX);
}

static int from_back(uint64_t ticket)
{
    return (int)(ticket >> 16 & UINT16_MAX);
}

static bool all_taken(const Pool *pool, uint64_t ticket)
{
    return from_front(ticket) + from_back(ticket) >= atomic_load(&pool->chunks);
}

/* Takes and does chunks until there are none: the caller and every other worker from the front. */
static void take_chunks(Pool *pool, int worker)
{
    uint64_t ticket = atomic_load(&pool->ticket);
    while (!all_taken(pool, ticket)) {
        bool back = worker % 2 != 0;
        /* after the exchange the job cannot end before this chunk has */
        if (!atomic_compare_exchange_weak(&pool->ticket, &ticket, ticket + (back ? UINT64_C(1) << 16 : 1)))
            continue;
        int chunk = back ? atomic_load(&pool->chunks) - 1 - from_back(ticket) : from_front(ticket);
        pool->work(pool->context, chunk, worker);
        chunk_done(pool);
        ticket = atomic_load(&pool->ticket);
    }
}

static bool idle(Pool *pool)
{
    return all_taken(pool, atomic_load(&pool->ticket)) && !atomic_load(&pool->ends);
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
        for (int i = 0; i < SPIN_WORK && idle(pool); i++)
            rest();
        if (!idle(pool))
            continue;
        pthread_mutex_lock(&pool->lock);
        atomic_fetch_add(&pool->sleepers, 1);
        while (idle(pool))
            pthread_cond_wait(&pool->job, &pool->lock);
        atomic_fetch_sub(&pool->sleepers, 1);
        pthread_mutex_unlock(&pool->lock);
    }
    return NULL;
}

void pool_run(Pool *pool, PoolWork *work, void *context, int chunks)
{
    uint64_t job = (atomic_load(&pool->ticket) >> 32) + 1;
    /* no chunk of a job without chunks can be taken while the job is changed */
    atomic_store(&pool->chunks, 0);
    atomic_store(&pool->left, chunks);
    pool->work = work;
    pool->context = context;
    atomic_store(&pool->ticket, job << 32);
    atomic_store(&pool->chunks, chunks);
    if (atomic_load(&pool->sleepers) > 0) {
        pthread_mutex_lock(&pool->lock);
        pthread_cond_broadcast(&pool->job);
        pthread_mutex_unlock(&pool->lock);
    }
    take_chunks(pool, 0);
    for (int i = 0; i < SPIN_DONE && atomic_load(&pool->left) > 0; i++)
        rest();
    if (atomic_load(&pool->left) > 0) {
        pthread_mutex_lock(&pool->lock);
        atomic_store(&pool->caller_sleeps, true);
        while (atomic_load(&pool->left) > 0)
            pthread_cond_wait(&pool->done, &pool->lock);
        atomic_store(&pool->caller_sleeps, false);
        pthread_mutex_unlock(&pool->lock);
    }
}

static const int faults[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

Pool *pool_create(int threads, Status *status)
{
    Pool *pool = aligned_alloc(64, (sizeof *pool + (size_t)threads * sizeof *pool->workers + 63) / 64 * 64);
    if (!pool) {
        status_fail(status, STATUS_FAILED, "not enough memory for %d threads", threads);
        return NULL;
    }
    atomic_init(&pool->ticket, 0);
    atomic_init(&pool->left, 0);
    atomic_init(&pool->sleepers, 0);
    atomic_init(&pool->caller_sleeps, false);
    atomic_init(&pool->ends, false);
    atomic_init(&pool->chunks, 0);
    pthread_mutex_init(&pool->lock, NULL);
    pthread_cond_init(&pool->job, NULL);
    pthread_cond_init(&pool->done, NULL);
    pool->n_workers = 0;
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
    atomic_store(&pool->ends, true);
    pthread_cond_broadcast(&pool->job);
    pthread_mutex_unlock(&pool->lock);
    for (int i = 0; i < pool->n_workers; i++)
        pthread_join(pool->workers[i].thread, NULL);
    pthread_mutex_destroy(&pool->lock);
    pthread_cond_destroy(&pool->job);
    pthread_cond_destroy(&pool->done);
    free(pool);
}
