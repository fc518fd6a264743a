/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The largest courant number dt c / dx with which a bar at rest on its mesh stays bounded; of two materials
 * c is the faster one's.
 *
 * The eigenvalues of the linearised step first leave the unit circle at -1, and there the problem is
 * symmetric:
 *
 *     courant^2 = 2 / lambda_max(Z K)       USF, MUSL
 *     courant^2 = 2 / lambda_max((T - Z) K) USL
 *     Z = (1 + G)^-1 W,   W = T M_c T,   G = alpha + (1 - alpha) T M_c
 *
 * T gives nodal velocities from momenta: M_l^-1, the inverse of a mass blend, or FMPM's series; M_c is the
 * consistent mass (bar_rest.h), alpha the flip fraction (0 with APIC and FMPM). A wave
 * in an endless mesh has its own limit (dispersion_endless_courant); the ends lower it by up to 40 % for
 * B-splines.
 *
 * It is the limit at rest: a node that has lost nearly all its mass to a crossing lowers it. */
#ifndef THEORY_STEP_LIMIT_H
#define THEORY_STEP_LIMIT_H

#include "theory/elastic_bar.h"

/* On the bar with its supports and padding; of a longer bar the ends with 32 cells between them. INFINITY
 * where no node is free; NAN: not enough memory. */
double step_limit_with_ends(const BarTheory *, const BarMesh *);

/* The smaller of it and the endless mesh's: what a run keeps to. */
double step_limit(const BarTheory *, const BarMesh *);

#endif
