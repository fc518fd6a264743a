/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The continuum's exact motion from any start, by its waves: a pulse that comes back from the ends, and a bar
 * of two materials, at whose joint a wave divides. What a bar of one material does besides - modes, loads -
 * is bar.h's, and is added here. Units: any consistent system. */
#ifndef THEORY_BAR_WAVES_H
#define THEORY_BAR_WAVES_H

#include "theory/bar.h"

/* Velocity, its slope and stress at t = 0: modes, and a pulse that is on its way to the right. */
double bar_waves_start_velocity(const BarTheory *, double x);
double bar_waves_start_slope(const BarTheory *, double x);
double bar_waves_start_stress(const BarTheory *, double x);

/* Whether the motion is known up to a time. A wave that meets the joint again and again divides each time:
 * of two materials it is followed through the joint BAR_WAVES_DIVIDED times, and no load is known. */
enum { BAR_WAVES_DIVIDED = 14 };
bool bar_waves_known(const BarTheory *, double end);

/* The fields and v_cm at a time up to which the motion is known. */
double bar_waves_displacement(const BarTheory *, double x, double t);
double bar_waves_velocity(const BarTheory *, double x, double t);
double bar_waves_stress(const BarTheory *, double x, double t);
double bar_waves_centre_velocity(const BarTheory *, double t);

/* E and rho at a place. */
double bar_waves_modulus(const BarTheory *, double x);
double bar_waves_density(const BarTheory *, double x);

/* What a joint sends back of a wave's velocity that comes from the left, and what it lets on:
 * (Z1 - Z2)/(Z1 + Z2) and 2 Z1/(Z1 + Z2), Z = sqrt(E rho). */
double bar_waves_reflected(const BarTheory *);
double bar_waves_transmitted(const BarTheory *);

#endif
