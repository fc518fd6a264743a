/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The right answers for the axial vibration of a bar: the continuum's (exact) and the mesh's (predicted).
 *
 * Source: paper M, eqs. 16 to 20; the discrete dispersion relation is our own derivation for the material
 * point method on a regular mesh (see the manual page). Units: any consistent system. */
#ifndef THEORY_ELASTIC_BAR_H
#define THEORY_ELASTIC_BAR_H

#include "base/kinds.h"

#include <stdbool.h>

enum { BAR_MODES_MAX = 16 };

/* A bar that starts at rest in place, with velocity sum A_n phi_n(x), and loads that act from t = 0 on. */
typedef struct BarTheory {
    double length, youngs_modulus, density;
    bool left_fixed, right_fixed;
    int n_modes;
    struct {
        int number;      /* n >= 1; 0 is rigid motion of the free-free bar, and no motion of a held one */
        double velocity; /* A_n */
    } modes[BAR_MODES_MAX];
    double body_force; /* b, per unit mass */
    double traction;   /* t, at each free end, outwards positive */
    double joint;      /* where a second material begins; 0: the bar is of one */
    double joint_modulus, joint_density;
    bool of_sines; /* of two materials: it starts with the modes of a bar of one, and not with its own */
    struct {       /* bar_waves.h; what is here knows no pulse */
        double centre, width, velocity; /* v = velocity exp(-((x - centre)/width)^2); of velocity 0 none */
        double to_left; /* share of it that goes to the left, 0 to 1; the rest goes to the right */
    } pulse;
} BarTheory;

/* Whether the second material differs from the first. */
bool bar_is_layered(const BarTheory *bar);
double bar_modulus_at(const BarTheory *bar, double x); /* E and rho at a place */
double bar_density_at(const BarTheory *bar, double x);

double bar_wave_speed(const BarTheory *bar);              /* c = sqrt(E / rho), of the first material */
double bar_wave_number(const BarTheory *bar, int number); /* beta_n, eq. 17, of a bar of one material */
double bar_largest_wave_number(const BarTheory *bar, int number); /* omega_n over the slower speed */
double bar_frequency(const BarTheory *bar, int number);           /* omega_n, eq. 18, radians per unit time */
double bar_mode_shape(const BarTheory *bar, int number, double x); /* phi_n(x), eq. 16 */

/* What the bar starts with for mode n: phi_n, or of two materials, if it starts so, that of one. */
double bar_start_shape(const BarTheory *bar, int number, double x);
double bar_initial_velocity(const BarTheory *bar, double x); /* eq. 19 with overtones */
double bar_initial_slope(const BarTheory *bar, double x);    /* its derivative by x */

/* How much of mode n is in a velocity of the shape of mode `start` of a bar of one material:
 * int rho phi s dx / int rho phi^2 dx; times the mean of the mode over the mass, for v_cm. */
double bar_share_of_sine(const BarTheory *bar, int start, int number);
double bar_mode_mean(const BarTheory *bar, int number);

/* The continuum's fields and means at a time; loads by superposition (d'Alembert), of a bar of one material.
 * A body force accelerates the free-free bar as a whole. Of two materials that start with sines the motion
 * is not here (bar_waves.h). Beyond the bar's ends there is no answer. */
double bar_displacement(const BarTheory *bar, double x, double t);
double bar_velocity(const BarTheory *bar, double x, double t);
double bar_stress(const BarTheory *bar, double x, double t);
double bar_centre_velocity(const BarTheory *bar, double t); /* v_cm, eq. 20 */

/* The mesh on which the answer is predicted. */
typedef struct BarMesh {
    double cell_size;
    int particles_per_cell;
    double offset; /* of particles from the middle of their share of a cell, in such shares */
    MpmAlgorithm algorithm;
    MpmShape shape; /* CPDI is GIMP: at rest they are the same; UNIFORM3 is BSPLINE3 */
    bool apic;
    double flip_fraction;
    double consistent; /* share of consistent mass in M = consistent M_c + (1 - consistent) M_l: 1 - mu */
    int fmpm_order;    /* 0: no FMPM */
    double dt;
} BarMesh;

/* Discrete frequency and decay of one wave number in an endless mesh. */
typedef struct Dispersion {
    bool known;        /* false: shorter than two cells, or the step is beyond the stability limit */
    double space_only; /* omega_h: the mesh without time stepping */
    double frequency;  /* Omega, as a run shows it */
    double decay;      /* amplitude ~ exp(-decay t) */
    double filter;     /* F: what particle -> node -> particle leaves of the wave (APIC: Fa) */
    double moves;      /* T: nodal velocity over p/m; 1 with lumped masses */
} Dispersion;

Dispersion dispersion_of_bar(const BarTheory *bar, const BarMesh *mesh, double wave_number);

/* The largest Courant number dt c / dx at which no wave of the endless mesh grows: the least over the angles
 * of the mesh's dispersion relation. mesh->dt does not matter. (Of a bar with its ends: step_modes.h.) */
double dispersion_endless_courant(const BarMesh *mesh);

#endif
