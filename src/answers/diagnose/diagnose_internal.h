/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the files behind diagnose.h share: a run beside a table. */
#ifndef ANSWERS_DIAGNOSE_INTERNAL_H
#define ANSWERS_DIAGNOSE_INTERNAL_H

#include "answers/diagnose/diagnose.h"
#include "run/advance.h"
#include "scenario/parameters.h"
#include "scenario/settings.h"

typedef struct TimeSettings TimeSettings; /* scenario/concern_time.h, which few of them need */

/* Fewer entries can be had with any value, or with two mistakes of some. */
enum { DIAGNOSE_ENTRIES_LEAST = 3 };

/* A walk along a run, as far as the file or `moments` go. */
typedef struct Walk {
    const DiagnoseTable *table;
    size_t moments;      /* of the table, at most; 0: all */
    bool to_end;         /* it goes on where it departs */
    double *values;      /* ours, [row][column]; NULL: they are not kept */
    const double *grown; /* what round-off has grown to, [moment][group of columns]; NULL: it is not known */

    /* what it comes to */
    size_t compared;   /* moments that the run reached */
    size_t agreed;     /* of them, from the first on */
    size_t entries;    /* that were compared and agreed, up to there */
    size_t departing;  /* entries that depart (to_end) */
    double worst;      /* largest difference of those that agree, over their column's size */
    double farthest;   /* likewise of all (to_end) */
    size_t off_digits; /* how many of those that agree are off by more than the digits written, */
    double beyond;     /* and by how much; a last digit or two may be rounded the other way */
    double most[DIAGNOSE_COLUMNS_MAX];  /* of each column the largest number, */
    double off[DIAGNOSE_COLUMNS_MAX];   /* and the largest difference beyond the digits written */
    bool departs[DIAGNOSE_COLUMNS_MAX]; /* columns that depart anywhere (to_end) */
    Departure departure;                /* the first */
    double jump;          /* its difference, over its column's size, where the step before agrees; else 0 */
    bool failed, stopped; /* the run failed; somebody gave up, or there was no memory */
} Walk;

/* False: the walk was given up, or the run cannot be made; the status says why. */
bool diagnose_walk(Walk *, const DiagnoseTask *, const Settings *, Status *);

/* The rows of so many moments, which come first. */
size_t diagnose_rows(const DiagnoseTable *, size_t moments);

/* Room for the values of a walk, all NAN; the caller frees it. NULL: there is no memory. */
double *diagnose_room(const DiagnoseTable *);

/* An entry that departs. */
Departure diagnose_departure(const DiagnoseTable *, size_t moment, size_t row, int column, double theirs,
                             double ours);

/* A unit of the last digit with which a number of a column of the file is written. */
double diagnose_last_digit(const OverlayColumn *, double number);

/* The information in an entry of a column at a step: half a unit of its last digit, in our units, and the
 * round-off of two right codes, as a share of the size of such numbers. */
double diagnose_rounding(const DiagnoseTable *, const DiagnoseColumn *, double theirs);
double diagnose_noise(const DiagnoseTable *, double size, long step);

/* Gives settings the time step of the file. False: they do not allow it; the status may say why. */
bool diagnose_hold_step(Settings *, double dt, Status *);

/* The number of a row of the file in our units; NAN: missing; infinite: from there on it is not a number. */
double diagnose_theirs(const DiagnoseTable *, const DiagnoseColumn *, size_t row);

/* What is to be said of the table; more than it has room for is dropped. */
void diagnose_note(DiagnoseTable *, const char *format, ...) __attribute__((format(printf, 2, 3)));

/* A run with all columns of the series, and none of one thing. NULL: there is none; the status says why. */
Simulation *diagnose_simulate(const Settings *, int threads, Status *);

/* What numbers like a quantity's are at most at the start; `row`: of the series there. Displacements are
 * sized among themselves, but a code may have them as differences of places. */
double diagnose_size_at_start(Simulation *, const Quantity *, const double *row);

/* Whether numbers of these have one size: they have one unit, and both are displacements or none is. */
bool diagnose_are_alike(const Quantity *, const Quantity *);

/* diagnose_candidates.c: what else could have made the numbers: up to two values other than the scenario's.
 */
typedef struct Candidate {
    DiagnoseKind kind;
    const Parameter *parameter;
    double value;
    int beside;                   /* a second mistake; 0: none */
    const TimeSettings *own_step; /* it makes its own time step, as these say; NULL: it has the file's */
} Candidate;

bool diagnose_is_of_plane(const Settings *);                 /* where a run takes long */
bool diagnose_is_tried(const Settings *, const Parameter *); /* whether codes may differ in it */
bool diagnose_is_share(const Parameter *);                   /* whether it is any number from 0 to 1 */

/* What another value of a parameter is: a mistake; a right code's, by another choice or share of the scheme
 * (mpm., pd.); or a wrong value. */
DiagnoseKind diagnose_kind(const Parameter *);

enum { CANDIDATES_MAX = 1200 };
typedef enum DiagnoseListed { MISTAKES, MISTAKES_AND_VALUES, PAIRS_OF_MISTAKES } DiagnoseListed;
int diagnose_candidates(const Settings *right, DiagnoseListed, Candidate out[CANDIDATES_MAX]);

/* A right code: the scenario's, or by other choices of its scheme. */
typedef struct DiagnoseScheme {
    Settings settings; /* with the file's time step */
    int choices;       /* in which it differs from the scenario */
    int axis;          /* that of the last of them */
} DiagnoseScheme;

/* The product of algorithms, shapes and transfers, or of corrections, influences and horizons; and what else
 * a scheme may choose, one at a time. The scenario's own comes first, then those of fewer choices, and none
 * of more than `most`. Returns how many there are; the caller frees them. NULL: there is no memory. */
enum { ANY_CHOICES = 5 };
int diagnose_schemes(const Settings *, const DiagnoseTable *, int most, DiagnoseScheme **out);

/* Its settings, with the file's time step. False: there is no such run. */
bool diagnose_settings_of(const Candidate *, const Settings *right, const DiagnoseTable *, Settings *out);

/* The scheme of a code in a word or two: "USL", "MUSL, gimp, apic". */
void diagnose_name_scheme(const Settings *, char *out, size_t size);

/* In words. */
void diagnose_explain(const Candidate *, const Settings *right, const Settings *wrong, Explanation *);

/* What a factor is: "2, the particles in a cell", "-1"; "": no such thing. Half of it, its inverse, counts.
 */
void diagnose_name_factor(double factor, double tolerance, const Settings *, char *out, size_t size);

/* diagnose_value.c: the value of a parameter with which the run agrees with the file, sought from its first
 * departure on. False: there is none; *tried counts the runs. */
bool diagnose_find_value(const DiagnoseTask *, const DiagnoseTable *, const Departure *, const Parameter *,
                         const TimeSettings *own_step, double *value, long *tried);

/* Fills in the run that distinguishes two codes, one that was made: a column that the file has not, or
 * another setting of both. */
void diagnose_tell_apart(const Settings *a, const Settings *b, const DiagnoseTable *, Explanation *);

/* One file and what is found of it. */
typedef struct Search {
    const DiagnoseTask *task;
    DiagnoseTable *table;
    Diagnosis *found;
    Settings right;    /* with the file's time step; while a scheme is tried, the right code of that */
    Settings given;    /* the scenario's, likewise */
    double *values;    /* of the right run */
    double *grown;     /* what its round-off grows to, where it departs; else NULL */
    Walk walk;         /* along it */
    size_t own;        /* entries that agree with the right code of the scheme whose mistakes are tried, */
    bool own_is_known; /* where it was run */
    Settings by_first; /* of the first code that explains it all; without one the right ones */
    bool nearer;       /* mistakes are tried that are nearer than the right code that agrees */
    double until;      /* of the clock: DiagnoseTask.seconds */
    Settings of_first; /* the right code of its scheme */
    Status *status;
    size_t
        lost[OVERLAY_COLUMNS_MAX]; /* per column of the file the row from which on it is left out; 0: none */
} Search;

/* diagnose_words.c: the last step: makes the verdict a word, and gives the scheme, digits and rows of a right
 * code by another scheme the place of those of the right run. */
void diagnose_conclude(Diagnosis *, const DiagnoseTable *);

/* Whether no other code and no other reading is tried any more; what is found says so. */
bool diagnose_time_is_up(const Search *);

/* diagnose_reading.c: how the table may be meant. The likeliest first; that which agrees with a right code
 * alone, where one does. `deep`: of the plane that with which a wrong code agrees, which takes many runs.
 * Returns how many there are; -1: it was given up, or there is no memory. */
enum { READINGS_MAX = 4 };
int diagnose_readings(const Search *, bool deep, DiagnoseReading out[READINGS_MAX]);

/* Time steps that differ by less are one, as where it is a number of single precision. */
#define DIAGNOSE_SAME_STEP 2e-7

/* Puts steps and columns of a table as a reading has them. False: it has rows between its steps. */
bool diagnose_read_as(DiagnoseTable *, const DiagnoseReading *);

/* diagnose_columns.c: after the first walk along the right run. Leaves out what is not a number, finds sizes,
 * silences columns without information; the verdict is UNKNOWN if any column is left. False: there is no
 * memory. */
bool diagnose_judge_columns(Search *);

/* Whether a column never changes in the right run, as a mass: beside others it identifies no run. */
bool diagnose_is_still(const Search *, int column);

/* diagnose_round_off.c: whether all numbers that are written with more digits than single precision has are
 * numbers of it. */
bool diagnose_is_single(const DiagnoseTable *);

/* The size of the single-precision numbers whose differences a column holds, as x - x0: its numbers are whole
 * multiples of a power of two that is far above their own last digits. 0: it holds no such differences. */
double diagnose_terms(const Overlay *, int column);

/* The most digits of any column. */
int diagnose_digits_written(const DiagnoseTable *);

/* What the round-off of a run has grown to, [moment][group of columns], by a run whose
 * last digits are others; the caller frees it. *moments: those before it is as large as the numbers. NULL: it
 * is not known, or *stopped: it was given up. */
double *diagnose_grown(const Search *, const Settings *, size_t *moments, bool *stopped);

#endif
