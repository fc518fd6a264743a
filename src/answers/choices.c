/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list behind choices.h: one row for each place where a paper is silent, contradicts itself or is not
 * followed. A page of the help and a section of the manual are made from it. */
#include "answers/choices.h"

const Choice choices[] = {
    /* --- the bar by the material point method --- */
    {CONCERN_BAR, METHOD_MPM, "how many per cent late",
     "\"5 %\" for mode 5, \"20 %\" for mode 10: of the frequency in one place, of the phase in another, "
     "mixed.",
     "Both are given: mode 5 has a frequency 4.24 % low and a period 4.43 % long, mode 10 17.7 % and 21.5 %. "
     "The paper's 5 % is nearer to the period (.57 off, .76 from the frequency), its 20 % lies between the "
     "two."},
    {CONCERN_BAR, METHOD_MPM, "how many modes", "figures for modes 1, 5 and 10.",
     "any mode that the mesh can carry, several at once (initial.overtones)."},
    {CONCERN_BAR, METHOD_MPM, "algorithm", "update stress first only.",
     "update stress last and its modified form beside; in both the gradients of the strain are taken where "
     "the particles were at the beginning of the step."},
    {CONCERN_BAR, METHOD_MPM, "cells beyond the ends", "not given.",
     "mesh.padding empty cells beyond each free end; a particle that leaves them stops the run."},
    {CONCERN_BAR, METHOD_MPM, "nearly empty nodes", "not given.",
     "a node with less than 1e-12 of a full cell's mass takes no part in the step."},
    {CONCERN_BAR, METHOD_MPM, "traction at an end",
     "eq. 11 spreads it over a layer of thickness h, not given.",
     "load.traction_layer: the last particle at each free end, unless another depth is given; who is in it "
     "is settled at t = 0."},
    {CONCERN_BAR, METHOD_MPM, "uGIMP", "not in the paper.",
     "a particle's width stays what it was at first. One layer of nodes lies beyond a fixed end; all nodes "
     "at or beyond the end are held."},
    {CONCERN_BAR, METHOD_MPM, "B-splines", "not in the paper.",
     "open knots at the ends of the mesh, knots on the edges of cells; the first (last) function is held at "
     "a fixed end."},
    {CONCERN_BAR, METHOD_MPM, "CPDI", "not in the paper.",
     "hat functions at both ends of a particle's domain, which follows its stretch (Sadeghirad, Brannon, "
     "Burghardt 2011); held and ghost nodes as of uGIMP."},
    {CONCERN_BAR, METHOD_MPM, "mass blend, mu*", "not in the paper; both words are ours.",
     "M = (1 - mu) consistent + mu lumped, which finite elements have long known; mu* is the share, by "
     "shape, particles and Courant number, that leaves the frequency of small motions of a uniform bar an "
     "error of fourth order. From 0.05 on, B-splines mostly have none: else a nearly empty cell leaves no "
     "stable step."},
    {CONCERN_BAR, METHOD_MPM, "FMPM(k), and no XPIC", "not in the paper; words of the literature.",
     "Nairn, Hammerquist 2021; a particle moves with the mean of its old and new velocity. XPIC is left out: "
     "it damps as FMPM does and keeps the lag of lumped masses."},
    {CONCERN_BAR, METHOD_MPM, "APIC", "not in the paper.",
     "the affine velocity starts as the slope of the initial velocity (mpm.affine_start)."},

    /* --- the bar by peridynamics --- */
    {CONCERN_BAR, METHOD_PD, "a bar by bonds", "paper P solves beams only.",
     "the same equations on a line, with the bar of paper M: nodes where its particles lie, its time step, "
     "mirror images beyond a fixed end."},

    /* --- beams --- */
    {CONCERN_BEAM, METHOD_PD, "horizon and spacing",
     "the text says spacing = horizon/4; Table 1 prints others.",
     "the spacings as printed: 1.2, .6, .5, .35, .3, .25 mm. The beam then has floor(height/spacing) layers "
     "and is up to 4 % thinner than given."},
    {CONCERN_BEAM, METHOD_PD, "the edge of the horizon", "not given.",
     "a node at the distance of the horizon belongs to the family; its volume counts by the line of "
     "PDLAMMPS, from 1 half a spacing within to 1/2 at the horizon, which is not the share of its area; with "
     "hhb the line goes on to 0 half a spacing beyond (pd.volume_correction)."},
    {CONCERN_BEAM, METHOD_PD, "surface correction", "a factor G from another book.",
     "the energy of uniform stretches along and across, over what a node's family holds; one by the volume "
     "of the family, or none, can be chosen."},
    {CONCERN_BEAM, METHOD_PD, "Poisson's ratio", "nu = .33 in one place.",
     "1/3, the only value that bonds in the plane can have."},
    {CONCERN_BEAM, METHOD_PD, "time step", "1e-8 s.",
     "half of the critical step of the lattice (the notched beam: 1e-7 s); periods do not depend on it."},
    {CONCERN_BEAM | CONCERN_DEFLECTION, METHOD_PD, "reading a period", "not given.",
     "least squares of cosine, sine and offset over the record; beside it the mean distance of zeros."},
    {CONCERN_BEAM | CONCERN_DEFLECTION, METHOD_PD, "which theory", "Euler-Bernoulli's period, .86 ms.",
     "Timoshenko's, .8638 ms, is given too: a body in the plane shears. Both at the size asked for and, "
     "named so, at the size that the lattice has."},
    {CONCERN_BEAM | CONCERN_DEFLECTION, METHOD_PD, "supports", "one node at each end, at an unnamed height.",
     "the node at mid-height (of an even number of rows the lower one): along and across at the left, across "
     "at the right; the start is zero there before the first force."},
    {CONCERN_MOTION, METHOD_PD, "the clamp", "the displacements across are zero inside the channel.",
     "motion.clamp = full also carries the nodes inside along at the beam's speed; guide is the paper's "
     "words, and lets the root turn inside its channel."},
    {CONCERN_NOTCH, METHOD_PD, "dimensions", "in figure 8, which cannot be read; 58 800 points at .5 mm.",
     "210 x 70 mm, of which 58 800 points is 420 x 140; notch 17.5 mm deep at 65 mm, supports at 5 and 205 "
     "mm, load at the middle. The dimensions are ours."},
    {CONCERN_NOTCH, METHOD_PD, "density and thickness", "not given.", "2400 kg/m^3 and 25.4 mm."},
    {CONCERN_NOTCH, METHOD_PD, "width of the load", "not given.",
     "3 mm. It rules when the crack begins: with 5 mm it begins a quarter earlier."},
    {CONCERN_NOTCH, METHOD_PD, "protected zone", "not given.",
     "bonds nearer than 3 mm to load or supports never break (pd.protected); without it load and supports "
     "tear off and the notch stays closed."},
    {CONCERN_NOTCH, METHOD_PD, "supports", "not given.",
     "across only; the left one along too with supports.pinned."},
    {CONCERN_NOTCH, METHOD_PD, "the experiment", "figure 10 shows its crack.",
     "only the paper's words are shown: about 30 degrees at first, then towards the load and not to it, "
     "through at 250 us. The picture itself is not in the text."},
};

const int n_choices = sizeof choices / sizeof *choices;

bool choice_is_about(const Choice *choice, const Problem *problem, MethodKind method)
{
    return choice->method == method && (problem->concerns & choice->concerns) == choice->concerns;
}
