/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A problem is a row: what it is made of (its concerns, whose parameters it has), their defaults, and who
 * solves it. A solver joins the problem to a method (physics) and to its right answers (theory).
 *
 * To add a problem: a file with its row, and its name in the list of problem_list.c. To add a method to a
 * problem: a file with the solver, and its name in the problem's row. Front ends use the functions below
 * and references.h; they look into no method. */
#ifndef PROBLEMS_PROBLEM_H
#define PROBLEMS_PROBLEM_H

#include "scenario/assignment.h"
#include "methods/method.h"

/* What a problem is made of; each parameter belongs to one of these, and so to the problems that have it. */
enum Concern {
    CONCERN_NONE = 0,            /* of no problem: what a scenario says beside it */
    CONCERN_BAR = 1 << 0,        /* a bar, in any consistent units */
    CONCERN_BEAM = 1 << 1,       /* a beam in the plane, SI units */
    CONCERN_MOTION = 1 << 2,     /* it leaves a channel */
    CONCERN_MODES = 1 << 3,      /* starts with the velocities of modes */
    CONCERN_DEFLECTION = 1 << 4, /* starts with the deflection of a mode */
    CONCERN_MESH = 1 << 5,       /* cells with particles */
    CONCERN_METHODS = 1 << 6,    /* more than one method solves it */
    CONCERN_LATTICE = 1 << 7,    /* nodes with bonds */
    CONCERN_BREAKING = 1 << 8,   /* bonds that break */
    CONCERN_NOTCH = 1 << 9,
    CONCERN_PULL = 1 << 10,     /* body force and traction at the ends */
    CONCERN_PRESSURE = 1 << 11, /* pressure on a stretch of the top */
    CONCERN_SUPPORTS = 1 << 12, /* supports at places of one's own */
    CONCERN_STEP = 1 << 13,     /* the time step itself is given; with a mesh it is a Courant number */
    CONCERN_WAVES = 1 << 14,    /* a pulse, and a second material that it meets */
    CONCERN_PLANE = 1 << 15,    /* cells with particles in the plane */
    CONCERN_SECTIONS = 1 << 16, /* ends held as whole sections, or at a point */
    CONCERN_RIDING = 1 << 17,   /* a mesh that may ride along */
    CONCERN_POINT = 1 << 18,    /* one particle */
    CONCERN_WEIGHT = 1 << 19,   /* a body force alone */
    CONCERN_PLATE = 1 << 20,    /* a rectangle with rows of cuts, loads, supports: settings/rows */
    CONCERN_BODIES = 1 << 21,   /* bodies in a box of cells: rows */
    CONCERN_DAMPING = 1 << 24,  /* a rate at which motion is damped */
    CONCERN_REST = 1 << 25,     /* it may end at rest */
    CONCERN_ANY = ~0            /* every problem: time.end, output */
};

/* Where a parameter differs in this problem from its row. */
typedef struct ParameterUse {
    const char *key;
    double usual;          /* the default */
    const char *automatic; /* a word that stands for 0; NULL: the row's */
    int choices;           /* the first so many of its choices are allowed; 0: all */
    const char *others;    /* what is said of the others: "is for beams" */
    const char *help;      /* NULL: the row's */
    int methods;           /* that read it in this problem (parameters.h); 0: the row's */
} ParameterUse;

typedef struct References References; /* references.h */
typedef struct Readout Readout;
typedef struct Finding Finding;
typedef struct Derived Derived;
typedef struct ModeOnMesh ModeOnMesh; /* answers/dispersion_curves.h */

/* The answers that are beside a run. */
typedef enum Reference {
    REFERENCE_EXACT,     /* the motion of the continuum, or of beam theory: columns, profiles, envelopes */
    REFERENCE_PREDICTED, /* of this mesh or lattice: columns, frequencies, limits */
    REFERENCE_FREQUENCY, /* a steady frequency: measured by a fit, exact, how late the run is */
    REFERENCE_ENERGY,    /* the sharp invariant E* */
    REFERENCES
} Reference;

/* What a reference accounts for: it takes the parameter into its formula, or knows that it has none then, or
 * that the parameter is of no matter to it. Of a parameter that is not named here it knows nothing: in a run
 * where that is not at its neutral value the reference leaves by itself (references.h), with its column,
 * curve and verdict. So a new parameter is named by those references that were made to account for it, and by
 * no others. */
typedef struct Validity {
    const char *const *keys;    /* ended by NULL; NULL: there is no such reference */
    const char *const *changes; /* those of them that may change in mid-run; NULL: none */
} Validity;

/* What a run of some settings is to show, known without it; periods in s, of a bar radians per unit time. */
typedef struct Prediction {
    double predicted;   /* by the equations of this very mesh or lattice; NAN: not known */
    double theory;      /* of the continuum (bar), by Timoshenko's theory (beams), at the size asked for */
    double real_size;   /* the same at the size that the body has on its lattice */
    double real_height; /* of a beam on its lattice, m; NAN: it is a bar */
} Prediction;

/* A problem by a method. What is NULL there is not. */
typedef struct Solver {
    MethodKind method;
    Validity validity[REFERENCES];
    /* A parameter that the reference accounts for, but not together with others as they are; NULL: none. */
    const char *(*unaccounted)(const Settings *, Reference);

    /* Does the whole make sense? Else the status names the key to be changed. */
    bool (*check)(const Settings *, Status *);
    Simulation *(*simulate)(const Settings *, int threads, Status *);
    /* Whether the time step is stable, where the prediction is known; and what else is said before a run: see
     * problem_advice(). */
    bool (*limit)(const Settings *, char *advice, size_t size, Status *);
    bool (*advice)(const Settings *, char *advice, size_t size, Status *);
    int (*derived)(const Settings *, const Simulation *, Derived *out);

    /* Plans the columns of the series with the answers beside (solver.h); works out their coefficients. */
    bool (*prepare)(References *, const Settings *, const Simulation *, Status *);
    double (*profile)(const References *, const char *field, double x, double time);
    double (*section)(const References *, const char *field, double x, double y, double time);
    void (*readout)(const References *, const double *rows, size_t n_rows, int n_columns, Readout *);
    int (*findings)(const References *, const Simulation *, Finding *out);
    double (*envelope)(const References *, const char *column, double time);
    double (*standing_frequency)(const References *, double time);
    int (*thickness_lines)(const References *, double *out);

    bool (*predict)(const Settings *, Prediction *, Status *);

    /* Every mode on this mesh or lattice: how many, and one of them. */
    int (*modes)(const Settings *);
    bool (*mode)(const Settings *, int number, ModeOnMesh *);
    /* The name of another way of the method, and the mode's frequency by it; NULL: behind the last. */
    const char *(*other_way)(const Settings *, int which, int number, double *frequency);

    /* The sharp invariant of the energy (answers/references.h), and whether it is kept. */
    double (*invariant)(Simulation *, const Settings *);
    bool (*invariant_kept)(const Settings *);

    /* Why the energy sinks with these settings: "USL damping"; NULL: not by them. */
    const char *(*damping)(const Settings *);
} Solver;

struct Problem {
    const char *word;  /* in a scenario file: "bar" */
    const char *title; /* "axial vibration of a bar" */
    const char *body;  /* what it is solved for: "bar" */
    int concerns;
    const ParameterUse *uses;
    int n_uses;
    const Solver *const *solvers; /* the usual one first; ended by NULL */
    const char *alone;            /* why no other method does; NULL: nothing is said */

    bool si; /* numbers are in SI units; else in units of one's own that fit each other */
    const char *unit_of_time;
    const char *answer; /* what the answer beside a run is called: "exact", "beam theory" */
    const char *about;  /* what a scenario that does not say is about: a word of answers/run_numbers.h */
    double shown_time;  /* a time is shown as so many of these */
    const char *shown_time_unit; /* with a space before it; "": a bare number */
    bool end_matters;            /* another time.end is another run from the start on */
};

/* For who names one; a new one need not stand here, but in problem_list.c. */
extern const Problem problem_bar, problem_one_particle, problem_hanging_column, problem_supported_beam,
    problem_moving_cantilever, problem_notched_beam, problem_plate, problem_bodies;

enum { PROBLEMS_MAX = 32 };
extern const Problem *const problems[]; /* ended by NULL */

/* The problem of that word; NULL: there is none. */
const Problem *problem_find(const char *word);

const Solver *problem_solver(const Problem *, MethodKind); /* NULL: it cannot be solved by the method */

/* Whether the problem can be solved by the method; false with the status: why not, and by which. */
bool problem_allows(const Problem *, MethodKind, Status *);

/* Whether a run to `end` takes steps that can be counted and done. */
bool problem_check_steps(double end, double dt, Status *);

/* The first step k with k dt >= end (1 - 1e-9): where a run ends; of a run that problem_check_steps()
 * allows. */
long problem_last_step(double dt, double end);

/* The simulation at t = 0. `threads` at least 1. NULL: settings_check() refuses the settings, or there is no
 * memory; the status says why. */
Simulation *problem_simulate(const Settings *, int threads, Status *);

/* The time step of a simulation of these settings; a beam's critical one may have to be found for it. */
bool problem_time_step(const Settings *, double *dt, Status *);

/* Makes settings those of a run that ends at a step: time.end its time, time.step the number in use, changes
 * and named times beyond it left out. Such a run has the same rows up to there. */
void problem_end_at(Settings *, double dt, long step);

/* Derived numbers: wave speed, time step, beta, omega, period, ...; micromodulus, bonds, dt_crit, ... */
struct Derived {
    const char *name;  /* ASCII, for `show` and `params`: "dt" */
    const char *label; /* on screen */
    const char *unit;
    double value;
    bool integer;
    bool by_reference; /* it is an answer, and left out where that is not known */
    Reference reference;
};

enum { DERIVED_MAX = 24 };

int problem_derived(const Settings *, const Simulation *, Derived out[DERIVED_MAX]);

/* The value of that name among them; NAN: there is none. */
double derived_named(const Derived *, int count, const char *name);

/* Said before a run: the Courant number against its limit, horizon over spacing outside 3 to 4. False: the
 * run is refused, the status says why and what is allowed. `advice` is "" where there is nothing to say. */
bool problem_advice(const Settings *, char *advice, size_t size, Status *);

#endif
