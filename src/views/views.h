/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Views that others name (all: view_list.c), and pictures that some of them have in a file of their own. */
#ifndef VIEWS_VIEWS_H
#define VIEWS_VIEWS_H

#include "views/view.h"

extern const View view_profile, view_probe, view_energies, view_table, view_beam, view_log;

/* What the inspector shows (inspector/inspector.h); it is in no list, for it has a pane of its own. */
extern const View view_inspector;

/* The body in the pane that is its own, where a map is in neither plot pane; no word shows it. */
extern const View view_strip;

/* Of a body that breaks: the crack's path, angle and speed among the probe's pictures, what it costs and
 * where that went among the energies. A count of 0, a word of NULL: it does not break. */
int crack_variants(const Screen *);
const char *crack_variant_word(int variant);
void crack_describe(const Screen *, int variant, Picture *);
const char *crack_cost_variant_word(const Screen *, int variant);
void crack_cost_describe(const Screen *, int variant, Picture *);

/* Two or three cells of a bar's mesh, with the terms of a stage, or (1) where the mass of a node sits. */
void cell_bar_describe(const Screen *, int variant, Picture *);

/* One bond with its two ends, or the strongest of a family, in the place of a cell where there is no mesh. */
void cell_bonds_describe(const Screen *, int variant, Picture *);

/* A cell of a plane mesh with its nodes. */
void cell_plane_describe(const Screen *, Picture *);

/* A bond's force over its stretch, in the place of shape functions where there is no mesh. */
void bond_law_describe(const Screen *, Picture *);

/* The map with where it is held and loaded alone: where a node lies in it. False: there is none. */
bool view_map_small(const Screen *, Picture *);

/* "640 m/s = 0.30 c_R, fastest 904 = 0.42": how fast a crack's tip is now. */
void beam_lines_tip_speed(const Crack *, double rayleigh, char out[160]);

/* Two lines that tell what a beam's run is judged by, for a pane of so many columns; false: it is a bar,
 * or comes to rest: its findings tell more. */
bool beam_lines(const Screen *, bool narrow, char first[160], char second[160]);

#endif
