/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What a plate has by rows, in the drawing of it before it moves: cuts, regions with their names, loads with
 * their size. */
#include "views/map/map_drawing.h"
#include "scenario/settings.h"
#include "scenario/rows/rows.h"
#include "base/math/functions.h"

#include <math.h>
#include <stdio.h>

/* A straight line at any angle. */
static void draw_line(const Drawing *drawing, const double from[2], const double to[2], Style style)
{
    const double height = drawing->body->size[1];
    const double places[][2] = {{drawing_column(drawing, from[0]), drawing_row(drawing, from[1] / height)},
                                {drawing_column(drawing, to[0]), drawing_row(drawing, to[1] / height)}};
    if (drawing_paper(drawing)) {
        drawing_trace(drawing, STROKE_LINE, style, 2, places);
        return;
    }
    const double across = places[1][0] - places[0][0], down = places[1][1] - places[0][1];
    const int count = (int)fmax(fabs(across), fabs(down));
    const uint32_t glyph = fabs(across) > 3 * fabs(down)   ? 0x2500
                           : fabs(down) > 2 * fabs(across) ? 0x2502
                           : across * down > 0             ? 0x2572
                                                           : 0x2571;
    for (int i = 0; i <= count; i++) {
        const double share = count > 0 ? (double)i / count : 0;
        drawing_put(drawing, round(places[0][0] + share * across), round(places[0][1] + share * down), glyph,
                    style);
    }
}

/* On paper one stroke: a line from tail to tail and the arrows on it, which point by (right, down). */
static void trace_arrows(const Drawing *drawing, const double x[2], const double y[2], int count, int right,
                         int down)
{
    Plot *plot = &drawing_paper(drawing)->plot;
    plot_begin(plot, STROKE_LINE, LINE_SOLID, STYLE_HEADING, RANK_EXACT, '|');
    for (int i = 0; i <= count; i++) {
        const double share = (double)i / count, at_x = x[0] + share * (x[1] - x[0]),
                     at_y = y[0] + share * (y[1] - y[0]), tip_x = at_x + 0.8 * right,
                     tip_y = at_y + 0.4 * down;
        const double tail_x = at_x - 0.8 * right, tail_y = at_y - 0.4 * down;
        const double places[][2] = {
            {tail_x, tail_y},
            {tip_x, tip_y},
            {tip_x - 0.5 * right - 0.4 * down, tip_y - 0.25 * down - 0.2 * right},
            {tip_x, tip_y},
            {tip_x - 0.5 * right + 0.4 * down, tip_y - 0.25 * down + 0.2 * right},
            {tip_x, tip_y},
            {tail_x, tail_y},
        };
        for (size_t k = 0; k < sizeof places / sizeof *places; k++)
            plot_point(plot, places[k][0], -places[k][1]);
    }
}

/* Arrows beside the edge, and the size of the traction where there is room. */
static void draw_traction(const Drawing *drawing, int row, double ends[2][2])
{
    enum { APART_COLUMNS = 4, APART_ROWS = 2 };
    const Settings *settings = drawing->settings;
    const double sx = settings_row_value(settings, ROWS_LOADS, row, 3),
                 sy = settings_row_value(settings, ROWS_LOADS, row, 4), height = drawing->body->size[1];
    const int edge = (int)settings_row_value(settings, ROWS_LOADS, row, 0);
    const bool lies = edge == ROW_TOP || edge == ROW_BOTTOM;
    const double away = edge == ROW_TOP || edge == ROW_LEFT ? -1 : 1;
    const double x[2] = {drawing_column(drawing, ends[0][0]) + (lies ? 0 : away),
                         drawing_column(drawing, ends[1][0]) + (lies ? 0 : away)},
                 y[2] = {drawing_row(drawing, ends[0][1] / height) + (lies ? away : 0),
                         drawing_row(drawing, ends[1][1] / height) + (lies ? away : 0)};
    const int count = (int)fmax(1, lies ? fabs(x[1] - x[0]) / APART_COLUMNS : fabs(y[1] - y[0]) / APART_ROWS);
    if (drawing_paper(drawing))
        trace_arrows(drawing, x, y, count, fabs(sx) > fabs(sy) ? (sx > 0 ? 1 : -1) : 0,
                     fabs(sx) > fabs(sy) ? 0
                     : sy > 0            ? -1
                                         : 1);
    for (int i = 0; i <= count && !drawing_paper(drawing); i++) {
        const double share = (double)i / count;
        drawing_put(drawing, round(x[0] + share * (x[1] - x[0])), round(y[0] + share * (y[1] - y[0])),
                    map_arrow(sx, sy), STYLE_HEADING);
    }
    char text[NUMBER_TEXT_MAX + 8], number[NUMBER_TEXT_MAX];
    text_rounded(number, 1e-6 * math_hypot(sx, sy), 4);
    snprintf(text, sizeof text, " %s MPa ", number);
    if (lies)
        drawing_label(drawing, fmax(x[0], x[1]) + 2, y[0], 1, text, STYLE_NORMAL);
    else
        drawing_label(drawing, x[0] - 2 * away, (y[0] + y[1]) / 2, -(int)away, text, STYLE_NORMAL);
}

/* What a plate has by rows: cuts, regions by their names, loads. */
void drawing_rows(const Drawing *drawing)
{
    const Settings *settings = drawing->settings;
    for (int kind = 0; kind < ROW_KINDS; kind++)
        for (int row = 0; settings_have_rows(settings, kind) && row < settings->rows[kind].count; row++) {
            double ends[2][2];
            map_row_ends(settings, kind, row, ends);
            const double *a = ends[0], *c = ends[1], b[2] = {c[0], a[1]}, d[2] = {a[0], c[1]};
            if (kind == ROWS_PROBE)
                continue; /* draw_probe() */
            if (kind == ROWS_CUTS) {
                draw_line(drawing, a, c, STYLE_HEADING);
            } else if (kind == ROWS_LOADS) {
                draw_traction(drawing, row, ends);
            } else {
                draw_line(drawing, a, b, STYLE_FRAME);
                draw_line(drawing, b, c, STYLE_FRAME);
                draw_line(drawing, c, d, STYLE_FRAME);
                draw_line(drawing, d, a, STYLE_FRAME);
                drawing_label(drawing, drawing_column(drawing, fmax(a[0], c[0])) + 1,
                              drawing_row(drawing, (a[1] + c[1]) / 2 / drawing->body->size[1]), 1,
                              settings->rows[kind].rows[row].name, STYLE_FAINT);
            }
        }
}
