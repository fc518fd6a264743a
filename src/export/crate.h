/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a folder of tables is, for those who keep research data: an RO-Crate 1.1, the file
 * ro-crate-metadata.json beside the tables. It names each file with what it holds, the program and its
 * version, and the scenario from which the program makes the tables again. */
#ifndef EXPORT_CRATE_H
#define EXPORT_CRATE_H

#include "export/export.h"

enum { CRATE_TABLES_MAX = 4 };

typedef struct CrateTable {
    const char *file;        /* NULL: it is not made */
    const char *description; /* what it holds */
} CrateTable;

typedef struct Crate {
    CrateTable tables[CRATE_TABLES_MAX];
    const char *command; /* that made them: "matvib run" */
    const char *source;  /* what FILE.ini beside each table is; NULL: none stands there */
    Asker asker;
    bool force; /* metadata that exist may be replaced */
} Crate;

/* The tables of a run. */
Crate crate_of_run(const Outputs *);

/* Whether there are tables in one folder, which the crate is made of, and the metadata may be written there.
 */
bool crate_may_begin(const Crate *, Status *);

/* Writes it after the tables, of a run with such settings. `date`: YYYY-MM-DD. */
bool crate_write(const Crate *, const Settings *, const char *date, Status *);

#endif
