/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Which code made these numbers? A table of somebody's own code is laid beside the right run, down to the
 * first entry that departs; then beside the run of every mistake, other scheme and other value that there is
 * (rows of the parameter table), simplest first, each dropped where it departs.
 *
 * The accuracy of an entry is bounded by how it is written (the significant digits and decimal places of its
 * column) and by the round-off in which two right codes differ. */
#ifndef ANSWERS_DIAGNOSE_H
#define ANSWERS_DIAGNOSE_H

#include "base/cancel.h"
#include "methods/method.h"
#include "run/overlay.h"
#include "scenario/assignment.h"

enum { DIAGNOSE_COLUMNS_MAX = 32, DIAGNOSE_NOTES_MAX = 8, DIAGNOSE_STAGES_MAX = 12 };

/* A column of the table that the run has too. */
typedef struct DiagnoseColumn {
    int theirs;                  /* of the overlay */
    char name[OVERLAY_NAME_MAX]; /* ours */
    char unit[32];
    char kinds[96];              /* it may be any of these by its name; "": it is `name` */
    char point[FOLLOW_TEXT_MAX]; /* of a series: it is one thing's, "particle 49 v"; "": the series' own */
    bool own;                    /* it has our name */
    int group;                   /* the first column with this unit: what is of one unit has one size */
    double factor;               /* theirs times it is in our units */
    double scale;                /* that of the reading alone: a sign, a unit, a mass */
    double natural;              /* the largest number of this unit at t = 0, in our units */
    double terms; /* size of the single-precision numbers whose differences it holds, as x - x0; 0: none */
    bool silent;  /* it is empty, zero, or copied: it has no information */
} DiagnoseColumn;

/* The rows of one step, or of one stage of it. */
typedef struct DiagnoseMoment {
    long step;
    int stage; /* so many are done of the step that leads to `step`; 0: a whole step */
    size_t first, count;
} DiagnoseMoment;

/* A way to read the table. */
typedef struct DiagnoseReading {
    double dt;          /* by its times */
    double time_factor; /* they times it are ours */
    double last;        /* the scenario's last step with it */
    double otherwise;   /* another time step with which a right code has these few digits; 0: none */
    long shift;         /* its row of step n holds what the run has after step n + shift */
    DiagnoseColumn columns[DIAGNOSE_COLUMNS_MAX];
    int n_columns;
} DiagnoseReading;

typedef struct DiagnoseTable {
    Overlay file;
    int set; /* whose things the rows are of; -1: it is a series */
    bool of_stages, stages_by_id;
    bool of_next; /* a row of step n is of the step that follows: what nodes got of the particles */
    char stage_ids[DIAGNOSE_STAGES_MAX][24];
    int n_stages;
    char thing[16]; /* "particle" */
    DiagnoseReading as;
    DiagnoseMoment *moments;
    size_t n_moments, all_moments; /* that are compared; that there are */
    size_t *rows;                  /* of the file, in the order of the moments */
    size_t *things;                /* of each of them */
    double scenario_dt;
    size_t particles; /* or nodes, of the scenario's run */
    double spacing,
        spacing_bound;   /* of its times as they are written, where they alone give the step; else 0 */
    double head_factor;  /* likewise as the unit in their head says; 0: it has none */
    int step_column;     /* of the file; -1: none */
    bool half;           /* its times are those of half steps */
    double dt_bound;     /* what times that are written with few digits leave open */
    bool timed;          /* they give one */
    int time_column;     /* of the file: its times, or else its steps */
    double noise;        /* round-off of two right codes after a step, as a share of a column's size */
    double noise_growth; /* and what each further step adds, as a share of that */
    char notes[DIAGNOSE_NOTES_MAX][160]; /* what has to be said of it */
    int n_notes;
} DiagnoseTable;

/* Reads a table for a scenario. `map`: "theirs=ours,theirs=ours*0.001", what the names do not say and in what
 * unit it is; NULL: nothing. False: one line says what is wrong with it. */
bool diagnose_read(DiagnoseTable *, const char *path, const Settings *, const char *map, Status *);
bool diagnose_read_from(DiagnoseTable *, FILE *, const char *file, const Settings *, const char *map,
                        Status *);
void diagnose_close(DiagnoseTable *);

/* Where the file first departs from a run. */
typedef struct Departure {
    bool is;
    size_t moment, row; /* the row counted from 1 on in the file */
    long step;
    int stage;
    size_t thing;
    int column;
    double theirs, ours;     /* in our units */
    char factors[96];        /* what their ratio is: "2, the particles in a cell"; "": no such thing */
    char change_factors[96]; /* likewise of the changes since the row before */
    const char *stage_id;    /* of the right run; NULL: the file has no stages */
} Departure;

typedef enum DiagnoseKind { DIAGNOSE_MISTAKE, DIAGNOSE_SCHEME, DIAGNOSE_VALUE } DiagnoseKind;

/* A code that makes these numbers. */
typedef struct Explanation {
    DiagnoseKind kind;
    char id[2 * KEY_MAX]; /* "x_by_own_velocity", "mpm.algorithm=usl", "bar.density=2" */
    char words[200];      /* a sentence, without its full stop */
    char where[200];      /* of a mistake: stage and equation; else "" */
    char stage[24];       /* and the stage's id */
    char scheme[128];     /* of that code: "USL, gimp" */
    char apart[160]; /* the run that distinguishes it from the first explanation, or the right code; "": none
                        of */
    char set[2 * KEY_MAX]; /* "mesh.cell_size=0.5", with which that is; "": no other setting is needed */
    int compared;          /* that were made of both */
    int digits;
    double beyond; /* the largest difference beyond the digits written, as a share of its column's size */
    size_t rows;   /* over which it agrees */
    bool grown;    /* no farther, since round-off grows in such a run */
} Explanation;

typedef enum DiagnoseVerdict {
    DIAGNOSE_RIGHT,     /* they are those of a right code */
    DIAGNOSE_EXPLAINED, /* they are those of other codes */
    DIAGNOSE_UNKNOWN,   /* of no code that was tried */
    DIAGNOSE_COPIED,    /* of no run: of the exact answer */
    DIAGNOSE_MUTE       /* no column has any information */
} DiagnoseVerdict;

/* The verdict in a word: right by the scenario's scheme or another one; right, but for how it is written; a
 * mistake or a wrong value; one of several; unknown. */
typedef enum DiagnoseWord {
    WORD_RIGHT,
    WORD_RIGHT_BUT,
    WORD_MISTAKE,
    WORD_ONE_OF,
    WORD_UNKNOWN
} DiagnoseWord;

extern const char *const diagnose_words[]; /* "right", "right but", "mistake", "one of", "unknown" */

enum { EXPLANATIONS_MAX = 40, DIAGNOSE_NAMED_MAX = 5 /* so many codes are named */ };

typedef struct Diagnosis {
    DiagnoseVerdict verdict;
    DiagnoseWord word;
    char but[200]; /* how right numbers are written otherwise than the scenario's; "": no such thing */
    size_t rows, compared; /* of the file; of them beside the right run */
    size_t agreed;         /* with the right run, from the first on */
    long agreed_step;      /* up to which; -1: none */
    int digits;            /* of that agreement */
    bool naive;            /* it is as inexact as the round-off of a bond's |y| - |xi| */
    Departure departure;
    char agreeing[160]; /* where some depart: the columns that change, and agree in all rows; "": none */
    double farthest;    /* the largest departure of all, as a share of its column's size */
    bool single;        /* it is judged as numbers of single precision */
    char scheme[128];   /* of the right run, or of the code that makes the numbers */
    Explanation
        explanations[EXPLANATIONS_MAX]; /* EXPLAINED: of the file; RIGHT: mistakes that it cannot show */
    int n_explanations, more;           /* of which there is no room */
    bool
        one_is_right; /* EXPLAINED: the first is the right code, of which the others are nearer to the file */
    long tried;
    bool pairs_left; /* no two mistakes at once were tried, nor one in a scheme of four choices or more */
    bool time_up;    /* the time was up before all were tried */
} Diagnosis;

typedef struct DiagnoseTask {
    const Settings *settings;
    int threads;
    bool pairs;     /* two mistakes at once are tried in the plane too, where that takes long */
    double seconds; /* no other code is tried after so many; 0: all are */
    Cancel cancel;
} DiagnoseTask;

/* False: it was given up, there is no memory, or the scenario itself cannot be run. */
bool diagnose(const DiagnoseTask *, DiagnoseTable *, Diagnosis *, Status *);

/* How the table was read: "v: v of particle 49; rows carry the time before their step; dt 0.02". */
void diagnosis_read_as(const DiagnoseTable *, char *out, size_t size);

/* What it came to, in lines of ASCII. As in a command, `scenario`: with its settings, "mode5 --set
 * bar.density=2"; `file`: with its map, "own/a.csv --map 1=time,2=v_cm". */
void diagnosis_tell(const Diagnosis *, const DiagnoseTable *, const char *scenario, const char *file, FILE *);

/* The same in a few sentences; what does not fit is cut. */
void diagnosis_sum_up(const Diagnosis *, const DiagnoseTable *, char *out, size_t size);

/* A series as an overlay of the run: our names, units and times; the table is left without it. False: it is
 * of things or stages. */
bool diagnose_overlay(DiagnoseTable *, Overlay *);

#endif
