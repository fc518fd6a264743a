/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of problems: nothing but their names. */
#include "problems/problem.h"

const Problem *const problems[] = {
    &problem_bar,   &problem_supported_beam, &problem_moving_cantilever, &problem_notched_beam,
    &problem_plate, &problem_one_particle,   &problem_hanging_column,    NULL,
};
