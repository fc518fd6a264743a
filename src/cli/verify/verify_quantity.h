/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Numbers that a verification takes from a run; what `row` must hold for each stands after it. NAN where
 * the run has no such number. */
#ifndef CLI_VERIFY_QUANTITY_H
#define CLI_VERIFY_QUANTITY_H

#include "cli/verify/verify_row.h"

/* The readout, as `matvib run` prints it. */
double quantity_measured(VerifyRun *, const VerifyRow *);        /* frequency or period */
double quantity_predicted(VerifyRun *, const VerifyRow *);       /* likewise */
double quantity_exact(VerifyRun *, const VerifyRow *);           /* likewise */
double quantity_measured_over(VerifyRun *, const VerifyRow *);   /* a derived number; column: its name */
double quantity_percent_over(VerifyRun *, const VerifyRow *);    /* the same less 1, percent */
double quantity_frequency_error(VerifyRun *, const VerifyRow *); /* against exact, percent */
double quantity_predicted_frequency_error(VerifyRun *, const VerifyRow *);
double quantity_period_error(VerifyRun *, const VerifyRow *);
double quantity_predicted_period_error(VerifyRun *, const VerifyRow *);
double quantity_kept(VerifyRun *, const VerifyRow *); /* share of the energy that one period keeps */
double quantity_predicted_kept(VerifyRun *, const VerifyRow *);
double quantity_decay_ratio(VerifyRun *, const VerifyRow *);    /* rate of decay, measured over predicted */
double quantity_derived_number(VerifyRun *, const VerifyRow *); /* column: its name */
double quantity_longer_than(VerifyRun *,
                            const VerifyRow *); /* period, percent; other: the scenario of the shorter */

/* A finding at the end of the run, and the right one beside it; column: its name, scale. */
double quantity_finding(VerifyRun *, const VerifyRow *);
double quantity_exact_finding(VerifyRun *, const VerifyRow *);

/* A column of the series. */
double quantity_value_at(VerifyRun *, const VerifyRow *);   /* column, from: the time */
double quantity_other_at(VerifyRun *, const VerifyRow *);   /* the same of the other column */
double quantity_mean_share(VerifyRun *, const VerifyRow *); /* column over other, means of from..to */
double quantity_amplitude_share(VerifyRun *,
                                const VerifyRow *);         /* column from..to, of other's value at t = 0 */
double quantity_furthest(VerifyRun *, const VerifyRow *);   /* largest |column - other| */
double quantity_first_peak(VerifyRun *, const VerifyRow *); /* column */
double quantity_first_peak_time(VerifyRun *, const VerifyRow *);
double quantity_largest(VerifyRun *, const VerifyRow *);
double quantity_largest_time(VerifyRun *, const VerifyRow *);
double quantity_zero_over_other(VerifyRun *, const VerifyRow *); /* over that of other's */
double quantity_distance(VerifyRun *,
                         const VerifyRow *); /* relative L2 of column and other in from..to, percent */
double quantity_swing_ratio(VerifyRun *,
                            const VerifyRow *); /* largest |column| from `to` on, over that until `from` */
double quantity_other_swing_ratio(VerifyRun *, const VerifyRow *); /* the same of the other column */
double quantity_line(VerifyRun *,
                     const VerifyRow *); /* frequency of column's highest line in from..to (Hz) */
double quantity_first_above(VerifyRun *, const VerifyRow *); /* time at which column comes to `from` */

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

/* The crack. */
double quantity_first_break(VerifyRun *, const VerifyRow *);
double quantity_twentieth_break(VerifyRun *, const VerifyRow *);
double quantity_plane_energy(VerifyRun *,
                             const VerifyRow *); /* up to s0, of the bonds through a plane; J/m^2 */
double quantity_broken_bonds(VerifyRun *, const VerifyRow *);
double quantity_angle_over(VerifyRun *, const VerifyRow *);   /* degrees over the height `from` */
double quantity_angle_turned(VerifyRun *, const VerifyRow *); /* over the height `to` less that over `from` */

/* The first crack of a plate (fronts.h): verify_front_quantity.c. */
double quantity_branch_x(VerifyRun *, const VerifyRow *);
double quantity_branch_time(VerifyRun *, const VerifyRow *);
double quantity_half_angle(VerifyRun *, const VerifyRow *);  /* degrees */
double quantity_front_speed(VerifyRun *, const VerifyRow *); /* the largest, m/s */
double quantity_front_angle(VerifyRun *, const VerifyRow *); /* degrees against the cut, over `from` */

#endif
