/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The material point method on a bar (axial vibration), one-dimensional.
 *
 * Source: A. da Silva Rocha, "Unidimensional Axial Vibration Using MPM" (paper M); equation numbers are its.
 * Units: any consistent system; lengths, masses and forces are per unit cross-section. */
#ifndef METHODS_MPM_MPM_BAR_H
#define METHODS_MPM_MPM_BAR_H

#include "base/kinds.h"
#include "base/cancel.h"
#include "methods/forces.h"

/* What a bar is made of and how it is discretised. */
typedef struct BarDef {
    double length;         /* L > 0; a whole number of cells */
    double youngs_modulus; /* E > 0 */
    double density;        /* rho > 0 */
    BarSupports supports;

    double joint;         /* from here on the bar is of a second material: a node inside it; 0: of one */
    double joint_modulus; /* E > 0 of the second material; */
    double joint_density; /* rho > 0 */

    double cell_size;       /* dx > 0 */
    int particles_per_cell; /* P, 1 to 8 */
    double offset;          /* of particles from the middle of their share of a cell, in such: -1/2 to 1/2 */
    int padding;            /* cells beyond each free end, >= 0 */

    double body_force;     /* b, per unit mass (eq. 11) */
    double traction;       /* t at each free end, outwards positive (eq. 11) */
    double traction_layer; /* h of eq. 11; 0: dx / P, the last particle at each free end */

    MpmAlgorithm algorithm;
    MpmShape shape;
    MpmTransfer transfer;
    double flip_fraction; /* alpha: 1 is FLIP, 0 is PIC; FLIP transfer only */
    int fmpm_order;       /* k of FMPM(k), 1 to FMPM_ORDER_MAX; 1 is PIC */
    double mass_blend;    /* mu: 1 lumped masses, less: M = (1 - mu) M_c + mu M_l; 0: bar_mass_blend_auto() */

    int mistake;           /* what a wrong code does instead: an index of bar_mistake_words; 0: none */
    bool conceals_mistake; /* its stage is worded as the right one */
    int mistake_beside;    /* what it does besides, in another place; it stays to the end */

    double courant; /* dt = courant * dx / c, c = sqrt(E / rho) (eq. 21), of two materials the larger c */

    Cancel cancel; /* asked while the bar is being built, with share 0 first */

    /* The particle velocity at t = 0 (eq. 19 and its overtones); NULL: at rest. */
    double (*initial_velocity)(double x, const void *context);
    /* Its slope dv0/dx, the affine velocities with which APIC's particles start; NULL: they start from 0. */
    double (*initial_slope)(double x, const void *context);
    /* The stress at t = 0, of which each cell's particles take their mean: what differs within a cell the
     * grid cannot see, and it would stay. NULL: none. */
    double (*initial_stress)(double x, const void *context);
    const void *initial_context; /* of all; used during bar_create only */

    const ForceTerm *forces; /* beside those of the load (eq. 11), ended by one without a name; NULL: none */
} BarDef;

/* The mass blend mu* that takes the error of order (dx/wavelength)^2 out of the frequency, that of the time
 * step included: what is left is of fourth order, for small motions of a uniform bar (transfer FLIP). C is
 * the Courant number, of a bar of two materials that of the faster one; where the speeds differ no share
 * serves both.
 *
 *     mu*(C) = 1/2 - (B - C^2/12)/(2 A), at most 1
 *     hat, uGIMP, CPDI:  A = 1/6 + 1/(12 P^2),  B = 1/12:  mu* = 1/2 - (1 - C^2) P^2/(4 P^2 + 2)
 *     B-spline 2:        A = 1/4,  B = 1/4 + 1/(12 P^2):   mu* = (C^2 - 1/P^2)/6
 *     B-spline 3:        A = B = 1/3:                      mu* = C^2/8
 *
 * Of uniform B-splines 2 and odd P, which have a particle at a knot, B = 1/4 - 1/(6 P^2).
 *
 * Of B-splines it is mostly below what is allowed: bar_check() refuses it then. "Mass blend" and mu* are
 * words of our own; blends of lumped and consistent mass are as old as finite elements. */
double bar_mass_blend_auto(MpmShape shape, int particles_per_cell, double courant);

/* The mistakes that such codes make, "none" first, ended by NULL; each at its index. They are defined for
 * lumped masses on a bar of one material, some for one algorithm, shape or transfer alone. Those of the start
 * or of a factor cannot come or go in mid-run. */
extern const char *const bar_mistake_words[];
bool bar_mistake_is_of_start(int mistake);
const char *bar_mistake_sentence(int mistake); /* what is done, in one sentence; NULL: no mistake */

/* Whether the bar is to start with modes of a bar whose right end is held as the left one is. */
bool bar_mistake_starts_as_held(int mistake);

/* Whether nodes of tiny mass act on the particles beside them: a hat's slope does not vanish where the hat
 * does, and by its slope APIC's C takes the velocity of a node that an end has just passed, whose f/m is
 * rounding over next to nothing. Written so wherever such a run may fail. */
static inline bool bar_feels_light_nodes(const BarDef *def, MpmTransfer transfer)
{
    return transfer == MPM_APIC && def->shape == MPM_HAT && def->supports != BAR_FIXED_FIXED;
}
#define BAR_LIGHT_NODES "APIC with hats lets round-off grow at nodes of tiny mass beside a moving end"

/* Below this the matrix may be nearly singular where particles are few: see bar_check(). */
#define BAR_MASS_BLEND_LEAST 0.05

/* Is the definition sound? Else the status names the key as in a scenario file, what is wrong, what is
 * allowed. bar_create() is given what is. */
bool bar_check(const BarDef *definition, Status *status);

/* Builds the simulation at t = 0. NULL: the status says what is wrong with the definition or that there is
 * not enough memory. Fields: particles x0 x u v stress strain density mass (the CSV columns, in this order,
 * with APIC also affine), then what only the screen shows; nodes x mass momentum velocity f_int f_ext f, then
 * likewise. Series: v_cm x_cm kinetic kinetic_grid kinetic_null strain work total (the fourth and fifth may
 * be left out; total = kinetic + strain; less the work it keeps its value).
 *
 * A run fails, with particle, step and time in its status, when a particle leaves the mesh, when 1 + de <= 0
 * for one (or one overtakes its neighbour), and when the energy is more than 1e4 times what the start and the
 * load have put in: looked at after each step that is a multiple of 64, where growth by 10 %, to twice, 10,
 * 100 and 1000 times is reported too. Heating by cell crossing stays far below.
 *
 * Live parameters: mpm.algorithm, mpm.transfer, mpm.flip_fraction, mpm.fmpm_order,
 * mpm.mass_blend, mpm.mistake, load.body_force, load.traction. They belong to the state: a snapshot that is
 * put back brings those of its time, and the stages that go with them. */
Simulation *bar_create(const BarDef *definition, Status *status);

#endif
