/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fields of the particles along a bar, or along the middle row of a beam, at one moment: what a picture over
 * x shows of a run, and what is kept of one that has ended. */
#ifndef ANSWERS_PROFILE_H
#define ANSWERS_PROFILE_H

#include "methods/method.h"

enum { PROFILE_FIELDS = 5 };

typedef struct Profile {
    double time;
    size_t count; /* particles; 0: nothing is known */
    double *x;    /* their reference positions */
    int n_fields;
    const char *names[PROFILE_FIELDS];
    double *values[PROFILE_FIELDS]; /* count each */
} Profile;

/* The fields worth a picture, the first is shown first; NULL: there are no more of them. */
const char *profile_field(const Simulation *, int i);

/* Of a body that moves along as a whole what it does beside that: values are without simulation_carried().
 * One field of these by name, or all of them if it is NULL. False: no memory, or there is no such field; the
 * profile is empty then. */
bool profile_take(Profile *, const Simulation *, const char *field);
void profile_close(Profile *);

/* NULL: it was not taken. */
const double *profile_values(const Profile *, const char *field);

#endif
