/* What a run came to, in words: printed by `matvib run`, shown by the laboratory at the end. */
#ifndef LAB_SUMMARY_H
#define LAB_SUMMARY_H

#include "lab/experiment.h"
#include "lab/export.h"

enum { SUMMARY_MAX = 1024 };

/* Fills in the energies, the columns and the last row from the rows of a run. */
void summary_rows(RunSummary *, const Column *columns, int n_columns, const double *rows, size_t count);

/* The same numbers for a run on screen, to its newest step. */
void summary_of(Experiment *, RunSummary *);

/* What drift is measured against: "" (the start) or " of the work", for a run that begins at rest. */
const char *summary_drift_base(const RunSummary *);

/* The crack in a few lines of at most 76 columns, each ended by '\n'; "": there is none to tell of. */
void summary_crack_text(const RunSummary *, char out[SUMMARY_MAX]);

/* A few lines of at most 76 columns, ASCII, each ended by '\n'. */
void summary_text(const RunSummary *, const Settings *, char out[SUMMARY_MAX]);

#endif
