/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The material point method on a beam in plane stress: simply supported, or leaving a channel.
 *
 * Source: the equations of A. da Silva Rocha, "Unidimensional Axial Vibration Using MPM" (paper M), written
 * for two directions, on the beams of Chen, Liu, Yang, "The application of peridynamics in predicting beam
 * vibration and impact damage" (paper P). SI units; energies are those of the beam (per unit thickness times
 * the thickness), masses and forces of particles and nodes are per unit thickness. Shapes, starts and
 * supports are explained where they are made: shape.h, plane.c, plane_model.c. */
#ifndef METHODS_MPM_PLANE_H
#define METHODS_MPM_PLANE_H

#include "base/kinds.h"
#include "base/cancel.h"
#include "methods/method.h"
#include "methods/mpm/mpm_bar.h"
#include "methods/bonds/plane/bonds_plane.h"

typedef struct PlaneDef {
    bool leaves_channel;              /* a cantilever that leaves its channel; else a supported beam */
    double length, height, thickness; /* m; length and height are whole numbers of cells, the height of an
                                         even one: a row of nodes lies on the mid-plane */
    double youngs_modulus, density;   /* Pa, kg/m^3 */
    double poisson;                   /* 0 to below .5 */

    double cell_size;       /* dx, m */
    int particles_per_cell; /* P along each side of a cell: P x P in all; 1 to 8, uGIMP from 2 */
    int padding;            /* empty cells around the beam, at least 1 */
    double grid_velocity;   /* of the whole grid, along the beam, m/s; 0 to the speed */

    MpmAlgorithm algorithm;
    MpmShape shape;       /* MPM_HAT, MPM_GIMP or MPM_BSPLINE2 */
    double flip_fraction; /* 1 is FLIP, 0 is PIC */
    BodyRotation rotation;

    int mistake; /* as of BarDef, of those that mean something in the plane */
    bool conceals_mistake;
    int mistake_beside;

    double amplitude; /* U, m; a cantilever's tip starts at 2 U */
    PlaneStart start;
    PlaneStress stress;
    PlaneEnds ends; /* of a supported beam */

    double speed, channel; /* of a cantilever: m/s, and the length inside the channel at t = 0, whole cells */
    Clamp clamp;

    double courant; /* dt = courant dx / c, c = sqrt(E / (rho (1 - nu^2))) */
    double end;     /* s; a fixed grid reaches as far as a cantilever comes until then */
    int threads;    /* at least 1 */

    Cancel cancel; /* asked while the beam is being built */
} PlaneDef;

/* Is the definition sound? Else the status names the key as in a scenario file, what is wrong, what is
 * allowed. plane_create() is given what is. */
bool plane_check(const PlaneDef *, Status *);

/* dt of a sound definition, s. */
double plane_step(const PlaneDef *);

/* Builds the simulation at t = 0. NULL: the status says why not. Fields: particles x0 y0 x y ux uy vx vy sxx
 * syy sxy density mass (the CSV columns), then what only the screen shows; nodes x y mass px py fx fy, then
 * likewise. vx is that in the laboratory. Series: u_probe v_probe, length (cantilever), kinetic kinetic_grid
 * kinetic_null (these two may be left out) strain work total; kinetic energies leave the cantilever's common
 * speed out. total = kinetic + strain, which changes little: the work is that of the channel in the
 * laboratory, where drawing the beam along counts too.
 *
 * A run fails, with particle, step and time in its status, when a particle leaves the grid, when
 * 1 + exx + eyy <= 0 for one in a step, and when the energy is more than 1e4 times that of the start: looked
 * at after each step that is a multiple of 64, where growth is reported too.
 *
 * Live parameters: mpm.algorithm, mpm.flip_fraction, mpm.mistake. */
Simulation *plane_create(const PlaneDef *, Status *);

/* What the equations of a beam's own mesh say before any step is taken: the period of its lowest vibration,
 * and the largest stable time step. */

/* The predicted period of a supported beam, s, for small motion about the lattice on which its particles
 * start, with its time step, algorithm and flip fraction; NAN for a cantilever, whose length changes, of
 * B-splines, and
 * where the mesh is so fine that its matrices would take more than a quarter of a gigabyte. PlaneDef.cancel
 * is asked on the way. False: the status says why (no memory, given up). */
bool plane_predicted_period(const PlaneDef *, double *period, Status *);

/* The largest stable Courant number of the lattice on which particles start; hats whose particles have
 * drifted stand less. Of a mesh too fine for its matrices that of an endless one, less a hundredth, which is
 * a lower bound. False: as above. */
bool plane_courant_limit(const PlaneDef *, double *courant, Status *);

#endif
