/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The clock of those who wait for something, or say how long it took: seconds, only ever growing. */
#ifndef BASE_CLOCK_H
#define BASE_CLOCK_H

#include <time.h>

static inline double clock_seconds(void)
{
    struct timespec time;
    clock_gettime(CLOCK_MONOTONIC, &time);
    return (double)time.tv_sec + 1e-9 * (double)time.tv_nsec;
}

#endif
