/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers that a verification takes from a run; what `row` must hold for each stands after it. NAN where
 * the run has no such number. */
#ifndef CLI_VERIFY_VERIFY_QUANTITY_H
#define CLI_VERIFY_VERIFY_QUANTITY_H

#include "cli/verify/verify_row.h"

#define QUANTITY(name, value) double quantity_##name(VerifyRun *, const VerifyRow *);
#include "cli/verify/verify_quantity_rows.inc"
#undef QUANTITY

/* By how much the period is longer, percent; other: the scenario of the shorter one. */
double quantity_longer_than(VerifyRun *, const VerifyRow *);
double quantity_finding_order(VerifyRun *, const VerifyRow *);

/* A column of the series: its amplitude in from..to, of other's value at t = 0; the largest |column - other|;
 * the relative L2 of both in from..to, percent; the frequency of its highest line in from..to (Hz); the time
 * at which it comes to `from`. */
double quantity_amplitude_share(VerifyRun *, const VerifyRow *);
double quantity_furthest(VerifyRun *, const VerifyRow *);
double quantity_distance(VerifyRun *, const VerifyRow *);
double quantity_line(VerifyRun *, const VerifyRow *);
double quantity_first_above(VerifyRun *, const VerifyRow *);

/* Energy: mean of kinetic and strain over t >= to, over that until `from`; how far kinetic, strain and
 * dissipated together are from the work after `from`, largest, percent. */
double quantity_energy_left(VerifyRun *, const VerifyRow *);
double quantity_energy_off_work(VerifyRun *, const VerifyRow *);

/* The first of these over many starts, whose velocities lie within 1 % of the run's: `scale` of them are
 * below (0 the least, .5 the median, 1 the most). What is chaotic has no other number. */
double quantity_energy_left_of_starts(VerifyRun *, const VerifyRow *);

/* What all energies have gained at the end beyond the start and the work, percent of the work. */
double quantity_energy_gained(VerifyRun *, const VerifyRow *);

/* The bar: the smallest velocity with which a particle of the scenario leaves its cell, by bisection; the
 * largest courant number with which a motion of all waves stays bounded, likewise, between from and to. */
double quantity_crossing_velocity(VerifyRun *, const VerifyRow *);
double quantity_courant_limit(VerifyRun *, const VerifyRow *);

/* Beams: the surface factor of the node in the middle; the energy after `to` steps of `from` critical ones,
 * over that at the start. */
double quantity_middle_factor(VerifyRun *, const VerifyRow *);
double quantity_energy_after_steps(VerifyRun *, const VerifyRow *);

/* Bodies of a scenario that begin with a field of velocities: the largest stress off D eps of a uniform
 * stretch in one step, over the largest of these; off that of a rigid turn with the spin `from`, over
 * G spin dt. Blocks clamped at x = 0 and 1, nu = 0, in their first mode: the root
 * mean square of the error of the displacement, or of a field `column`, over the largest value of the motion,
 * at the cell size `from`; its order between that and `to`. */
double quantity_stretch_error(VerifyRun *, const VerifyRow *);
double quantity_turn_error(VerifyRun *, const VerifyRow *);

/* Of the bonds through a plane, stretched up to s0; J/m^2. */
double quantity_plane_energy(VerifyRun *, const VerifyRow *);

#endif
