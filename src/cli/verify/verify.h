/* SPDX-License-Identifier: GPL-3.0-or-later */
/* `matvib verify`: the claims of the papers beside theory and measured numbers.
 *
 *     matvib verify [NAME]... [--full] [--list]
 *
 * Each name is a figure or a table of one of the two papers, or one more thing that is known of a method: a
 * table of rows (VerifyRow). The engine runs, and each row prints theory, the measured number,
 * what our reference allows and whether it is reproduced; and under it, with a verdict of its own, the
 * paper's claim. */
#ifndef CLI_VERIFY_VERIFY_H
#define CLI_VERIFY_VERIFY_H

#include "base/status.h"
#include "scenario/settings.h"
#include "base/cancel.h"
#include "problems/problem.h"
#include "answers/references.h"
#include "run/advance.h"
#include "cli/cli.h"

#include <stdio.h>
#include <math.h>

/* The names, in the order of --list; NULL behind the last. */
const char *verify_name(int index);

/* `arguments` are those after the word "verify". Tables go to `out`. Returns the exit status: 0 our
 * reference and theory are reproduced; 1 a miss (the status says how many); 2 bad usage (the status says what
 * is allowed). */
int verify_main(int count, char **arguments, FILE *out, Status *status);

/* A row of a verification: one number of one run beside what theory, the mesh's eigenvalue and its prediction
 * say; the reference that it has to reproduce, the bounds that must hold, and the paper's claim about it. All
 * rows are in data/verify; tools/claims.awk makes the table of them. */

/* A run as verification sees it: a scenario, its series with the references beside, and what it came to. */
enum { VERIFY_STARTS = 21 };

typedef struct VerifyRun {
    const char *scenario; /* as the row names it; NULL: none was run */
    int threads;
    Settings settings;
    Run passing; /* at its end */
    References *refs;
    Column columns[COLUMNS_MAX];
    int n_columns;
    size_t count;   /* rows, that of step 0 included */
    double spacing; /* time between two rows */
    double *rows;
    Readout readout;
    Derived derived[DERIVED_MAX];
    int n_derived;
    bool starts_known;
    int n_starts;                 /* those of VERIFY_STARTS near this one that came to their end */
    double starts[VERIFY_STARTS]; /* what energy they have left, in order */
    Status failure;               /* why there is no run; code STATUS_DONE: there is */
} VerifyRun;

/* Runs a scenario: its name and KEY=VALUE ... behind, separated by spaces; rows every output.every steps.
 * False: the run's failure says why. The run is closed in any case by verify_run_close(). */
bool verify_run_open(VerifyRun *, const char *scenario, int threads, Cancel);
void verify_run_close(VerifyRun *);

/* The settings alone. */
bool verify_settings(const char *scenario, Settings *, Status *);

/* A column's values from row 0 on, n_columns apart; NULL: the run has no such column. */
const double *verify_column(const VerifyRun *, const char *name);

/* The rows with from <= time <= to: from *first, as many as returned. */
size_t verify_rows_between(const VerifyRun *, double from, double to, size_t *first);

/* What a number may be, both ends included. */
typedef struct Band {
    double low, high;
} Band;

#define WITHIN(value, tolerance)                                                                             \
    {                                                                                                        \
        (value) - (tolerance), (value) + (tolerance)                                                         \
    }

/* The paper's claim about a number. */
typedef struct Claim {
    const char
        *words; /* the paper's own, letter by letter: they are printed in quotation marks; NULL: no claim */
    double number;       /* that the words name, printed with our distance from it; NAN: they name none */
    double agrees, near; /* off by no more than such a share of the number */
    Band range;          /* where they name none: what we take them for, printed behind them */
    const char *remark;  /* printed after the verdict; NULL: none */
} Claim;

/* A number that the paper prints: 2 % off agrees, 10 % is near; of "about 5", 10 % and 25 %. */
#define PRINTS(words, number)                                                                                \
    {                                                                                                        \
        words, number, 0.02, 0.1, {0, 0}, NULL                                                               \
    }
#define PRINTS_WITH_REMARK(words, number, remark)                                                            \
    {                                                                                                        \
        words, number, 0.02, 0.1, {0, 0}, remark                                                             \
    }
#define ABOUT(words, number)                                                                                 \
    {                                                                                                        \
        words, number, 0.1, 0.25, {0, 0}, NULL                                                               \
    }
#define CLAIM(words, low, high)                                                                              \
    {                                                                                                        \
        words, NAN, 0, 0, {low, high}, NULL                                                                  \
    }

typedef struct VerifyRow VerifyRow;

/* A number of a run; `row` has the column, the time and so on. NAN: there is none. */
typedef double VerifyQuantity(VerifyRun *, const VerifyRow *row);

/* What numbers are printed under. */
typedef enum VerifyColumn {
    VERIFY_THEORY,     /* of the continuum: exact, or beam theory */
    VERIFY_EIGENVALUE, /* of the step on this very mesh or lattice, or what follows from it at once */
    VERIFY_PREDICTED,  /* what else the equations of this discretisation give beforehand: a series, a limit */
    VERIFY_MEASURED,
    VERIFY_COLUMNS
} VerifyColumn;

/* The row's own number is the last one that it has; reference, bound and claims are of it. A row needs a
 * reference, a bound or a tolerance: something that it can miss. */
struct VerifyRow {
    const char *what;     /* with its unit */
    const char *scenario; /* and KEY=VALUE ..., as `matvib run` takes them; NULL: as in the row above */
    VerifyQuantity *quantity, *theory, *eigenvalue, *predicted; /* quantity: measured */
    const char *column, *other;                                 /* what the quantity takes: columns, names */
    double from, to;                                            /* times, or what else it takes */
    double scale;                                               /* the numbers are printed times this; 0: 1 */
    double part; /* of many runs, those below: .5 is the median */
    int decimals;
    Band reference;   /* around the digits of an independent solver; unused where both ends are 0 */
    Band bound;       /* what must hold without one: a law, a ripple; likewise */
    double tolerance; /* of the own number less the one that is printed before it; 0: that is shown only */

    Claim paper, also; /* a sentence may say two things */
    bool full;         /* --full only */
};

typedef struct VerifyCheck {
    const char *name;
    const char *title;
    const VerifyRow *rows; /* the first names a scenario */
    int n_rows;
    const char *note; /* printed under them; NULL: nothing */
} VerifyCheck;

#define VERIFY_ROWS(rows) rows, (int)(sizeof(rows) / sizeof *(rows))

/* In the order of --list; a NULL name ends them. */
extern const VerifyCheck verify_checks[];

typedef enum Agreement { PAPER_SILENT, PAPER_AGREES, PAPER_NEAR, PAPER_DIFFERS, AGREEMENTS } Agreement;

typedef enum Verdict { VERDICT_NONE, VERDICT_MISSED, VERDICT_GOOD } Verdict;

/* What a row prints, NAN where it has nothing. */
typedef struct VerifyNumbers {
    double values[VERIFY_COLUMNS];
    VerifyColumn own, beside; /* equal: there is none beside it */
} VerifyNumbers;

/* The run may be NULL: then all values are NAN. */
VerifyNumbers verify_numbers(VerifyRun *, const VerifyRow *);

/* Whether the own number reproduces the reference, lies within the bound, is as near to the one beside it as
 * it should be. NAN misses; VERDICT_NONE: the row does not ask for it. */
Verdict verify_reproduces(const VerifyRow *, const VerifyNumbers *);
Verdict verify_is_bounded(const VerifyRow *, const VerifyNumbers *);
Verdict verify_is_near(const VerifyRow *, const VerifyNumbers *);

/* The verdict of the paper's claim on a number; NAN differs. */
Agreement verify_agreement(const Claim *claim, double measured);

/* Numbers that a verification takes from a run; what `row` must hold for each stands after it. NAN where
 * the run has no such number. */

#define QUANTITY(name, value) VerifyQuantity quantity_##name;
#include "cli/verify/verify_quantity_rows.inc"
#undef QUANTITY

/* By how much the period is longer, percent; other: the scenario of the shorter one. The order of a finding
 * between two cell sizes; other: the scenario of the smaller one. */
VerifyQuantity quantity_longer_than, quantity_finding_order;

/* A column of the series: its amplitude in from..to, of other's value at t = 0; the largest |column - other|;
 * the relative L2 of both in from..to, percent; the frequency of its highest line in from..to (Hz); the time
 * at which it comes to `from`. */
VerifyQuantity quantity_amplitude_share, quantity_furthest, quantity_distance, quantity_line,
    quantity_first_above;

/* Energy: mean of kinetic and strain over t >= to, over that until `from`; how far kinetic, strain and
 * dissipated together are from the work after `from`, largest, percent. */
VerifyQuantity quantity_energy_left, quantity_energy_off_work;

/* The first of these over many starts, whose velocities lie within 1 % of the run's: `scale` of them are
 * below (0 the least, .5 the median, 1 the most). What is chaotic has no other number. */
VerifyQuantity quantity_energy_left_of_starts;

/* What all energies have gained at the end beyond the start and the work, percent of the work. */
VerifyQuantity quantity_energy_gained;

/* The bar: the smallest velocity with which a particle of the scenario leaves its cell, by bisection; the
 * largest Courant number with which a motion of all waves stays bounded, likewise, between from and to. */
VerifyQuantity quantity_crossing_velocity, quantity_courant_limit;

/* Beams: the surface factor of the node in the middle; the energy after `to` steps of `from` critical ones,
 * over that at the start. */
VerifyQuantity quantity_middle_factor, quantity_energy_after_steps;

/* Bodies of a scenario that begin with a field of velocities: the largest stress off D eps of a uniform
 * stretch in one step, over the largest of these; off that of a rigid turn with the spin `from`, over
 * G spin dt. Blocks clamped at x = 0 and 1, nu = 0, in their first mode: the root
 * mean square of the error of the displacement, or of a field `column`, over the largest value of the motion,
 * at the cell size `from`; its order between that and `to`. */
VerifyQuantity quantity_stretch_error, quantity_turn_error;

/* Of the bonds through a plane, stretched up to s0; J/m^2. */
VerifyQuantity quantity_plane_energy;

/* The one runner of checks, and its counts: what reproduces our reference, what is bounded as it should be,
 * and what agrees with the paper. */

/* One verification: where it is printed, and the counts so far. */
typedef struct Verify {
    FILE *out;
    Quantities *json; /* NULL: it is printed as text */
    int threads;
    Progress *progress; /* NULL: not shown, and nothing stops it */
    long to_do;         /* rows, for the progress */
    VerifyRun run;      /* the last one, which following rows may use again */
    long rows;
    long references[VERDICT_GOOD + 1], bounds[VERDICT_GOOD + 1];
    long papers[AGREEMENTS];
} Verify;

/* Runs the rows of a check, with --full all of them, and prints each. A run that cannot be made is a miss of
 * its rows. After a signal nothing more is run or printed. */
void verify_check_run(Verify *, const VerifyCheck *, bool full);

/* The last lines, with all counts, and the exit status: 1, with a status that says so, if anything was
 * missed; what differs from the paper is only printed. 0 where nothing can be written any more: closing
 * the stream reports that. 128 + n after signal n. */
int verify_end(Verify *, Status *);

#endif
