/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The choices that a run is made of: the words of parameters, and what the methods know by the same names.
 * They stand here because neither owns the other. */
#ifndef BASE_KINDS_H
#define BASE_KINDS_H

/* --- the material point method --- */

typedef enum BarSupports { BAR_FIXED_FREE, BAR_FREE_FIXED, BAR_FIXED_FIXED, BAR_FREE_FREE } BarSupports;

typedef enum MpmAlgorithm {
    MPM_USF, /* update stress first: as in paper M */
    MPM_USL, /* update stress last */
    MPM_MUSL /* modified USL: the nodal velocity for the strain is mapped again */
} MpmAlgorithm;

typedef enum MpmShape {
    MPM_HAT,
    MPM_GIMP,
    MPM_BSPLINE2,
    MPM_BSPLINE3,
    MPM_CPDI,
    MPM_UNIFORM2, /* of a bar: B-splines about its nodes, the same at its ends as inside */
    MPM_UNIFORM3
} MpmShape;

typedef enum MpmTransfer { MPM_FLIP, MPM_APIC, MPM_FMPM } MpmTransfer;

enum { FMPM_ORDER_MAX = 8 };

/* Elastic bodies in the plane: their law, what is prevented across the plane, how stress turns with the body,
 * what a wall of the box does, and whether bodies share one velocity field. */
typedef enum BodyLaw { LAW_HYPOELASTIC, LAW_NEO_HOOKEAN } BodyLaw;
typedef enum BodyPlane { PLANE_STRAIN, PLANE_STRESS } BodyPlane;
typedef enum BodyRotation { ROTATION_JAUMANN, ROTATION_NONE } BodyRotation;
typedef enum BodyWall { WALL_OPEN, WALL_CLAMP, WALL_SLIP, WALL_FRICTION } BodyWall;
typedef enum BodyFields { FIELDS_ONE, FIELDS_EACH } BodyFields;
typedef enum BodyShape { BODY_DISC, BODY_RING, BODY_BLOCK } BodyShape;

/* How the ends of a supported beam are held: uy = 0 over the whole end section (the plane problem with an
 * exact answer), or at its middle alone. ux = 0 at the left end's middle either way. */
typedef enum PlaneEnds { PLANE_SECTION, PLANE_POINT } PlaneEnds;

/* What moves at t = 0: the deflection of the first mode, held and let go; or the straight beam with the
 * velocities of that mode. */
typedef enum PlaneStart { PLANE_DEFLECTION, PLANE_VELOCITY } PlaneStart;

/* The stress that belongs to the deflection, which the method cannot find out by itself. */
typedef enum PlaneStress {
    PLANE_RELAXED, /* of nodal displacements with the sections' widening and narrowing: rings least */
    PLANE_GRID,    /* of nodal displacements by beam theory alone */
    PLANE_EXACT    /* beam theory's curvature at each particle */
} PlaneStress;

/* --- peridynamics --- */

/* Which nodes are members of a family, and what they count for: methods/bonds/plane/lattice/volume.h. */
typedef enum VolumeCorrection { VOLUME_NONE, VOLUME_PARTIAL, VOLUME_HHB } VolumeCorrection;

typedef enum SurfaceCorrection { SURFACE_NONE, SURFACE_ENERGY, SURFACE_VOLUME } SurfaceCorrection;
/* How a bond's stiffness depends on its length (the micromodulus): not at all, or as 1 - |xi|/delta. */
typedef enum Influence { INFLUENCE_CONSTANT, INFLUENCE_CONICAL } Influence;

/* How a step moves the nodes by their forces: methods/bonds/plane/bonds_step.c. */
typedef enum Stepping {
    STEPPING_VERLET,
    STEPPING_EULER,
    STEPPING_EULER_POSITION,
    STEPPING_LEAPFROG,
    STEPPING_LEAPFROG_AHEAD
} Stepping;

typedef enum Clamp { CLAMP_FULL, CLAMP_GUIDE } Clamp;

#endif
