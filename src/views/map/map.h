/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The map of a beam: the nodes of a two-dimensional simulation as they lie, deformed, as a picture. Any
 * experiment's beam can be described: all that is read is the Screen that is handed over. Private to
 * src/views. Lengths in m. */
#ifndef VIEWS_MAP_MAP_H
#define VIEWS_MAP_MAP_H

#include "panes/screen.h"
#include "picture/picture.h"
#include "views/plots/plots.h"

/* The lattice of nodes: node k lies in column k % nx and row k / nx, row 0 below. Particles anywhere are one
 * row, and `low` and `size` are of their box. */
typedef struct Body {
    size_t count;
    int nx, ny;
    double spacing;
    double first[2]; /* reference position of node 0 */
    double low[2], size[2];
} Body;

/* What the nodes are coloured by: a row of the table in map_drawing.c. */
typedef struct Colouring {
    const char *field, *label, *meaning, *unit;
    bool is_signed;   /* zero in the middle of the ramp */
    const char *flat; /* its meaning where the body is neither long nor thin; NULL: the same */
} Colouring;

/* What the run is made of that its picture shows besides the body itself, by the concerns of its problem. */
typedef struct MapScene {
    bool slender; /* a beam: along it and across it mean something */
    bool bent;    /* it begins bent, held at its ends */
    bool by_rows; /* cuts, loads and supports are rows of the scenario */
    bool leaves;  /* it comes out of a channel: the picture has room for its way, and displacements along it
                   * are drawn as they are */
    bool pressed; /* a load above, supports below: it is deep, and keeps its shape when it bends */
    bool notched; /* cut from below, with a crack to come */
    bool pinned;  /* its left support holds both ways */
    bool bodies;  /* particles anywhere in a box with walls */
    int around;   /* rows above and below the body that a drawing of it needs */
    double probe[2]; /* where the motion is measured: shares of length and height */
} MapScene;

MapScene map_scene(const Settings *);

typedef struct Map {
    const Screen *screen;
    const Simulation *sim;
    const Settings *settings;
    Picture *picture;
    PictureMap *drawn; /* the nodes in it: where they are drawn, and their values */
    Body body;
    MapScene scene;
    double *ux, *uy; /* of all nodes, in one block */
    const Colouring *colouring;
} Map;

/* The words of view.colour in their order; the last is the drawing with its dimensions. */
typedef enum MapVariant {
    MAP_BODY,
    MAP_UY,
    MAP_UX,
    MAP_VELOCITY,
    MAP_ENERGY,
    MAP_DAMAGE,
    MAP_FAMILY,
    MAP_SURFACE,
    MAP_SXX,
    MAP_SYY,
    MAP_SXY,
    MAP_MISES,
    MAP_KINETIC,
    MAP_SPEED,
    MAP_PRESSURE,
    MAP_DET_F,
    MAP_COLOURINGS,
    MAP_DRAWING = MAP_COLOURINGS,
    MAP_VARIANTS
} MapVariant;

/* Of these a simulation has those whose field it has, and the drawing; MAP_VARIANTS: there are no more. */
MapVariant map_variant(const Simulation *, int number);

/* Fills values and range of the colours, whose ends are round. False: the nodes have no such field. */
bool map_colour(Map *, MapVariant);

/* Lattice and where its nodes are drawn in a picture that is open. False: this is not a beam, there is no
 * room for it, or no memory. map_close() in any case. */
bool map_open(Map *, const Screen *, Picture *);
void map_close(Map *);

bool body_of(const Simulation *, Body *);

/* Where a place of the undeformed body is drawn now: it goes with the nodes around it. */
void map_body_place(const Map *, double x, double y, double place[2]);

/* How far a field will reach in this run, as far as can be known: so that scales keep still. */
double map_reach(const Map *, int field, const double *now);

/* A line between two places of the body, bent with it; and one that stays as it is. */
void map_body_line(Map *, const double from[2], const double to[2], Stroke pen);

/* Both ends of a row as places in the body, m: of a load along its edge, of the probe twice the same. */
void map_row_ends(const Settings *, int kind, int row, double ends[2][2]);

/* The corners of a row that is a rectangle, the first one again at the end. */
void map_row_corners(double ends[2][2], double corners[5][2]);

/* Which way is out at an edge of a plate: to the right, upwards. */
void map_row_side(int edge, signed char side[2]);

/* Earlier runs, of those that are kept, in which the body cracked: how many. */
int map_cracks_before(const Map *, ShownRun[RUNS_MAX]);

/* The parts of the picture, in the order in which they are drawn. */
void map_add_bonds(Map *);
void map_add_box(Map *);        /* of bodies: cells of the grid, walls, gravity */
void map_add_velocities(Map *); /* of bodies coloured by their speed: an arrow on some of the particles */
void map_add_mesh(Map *);
void map_add_lines(Map *); /* channel, notch, protected zones, crack; what a plate has by rows */
void map_add_signs(Map *); /* supports, loads, tips, probe, chosen node */

/* A mesh is drawn under the particles that are seen one by one; "cross 0.56, -0.02 MPa": the principal
 * stresses that are drawn on the chosen particle. */
bool map_has_mesh(const Map *);
void map_cross_text(const Map *, char *out, size_t size);

/* The beam before it moves, with its dimensions. */
void map_drawing(const Screen *, Picture *);

/* The directions in which a stress of the plane has no shear. Pa, tension positive. */
typedef struct Principal {
    double most, least; /* the two principal stresses */
    double angle;       /* of the direction of the first, radians from x towards y, -pi/2 to pi/2 */
} Principal;

Principal principal_stresses(double xx, double yy, double xy);

#endif
