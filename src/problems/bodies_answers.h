/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Exact answers beside a run of bodies, for its solver. */
#ifndef PROBLEMS_BODIES_ANSWERS_H
#define PROBLEMS_BODIES_ANSWERS_H

#include "problems/solver.h"

bool bodies_prepare(References *, const MpmDef *, const Simulation *, Status *);
int bodies_findings(const References *, const Simulation *, Finding out[FINDINGS_MAX]);

#endif
