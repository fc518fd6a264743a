/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A foreign series over the curves of a plot. `curve` is the name of the plot's own curve, `along` tells a
 * profile from a plot over time; where the series has no such column all of these do nothing. */
#ifndef VIEWS_PLOTS_OVERLAY_PLOT_H
#define VIEWS_PLOTS_OVERLAY_PLOT_H

#include "panes/screen_runs.h"
#include "picture/picture.h"

/* Widens a range, or tells the largest magnitude (0: there is none), so that the axis of y holds it. */
void overlay_widen(const Screen *, const char *curve, bool along, double *least, double *most);
double overlay_reach(const Screen *, const char *curve, bool along);

/* Adds its dots, the first, least, largest and last value of each column of them, with marks and a name. */
void overlay_add(const Screen *, Picture *, const char *curve, bool along);

/* Its value at a time or place, that of the nearest row; NAN: it has none there. */
double overlay_value(const Screen *, const char *curve, bool along, double x);

#endif
