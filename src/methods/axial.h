/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the methods for the axial vibration of a bar share: the fields and series that both report under the
 * same names, and which of their particles bear the traction. Units: any consistent system; lengths, masses
 * and forces are per unit cross-section. */
#ifndef METHODS_AXIAL_H
#define METHODS_AXIAL_H

#include "methods/method.h"

/* The first fields of set 0, the particles: the columns of its table, in this order. Stress and strain are
 * something else in each method: these are the words for them. ROW says what a row of the method's table is.
 */
#define AXIAL_FIELD_ROWS(ROW, of_stress, of_strain)                                                          \
    ROW(X0, "x0", "x0", "length", "position at the start"), ROW(X, "x", "x", "length", "position"),          \
        ROW(U, "u", "displacement", "length", "displacement x - x0"),                                        \
        ROW(V, "v", "velocity", "length/time", "velocity"),                                                  \
        ROW(STRESS, "stress", "stress", "force/length^2", of_stress),                                        \
        ROW(STRAIN, "strain", "strain", "1", of_strain),                                                     \
        ROW(DENSITY, "density", "density", "mass/length^3", "density"),                                      \
        ROW(MASS, "mass", "mass", "mass/length^2", "mass per unit cross-section; constant")

/* Quantities of the series that both have: {AXIAL_...}. Momentum and reaction are on request, the latter
 * where an end is held. */
#define AXIAL_V_CM    "v_cm", "v_cm", "length/time", "velocity of the centre of mass"
#define AXIAL_X_CM    "x_cm", "x_cm", "length", "position of the centre of mass"
#define AXIAL_KINETIC "kinetic", "kinetic", "force/length", "kinetic energy of the particles"
#define AXIAL_WORK    "work", "work", "force/length", "work of the external force so far"
#define AXIAL_TOTAL                                                                                          \
    "total", "total", "force/length", "kinetic + strain; without loads it should keep its value"
#define AXIAL_MOMENTUM "momentum", "momentum", "mass/length/time", "momentum of all particles"
#define AXIAL_REACTION "reaction", "reaction", "force/length^2", "force of the supports on the bar, +x"

/* Of particles `spacing` apart: how many at a free end have their middle in the traction's layer h of paper
 * M, eq. 11. */
int axial_particles_in_layer(double layer, double spacing, int particles);

/* Is load.traction_layer sound? 0 stands for the spacing: the last particle. */
bool axial_check_layer(double layer, double spacing, double length, Status *status);

#endif
