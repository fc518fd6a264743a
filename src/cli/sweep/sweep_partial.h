/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of a sweep that has not come to its end, in FILE.partial: a row is appended as soon as its run is
 * done, and a sweep that was interrupted goes on from there. Each row begins with a hash of everything
 * its run depends on, which identifies the combination; so rows are found again whatever
 * their order, and more values may be added to a sweep without losing those that are there. */
#ifndef CLI_SWEEP_PARTIAL_H
#define CLI_SWEEP_PARTIAL_H

#include "cli/sweep/sweep_result.h"

#include <stdint.h>
#include <stdio.h>

typedef struct SweepPartial {
    FILE *stream; /* NULL: the rows are not kept */
    char *name;
    long rows;
} SweepPartial;

/* A number for a combination: equal settings and steps, equal number. 0: there was no memory. */
uint64_t sweep_partial_number(const Settings *, long steps);

/* Opens or begins the file beside `output` and puts the rows that are there into the results of the `count`
 * combinations. A file with rows that belong to none of them is refused, or begun anew with `force`; so is
 * one that another sweep is writing, always. */
bool sweep_partial_open(SweepPartial *, const char *output, const uint64_t *numbers, int count, bool force,
                        SweepResult *results, Status *);

bool sweep_partial_add(SweepPartial *, uint64_t number, const SweepResult *, Status *);

/* The file goes if it holds nothing or `finished`. */
void sweep_partial_close(SweepPartial *, bool finished);

#endif
