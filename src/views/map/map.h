/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The map of a beam: the nodes of a two-dimensional simulation as they lie, deformed, on a grid of cells. Any
 * experiment's beam can be drawn into any area: all that is read is the Screen that is handed over. Private
 * to src/view. Lengths in m; columns and rows are cells of the area, a row counted downwards. */
#ifndef VIEW_MAP_H
#define VIEW_MAP_H

#include "panes/panes.h"
#include "picture/picture.h"
#include "panes/stage_flow.h"
#include "views/plots/runs.h"

#include <math.h>

/* The lattice of nodes: node k lies in column k % nx and row k / nx, row 0 below. */
typedef struct Body {
    size_t count;
    int nx, ny;
    double spacing;
    double first[2]; /* reference position of node 0 */
    double low[2], size[2];
} Body;

/* What the nodes are coloured by: a row of the table in map_colour.c. */
typedef struct Colouring {
    const char *field, *label, *meaning, *unit;
    bool is_signed;   /* zero in the middle of the ramp */
    const char *flat; /* its meaning where the body is neither long nor thin; NULL: the same */
} Colouring;

/* What lies over a cell: dots of lines, or the letter that stands for them where there are no dots. */
typedef struct MapMark {
    uint8_t dots, rank;
    uint16_t style;
    uint32_t letter;
} MapMark;

typedef struct Map Map;

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
    int around;   /* rows above and below the body that a drawing of it needs */
    double probe[2]; /* where the motion is measured: shares of length and height */
} MapScene;

MapScene map_scene(const Settings *);

/* A piece of a cell, and the nodes that cover it. */
typedef struct Pixel {
    float sum, count, broken;
} Pixel;

struct Map {
    const Screen *screen;
    const Simulation *sim;
    const Settings *settings;
    Area area;
    Picture *picture; /* to be made for a page or words; NULL: it is drawn in cells */
    Body body;
    MapScene scene;
    int legend_at; /* column from which the lines are named; 0: no room */

    /* where things are drawn */
    double scale_x, scale_y; /* columns and rows for a metre */
    double middle[2];        /* the place that stands in the middle of the area */
    double stretch;          /* of the height; 1: to scale */
    double enlarged;         /* factor of the displacements */
    bool nodes_seen;         /* so large that nodes are dots and bonds lines */

    /* fields of all nodes, in one block */
    double *block;
    double *ux, *uy, *value, *damage;
    const Colouring *colouring;
    double low, high; /* range of the ramp */
    bool open_ended;  /* some values lie above it */

    /* pixels of the heat map, marks of cells, in one block */
    bool coloured;    /* a cell shows two colours, one above the other */
    int across, down; /* pixels in a cell */
    Pixel *pixels;
    MapMark *marks;
};

/* The words of view.colour in their order; the last is the drawing with its dimensions. */
typedef enum MapVariant {
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
    MAP_COLOURINGS,
    MAP_DRAWING = MAP_COLOURINGS,
    MAP_VARIANTS
} MapVariant;

/* Of these a simulation has those whose field it has, and the drawing: how many, and which. */
int map_variants(const Simulation *);
MapVariant map_variant(const Simulation *, int number);

/* Fills values and range of the ramp, whose ends are round. False: the nodes have no such field. */
bool map_colour(Map *, MapVariant);
const char *map_meaning(const Map *); /* what the colours stand for, in words */

/* Lattice, fields but map->value, and scales. False: this is no beam, or no memory. map_close() in any case.
 */
bool map_open(Map *, const Screen *, Area);
void map_close(Map *);

bool body_of(const Simulation *, Body *);

#define MAP_FAR 1e6 /* cells */

/* Where a place is drawn that is displaced by (ux, uy). Here, since it is asked for each node of a frame. */
static inline void map_place(const Map *map, double x, double y, double ux, double uy, double *column,
                             double *row)
{
    const double along = map->scene.leaves ? 1 : map->enlarged;
    const double right = (x + along * ux - map->middle[0]) * map->scale_x;
    const double up = (y + map->enlarged * uy - map->middle[1]) * map->scale_y;
    /* a run that has become unstable has nodes anywhere and nowhere */
    *column = fabs(right) < MAP_FAR ? map->area.rect.width / 2.0 + right : -MAP_FAR;
    *row = fabs(up) < MAP_FAR ? map->area.rect.height / 2.0 - up : -MAP_FAR;
}

void map_node_place(const Map *, size_t node, double *column, double *row);

/* Where a place of the undeformed body is drawn now: it goes with the nodes around it. */
void map_body_place(const Map *, double x, double y, double *column, double *row);

/* The place of the undeformed body that is drawn in the middle of a cell, m. */
void map_place_of(const Map *, int x, int y, double place[2]);

/* The node drawn nearest to the middle of a cell; -1: none is near. */
long map_node_at(const Map *, int x, int y);

/* How far a field will reach in this run, as far as can be known: so that scales keep still. */
double map_reach(const Map *, int field, const double *now);

/* A line between two places of the area in cells, drawn with dots (every n-th) or a letter; letter 0: one
 * that shows the direction. Of two marks in a cell that of higher rank is seen. */
typedef struct Pen {
    Style style;
    int rank, every;
    uint32_t letter;
} Pen;
void map_line(Map *, double from_x, double from_y, double to_x, double to_y, Pen);

/* A line between two places of the body (m), bent with it. */
void map_body_line(Map *, const double from[2], const double to[2], Pen);

/* Both ends of a row as places in the body, m: of a load along its edge; of the probe twice the same; and the
 * arrow of a traction. */
void map_row_ends(const Settings *, int kind, int row, double ends[2][2]);
uint32_t map_arrow(double sx, double sy);

/* Earlier runs, of those that are kept, in which the notched beam cracked: how many. */
int map_cracks_before(const Map *, ShownRun[RUNS_MAX]);

/* The parts of the picture, in the order in which they are drawn. */
void map_draw_heat(Map *);
void map_draw_bonds(Map *);
void map_draw_mesh(Map *);
void map_draw_lines(Map *);           /* channel, notch, protected zones, crack, with the bonds */
void map_draw_rows(Map *);            /* what a plate has by rows, and its cracks; by map_draw_lines() */
void map_draw_row_signs(const Map *); /* likewise loads, tips, probe; by map_draw_signs() */
void map_draw_nodes(Map *);
void map_draw_mesh_nodes(Map *);
void map_draw_signs(Map *); /* supports, load, chosen node */

/* A mesh is drawn under the particles that are seen one by one; what flows in the stage just done (inside:
 * one has been); "cross 0.56, -0.02 MPa": the principal stresses that are drawn on the chosen particle. */
bool map_has_mesh(const Map *);
Flow map_flow(const Map *, bool *inside);
void map_cross_text(const Map *, char *out, size_t size);

/* The picture on paper; and how lines and signs go into it, at places in columns and rows of the area. */
void map_picture(Map *);
#define MAP_MILLI 1e-3
void map_picture_place(const Map *, double column, double row, double *x, double *y); /* of the body, in mm */
void map_picture_line(Map *, double from_x, double from_y, double to_x, double to_y, Style, int every);
void map_picture_sign(Map *, double column, double row, uint32_t glyph, Style);

/* The beam before it moves, with its dimensions. */
void map_drawing(const Screen *, Area, Style heading, Picture *);

/* The glyph for a step of the ramp where colours are few, and beside colours: more ink for more; of a signed
 * field those below and above zero differ. */
uint32_t map_letter(const Map *, int step);
int map_step(const Map *, double value); /* 0 to RAMP_STEPS - 1 */
Style map_ink(int step);                 /* what is seen on a cell of that colour */

#endif
