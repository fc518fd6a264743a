/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a scenario says of what is written and shown of a run; it does not make it another run. */
#ifndef SCENARIO_CONCERN_OUTPUT_H
#define SCENARIO_CONCERN_OUTPUT_H

#include "base/status.h"
#include "scenario/assignment.h"

/* What a run writes; it does not make it another run. */
typedef struct Output {
    int every;              /* steps from row to row */
    int frames;             /* 0: the last step alone */
    char at[LIST_MAX];      /* "0,1e-4,2e-4"; "": none */
    char follow[LIST_MAX];  /* "particle 12 v, node 7 momentum": columns of the series; "": none */
    char columns[LIST_MAX]; /* "all", or those of the series that are written; "": all that cost no more than
                             * the step does */
} Output;

/* How a scenario opens; the engine ignores it. Empty: as the laboratory likes. */
typedef struct ViewSettings {
    char upper[VALUE_MAX], lower[VALUE_MAX], window[VALUE_MAX], pace[VALUE_MAX];
    char colour[VALUE_MAX], exaggeration[VALUE_MAX], references[VALUE_MAX];
    char sheet[VALUE_MAX]; /* how much of the screen there is: one of parameter_sheet_words */
    char about[VALUE_MAX]; /* the number that it is about: a word of run_numbers (answers/run_numbers.h) */
    char ask[LIST_MAX];    /* keys of the parameters that it asks about: settings_asked() */
} ViewSettings;

/* Of some settings: to be read, and to be changed. */
const Output *settings_output(const Settings *);
const ViewSettings *settings_view(const Settings *);
Output *settings_edit_output(Settings *);
ViewSettings *settings_edit_view(Settings *);

/* What is written of another one's run, but for the columns that it follows, which are another run's. */
void settings_take_output(Settings *, const Settings *from);

enum { TIMES_MAX = 64 };

/* "0,1e-4,2e-4", ascending: how many there are, or -1. */
int settings_times_read(const char *text, double out[TIMES_MAX], Status *);

#endif
