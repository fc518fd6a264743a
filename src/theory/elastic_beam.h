/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The right answers for beams: Euler-Bernoulli, Timoshenko, and the axially moving cantilever. SI units. */
#ifndef THEORY_ELASTIC_BEAM_H
#define THEORY_ELASTIC_BEAM_H

#include "base/cancel.h"
#include "base/status.h"

typedef struct BeamTheory {
    double length, height; /* m */
    double youngs_modulus, density;
    double poisson;   /* 1/3 with bonds; Euler-Bernoulli's beam knows none */
    double amplitude; /* U */
    double damping;   /* rate alpha: the acceleration is that of the forces less alpha v */
    double from_tip;  /* of a moving cantilever: the point that is looked at, so far before its tip, m */
    Cancel cancel;    /* asked while a motion is being solved */
} BeamTheory;

/* What damping makes of a period: 2 pi/sqrt((2 pi/T)^2 - alpha^2/4); NAN: it does not oscillate any more. */
double beam_damped_period(double period, double damping);

/* First period of the simply supported beam, s. Timoshenko: kappa 5/6, exact frequency equation. Plane: of
 * the plane problem itself (plane stress), whose ends are held across as whole sections and free along. */
double beam_period_euler(const BeamTheory *beam);
double beam_period_timoshenko(const BeamTheory *beam);
double beam_period_plane(const BeamTheory *beam);

/* The middle's displacement at rest under a body force of its mass, m/s^2: Timoshenko's beam between two
 * pins. */
double beam_sag(const BeamTheory *beam, double body_force);

/* The same at a place between the pins, 0 to length. */
double beam_sag_at(const BeamTheory *beam, double body_force, double x);

/* Mid-point displacement and velocity at a time, let go at U, for a period T that it has without damping. */
double beam_midpoint(const BeamTheory *beam, double period, double t);
double beam_midpoint_velocity(const BeamTheory *beam, double period, double t);

/* Stresses of the same motion at a place of the beam between two pins, y = 0 on its middle, Pa: bending,
 * straight over y and 0 in the middle, and shear, a parabola that is 0 at both edges. With Timoshenko's
 * period. */
double beam_bending_stress(const BeamTheory *beam, double x, double y, double t);
double beam_shear_stress(const BeamTheory *beam, double x, double y, double t);

/* The first angular frequency of a cantilever of the beam's section and of this length (its own does not
 * count): lambda_1^2 / length^2 sqrt(E h^2 / (12 rho)). */
double beam_cantilever_frequency(const BeamTheory *beam, double length);

/* The frequencies (radians per s, ascending) of the vibration through the thickness that leaves the middle's
 * two sides alike, as a run with steps of dt shows them (paper P, the fast lines of fig. 4). `stiffness`:
 * rows x rows, N/m^4, symmetric; `frequencies` takes at most `most`. Returns how many; without memory 0. */
int beam_thickness_modes(const double *stiffness, int rows, double density, double dt, double *frequencies,
                         int most);

/* Axially moving cantilever, Euler-Bernoulli on L(t) = L0 + v0 t, by modal equations; see the .c file. */
typedef struct MovingCantilever MovingCantilever;

/* Solves from 0 to `end`; NULL: the status says why (not enough memory, the solver gave up). */
MovingCantilever *moving_cantilever_solve(const BeamTheory *beam, double speed, double end, Status *status);
void moving_cantilever_free(MovingCantilever *solution);

/* Displacement (m) of the tip, or of the point `from_tip` before it, and its material velocity (m/s) at a
 * time in [0, end]. */
double moving_cantilever_tip(const MovingCantilever *solution, double t);
double moving_cantilever_tip_velocity(const MovingCantilever *solution, double t);

/* Stresses at a distance x from the root (the mouth of the channel; in the channel, x < 0, there are none), y
 * = 0 on the beam's middle, Pa: bending, straight over y, and shear, a parabola. `beam`: that which was
 * solved. NAN: beyond the tip, or the motion is too long for its modes to be kept. */
double moving_cantilever_bending_stress(const MovingCantilever *solution, const BeamTheory *beam, double x,
                                        double y, double t);
double moving_cantilever_shear_stress(const MovingCantilever *solution, const BeamTheory *beam, double x,
                                      double y, double t);

#endif
