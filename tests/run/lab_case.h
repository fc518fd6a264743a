/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the tests of the laboratory share: settings to start from, comparisons of whole runs. */
#ifndef TESTS_LAB_CASE_H
#define TESTS_LAB_CASE_H

#include "run/experiment.h"
#include "scenario/parameters.h"

/* Paper M's bar in a mode, to the end of `end`. */
Settings bar_settings(int mode, double end);

/* A small beam that takes little time. */
Settings beam_settings(const Problem *problem, double end);

void set(Settings *settings, const char *key, const char *value);

Experiment *open_experiment(const Settings *settings, size_t history);

/* Works until nothing is pending, a few steps at a time. */
void finish_work(Experiment *experiment);

/* A deterministic number in [0, below). */
unsigned long draw(unsigned long *state, unsigned long below);

/* All that a state is made of, as bytes; free() it. */
unsigned char *state_of(const Simulation *sim, size_t *size);
void expect_same_states(const Simulation *a, const Simulation *b, const char *what);
void expect_same_records(const Record *a, const Record *b, const char *what);

/* The index of a column of the series; -1: there is none. */
int column_of(const Experiment *, const char *name);

#endif
