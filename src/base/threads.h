/* SPDX-License-Identifier: GPL-3.0-or-later */
/* How many threads to compute with by default. */
#ifndef BASE_THREADS_H
#define BASE_THREADS_H

#include <stdbool.h>

enum { THREADS_MAX = 1024 }; /* that may be asked for: more would only wait for each other */

/* The processors that this process may use, at least 1: those of its affinity mask (taskset, cgroups'
 * cpusets, a batch system) where the system has one, else all that are on. */
int threads_allowed(void);

/* OMP_NUM_THREADS if it is set (of a list, the number of the outermost level), else all that are allowed, and
 * on a screen one less, left to the terminal and other programs. Never more than allowed. */
int threads_default(bool on_screen);

#endif
