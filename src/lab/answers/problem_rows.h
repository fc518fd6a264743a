/* What the files behind problem.h share: one row for each pair of problem and method, and the references in
 * full. Not for front ends. */
#ifndef LAB_PROBLEM_ROWS_H
#define LAB_PROBLEM_ROWS_H

#include "lab/answers/problem.h"
#include "theory/bar.h"
#include "theory/frequency.h"
#include "theory/beam.h"
#include "theory/rod.h"

/* A column of the series: a number of the method's row, or an answer worked out beside it. */
typedef double Answer(References *, long step, double time, const double *row);

typedef struct PlannedColumn {
    Column column;
    int from_method; /* index into the method's row; -1: not from there */
    Answer *answer;  /* NULL: not an answer; step and time are neither */
    bool remembers;  /* the answer depends on earlier rows */
} PlannedColumn;

/* On which column the bar's frequency is measured, and what it should be. */
typedef struct BarWatch {
    bool moving;
    int mode;
    const char *column;
    double times;                       /* the column oscillates so many times as fast as the bar */
    double ratios[FREQUENCY_LINES_MAX]; /* the lines of the column against the one that is measured, which is
                                         * the first */
    int n_lines;                        /* at least 1 */
    double exact, predicted;
    bool predicted_known;
} BarWatch;

typedef struct BarAnswers {
    BarTheory theory;
    BarMesh mesh;     /* by the material point method */
    RodModes *modes;  /* by peridynamics; NULL: v_cm is not predicted */
    bool exact_known; /* false: the load changes in mid-run */
    BarWatch watch;
} BarAnswers;

/* The last rows of the probe's velocity, for the filter. */
typedef struct Window {
    double *values; /* a ring */
    long size, filled, next;
} Window;

typedef struct BeamAnswers {
    BeamTheory theory;                         /* as the scenario says */
    BeamTheory real;                           /* as the lattice came out */
    double euler, timoshenko, timoshenko_real; /* periods of the simply supported beam */
    MovingCantilever *moving;
    double speed; /* of the same */
    Window window;
    int v_probe;                           /* in the method's row */
    double thickness[THICKNESS_LINES_MAX]; /* frequencies of the lattice through the beam's height */
    int n_thickness;
} BeamAnswers;

typedef struct ProblemRow {
    Problem problem;
    MethodKind method;
    Simulation *(*simulate)(const Settings *, int threads, Status *);
    bool (*prepare)(References *, const Settings *, const Simulation *, Status *);
    double (*profile)(const References *, const char *field, double x, double time);
    void (*readout)(const References *, const double *rows, size_t n_rows, int n_columns, Readout *);
    int (*derived)(const Settings *, const Simulation *, Derived out[DERIVED_MAX]);
    bool (*advice)(const Settings *, char *advice, size_t size, Status *);
} ProblemRow;

struct References {
    const ProblemRow *kind;
    PlannedColumn plan[COLUMNS_MAX];
    int n_columns;
    double dt;
    BarAnswers bar;
    BeamAnswers beam;
};

/* For prepare(): appends columns to the plan. */
void plan_method(References *, const Simulation *, const char *series); /* no such series: nothing */
void plan_answer(References *, const Quantity *, ColumnKind, const char *of, Answer *);
void plan_filter(References *, const Quantity *, const char *of, Answer *); /* an answer that remembers */
int plan_find(const References *, const char *column);                      /* -1: there is none */

/* One or more cosines in a column fitted by least squares (theory/frequency.h); at most a few thousand of its
 * rows are looked at, spread evenly. `start`: radians per unit time, the frequency expected of the first
 * line. Several lines need a whole period of it, one a half. False: not yet. */
bool readout_fit(const double *rows, size_t n_rows, int n_columns, int column, double start,
                 const double *ratios, int n_lines, double *frequency);

/* The beam as its engine wants it. */
BeamDef beam_definition(const Settings *, int threads);

/* Appends a derived number. */
void derived_add(Derived out[DERIVED_MAX], int *count, const char *name, const char *label, const char *unit,
                 double value, bool integer);

extern const ProblemRow bar_mpm_row, bar_pd_row;
extern const ProblemRow supported_pd_row, moving_pd_row, notched_pd_row;

#endif
