/* The list of problems: nothing but their names. */
#include "lab/problems/problem.h"

const Problem *const problems[] = {
    &bar_problem, &supported_beam_problem, &moving_cantilever_problem, &notched_beam_problem, NULL,
};
