/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A row of a verification: one number of one run, its reference and tolerance, and the paper's claim about
 * it. */
#ifndef CLI_VERIFY_ROW_H
#define CLI_VERIFY_ROW_H

#include "cli/verify/verify_run.h"

#include <math.h>

/* What a number may be, both ends included. */
typedef struct Band {
    double low, high;
} Band;

#define WITHIN(value, tolerance)                                                                             \
    {                                                                                                        \
        (value) - (tolerance), (value) + (tolerance)                                                         \
    }

/* The paper's claim about a number, in its words. */
typedef struct Claim {
    const char *words;   /* NULL: no claim */
    double number;       /* that the words name, printed with our distance from it; NAN: they name none */
    double agrees, near; /* off by no more than such a share of the number */
    Band range;          /* where they name none: what agrees with them */
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
#define NOTHING                                                                                              \
    {                                                                                                        \
        NULL, NAN, 0, 0, {0, 0}, NULL                                                                        \
    }

typedef struct VerifyRow VerifyRow;

/* A number of a run; `row` has the column, the time and so on. NAN: there is none. */
typedef double (*VerifyQuantity)(VerifyRun *, const VerifyRow *row);

/* A row needs a reference, or a theory with a tolerance: something that it can miss. */
struct VerifyRow {
    const char *what;     /* with its unit */
    const char *scenario; /* and KEY=VALUE ..., as `matvib run` takes them; NULL: as in the row above */
    VerifyQuantity quantity;
    const char *column, *other; /* what the quantity takes: columns, names */
    double from, to;            /* times, or what else it takes */
    double scale;               /* the number is printed times this; 0: 1 */
    int decimals;
    Band reference; /* around the digits of our reference solvers; unused where both ends are 0 */

    VerifyQuantity theory;
    double tolerance; /* of measured - theory, as printed; 0: theory is shown only */

    Claim paper;
    bool full; /* --full only */
};

typedef enum Agreement { PAPER_SILENT, PAPER_AGREES, PAPER_NEAR, PAPER_DIFFERS, AGREEMENTS } Agreement;

/* Whether a number is within the tolerances of our reference and theory; NAN is not. */
bool verify_reproduces(const VerifyRow *row, double measured, double theory);

/* The verdict of the paper's claim on a number; NAN differs. */
Agreement verify_agreement(const Claim *claim, double measured);

#endif
