/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a folder of tables is, for those who keep research data: an RO-Crate 1.1, the file
 * ro-crate-metadata.json beside the tables. It names each file with what it holds, the program and its
 * version, and the scenario from which the program writes the same bytes again. */
#ifndef LAB_CRATE_H
#define LAB_CRATE_H

#include "lab/export/export.h"

/* Whether the tables lie in one folder, which the crate is made of, and the metadata may be written there. */
bool crate_may_begin(const Outputs *, bool force, Status *);

/* Writes it after the tables. `date`: YYYY-MM-DD. */
bool crate_write(const Outputs *, const Settings *, const char *date, Status *);

#endif
