/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What every front end knows of a method: nothing else.
 *
 * A Simulation is one problem, discretised by one method, at one moment. What never changes during the run
 * (parameters, lattice, bonds) is its model; what changes is its state, which can be copied out and put back
 * at any stage. A time step is a loop over a table of stages; the fast path runs the same stage functions.
 *
 * Front ends see named arrays (fields) over sets of things (particles, nodes, bonds), a row of numbers per
 * time step (the series), the stages with their equations, and links between things (who gives to whom).
 * What of this a simulation has (a mesh, bonds, a lattice in the plane ...) is listed
 * in Simulation.has: no front end needs to know the method or the problem to decide what can be shown.
 *
 * Files of this folder use no clock, no screen, no file, no printf, no exit, no rand and no global state.
 * Every result is a function of the parameters alone: the same bits forwards, rewound, sliced, observed or
 * not, at any number of threads and any vector width. */
#ifndef METHODS_METHOD_H
#define METHODS_METHOD_H

#include "base/status.h"

#include <stdbool.h>
#include <stddef.h>

/* Something measured: a column of a CSV file and a curve on the screen. */
typedef struct Quantity {
    const char *name;    /* column name: ASCII, no unit, e.g. "v_cm" */
    const char *label;   /* on screen, short, e.g. "v_cm" or "stress" */
    const char *unit;    /* "m/s"; in a problem without units its dimension, "length/time" */
    const char *meaning; /* one line for people */
} Quantity;

/* A kind of thing that fields live on. */
typedef struct Set {
    const char *name;   /* "particle", "node", "bond": the index column of its CSV table */
    const char *plural; /* "particles": the command line option that writes its table */
    /* How many stages of a step must have run before a table of this set is worth writing: 0 for particles;
     * for nodes of a grid that is forgotten at the end of the step, all stages before the momentum is
     * integrated. A writer snapshots, runs that many stages, reads, restores. */
    int ready_after;
} Set;

/* A named array over one set. */
typedef struct Field {
    Quantity quantity;
    int set;        /* index into Simulation.sets */
    bool in_table;  /* a column of the set's CSV table (in the order of the field table) */
    bool integer;   /* values are whole numbers (indices, flags) */
    int kind, axis; /* the method's own: what it is, of which direction */
} Field;

/* A row of a method's field table. */
#define FIELD_ROW(kind, axis, set, in_table, integer, name, label, unit, meaning)                            \
    {                                                                                                        \
        {name, label, unit, meaning}, set, in_table, integer, kind, axis                                     \
    }

/* In the equation of a stage that a wrong code does, what differs from the right one stands between these
 * marks; text_to_ascii() makes the second pair of them. */
#define STAGE_WRONG_OPEN        "»"
#define STAGE_WRONG_CLOSE       "«"
#define STAGE_WRONG_OPEN_ASCII  ">>"
#define STAGE_WRONG_CLOSE_ASCII "<<"

/* One stage of a time step. */
typedef struct Stage {
    const char *id;       /* "map", "strain": stable, for scripts and tests */
    const char *name;     /* "map to nodes" */
    const char *equation; /* as shown on screen, UTF-8, at most 76 columns a line, lines separated by '\n' */
    const char *source;   /* "eqs. 2, 3" */
    const char *sentence; /* what happens, in one sentence for a student */
    const char *reads;    /* names of fields, separated by spaces */
    const char *writes;
} Stage;

/* What a stage says in runs of which some conditions hold, bits that are the method's own. Of each group of
 * conditions (ended by 0) at most one holds in a run; of a group of which `when` names none any will do. A
 * stage says what the last row that is for the run says of it, a member that is not said there as in a row
 * before. */
typedef struct StageWords {
    int stage;
    unsigned when;
    Stage words;
} StageWords;
#define STAGE_WORDS(stage, when, ...)                                                                        \
    {                                                                                                        \
        stage, when,                                                                                         \
        {                                                                                                    \
            __VA_ARGS__                                                                                      \
        }                                                                                                    \
    }
bool stage_when(unsigned when, unsigned run, const unsigned *groups);
Stage stage_words(const StageWords *, size_t count, int stage, unsigned run, const unsigned *groups);

enum { SIMULATION_EVENTS_MAX = 256, SIMULATION_SERIES_MAX = 112, SIMULATION_DIMENSIONS_MAX = 2 };

/* What a simulation has: bits of Simulation.has. */
enum {
    HAS_MESH =
        1 << 0, /* set 1 are the nodes of a grid with which the particles of set 0 exchange: shapes() */
    HAS_BONDS = 1 << 1,    /* the things of set 0 act on each other by bonds: links() of set 0 are these */
    HAS_LINE = 1 << 2,     /* set 0 lies along a line: places have one component */
    HAS_PLANE = 1 << 3,    /* set 0 lies in rows and columns of a plane: places have two */
    HAS_BREAKING = 1 << 4, /* bonds can break in this run */
    HAS_STRETCH = 1 << 5,  /* the things of set 0 have the largest stretch of their bonds: field "stretch" */
    HAS_ROWS = 1 << 6,     /* its body has any number of cuts, loads, supports ... */
    HAS_FRONTS = 1 << 7,   /* and cracks may run from the ends of its cuts: fronts.h follows them */
    /* The energies of the series are those beside the body's common speed: the work of what moves it so is no
     * part of their balance. */
    HAS_RELATIVE_ENERGY = 1 << 8,
    /* set 0 are particles of bodies anywhere in the plane, in no rows: field "body" says of which; set 1 are
     * the nodes of each body's own grid, one grid after the other */
    HAS_BODIES = 1 << 9
};

/* "set_from[index_from] and the other are linked": a particle and a node of its cell, the two ends of a bond.
 */
enum { LINK_FACTORS = 4 };
typedef struct Link {
    int set;       /* of the other end */
    size_t index;  /* of the other end */
    bool mirrored; /* the other end is the mirror image of that one, beyond a fixed end */

    /* of a particle and a node of the mesh */
    double weight;                              /* shape function N of the pair */
    double gradient[SIMULATION_DIMENSIONS_MAX]; /* dN/dx, dN/dy; 0 in a direction that there is not */

    /* of a bond */
    double stretch;
    double stiffness; /* K = c G w V of its force density K s, as the code at work has it; broken: 0 */
    bool broken;      /* it carries nothing any more */
    long broken_at;   /* of such a one: the step after which it was broken; 0: before the run, by a notch */
    double apart[SIMULATION_DIMENSIONS_MAX];     /* to the other end at rest, along a line to an image too */
    double direction[SIMULATION_DIMENSIONS_MAX]; /* in which it pulls now, a unit vector */
    /* c, G, w and V of K: micromodulus at its length, mean surface factor, share of the other end's volume
     * within reach, that volume */
    double factors[LINK_FACTORS];
} Link;

/* The force density that a bond gives: > 0 pulls towards the other end. */
static inline double link_pull(const Link *link)
{
    return link->stiffness * link->stretch;
}

/* Before the number of the other end, where that is meant. */
static inline const char *link_mirror(const Link *link)
{
    return link->mirrored ? "the mirror of " : "";
}

/* What linked things give to each other in a stage: for each pair a product of a few numbers. The products
 * that one thing is given add up to a field of it: a node's momentum is the sum of "m v N" of its particles.
 */
enum { EXCHANGE_FACTORS_MAX = 4 };
typedef struct Exchange {
    const char *stage;   /* id of the stage that does it */
    int from, to;        /* sets */
    const char *field;   /* of the receiver: what the products add up to */
    bool adds;           /* they are added to what the field was before the stage */
    const char *factors; /* their names, one word each: "m v N", UTF-8 */
    const char *note;    /* what a factor stands for, or NULL: "a = f/m" */
} Exchange;

/* What one pair gives: a product of so many factors; none: it is 0. */
typedef struct ExchangeTerm {
    double product, factors[EXCHANGE_FACTORS_MAX];
    int count;
} ExchangeTerm;

/* The factors of a product, for Method.exchange; return how many they are. */
static inline int exchange_two(double factors[EXCHANGE_FACTORS_MAX], double a, double b)
{
    factors[0] = a, factors[1] = b;
    return 2;
}

static inline int exchange_three(double factors[EXCHANGE_FACTORS_MAX], double a, double b, double c)
{
    factors[0] = a, factors[1] = b, factors[2] = c;
    return 3;
}

/* Something that happened in the run: in plain words, as the log and the caption show it. */
typedef enum EventKind {
    EVENT_CROSSING, /* a particle entered another cell */
    EVENT_BREAK,    /* a bond broke (the first, the twentieth, ... : not every one) */
    EVENT_TOUCH,    /* two bodies, or a body and a wall, push each other for the first time */
    EVENT_PART,     /* and first do so no more */
    EVENT_TEAR,     /* neighbouring particles of a body have parted */
    EVENT_ENERGY,   /* the energy left the range that the method promises */
    EVENT_CHANGE,   /* a live parameter was changed */
    EVENT_REST,     /* the motion has come to an end */
    EVENT_FAILURE,  /* the run stopped: the text is the failure's */
    EVENT_ADVICE,   /* not of a method: a limit is near, known beforehand */
    EVENT_LATE,     /* not of a method: the run lags behind the exact answer */
    EVENT_KINDS
} EventKind;

typedef struct Event {
    long step; /* the step after which it is true */
    EventKind kind;
    char text[120]; /* "particle 49 crossed into cell 25" */
} Event;

/* How many events of each kind there are. */
typedef struct EventCounts {
    long of[EVENT_KINDS];
} EventCounts;

typedef struct Simulation Simulation;

/* The verbs of a method. Each gets the simulation it belongs to. */
typedef struct Method {
    const char *name; /* "mpm", "pd" */
    const char *title;

    void (*destroy)(Simulation *);

    /* Does items [first, end) of a stage; items are cells, rows of a lattice, ... as the method likes.
     * A stage may be cut anywhere into consecutive slices, done in order: the bits are the same. False: the
     * run cannot go on; the status names particle or node, step and time. */
    bool (*stage)(Simulation *, int stage, size_t first, size_t end, Status *);

    /* NULL, or whole steps faster than stage by stage, with the same bits; called between steps only.
     * With `rows` it writes the series row of each of these steps (n_series numbers each). On failure the
     * simulation stands at the last whole step that is sound and *done is how many were. */
    bool (*steps)(Simulation *, long count, double *rows, long *done, Status *);

    /* Called between steps only: the series at the present state. Must not change what comes. */
    void (*row)(Simulation *, double *row);

    /* The columns of the series that are there only where somebody asks for them, ended by NULL: those that
     * cost more than the step does, and forces and momenta; ".touching": of each body. NULL: there is none.
     */
    const char *const *on_request;

    /* Values [first, first + count) of a field at the present stage. */
    void (*field)(const Simulation *, int field, size_t first, size_t count, double *out);

    /* The links of one thing, the first `max` of them; returns how many were written. May be NULL. */
    size_t (*links)(const Simulation *, int set, size_t index, Link *out, size_t max);

    /* The shape functions of the mesh at a place (x, or x and y): one link for each node that has a part
     * there; 0: the place is outside. NULL: there is no mesh. */
    size_t (*shapes)(const Simulation *, const double *place, Link *out, size_t max);

    /* The factors of what thing `index` exchanges with the other end of one of its links; returns how many
     * there are. 0: they are not at hand at the present stage, or the pair exchanges nothing. NULL: there are
     * no exchanges. */
    int (*exchange)(const Simulation *, int exchange, size_t index, const Link *,
                    double factors[EXCHANGE_FACTORS_MAX]);

    /* The loads on a thing of the first set along an axis, as force per volume, at the time that its place is
     * of. NULL: they are not known as such. */
    double (*load_on)(const Simulation *, size_t index, int axis);

    /* The sums behind the stage just done, for one thing, written out with their numbers, which add up as
     * they stand: "p15 = 0.5 × (0.25 × 0.5 + 0.75 × 0.5) = 0.25". UTF-8, one sum a line, each line ended by
     * '\n', of any length: it may be broken at spaces (no-break spaces hold terms together). At most `size`
     * bytes. A sum of more than `terms` terms sums the last of them up (0: never). `before` is the state
     * before the stage as simulation_save() wrote it (NULL: not known). May be NULL: nothing to say. */
    void (*explain)(const Simulation *, int stage, int set, size_t index, const void *before, int terms,
                    char *out, size_t size);

    /* How many bytes of Simulation.state are at work: between steps fewer, perhaps, than in the middle of
     * one. load() sees what they were at the same stage of the same simulation. */
    size_t (*state_size)(const Simulation *);
    void (*load)(Simulation *, const void *bytes);

    /* The state of a motion so small that no place changes, as a vector x: sqrt(m) v and `unit` times
     * sqrt(V/E) stress of each thing, so that |x|^2 is twice the energy where unit is 1. It is read, or put
     * as the state between steps; x NULL: neither. Returns how many numbers. NULL: not known. */
    size_t (*small)(Simulation *, double *x, double unit, bool put);

    /* Changes a parameter that may change in mid-run, between steps: key as in a scenario file, value as
     * number (the index for a choice). False: not a live parameter of this method, or a bad value. */
    bool (*change)(Simulation *, const char *key, double value, Status *);
} Method;

/* A simulation; each method's own struct begins with it. Read only for front ends. */
struct Simulation {
    const Method *method;

    const Stage *stages; /* of the present algorithm; may change between steps with a live parameter */
    int n_stages;
    size_t stage_items; /* how many items a stage has */

    const Exchange *exchanges; /* of the present algorithm, as the stages are */
    int n_exchanges;

    const Set *sets;
    int n_sets;
    size_t counts[4]; /* things in each set */

    const Field *fields;
    int n_fields;

    const Quantity *series;
    int n_series;
    Quantity series_own[SIMULATION_SERIES_MAX]; /* of the method, and which of its columns each is */
    int series_entry[SIMULATION_SERIES_MAX];
    int n_askable;         /* of series_own: those in the series, then those that nobody asked for */
    struct Follow *follow; /* things that are followed, behind the method's own series; NULL: none */

    unsigned has; /* HAS_... */

    const void *state; /* one block that is all of the state; what it means is the method's */

    /* How set 0 lies at rest: thing k in column k % columns and row k / columns, row 0 lowest, neighbours
     * `spacing` apart both ways (m, or the problem's unit of length). A line has one row. */
    size_t columns, rows;
    double spacing;

    /* Where things are: fields of set 0, one per dimension, -1 for a direction that there is not. */
    int dimensions;
    int position[SIMULATION_DIMENSIONS_MAX];
    int displacement[SIMULATION_DIMENSIONS_MAX];
    int velocity[SIMULATION_DIMENSIONS_MAX];

    double common_speed; /* with which the body moves along x as a whole; else 0 */

    double dt;   /* the time step in use */
    long step;   /* whole steps done */
    int stage;   /* stages of the current step done: 0 between steps */
    size_t item; /* items of the current stage done: 0 but in the middle of a sliced stage */

    Event events[SIMULATION_EVENTS_MAX]; /* the first ones; later ones are counted only */
    int n_events;
    EventCounts events_beyond;

    double kinetic_left; /* of a run that is to end at rest: its kinetic energy over the largest; else 0 */
    bool at_rest; /* the run was to end at rest, and has: nothing moves any more; simulation_steps() stands */

    /* Set by who keeps the rows of the series and does not need all of them whole: what takes long to find
     * (and was not left out) may be NAN in the others. */
    bool spares_rows; /* whole is the last one of a call of simulation_steps() */
    long whole_rows;  /* whole are those of steps that are multiples of it; 0: of all */

    bool failed; /* the run cannot go on; failure says why */
    Status failure;
};

/* The part of a field of set 0 that comes from the common speed alone: v0 t of the displacement along x, v0
 * of the velocity. */
double simulation_carried(const Simulation *, int field);

/* Whether it has all of these (HAS_...). */
bool simulation_has(const Simulation *, unsigned what);

/* Whether set 0 lies in a plane, in rows or anywhere: there is a map of it. */
bool simulation_has_map(const Simulation *);

/* step * dt: never accumulated. */
double simulation_time(const Simulation *);

/* Does at most `items` items of the current stage (0: all that is left of it). *stage_done says whether the
 * stage came to its end; after the last stage the step is counted. False: the simulation failed. */
bool simulation_slice(Simulation *, size_t items, bool *stage_done, Status *);

/* Does the next stage, or what is left of it. */
bool simulation_stage(Simulation *, Status *);

/* Finishes the step that has begun, if one has; then `count` whole steps, fewer where it comes to rest.
 * `rows` may be NULL, else it takes one series row per whole step counted. *done (may be NULL) is how many
 * steps were counted. */
bool simulation_steps(Simulation *, long count, double *rows, long *done, Status *);

/* How many whole steps may be done before somebody is asked whether to go on: some ten milliseconds of work,
 * whatever the size. Steps of very large models take longer than that each. */
long simulation_steps_per_poll(const Simulation *);

/* The series at the present state; between steps only. */
void simulation_row(Simulation *, double *row);

/* The names of things that are followed are the simulation's own: who keeps a copy of its series' quantities
 * for longer than it lives holds them too. NULL, which may be released: nothing is followed. */
struct Follow *simulation_hold_names(const Simulation *);
void simulation_release_names(struct Follow *);

/* From now on a field of one thing is one more column of the series, "particle_12_velocity": what is asked
 * for as "particle 12 velocity", with the name of a set, a number, and a field's name or label. Of a set that
 * is ready only after some stages (a grid's nodes) it is the value that these stages of the next step give,
 * as in its table. Runs with such a column do their steps one by one, with the same bits. False: there is no
 * such thing; the status says what there is. Before the first step only. */
enum { FOLLOW_MAX = 4, FOLLOW_TEXT_MAX = 64 };
bool simulation_follow(Simulation *, const char *thing, Status *);

/* Leaves out of the series the columns that are there on request, but for those that are asked for: names
 * separated by commas, or "all"; "": none. Before the first step, and before anything is followed. */
void simulation_ask_columns(Simulation *, const char *names);

/* Whether such a list has a column, and whether it is one that it takes. */
bool simulation_asks(const char *names, const char *column);
bool simulation_is_on_request(const Simulation *, const char *column);

/* The state as bytes, Method.state_size() of them. */
void simulation_save(const Simulation *, void *bytes);

/* A snapshot: the state with step and stage. Taken between slices of a stage it is that of its beginning,
 * so take it between stages. */
size_t simulation_snapshot_size(const Simulation *);
void simulation_snapshot(const Simulation *, void *bytes);

/* Puts a snapshot of this simulation back; events after it are forgotten, a failure too. */
void simulation_restore(Simulation *, const void *bytes);

/* Puts a snapshot back (NULL: none, it stays where it is), lets somebody look at that moment (NULL: nobody)
 * and go on from it as he likes, and comes back to the present. False: no memory, nobody has looked. */
bool simulation_visit(Simulation *, const void *there, void (*look)(Simulation *, void *context),
                      void *context);

/* One step ahead and back: the velocities of set 0 before and after it, one component after the other, and
 * the energy of strain ("strain" of the series) before and after. False: the step failed, or no memory. */
bool simulation_step_ahead(Simulation *, double *before, double *after, double strain[2]);

/* Goes on, within the step, to where the things of a set are ready (Set.ready_after): for who comes back, as
 * by simulation_visit(). What a stage cannot do any more stays as it stands. */
void simulation_make_ready(Simulation *, int set);

/* The same from between steps to where a stage is done. *before is the state before it, which is the caller's
 * to free; NULL: no memory, or a stage before it failed. */
bool simulation_make_stage(Simulation *, int stage, void **before);

/* A simulation that has failed goes no further even where it stands at a sound moment; from here on it is as
 * one that was brought there, and may walk up to its failure again. False: no memory. */
bool simulation_forget_failure(Simulation *);

/* Appends an event; for methods. Text as by printf's rules is made by the caller. */
void simulation_report(Simulation *, EventKind, const char *text);

/* Marks the simulation as failed; returns false, as status_fail() does. */
bool simulation_fail(Simulation *, Status *, const char *format, ...) __attribute__((format(printf, 3, 4)));

/* For methods, whose fields are listed: set 0 lies in these columns and rows, so far apart. Its motion is in
 * the fields x0, u, v of a line, in x0, ux, vx and y0, uy, vy of the plane. */
void simulation_lay(Simulation *, size_t columns, size_t rows, double spacing, int dimensions);

/* For methods: one more column of the series, which of its own it is. */
void simulation_add_column(Simulation *, int entry, Quantity);

/* One value of a field, by its index or its name; NAN: there is no such field (-1). */
double simulation_value(const Simulation *, int field, size_t index);
double simulation_named(const Simulation *, int set, const char *name, size_t index);

/* Bonds in the order of their pull: the strongest first, broken ones last. */
void simulation_sort_links(Link *, size_t count);

/* What thing `index` and the other end of one of its links exchange (Method.exchange). */
ExchangeTerm simulation_exchange(const Simulation *, int exchange, size_t index, const Link *);

/* The index of a field, series entry or stage by name; -1: there is none. */
int simulation_find_field(const Simulation *, int set, const char *name);
int simulation_find_series(const Simulation *, const char *name);
int simulation_find_stage(const Simulation *, const char *id);

void simulation_destroy(Simulation *); /* NULL is allowed */

#endif
