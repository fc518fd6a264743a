/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The crack of the notched beam as it is shown on screen, on paper and in tables: the numbers that the method
 * measures, and those of paper P (figs. 9 and 10). Front ends call this, not the method. SI units; angles in
 * degrees between the notch and the way that the crack goes, positive towards larger x. */
#ifndef ANSWERS_CRACK_GROWTH_H
#define ANSWERS_CRACK_GROWTH_H

#include "scenario/assignment.h"
#include "methods/bonds/cracks/crack.h"
#include "methods/bonds/cracks/crack_cost.h"
#include "methods/bonds/cracks/fronts.h"

/* Paper P, section 3.3: the crack leaves the notch at about this angle. */
#define CRACK_PAPER_ANGLE 30.0
#define CRACK_PAPER_SLOPE 0.57735026918962576 /* its tangent, 1/sqrt(3) */

enum { CRACK_ANGLES = 3 };

typedef struct CrackFacts {
    Crack measured; /* tip, length, counts of bonds, times */
    double
        heights[CRACK_ANGLES]; /* above the notch's end (m) over which the angle is measured, as in fig. 10 */
    double angles[CRACK_ANGLES]; /* NAN: the tip has not come so far */
    double angle;                /* over the whole path; NAN: it has fewer than two rows */
} CrackFacts;

/* False: the simulation has no notch that a crack could begin at. At any stage of a step: bonds count as
 * broken from the stage of bond forces on, tip and path follow at the stage of damage. */
bool crack_facts(const Simulation *, CrackFacts *);

/* Where the energy of the broken bonds went, and what it is to be set beside. */
typedef struct CrackPrice {
    CrackCost cost;
    double critical_energy; /* G0, J/m^2 */
} CrackPrice;

/* Of the notched beam's crack or, where fronts are given, of theirs. False: there is no crack as yet, s0 was
 * changed on the way, or it was given up. It looks at every broken bond: for a table or a summary, not for
 * every row of a run. */
bool crack_price(const Simulation *, const Settings *, const CrackFronts *, const Cancel *, CrackPrice *);

/* What the cracks of a plate are judged by: the one that runs fastest, and the first that branched. */
typedef struct FrontsFacts {
    long broken;
    int n_tips;
    double fastest; /* m/s; NAN: too short a time */
    double angle;   /* of that one from its cut, degrees; NAN */
    bool branched;
    double branch[2], branch_time, half_angle;
    double surface_ratio; /* crack surface made over crack length; NAN: nothing broke */
} FrontsFacts;

void crack_fronts_facts(const CrackFronts *, FrontsFacts *);

/* Two lines of it, beside Rayleigh's speed; `microseconds` is how these are written. */
void crack_fronts_lines(const FrontsFacts *, double rayleigh, const char *microseconds, char first[160],
                        char second[160]);

/* The speed of a front at one of the times that are kept, m/s; NAN: too near to the first or last. */
double crack_speed_at(const CrackFronts *, const CrackFront *, size_t sample);

/* The speed that no crack of this kind reaches, m/s. */
double crack_rayleigh_speed(const Settings *);

/* The path from the notch's end upwards: x and y (m) of at most `max` rows of the lattice; returns how many.
 */
size_t crack_line(const Simulation *, double *x, double *y, size_t max);

/* The cracks of a run to be kept, with the notch or the cuts that they grew from: lines from place to place
 * in the body (m), as many places as a map can show. No places: nothing has cracked. */
enum { CRACK_LINE_MAX = 512 };
typedef struct CrackLine {
    size_t count;
    double x[CRACK_LINE_MAX], y[CRACK_LINE_MAX];
    bool begins[CRACK_LINE_MAX]; /* another line begins here */
} CrackLine;

/* `fronts`: those of a plate, or NULL. */
void crack_line_keep(const Simulation *, const Settings *, const CrackFronts *, CrackLine *);

#endif
