/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The particles of a bar at rest and the matrices that they make on its mesh: what one time step does to a
 * motion so small that no weight changes.
 *
 * All shape functions are written as B-splines of degree p by their definition, the recursion of Cox and de
 * Boor on the open knots of the mesh (p = 1: the hat). uGIMP's particles at rest touch no edge of their cell,
 * so that their weights are the hat's, unless they are beside the middle of their share. Physics computes
 * the same functions in another way; neither knows the other.
 *
 * Lengths are in cells, masses in rho dx, stiffnesses in E/dx; a time step is then the courant number, and a
 * frequency is one of dx/c: all of the first material, where there are two. Only nodes that are free and have
 * mass are kept, counted from 0. A band matrix is stored by rows: B(i, i - d) at [i * (reach + 1) + d], d = 0
 * .. reach; what lies left of it is 0. */
#ifndef THEORY_BAR_REST_H
#define THEORY_BAR_REST_H

#include "theory/elastic_bar.h"

enum { REST_SUPPORT_MAX = 4 };

typedef struct BarRest {
    int cells, per_cell;                   /* of the bar */
    double offset;                         /* of particles, in shares 1/per_cell of a cell */
    int joint;                             /* the first cell of the second material; of one: cells */
    double density_beyond, modulus_beyond; /* of the second material over the first */
    int degree;                            /* p of the shape functions; a cell touches p + 1 nodes */
    int origin, mesh_cells;                /* cells before the bar; cells in all */
    int first_node, nodes; /* those that are kept: first_node .. first_node + nodes - 1 of the mesh */
    int reach;             /* half-width of the bands */
    double *mass;          /* M_l = sum m N, the lumped mass */
    double *consistent; /* consistent mass M_c = sum m N N^T; with APIC M_c + sum m (N d)(N d)^T / sum N d^2,
                        d from particle to node */
    double *stiffness;  /* K = sum V N' N'^T */
} BarRest;

/* The weights of particle j (0 to per_cell - 1) of a cell of the bar, for the nodes from `cell + origin` of
 * the mesh on; NULL: not wanted. arm: from the particle to the node (its Greville abscissa). */
void bar_rest_weights(const BarRest *, int cell, int j, double n[REST_SUPPORT_MAX],
                      double slope[REST_SUPPORT_MAX], double arm[REST_SUPPORT_MAX]);

/* `cells` cells of the bar with its own ends. False: not enough memory, or no node is free. */
bool bar_rest_make(BarRest *, const BarTheory *, const BarMesh *, int cells);
void bar_rest_free(BarRest *);

/* x <- M^-1 x, M = share M_c + (1 - share) M_l. False: not enough memory, or M is singular. */
bool bar_rest_solve_mass(const BarRest *, double share, double *x);

/* Nodal velocities sum m N phi / M_l of a mode of unit velocity, as phi is. */
typedef double BarShape(const BarTheory *, int number, double x);
void bar_rest_sample(const BarRest *, const BarTheory *, BarShape *phi, int number, double *velocity);

/* The degree of the splines that a shape's weights at rest are: 1, 2, 3. */
int bar_rest_degree(MpmShape);

/* How much of the particles' velocity of the last step is kept beside the grid's: alpha; 0 with APIC and
 * FMPM. */
double bar_mesh_flip(const BarMesh *);

/* What a step does to a motion that the filter particle -> node -> particle multiplies by F, an eigenvalue of
 * M_l^-1 M (of a wave: F of its angle). All transfers are the same step in three numbers:
 *
 *     T  nodal velocity over p / m
 *     W  nodal velocity that comes back through the particles, over p / m
 *     g  what is left of the grid's velocity when it has gone to the particles and back without force
 *
 *                                                T      W        g
 *     FLIP, PIC                                  1      F        alpha + (1 - alpha) F
 *     mass blend mu, Mh = (1 - mu) F + mu        1/Mh   F/Mh^2   alpha + (1 - alpha) F/Mh
 *     FMPM(k), R = 1 - (1 - F)^k                 R/F    R^2/F    R
 *     APIC, F being Fa                           1      Fa       Fa */
typedef struct MeshResponse {
    double moves, returns, kept; /* T, W, g */
} MeshResponse;

MeshResponse bar_mesh_response(const BarMesh *, double filter);

#endif
