/* The panes of the screen: each draws itself into an area from what the screen says. Private to src/view. */
#ifndef VIEW_PANES_H
#define VIEW_PANES_H

#include "base/text.h"
#include "view/draw/area.h"
#include "view/draw/axes.h"
#include "view/draw/plot.h"
#include "view/panes/screen.h"

/* --- where panes lie --- */

typedef enum LayoutKind { LAYOUT_TOO_SMALL, LAYOUT_ONE_PANE, LAYOUT_FULL } LayoutKind;

/* From here on the letters of a lecture are twice as large. */
enum { LECTURE_LARGE_WIDTH = 120, LECTURE_LARGE_HEIGHT = 36 };

enum { SIDES_MAX = 3, GUTTER = 6, SIDE_BY_SIDE = 120 /* columns from which on two runs stand so */ };

typedef struct Layout {
    LayoutKind kind;
    Rect title, bar;
    Rect banner;   /* of a lecture; width 0: there is none */
    Rect timeline; /* one row under the plots; width 0: there is none */
    Rect panes[PANE_COUNT];
    Rect sides[SIDES_MAX]; /* what joins on a large screen: energies, particles, nodes */
} Layout;

Layout layout_make(const Screen *, int width, int height);

/* --- the other panes --- */

void pane_title(const Screen *, Area);
void pane_banner(const Screen *, Area);           /* of a lecture: time and state in large letters */
void pane_chosen_parameter(const Screen *, Area); /* of a lecture: the one that the arrows change */
int banner_rows(const Screen *, int width, int height);
void pane_bar(const Screen *, Area);
void pane_parameters(const Screen *, Area);
void pane_lesson(const Screen *, Area);
void pane_timeline(const Screen *, Area);
char pane_timeline_letter(EventKind); /* its mark in the timeline; ' ': it has none */
void pane_mesh(const Screen *, Area);
void pane_lattice(const Screen *, Area);                /* the same for a bar without a mesh */
bool pane_lattice_choose(Screen *, Rect, int x, int y); /* the node near a place of the screen */
void pane_box(const Screen *, Area);
void pane_stage(const Screen *, Area);
void pane_duel(const Screen *, Area); /* the readout of a duel, in place of the box */
void help_draw(const Screen *, Area);
void pane_mesh_inspector(const Screen *, Area); /* of methods with particles and a grid */
void pane_mesh_inspector_move(Screen *, int x, int y, int page);

void pane_bonds(const Screen *, Area); /* of a bar without a mesh */
void pane_bonds_move(Screen *, int x, int y, int page);
void pane_family(const Screen *, Area);                  /* of beams */
void pane_family_move(Screen *, int x, int y, int page); /* chooses the node beside; y downwards */

/* What stands in the inspector; the seam is in inspector.c. */
typedef struct Inspector {
    unsigned needs; /* what the simulation must have, all of it (HAS_...) */
    void (*draw)(const Screen *, Area);
    /* The arrows: to the next thing. NULL: as in the mesh strip. */
    void (*move)(Screen *, int x, int y, int page);
} Inspector;
const Inspector *inspector_find(const Screen *); /* NULL: none fits */

/* "640 m/s = 0.30 c_R, fastest 904 = 0.42": how fast a crack's tip is now. */
void beam_lines_tip_speed(const Crack *, double rayleigh, char out[160]);

/* Two lines that tell what a beam's run is judged by, for a pane of so many columns; false: it is a bar. */
bool beam_lines(const Screen *, int width, char first[160], char second[160]);

/* The scenarios to choose from, on as many rows as there are and fit, above row `bottom`. */
void pane_scenarios(const ScenarioList *, Area, int bottom);

/* The command under a column of the bottom bar; COMMAND_NONE: none. */
CommandId bar_command_at(const Screen *, int width, int x);

/* One parameter with its value, as a row of its own; `chosen`: the arrows change it. */
void pane_parameter(const Screen *, Area, int y, const Parameter *, bool chosen);

/* --- what several of them share --- */

/* One entry of a legend. */
typedef struct Legend {
    LineStyle line;
    char letter;
    Style style;
    const char *name;
    const char *key; /* what stands for it, 2 columns; NULL: a piece of the line */
} Legend;

/* Draws entries of a legend from column x on as far as there is room; returns how many. */
int legend_draw(Area, int x, int y, const Legend *, int n_legend);

enum { LEGENDS_MAX = 32 }; /* under one heading */

/* Draws the heading line of a plot: name, scale, legend as far as there is room. Where it is short names are
 * shortened first; then the solid line of what is measured goes without saying. Returns how many entries of
 * the legend that were. */
int heading_draw(Area, Style heading, const char *name, const char *scale, const Legend *, int n_legend);

/* Writes a hint into a heading line, up to column `end`; false: there is no room behind column `begin`. */
bool heading_hint(const Screen *, Area, int begin, int end, const char *hint);

/* A curve's or a picture's name where room is short: "measured" is "meas", "displacement" is "displ.". */
const char *legend_short_name(const char *name);

/* The second run of a duel; NULL: there is none. */
Experiment *screen_second_run(const Screen *);

/* Both runs of a duel share the picture: what only one of them can have is left to the pictures of one run.
 */
bool screen_is_shared(const Screen *);

/* The screen of one run of a duel, for a picture of its own. */
Screen screen_of_side(const Screen *, DuelSide);

/* The run whose times the axes of time go by: A, in a picture of B as well. */
Experiment *screen_clock_run(const Screen *);

bool screen_shows_exact(const Screen *);
bool screen_shows_predicted(const Screen *);
bool screen_is_focused(const Screen *, PaneId);
bool screen_is_rewound(const Screen *); /* more has been computed than is shown */

/* The time of the run with so many decimals less than the step has, but with two at least where it has them.
 */
void screen_shorter_time(const Screen *, int less, char *out, size_t size);

/* What is settled by the problem of the run shown, its units above all. */
const Problem *screen_problem(const Screen *);

/* "t 12.34" with as many decimals as the time step has: columns do not dance. */
void screen_time_text(const Screen *, double time, char *out, size_t size);

/* One value of a field; NAN: there is no such field (-1). */
double simulation_value(const Simulation *, int field, size_t index);

/* A number for people in at most `width` columns: as many digits as fit, at most `digits`. */
void text_fitted(double value, int digits, int width, char out[NUMBER_TEXT_MAX]);

/* A factor by which something is enlarged: "5000", not "5e3". */
void text_factor(double factor, char out[NUMBER_TEXT_MAX]);

/* How far a particle field reaches: what it is now and, where the exact answer is known, will be; rounded up
 * so that a scale made of it keeps still. */
double screen_field_reach(const Screen *, int field, const double *now, size_t count);

/* The column of the record by name; -1: there is none. */
int screen_column(const Screen *, const char *name);

/* A derived number by name; NAN: there is none. */
double screen_derived(const Screen *, const char *name);

/* The stage that the box speaks of: the last one done (*done) or, between steps, the next. */
int screen_box_stage(const Screen *, bool *done);

/* Appends to a text; what does not fit is cut. */
void text_append(char *out, size_t size, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* Between which things a stage hands on: a name that particles and nodes share (mass, x) counts as the one
 * that the other names of the stage tell. */
typedef enum Flow { FLOW_NONE, FLOW_TO_NODES, FLOW_TO_PARTICLES, FLOW_FORGET } Flow;
/* A factor of 1, 2 or 5 times a power of ten by which a displacement of at most `reach` becomes at most
 * `room`. Taken from what the whole run reaches, so that it does not change while it goes on. */
double axis_enlargement(double reach, double room);

int stage_flow_target(const Simulation *, const Stage *); /* the set that a stage writes to */
Flow stage_flow(const Simulation *, const Stage *);
int stage_flow_field(const Simulation *, int set, const char *name); /* -1: the set has none of that name */

/* Text as the glyphs of the screen have it: with ASCII "→" becomes "->", "Δε" "de", and so on. */
void screen_plain_text(const Screen *, const char *text, char *out, size_t size);

/* " m/s" after a value of a field; "" where it has none, and for the bar, whose units are whatever one likes
 * so long as they fit together. */
void screen_unit_text(const Screen *, const Field *, char *out, size_t size);

/* Names of fields, separated by spaces, one after the other. */
bool text_next_word(const char **text, char *out, size_t size);

#endif
