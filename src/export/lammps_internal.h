/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files that write for LAMMPS share (lammps.h). */
#ifndef EXPORT_LAMMPS_INTERNAL_H
#define EXPORT_LAMMPS_INTERNAL_H

#include "methods/bonds/plane/bonds_plane.h"
#include "scenario/assignment.h"

#include <stdbool.h>
#include <stdio.h>

/* The body at t = 0, in arrays over its nodes and over its bonds, SI units. */
typedef struct LammpsBody {
    const Simulation *sim;
    const Settings *settings;
    BeamFacts facts;
    Support supports[PLATE_ROWS_MAX];
    Load loads[PLATE_ROWS_MAX];
    int n_supports, n_loads;
    size_t count, n_bonds;
    double *x, *y, *ux, *uy, *vx, *vy, *fx, *fy;
    double *held, *protected_node, *probe; /* 1: it is */
    double *whole;                         /* bonds of the node that no cut parts */
    double *bond_i, *bond_j, *cut;
    int *type;           /* of the node's atom, from 1 */
    int n_types;         /* those from first_protected on have bonds that never break */
    int first_protected; /* n_types + 1: none has */
    bool *apart;         /* two types have no bonds: rows of n_types + 1 */
} LammpsBody;

/* lammps_body.c: of a simulation and its settings, which it begins with; free it also when reading failed. */
bool lammps_body_read(LammpsBody *, Status *);
void lammps_body_free(LammpsBody *);

/* Bonds may break at all, and some of them never. */
bool lammps_breaks(const LammpsBody *);
bool lammps_protects(const LammpsBody *);
bool lammps_starts_bent(const LammpsBody *);

/* A line with numbers in their shortest text: each '@' is the next of them. */
void lammps_line(FILE *, const char *pattern, const double *numbers);
#define LAMMPS_LINE(file, pattern, ...) lammps_line(file, pattern, (const double[]){__VA_ARGS__})

/* lammps_types.c: sorts the nodes by what cuts do to them; writes which types are apart. */
bool lammps_set_types(LammpsBody *, Status *);
void lammps_write_cuts(FILE *, const LammpsBody *);

/* lammps_data.c: the nodes with their first velocities; one number for each node, as a variable of style
 * atomfile reads it. */
void lammps_write_data(FILE *, const LammpsBody *);
void lammps_write_numbers(FILE *, const LammpsBody *, const double *numbers);

/* lammps_script.c */
void lammps_write_script(FILE *, const LammpsBody *);

#endif
