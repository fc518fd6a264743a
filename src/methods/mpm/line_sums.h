/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The sums of one particle or node of the bar, written out term by term. For line_explain.c only. */
#ifndef METHODS_MPM_LINE_SUMS_H
#define METHODS_MPM_LINE_SUMS_H

#include "methods/mpm/engine.h"
#include "methods/mpm/subject.h"

/* A label of a node: "p13 = " from "p%d = ". */
typedef struct LineLabel {
    char text[48];
} LineLabel;

LineLabel line_label(const char *before, int node, const char *after);

/* Adds to the sum one term for each link of the subject, and the factor they share; returns their total. */
double line_add_terms(const Subject *, MpmExchange, CalculationSum *);

/* "load = m b + t V/h = 0.1 + 0.2 = 0.3": what acts on the chosen particle from outside, term by term. */
void line_write_load(const Subject *, double load);

/* "v13 = p/m = 0.2 / 0.5 = 0.4": a quantity over the mass of the chosen node. */
void line_write_ratio(const Subject *, const char *label, double above, double result);

#endif
