/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bond-based peridynamics on beams and plates, two-dimensional (plane stress, Poisson's ratio 1/3), and on a
 * bar, which is a lattice of one row (axial vibration).
 *
 * Source: Chen, Liu, Yang, "The application of peridynamics in predicting beam vibration and impact damage"
 * (2015; paper P); equation numbers are its. SI units; forces and energies are those of the beam, that is per
 * unit thickness times the thickness; those of a bar, in any consistent system of units, per unit
 * cross-section.
 *
 * On a line |xi + eta| - |xi| is eta sign(xi + eta) itself, so the stretch is linear in the displacements as
 * long as no node overtakes another. A fixed end is the middle between its first node and that node's mirror
 * image: beyond it lie mirrored nodes, u(-X) = -u(X), whose bonds are like all others. So the end itself
 * stays at rest, no node lacks partners there, and sin(n pi X / L) is an exact mode of the bar that is fixed
 * at both ends. A free end has nothing beyond it: its nodes lack partners and are too soft. */
#ifndef METHODS_BONDS_PLANE_BONDS_PLANE_H
#define METHODS_BONDS_PLANE_BONDS_PLANE_H

#include "base/kinds.h"
#include "base/cancel.h"
#include "methods/forces.h"
#include "methods/bonds/plane/lattice/volume.h"
#include "methods/bonds/plane/plate/plate.h"

typedef enum BeamProblem {
    BEAM_SIMPLY_SUPPORTED,
    BEAM_MOVING_CANTILEVER,
    BEAM_NOTCHED,
    BEAM_PLATE,
    BEAM_BAR /* height, thickness and threads do not count */
} BeamProblem;
typedef struct BeamDef {
    BeamProblem problem;
    double length, height, thickness; /* m */
    double youngs_modulus, density;   /* Pa, kg/m^3 */

    double horizon, spacing; /* delta and dx, m */
    SurfaceCorrection surface_correction;
    VolumeCorrection volume_correction;
    Influence influence;
    Stepping stepping;
    double critical_stretch; /* s0; 0: bonds never break */
    double protected_depth;  /* bonds nearer than this to load or supports never break, m */

    double amplitude; /* U of eqs. 15 to 18, m; beams that vibrate */

    double speed, channel; /* v0 and the length behind the clamp; moving cantilever */
    Clamp clamp;

    double notch_position, notch_depth; /* notched beam */
    double load_stress, load_ramp, load_position, load_width;
    double support_left, support_right;
    bool pinned; /* ux of the left support is fixed too */

    bool left_fixed, right_fixed; /* bar, of a whole number of spacings */
    double traction;              /* at each free end, outwards positive */
    double traction_layer;        /* depth over which it is spread; 0: a spacing, the last node */
    double (*initial_velocity)(double x, const void *context); /* of its nodes at t = 0; NULL: at rest */
    const void *initial_context;                               /* used during beam_create() only */

    PlateDef plate;    /* what a plate has */
    double body_force; /* on every node from t = 0 on, upwards, m/s^2; -9.81: weight; on a bar along x */
    const ForceTerm *forces; /* beside weight and loads, as force densities, along x and y; NULL: none */
    double damping; /* rate alpha, 1/s: the acceleration is f/rho - alpha v (bonds_damping.c); 0: none */
    bool critically_damped; /* alpha is twice the lowest frequency of the lattice instead */
    bool to_rest;           /* the run is over when the motion is ... */
    long changes_until;     /* ... and this many steps are done: Method.change is to be called till then */

    int mistake;           /* what a wrong code does instead: an index of beam_mistake_words; 0: none */
    bool conceals_mistake; /* its stages are worded as the right ones */
    bool step_is_known;    /* to be stable, or to be run all the same: of a given dt */
    int mistake_beside;    /* what it does besides, in another place; it stays to the end */

    double dt;   /* s; 0: half the critical time step, but not on a bar */
    double end;  /* s: the channel must hold the beam until then; moving cantilever */
    int threads; /* at least 1 */

    Cancel cancel; /* asked while the beam is being built, with share 0 first */
} BeamDef;

/* The names of the steppings: "symplectic Euler (kick first)"; NULL: velocity Verlet. */
const char *beam_stepping_name(int stepping);

/* The mistakes that such codes make, "none" first, ended by NULL; each at its index. They are defined for
 * whole bonds of one stiffness without damping. Those of the start, the family or a factor cannot come or go
 * in mid-run. */
extern const char *const beam_mistake_words[];
bool beam_mistake_is_of_start(int mistake);
const char *beam_mistake_sentence(int mistake); /* what is done, in one sentence; NULL: no mistake */

/* Is the definition sound? Else the status names the key as in a scenario file, what is wrong, what is
 * allowed. beam_create() is given what is. */
bool beam_check(const BeamDef *definition, Status *status);

/* The first cut of a plate that runs along nodes of its lattice, so that it is one-sided; `outer`: that parts
 * nothing, for it runs along an edge. -1: there is none. */
int beam_find_cut(const BeamDef *definition, bool outer);

/* Builds the simulation at t = 0. NULL: the status names the scenario key that is wrong ("notch.position:
 * ..."), or says that there is not enough memory.
 *
 * Sets: 0 particles (the nodes of the lattice), 1 bonds, of a bar those between two of its nodes; their
 * fields and the series are the tables of bonds_fields.c and bonds_series.c. Bonds that the notch or a cut
 * parts broke in step 0. Live parameters: bonds_state.c. A bar's run fails when a node comes nearly a spacing
 * nearer to its neighbour (at a fixed end: its own image), or a spacing further away: beyond the critical
 * time step that is where it ends. The crack as the paper speaks of it (first break, tip, angle, arrival):
 * crack.h. */
Simulation *beam_create(const BeamDef *definition, Status *status);

/* What the lattice came to; for the read-only rows and the tables. */
typedef struct BeamFacts {
    double micromodulus;  /* c of eq. 4, N/m^5: of a plane, so per unit thickness; conical: of |xi| = 0 */
    double modulus;       /* of a bar: E that a uniform strain finds far from the ends */
    double end_factor;    /* of a bar: g of the last node at a free end; 1: no correction, or no free end */
    int nx, ny;           /* columns and rows of nodes */
    double real_height;   /* ny dx */
    double real_span;     /* distance of the supports as the nodes lie */
    size_t family;        /* bonds of a node in the bulk */
    size_t bonds;         /* each counted once, before the notch */
    size_t notch_bonds;   /* of these cut by the notch, or by the cuts of a plate */
    double critical_step; /* 2 / omega_max, s: of a bar as its ends are, else with no node held */
    double damping;       /* alpha in use, 1/s */
} BeamFacts;

void beam_facts(const Simulation *beam, BeamFacts *facts);

/* The critical step of a bar before there is a simulation. False: memory is short, or given up. */
bool bonds_line_critical_step(const BeamDef *definition, double *step, Status *status);

/* The frequency of a wave in a bar of bonds far from its ends, before time is cut into steps: the dispersion
 * relation of S. A. Silling (2000), section 6, summed over the lattice. For long waves, with partial volumes
 * and delta a whole number of spacings, it is that of elasticity; to the next order it is too low by
 * k^2 (delta^2 + h^2)/48. NAN: the horizon is not sound. */
double bonds_line_wave(const BeamDef *, double wave_number);

/* The motion is at rest when the kinetic energy is below this share of its largest; looked for every so many
 * steps. */
enum { BEAM_REST_EVERY = 16 };
#define BEAM_REST_SHARE 1e-10

/* How the rows hold each other where all columns move alike across the beam, whole bonds and small motion:
 * the force density on row j is minus the sum of matrix[j ny + k] times the displacement of row k, N/m^4. The
 * caller has ny x ny numbers. False: the simulation is not a beam. */
bool beam_row_stiffness(const Simulation *beam, double *matrix);

/* The lowest vibration of this very lattice, with its supports and its surface correction: the predicted
 * period of a simply supported beam, and of any beam or plate what critical damping and rest go by. It is
 * what the discretisation gives for small motion, before any step is taken: what a run measures differs by
 * the step (dt^2) and by how well the record can be fitted.
 *
 * The largest factor that is made for it, in numbers of 8 bytes: a quarter of a gigabyte. */
enum { BEAM_MODES_NUMBERS_MAX = 1 << 25 };

/* The period in s of a simply supported beam; NAN where the lattice is so fine that the factor of its
 * stiffness would not fit (BEAM_MODES_NUMBERS_MAX), and for other problems, which have none. `span` and
 * `height` (NULL: not wanted): the distance of the supports and the height as the nodes lie, m. It takes n
 * B^2 products, n twice the number of nodes and B twice the nodes of a column times the reach: a tenth of a
 * second at 400 x 20 nodes, seconds at 800 x 40. BeamDef.cancel is asked on the way. False: the status says
 * why (a definition that is not a beam, no memory, given up). */
bool beam_predicted_period(const BeamDef *definition, double *period, double *span, double *height,
                           Status *status);

/* What small motion of a beam or a plate is, by the factor of its stiffness as it stands: with its supports,
 * its notch or cuts, and the clamp of t = 0. NAN: nothing holds it, or the factor would not fit. */
typedef struct BeamLinear {
    double period; /* the longest, s */
    double sag;    /* of the probe at rest under a body force of 1 m/s^2 upwards, m */
} BeamLinear;

/* False: no memory, or given up by BeamDef.cancel; the status says which. */
bool beam_linear(const Simulation *beam, BeamLinear *, Status *);

#endif
