/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A simulation of any method, run and read in a test. */
#ifndef TESTS_RUN_CASE_H
#define TESTS_RUN_CASE_H

#include "methods/method.h"

/* n steps; stops the test if they fail. */
void advance(Simulation *sim, long steps);

/* A series value at the present state, by name. */
double series_now(Simulation *sim, const char *name);

/* A field as an array of its whole length; the caller frees it. */
double *field_now(const Simulation *sim, int set, const char *name);

/* A snapshot; the caller frees it. */
unsigned char *snapshot_now(const Simulation *sim);

#endif
