/* Rows of a verification: a number that was measured, what it may be, and how it is told. */
#ifndef CLI_VERIFY_SHEET_H
#define CLI_VERIFY_SHEET_H

#include "base/status.h"

#include <stdbool.h>
#include <stdio.h>

typedef enum Verdict {
    VERDICT_SHOWN, /* nothing is claimed of it */
    VERDICT_HOLDS,
    VERDICT_MISSED
} Verdict;

/* What a number may be, both ends included. */
typedef struct Bound {
    double low, high;
} Bound;

enum { BOUNDS_MAX = 3 };

/* Unused bounds are left as {0}. */
typedef struct VerifyRow {
    const char *what;
    const char *paper; /* in the paper's words; NULL: it says nothing */
    double predicted;  /* NAN: no theory knows */
    double measured;
    int decimals;
    int n_bounds;
    Bound bounds[BOUNDS_MAX];
} VerifyRow;

Bound within(double centre, double tolerance);

/* MISSED unless the number lies in every bound; what is no number misses. SHOWN without bounds. */
Verdict verdict_of(double measured, const Bound *bounds, int count);

/* Runs that two figures tell of, made once: see verify_moving.c and verify_notch.c. */
struct MovingStory;
struct CrackStory;

/* One verification: where it is told, and the count so far. */
typedef struct Verify {
    FILE *out;
    bool full;   /* everything, however long it takes */
    int threads; /* for beams */
    long held, missed;
    struct MovingStory *moving; /* NULL: not yet run */
    struct CrackStory *crack;
} Verify;

/* The last line, and the exit status: 1, with a status that says so, if anything was missed. 0 where nothing
 * can be written any more, which who closes the stream tells. */
int verify_end(Verify *verify, Status *status);

/* The head of a table of rows; `quantity` (may be NULL) is what all its numbers are. */
void verify_head(Verify *verify, const char *quantity);
void verify_row(Verify *verify, const VerifyRow *row);

/* A line of a table with columns of its own: cells are right-aligned in their widths, the first one left. */
typedef struct VerifyColumn {
    const char *heading;
    int width;
} VerifyColumn;

void verify_columns(Verify *verify, const VerifyColumn *columns, int count);
void verify_line(Verify *verify, const VerifyColumn *columns, int count, const char *const *cells,
                 Verdict verdict);

/* A sentence under a table. */
void verify_note(Verify *verify, const char *format, ...) __attribute__((format(printf, 2, 3)));

#endif
