/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The particle or node whose sums are written out, and what both meshes write of an exchange. */
#ifndef METHODS_MPM_SUBJECT_H
#define METHODS_MPM_SUBJECT_H

#include "methods/calculation.h"
#include "methods/method.h"

enum { SUBJECT_LINKS_MAX = 64 };

typedef struct Subject {
    const Simulation *sim;
    const void *before; /* the state before the stage; NULL: not known */
    int set, index;
    Link links[SUBJECT_LINKS_MAX];
    size_t n_links;
    Calculation *calculation;
} Subject;

Subject subject_of(const Simulation *, int set, size_t index, const void *before, Calculation *);

/* The product of a term's factors; *count 0: its numbers are not at hand at this stage. */
double subject_term(const Subject *, int exchange, size_t from, size_t to, int *count,
                    double factors[EXCHANGE_FACTORS_MAX]);

/* "m v N: 0.1 to 12 + 0.3 to 13 = 0.4": how what the subject gives is divided; `whole` is what the shares add
 * up to. */
void subject_write_given(const Subject *, int exchange, const char *label, double whole);

#endif
