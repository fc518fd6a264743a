/* For the rows of problems: their parameters, and the solvers that there are. */
#ifndef LAB_SOLVERS_H
#define LAB_SOLVERS_H

#include "lab/problems/problem.h"

/* The head of a ParameterUse. */
#define USE(name, value) .key = name, .usual = value

extern const Solver bar_by_mpm, bar_by_pd;
extern const Solver supported_beam_by_pd, moving_cantilever_by_pd, notched_beam_by_pd;

#endif
