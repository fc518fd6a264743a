/* SPDX-License-Identifier: GPL-3.0-or-later */
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
#ifndef THEORY_STEP_MOTION_H
#define THEORY_STEP_MOTION_H

#include "theory/bar_motion.h"
#include "theory/elastic_bar.h"

/* NULL: not by FLIP with alpha = 1, by USL, loaded, with a pulse, an unstable step, more particles than
 * STEP_MOTION_MAX (all eigenvectors are needed), or not enough memory (errno ENOMEM). */
enum { STEP_MOTION_MAX = 400 };
BarMotion *step_motion(const BarTheory *, const BarMesh *);

#endif
