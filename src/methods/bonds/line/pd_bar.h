/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Bond-based peridynamics on a bar (axial vibration), one-dimensional.
 *
 * Nodes lie at X_i = (i + 1/2) h, h the spacing; each stands for a volume h per unit of cross-section. Nodes
 * i and j are bonded while |xi| = |X_j - X_i| is at most the horizon delta. The micromodulus follows from
 * equal strain energy in a stretched bar, W = E e^2/2 = 1/2 int c e^2 |xi|/2 dV over both sides:
 *
 *     c = 2E/(A delta^2)
 *     rho u_i'' = sum_j c G w V_j s n + rho b,    s = (|xi + eta| - |xi|)/|xi|,   n = sign(xi + eta)
 *
 * On a line |xi + eta| - |xi| is eta n itself as long as no node overtakes another, so the stretch is linear
 * in the displacements at any amplitude. w is what node j's volume counts for
 * (lattice/volume.h; here that of "hhb" is the share of its cell within the horizon, and "partial" is
 * the same unless delta/h has a fraction above 1/2): then the sum over j gives back E exactly where delta is
 * a whole number of spacings; with w = 1 it gives E (1 + h/delta).
 *
 * Ends. A fixed end is the middle between its first node and that node's mirror image: beyond it lie mirrored
 * nodes, u(-X) = -u(X), whose bonds are like all others. So the end itself stays at rest, no node lacks
 * partners there, and sin(n pi X / L) is an exact mode of the bar that is fixed at both ends. A free end has
 * nothing beyond it: its nodes lack partners and are too soft. surface_correction "energy" scales each bond
 * by G = (g_i + g_j)/2, g_i = (E/2)/(sum_j c w V_j |xi|/4): what the energy of a uniform strain should be
 * over what the family of i holds (the correction of the beams in one dimension); "none" leaves G = 1.
 *
 * Sources: S. A. Silling, Reformulation of elasticity theory for discontinuities and long-range forces
 * (2000); S. A. Silling, M. Zimmermann, R. Abeyaratne, Deformation of a peridynamic bar (2003); F. Bobaru and
 * others, Convergence, adaptive refinement, and scaling in 1D peridynamics (2009); time stepping, partial
 * volumes and surface correction as in paper P (bonds_plane.h). Units: any consistent system; forces, masses
 * and energies are per unit cross-section. */
#ifndef METHODS_BONDS_LINE_PD_BAR_H
#define METHODS_BONDS_LINE_PD_BAR_H

#include "methods/forces.h"
#include "methods/bonds/plane/bonds_plane.h"

typedef struct PdBarDef {
    double length;         /* L > 0; a whole number of spacings */
    double youngs_modulus; /* E > 0 */
    double density;        /* rho > 0 */
    bool left_fixed, right_fixed;

    double spacing;                       /* h > 0 */
    double horizon;                       /* delta, 1 to PD_BAR_REACH_MAX spacings, at most the length */
    SurfaceCorrection surface_correction; /* none or energy */
    VolumeCorrection volume_correction;
    Influence influence; /* conical: c is scaled so that the sum over a whole family gives E */

    double body_force;     /* b, per unit mass */
    double traction;       /* t at each free end, outwards positive */
    double traction_layer; /* depth over which it is spread; 0: h, the last node */

    const ForceTerm *forces; /* beside body force and traction, as force densities; NULL: none */

    double dt; /* > 0 */
    Stepping stepping;
    int mistake, mistake_beside; /* as of BeamDef, but for those that a line has not */
    bool conceals_mistake;

    Cancel cancel; /* asked while the bar is being built, with share 0 first */

    /* The velocity of the nodes at t = 0; NULL: at rest. */
    double (*initial_velocity)(double x, const void *context);
    const void *initial_context; /* used during pd_bar_create only */
} PdBarDef;

enum { PD_BAR_REACH_MAX = 24 };

/* Is the definition sound? Else the status names the key as in a scenario file, what is wrong, what is
 * allowed. pd_bar_create() is given what is. */
bool pd_bar_check(const PdBarDef *definition, Status *status);

/* Builds the simulation at t = 0. NULL: the status says what is wrong with the definition or that there is
 * not enough memory.
 *
 * Sets: 0 particles (the nodes of the lattice), 1 bonds (those between two nodes of the bar, not those to
 * mirrored nodes). Fields in tables: particles x0 x u v stress strain density mass as on the bar by the
 * material point method, then strain_energy surface_factor; bonds i j x_i x_j stretch. Stress is the force of
 * all bonds through a section, the mean of the sections on both sides of the node; strain is the mean stretch
 * of the node's bonds, weighted with their lengths and volumes. On screen also: particles force load family
 * acceleration; bonds pull energy.
 *
 * Series: v_cm x_cm kinetic strain work total (total = kinetic + strain; less the work it keeps its value).
 * Live parameters: load.body_force, load.traction, pd.mistake. They belong to the state.
 *
 * A run fails, with particle, step and time in its status, when a node comes a whole spacing nearer to its
 * neighbour (at a fixed end: its own image), or as much further away: beyond the critical time step that is
 * where it ends. */
Simulation *pd_bar_create(const PdBarDef *definition, Status *status);

/* What the lattice came to. */
typedef struct PdBarFacts {
    double micromodulus; /* c for a unit cross-section */
    size_t nodes;
    size_t family;        /* bonds of a node in the bulk */
    double modulus;       /* E that a uniform strain finds far from the ends */
    double end_factor;    /* g of the last node at a free end; 1: no correction, or no free end */
    double critical_step; /* 2 / omega_max, by the largest eigenvalue of the lattice with its ends */
} PdBarFacts;

void pd_bar_facts(const Simulation *bar, PdBarFacts *facts);

/* The critical step before there is a simulation. False: the definition is wrong or memory is short. */
bool pd_bar_critical(const PdBarDef *definition, double *step, Status *status);

#endif
