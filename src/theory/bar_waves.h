/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The continuum's exact motion from any start, by its waves: a pulse that comes back from the ends, and a bar
 * of two materials, at whose joint a wave divides. What a bar of one material does besides - modes, loads -
 * is elastic_bar.h's, and is added here. Units: any consistent system. */
#ifndef THEORY_BAR_WAVES_H
#define THEORY_BAR_WAVES_H

#include "theory/elastic_bar.h"

/* Velocity, its slope and stress at t = 0: modes, and a pulse on its way. */
double bar_waves_start_velocity(const BarTheory *, double x);
double bar_waves_start_slope(const BarTheory *, double x);
double bar_waves_start_stress(const BarTheory *, double x);

/* Whether the motion is known up to a time. Of two materials a wave divides each time it meets the joint;
 * what has gone i times to and fro in the one and j times in the other is there at the same time, whatever
 * the order, so that there are as many waves as such pairs: of up to BAR_WAVES_MOST the motion is known. What
 * starts with modes of the bar itself is known for ever, and of two materials no load is. */
enum { BAR_WAVES_MOST = 4096 };
bool bar_waves_known(const BarTheory *, double end);

/* The fields and v_cm at a time; NAN where that needs more waves. */
double bar_waves_displacement(const BarTheory *, double x, double t);
double bar_waves_velocity(const BarTheory *, double x, double t);
double bar_waves_stress(const BarTheory *, double x, double t);
double bar_waves_centre_velocity(const BarTheory *, double t);

/* What a joint sends back of a wave's velocity that comes from the left, and what it lets on:
 * (Z1 - Z2)/(Z1 + Z2) and 2 Z1/(Z1 + Z2), Z = sqrt(E rho). */
double bar_waves_reflected(const BarTheory *);
double bar_waves_transmitted(const BarTheory *);

#endif
