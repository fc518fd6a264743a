/* What the words of a bar's stages are made of: the sums of one particle or node, term by term. For
 * bar_explain.c only. */
#ifndef PHYSICS_MPM_BAR_SUMS_H
#define PHYSICS_MPM_BAR_SUMS_H

#include "physics/mpm_bar/bar_state.h"
#include "physics/calculation.h"

enum { LINKS_MAX = 64 };

/* What is asked about. */
typedef struct BarSubject {
    const Bar *bar;
    const void *before; /* the state before the stage; NULL: not known */
    int set, index;
    Link links[LINKS_MAX];
    size_t n_links;
    Calculation *calculation;
} BarSubject;

/* A label of a node: "p13 = " from "p%d = ". */
typedef struct BarLabel {
    char text[48];
} BarLabel;

BarLabel bar_label(const char *before, int node, const char *after);

/* What the subject's links give to it: adds terms and scale to the sum, returns what they come to. */
double bar_add_gifts(const BarSubject *, BarExchange, CalculationSum *);

/* "m v N: 0.1 to 12 + 0.3 to 13 = 0.4": how the chosen particle deals out. */
void bar_say_shares(const BarSubject *, BarExchange, const char *label, double whole);

/* "v13 = p/m = 0.2 / 0.5 = 0.4": over the mass of the chosen node. */
void bar_say_ratio(const BarSubject *, const char *label, double above, double result);

#endif
