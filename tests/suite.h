/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What every unit test program shares: cases are collected in a suite, run by Check and told as TAP. */
#ifndef TESTS_SUITE_H
#define TESTS_SUITE_H

#include <check.h>

/* Each test program defines it: adds its cases to the suite. */
void add_cases(Suite *suite);

/* The path of a file of the source tree, e.g. source_path("tests/golden/mpm.txt"); valid until the next call.
 */
const char *source_path(const char *relative);

#endif
