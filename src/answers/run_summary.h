/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a run came to, as numbers: summary.h puts them into words. */
#ifndef ANSWERS_RUN_SUMMARY_H
#define ANSWERS_RUN_SUMMARY_H

#include "answers/crack_growth.h"
#include "answers/references.h"
#include "base/status.h"

/* How the change of a run's energy is measured, so that the ripple of kinetic and strain energy, which are
 * known half a step apart, does not enter: by E* where there is one (answers/references.h), else by the
 * means of total - work over the first and the last period, or tenths of the run where no one period is
 * known. */
typedef enum EnergyMeasure { ENERGY_NOT_KNOWN, ENERGY_INVARIANT, ENERGY_PERIOD, ENERGY_TENTH } EnergyMeasure;

enum { SUMMARY_EVENTS_MAX = 40 };

typedef struct RunSummary {
    const char *mistake; /* what a wrong code does in it; NULL: nothing is wrong */
    long steps;
    double time, dt;
    Readout readout;
    Finding findings[FINDINGS_MAX]; /* of the last step */
    int n_findings;
    Event events[SUMMARY_EVENTS_MAX]; /* what the run reported but crossings, the first ones */
    int n_events;
    EnergyMeasure energy_measure;
    bool energy_of_feed;  /* of the start's energy the motion that all of a body has in common is most */
    double energy_most;   /* per cent of the start: the largest change on the way; 0: not of the start */
    bool energy_of_work;  /* it begins at rest, or next to it: the change is a share of the largest work */
    bool energy_of_ahead; /* and that work is half a step ahead of the velocities */
    double energy_change; /* from the start to the end, in percent of the start */
    long rows;            /* of the series */
    double broken_bonds, crack_length; /* the columns at the end; NAN: there is no such column */
    Derived derived[DERIVED_MAX];      /* of the simulation that ran */
    int n_derived;
    bool crack_known; /* a beam with a notch */
    CrackFacts crack;
    bool fronts_known; /* a plate with cuts */
    FrontsFacts fronts;
    bool price_known; /* where the crack's energy went */
    CrackPrice price;
    double rayleigh_speed; /* that of the tip is given beside it */
    size_t frames;         /* of tables of particles, nodes, bonds, and for ParaView */
    bool at_rest;          /* it ended where it had come to rest */
    bool failed;
    Status failure;
} RunSummary;

double run_summary_derived(const RunSummary *, const char *name); /* NAN: it has none of that name */

#endif
