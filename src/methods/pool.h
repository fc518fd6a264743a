/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A few threads that share out the chunks of one job after another and sleep when there is none.
 *
 * The caller works too, and waits only for chunks that another thread has begun, never for a thread that has
 * not come yet: a machine that is busy elsewhere costs no more than one chunk. */
#ifndef METHODS_POOL_H
#define METHODS_POOL_H

#include "base/status.h"

typedef struct Pool Pool;

/* Does one chunk; `worker` counts the threads from 0 (the caller). */
typedef void PoolWork(void *context, int chunk, int worker);

/* `threads` counts the caller; where the system starts fewer, these do the work. NULL: the status says why.
 */
Pool *pool_create(int threads, Status *status);
void pool_destroy(Pool *pool); /* NULL is allowed */

/* Does chunks 0 .. chunks - 1, in any order, and returns when all are done. */
void pool_run(Pool *pool, PoolWork *work, void *context, int chunks);

#endif
