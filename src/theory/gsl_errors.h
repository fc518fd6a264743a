/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Keeps GSL from ending the program.
 *
 * GSL's default error handler calls abort(); here errors are Status values. The handler belongs to the whole
 * process, so this is the one place that touches it: between gsl_errors_off() and gsl_errors_on() it is off,
 * and when the last of several threads has left, the handler that was there before is back. */
#ifndef THEORY_GSL_ERRORS_H
#define THEORY_GSL_ERRORS_H

#include <gsl/gsl_matrix.h>
#include <stdbool.h>

void gsl_errors_off(void);
void gsl_errors_on(void);

/* Whether gsl_eigen_symm() and gsl_eigen_symmv() come to an end with a matrix. They go on until an entry
 * beside the diagonal is below eps of its neighbours there, which never comes where eps times these
 * underflows; and they count no turns. True: all entries are 0 or from 1e-250 to 1e250 in size. */
bool gsl_can_converge(const gsl_matrix *);

#endif
