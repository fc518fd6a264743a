/* A problem joins a method (physics) to its right answers (theory): one table row each.
 *
 * From settings to a simulation; the columns of its series with the references beside; derived numbers for
 * the read-only rows; advice before a run. Front ends ask here and never look into a method. */
#ifndef LAB_PROBLEM_H
#define LAB_PROBLEM_H

#include "lab/settings/settings.h"
#include "physics/method.h"

/* Where a number comes from; the three words that are used everywhere. */
typedef enum ColumnKind { COLUMN_MEASURED, COLUMN_PREDICTED, COLUMN_EXACT } ColumnKind;

typedef struct Column {
    Quantity quantity;
    ColumnKind kind;
    int of; /* a reference: the index of the column that it answers; else -1 */
} Column;

enum { COLUMNS_MAX = 32, DERIVED_MAX = 24 };

/* The references of one run: theory with its coefficients worked out once. */
typedef struct References References;

/* What is settled by the problem alone. */
typedef struct ProblemFacts {
    const char *title;       /* "axial vibration of a bar" */
    MethodKind usual_method; /* where a scenario names none */
    BeamProblem beam;        /* which one, in two dimensions; of no meaning for the bar */
    bool si;                 /* numbers are in SI units; else in units of one's own that fit each other */
    const char *unit_of_time;
    double told_time;           /* a time is told to people in so many of these */
    const char *told_time_unit; /* with a space before it; "": a bare number */
} ProblemFacts;

extern const ProblemFacts problem_facts[PROBLEM_COUNT];

/* Whether the problem can be solved by the method; false with the status: why not, and by which. */
bool problem_allows(Problem, MethodKind, Status *);

/* Whether a run to `end` takes steps that can be counted and done. */
bool problem_check_steps(double end, double dt, Status *);

/* The simulation at t = 0. `threads` at least 1. NULL: the status says why. */
Simulation *problem_simulate(const Settings *, int threads, Status *);

/* The time step that a simulation of these settings has; a beam's critical one may have to be found for it.
 */
bool problem_time_step(const Settings *, double *dt, Status *);

/* Makes settings those of a run that ends at a step: time.end its time, time.step the number in use, changes
 * and named times beyond it left out. Such a run has the same rows up to there. */
void problem_end_at(Settings *, double dt, long step);

/* The first step k with k dt >= end (1 - 1e-9): where a run ends; of a run that problem_check_steps()
 * allows. */
long problem_last_step(double dt, double end);

References *problem_references(const Settings *, const Simulation *, Status *);
/* For a simulation that no problem knows: its own series, nothing beside. */
References *problem_no_references(const Simulation *, Status *);
void references_destroy(References *);

/* The columns of the series in the order of the CSV contract; the first two are step and time. Which there
 * are depends on the settings (no prediction: no such column). Returns how many. */
int references_columns(const References *, Column columns[COLUMNS_MAX]);

/* Completes a row: `method_row` is what the simulation gave at this step, `row` takes one number for every
 * column. Columns that need the past (a filter) are kept inside: rows come in order; reset() before the
 * first. */
void references_row(References *, long step, double time, const double *method_row, double *row);
void references_reset(References *);

/* The row of any step, out of order and without leaving a trace; what needs the past is taken from `earlier`,
 * the full row of a step nearby. */
void references_row_again(References *, long step, double time, const double *method_row,
                          const double *earlier, double *row);

/* How many rows before the present one a row depends on (a filter's window); 0: none. Whoever begins again in
 * the middle of a run resets, and hands over so many earlier rows first. Where it is not 0, every step needs
 * a row, whichever are kept. */
long references_memory(const References *);

/* The exact profile of a particle field ("u", "v", "stress", ...) at a reference position; NAN: not known. */
double references_profile(const References *, const char *field, double x, double time);

/* How far a column of a beam that comes out of its channel swings at a time, by slow lengthening alone (its
 * action is kept): displacement as L^(1/2), velocity as L^(-3/2). NAN: not such a column. */
double references_envelope(const References *, const char *column, double time);

enum { THICKNESS_LINES_MAX = 6 };

/* The predicted frequencies (radians per s) with which a beam's lattice rings through its height, ascending;
 * the least of them. Returns how many; 0: no such beam. */
int references_thickness_lines(const References *, double out[THICKNESS_LINES_MAX]);

/* The frequency in Hz that a beam which comes out of its channel would have if it stopped at a time; NAN: it
 * is none. */
double references_standing_frequency(const References *, double time);

/* What the run is judged by: a frequency (bar, radians per time) or a period (beams, s). */
typedef struct Readout {
    bool moving; /* false: at rest or rigid motion; there is no frequency */
    bool measured_known, predicted_known, exact_known;
    bool is_period; /* the three numbers are periods, not frequencies */
    double measured, predicted, exact;
    double error_frequency, error_period; /* measured against exact, in percent */
    double predicted_error_frequency;     /* predicted against exact, in percent */
    double late;                          /* periods behind the exact answer at `time` */
    double time;
    double by_zeros; /* a beam's period once more, from the zeros of its swing; NAN: fewer than two */
    bool drifting;   /* the period itself changes: the three numbers and `late` are those of the last zeros */
    const char *column;     /* the series it was measured on */
    double times;           /* which swings so many times as fast */
    int mode;               /* of a bar: the number of the mode that it is; 0: none */
    const char *unmeasured; /* of what moves: why there is no measured number, in a few words; else "" */
} Readout;

/* Periods behind the exact answer at another time than the readout's; NAN: not known. */
double readout_late(const Readout *, double time);

/* From a record of rows (n_columns numbers each, equally spaced): measured as soon as it can be. */
void references_readout(const References *, const double *rows, size_t n_rows, int n_columns, Readout *);

/* Derived numbers: wave speed, time step, beta, omega, period, ...; micromodulus, bonds, dt_crit, ... */
typedef struct Derived {
    const char *name;  /* ASCII, for `show` and `params`: "dt" */
    const char *label; /* on screen */
    const char *unit;
    double value;
    bool integer;
} Derived;

int problem_derived(const Settings *, const Simulation *, Derived out[DERIVED_MAX]);

/* Said before a run: the courant number against its limit, horizon over spacing outside 3 to 4. False: the
 * run is refused, the status says why and what is allowed. `advice` is "" where there is nothing to say. */
bool problem_advice(const Settings *, char *advice, size_t size, Status *);

#endif
