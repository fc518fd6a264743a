/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Elastic bodies in the plane by the material point method: they move, turn, bend far, meet and part in a
 * box.
 *
 * Sources: Sulsky, Chen, Schreyer 1994 (the method, two discs); Hughes, Winget 1980 (rotation of the stress);
 * Bardenhagen, Brackbill, Sulsky 2000 (a field of velocities for each body, contact with friction);
 * Bardenhagen, Kober 2004 (uGIMP); Jiang et al. 2015 (APIC); Nairn 2013 (the gap). Any consistent units;
 * masses, forces and energies are per unit thickness. */
#ifndef METHODS_MPM_BODIES_H
#define METHODS_MPM_BODIES_H

#include "base/kinds.h"
#include "base/cancel.h"
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

typedef struct BodiesDef {
    double width, height; /* of the box from (0, 0) on; whole numbers of cells */
    BodyWall walls[WALLS];
    double wall_friction; /* at least 0 */
    BodyDef bodies[BODIES_MAX];
    int n_bodies;
    double youngs_modulus, density;
    double poisson; /* 0 to below .5 */
    BodyLaw law;
    BodyPlane plane;
    double cell_size;
    int particles_per_cell; /* along each side of a cell; 1 to 8, uGIMP from 2 */
    MpmAlgorithm algorithm;
    MpmShape shape;       /* MPM_HAT, MPM_GIMP or MPM_BSPLINE2 */
    MpmTransfer transfer; /* MPM_FLIP or MPM_APIC */
    double flip_fraction; /* 1 is FLIP, 0 is PIC */
    BodyRotation rotation;
    BodyFields fields;
    double friction; /* between bodies, at least 0 */
    double gap; /* cells, from a body to a wall, twice that between two; INFINITY: they meet as soon as they
                   share a node */
    double gravity[2]; /* acceleration */
    double damping;    /* rate at which momentum fades, 1/time */
    double courant;    /* dt = courant dx/c, c = sqrt(D_11/rho) */
    int mistake,
        mistake_beside;    /* of a code that is wrong in one place, or in two: bodies_mistake_words; 0 */
    bool conceals_mistake; /* its stages do not show it */
    int threads;
    Cancel cancel; /* asked while the bodies are being built */
} BodiesDef;

/* What a wrong code does. */
enum {
    BODIES_RIGHT,
    BODIES_SPIN_SIGN,
    BODIES_NO_ROTATION,
    BODIES_TENSOR_SHEAR,
    BODIES_VOLUME_KEPT,
    BODIES_NORMAL_OF_ONE,
    BODIES_START_AFTER_CONTACT,
    BODIES_NO_FIRST_FIX,
    BODIES_MISTAKES
};
extern const char *const bodies_mistake_words[BODIES_MISTAKES + 1];
const char *bodies_mistake_sentence(int mistake); /* NULL: none */

/* Is the definition sound? Else the status names the key as in a scenario file, what is wrong, what is
 * allowed. bodies_create() is given what is. */
bool bodies_check(const BodiesDef *, Status *);

/* dt of a sound definition. */
double bodies_step(const BodiesDef *);

/* Builds the simulation at t = 0. NULL: the status says why not. Particles: by body, rows from below, in a
 * row from the left; fields x y x0 y0 vx vy sxx syy sxy density mass body (the CSV columns), then what only
 * the screen shows. Series: kinetic strain potential friction total momentum_x momentum_y angular, then of
 * each body NAME.x NAME.y NAME.vx NAME.vy NAME.spin, and where it is asked for NAME.touching.
 *
 * A run fails, with particle, step and time in its status, when a particle is more than 2.5 cells outside the
 * box, when det F <= 0 for one, and when the energy is more than 1e4 times that of the start.
 *
 * Live parameters: mpm.algorithm, mpm.transfer, mpm.flip_fraction. */
Simulation *bodies_create(const BodiesDef *, Status *);

/* What the simulation has seen: the times of the first push between two bodies, of the first one by a wall,
 * of the first tear, NAN: not yet; and the largest distance of neighbours over that at t = 0. */
typedef struct BodiesSeen {
    double met, hit, torn, stretch;
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
void bodies_row(const Simulation *, double *row);

/* A field of velocities at t = 0 in place of the bodies' own, with its gradient dv_i/dx_j in rows. */
typedef void BodiesField(const double x[2], const void *context, double v[2], double gradient[4]);
void bodies_begin_with(Simulation *, BodiesField *, const void *context);

/* The displacement of the middle of a block's right end: the columns of particles next to it, extrapolated.
 */
void bodies_tip(const Simulation *, double tip[2]);

/* The centre of a body: given, of a block its middle; and the box around it. */
void bodies_centre(const BodyDef *, double centre[2]);
void bodies_bounds(const BodyDef *, double low[2], double high[2]);

#endif
