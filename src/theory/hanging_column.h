/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A bar that hangs from its left end at rest, exact at any strain where stress = E ln(stretch) and the
 * section stays as it is: at the place X of the bar without load hangs the weight rho b (L - X) below it.
 * Units: any consistent system. */
#ifndef THEORY_HANGING_COLUMN_H
#define THEORY_HANGING_COLUMN_H

typedef struct HangingColumn {
    double length, youngs_modulus, density, body_force;
} HangingColumn;

double hanging_column_stress(const HangingColumn *, double x);       /* rho b (L - X) */
double hanging_column_displacement(const HangingColumn *, double x); /* at a place of the bar without load */
double hanging_column_linear(const HangingColumn *,
                             double x);              /* the same for small strains, k (L X - X^2/2) */
double hanging_column_centre(const HangingColumn *); /* where the centre of mass hangs */

#endif
