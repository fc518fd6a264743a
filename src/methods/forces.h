/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What acts from outside, a row for each term. The stage that adds them, the sum under it and the field are
 * worded by the rows that are at work, so that the screen cannot show another force than the one that acts;
 * a definition may bring rows of its own. */
#ifndef METHODS_FORCES_H
#define METHODS_FORCES_H

#include "methods/method.h"

typedef struct ForceTerm {
    const char *name;     /* "spring to the ground" */
    const char *equation; /* as the stage has it: "Σ N_i m_p b" */
    const char *load;     /* of one particle, in ASCII: "m b" */
    const char *sentence; /* what it does; NULL: the name says it */

    /* The same as a number, along an axis (0 is x), in the method's unit of a particle's load: a force per
     * unit cross-section, of bonds a force density. Called of the simulation as it is. */
    double (*on)(const Simulation *, size_t particle, int axis, const void *context);
    const void *context;
} ForceTerm;

enum { FORCE_TERMS_MAX = 6, FORCE_WORDS_MAX = 400 };

/* The terms at work. */
typedef struct ForceTerms {
    int count;
    const ForceTerm *terms[FORCE_TERMS_MAX];
} ForceTerms;

/* Adds one; and those of a definition, ended by one without a name (NULL: none). */
void forces_add(ForceTerms *, const ForceTerm *);
void forces_add_all(ForceTerms *, const ForceTerm *);

/* What they are together on a particle. */
double forces_on(const ForceTerms *, const Simulation *, size_t particle, int axis);

/* The same of the rows of a definition alone. */
double forces_of_definition(const ForceTerm *, const Simulation *, size_t particle, int axis);

/* "A + B" of their equations and loads, "force of a and b", and their sentences; words for none too. */
typedef struct ForceWords {
    char equation[FORCE_WORDS_MAX], load[120], meaning[160], sentence[FORCE_WORDS_MAX];
} ForceWords;

void forces_word(const ForceTerms *, ForceWords *);

/* Words a stage that adds them to what bonds have left: "f(i) += A + B". */
void forces_word_stage(const ForceTerms *, ForceWords *, Stage *);

#endif
