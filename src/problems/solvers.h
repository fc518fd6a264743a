/* SPDX-License-Identifier: GPL-3.0-or-later */
/* For the rows of problems: their parameters, and the solvers that there are. */
#ifndef PROBLEMS_SOLVERS_H
#define PROBLEMS_SOLVERS_H

#include "problems/problem.h"

/* The head of a ParameterUse. */
#define USE(name, value) .key = name, .usual = value

/* Of a problem: its parameters, and that numbers are in units of one's own. */
#define USES(rows)   .uses = rows, .n_uses = sizeof rows / sizeof *rows
#define IN_OWN_UNITS .answer = "exact", .unit_of_time = "time", .shown_time = 1, .shown_time_unit = ""

extern const Solver bar_by_mpm, bar_by_pd;
extern const Solver beam_by_mpm_supported, beam_by_mpm_moving;
extern const Solver beam_by_pd_supported, beam_by_pd_moving, beam_by_pd_notched, beam_by_pd_plate;

#endif
