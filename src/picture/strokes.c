/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The list of strokes that a plot is: what is drawn, before anything is drawn. A curve of many samples keeps
 * for each column the first, least, largest and last of them, so that nothing that it does is left out. */
#include "base/assertion.h"
#include "picture/plot.h"

#include <math.h>
#include <stdlib.h>

void plot_close(Plot *plot)
{
    free(plot->points);
    plot->points = NULL;
    plot->n_points = plot->room = 0;
    plot->n_strokes = 0;
}

const Pen pen_measured = {LINE_SOLID, '*', STYLE_MEASURED, RANK_MEASURED, 0};
const Pen pen_second = {LINE_DASHED, '-', STYLE_SECOND, RANK_SECOND, 0};
const Pen pen_exact = {LINE_DOTTED, '.', STYLE_EXACT, RANK_EXACT, 0};
const Pen pen_predicted = {LINE_DASHED, '-', STYLE_PREDICTED, RANK_PREDICTED, 0};

void plot_begin(Plot *plot, StrokeKind kind, Pen pen)
{
    if (plot->n_strokes == STROKES_MAX)
        return;
    plot->strokes[plot->n_strokes++] = (Stroke){.kind = kind,
                                                .line = pen.line,
                                                .style = pen.style,
                                                .rank = pen.rank,
                                                .fill = pen.fill,
                                                .letter = pen.letter,
                                                .first = plot->n_points};
}

void plot_point(Plot *plot, double x, double y)
{
    if (plot->n_strokes == 0)
        return;
    if (plot->n_points == plot->room) {
        size_t room = plot->room ? 2 * plot->room : 256;
        double *points = realloc(plot->points, room * 2 * sizeof *points);
        if (!points) {
            plot->lost = true;
            return;
        }
        plot->points = points;
        plot->room = room;
    }
    plot->points[2 * plot->n_points] = x;
    plot->points[2 * plot->n_points + 1] = y;
    plot->n_points++;
    plot->strokes[plot->n_strokes - 1].count++;
}

/* What is kept of the samples of one column. */
typedef struct Extent {
    size_t count;
    struct {
        size_t index;
        double x, y;
    } first, least, largest, last;
} Extent;

static void flush(Plot *plot, const Extent *extent)
{
    if (extent->count == 0)
        return;
    plot_point(plot, extent->first.x, extent->first.y);
    const bool least_first = extent->least.index < extent->largest.index;
    const size_t a = least_first ? extent->least.index : extent->largest.index;
    const size_t b = least_first ? extent->largest.index : extent->least.index;
    if (a != extent->first.index && a != extent->last.index)
        plot_point(plot, least_first ? extent->least.x : extent->largest.x,
                   least_first ? extent->least.y : extent->largest.y);
    if (b != extent->first.index && b != extent->last.index && b != a)
        plot_point(plot, least_first ? extent->largest.x : extent->least.x,
                   least_first ? extent->largest.y : extent->least.y);
    if (extent->count > 1)
        plot_point(plot, extent->last.x, extent->last.y);
}

void plot_curve(Plot *plot, PlotSample *sample, const void *context, size_t first, size_t end, int columns)
{
    ASSERT_INT(first, <=, end);
    const double scale = columns / (plot->x.high - plot->x.low);
    Extent extent = {0};
    long column = 0;
    for (size_t i = first; i < end; i++) {
        double x, y = sample(context, i, &x);
        long here = (long)floor((x - plot->x.low) * scale);
        if (extent.count && (here != column || isnan(y))) {
            flush(plot, &extent);
            extent.count = 0;
        }
        if (isnan(y)) {
            plot_point(plot, x, y);
            continue;
        }
        column = here;
        if (extent.count == 0) {
            extent.first.index = extent.least.index = extent.largest.index = i;
            extent.first.x = extent.least.x = extent.largest.x = x;
            extent.first.y = extent.least.y = extent.largest.y = y;
        }
        if (y < extent.least.y)
            extent.least.index = i, extent.least.x = x, extent.least.y = y;
        if (y > extent.largest.y)
            extent.largest.index = i, extent.largest.x = x, extent.largest.y = y;
        extent.last.index = i, extent.last.x = x, extent.last.y = y;
        extent.count++;
    }
    flush(plot, &extent);
}
