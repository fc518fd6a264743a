/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files behind export.h share: a run under way, and its files. */
#ifndef EXPORT_EXPORT_INTERNAL_H
#define EXPORT_EXPORT_INTERNAL_H

#include "export/export.h"
#include "run/advance.h"
#include "run/record.h"

enum { TABLES = 3, TABLE_FIELDS_MAX = 32 };

/* A table of one set of things. */
typedef struct Table {
    const char *name;
    OutputFile file, beside;
    int set;
    bool indexed; /* else its first columns, whole numbers, say which thing it is */
    int fields[TABLE_FIELDS_MAX], n_fields;
    bool of_stages; /* all fields, after each stage of some steps */
} Table;

typedef struct Export {
    const Settings *settings;
    const Outputs *outputs;
    Run run;
    References *refs;
    Column columns[COLUMNS_MAX];
    int n_columns;
    int written[COLUMNS_MAX], n_written; /* those of the series, by output.columns */
    long planned_last;                   /* the run's own is another where it failed, or came to rest */
    Frames frames;
    size_t next_frame;
    OutputFile series, series_beside;
    Table tables[TABLES];
    OutputFile *vtk; /* one for each frame */
    OutputFile collection;
    Record record;
    double newest[COLUMNS_MAX]; /* the row of the newest step that has one */
    double invariant;           /* E* at t = 0; NAN: there is none */
    long rows;
} Export;

/* export_files.c: names are checked before anything is touched; then every file is begun. */
bool export_check_names(const Export *, Status *);
bool export_open_files(Export *, Status *);

/* A row of the series. */
bool export_write_row(Export *, const double *row, Status *);

/* The next frame: of the step at which the simulation stands, whichever was planned. */
bool export_write_frame(Export *, Status *);

/* The tables after a stage of a step. */
bool export_write_stage(Export *, long step, int stage, Status *);

/* The scenarios beside, and everything on the disk; then everything under its name. */
bool export_finish_files(Export *, Status *);
bool export_commit_files(Export *, Status *);
void export_close_files(Export *);

#endif
