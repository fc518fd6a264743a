/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What solvers share: the plan of the columns of a series, the references in full, and what helps to fill
 * them. Not for front ends. */
#ifndef PROBLEMS_SOLVER_H
#define PROBLEMS_SOLVER_H

#include "answers/references.h"
#include "methods/mpm/mpm.h"

/* A column of the series: a number of the method's row, or an answer worked out beside it. */
typedef double Answer(References *, long step, double time, const double *row);

/* One that is an expression of refs, step, time and row. */
#define ANSWER(name, value)                                                                                  \
    static double name(References *refs, long step, double time, const double *row)                          \
    {                                                                                                        \
        (void)refs, (void)step, (void)time, (void)row;                                                       \
        return value;                                                                                        \
    }

typedef struct PlannedColumn {
    Column column;
    int from_method; /* index into the method's row; -1: not from there */
    Answer *answer;  /* NULL: not an answer; step and time are neither */
    bool remembers;  /* the answer depends on earlier rows */
} PlannedColumn;

/* The last rows of one number of the method, for a filter. */
typedef struct Window {
    int of;         /* in the method's row */
    double *values; /* a ring */
    long size, filled, next;
} Window;

struct References {
    const Solver *solver;                /* NULL: none, the simulation came from elsewhere */
    const char *unaccounted[REFERENCES]; /* what each does not account for; NULL: it knows the run */
    PlannedColumn plan[COLUMNS_MAX];
    int n_columns;
    double dt;
    Window window; /* of size 0: nothing is remembered */
    void *own;     /* the solver's: what its answers are worked out from */
    void (*release)(void *own);
};

/* For prepare(): appends columns to the plan. */
void plan_method(References *, const Simulation *, const char *series); /* no such series: nothing */
void plan_rest_of_method(References *, const Simulation *);             /* all that is not planned yet */
/* An answer that is exact or predicted, and is not known, is left out. */
void plan_answer(References *, const Quantity *, ColumnKind, const char *of, Answer *);
void plan_filter(References *, const Quantity *, const char *of, Answer *); /* an answer that remembers */
int plan_find(const References *, const char *column);                      /* -1: there is none */

/* Zeroed memory for what is the solver's own; freed with the references, after `release` (NULL: nothing in it
 * is to be freed). NULL: there is none, the status says so. */
void *plan_own(References *, size_t size, void (*release)(void *own), Status *);

/* So many of the last rows of a series are remembered. False: not enough memory. */
bool plan_window(References *, const Simulation *, const char *series, long rows);

/* One or more cosines in a column fitted by least squares (theory/frequency.h); at most a few thousand of its
 * rows are looked at, spread evenly. `start`: radians per unit time, the frequency expected of the first
 * line. Several lines need a whole period of it, one a half. Fills in what is measured of the readout, whose
 * `times` and `is_period` say what it is of the line; nothing: not yet. */
void readout_fit(const double *rows, size_t n_rows, int n_columns, int column, double start,
                 const double *ratios, int n_lines, Readout *);

/* A Solver's limit where the largest stable Courant number is known; `allowed`: what a refusal says of it. */
bool problem_limit_courant(const Settings *, double largest, double allowed, char *text, size_t size,
                           Status *);

/* Appends a derived number; that of a reference is left out where the reference is not known. */
void derived_add_answer(Derived out[DERIVED_MAX], int *count, Reference, const char *name, const char *label,
                        const char *unit, double value);

void derived_add(Derived out[DERIVED_MAX], int *count, const char *name, const char *label, const char *unit,
                 double value, bool integer);

/* Of all problems by the material point method (by_mpm.c): the definition, and that of a right code; check
 * and simulate of a Solver. */
MpmDef mpm_definition(const Settings *, int threads);
MpmDef mpm_right_definition(const Settings *);
bool mpm_check_settings(const Settings *, Status *);
Simulation *mpm_simulate(const Settings *, int threads, Status *);

/* For the rows of problems: their parameters, and the solvers that there are. */

/* The head of a ParameterUse. */
#define USE(name, value) .key = name, .usual = value

/* Of a problem: its parameters, its solvers, and that numbers are in units of one's own. */
#define USES(rows) .uses = rows, .n_uses = sizeof rows / sizeof *rows
#define SOLVED_BY(...)                                                                                       \
    .solvers = (const Solver *const[])                                                                       \
    {                                                                                                        \
        __VA_ARGS__, NULL                                                                                    \
    }
#define IN_OWN_UNITS .answer = "exact", .unit_of_time = "time", .shown_time = 1, .shown_time_unit = ""

extern const Solver bar_by_mpm, bar_by_pd;
extern const Solver beam_by_mpm_supported, beam_by_mpm_moving;
extern const Solver beam_by_pd_supported, beam_by_pd_moving, beam_by_pd_notched, beam_by_pd_plate;

#endif
