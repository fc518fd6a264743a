/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sharp invariant of the bar: its energy without the ripple.
 *
 * Velocities and stresses of the material point method are known half a step apart, so kinetic and strain
 * energy at the same step do not belong together and their sum ripples. What belongs together is
 *
 *     E* = sum of m v^n v^{n+1} / 2 + strain energy of the stress that turns v^n into v^{n+1}:
 *
 * the new one with USF, the old one with MUSL and USL. A loss of energy is measured by it wherever it exists.
 */
#ifndef ANSWERS_INVARIANT_H
#define ANSWERS_INVARIANT_H

#include "scenario/assignment.h"
#include "methods/method.h"

/* Whether there is one: bars without a load, velocities by FLIP alone; else E* is not what is kept. */
bool invariant_exists(const Settings *);

/* E* of a simulation between steps, with the settings in force at its step, worked out by one step ahead; the
 * simulation stands where it stood afterwards. NAN: the step failed, or no memory. */
double invariant_now(Simulation *, const Settings *);

#endif
