/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What every unit test program shares: cases are collected in a suite, run by Check and told as TAP. */
#ifndef TESTS_SUITE_H
#define TESTS_SUITE_H

#include <check.h>
#include <stdbool.h>

/* Check tells its parent of every assertion that holds, by calls of the system: in loops dearer than what is
 * tested. Where one fails is told anyway; a crash is told with its case alone. */
#define _mark_point(file, line) ((void)0)

/* Each test program defines it: adds its cases to the suite. */
void add_cases(Suite *suite);

/* Called by add_cases() where a case ends the process or changes what the next one starts from: each case
 * runs in a process of its own. Elsewhere all run in one, which is faster by a third; with MATVIB_WIDE or
 * CK_FORK=yes each has its own, and a crash names its case. */
void suite_fork(void);

/* The path of a file of the source tree, e.g. source_path("tests/golden/mpm.txt"); valid until the next call.
 */
const char *source_path(const char *relative);

/* The text is that of a file of the source tree, or the test fails and tells the rows that differ;
 * MATVIB_REGENERATE in the environment: the file is written anew. `what` names it in the message. */
void suite_compare(const char *relative, const char *text, const char *what);

/* Whether every case is requested (MATVIB_WIDE is set, as check-long does). Where it is not, a test that
 * crosses bodies, sizes and glyphs takes a part of the crossings, always the same and each of them once. */
bool suite_wide(void);
/* Or every repetition of them too: MATVIB_LONG, which check-long sets. */
bool suite_long(void);
/* Whether this is a build for the sanitizers, which look at each access and make computing ten times as long:
 * runs that are there for their numbers alone are left to the other builds, and walks are shorter. */
bool suite_sanitized(void);

#endif
