/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of problems: nothing but their names. To add one: its file, and its name here. */
#include "problems/problem.h"

#define PROBLEMS(PROBLEM)                                                                                    \
    PROBLEM(bar)                                                                                             \
    PROBLEM(supported_beam)                                                                                  \
    PROBLEM(moving_cantilever)                                                                               \
    PROBLEM(notched_beam)                                                                                    \
    PROBLEM(plate)                                                                                           \
    PROBLEM(one_particle)                                                                                    \
    PROBLEM(hanging_column)                                                                                  \
    PROBLEM(bodies)

#define DECLARED(name) extern const Problem problem_##name;
PROBLEMS(DECLARED)

#define LISTED(name) &problem_##name,
const Problem *const problems[] = {PROBLEMS(LISTED) NULL};
