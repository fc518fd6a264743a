/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What the solvers of the beams share. Not for front ends. SI units. */
#ifndef ANSWERS_BEAM_ANSWERS_H
#define ANSWERS_BEAM_ANSWERS_H

#include "problems/solver.h"
#include "methods/bonds/plane/bonds_plane.h"
#include "theory/elastic_beam.h"

/* The beam as its engine by peridynamics wants it. */
BeamDef beam_definition(const Settings *, int threads);

/* The beam as the scenario says. */
BeamTheory beam_theory_of(const Settings *);

/* What a method makes of the beam, for the answers beside a run. */
typedef struct BeamBody {
    BeamTheory real;  /* as it came out on its lattice or mesh */
    double predicted; /* period without damping, s; NAN: not known */
    double damping;   /* alpha in use, 1/s */
    double weight;    /* body force on all of it, m/s^2 */
    double solved;   /* what the probe is displaced by under it at rest, by one solution, m; NAN: not known */
    double plane;    /* period of the plane problem itself, where its ends are those of the run; else NAN */
    double from_tip; /* the probe of a cantilever lies so far before its tip, m */
    bool rings;      /* through the height, so that velocities want a filter */
    double thickness[THICKNESS_LINES_MAX]; /* frequencies of that */
    int n_thickness;
} BeamBody;

/* For Solver, each with the method's body. */
bool beam_prepare_supported(References *, const Settings *, const Simulation *, const BeamBody *, Status *);
double beam_supported_profile(const References *, const char *field, double x, double time);
double beam_supported_section(const References *, const char *field, double x, double y, double time);
int beam_find_rest(const References *, const Simulation *, Finding *out);
void beam_read_supported(const References *, const double *rows, size_t n_rows, int n_columns, Readout *);

bool beam_prepare_moving(References *, const Settings *, const Simulation *, const BeamBody *, Status *);
void beam_read_moving(const References *, const double *rows, size_t n_rows, int n_columns, Readout *);
double beam_moving_section(const References *, const char *field, double x, double y, double time);
double beam_moving_envelope(const References *, const char *column, double time);
double beam_moving_frequency(const References *, double time);

bool beam_prepare_notched(References *, const Settings *, const Simulation *, Status *);
void beam_read_nothing(const References *, const double *rows, size_t n_rows, int n_columns, Readout *);

int beam_thickness_lines(const References *, double out[THICKNESS_LINES_MAX]);

#endif
