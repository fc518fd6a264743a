/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A row of a verification: one number of one run beside what theory, the mesh's eigenvalue and its prediction
 * say; the reference that it has to reproduce, the bounds that must hold, and the paper's claim about it. All
 * rows are in data/verify; tools/claims.awk makes the table of them. */
#ifndef CLI_VERIFY_VERIFY_ROW_H
#define CLI_VERIFY_VERIFY_ROW_H

#include "scenario/settings.h"
#include "base/cancel.h"
#include "problems/problem.h"
#include "answers/references.h"
#include "run/advance.h"

#include <math.h>

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

/* Runs a scenario: its name and KEY=VALUE ... behind, parted by spaces; rows every output.every steps. False:
 * the run's failure says why. The run is closed in any case by verify_run_close(). */
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
typedef double (*VerifyQuantity)(VerifyRun *, const VerifyRow *row);

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
    VerifyQuantity quantity, theory, eigenvalue, predicted; /* quantity: measured */
    const char *column, *other;                             /* what the quantity takes: columns, names */
    double from, to;                                        /* times, or what else it takes */
    double scale;                                           /* the numbers are printed times this; 0: 1 */
    double part;                                            /* of many runs, those below: .5 is the median */
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

#endif
