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
#include "theory/bar_motion.h"

/* On the bar with its supports and padding; of a longer bar the ends with 32 cells between them. INFINITY
 * where no node is free; NAN: not enough memory. */
double step_limit_with_ends(const BarTheory *, const BarMesh *);

/* The smaller of it and the endless mesh's: what a run keeps to. */
double step_limit(const BarTheory *, const BarMesh *);

/* v_cm(t) of a bar by the material point method with the ends, shapes and materials that it has.
 *
 * With FLIP, no velocity is filtered, and of particles at rest in their places every step of USF or MUSL does
 *
 *     v_p'' = -sum_i N_i a_i,   a = M^-1 K M^-1 p,   p_i = sum_p m N_i v_p
 *
 * in steps of dt (a second difference in place of the derivative). y = sqrt(m) v makes that symmetric,
 *
 *     y'' = -S y,   S = R^T K R,   R = M^-1 C,   C_ip = sqrt(m_p) N_i(x_p)
 *
 * over the particles, with M the mass blend and the rows of held nodes left out. What the grid cannot see has
 * omega = 0: the offset of v_cm. */

/* NULL: not by FLIP with alpha = 1, by USL, loaded, with a pulse, an unstable step, more particles than
 * STEP_MOTION_MAX (all eigenvectors are needed), or not enough memory (errno ENOMEM). */
enum { STEP_MOTION_MAX = 400 };
BarMotion *step_motion(const BarTheory *, const BarMesh *);

#endif
