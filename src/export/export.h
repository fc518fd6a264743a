/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run as files: CSV tables with their .csv.ini beside. Column contract: manual page matvib-commands(7).
 *
 * Files are written whole or not at all: a temporary file in the same folder, fsync, rename. */
#ifndef EXPORT_EXPORT_H
#define EXPORT_EXPORT_H

#include "base/output.h"
#include "base/status.h"
#include "answers/run_summary.h"
#include "scenario/assignment.h"
#include "methods/method.h"

#include <stdio.h>
#include <stdbool.h>
#include <stddef.h>

/* The steps at which tables of particles, nodes and bonds are written. */
typedef struct Frames {
    long *steps; /* ascending, none twice */
    size_t count;
} Frames;

/* By output.frames (evenly from 0 to the last step), or output.at, or the last step alone. */
bool frames_plan(Frames *, const Settings *, double dt, long last, Status *);
void frames_free(Frames *);

/* How the numbers of a frame are written: as text, or behind the XML as they are in memory (raw appended data
 * of 64 bits), which is a third of the size and read much faster. */
typedef enum VtkData { VTK_TEXT, VTK_RAW } VtkData;

typedef enum Dialect { DIALECT_COMMA, DIALECT_SEMICOLON } Dialect;

/* What a run writes; a NULL name is not written, "-" is standard output. */
typedef struct Outputs {
    const char *series, *particles, *nodes, *bonds, *vtk;
    long stages[2]; /* of these steps, the first one of a run is 1: tables after each stage; 0: at frames */
    int stage;      /* after so many stages of them alone; 0: after each */
    Dialect dialect;
    VtkData vtk_data;
    Asker asker; /* on whose behalf */
    bool force;  /* existing files are replaced; else they are refused before the run starts */
} Outputs;

/* Whether the series has a column, the i-th of the references', by output.columns: step and time always. */
bool export_writes(const Settings *, const Simulation *, int i, const char *column);

/* Called now and then with the share done in [0, 1]; returns false to stop the run (^C). May be NULL. */
typedef bool (*RunProgress)(double share, void *context);

/* Runs settings from 0 to the end without keeping more than it must and writes the outputs as it goes; the
 * laboratory's export and `matvib run` are this function, so they write the same bytes. A run that fails on
 * its way still writes everything up to there, then returns false with the failure. */
bool export_run(const Settings *, const Outputs *, int threads, RunProgress, void *context, RunSummary *,
                Status *);

/* Particles as XML point data for ParaView: one .vtu file for each frame, and a .pvd file that names them
 * with their times. Points stand at their reference positions; "displacement" and "velocity" are vectors. */

/* The name of frame `i` of `count` for what the user wrote ("beam", "beam.vtu", "beam.pvd"); free() it. With
 * one frame there is "beam.vtu" alone. */
char *vtk_frame_name(const char *name, size_t i, size_t count);
char *vtk_collection_name(const char *name);

/* False: not enough memory. */
bool vtk_write_frame(FILE *, const Simulation *, VtkData);

void vtk_begin_collection(FILE *);
void vtk_add_to_collection(FILE *, const char *frame_name, double time);
void vtk_end_collection(FILE *);

/* Lines of a CSV table: numbers as the shortest text that reads back to the same double, LF. */

/* A number that is not known (NAN) leaves its cell empty. */
void csv_header(FILE *, Dialect, const char *const *names, int count);
/* The first cells of a row that goes on: numbers, and a word that needs no quotes (NULL: none). */
void csv_begin(FILE *, Dialect, const double *row, int count, const char *word);
void csv_row(FILE *, Dialect, const double *row, int count);

/* Words, in quotes where they hold a quote, a separator or a line end. A text that a spreadsheet would take
 * for a formula (it begins with = + - @ or a control character, and is not a number) gets an apostrophe in
 * front. */
void csv_words(FILE *, Dialect, const char *const *cells, int count);

#endif
