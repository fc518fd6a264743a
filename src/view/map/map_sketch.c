/* The map of a beam on paper: its nodes as pieces with their colours, and what is drawn over them as lines
 * and signs, in millimetres of the beam, displacements enlarged as on the screen. */
#include "view/map/map.h"
#include "view/draw/sketch.h"

#include "lab/answers/crack.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define MILLI 1e-3

static Sketch *sketch_of(const Map *map)
{
    return map->area.canvas->sketch;
}

/* From columns and rows of the area back to the beam's own millimetres. */
static void place_of(const Map *map, double column, double row, double *x, double *y)
{
    *x = (map->middle[0] + (column - map->area.rect.width / 2.0) / map->scale_x) / MILLI;
    *y = (map->middle[1] + (map->area.rect.height / 2.0 - row) / map->scale_y) / MILLI;
}

/* --- lines and signs ------------------------------------------------------------------------------- */

/* Lines that hang together are one stroke, so that their dashes go on. */
void map_sketch_line(Map *map, double from_x, double from_y, double to_x, double to_y, Style style, int every)
{
    Plot *plot = &sketch_of(map)->plot;
    const LineStyle line = every >= 4 ? LINE_DOTTED : every >= 2 ? LINE_DASHED : LINE_SOLID;
    const Stroke *last = plot->n_strokes > 0 ? &plot->strokes[plot->n_strokes - 1] : NULL;
    const double *end = last ? plot->points + 2 * plot->n_points - 2 : NULL;
    double x0, y0, x1, y1;
    place_of(map, from_x, from_y, &x0, &y0);
    place_of(map, to_x, to_y, &x1, &y1);
    if (!last || last->style != style || last->line != line || fabs(end[0] - x0) + fabs(end[1] - y0) > 1e-6) {
        plot_begin(plot, STROKE_LINE, line, style, style == STYLE_CHANGED ? RANK_MARK : RANK_EXACT, '|');
        plot_point(plot, x0, y0);
    }
    plot_point(plot, x1, y1);
}

void map_sketch_sign(Map *map, double column, double row, uint32_t glyph)
{
    double x, y;
    place_of(map, column, row, &x, &y);
    sketch_mark(sketch_of(map), x, y, glyph, STYLE_HEADING);
}

/* --- the pieces ------------------------------------------------------------------------------------ */

static void take_nodes(const Map *map, SketchMap *out)
{
    const bool hides = strcmp(map->colouring->field, "damage") != 0;
    for (size_t node = 0; node < map->body.count; node++) {
        double column, row;
        map_node_place(map, node, &column, &row);
        place_of(map, column, row, &out->x[node], &out->y[node]);
        out->value[node] = hides && map->damage[node] > CRACK_DAMAGE ? NAN : map->value[node];
    }
    out->size = map->body.spacing / MILLI;
    out->enlarged = map->enlarged;
    out->low = map->low;
    out->high = map->high;
    out->is_signed = map->colouring->is_signed;
    snprintf(out->unit, sizeof out->unit, "%s", map->colouring->unit);
}

/* What is seen: as much as on the screen; a beam that is pressed fills the picture, but for its supports. */
static void take_axes(const Map *map, Sketch *sketch)
{
    const Body *body = &map->body;
    double low[2], high[2];
    place_of(map, 0, map->area.rect.height, &low[0], &low[1]);
    place_of(map, map->area.rect.width, 0, &high[0], &high[1]);
    if (map->scenery->pressed && map->screen->magnified <= 1)
        for (int d = 0; d < 2; d++) {
            const double margin = (d == 0 ? 0.01 : 0.1) * body->size[d];
            low[d] = (body->low[d] - margin) / MILLI;
            high[d] = (body->low[d] + body->size[d] + margin) / MILLI;
        }
    const Axis x = axis_make(low[0], high[0], map->area.rect.width / 9);
    const Axis y = axis_make(low[1], high[1], 5);
    sketch_axes(sketch, &x, &y, "x, mm");
}

static void name_lines(Sketch *sketch, const Map *map)
{
    static const SketchKey keys[] = {
        {LINE_SOLID, STYLE_CHANGED, 0, "crack's path"},
        {LINE_DOTTED, STYLE_FAINT, 0, "30° from the notch (paper)"},
        {LINE_SOLID, STYLE_HEADING, 0, "notch"},
        {LINE_DASHED, STYLE_FRAME, 0, "protected"},
    };
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++)
        for (int k = 0; k < sketch->plot.n_strokes && map->scenery->pressed; k++)
            if (sketch->plot.strokes[k].style == keys[i].style) {
                sketch_key(sketch, &keys[i]);
                break;
            }
}

void map_sketch(Map *map)
{
    Sketch *sketch = sketch_of(map);
    SketchMap *out = sketch_map(sketch, map->body.nx, map->body.ny);
    if (!out)
        return;
    sketch->stretch = map->stretch;
    take_nodes(map, out);
    take_axes(map, sketch);
    map_draw_lines(map);
    map_draw_signs(map);
    name_lines(sketch, map);
    sketch_heading(sketch, map->colouring->meaning);
}
