/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The rows of a run as far as they are kept: one row per recorded step, all columns.
 *
 * Rows are kept whole up to a budget. Beyond it every second row is dropped and from then on only every
 * second step is kept (again and again): the spacing doubles, first and last row stay. */
#ifndef RUN_RECORD_H
#define RUN_RECORD_H

#include <stdbool.h>
#include <stddef.h>

typedef struct Record {
    double *rows; /* count x n_columns; column 0 is the step, column 1 the time */
    size_t count, room, most;
    int n_columns;
    long spacing; /* steps between rows: `every` of record_open(), twice, four times it, ... */
    bool thinned;
    bool loose_last; /* the last row is not a multiple of the spacing; the next one takes its place */
} Record;

/* `budget` in bytes; every: steps between rows to begin with. */
void record_open(Record *, int n_columns, long every, size_t budget);
void record_close(Record *);

/* Appends a row if its step is due, else puts it last until the next comes. False: no memory. */
bool record_append(Record *, const double *row);

/* Forgets all rows after a step. */
void record_cut(Record *, long step);

/* A copy with memory of its own. False: no memory; `to` is empty then. */
bool record_copy(Record *to, const Record *from);

const double *record_row(const Record *, size_t i);

/* A column in row i, or in the last of some rows before it that has it: what takes long to find is NAN in
 * most. NAN: none has it. */
double record_known(const Record *, size_t i, int column);

/* The row of a step; NULL: it is not kept. */
const double *record_of_step(const Record *, long step);

/* The index of the last row with time <= t; 0 if there is none. */
size_t record_find(const Record *, double t);

#endif
