/* What both methods of the bar share behind problem.h. Not for front ends. */
#ifndef LAB_BAR_ANSWERS_H
#define LAB_BAR_ANSWERS_H

#include "lab/answers/bar_problem.h"
#include "lab/answers/problem_rows.h"

/* The velocity at t = 0; the context is a BarTheory. */
double bar_start(double x, const void *theory);

/* The mode that is watched: the first that moves and is no rigid motion; else 0. */
int bar_watched_mode(const BarTheory *);

/* Which column shows the frequency, and the exact one; what is predicted is not known yet. */
BarWatch bar_watch(const BarTheory *);

/* The frequency predicted for a mode as a run of time step `dt` shows it; NAN: not known. */
typedef double BarFrequency(const Settings *, const BarTheory *, double dt, int mode);

/* Plans v_cm with its references. `predicted` v_cm, NULL: not known; `meaning` of that column. */
bool bar_prepare(References *, const Settings *, const Simulation *, BarFrequency *, Answer *predicted,
                 const char *meaning, Status *);

/* For ProblemRow. */
double bar_profile(const References *, const char *field, double x, double time);
void bar_read_out(const References *, const double *rows, size_t n_rows, int n_columns, Readout *);

/* beta, omega, omega_predicted (if there is a way to predict), period, steps_per_period of the watched mode,
 * if one moves. */
void bar_derived_wave(Derived out[DERIVED_MAX], int *n, const Settings *, const BarTheory *, BarFrequency *,
                      double dt);

#endif
