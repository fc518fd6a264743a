/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The material point method on a bar, on a beam and on bodies in a box.
 *
 * Sources: A. da Silva Rocha, "Unidimensional Axial Vibration Using MPM" (paper M; equation numbers are its),
 * also written for two directions; its bar (axial vibration). Beams in plane stress, simply supported or
 * leaving a channel, are those of Chen, Liu, Yang, "The application of peridynamics in predicting beam
 * vibration and impact damage" (paper P). Elastic bodies in the plane move, turn, bend far, meet and part in
 * a box: Sulsky, Chen, Schreyer 1994 (the method, two discs); Hughes, Winget 1980 (rotation of the stress);
 * Bardenhagen, Brackbill, Sulsky 2000 (a field of velocities for each body, contact with friction);
 * Bardenhagen, Kober 2004 (uGIMP); Jiang et al. 2015 (APIC); Nairn 2013 (the gap).
 *
 * Units: of bars and bodies any consistent system, of beams SI units. Lengths, masses and forces of a bar are
 * per unit cross-section, masses and forces in the plane per unit thickness; energies of a beam are those of
 * the beam (per unit thickness times the thickness). Shapes, starts and supports are explained where they are
 * made: shape.h, bar.c, plane.c, bodies.c. */
#ifndef METHODS_MPM_MPM_H
#define METHODS_MPM_MPM_H

#include "base/kinds.h"
#include "base/cancel.h"
#include "methods/forces.h"
#include "methods/method.h"

enum { BODIES_MAX = 16, BODY_NAME_MAX = 24 };

enum { WALL_LEFT, WALL_RIGHT, WALL_BOTTOM, WALL_TOP, WALLS };

typedef struct BodyDef {
    char name[BODY_NAME_MAX];
    BodyShape shape;
    double size[4]; /* disc: cx cy r; ring: cx cy ri ro; block: x0 y0 x1 y1 */
    double velocity[2],
        spin;    /* spin about the centre given, of a block its middle; counterclockwise, rad/time */
    double wave; /* of a block: its first mode between clamps, v_x = wave sin(pi (x - x0)/(x1 - x0)) */
} BodyDef;

typedef enum MpmProblem { MPM_BAR, MPM_BEAM, MPM_BODIES } MpmProblem;

/* What is computed, and how it is discretised. */
typedef struct MpmDef {
    MpmProblem problem;

    /* whole numbers of cells; of bodies those of the box from (0, 0) on; the height of a beam is an even
     * number: a row of nodes lies on the mid-plane */
    double length, height, thickness;
    double youngs_modulus, density; /* E, rho */
    double poisson;                 /* in the plane, 0 to below .5 */

    double cell_size;       /* dx */
    int particles_per_cell; /* P along each side of a cell, 1 to 8; in the plane uGIMP from 2 */
    int padding;            /* cells beyond each free end of a bar, around a beam; at least 1 there */

    MpmAlgorithm algorithm;
    MpmShape shape;        /* in the plane MPM_HAT, MPM_GIMP or MPM_BSPLINE2 */
    MpmTransfer transfer;  /* of a beam MPM_FLIP, of bodies MPM_FLIP or MPM_APIC */
    double flip_fraction;  /* alpha: 1 is FLIP, 0 is PIC; FLIP transfer only */
    BodyRotation rotation; /* in the plane */

    /* what a wrong code does instead: an index of mpm_mistake_words, of mpm_body_mistake_words; 0: none */
    int mistake;
    bool conceals_mistake; /* its stage is worded as the right one */
    int mistake_beside;    /* what it does besides, in another place; it stays to the end */

    double courant; /* dt = courant dx/c, c = sqrt(E/rho) (eq. 21), of two materials the larger c; of a beam
                       sqrt(E/(rho (1 - nu^2))), of bodies sqrt(D_11/rho) */
    int threads;    /* at least 1; a bar is too small to be shared */
    Cancel cancel;  /* asked while the particles are being made, with share 0 first */

    /* --- a bar --- */
    BarSupports supports;
    double joint;         /* from here on the bar is of a second material: a node inside it; 0: of one */
    double joint_modulus; /* E > 0 of the second material; */
    double joint_density; /* rho > 0 */
    double offset;        /* of particles from the middle of their share of a cell, in such: -1/2 to 1/2 */

    double body_force;     /* b, per unit mass (eq. 11) */
    double traction;       /* t at each free end, outwards positive (eq. 11) */
    double traction_layer; /* h of eq. 11; 0: dx / P, the last particle at each free end */

    int fmpm_order;    /* k of FMPM(k), 1 to FMPM_ORDER_MAX; 1 is PIC */
    double mass_blend; /* mu: 1 lumped masses, less: M = (1 - mu) M_c + mu M_l; 0: bar_mass_blend_auto() */

    /* The particle velocity at t = 0 (eq. 19 and its overtones); NULL: at rest. */
    double (*initial_velocity)(double x, const void *context);
    /* Its slope dv0/dx, the affine velocities with which APIC's particles start; NULL: they start from 0. */
    double (*initial_slope)(double x, const void *context);
    /* The stress at t = 0, of which each cell's particles take their mean: what differs within a cell the
     * grid cannot see, and it would stay. NULL: none. */
    double (*initial_stress)(double x, const void *context);
    const void *initial_context; /* of all; used during mpm_create() only */

    const ForceTerm *forces; /* beside those of the load (eq. 11), ended by one without a name; NULL: none */

    /* --- a beam --- */
    bool leaves_channel;  /* a cantilever that leaves its channel; else a supported beam */
    double grid_velocity; /* of the whole grid, along the beam, m/s; 0 to the speed */
    double amplitude;     /* U, m; a cantilever's tip starts at 2 U */
    PlaneStart start;
    PlaneStress stress;
    PlaneEnds ends;        /* of a supported beam */
    double speed, channel; /* of a cantilever: m/s, and the length inside the channel at t = 0, whole cells */
    Clamp clamp;
    double end; /* s; a fixed grid reaches as far as a cantilever comes until then */

    /* --- bodies in a box --- */
    BodyWall walls[WALLS];
    double wall_friction;
    BodyDef bodies[BODIES_MAX];
    int n_bodies;
    BodyLaw law;
    BodyPlane plane;
    BodyFields fields;
    double friction; /* between bodies */
    double gap; /* cells, from a body to a wall, twice that between two; INFINITY: they meet as soon as they
                   share a node */
    double gravity[2]; /* acceleration */
    double damping;    /* rate at which momentum fades, 1/time */
} MpmDef;

/* Do the values, each of which is within its range, fit each other? Else the status names the key as in a
 * scenario file, what is wrong, what is allowed. mpm_create() is given what does. */
bool mpm_check(const MpmDef *, Status *);

/* dt of a sound definition. */
double mpm_time_step(const MpmDef *);

/* Builds the simulation at t = 0. NULL: the status says what is wrong with the definition, or that there is
 * not enough memory. What can be read of it: fields.c, rows.c. Particles of bodies are by body, rows from
 * below, in a row from the left.
 *
 * A run fails, with particle, step and time in its status, when a particle leaves the mesh (of bodies: is
 * more than 2.5 cells outside the box), when its volume is not positive any more (1 + de <= 0, det F <= 0; on
 * a bar also when one overtakes its neighbour), and when the energy is more than 1e4 times what the start and
 * the load have put in: looked at after each step that is a multiple of 64, where growth by 10 %, to twice,
 * 10, 100 and 1000 times is reported too. Heating by cell crossing stays far below.
 *
 * Live parameters (memory.c) belong to the state: a snapshot that is put back brings those of its time, and
 * the stages that go with them. */
Simulation *mpm_create(const MpmDef *, Status *);

/* --- bars ----------------------------------------------------------------------------------------- */

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
 * Of B-splines it is mostly below what is allowed: mpm_check() refuses it then. "Mass blend" and mu* are
 * words of our own; blends of lumped and consistent mass are as old as finite elements. */
double bar_mass_blend_auto(MpmShape shape, int particles_per_cell, double courant);

/* Below this the matrix may be nearly singular where particles are few: see check_mass_blend(). */
#define BAR_MASS_BLEND_LEAST 0.05

/* Whether nodes of tiny mass act on the particles beside them: a hat's slope does not vanish where the hat
 * does, and by its slope APIC's C takes the velocity of a node that an end has just passed, whose f/m is
 * rounding over next to nothing. Written so wherever such a run may fail. */
static inline bool bar_feels_light_nodes(const MpmDef *def, MpmTransfer transfer)
{
    return def->problem == MPM_BAR && transfer == MPM_APIC && def->shape == MPM_HAT &&
           def->supports != BAR_FIXED_FIXED;
}
#define BAR_LIGHT_NODES "APIC with hats lets round-off grow at nodes of tiny mass beside a moving end"

/* --- beams: what the equations of their own mesh say before any step is taken ---------------------- */

/* The predicted period of a supported beam, s, for small motion about the lattice on which its particles
 * start, with its time step, algorithm and flip fraction; NAN for a cantilever, whose length changes, of
 * B-splines, and where the mesh is so fine that its matrices would take more than a quarter of a gigabyte.
 * MpmDef.cancel is asked on the way. False: the status says why (no memory, given up). */
bool plane_predicted_period(const MpmDef *, double *period, Status *);

/* The largest stable Courant number of the lattice on which particles start; hats whose particles have
 * drifted stand less. Of a mesh too fine for its matrices that of an endless one, less a hundredth, which is
 * a lower bound. False: as above. */
bool plane_courant_limit(const MpmDef *, double *courant, Status *);

/* --- bodies --------------------------------------------------------------------------------------- */

/* What the simulation has seen: the times of the first push between two bodies, of the first one by a wall,
 * of the first tear, NAN: not yet; and the largest distance of neighbours over that at t = 0. */
typedef struct BodiesSeen {
    double met, hit, torn, stretch;
    double meeting, parting; /* speeds of two bodies along the line of their centres, when they first pushed
                                each other and when they last did; parting is NAN while they push */
    bool on_floor;           /* the first body pushes the bottom wall */
    double growth, pull; /* of a disc that spins alone: I/I0 - 1 and sum V (sxx + syy)/2 over its area, means
                            over the steps so far; NAN: not such a disc, no step */
} BodiesSeen;
BodiesSeen bodies_seen(const Simulation *);

/* The row of the series at present, by these places; from BODIES_X on five of each body, and no column that
 * is there on request. */
enum {
    BODIES_KINETIC,
    BODIES_STRAIN,
    BODIES_POTENTIAL,
    BODIES_FRICTION,
    BODIES_TOTAL,
    BODIES_MOMENTUM_X,
    BODIES_MOMENTUM_Y,
    BODIES_ANGULAR,
    BODIES_X
};
void mpm_row_of_bodies(const Simulation *, double *row);
double bodies_closing(const double *row); /* how fast the first two come nearer */

/* A field of velocities at t = 0 in place of the bodies' own, with its gradient dv_i/dx_j in rows. */
typedef void BodiesField(const double x[2], const void *context, double v[2], double gradient[4]);
void bodies_begin_with(Simulation *, BodiesField *, const void *context);

/* The displacement of the middle of a block's right end: the columns of particles next to it, extrapolated.
 */
void bodies_tip(const Simulation *, double tip[2]);

/* The centre of a body: given, of a block its middle; and the box around it. */
void bodies_centre(const BodyDef *, double centre[2]);
void bodies_bounds(const BodyDef *, double low[2], double high[2]);

/* --- mistakes ------------------------------------------------------------------------------------- */

/* The mistakes that such codes make, "none" first, ended by NULL; each at its index. Those of bars and beams
 * are defined for lumped masses and one material, some for one algorithm, shape or transfer alone. Those of
 * the start or of a factor cannot come or go in mid-run. A sentence says what is done; NULL: no mistake. */
extern const char *const mpm_mistake_words[], *const mpm_body_mistake_words[];
bool mpm_mistake_is_of_start(int mistake);
const char *mpm_mistake_sentence(int mistake);
const char *mpm_body_mistake_sentence(int mistake);

/* Whether the bar is to start with modes of a bar whose right end is held as the left one is. */
bool mpm_mistake_starts_as_held(int mistake);

#endif
