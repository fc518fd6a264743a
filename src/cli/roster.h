/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of a class, as a course or a spreadsheet exports it. */
#ifndef CLI_ROSTER_H
#define CLI_ROSTER_H

#include "cli/students.h"

/* Reads names and ID numbers from a table with a head ("Full name", or "First name" and "Surname"; "ID
 * number" or "Email address" where there is one), its cells separated by commas, semicolons or tabs. False:
 * "FILE:LINE: what is wrong (what is allowed)". */
bool roster_read(const char *file, Students *, Status *);

#endif
