/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The number of threads to use by default (threads.h); the threads themselves are the pool's
 * (methods/pool.h). */
#include "base/threads.h"

#include <errno.h>
#include <limits.h>
#include <sched.h>
#include <stdlib.h>
#include <unistd.h>

int threads_allowed(void)
{
#ifdef HAVE_SCHED_GETAFFINITY
    /* a mask that is shorter than the kernel's is refused, so it grows until it fits */
    for (size_t processors = CPU_SETSIZE; processors <= 1 << 20; processors *= 2) {
        cpu_set_t *set = CPU_ALLOC(processors);
        const size_t size = CPU_ALLOC_SIZE(processors);
        if (!set)
            break;
        const int result = sched_getaffinity(0, size, set);
        const bool too_short = result != 0 && errno == EINVAL;
        const int count = result == 0 ? CPU_COUNT_S(size, set) : 0;
        CPU_FREE(set);
        if (count > 0)
            return count;
        if (!too_short)
            break;
    }
#endif
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    return processors > 0 && processors <= INT_MAX ? (int)processors : 1;
}

/* "4", or "4,2" for levels of parallel regions within each other; 0: not set, or no number. */
static int threads_asked(void)
{
    const char *text = getenv("OMP_NUM_THREADS");
    if (!text)
        return 0;
    char *end;
    const long number = strtol(text, &end, 10);
    while (*end == ' ' || *end == '\t')
        end++;
    if (end == text || (*end && *end != ','))
        return 0;
    return number < 1 ? 0 : number > INT_MAX ? INT_MAX : (int)number;
}

int threads_default(bool on_screen)
{
    const int allowed = threads_allowed(), asked = threads_asked();
    if (asked > 0)
        return asked < allowed ? asked : allowed;
    return on_screen && allowed > 1 ? allowed - 1 : allowed;
}
