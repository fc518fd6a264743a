/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Counts the callers between gsl_errors_off() and gsl_errors_on() (gsl_errors.h). */
#include "theory/gsl_errors.h"

#include <gsl/gsl_errno.h>
#include <math.h>
#include <pthread.h>

/* GSL's handler is global, so what counts its users has to be global too. */
static pthread_mutex_t lock = PTHREAD_MUTEX_INITIALIZER;
static int users;
static gsl_error_handler_t *before;

void gsl_errors_off(void)
{
    pthread_mutex_lock(&lock);
    if (users++ == 0)
        before = gsl_set_error_handler_off();
    pthread_mutex_unlock(&lock);
}

void gsl_errors_on(void)
{
    pthread_mutex_lock(&lock);
    if (--users == 0)
        gsl_set_error_handler(before);
    pthread_mutex_unlock(&lock);
}

bool gsl_can_converge(const gsl_matrix *matrix)
{
    for (size_t i = 0; i < matrix->size1; i++)
        for (size_t j = 0; j < matrix->size2; j++) {
            const double size = fabs(gsl_matrix_get(matrix, i, j));
            if (size != 0 && !(size >= 1e-250 && size <= 1e250))
                return false;
        }
    return true;
}
