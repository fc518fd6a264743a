/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A run as files: CSV tables with their .csv.ini beside. Column contract: manual page matvib(1).
 *
 * Files are written whole or not at all: a temporary file in the same folder, fsync, rename. */
#ifndef LAB_EXPORT_H
#define LAB_EXPORT_H

#include "export/vtk.h"
#include "base/output.h"
#include "base/status.h"
#include "answers/crack_growth.h"
#include "answers/references.h"
#include "scenario/assignment.h"

typedef enum Dialect { DIALECT_COMMA, DIALECT_SEMICOLON } Dialect;

/* What a run writes; a NULL name is not written, "-" is standard output. */
typedef struct Outputs {
    const char *series, *particles, *nodes, *bonds, *vtk;
    long stages[2]; /* of these steps, the first one of a run is 1: tables after each stage; 0: at frames */
    int stage;      /* after so many stages of them alone; 0: after each */
    Dialect dialect;
    VtkData vtk_data;
    Asker asker; /* on whose behalf */
    bool force;  /* existing files are replaced; else they are refused before the run starts */
} Outputs;

/* How the change of a run's energy is measured, so that the ripple of kinetic and strain energy, which are
 * known half a step apart, does not enter: by E* where there is one (answers/invariant.h), else by the
 * means of total - work over the first and the last period, or tenths of the run where no one period is
 * known. */
typedef enum EnergyMeasure { ENERGY_NOT_KNOWN, ENERGY_INVARIANT, ENERGY_PERIOD, ENERGY_TENTH } EnergyMeasure;

/* What a run came to; printed by `matvib run`, shown by the laboratory at the end. */
typedef struct RunSummary {
    const char *mistake; /* what a wrong code does in it; NULL: nothing is wrong */
    long steps;
    double time, dt;
    Readout readout;
    Finding findings[FINDINGS_MAX]; /* of the last step */
    int n_findings;
    EnergyMeasure energy_measure;
    bool energy_of_feed;  /* of the start's energy the motion that all of a body has in common is most */
    double energy_most;   /* per cent of the start: the largest change on the way; 0: not of the start */
    bool energy_of_work;  /* it begins at rest, or next to it: the change is a share of the largest work */
    double energy_change; /* from the start to the end, in percent of the start */
    long rows;            /* of the series */
    Column columns[COLUMNS_MAX]; /* of the series */
    int n_columns;
    double last_row[COLUMNS_MAX];
    Derived derived[DERIVED_MAX]; /* of the simulation that ran */
    int n_derived;
    bool crack_known; /* a beam with a notch */
    CrackFacts crack;
    bool fronts_known; /* a plate with cuts */
    FrontsFacts fronts;
    bool price_known; /* where the crack's energy went */
    CrackPrice price;
    double rayleigh_speed; /* that of the tip is told beside it */
    size_t frames;         /* of tables of particles, nodes, bonds, and for ParaView */
    bool at_rest;          /* it ended where it had come to rest */
    bool failed;
    Status failure;
} RunSummary;

/* Whether the series has a column, the i-th of the references', by output.columns: step and time always. */
bool export_writes(const Settings *, const Simulation *, int i, const char *column);

/* Called now and then with the share done in [0, 1]; returns false to stop the run (^C). May be NULL. */
typedef bool (*RunProgress)(double share, void *context);

/* Runs settings from 0 to the end without keeping more than it must and writes the outputs as it goes; the
 * laboratory's export and `matvib run` are this function, so they write the same bytes. A run that fails on
 * its way still writes everything up to there, then returns false with the failure. */
bool export_run(const Settings *, const Outputs *, int threads, RunProgress, void *context, RunSummary *,
                Status *);

#endif
