/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a scenario says of the cells of the material point method, and of its way to them and back. */
#ifndef SCENARIO_CONCERN_CELLS_H
#define SCENARIO_CONCERN_CELLS_H

#include "base/kinds.h"
#include "scenario/assignment.h"

/* The cells of the material point method; the bar's lattice left to itself has a node for each particle. */
typedef struct Mesh {
    double cell_size;
    int particles_per_cell;
    int padding;     /* empty cells beyond each free end */
    double velocity; /* of the whole mesh, along a beam that leaves its channel */
} Mesh;

/* With what slope of velocity APIC's particles start: that of the velocity, or none. */
typedef enum AffineStart { AFFINE_GRADIENT, AFFINE_ZERO } AffineStart;

/* How the material point method transfers momentum to its mesh and back. */
typedef struct Transfer {
    MpmAlgorithm algorithm;
    MpmShape shape;
    MpmTransfer transfer;
    double flip_fraction;
    double mass_blend; /* 0: the best one */
    int fmpm_order;
    AffineStart affine_start;
    BodyRotation rotation;
    int mistake;        /* of a code that is wrong in one place; 0: none */
    int body_mistake;   /* the same of a code for bodies */
    int mistake_beside; /* and in another one: of a code that is sought, no scenario has it */
} Transfer;

/* Of some settings: to be read, and to be changed. */
const Mesh *settings_mesh(const Settings *);
const Transfer *settings_transfer(const Settings *);
Mesh *settings_edit_mesh(Settings *);
Transfer *settings_edit_transfer(Settings *);

#endif
