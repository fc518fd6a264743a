/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keeps GSL from ending the program.
 *
 * GSL's default error handler calls abort(); here errors are Status values. The handler belongs to the whole
 * process, so this is the one place that touches it: between quiet_begin() and quiet_end() it is off, and
 * when the last of several threads has left, the handler that was there before is back. */
#ifndef THEORY_QUIET_H
#define THEORY_QUIET_H

void quiet_begin(void);
void quiet_end(void);

#endif
