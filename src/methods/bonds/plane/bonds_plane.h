/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bond-based peridynamics on beams and plates, two-dimensional (plane stress, Poisson's ratio 1/3).
 *
 * Source: Chen, Liu, Yang, "The application of peridynamics in predicting beam vibration and impact damage"
 * (2015; paper P); equation numbers are its. SI units; forces and energies are those of the beam, that is per
 * unit thickness times the thickness. */
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
    BEAM_PLATE
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

    PlateDef plate;          /* what a plate has */
    double body_force;       /* on every node from t = 0 on, upwards, m/s^2; -9.81: weight */
    const ForceTerm *forces; /* beside weight and loads, as force densities, along x and y; NULL: none */
    double damping; /* rate alpha, 1/s: the acceleration is f/rho - alpha v (bonds_damping.c); 0: none */
    bool critically_damped; /* alpha is twice the lowest frequency of the lattice instead */
    bool to_rest;           /* the run is over when the motion is ... */
    long changes_until;     /* ... and this many steps are done: Method.change is to be called till then */

    int mistake;           /* what a wrong code does instead: an index of beam_mistake_words; 0: none */
    bool conceals_mistake; /* its stages are worded as the right ones */
    int mistake_beside;    /* what it does besides, in another place; it stays to the end */

    double dt;   /* s; 0: half the critical time step */
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

/* The first cut of a plate that runs along nodes of its lattice, so that it is one-sided; -1: there is none.
 */
int beam_one_sided_cut(const BeamDef *definition);

/* The first cut that parts nothing, for it runs along an edge; -1: there is none. */
int beam_outer_cut(const BeamDef *definition);

/* Builds the simulation at t = 0. NULL: the status names the scenario key that is wrong ("notch.position:
 * ..."), or says that there is not enough memory.
 *
 * Sets: 0 particles (the nodes of the lattice), 1 bonds. Fields in tables: particles x0 y0 ux uy vx vy damage
 * surface_factor strain_energy; bonds i j x_i y_i x_j y_j (reference positions) stretch broken broken_at (the
 * step after which the bond was broken: 0 the notch, -1 not broken). On screen also, for particles: fx fy
 * (force density) speed stretch (largest of its live bonds) family surface_x surface_y held loaded probe
 * protected; for bonds: notch pull energy.
 *
 * Series: u_probe v_probe, of a plate also ux_probe vx_probe; length (moving) or crack_x crack_y crack_length
 * (notched); kinetic strain work dissipated total broken_bonds; damped where damping is at work. total =
 * kinetic + strain + dissipated + damped; less the work it keeps its value. broken_bonds leaves out the
 * notch's. Live parameters: load.stress, load.body_force, pd.critical_stretch, pd.mistake.
 *
 * The crack as the paper speaks of it (first break, tip, angle, arrival): methods/bonds/cracks/crack.h.
 */
Simulation *beam_create(const BeamDef *definition, Status *status);

/* What the lattice came to; for the read-only rows and the tables. */
typedef struct BeamFacts {
    double micromodulus;  /* c of eq. 4, N/m^5: of a plane, so per unit thickness; conical: of |xi| = 0 */
    int nx, ny;           /* columns and rows of nodes */
    double real_height;   /* ny dx */
    double real_span;     /* distance of the supports as the nodes lie */
    size_t family;        /* bonds of a node in the bulk */
    size_t bonds;         /* each counted once, before the notch */
    size_t notch_bonds;   /* of these cut by the notch, or by the cuts of a plate */
    double critical_step; /* 2 / omega_max by power iteration with no node held, s */
    double damping;       /* alpha in use, 1/s */
} BeamFacts;

void beam_facts(const Simulation *beam, BeamFacts *facts);

/* What holds and what loads its nodes, with the pressure of now; returns how many there are. The channel of a
 * moving cantilever is not among them. */
int beam_supports(const Simulation *beam, Support out[PLATE_ROWS_MAX]);
int beam_loads(const Simulation *beam, Load out[PLATE_ROWS_MAX]);

/* The motion is at rest when the kinetic energy is below this share of its largest; looked for every so many
 * steps. */
enum { BEAM_REST_EVERY = 16 };
#define BEAM_REST_SHARE 1e-10

/* How the rows hold each other where all columns move alike across the beam, whole bonds and small motion:
 * the force density on row j is minus the sum of matrix[j ny + k] times the displacement of row k, N/m^4. The
 * caller has ny x ny numbers. False: the simulation is no beam. */
bool beam_row_stiffness(const Simulation *beam, double *matrix);

#endif
