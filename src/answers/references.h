/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The references of one run: the columns of its series with theory beside, theory's coefficients worked out
 * once; profiles, frequencies and envelopes from the same; and the readout by which a run is judged. */
#ifndef ANSWERS_REFERENCES_H
#define ANSWERS_REFERENCES_H

#include "base/text.h"
#include "problems/problem.h"
#include "scenario/assignment.h"
#include "methods/method.h"

/* Where a number comes from; the three words that are used everywhere. */
typedef enum ColumnKind { COLUMN_MEASURED, COLUMN_PREDICTED, COLUMN_EXACT } ColumnKind;

typedef struct Column {
    Quantity quantity;
    ColumnKind kind;
    int of; /* a reference: the index of the column that it answers; else -1 */
} Column;

enum { COLUMNS_MAX = 104 };

References *references_create(const Settings *, const Simulation *, Status *);
void references_destroy(References *);

/* The columns of the series in the order of the CSV contract; the first two are step and time. Which there
 * are depends on the settings (no prediction: no such column). Returns how many. */
int references_columns(const References *, Column columns[COLUMNS_MAX]);

/* Which of them has that name; -1: none. */
int references_column(const Column *columns, int count, const char *name);

/* Completes a row: `method_row` is what the simulation gave at this step, `row` takes one number for every
 * column. Columns that need the past (a filter) are kept inside: rows come in order; reset() before the
 * first. */
void references_row(References *, long step, double time, const double *method_row, double *row);
void references_reset(References *);

/* The row of any step, out of order and without leaving a trace; what needs the past is taken from `earlier`,
 * the full row of a step nearby. */
void references_row_again(References *, long step, double time, const double *method_row,
                          const double *earlier, double *row);

/* How many rows before the present one a row depends on (a filter's window); 0: none. A caller that begins
 * again in the middle of a run resets, and hands over so many earlier rows first. Where it is not 0, every
 * step needs a row, whichever are kept. */
long references_memory(const References *);

/* The exact profile of a particle field ("u", "v", "stress", ...) at a reference position; NAN: not known. */
double references_profile(const References *, const char *field, double x, double time);

/* The same at a place of a beam's section, of a stress; y as the particles' places have it. */
double references_section(const References *, const char *field, double x, double y, double time);

/* How far a column of a beam that comes out of its channel oscillates at a time, by slow lengthening alone
 * (its action is kept): displacement as L^(1/2), velocity as L^(-3/2). NAN: not such a column. */
double references_envelope(const References *, const char *column, double time);

enum { THICKNESS_LINES_MAX = 6 };

/* The predicted frequencies (radians per s) with which a beam's lattice rings through its height, ascending;
 * the least of them. Returns how many; 0: no such beam. */
int references_thickness_lines(const References *, double out[THICKNESS_LINES_MAX]);

/* The frequency in Hz that a beam which comes out of its channel would have if it stopped at a time; NAN: it
 * is none. */
double references_standing_frequency(const References *, double time);

#define READOUT_PURE     0.995
#define READOUT_ONE      0.5     /* below this R2 a record is not one frequency */
#define READOUT_UNDAMPED 0.99995 /* a period that keeps more of its energy keeps all of it */

/* What the run is judged by: a frequency (bar, radians per time) or a period (beams, s). */
struct Readout {
    bool moving;   /* false: at rest or rigid motion; there is no frequency */
    bool unjudged; /* nothing here is judged by a frequency, however it moves */
    bool measured_known, predicted_known, exact_known;
    bool is_period; /* the three numbers are periods, not frequencies */
    double measured, predicted, exact;
    double uncertainty;    /* standard deviation of `measured`; NAN: not known */
    double r2;             /* share of the record's squares that the fit explains; NAN: none */
    double nominal_period; /* how long about one oscillation takes, in units of time, whether that is
                            * known exactly or not: for windows and paces; NAN: nothing oscillates */
    double error_frequency, error_period; /* measured against exact, in percent */
    double predicted_error_frequency;     /* predicted against exact, in percent */
    double late;                          /* periods behind the exact answer at `time` */
    double time;
    double real_size; /* a beam's period by theory at the size that it has on the lattice; NAN: none */
    double overlap; /* of what oscillates with the mode that is predicted; below READOUT_PURE it is a mixture
                     * of modes, and no one frequency can be measured to the last digit */
    double kept_measured, kept_predicted; /* the share of its energy that the watched motion keeps in one
                                           * exact period; NAN: not known */
    double decay_measured,
        decay_exact; /* of a damped oscillation, amplitude ~ exp(-decay t), 1/s; NAN: not known */
    double by_zeros; /* a beam's period once more, from the zeros of its oscillation; NAN: fewer than two */
    bool drifting;   /* the period itself changes: the three numbers and `late` are those of the last zeros */
    bool faded;      /* the record does not end with that oscillation: `late` is not known */
    const char *column;      /* the series it was measured on */
    double times;            /* which oscillates so many times as fast */
    int mode;                /* of a bar: the number of the mode that it is; 0: none */
    const char *unmeasured;  /* of what moves: why there is no measured number, in a few words; else "" */
    bool no_memory;          /* the fit found no memory, and `unmeasured` says so */
    const char *unaccounted; /* the parameter with which no frequency is known; NULL: it is known */
};

/* A number of the run as it stands, beside the right one: what is judged besides a frequency, or where there
 * is none. */
typedef struct Finding {
    const char *name;    /* ASCII: "v_error" */
    const char *label;   /* on screen: "L2 error of v" */
    double measured;     /* NAN: there is none yet */
    double exact;        /* an error's is 0 */
    const char *word;    /* what that is called; NULL: exact */
    const char *missing; /* why it is not measured, in two or three words; NULL: not yet */
} Finding;

enum { FINDINGS_MAX = 8 };

/* Returns how many there are. The simulation is that of the references, at any time. Of a run whose exact
 * answer is not known, what is measured alone. */
int references_findings(const References *, const Simulation *, Finding out[FINDINGS_MAX]);

/* The one of that name; NAN where there is none. */
Finding finding_named(const Finding *, int count, const char *name);

/* "L2 error of v 0.7394  peak/start 0.6993 (exact 1)". */
void findings_text(const Finding *, int n_findings, bool with_exact, char *out, size_t size);

/* Periods behind the exact answer at another time than the readout's; NAN: not known. */
double readout_late(const Readout *, double time);

/* To how many digits behind the point, at most so many, its error in percent is known: to the first digit of
 * its uncertainty. */
int readout_error_decimals(const Readout *, int most);

/* What is measured to the digits that are known, a period in ms. */
NumberText readout_text(const Readout *, int most);

/* From a record of rows (n_columns numbers each, equally spaced): measured as soon as it can be. */
void references_readout(const References *, const double *rows, size_t n_rows, int n_columns, Readout *);

/* Which references account for a run: each names the parameters that it understands, and leaves where another
 * one is at work. */

/* The key of a parameter that is at work in these settings (not at its neutral value, or changed in mid-run)
 * and that the reference does not account for; NULL: it knows the run, or there is no such reference. */
const char *answer_invalid_because(const Settings *, Reference);

/* The same of the values alone, whatever changes on the way. */
const char *answer_unaccounted_now(const Settings *, Reference);

/* And of the lists of keys alone: a solver may say more of what a reference does not know, though what is
 * predicted of the largest step still holds. */
const char *answer_unlisted_now(const Settings *, Reference);

enum { KNOWN_TEXT_MAX = 120 };

/* "exact, frequency: not known with mpm.damping": the references that are left out because of the first such
 * key that any of them has. *step (may be NULL): from where on it is at work. False: all are known. */
bool answers_known_text(const Settings *, char out[KNOWN_TEXT_MAX], long *step);

/* The sharp invariant of the bar: its energy without the ripple.
 *
 * Velocities and stresses of the material point method are known half a step apart, so kinetic and strain
 * energy at the same step do not belong together and their sum ripples. What belongs together is
 *
 *     E* = sum of m v^n v^{n+1} / 2 + strain energy of the stress that turns v^n into v^{n+1}:
 *
 * the new one with USF, the old one with MUSL and USL. A loss of energy is measured by it wherever it exists.
 */

/* Whether there is one: bars without a load, velocities by FLIP alone; else E* is not what is kept. */
bool references_have_invariant(const Settings *);

/* E* of a simulation between steps, with the settings in force at its step, worked out by one step ahead; the
 * simulation stands where it stood afterwards. NAN: the step failed, or no memory. */
double references_invariant(Simulation *, const Settings *);

#endif
