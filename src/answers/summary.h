/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a run came to, in words: printed by `matvib run`, shown by the laboratory at the end. */
#ifndef ANSWERS_SUMMARY_H
#define ANSWERS_SUMMARY_H

#include "run/experiment.h"
#include "answers/run_summary.h"

enum { SUMMARY_MAX = 1024 };

/* Fills in the columns that are told at the end and the energy from the rows of a run whose readout is known.
 * `invariant`: E* at the start and at the end, NAN where it is not known. */
void summary_rows(RunSummary *, const Simulation *, const Column *columns, int n_columns, const double *rows,
                  size_t count, const double invariant[2]);

/* Of a beam with a notch what there is to tell of its crack; else nothing. */
void summary_crack(RunSummary *, const Simulation *, const Settings *);

/* The same numbers for a run on screen, to its newest step. */
void summary_of(const Experiment *, RunSummary *);

/* The part of a summary from which a number is read; the readout is always there. */
typedef enum SummaryPart { SUMMARY_READOUT, SUMMARY_ENERGY, SUMMARY_FINDINGS, SUMMARY_CRACK } SummaryPart;

/* The readout and one part more at the step on screen, cheap enough for every picture: without what the crack
 * cost. What is not known there is left out. */
void summary_now(const Experiment *, SummaryPart, RunSummary *);

/* "energy E* changed by -82.5 % of the start": the measure, the change, relative to what. "": not known. */
void summary_energy_text(const RunSummary *, char out[SUMMARY_MAX]);

/* The crack in a few lines of at most 76 columns, each ended by '\n'; "": there is no crack. What a
 * microsecond is written as, "us" or with its sign, is the caller's. */
void summary_crack_text(const RunSummary *, const char *microseconds, char out[SUMMARY_MAX]);

/* A few lines of at most 76 columns, ASCII, each ended by '\n'. */
void summary_text(const RunSummary *, const Settings *, char out[SUMMARY_MAX]);

#endif
