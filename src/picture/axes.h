/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Axes with round ticks: steps of 1, 2 or 5 times a power of ten, and a common power of ten for their labels.
 * An axis may also go by square roots, where small and large errors are to be read side by side, or by powers
 * of ten. */
#ifndef PICTURE_AXES_H
#define PICTURE_AXES_H

#include <stdbool.h>
#include <stddef.h>

enum { TICKS_MAX = 64, TICKS_USUAL = 5, TICK_TEXT_MAX = 24 };

typedef enum AxisScale { SCALE_LINEAR, SCALE_ROOT, SCALE_LOG } AxisScale;

typedef struct Axis {
    AxisScale scale;
    double low, high; /* what is shown */
    double step;      /* distance of the ticks; by roots: least distance, as a share of the axis */
    int exponent;     /* labels are value / 10^exponent; a multiple of 3 */
    int decimals;     /* of the labels */
    bool symmetric;   /* around zero, which must not be the only tick */
    bool whole;       /* counts things: ticks are whole */
    bool moves;       /* and its labels change their length with it */
} Axis;

/* At most so many ticks, 2 at least if they fit: who draws an axis finds those for its room. */
Axis axis_with_ticks(Axis, int most);

/* An axis from low to high. low < high, both finite; else 0 to 1. */
Axis axis_make(double low, double high);

/* An axis around zero that holds +-amplitude, rounded up so that it keeps still while a run goes on. */
Axis axis_symmetric(double amplitude);

/* An axis on which a value stands at the signed root of its distance from 0: what grows like a square is a
 * straight line. Ticks: 0, and 1, 5, 20, 50 times a power of 100 as far as there is room. */
Axis axis_make_root(double low, double high);

/* Powers of ten from below `low` to above `high`, both positive. */
Axis axis_make_log(double low, double high);

/* An axis that holds low and high, and 0 if it is not far; rounded outwards. */
Axis axis_around(double low, double high);

/* From 0 to a number of things, 1 at least: the ticks are whole. */
Axis axis_count(double high);

/* The next of 1, 1.2, 1.5, 2, 2.5, 3, 4, 5, 6, 8 times a power of ten not below a positive value; else 1. */
double axis_round_up(double value);

/* The next of 1, 2, 5 times a power of ten that is not below (not above) a positive value. */
double axis_step_up(double value);
double axis_step_down(double value);

/* A factor of 1, 2 or 5 times a power of ten by which a displacement of at most `reach` becomes at most
 * `room`. Taken from what the whole run reaches, so that it does not change while it goes on. */
double axis_enlargement(double reach, double room);

double axis_power_of_ten(int exponent);

/* The values of the ticks; returns how many. */
int axis_ticks(const Axis *, double ticks[TICKS_MAX]);

/* The label of a tick: all labels of an axis have the same number of decimals. */
void axis_label(const Axis *, double tick, char out[TICK_TEXT_MAX]);

/* The common power of ten with the unit: "x10^-3", "mm", "x10^6 Pa", "kHz"; "" if there is nothing to say. */
void axis_scale_text(const Axis *, const char *unit, char out[TICK_TEXT_MAX]);

/* "v_cm x10^-3", "x, mm": a name with what axis_scale_text() says. */
void axis_name(const char *name, const char *scale, char *out, size_t size);

/* Where a value stands, in a measure that is even along the axis: the value, its root, its logarithm. */
double axis_place(const Axis *, double value);
double axis_share(const Axis *, double value); /* of the axis; 0 at its low end */

/* The column and row of a value within `cells` cells; -1 if it is outside. */
int axis_column(const Axis *, double value, int cells);
int axis_row(const Axis *, double value, int cells);

#endif
