/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What becomes of the error when a mesh or a lattice is refined: predicted answers beside theory, a point at
 * a time, without a run. Bodies have no prediction: a point is a run to its end, and its error that of the
 * number that the scenario is about, or of the first one with an exact or reference answer.
 *
 * A study keeps everything but one thing: the cells of a bar grow smaller; the horizon of a beam grows
 * smaller and the nodes in it stay as many (delta-convergence, m = horizon/spacing kept); the nodes within
 * the horizon grow more and the horizon stays (m-convergence); or it takes the six lattices of paper P's
 * Table 1. A study of several lines sets them beside each other: other numbers of particles in a cell, or
 * both methods, each with its own size. The error of a beam is measured against Timoshenko's period at the
 * size that the beam has on each lattice, so that its layers do not hide what the horizon does; the same at
 * the size asked for is beside. */
#ifndef ANSWERS_CONVERGENCE_H
#define ANSWERS_CONVERGENCE_H

#include "scenario/settings.h"
#include "base/cancel.h"
#include "problems/problem.h"

enum { CONVERGENCE_POINTS_MAX = 12, CONVERGENCE_LINES_MAX = 3 };

typedef struct ConvergenceStudy {
    const char *word;  /* "delta" */
    const char *title; /* "horizon smaller, m kept" */
    const char *size;  /* what is refined: "horizon", "cell size" */
    int concerns;      /* of the problems that have it (problem.h), all of them */
    MethodKind method;
    void (*refine)(Settings *, int k); /* to those of point k, coarsest first */
    int points;                        /* so many; at most CONVERGENCE_POINTS_MAX */
    double (*paper)(int k);            /* ConvergencePoint.paper; NULL: the paper gives none */
    double (*size_of)(const Settings *);
    const char *const *lines;          /* of several: their names, ended by NULL; else NULL */
    int line_points;                   /* of several: so many points in each, one line after the other */
    double (*limit)(const Settings *); /* convergence_limit(); NULL: it is not known */
    bool by_run;
} ConvergenceStudy;

typedef struct ConvergencePoint {
    bool known; /* false: no such mesh or lattice can be made */
    double size;
    double nodes; /* within the horizon: m; of a mesh cells in the length */
    bool of_mesh;
    Prediction prediction;
    double
        error; /* percent: of the frequency (bar), of the period at the real size (beam), of `of` (bodies) */
    const char *of; /* by a run: what is measured, with its value and what it should be in `prediction` */
    double paper;   /* the period that paper P prints for it, s; NAN: none */
} ConvergencePoint;

/* The studies that these settings allow; returns how many. `out` has room for CONVERGENCE_STUDIES_MAX. */
enum { CONVERGENCE_STUDIES_MAX = 4 };
int convergence_studies(const Settings *, const ConvergenceStudy *out[CONVERGENCE_STUDIES_MAX]);

/* Works out point k, which takes from a millisecond to some seconds; Settings.cancel is called on the way.
 * False: given up, or not enough memory. */
bool convergence_point(const ConvergenceStudy *, const Settings *, int k, ConvergencePoint *out, Status *);

/* The order of the error between two points, log(e_a/e_b)/log(size_a/size_b); NAN: one is not known, or the
 * error changes its sign. */
double convergence_order(const ConvergencePoint *a, const ConvergencePoint *b);

/* What a beam's period over theory's tends to in a study, where that is known and not 1; else NAN. */
double convergence_limit(const ConvergenceStudy *, const Settings *);

/* The order between two points as above, of the difference to such a limit. */
double convergence_order_to(double limit, const ConvergencePoint *a, const ConvergencePoint *b);

/* The slope of the straight line through log|error| over log(size) of all points that are known. NAN: fewer
 * than three, or the error does not fall from each to the next with the same sign. */
double convergence_fitted_order(const ConvergencePoint *points, int count);

/* What is known of all studies of one run so far: nothing is worked out twice. */
typedef struct Convergence {
    Settings base;
    const ConvergenceStudy *studies[CONVERGENCE_STUDIES_MAX];
    ConvergencePoint points[CONVERGENCE_STUDIES_MAX][CONVERGENCE_POINTS_MAX];
    int known[CONVERGENCE_STUDIES_MAX]; /* the first so many points */
    int n_studies;
} Convergence;

/* Makes it that of these settings; what is known of the same ones stays. */
void convergence_begin(Convergence *, const Settings *);

/* How many points of a study are known, and which; 0 of one that does not belong to these settings. */
int convergence_known(const Convergence *, const Settings *, const ConvergenceStudy *,
                      const ConvergencePoint **points);

/* Whether points are still to be worked out. */
bool convergence_lacks(const Convergence *, const Settings *, const ConvergenceStudy *);

/* Works out the next one, of settings that convergence_begin() was given. False: as convergence_point(). */
bool convergence_next(Convergence *, const ConvergenceStudy *, Cancel, Status *);

#endif
