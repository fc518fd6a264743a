/* SPDX-License-Identifier: GPL-3.0-or-later */
/* --crate: the description of what a command has written. */
#ifndef CLI_DESCRIBE_H
#define CLI_DESCRIBE_H

#include "cli/options.h"
#include "export/crate.h"

/* Whether it may be written, before anything is; true where it was not asked for. */
bool describe_may_begin(const Options *, const Crate *, Status *);

/* Writes it after the tables, if it was asked for. */
bool describe(const Options *, const Crate *, const Settings *, Status *);

#endif
