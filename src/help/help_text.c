/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The passages of the help: one set for each kind of simulation, distinguished by what it has. */
#include "help/help_text.h"

/* --- words of the curves --------------------------------------------------------------------------- */

static const HelpWord bar_words[] = {
    {"exact", "solution of the continuum, without mesh and time step: dotted."},
    {"ω", "angular frequency, by a least-squares fit of cosine, sine and offset. T is the period: its error "
          "has the opposite sign."},
    {"behind",
     "phase lag: by how many periods the run is behind the exact solution now. A small error of frequency "
     "adds up to a large lag."},
    {"v_cm", "momentum of the particles over their mass. Particles move with the nodal velocities, so "
             "d(x_cm)/dt is another number (column x_cm_rate). The difference grows as energy goes to the "
             "null space: the amplitude of v_cm falls, and no energy is lost."},
    {"lumping",
     "kinetic energy that the lumped mass matrix leaves out of a motion that the grid resolves. It is there "
     "from the start and is not lost. The shares below the energies are means over the plotted time."},
    {"null space", "kinetic energy of particle motion that no nodal velocities can represent: no force acts "
                   "on it. It grows where particles move far within their cells."},
    {"ripple", "velocity and stress are half a step apart in time, so the sum of their energies ripples by "
               "about half of ω times the time step. No energy is lost: the time-centred energy E* takes "
               "both at the same time and does not ripple. Only a decrease of E* is a loss."},
    {"K and F",
     "view 5, the error of ω. The lag has two parts, both due to the lumped mass matrix: mapping velocity to "
     "the nodes and back acts as a low-pass filter (F), and the linear elements vibrate too slowly (K). apic "
     "removes F; smaller cells reduce both; with a consistent mass matrix the factor is 1/F, and a mass "
     "blend cancels both. The scale is a square root: an error in proportion to n² is a straight line."},
    {"R, T", "of a pulse at a joint: the reflected and the transmitted part of its velocity, while each is "
             "in one piece. Of two materials mode n is the n-th of this bar; a sine excites several."},
};

static const HelpWord pd_bar_words[] = {
    {"exact", "solution of the continuum, without mesh and time step: dotted."},
    {"ω", "angular frequency, by a least-squares fit of cosine, sine and offset. T is the period: its error "
          "has the opposite sign."},
    {"behind",
     "phase lag: by how many periods the run is behind the exact solution now. A small error of frequency "
     "adds up to a large lag."},
    {"v_cm", "the velocity of the centre of mass. Predicted: the start is resolved into all modes of the "
             "lattice with its ends, and each oscillates at its own frequency."},
    {"lattice", "view 5, the error of ω far from the ends: the lattice is too soft for short waves. free "
                "end: the effect of the nodes there, which lack neighbours or have stiffer bonds instead. "
                "The curve does not include it."},
    {"stress", "the force of all bonds that cross a section, the mean of the two sections beside a node. At "
               "a free end half of it is missing: no bond crosses the section beyond the last node."},
    {"strain", "the mean stretch of a node's bonds, weighted with their lengths: a mean over the horizon."},
    {"force", "view 4: the force of a bond over its stretch s. A node is drawn at the stretch of its most "
              "stretched bond; heights are logarithms of the number of nodes."},
    {"mirrored", "beyond a fixed end lie mirror images of the nodes, with the opposite displacement. They "
                 "keep the end at rest, and sines are exact modes of a bar fixed at both ends."},
};

/* What bonds that break show, in beams and in plates. */
static const char of_force[] =
    "view 4: the force of a bond over its stretch s, and s0, where it breaks. A node is drawn at the stretch "
    "of its most stretched bond; heights are logarithms of the number of nodes.";
static const char of_cost[] =
    "fracture energy: the energy of a crack over its area. It and s0 follow from each other: edit either. "
    "View 3, pressed again: the energy of the crack so far.";
static const char of_residual[] =
    "kinetic + strain + dissipated energy minus the work of the load. It is 0 but for an error of second "
    "order in the time step: half the step leaves a quarter.";
static const char of_damage[] =
    "the fraction of a node's bonds that are broken. A crack right through reads 0.4 to 0.5, not 1.";

static const HelpWord beam_words[] = {
    {"beam theory", "the beam of Euler-Bernoulli or of Timoshenko, or the modes of a cantilever of growing "
                    "length, without lattice and time step: dotted, with its name."},
    {"probe", "the mid-point of a supported beam, the tip of a cantilever."},
    {"Euler", "Euler-Bernoulli: plane sections stay normal to the axis. Timoshenko adds shear and rotary "
              "inertia: the reference for a two-dimensional body."},
    {"T", "the period, by a least-squares fit. Predicted: that of the lowest mode of this lattice with its "
          "supports and its surface correction. Theory at its real size: Timoshenko's period for the size of "
          "the lattice, which is a little thinner and shorter than specified."},
    {"zeros", "the same period from the zeros of the oscillation alone: where the two differ the record is "
              "short or not a pure sine."},
    {"modal", "the moving cantilever by its first bending modes on the growing length. Filtered: the end of "
              "a straight line fitted to the last 0.1 ms, without thickness modes."},
    {"~L^1/2", "amplitude of a beam that grows slowly: in proportion to L^1/2 for the displacement, to "
               "L^-3/2 for the velocity, because energy over frequency is conserved."},
    {"section", ":show section: the displacement along the beam through its height at the chosen "
                "particle. On the line -y duy/dx sections stay plane and normal to the axis."},
    {"force", of_force},
    {"G0", of_cost},
    {"residual", of_residual},
    {"height", "view 6: the predicted lines are modes of the lattice through the height of the beam."},
    {"damage", of_damage},
    {"horizon",
     "view 5: the period over the horizon, with the two beam theories. Each earlier run with another "
     "horizon has a dot."},
};

static const HelpWord plate_words[] = {
    {"rows",
     "cuts, loads, supports, impulses, protected regions and the probe, each a line among the parameters. "
     "Enter edits it as text, p moves it on the map, Tab takes its other end; A adds one, C copies, D "
     "deletes."},
    {"probe", "the node at the place that the row of that name gives. There is no theory for its curves."},
    {"cracks", ":show cracks: the speed of each crack tip; again: its path length. A tip is followed from "
               "each end of a cut inside the plate; where there are several each curve ends in a letter."},
    {"c_R", "the speed of the Rayleigh wave along an edge, dotted: the limit of a crack in tension."},
    {"deg",
     "from the cut: the angle between the cut and the straight line through its crack. Half angle: half "
     "of that between two branches, over a quarter of the plate after the place where the crack split."},
    {"surface",
     "made / length: the length of a straight cut with as many broken bonds, over the length of the "
     "cracks. 1 is a straight cut; above 1 bonds broke beside the crack too."},
    {"force", of_force},
    {"G0", of_cost},
    {"residual", of_residual},
    {"damage", of_damage},
};

static const HelpWord plane_words[] = {
    {"beam theory", "the beam of Euler-Bernoulli or of Timoshenko, or the modes of a cantilever of growing "
                    "length, without mesh and time step: dotted, with its name."},
    {"plane",
     "the exact answer of the plane problem with its ends held as whole sections: Rayleigh and Lamb's "
     "bending wave. Smaller cells converge to it."},
    {"T", "the period, by a least-squares fit. Predicted: the lowest eigenvalue of this mesh, with stiffness "
          "and masses mapped from particles to nodes and back."},
    {"modal", "the moving cantilever by its first bending modes on the growing length."},
    {"~L^1/2", "amplitude of a beam that grows slowly: in proportion to L^1/2 for the displacement, to "
               "L^-3/2 for the velocity, because energy over frequency is conserved."},
    {"section",
     ":show section, again: displacement, bending stress and shear through the height at the chosen "
     "particle. Dashed are the columns of particles of its cell, solid their mean: the difference of the "
     "columns is the false shear of a cell in bending."},
    {"mesh",
     ":magnify 16, or Z and + : the cells under the particles, bars of mass and momentum on the nodes while "
     "a step is under way, arrows from giver to receiver; for a beam that leaves its channel the bars of "
     "momentum are without its common speed v0. The cross on the chosen particle: its principal stresses, "
     "dotted in compression."},
    {"null space", "view 3: kinetic energy of particle motion that no nodal velocities can represent. "
                   "Lumping: kinetic energy that the lumped mass matrix leaves out."},
    {"order",
     ":show convergence: cells, particles, methods. An order of 2: half the cell, a quarter of the error."},
};

static const HelpWord bodies_words[] = {
    {"exact", "without mesh and time step, dotted: free flight until a wall is met, the momenta, the first "
              "touch, and the closed solutions of a disc that spins, slides or rolls."},
    {"L", "the velocity gradient at a particle, Σ v_i ⊗ ∇N_i: its symmetric part is the strain rate, its "
          "antisymmetric part the rotation."},
    {"det F", "volume of a particle over that at t = 0: above 1 it is expanded, below 1 compressed."},
    {"first touch",
     "the time at which two bodies first act on each other. On a grid it is known to a fraction of "
     "a cell."},
    {"restitution", "the speed at which two bodies separate over that at which they met: 1 where no energy "
                    "goes into vibration or is lost."},
    {"torn", "two neighbouring particles of a body are so far apart that no node takes mass from both, so no "
             "force acts between them: numerical fracture, not fracture of the material. A wider shape "
             "function or more particles per cell delay it."},
    {"angular mom.", "angular momentum about the centre of the box. Contact conserves it. With flip it "
                     "decreases as bodies turn, with apic it is conserved."},
    {"spin", "angular momentum of a body over its moment of inertia, both about its centre of mass: radians "
             "per unit of time, counterclockwise positive."},
    {"friction", "the energy that friction at walls and contacts dissipated; the total includes it. The "
                 "hypoelastic law has no potential, so the total is conserved only approximately."},
    {"mesh",
     ":magnify 16, or Z and + : the cells under the particles, bars of mass and momentum on the nodes "
     "while a step is under way, arrows from giver to receiver."},
};

/* --- what is solved -------------------------------------------------------------------------------- */

static const HelpPassage bar_before[] = {
    {true, "What is solved: axial vibration of a bar"},
    {false, "Momentum and Hooke's law along a line, small strains:"},
    {false, "ρ dv/dt = dσ/dx + ρ b      dσ/dt = E dv/dx"},
    {false, "Weak form, with a test function w that vanishes where the bar is held:"},
    {false, "∫ w ρ dv/dt dx = -∫ w′ σ dx + ∫ w ρ b dx + w t at the ends"},
    {false, "The integrals become sums over particles of mass m and volume m/ρ."},
};

static const HelpPassage pd_bar_before[] = {
    {true, "What is solved: axial vibration of a bar, by bonds"},
    {false, "ρ d²u/dt² = Σ c G w s V sign(ξ+η) + ρ b      s = (|ξ+η| - |ξ|)/|ξ|"},
    {false, "The sum runs over the family: all nodes nearer than the horizon δ. ξ is the initial vector to a "
            "neighbour, η the relative displacement; c = 2E/(A δ²), from equal strain energy in a stretched "
            "bar, with "
            "cross-section A = 1."},
    {false, "On a line the stretch is linear in the displacements, at any amplitude."},
    {false,
     "Conical influence: c₁ (1 - |ξ|/δ) in place of c, c₁ = E/(Δx² Σ (1 - mΔx/δ) w_m m) over one side, which "
     "is 6E/(A δ²) on a fine lattice."},
    {false, "w is the fraction of a node's cell within the horizon: partial leaves out nodes whose centre "
            "lies beyond it, hhb includes them. G is the mean of the two nodes' surface factors: the strain "
            "energy of the continuum under uniform strain over that of the family."},
};

static const HelpPassage bar_exact[] = {
    {true, "The exact solution"},
    {false, "v = A φ(x) cos ωt    u = A/ω φ(x) sin ωt    ω = β c,  c = √(E/ρ)"},
    {false,
     "φ = sin βx if the left end is held, cos βx if it is free; β = (2n-1)π/2L with one free end, nπ/L "
     "with two equal ends. Several modes add up."},
};

static const HelpPassage bar_after[] = {
    {true, "Dispersion on this mesh (hat, uGIMP)"},
    {false, "ω² = (c/Δx)² F K    K = 4 sin²(βΔx/2)\nF = 1 - (1/3 + 1/(6P²))(1 - cos βΔx)"},
    {false, "K is the usual dispersion of linear elements; F is the filter of mapping to the nodes and back, "
            "the larger part of the error. P: particles per cell."},
    {true, "Errors of the paper, and what is used here"},
    {false, "eqs. 5, 6: as printed they are not tensor expressions. In one dimension the strain increment is "
            "Δt Σ N′v without the 1/2, and the vorticity increment is 0: a line cannot spin."},
    {false, "eq. 7: the density is the particle's."},
    {false, "eq. 9: a stray t."},
    {false, "eqs. 14, 15: they start from the particle's own velocity and position."},
    {false, "eq. 17: L is a length. \"In elements\" is true only where a cell has the size 1."},
    {false, "A particle maps to two nodes here, to four in two dimensions, to eight in three."},
};

static const HelpPassage pd_bar_after[] = {
    {true, "Dispersion of this lattice"},
    {false, "ω² = 8EG/(ρδ²) Σ (w_m/m) sin²(mβΔx/2)      sin(ΩΔt/2) = ωΔt/2"},
    {false, "m counts the spacings Δx within the horizon; G is the surface factor of a full family, 1 "
            "without correction; Ω is the frequency of the run with its time step. For long waves ω = βc (1 "
            "- β²(δ² + Δx²)/48): the "
            "horizon sets the error, more than the spacing."},
    {false,
     "Conical influence: w_m (1 - mΔx/δ) times (δ/Δx)²/(2 Σ w_m m (1 - mΔx/δ)) in place of w_m. For long "
     "waves ω = βc (1 - β²(δ² - ⅔ Δx²)/80)."},
    {false,
     "Exact for a bar fixed at both ends. With a free end the frequencies are eigenvalues of this lattice."},
};

static const HelpPassage beam_before[] = {
    {true, "What is solved: nodes joined by bonds"},
    {false, "ρ d²u/dt² = Σ c G w s V (ξ+η)/|ξ+η| + b      s = (|ξ+η| - |ξ|)/|ξ|"},
    {false, "The sum runs over the family: all nodes nearer than the horizon δ. ξ is the initial vector to a "
            "neighbour, η the relative displacement; c = 6E/(πδ³(1-ν)) with ν = 1/3, the only value of this "
            "theory in plane stress."},
    {false, "Conical influence: c₁ (1 - |ξ|/δ) in place of c, c₁ = 4c."},
    {false, "w decreases near the horizon, from 1 at |ξ| = δ - Δx/2 as (δ + Δx/2 - |ξ|)/Δx: partial leaves "
            "out nodes beyond δ, hhb goes on to 0. It is not the fraction of the cell's area. G is the "
            "surface correction: it makes up for bonds that are missing near a surface."},
    {false, "A bond breaks irreversibly at the critical stretch: s₀ = √(4πG₀/(9Eδ)), conical √(5πG₀/(9Eδ))."},
    {false, "There is no contact: broken bonds have no force in compression either, so the faces of a crack "
            "that closes may overlap."},
};

static const HelpPassage plane_before[] = {
    {true, "What is solved: a beam in plane stress, by particles and cells"},
    {false, "ρ dv/dt = div σ      dσ/dt = D dε/dt      D: Young's modulus E and Poisson's ratio ν"},
    {false,
     "Each particle carries mass, velocity and stress. In each step they are mapped to the nodes of square "
     "cells, N = N_x N_y; forces change the momentum of the nodes; the particles take the change of "
     "velocity, and the mesh is reset."},
    {false, "Small strains: the stress is not turned with the particle."},
    {false, "The stress at the start is that of the bent beam with lateral contraction (relaxed); without it "
            "the beam vibrates through its height."},
};

static const HelpPassage bodies_before[] = {
    {true, "What is solved: the momentum balance of elastic bodies, by the material point method"},
    {false, "ρ dv/dt = div σ + ρ g      dx/dt = v      dρ/dt = -ρ tr L      L = ∇v"},
    {false,
     "Each particle carries mass, velocity, stress and volume. In each step they are mapped to the nodes of "
     "square cells, N = N_x N_y; forces change the momentum of the nodes; the particles take the change of "
     "velocity, and the mesh is reset."},
    {true, "Stress and large rotation"},
    {false, "dσ/dt = D sym L + W σ - σ W      W = (L - Lᵀ)/2"},
    {false, "Hypoelastic law: the stress turns with the particle (eq. 6, Jaumann's rate). In a step it turns "
            "by θ, tan(θ/2) = Δt (dv/dx - du/dy)/4, and then the strain increment is added; rotation = none "
            "does not turn it."},
    {false, "Neo-Hookean law, from the deformation gradient F, with dF/dt = L F and J = det F:"},
    {false, "σ = (G (F Fᵀ - I) + λ ln J I)/J"},
    {true, "Walls and contact"},
    {false, "n_i = Σ m ∇N points out of a body;  n = (n_a - n_b)/|n_a - n_b|    vₙ = (v_a - v)·n    "
            "v = (q_a + q_b)/(m_a + m_b)"},
    {false, "Two bodies a and b that map mass to one node interact if they are near, (r_b - r_a)·n ≤ 2 gap "
            "cells with r the mean position of each one's particles, and approach each other, vₙ > 0. The "
            "impulse m_a (vₙ n + min(1, μ vₙ/|vₜ|) vₜ) goes from a to b: it stops the approach, and friction "
            "reduces the sliding velocity vₜ. Momentum is conserved exactly."},
    {false, "A wall cancels the momentum out of the box where the body is within gap; with friction also at "
            "most μ times as much of the momentum along the wall; clamp cancels all of it. With "
            "contact.fields = one all bodies share one velocity field: they do not slide, and they interact "
            "at every node that both map mass to."},
};

static const HelpPassage bodies_after[] = {
    {true, "Reference solutions"},
    {false,
     "Momentum p = p₀ + M g t and angular momentum, until a wall acts; first touch of two round bodies "
     "|D + V t| = R_a + R_b, with D and V the distance and velocity between their centres."},
    {false,
     "Spinning disc: mean σ_xx = ρω²R²/4. On an incline of angle φ it slides with g (sin φ - μ cos φ) where "
     "tan φ > 3μ, else it rolls with ⅔ g sin φ."},
};

static const HelpPassage plane_after[] = {
    {true, "Reference solutions"},
    {false, "(k² + q²)² tanh(ph/2) = 4k²pq tanh(qh/2)    p² = k² - ω²/c²    q² = k² - ω²ρ/G    k = π/L"},
    {false, "Moving cantilever: bending modes of the length outside the channel, L(t) = L0 + v0 t."},
    {true, "Frequency on this mesh"},
    {false, "ω² = lowest eigenvalue of M_L⁻¹ M_C M_L⁻¹ K      sin(ΩΔt/2) = ωΔt/2"},
    {false, "K is a sum over the particles, stiffer the farther they lie from the centre of their cells: "
            "three along a side lock more than two."},
    {false, "A particle that enters another cell jumps from one slope of a hat to the next. The jump feeds "
            "null-space "
            "stress, and the energy grows. Remedies: uGIMP, or a mesh that moves along (mesh.velocity)."},
};

static const HelpPassage plate_after[] = {
    {true, "Reference values of a crack"},
    {false, "c_R = c_s √(2 - 2/√3)    c_s = √(3E/(8ρ))"},
    {false, "Speed of the Rayleigh wave in plane stress at ν = 1/3. The speed of a tip is a slope over the "
            "time in which that wave travels four horizons: over less time the jumps of the tip from node to "
            "node would show."},
    {false, "No formula gives the path of a crack in a plate. The balance of energy must hold throughout."},
};

static const HelpPassage beam_after[] = {
    {true, "Reference solutions"},
    {false,
     "Euler-Bernoulli: T = 2L²/π / √(Eh²/(12ρ)). Timoshenko: the same with shear and rotation, κ = 5/6."},
    {false,
     "Moving cantilever: bending modes of the length outside the channel, L(t) = L0 + v0 t; its amplitude "
     "and its period grow."},
    {true, "Errors of the paper, and what is used here"},
    {false, "Before eq. 9: \"Eq. (5)\" means eq. 8."},
    {false, "ν = .33 of the notched beam is 1/3."},
    {false, "Velocity Verlet and central differences give the same positions."},
    {false, "The time step of 1e-8 s is far below the critical one; periods do not depend on it."},
    {false,
     "Table 1 is not monotone because a beam of floor(h/dx) layers is up to 4 % thinner and the supports "
     "lie a spacing nearer: see real height and real span."},
};

/* --- by what the simulation has ------------------------------------------------------------------------- */

#define LIST(list) list, sizeof list / sizeof *list

const HelpText *help_text_of(const Simulation *sim)
{
    static const HelpText bar = {"One time step", LIST(bar_words), LIST(bar_before), LIST(bar_exact),
                                 LIST(bar_after)};
    static const HelpText pd_bar = {"One time step (velocity Verlet)", LIST(pd_bar_words),
                                    LIST(pd_bar_before), LIST(bar_exact), LIST(pd_bar_after)};
    static const HelpText beam = {
        "One time step (velocity Verlet)", LIST(beam_words), LIST(beam_before), NULL, 0, LIST(beam_after)};
    static const HelpText plate = {
        "One time step (velocity Verlet)", LIST(plate_words), LIST(beam_before), NULL, 0, LIST(plate_after)};
    static const HelpText plane = {"One time step",  LIST(plane_words), LIST(plane_before), NULL, 0,
                                   LIST(plane_after)};
    static const HelpText bodies = {"One time step",   LIST(bodies_words), LIST(bodies_before), NULL, 0,
                                    LIST(bodies_after)};
    static const HelpText other = {.step = "One time step"};
    static const struct {
        unsigned has;
        const HelpText *text;
    } texts[] = {{HAS_BODIES, &bodies},
                 {HAS_PLANE | HAS_MESH, &plane},
                 {HAS_LINE | HAS_MESH, &bar},
                 {HAS_LINE | HAS_BONDS, &pd_bar},
                 {HAS_PLANE | HAS_BONDS | HAS_ROWS, &plate},
                 {HAS_PLANE | HAS_BONDS, &beam}};
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++)
        if (simulation_has(sim, texts[i].has))
            return texts[i].text;
    return &other;
}
