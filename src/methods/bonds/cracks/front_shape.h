/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The shape of the cracks of a plate at one state (fronts.h): the lines of the lattice across a front, groups
 * of cracked nodes on them, and what follows from these: tips, the branch, paths. Private to fronts.c. */
#ifndef METHODS_BONDS_CRACKS_FRONT_SHAPE_H
#define METHODS_BONDS_CRACKS_FRONT_SHAPE_H

#include "methods/bonds/plane/bonds_internal.h"
#include "methods/bonds/cracks/fronts.h"

enum { FRONT_NONE = 255, FRONT_GROUPS_MAX = 32 };

/* A node that cracked in the run and belongs to a front, from this step on. */
typedef struct CrackedNode {
    int32_t step;
    uint32_t node;
} CrackedNode;

/* A front while it is worked out. */
typedef struct Growth {
    const Beam *beam;
    CrackFronts *fronts;
    uint8_t *front_of;   /* per node: index, FRONT_NONE: not cracked now, or of none */
    uint8_t *cracked;    /* per node, at the step that a pass has come to */
    CrackedNode *cracks; /* in the order in which they came to their fronts */
    size_t n_cracks;
    uint32_t *asked, *next; /* nodes that may come to a front in this round, and in the next one */
    uint8_t *found;         /* and where these came to */
    double *all, *broken; /* per node: weights of its family, and of its broken bonds; all 0: not looked up */
    uint32_t *breaks;     /* slots of broken bonds in the order in which they broke */
    size_t n_breaks, n_of_cuts; /* those of the cuts come first */
    uint8_t *is_touched;        /* per front and line: a node of it has cracked since it was looked at */
    uint32_t *touched;          /* which these are */
    size_t n_touched;
    int32_t *split; /* per front and line: the first step looked at in which it was split; -1: never */
    int lines;      /* as many as the larger of columns and rows */
} Growth;

/* A group of neighbouring cracked nodes of a line. */
typedef struct Group {
    int low, high;  /* across */
    double centre;  /* sum phi x / sum phi */
    int behind;     /* lines back to where it split off, or to the front's end */
    int successors; /* groups of the next line that touch it */
} Group;

/* The lattice's lines across an axis: where one lies, which holds a node. */
double front_place(const Beam *, int axis, int line);
int front_line_of(const Beam *, int axis, size_t node);

/* The groups of a front on a line, at most FRONT_GROUPS_MAX, in order. */
int front_groups(const Growth *, int front, int line, Group groups[FRONT_GROUPS_MAX]);

/* These fill the front's tips, branch, lines and paths. False: memory is short. */
void front_find_tips(const Growth *, int front);
void front_find_branch(const Growth *, int front);
bool front_find_lines(const Growth *, int front);
bool front_find_paths(const Growth *, int front);

#endif
