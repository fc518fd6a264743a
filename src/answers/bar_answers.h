/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What both methods of the bar share: which column shows its frequency, exact answers, and what is predicted
 * beside. Not for front ends. */
#ifndef ANSWERS_BAR_ANSWERS_H
#define ANSWERS_BAR_ANSWERS_H

#include "answers/dispersion_curves.h"
#include "answers/step_modes.h"
#include "methods/bonds/plane/bonds_plane.h"
#include "problems/solver.h"
#include "scenario/assignment.h"
#include "theory/elastic_bar.h"
#include "theory/frequency.h"

/* On which column the bar's frequency is measured, and what it should be. */
typedef struct BarWatch {
    bool moving;
    int mode;
    const char *column;
    double times;                       /* the column oscillates so many times as fast as the bar */
    double ratios[FREQUENCY_LINES_MAX]; /* the lines of the column against the one that is measured, which is
                                         * the first */
    int n_lines;                        /* at least 1 */
    double exact, predicted;
    double kept;    /* share of the energy that one period keeps, predicted; NAN: not known */
    double overlap; /* of the sampled mode with the one predicted; 1 where nothing else is known */
    bool predicted_known;
} BarWatch;

/* What References.own is of a bar. */
typedef struct BarAnswers {
    BarTheory theory;
    BarMesh mesh;                    /* by the material point method */
    StepModes *modes[BAR_MODES_MAX]; /* v_cm of each mode of the start by the engine's own step */
    BarWatch watch;
} BarAnswers;

const BarAnswers *bar_answers(const References *);

/* With the theory, else zeroed; in References.own. NULL: not enough memory, or overtones that cannot be read.
 */
BarAnswers *bar_answers_create(References *, const Settings *, Status *);

/* The velocity at t = 0; the context is a BarTheory. */
double bar_start(double x, const void *theory);
double bar_start_slope(double x, const void *theory);  /* its slope */
double bar_start_stress(double x, const void *theory); /* the stress of a pulse */

/* The mode that is watched: the first that moves and is not a rigid motion; else 0. */
int bar_watched_mode(const BarTheory *);

/* Which column shows the frequency, and the exact one; what is predicted is not known yet. */
BarWatch bar_watch(const BarTheory *);

/* The frequency predicted for a mode as a run of the settings shows it; NAN: not known. */
typedef double BarFrequency(const Settings *, const BarTheory *, int mode);

/* What a method's step predicts from. `start`: the bar of a right code without loads as the theory starts it,
 * NULL: no memory. `wave`: of an endless bar, known: the step is within the stability limit of this wave. */
typedef Simulation *BarStart(const Settings *, const BarTheory *);
typedef Dispersion BarWave(const Settings *, const BarTheory *, double wave_number);
typedef struct BarStep {
    BarStart *start;
    BarWave *wave;
    double spacing; /* of nodes */
    int most;       /* of spacings in a bar; of a longer one the wave is taken */
} BarStep;

/* Mode `number` as the step goes on with it, and its overlap with what the bar starts with. Between
 * shortage_begin() and shortage_end(). */
StepMode bar_step_mode(const BarStep *, const Settings *, const BarTheory *, int number);

/* BarAnswers.modes. False: v_cm is not known by them. */
bool bar_find_motion(BarAnswers *, const Settings *, BarStart *);

/* Plans v_cm with its references. `whole`: bar_find_motion() found the predicted one; `meaning` of that
 * column. */
void bar_prepare(References *, const Settings *, const Simulation *, BarFrequency *, bool whole,
                 const char *meaning);

/* Of both solvers. */
double bar_profile(const References *, const char *field, double x, double time);
void bar_read_out(const References *, const double *rows, size_t n_rows, int n_columns, Readout *);

int bar_findings(const References *, const Simulation *, Finding out[FINDINGS_MAX]);

/* Whether the Courant number is stable, by the material point method (Solver.limit). */
bool bar_limit(const Settings *, char *advice, size_t size, Status *);

/* The parameters that answers of the bar account for, by what they are about (Validity). */
#define BAR_KEYS                                                                                             \
    "bar.length", "bar.youngs_modulus", "bar.density", "bar.supports", "initial.mode", "initial.velocity",   \
        "initial.overtones", "load.body_force", "load.traction", "load.traction_layer", "scenario.method",   \
        "time.end"
#define BAR_MESH_KEYS                                                                                        \
    "mesh.cell_size", "mesh.particles_per_cell", "mesh.padding", "time.courant", "time.unstable"
#define BAR_TRANSFER_KEYS                                                                                    \
    "mpm.algorithm", "mpm.shape", "mpm.transfer", "mpm.flip_fraction", "mpm.mass_blend", "mpm.fmpm_order",   \
        "mpm.affine_start"
#define BAR_WAVE_KEYS                                                                                        \
    "initial.pulse", "initial.pulse_way", "initial.offset", "bar2.joint", "bar2.youngs_modulus",             \
        "bar2.density", "initial.shape"
#define BAR_LATTICE_KEYS                                                                                     \
    "pd.spacing", "pd.horizon", "pd.surface_correction", "pd.volume_correction", "pd.influence"

/* How many modes so many cells or nodes can represent. */
int bar_modes_of(double count);

/* A mode with the wave that is predicted for it, and the factors of which its frequency is made. False: no
 * such wave. */
typedef void BarFactors(const Dispersion *, ModeOnMesh *);
bool bar_mode(const Settings *, int number, BarWave *, BarFactors *, ModeOnMesh *);

/* For Solver. */
double bar_invariant(Simulation *, const Settings *);
bool bar_invariant_kept(const Settings *);

/* Start, question and loads as far as they are the same by both; `particles` in the bar. */
bool bar_check_modes(const Settings *, double particles, Status *);

/* After a prediction that began with shortage_begin(), which gave `before`: what theory cannot predict is
 * left out; for want of memory, or cancelled, it must not be. False: the status says so, of a bar of `count`
 * `parts`.
 */
bool bar_prediction_is_whole(int before, double count, const char *parts, Status *);

/* wave_speed and dt. */
void bar_derived_step(Derived out[DERIVED_MAX], int *n, double speed, double dt);

/* beta, omega, omega_predicted (if there is a way to predict), period, steps_per_period of the watched mode,
 * if one moves. */
void bar_derived_wave(Derived out[DERIVED_MAX], int *n, const Settings *, const BarTheory *, BarFrequency *,
                      double dt);

/* The bar between its settings and its theory: for what needs the theory directly (a
 * dispersion plot, a table of verification). */

/* The bar with its modes and loads. False: its overtones cannot be read. */
bool bar_theory_of(const Settings *, BarTheory *, Status *);

/* The same bar on a lattice of bonded nodes. */
BeamDef bar_pd_definition(const Settings *);

/* dt = courant * dx / c, eq. 21. */
double bar_time_step(const Settings *);

#endif
