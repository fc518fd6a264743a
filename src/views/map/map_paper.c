/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The pen on paper: how lines and signs of a map go into a picture, in millimetres of the body. */
#include "views/map/map.h"
#include "picture/picture.h"

#include <math.h>

static Picture *picture_of(const Map *map)
{
    return map->picture;
}

/* From columns and rows of the area back to the beam's own millimetres. */
void map_picture_place(const Map *map, double column, double row, double *x, double *y)
{
    *x = (map->middle[0] + (column - map->area.rect.width / 2.0) / map->scale_x) / MAP_MILLI;
    *y = (map->middle[1] + (map->area.rect.height / 2.0 - row) / map->scale_y) / MAP_MILLI;
}

/* --- lines and signs ------------------------------------------------------------------------------- */

/* Lines that hang together are one stroke, so that their dashes go on. */
void map_picture_line(Map *map, double from_x, double from_y, double to_x, double to_y, Style style,
                      int every)
{
    Plot *plot = &picture_of(map)->plot;
    const LineStyle line = every >= 4 ? LINE_DOTTED : every >= 2 ? LINE_DASHED : LINE_SOLID;
    const Stroke *last = plot->n_strokes > 0 ? &plot->strokes[plot->n_strokes - 1] : NULL;
    const double *end = last ? plot->points + 2 * plot->n_points - 2 : NULL;
    double x0, y0, x1, y1;
    map_picture_place(map, from_x, from_y, &x0, &y0);
    map_picture_place(map, to_x, to_y, &x1, &y1);
    if (!last || last->style != style || last->line != line || fabs(end[0] - x0) + fabs(end[1] - y0) > 1e-6) {
        plot_begin(plot, STROKE_LINE, line, style, style == STYLE_CHANGED ? RANK_MARK : RANK_EXACT, '|');
        plot_point(plot, x0, y0);
    }
    plot_point(plot, x1, y1);
}

void map_picture_sign(Map *map, double column, double row, uint32_t glyph, Style style)
{
    double x, y;
    map_picture_place(map, column, row, &x, &y);
    picture_mark(picture_of(map), x, y, glyph, style);
}
