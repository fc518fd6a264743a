/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What is told of the stress in the plane. Pa, tension positive. */
#ifndef ANSWERS_STRESS_H
#define ANSWERS_STRESS_H

typedef struct Principal {
    double most, least; /* the two principal stresses */
    double angle;       /* of the direction of the first, radians from x towards y, -pi/2 to pi/2 */
} Principal;

Principal stress_principal(double xx, double yy, double xy);

#endif
