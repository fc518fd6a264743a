/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Threads that share out chunks: each chunk of each job is done once, whoever does it, and a job is done when
 * its caller goes on. */
#include "methods/pool.h"
#include "suite.h"

#include <stdint.h>
#include <unistd.h>

enum { THREADS_MAX = 5, CHUNKS_MAX = 97, JOBS = 4000 };

typedef struct Job {
    uint8_t times[CHUNKS_MAX];
    int chunks_of[THREADS_MAX]; /* each thread's own */
} Job;

static void count(void *context, int chunk, int worker)
{
    Job *job = context;
    job->times[chunk]++;
    job->chunks_of[worker]++;
    for (volatile int k = 0; k < 50 * (chunk % 7); k++) /* some take longer */
        ;
}

START_TEST(each_chunk_is_done_once)
{
    const int threads = _i + 1;
    Status status = {0};
    Pool *pool = pool_create(threads, &status);
    ck_assert_ptr_nonnull(pool);
    for (int n = 0; n < JOBS; n++) {
        Job job = {{0}, {0}};
        const int chunks = n % (CHUNKS_MAX + 1);
        pool_run(pool, count, &job, chunks);
        int sum = 0;
        for (int k = 0; k < THREADS_MAX; k++)
            sum += job.chunks_of[k];
        ck_assert_int_eq(sum, chunks);
        for (int k = 0; k < CHUNKS_MAX; k++)
            ck_assert_msg(job.times[k] == (k < chunks), "job %d: chunk %d of %d was done %d times", n, k,
                          chunks, job.times[k]);
        if (n % 1000 == 0)
            usleep(2000); /* everybody goes to sleep */
    }
    pool_destroy(pool);
}
END_TEST

void add_cases(Suite *suite)
{
    TCase *pool = tcase_create("pool");
    tcase_add_loop_test(pool, each_chunk_is_done_once, 0, THREADS_MAX);
    suite_add_tcase(suite, pool);
}
